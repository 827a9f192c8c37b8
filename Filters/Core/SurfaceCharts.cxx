// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceCharts.h"

#include "Parallel.h"
#include "SurfaceChartsPlaces.h"
#include "SurfaceChartsSmooth.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace hachure
{
namespace
{
std::size_t indexOf(std::int32_t number)
{
  return static_cast<std::size_t>(number);
}

double areaOf(const TriangleMesh& mesh, std::size_t triangle)
{
  return 0.5 * glm::length(triangleAreaVector(mesh, static_cast<std::int64_t>(triangle)));
}

double areaOfAll(const TriangleMesh& mesh)
{
  double area = 0.0;
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
  {
    area += areaOf(mesh, triangle);
  }
  return area;
}

// Charts of what a mesh was simplified to.
class ChartMaker
{
public:
  ChartMaker(const TriangleMesh& someMesh, const BaseMesh& aBase)
    : mesh(someMesh)
    , base(aBase)
    , chartOfBase(aBase.mesh.triangleCount(), -1)
  {
  }

  // Parts of less area are one chart.
  SurfaceCells make(double leastArea)
  {
    this->findParts(leastArea);
    this->addCharts();
    this->place();
    this->measure();
    this->link();
    return std::move(this->cells);
  }

private:
  bool isLeft(std::size_t triangle) const { return this->base.mesh.vertices[3 * triangle] >= 0; }

  // The small parts, each by its first triangle.
  void findParts(double leastArea)
  {
    const std::size_t count = this->base.mesh.triangleCount();
    this->partOf.assign(count, -1);
    std::vector<char> isKnown(count, 0);
    std::vector<std::int32_t> part;
    for (std::size_t triangle = 0; triangle < count; ++triangle)
    {
      if (this->isLeft(triangle) && isKnown[triangle] == 0)
      {
        this->findPart(static_cast<std::int32_t>(triangle), isKnown, part);
        double area = 0.0;
        for (const std::int32_t member : part)
        {
          area += this->base.areas[indexOf(member)];
        }
        for (std::size_t i = 0; i < part.size() && area < leastArea; ++i)
        {
          this->partOf[indexOf(part[i])] = part[0];
        }
      }
    }
  }

  void findPart(
    std::int32_t start, std::vector<char>& isKnown, std::vector<std::int32_t>& part) const
  {
    part.assign(1, start);
    isKnown[indexOf(start)] = 1;
    for (std::size_t next = 0; next < part.size(); ++next)
    {
      for (std::int32_t corner = 3 * part[next]; corner < 3 * part[next] + 3; ++corner)
      {
        const std::int32_t across = this->base.mesh.opposite(corner);
        if (across >= 0 && isKnown[indexOf(across / 3)] == 0)
        {
          isKnown[indexOf(across / 3)] = 1;
          part.push_back(across / 3);
        }
      }
    }
  }

  void addCharts()
  {
    for (std::size_t triangle = 0; triangle < this->chartOfBase.size(); ++triangle)
    {
      const std::int32_t part = this->partOf[triangle];
      if (!this->isLeft(triangle) || (part >= 0 && indexOf(part) != triangle))
      {
        continue;
      }
      this->chartOfBase[triangle] = static_cast<std::int32_t>(this->cells.charts.size());
      this->baseOfChart.push_back(static_cast<std::int32_t>(triangle));
      CellChart chart;
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        chart.corners[static_cast<int>(corner)] =
          this->base.mesh.points[indexOf(this->base.mesh.vertices[3 * triangle + corner])];
      }
      this->cells.charts.push_back(chart);
    }
  }

  void place()
  {
    const std::size_t count = this->mesh.triangles.size();
    this->cells.chartOfTriangle.resize(count);
    this->cells.places.resize(count);
    parallelFor(static_cast<std::int64_t>(count),
      [&](std::int64_t i)
      {
        const auto triangle = static_cast<std::size_t>(i);
        const TrianglePlace found = placeTriangle(this->base, this->base.mesh.sources[triangle]);
        const std::int32_t part = found.triangle < 0 ? -1 : this->partOf[indexOf(found.triangle)];
        const std::int32_t under = part >= 0 ? part : found.triangle;
        this->cells.chartOfTriangle[triangle] = under < 0 ? -1 : this->chartOfBase[indexOf(under)];
        this->cells.places[triangle] = found.corners;
        if (part >= 0)
        {
          this->cells.places[triangle].fill(glm::vec2(1.0f / 3.0f));
        }
      });
  }

  void measure()
  {
    for (std::size_t triangle = 0; triangle < this->mesh.triangles.size(); ++triangle)
    {
      const std::int32_t chart = this->cells.chartOfTriangle[triangle];
      if (chart >= 0)
      {
        this->cells.charts[indexOf(chart)].area += areaOf(this->mesh, triangle);
      }
    }
    // Where the middle of no triangle lies: what it should be.
    for (std::size_t chart = 0; chart < this->cells.charts.size(); ++chart)
    {
      if (!(this->cells.charts[chart].area > 0.0))
      {
        this->cells.charts[chart].area = this->base.areas[indexOf(this->baseOfChart[chart])];
      }
    }
  }

  // By the simplified mesh; over cuts by the charts' corners.
  void link()
  {
    detail::linkCharts(this->cells.charts);
    for (std::size_t chart = 0; chart < this->cells.charts.size(); ++chart)
    {
      for (std::size_t edge = 0; edge < 3; ++edge)
      {
        std::int32_t& code = this->cells.charts[chart].neighbours[edge];
        const std::int32_t triangle = this->baseOfChart[chart];
        const std::int32_t across = this->base.mesh.opposites[3 * indexOf(triangle) + edge];
        if (across >= 0 || this->partOf[indexOf(triangle)] >= 0)
        {
          code = this->partOf[indexOf(triangle)] >= 0
            ? -1
            : 6 * this->chartOfBase[indexOf(across / 3)] + 2 * (across % 3);
        }
        else if (across == CornerMesh::border || !this->isCut(code))
        {
          code = -1;
        }
      }
    }
  }

  bool isCut(std::int32_t code) const
  {
    return code >= 0 &&
      this->base.mesh
        .opposites[3 * indexOf(this->baseOfChart[indexOf(code / 6)]) + indexOf(code % 6 / 2)] ==
      CornerMesh::cut;
  }

  const TriangleMesh& mesh;
  const BaseMesh& base;
  std::vector<std::int32_t> partOf;      // of base triangles: of a small part, its first triangle
  std::vector<std::int32_t> chartOfBase; // of base triangles
  std::vector<std::int32_t> baseOfChart;
  SurfaceCells cells;
};
} // namespace

SurfaceCells surfaceCells(
  const TriangleMesh& mesh, const SurfaceCellOptions& options, const ProgressFn& progress)
{
  checkTriangleMesh(mesh);
  detail::checkOptions(options);
  if (mesh.triangles.size() <= static_cast<std::size_t>(options.baseCells))
  {
    const std::vector<glm::ivec3> triangles = joinedTriangles(mesh);
    return trianglesAsCells({ mesh.points, triangles, {} }, options);
  }
  // Of the time.
  constexpr double collapsing = 0.7;
  constexpr double smoothing = 0.2;
  const auto within = [&](double start, double part)
  {
    return ProgressFn([&progress, start, part](double fraction)
      { return !progress || progress(start + part * fraction); });
  };
  CollapseOptions collapse;
  collapse.triangles = options.baseCells;
  collapse.area = areaOfAll(mesh) / options.baseCells;
  collapse.progress = within(0.0, collapsing);
  BaseMesh base = collapseToBase(makeCornerMesh(mesh), collapse);
  if (base.isStopped || !smoothHomes(base, within(collapsing, smoothing)))
  {
    return {};
  }
  SurfaceCells cells =
    ChartMaker(mesh, base).make(collapse.area * std::pow(0.25, options.finestLevel));
  detail::numberNodes(cells, options);
  return cells;
}

} // namespace hachure
