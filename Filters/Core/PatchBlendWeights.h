// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PatchBlendWeights_h
#define hachure_PatchBlendWeights_h

#include "SurfacePatchesMesh.h"
#include "SurfaceSampling.h"

#include <array>
#include <cstdint>
#include <vector>

// How strong the pattern of every patch is at every vertex (Breslav et al. 2007, section 3.6):
// patterns fade into each other on both sides of the borders of patches.
//
// The paper stores a weight per vertex and patch. Here a vertex holds only the patches that reach
// it, and away from all borders nothing at all, so that the cost follows the vertices near borders:
// it does not grow with the number of patches.
namespace hachure
{
enum class BlendWidth : std::uint8_t
{
  Rings,   ///< rings of vertices about the border, as in the paper
  Distance ///< a distance along the surface, whatever the size of the triangles
};

enum class BlendStart : std::uint8_t
{
  Equal, ///< 1/k where k patches meet: the text of the paper
  Faces  ///< the fraction of the faces at the vertex: the authors' program
};

struct BlendOptions
{
  BlendWidth width = BlendWidth::Rings;
  int rings = 1;         ///< n, at least 1: weights are 0 from the n-th ring outside on
  double distance = 1.0; ///< on each side of the border, model units, above 0
  BlendStart start = BlendStart::Equal; ///< read for rings only
  ProgressFn progress;
};

constexpr int maximumBlendPatches = 4;

/// The patches at a point by falling weight, equal ones by rising number. The weights add up to 1.
struct PatchBlend
{
  std::array<std::int32_t, maximumBlendPatches> patches{ -1, -1, -1, -1 }; ///< -1 = none
  std::array<float, maximumBlendPatches> weights{ 0.0f, 0.0f, 0.0f, 0.0f };
};

/// The blend of every point, from the patches of the triangles (surface.mesh.patches). Where more
/// than four patches reach a point, the four strongest remain and are scaled up to 1. Points of no
/// patch have no patches and weights of 0.
///
/// Rings: weights begin as BlendStart says and are replaced n - 1 times by the average over the
/// neighbouring vertices, then normalised. Neighbours share an edge of a face; an edge along which
/// a polygon was cut into triangles is none.
///
/// Distance: with t the distance to the border of a patch, negative outside of the patch, its
/// weight is smoothstep(-distance, distance, t), then normalised. Distances are measured over the
/// triangles, by fast marching.
///
/// Throws std::invalid_argument as checkFaceSurface does, and on bad options. Returns an empty
/// result when `progress` stopped the work.
std::vector<PatchBlend> patchBlendWeights(
  const FaceSurface& surface, const BlendOptions& options = {});

namespace detail
{
struct PatchWeight
{
  std::int32_t patch = 0;
  double weight = 0.0;
};
using PatchWeights = std::vector<PatchWeight>;

/// The patches that meet at every vertex, and the triangles there. Triangles without patch are left
/// out.
struct PatchBorders
{
  explicit PatchBorders(const FaceSurface& someSurface);

  const FaceSurface& surface;
  std::vector<std::int32_t> patches; ///< per vertex: one of its patches, -1 = none
  std::vector<std::int32_t> borders; ///< the vertices at which several patches meet, ascending
  std::vector<std::size_t> offsets;  ///< per vertex: where its triangles begin, and one more
  std::vector<std::int32_t> triangles;

  Span<const std::int32_t> trianglesAt(std::int32_t vertex) const
  {
    const std::size_t begin = offsets[vertex];
    return Span<const std::int32_t>(triangles).subspan(begin, offsets[vertex + 1] - begin);
  }
};

/// The weights of the vertices near borders.
struct VertexBlends
{
  explicit VertexBlends(std::size_t vertexCount)
    : slots(vertexCount, -1)
  {
  }

  std::vector<std::int32_t> slots; ///< per vertex: index into the next two, -1 = far from borders
  std::vector<std::int32_t> vertices; ///< per slot
  std::vector<PatchWeights> weights;  ///< per slot

  /// The slot of a vertex; a new one gets the whole of the vertex's patch.
  std::int32_t slotOf(std::int32_t vertex, const PatchBorders& borders);
};

/// Scales weights so that they add up to 1.
void normalise(PatchWeights& weights);

bool blendOverDistance(
  const PatchBorders& borders, const BlendOptions& options, VertexBlends& blends);
} // namespace detail
} // namespace hachure

#endif
