// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewTextureOutput.h"

#include "Core/SrgbColor.h"
#include "Core/ViewTexture.h"
#include "SurfacePatchesInput.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTextureViews.h>
#include <vtkUnsignedCharArray.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace hachure
{
namespace
{
template <class ArrayType>
ArrayType* addCellArray(
  vtkPolyData* output, const char* name, std::size_t count, int components = 1)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  output->GetCellData()->AddArray(array);
  return array;
}

// Cells that have a triangle, which are those of the output.
std::vector<std::int32_t> drawnCells(const CellMesh& mesh)
{
  std::vector<std::int32_t> drawn;
  drawn.reserve(mesh.triangles.size());
  for (std::size_t cell = 0; cell < mesh.triangles.size(); ++cell)
  {
    if (mesh.triangles[cell].x >= 0)
    {
      drawn.push_back(static_cast<std::int32_t>(cell));
    }
  }
  return drawn;
}

vtkNew<vtkPoints> pointsOf(const std::vector<glm::dvec3>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), &places[i].x);
  }
  return points;
}

double areaOf(const CellMesh& mesh, const glm::ivec3& corners)
{
  const auto at = [&](int corner) -> const glm::dvec3&
  { return mesh.points[static_cast<std::size_t>(corners[corner])]; };
  return 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
}

void attachGeometry(
  const ViewTextureCells& cells, const std::vector<std::int32_t>& drawn, vtkPolyData* output)
{
  auto* charts = addCellArray<vtkIntArray>(output, "Chart", drawn.size());
  auto* levels = addCellArray<vtkIntArray>(output, "Level", drawn.size());
  auto* areas = addCellArray<vtkDoubleArray>(output, "Area", drawn.size());
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(
    static_cast<vtkIdType>(drawn.size()), 3 * static_cast<vtkIdType>(drawn.size()));
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const std::int32_t chart = cells.layer.chartOf(drawn[i]);
    const int first = cells.layer.surface().charts[static_cast<std::size_t>(chart)].level;
    const glm::ivec3& corners = cells.mesh.triangles[static_cast<std::size_t>(drawn[i])];
    const vtkIdType ids[3] = { corners.x, corners.y, corners.z };
    triangles->InsertNextCell(3, ids);
    charts->SetValue(id, chart);
    levels->SetValue(id, std::max(cells.layer.number(), first));
    areas->SetValue(id, areaOf(cells.mesh, corners));
  }
  output->SetPoints(pointsOf(cells.mesh.points));
  output->SetPolys(triangles);
}

void attachColors(
  const ViewTextureCells& cells, const std::vector<std::int32_t>& drawn, vtkPolyData* output)
{
  constexpr float whole = 255.0f;
  constexpr int channels = 4;
  auto* independent = addCellArray<vtkUnsignedCharArray>(output, "Independent", drawn.size(), 4);
  auto* dependent = addCellArray<vtkFloatArray>(output, "DependentShare", drawn.size());
  const ViewTextureColors& colors = cells.colors;
  const auto side = static_cast<std::size_t>(colors.hemisphere);
  const std::size_t directions = side * side;
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const auto node = static_cast<std::size_t>(cells.layer.nodeOf(drawn[i]));
    const glm::u8vec4& color = colors.independent[node];
    for (int channel = 0; channel < channels; ++channel)
    {
      independent->SetTypedComponent(id, channel, color[channel]);
    }
    std::uint8_t most = 0;
    for (std::size_t direction = 0; direction < directions; ++direction)
    {
      most = std::max(most, colors.dependent[directions * node + direction].a);
    }
    dependent->SetValue(id, static_cast<float>(most) / whole);
  }
}

// The views' colours of their own, mixed as light.
glm::u8vec4 mixedColor(const std::vector<std::vector<float>>& shares, std::size_t node)
{
  glm::vec4 sum(0.0f);
  for (std::size_t view = 0; view < shares.size(); ++view)
  {
    sum += shares[view][node] * linearOf(coverageColor(view));
  }
  return srgbOf(sum);
}

void attachShares(const ViewTextureCells& cells, const std::vector<std::int32_t>& drawn,
  vtkTextureViews* views, vtkPolyData* output)
{
  auto* coverage = addCellArray<vtkUnsignedCharArray>(output, "Coverage", drawn.size(), 4);
  const auto count = static_cast<int>(cells.shares.size());
  auto* shares =
    count > 0 ? addCellArray<vtkFloatArray>(output, "ViewShares", drawn.size(), count) : nullptr;
  for (int view = 0; view < count; ++view)
  {
    shares->SetComponentName(view, views->GetViewName(view).c_str());
  }
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const auto node = static_cast<std::size_t>(cells.layer.nodeOf(drawn[i]));
    const glm::u8vec4 color = mixedColor(cells.shares, node);
    coverage->SetTypedTuple(id, &color.r);
    for (int view = 0; view < count; ++view)
    {
      shares->SetTypedComponent(id, view, cells.shares[static_cast<std::size_t>(view)][node]);
    }
  }
}
} // namespace

std::vector<std::int32_t> mainViews(const ViewTextureCells& cells)
{
  std::vector<std::int32_t> main(static_cast<std::size_t>(cells.layer.size()), -1);
  for (std::size_t cell = 0; cell < main.size(); ++cell)
  {
    const auto node = static_cast<std::size_t>(cells.layer.nodeOf(static_cast<std::int32_t>(cell)));
    float most = 0.0f;
    for (std::size_t view = 0; view < cells.shares.size(); ++view)
    {
      if (cells.shares[view][node] > most)
      {
        most = cells.shares[view][node];
        main[cell] = static_cast<std::int32_t>(view);
      }
    }
  }
  return main;
}

void attachCells(const ViewTextureCells& cells, vtkTextureViews* views,
  const std::vector<std::int32_t>& labels, vtkPolyData* output)
{
  const std::vector<std::int32_t> drawn = drawnCells(cells.mesh);
  attachGeometry(cells, drawn, output);
  attachColors(cells, drawn, output);
  attachShares(cells, drawn, views, output);
  auto* main = addCellArray<vtkIntArray>(output, "View", drawn.size());
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    main->SetValue(static_cast<vtkIdType>(i), labels[static_cast<std::size_t>(drawn[i])]);
  }
}

void attachBorders(
  const ViewTextureCells& cells, const std::vector<std::int32_t>& labels, vtkPolyData* output)
{
  const std::vector<CellBorder> borders = cellBorders(cells.layer, cells.mesh, labels);
  auto* views = addCellArray<vtkIntArray>(output, "Views", borders.size(), 2);
  vtkNew<vtkCellArray> lines;
  std::vector<glm::dvec3> places; // only those of lines
  places.reserve(borders.size() + 1);
  std::vector<vtkIdType> known(cells.mesh.points.size(), -1);
  for (std::size_t i = 0; i < borders.size(); ++i)
  {
    vtkIdType ends[2];
    for (std::size_t end = 0; end < 2; ++end)
    {
      const auto point = static_cast<std::size_t>(borders[i].points[end]);
      if (known[point] < 0)
      {
        known[point] = static_cast<vtkIdType>(places.size());
        places.push_back(cells.mesh.points[point]);
      }
      ends[end] = known[point];
    }
    lines->InsertNextCell(2, ends);
    const auto sides = std::minmax(labels[static_cast<std::size_t>(borders[i].cells[0])],
      labels[static_cast<std::size_t>(borders[i].cells[1])]);
    const int pair[2] = { sides.first, sides.second };
    views->SetTypedTuple(static_cast<vtkIdType>(i), pair);
  }
  output->SetPoints(pointsOf(places));
  output->SetLines(lines);
}

void attachPointColors(vtkDataObject* input, const SurfaceTriangles& surface,
  const std::vector<glm::u8vec4>& colors, vtkDataObject* output)
{
  copyBlocks(input, output);
  const std::vector<vtkPolyData*> blocks = polyDataBlocks(output);
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName("Colors");
    array->SetNumberOfComponents(4);
    array->SetNumberOfTuples(blocks[block]->GetNumberOfPoints());
    const auto first = static_cast<std::size_t>(surface.blocks[block].firstPoint);
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      array->SetTypedTuple(i, &colors[first + static_cast<std::size_t>(i)].r);
    }
    blocks[block]->GetPointData()->SetScalars(array);
  }
}

} // namespace hachure
