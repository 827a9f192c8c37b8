// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceRaster.h"

#include "Parallel.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

// Triangles are drawn in homogeneous pixel coordinates (Olano and Greer 1997): the weights of a
// triangle's corners at a pixel, over w, are linear functions of the pixel, also for corners behind
// the eye, so that nothing has to be cut off: where all three are positive the triangle is seen.
namespace hachure
{
namespace
{
using Corners = std::array<glm::dvec4, 3>; // x, y (pixels), z, each times w, and w

struct DrawnTriangle
{
  std::array<glm::dvec3, 3> weights{}; // over w: factors of the pixel's x, of its y, and of 1
  glm::dvec3 slack{ 0.0 };             // rounding of them anywhere in the picture
  glm::dvec3 depth{ 0.0 };
  double determinant = 0.0; // 0: not seen, or from its edge only

  double weight(int corner, double x, double y) const
  {
    const glm::dvec3& factors = this->weights[static_cast<std::size_t>(corner)];
    return factors.x * x + factors.y * y + factors.z;
  }
};

struct RowRange
{
  std::int32_t first = 0, last = -1;
};

// The point that a matrix to clip space maps to x = y = w = 0, in homogeneous coordinates: the eye,
// or the direction to it.
glm::dvec4 eyeOf(const glm::dmat4& modelToClip)
{
  const glm::dmat4 rows = glm::transpose(modelToClip);
  glm::dvec4 eye(0.0);
  for (int i = 0; i < 4; ++i)
  {
    // All coordinates but one, in turn.
    const auto without = [&](int row)
    { return glm::dvec3(rows[row][(i + 1) % 4], rows[row][(i + 2) % 4], rows[row][(i + 3) % 4]); };
    eye[i] = (i % 2 == 0 ? 1.0 : -1.0) * glm::dot(without(0), glm::cross(without(1), without(3)));
  }
  return eye;
}

class Drawing
{
public:
  Drawing(const TriangleMesh& mesh, Span<const std::int32_t> shown, const glm::dmat4& modelToClip,
    SurfaceRaster& raster);
  void drawRows(int first, int last);
  // Weights of what was drawn; the area of the surface that it shows.
  double resolveRow(int row);

private:
  Corners cornersOf(std::size_t triangle) const;
  double shownShare(std::size_t triangle, const glm::dvec3& weights) const;
  DrawnTriangle setUp(std::size_t triangle) const;
  RowRange rowsOf(std::size_t triangle) const;
  void drawRow(const DrawnTriangle& drawn, std::int32_t triangle, int row, double* depth);

  const TriangleMesh& mesh;
  SurfaceRaster& raster;
  glm::dvec4 eye; // homogeneous
  std::vector<glm::dvec4> points;
  std::vector<RowRange> rows; // of every triangle
};

Drawing::Drawing(const TriangleMesh& surface, Span<const std::int32_t> shown,
  const glm::dmat4& modelToClip, SurfaceRaster& result)
  : mesh(surface)
  , raster(result)
  , eye(eyeOf(modelToClip))
  , points(surface.points.size())
  , rows(surface.triangles.size())
{
  parallelFor(static_cast<std::int64_t>(this->points.size()),
    [&](std::int64_t i)
    {
      const auto point = static_cast<std::size_t>(i);
      const glm::dvec4 clip = modelToClip * glm::dvec4(this->mesh.points[point], 1.0);
      this->points[point] = { 0.5 * this->raster.width * (clip.x + clip.w),
        0.5 * this->raster.height * (clip.y + clip.w), clip.z, clip.w };
    });
  parallelFor(static_cast<std::int64_t>(this->rows.size()),
    [&](std::int64_t i)
    {
      const auto triangle = static_cast<std::size_t>(i);
      if (shown[triangle] >= 0)
      {
        this->rows[triangle] = this->rowsOf(triangle);
      }
    });
}

Corners Drawing::cornersOf(std::size_t triangle) const
{
  const glm::ivec3& corners = this->mesh.triangles[triangle];
  return { this->points[static_cast<std::size_t>(corners.x)],
    this->points[static_cast<std::size_t>(corners.y)],
    this->points[static_cast<std::size_t>(corners.z)] };
}

// Rows that a triangle's part in front of the eye reaches.
RowRange Drawing::rowsOf(std::size_t triangle) const
{
  const Corners corners = this->cornersOf(triangle);
  const double most = std::max({ corners[0].w, corners[1].w, corners[2].w });
  if (!(most > 0.0))
  {
    return {};
  }
  const double nearest = 1e-6 * most; // pixels nearer than that are everywhere
  double low = std::numeric_limits<double>::max();
  double high = -low;
  for (std::size_t i = 0; i < 3; ++i)
  {
    glm::dvec4 from = corners[i];
    const glm::dvec4 to = corners[(i + 1) % 3];
    if ((from.w < nearest) != (to.w < nearest))
    {
      const double share = (nearest - from.w) / (to.w - from.w);
      const double y = (from.y + share * (to.y - from.y)) / nearest;
      low = std::min(low, y);
      high = std::max(high, y);
    }
    if (from.w >= nearest)
    {
      low = std::min(low, from.y / from.w);
      high = std::max(high, from.y / from.w);
    }
  }
  const double end = this->raster.height;
  return { static_cast<std::int32_t>(std::floor(std::clamp(low - 1.0, 0.0, end))),
    static_cast<std::int32_t>(std::ceil(std::clamp(high + 1.0, 0.0, end))) - 1 };
}

DrawnTriangle Drawing::setUp(std::size_t triangle) const
{
  const Corners corners = this->cornersOf(triangle);
  std::array<glm::dvec3, 3> places;
  for (std::size_t i = 0; i < 3; ++i)
  {
    places[i] = { corners[i].x, corners[i].y, corners[i].w };
  }
  DrawnTriangle drawn;
  drawn.determinant = glm::dot(places[0], glm::cross(places[1], places[2]));
  if (!(std::abs(drawn.determinant) > 0.0) || !std::isfinite(1.0 / drawn.determinant))
  {
    drawn.determinant = 0.0;
    return drawn;
  }
  constexpr double rounding = 1e-13;
  for (int i = 0; i < 3; ++i)
  {
    const auto corner = static_cast<std::size_t>(i);
    const glm::dvec3 factors =
      glm::cross(places[(corner + 1) % 3], places[(corner + 2) % 3]) / drawn.determinant;
    drawn.weights[corner] = factors;
    drawn.slack[i] = rounding *
      (std::abs(factors.x) * this->raster.width + std::abs(factors.y) * this->raster.height +
        std::abs(factors.z));
    drawn.depth += corners[corner].z * factors;
  }
  return drawn;
}

// Of equal depths the triangle with the lowest number stays.
void Drawing::drawRow(const DrawnTriangle& drawn, std::int32_t triangle, int row, double* depth)
{
  const double y = row + 0.5;
  double low = 0.0;
  double high = this->raster.width;
  for (int corner = 0; corner < 3; ++corner)
  {
    const double slope = drawn.weights[static_cast<std::size_t>(corner)].x;
    const double zero = -(drawn.weight(corner, 0.0, y) + drawn.slack[corner]) / slope;
    low = slope > 0.0 ? std::max(low, zero - 1.0) : low;
    high = slope < 0.0 ? std::min(high, zero + 1.0) : high;
  }
  const int first = static_cast<int>(std::min(low, static_cast<double>(this->raster.width)));
  const int end = static_cast<int>(std::ceil(std::max(high, 0.0)));
  std::int32_t* triangles =
    &this->raster
       .triangles[static_cast<std::size_t>(row) * static_cast<std::size_t>(this->raster.width)];
  for (int column = first; column < end; ++column)
  {
    const double x = column + 0.5;
    const double z = drawn.depth.x * x + drawn.depth.y * y + drawn.depth.z;
    if (drawn.weight(0, x, y) >= -drawn.slack[0] && drawn.weight(1, x, y) >= -drawn.slack[1] &&
      drawn.weight(2, x, y) >= -drawn.slack[2] && z < depth[column])
    {
      depth[column] = z;
      triangles[column] = triangle;
    }
  }
}

void Drawing::drawRows(int first, int last)
{
  const auto width = static_cast<std::size_t>(this->raster.width);
  std::vector<double> depth(
    width * static_cast<std::size_t>(last - first + 1), std::numeric_limits<double>::infinity());
  for (std::size_t triangle = 0; triangle < this->rows.size(); ++triangle)
  {
    const int low = std::max(first, this->rows[triangle].first);
    const int high = std::min(last, this->rows[triangle].last);
    if (low > high)
    {
      continue;
    }
    const DrawnTriangle drawn = this->setUp(triangle);
    for (int row = low; row <= high && drawn.determinant != 0.0; ++row)
    {
      this->drawRow(drawn, static_cast<std::int32_t>(triangle), row,
        &depth[width * static_cast<std::size_t>(row - first)]);
    }
  }
}

// Almost edge-on a triangle covers a pixel or none by chance, and that pixel shows a lot of it: no
// more is counted than of one that is turned by this cosine.
double Drawing::shownShare(std::size_t triangle, const glm::dvec3& weights) const
{
  constexpr double leastCosine = 0.05;
  const glm::ivec3& corners = this->mesh.triangles[triangle];
  glm::dvec3 point(0.0);
  for (int corner = 0; corner < 3; ++corner)
  {
    point += weights[corner] * this->mesh.points[static_cast<std::size_t>(corners[corner])];
  }
  const glm::dvec3 normal = triangleAreaVector(this->mesh, static_cast<std::int64_t>(triangle));
  const glm::dvec3 towards = glm::dvec3(this->eye) - this->eye.w * point;
  const double length = glm::length(normal) * glm::length(towards);
  const double cosine = length > 0.0 ? std::abs(glm::dot(normal, towards)) / length : 1.0;
  return std::min(cosine / leastCosine, 1.0);
}

double Drawing::resolveRow(int row)
{
  double shown = 0.0;
  std::size_t last = this->rows.size();
  DrawnTriangle drawn;
  double area = 0.0; // of the triangle
  const std::size_t begin =
    static_cast<std::size_t>(row) * static_cast<std::size_t>(this->raster.width);
  for (int column = 0; column < this->raster.width; ++column)
  {
    const std::size_t pixel = begin + static_cast<std::size_t>(column);
    if (this->raster.triangles[pixel] < 0)
    {
      continue;
    }
    const auto triangle = static_cast<std::size_t>(this->raster.triangles[pixel]);
    if (triangle != last)
    {
      drawn = this->setUp(triangle);
      area = 0.5 * glm::length(triangleAreaVector(this->mesh, this->raster.triangles[pixel]));
      last = triangle;
    }
    glm::dvec3 weights(0.0);
    for (int corner = 0; corner < 3; ++corner)
    {
      weights[corner] = std::max(drawn.weight(corner, column + 0.5, row + 0.5), 0.0);
    }
    const double sum = weights.x + weights.y + weights.z; // 1 / w
    weights = sum > 0.0 && std::isfinite(sum) ? weights / sum : glm::dvec3(1.0, 0.0, 0.0);
    this->raster.weights[pixel] = glm::vec2(weights.y, weights.z);
    // From weights to pixels the area changes by det / w^3.
    const double perPixel = 2.0 * area / (sum * sum * sum * std::abs(drawn.determinant));
    shown += std::isfinite(perPixel) ? perPixel * this->shownShare(triangle, weights) : 0.0;
  }
  return shown;
}

} // namespace

SurfaceRaster rasterOf(const TriangleMesh& mesh, Span<const std::int32_t> shown,
  const glm::dmat4& modelToClip, int width, int height)
{
  SurfaceRaster raster;
  raster.width = width;
  raster.height = height;
  raster.triangles.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1);
  raster.weights.resize(raster.triangles.size());
  Drawing drawing(mesh, shown, modelToClip, raster);
  constexpr int band = 64; // rows: few enough to share, and every band looks at all triangles
  std::vector<double> areas(static_cast<std::size_t>(height), 0.0);
  parallelForRanges(height, band,
    [&](std::int64_t begin, std::int64_t end)
    {
      drawing.drawRows(static_cast<int>(begin), static_cast<int>(end) - 1);
      for (std::int64_t row = begin; row < end; ++row)
      {
        areas[static_cast<std::size_t>(row)] = drawing.resolveRow(static_cast<int>(row));
      }
    });
  for (const double area : areas)
  {
    raster.area += area;
  }
  raster.pixels = static_cast<std::int64_t>(raster.triangles.size()) -
    std::count(raster.triangles.begin(), raster.triangles.end(), -1);
  return raster;
}

} // namespace hachure
