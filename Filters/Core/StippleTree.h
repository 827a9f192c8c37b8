// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleTree_h
#define hachure_StippleTree_h

#include "Span.h"
#include "StippleHierarchy.h"
#include "StippleNode.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

// The points of a hierarchy, sorted so that those that are wanted in a view are soon found, and
// more of them where a view comes near. The drawing walks from the root: a node out of sight, or
// whose leastDensity is above the most that is wanted in it, is left with all below it; a point is
// drawn where its density is at most the wanted one at it. So the work follows what is drawn.
//
// Density is the number of points per unit of area at which a point comes in: for the point of rank
// k it is (k + 1) / area. Points of a refinement go on from there, for every density as evenly as
// the hierarchy. They are a function of the reference mesh, the base and the seed: neither of what
// was refined before nor of how the mesh is deformed.
namespace hachure
{

class StippleRefinement;
class StippleShape;
struct StippleLevels;

struct StippleTreeOptions
{
  std::uint32_t seed = 1; // of the points of refinements
  // Bytes that refinements may take besides the base; one that does not fit is not made.
  std::size_t budget = std::size_t{ 256 } << 20;
  // Called on the caller's thread with the finished fraction of the building; false stops, and the
  // tree is empty.
  ProgressFn progress;
};

struct StippleRequest
{
  std::int32_t node = 0; // of nodes()
  double density = 0.0;  // wanted, per unit of the present area
};

class StippleTree
{
public:
  // Points of stippleSurface(reference), in either order. Only the progressive ones of a mesh with
  // an area can be refined. Classic: the density is that of evenly spread points with the point's
  // spacing, stippleSquareSpacing / spacing^2. The mesh is copied, and nothing else is kept. Throws
  // std::invalid_argument for a bad mesh, and a base whose points are not on it.
  explicit StippleTree(const TriangleMesh& reference, const StippleHierarchy& base,
    const StippleTreeOptions& options = {});
  // Points of stipplePoints(points, normals): the density is as for classic ones. No refinement.
  StippleTree(Span<const glm::dvec3> points, Span<const glm::dvec3> normals,
    const StippleHierarchy& base, const StippleTreeOptions& options = {});
  ~StippleTree();
  StippleTree(StippleTree&&) noexcept;
  StippleTree& operator=(StippleTree&&) noexcept;
  StippleTree(const StippleTree&) = delete;
  StippleTree& operator=(const StippleTree&) = delete;

  // The first is the root; empty if there are no points. Refinements add nodes and points at the
  // end; numbers stay valid, references do not. A node that is not reached from the root waits for
  // the rest of its parent's children.
  const std::vector<StippleNode>& nodes() const { return this->allNodes; }
  const StippleNode& node(std::int32_t index) const
  {
    return this->allNodes[static_cast<std::size_t>(index)];
  }

  // Names a point of a node for as long as the mesh, the base and the seed are the same: the rank
  // for a point of the base, at least 2^63 for others.
  std::uint64_t identity(std::int32_t node, std::int32_t point) const;

  bool canRefine() const { return this->refinement != nullptr; }
  // Makes the children of all nodes that have none and whose heldDensity is below the wanted one. A
  // request makes one level, because only what is in sight of it may need the next: walk again,
  // until nothing is asked for. False if the budget was spent, a node is of the finest level
  // (spacings of some 1e-6 of the mesh's size) or the progress function stopped it: then a node has
  // either all of its children or none. Throws std::invalid_argument for a node that is none and a
  // density that is NaN.
  bool refine(Span<const StippleRequest> requests, const ProgressFn& progress = {});
  // Bytes for refinements from now on; what is there stays.
  void setBudget(std::size_t bytes) { this->budget = bytes; }
  // Forgets all points of refinements, to make room for others; made again they are the same.
  void dropRefinements();

  // Moves the mesh: as many points as the reference has. Places, normals, bounds and densities (by
  // the ratio of a triangle's areas) follow; in a triangle that has no area any more the density is
  // infinite. Points without a mesh also take normals, or keep theirs. Throws std::invalid_argument
  // for another number of points or normals, and numbers that are not finite.
  void setPositions(Span<const glm::dvec3> points, Span<const glm::dvec3> normals = {});

  std::size_t memory() const; // bytes held
  std::size_t refinedMemory() const { return this->memory() - this->baseMemory; }

private:
  void build(const StippleHierarchy& base, const StippleTreeOptions& options);
  void prepareRefinement(std::uint32_t seed, std::size_t pointCount);

  std::unique_ptr<StippleShape> shape;
  std::unique_ptr<StippleLevels> levels;
  std::vector<StippleNode> allNodes;
  std::size_t baseCount = 0;  // of nodes
  std::size_t baseMemory = 0; // bytes before any refinement
  std::size_t budget = 0;
  std::unique_ptr<StippleRefinement> refinement; // if there can be one
};

} // namespace hachure

#endif
