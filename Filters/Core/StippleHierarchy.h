// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleHierarchy_h
#define hachure_StippleHierarchy_h

#include "Span.h"
#include "SurfaceSampling.h"
#include "TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

// Points on a surface in an order of which every beginning is spread evenly: the first n are the
// stipples of a light tone, and a darker tone only adds others (Meruvia Pastor and Strothotte 2002,
// with a better order as the default).
namespace hachure
{

// Evenly spread points are as far apart as the root of this over their density (measured).
constexpr double stippleSquareSpacing = 0.47;

// The rank of a point is its index.
struct StipplePoint
{
  std::int32_t triangle = 0;         // of the mesh; of points without a mesh, the point
  float weights[2] = { 0.0f, 0.0f }; // barycentric, of the second and third corner
  // Relevance, in units of the mesh. Progressive: all points of this and of lower rank are at least
  // so far apart; never more than that of the point before, so that a bound of the spacing is a
  // bound of the rank. Classic: the shortest edge to a relevant neighbour. Where there is nothing
  // to compare with (rank 0; the top of the classic hierarchy), the diagonal of the bounds.
  float spacing = 0.0f;
};

enum class StippleOrder
{
  Progressive, // blue noise on the surface, nested
  Classic      // edge collapses and longest-edge splits, as in the paper
};

struct StippleOptions
{
  std::int64_t count = 100000; // points wanted, 0 to 2^27
  std::uint32_t seed = 1;
  StippleOrder order = StippleOrder::Progressive;
  // Classic: how far a vertex is moved, as shares of the edges of a triangle (section 2.4.1); 0 to
  // 0.5, the least first. Both 0: no vertex is moved.
  double leastMove = 0.125;
  double mostMove = 0.25;
  // Called on the caller's thread with the finished fraction; false stops, and the result is empty.
  ProgressFn progress;
};

struct StippleHierarchy
{
  // By rank. Fewer than wanted only where there is no place (no area) or no further point.
  std::vector<StipplePoint> points;
  // Area over which the points are spread: equal triangles count once, those of zero area not. The
  // first n points of a mesh have the density n / area. 0 for points without a mesh.
  double area = 0.0;
  // Diagonal of the bounds of all that points can be on.
  double size = 0.0;

  // Classic only, otherwise empty. Relevant neighbours of point i, all of lower rank:
  // neighbours[firstNeighbour[i]] to neighbours[firstNeighbour[i + 1] - 1]. The stipple is drawn
  // where all these edges, projected, are longer than the threshold of the wanted tone. None: it is
  // always drawn. Edges are as long as the points are apart.
  std::vector<std::uint32_t> firstNeighbour; // one more than there are points
  std::vector<std::int32_t> neighbours;
  // Classic only: the particle mesh between all points (the paper's figure 4); corners are ranks.
  std::vector<glm::ivec3> particleTriangles;

  std::size_t memory() const; // bytes held
};

// Spreads points over the triangles, whatever their size and connectivity. Distances are in space,
// between places that do not face opposite ways: the two sides of a thin wall do not see each
// other. Progressive keeps a third of a spacing from open borders, about as from mirrored points.
// The patches of the mesh are not read. The result is a function of the mesh and the options,
// whatever the number of threads. Throws std::invalid_argument for a bad mesh or option.
StippleHierarchy stippleSurface(const TriangleMesh& mesh, const StippleOptions& options = {});

// Ranks given points, Progressive only: of points in one place one is taken. Normals of any
// length, or none; (0, 0, 0) faces every way. Throws for another number of normals, numbers that
// are not finite and StippleOrder::Classic.
StippleHierarchy stipplePoints(Span<const glm::dvec3> points, Span<const glm::dvec3> normals = {},
  const StippleOptions& options = {});

// Where the point is.
glm::dvec3 stipplePosition(const TriangleMesh& mesh, const StipplePoint& point);

} // namespace hachure

#endif
