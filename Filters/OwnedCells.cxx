// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OwnedCells.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace hachure
{
namespace
{
using Corners = std::vector<glm::dvec3>;

Corners cornersOf(vtkPolyData* block, vtkIdType polygon, vtkIdList* list)
{
  block->GetPolys()->GetCellAtId(polygon, list);
  Corners corners(static_cast<std::size_t>(list->GetNumberOfIds()));
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    block->GetPoint(list->GetId(static_cast<vtkIdType>(i)), &corners[i][0]);
  }
  return corners;
}

// Twice the area, along the normal.
glm::dvec3 areaOf(const Corners& corners)
{
  glm::dvec3 area(0.0);
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    area += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  }
  return area;
}

// A point that no cut through the middle of a cell meets.
glm::dvec3 pointIn(const Corners& corners)
{
  constexpr double first = 0.47;
  constexpr double second = 0.32;
  constexpr double third = 0.21;
  return first * corners[0] + second * corners[1] + third * corners[2];
}

// In the plane of two axes that does not see the polygon from the side.
bool contains(const Corners& polygon, const glm::dvec3& normal, const glm::dvec3& point)
{
  const glm::dvec3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
  const int away = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  const int x = (away + 1) % 3;
  const int y = (away + 2) % 3;
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec3& begin = polygon[i];
    const glm::dvec3& end = polygon[(i + 1) % polygon.size()];
    if ((begin[y] > point[y]) != (end[y] > point[y]))
    {
      const double share = (point[y] - begin[y]) / (end[y] - begin[y]);
      inside = inside != (point[x] < begin[x] + share * (end[x] - begin[x]));
    }
  }
  return inside;
}

bool draws(const Corners& own, const Corners& cell)
{
  if (own.size() < 3 || cell.size() < 3)
  {
    return false;
  }
  constexpr double uncut = 1.0 - 1e-4; // cuts round coordinates
  const glm::dvec3 normal = areaOf(cell);
  return glm::length(areaOf(own)) >= uncut * glm::length(normal) ||
    contains(own, normal, pointIn(cell));
}
} // namespace

std::vector<std::uint8_t> ownedCells(vtkPolyData* part, vtkPolyData* whole, const std::string& ids)
{
  std::vector<std::uint8_t> owned(static_cast<std::size_t>(whole->GetNumberOfPolys()), 0);
  vtkDataArray* numbers = part ? part->GetCellData()->GetArray(ids.c_str()) : nullptr;
  if (!numbers)
  {
    return owned;
  }
  const vtkIdType others = part->GetNumberOfVerts() + part->GetNumberOfLines();
  vtkNew<vtkIdList> list;
  for (vtkIdType i = 0; i < part->GetNumberOfPolys(); ++i)
  {
    const auto id = static_cast<vtkIdType>(numbers->GetComponent(others + i, 0));
    if (id < 0 || id >= whole->GetNumberOfPolys() || owned[static_cast<std::size_t>(id)] != 0)
    {
      continue;
    }
    owned[static_cast<std::size_t>(id)] =
      draws(cornersOf(part, i, list), cornersOf(whole, id, list)) ? 1 : 0;
  }
  return owned;
}
} // namespace hachure
