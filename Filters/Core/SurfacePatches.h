// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfacePatches_h
#define hachure_SurfacePatches_h

#include "SurfacePatchesMesh.h"
#include "SurfaceSampling.h"

#include <cstdint>
#include <vector>

// Ways to cut a surface into patches, each of which carries a pattern of its own (Breslav et al.
// 2007, section 3.6). All of them return one patch per face, numbered from 0 without gaps; where
// nothing else is said, by the lowest face of every patch. The result depends neither on the number
// of threads nor on anything but the arguments.
namespace hachure
{
/// Replaces labels of any value by their ranks, 0 for the lowest. Negative labels become -1: no
/// patch. Returns the number of patches.
std::int32_t rankPatches(Span<const std::int64_t> labels, std::vector<std::int32_t>& patches);

/// Renumbers patches from 0 by their lowest faces; negative ones stay. Returns the numbers that
/// they had, in the new order.
std::vector<std::int32_t> numberByLowestFace(std::vector<std::int32_t>& patches);

/// Regions that hang together by vertices. Faces without area connect, too.
std::vector<std::int32_t> connectedPatches(const FaceSurface& surface);

/// Regions bounded by edges at which the normals of the two faces differ by more than `creaseAngle`
/// degrees, from 0 to 180; a face turned over counts as if it were not. Where more than two faces
/// meet in an edge, those that continue each other are joined. Faces without area follow the
/// neighbour of the lowest number.
std::vector<std::int32_t> creasePatches(const FaceSurface& surface, double creaseAngle);

/// How compactPatches divides a surface.
struct CompactOptions
{
  int patches = 16; ///< wanted, at least 1; never more than there are faces
  /// How much a turn of the normal by one radian counts against a distance of the radius that a
  /// round patch of mean size has. 0: distance alone.
  double normalWeight = 0.1;
  int iterations = 20; ///< at most; at least 1
  ProgressFn progress;
};

/// Patches that are as round, as flat and as equal in size as they can be.
///
/// This is the iteration of Cohen-Steiner, Alliez and Desbrun (Variational shape approximation,
/// 2004): grow all patches from their seed faces, always adding the face that costs least; fit a
/// proxy to every patch; take the face nearest to it as the next seed. But where they measure the
/// distance of a face to its proxy by the normals alone (L2,1), we add the distance to the patch's
/// centroid, as in Lloyd's method: a patch of a plane or a cylinder should be round too, since a
/// similarity transform fits a long one badly. The first seeds are spread by farthest points.
///
/// Every patch hangs together by edges, as long as the surface has no more separate pieces than
/// patches are wanted. If it has more, pieces left over join the patch nearest to them. Returns an
/// empty result when `progress` stopped the work.
std::vector<std::int32_t> compactPatches(const FaceSurface& surface, const CompactOptions& options);

/// The same on some of the faces only, with their graph and shapes ready made, for repeated use:
/// the patch per item of `faces`, which ascend. Numbers are not in order of the faces.
std::vector<std::int32_t> divideFaces(const FaceGraph& graph, Span<const FaceShape> shapes,
  Span<const std::int32_t> faces, const CompactOptions& options);
} // namespace hachure

#endif
