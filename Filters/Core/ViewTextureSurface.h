// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewTextureSurface_h
#define hachure_ViewTextureSurface_h

#include "CellLayers.h"
#include "HemisphereTable.h"
#include "SurfaceFrames.h"
#include "TriangleMesh.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace hachure
{

// What the colours of a view-dependent texture need of their surface, made once. It does not move,
// as its layers look into its cells.
class ViewTextureSurface
{
public:
  // Copies the mesh. Throws std::invalid_argument for cells or frames of another mesh.
  ViewTextureSurface(
    const TriangleMesh& mesh, const SurfaceCells& cells, const SurfaceFrames& frames);
  ViewTextureSurface(const ViewTextureSurface&) = delete;
  ViewTextureSurface& operator=(const ViewTextureSurface&) = delete;

  TriangleMesh mesh() const { return { this->points, this->triangles, {} }; }
  int levels() const { return static_cast<int>(this->layers.size()); }
  const CellLayer& layer(int level) const { return this->layers[static_cast<std::size_t>(level)]; }
  Span<const CellLayer> allLayers() const { return this->layers; }
  // Of a level's nodes; they are numbered chart by chart without other levels.
  const NodeCells& nodeCells(int level) const
  {
    return this->nodes[static_cast<std::size_t>(level)];
  }
  // Of nodes of all levels.
  std::int64_t nodeCount() const
  {
    return this->cells.firstNode.empty() ? 0 : this->cells.firstNode.back();
  }
  const glm::quat& turnOfNode(std::int64_t node) const
  {
    return this->turns[static_cast<std::size_t>(node)];
  }
  const glm::quat& turnOfCell(int level, std::int32_t cell) const
  {
    return this->turnOfNode(this->layer(level).nodeOf(cell));
  }
  // The middle of a cell, in model coordinates.
  const glm::dvec3& placeOfCell(int level, std::int32_t cell) const
  {
    return this->places[static_cast<std::size_t>(level)][static_cast<std::size_t>(cell)];
  }
  // The nodes of the level before that a cell's middle is mixed of, and so its cells.
  void mixFromBelow(int level, std::int32_t cell, std::vector<NodeCells::Share>& shares) const;

private:
  void checkInput(const SurfaceFrames& frames) const;
  void placeNodes(const SurfaceFrames& frames);

  std::vector<glm::dvec3> points;
  std::vector<glm::ivec3> triangles;
  SurfaceCells cells;
  std::vector<CellLayer> layers;
  std::vector<NodeCells> nodes;
  std::vector<glm::quat> turns;
  std::vector<std::vector<glm::dvec3>> places;
};

} // namespace hachure

#endif
