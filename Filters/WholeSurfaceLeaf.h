// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A block of a surface that processes hold parts of, put together from them.
 */
#ifndef WholeSurfaceLeaf_h
#define WholeSurfaceLeaf_h

#include "Core/CanonicalOrder.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstdint>
#include <functional>
#include <vector>

class vtkDataSetAttributes;
class vtkPolyData;

namespace hachure
{

/// The polygons of a block alone, without ghosts; strips are triangles. Null gives no cells.
vtkSmartPointer<vtkPolyData> polygonsOf(vtkPolyData* block);

/// The block without ghosts and with triangles for strips, whose polygons are those of
/// polygonsOf().
vtkSmartPointer<vtkPolyData> withoutGhosts(vtkPolyData* block);

/// Polygons of a block as Core takes them.
struct PolygonLists
{
  std::vector<std::int64_t> offsets;
  std::vector<std::int64_t> corners;
  PolygonCells cells() const { return { this->offsets, this->corners }; }
};
PolygonLists polygonLists(vtkPolyData* polygons);
std::vector<glm::dvec3> pointsOf(vtkPolyData* surface);

/// Extends a box by polygons.
void addPolygons(vtkPolyData* polygons, CellBox& box);

class WholeSurfaceLeaf
{
public:
  /// Polygons of every process, in their order. The cells keep their order as long as all parts
  /// keep their connectivity, so that what is attached to them stays while they move. The arrays
  /// are those that all parts with cells have. boxOfAll: asked where an order is made; of all
  /// blocks, so that a block's cells have the order that they have in a surface of one block.
  void assemble(const std::vector<vtkSmartPointer<vtkPolyData>>& parts,
    const std::function<CellBox()>& boxOfAll);

  vtkPolyData* whole() const { return this->Whole; }
  /// Of the polygon, and of the point, of a part: its cell or point in the whole; -1 where a point
  /// is of no cell.
  vtkIdType cellOf(std::size_t part, vtkIdType cell) const;
  vtkIdType pointOf(std::size_t part, vtkIdType point) const;

private:
  void order(vtkPolyData* appended, const CellBox& box);
  void build(vtkPolyData* appended);

  std::vector<std::uint64_t> Connectivity; // a hash of every part's
  std::vector<vtkIdType> FirstCells;       // of the parts
  std::vector<vtkIdType> FirstPoints;
  std::vector<std::int64_t> Order;
  std::vector<vtkIdType> CellNumbers; // inverse of the order
  DistinctPoints Points;
  vtkSmartPointer<vtkPolyData> Whole;
};

} // namespace hachure

#endif
