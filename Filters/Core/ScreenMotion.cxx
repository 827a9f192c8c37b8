// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScreenMotion.h"

#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

// Surfaces nearer to each other than this part of their distance are one surface: a few roundings
// of coordinates in single precision.
constexpr double coincidence = 1e-6;
// A neighbouring triangle may bend towards the viewer by this slope, in pixels of depth per pixel,
// before it hides a point beside it.
constexpr double neighbourSlope = 2.0;

[[noreturn]] void refuse(const std::string& what)
{
  throw std::invalid_argument("screenMotion: " + what);
}

void checkLength(const std::string& name, std::size_t length, std::size_t expected)
{
  if (length != expected)
  {
    refuse(
      name + " has " + std::to_string(length) + " elements, expected " + std::to_string(expected));
  }
}

void checkState(const std::string& name, const MotionState& state, const MotionScene& scene)
{
  const std::size_t pixels =
    static_cast<std::size_t>(scene.size.x) * static_cast<std::size_t>(scene.size.y);
  checkLength(name + ".points", state.points.size(), scene.before.points.size());
  checkLength(name + ".seen", state.seen.size(), pixels);
  for (int column = 0; column < 4; ++column)
  {
    if (!std::isfinite(glm::dot(state.viewToClip[column], glm::dvec4(1.0))))
    {
      refuse(name + ".viewToClip is not finite");
    }
  }
  for (std::size_t i = 0; i < state.points.size(); ++i)
  {
    if (!std::isfinite(glm::dot(state.points[i], glm::dvec3(1.0))))
    {
      refuse(name + ".points[" + std::to_string(i) + "] is not finite");
    }
  }
  for (const std::int32_t triangle : state.seen)
  {
    if (triangle < nothingSeen || triangle >= static_cast<std::int64_t>(scene.triangles.size()))
    {
      refuse(name + ".seen names triangle " + std::to_string(triangle) + " of " +
        std::to_string(scene.triangles.size()));
    }
  }
}

void check(const MotionScene& scene)
{
  if (scene.size.x < 1 || scene.size.y < 1)
  {
    refuse("size is " + std::to_string(scene.size.x) + " x " + std::to_string(scene.size.y) +
      ", expected at least 1 x 1");
  }
  checkLength("labels", scene.labels.size(), scene.triangles.size());
  if (!scene.normals.empty())
  {
    checkLength("normals", scene.normals.size(), scene.before.points.size());
  }
  const int points = static_cast<int>(scene.before.points.size());
  for (std::size_t i = 0; i < scene.triangles.size(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const int point = scene.triangles[i][corner];
      if (point < 0 || point >= points)
      {
        refuse("triangles[" + std::to_string(i) + "] names point " + std::to_string(point) +
          " of " + std::to_string(points));
      }
    }
  }
  checkState("before", scene.before, scene);
  checkState("after", scene.after, scene);
}

// One triangle in one state, as it is seen.
class SeenTriangle
{
public:
  SeenTriangle(const MotionState& state, const glm::ivec3& triangle, const glm::ivec2& size)
    : projection(state.viewToClip)
    , halfSize(glm::dvec2(size) * 0.5)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->corners[i] = state.points[static_cast<std::size_t>(triangle[i])];
      const glm::dvec4 clip = this->clip(this->corners[i]);
      this->homogeneous[i] = glm::dvec3(clip.x, clip.y, clip.w);
    }
    this->orientation = glm::determinant(this->homogeneous);
  }

  glm::dvec4 clip(const glm::dvec3& point) const
  {
    return this->projection * glm::dvec4(point, 1.0);
  }

  glm::dvec2 pixel(const glm::dvec3& point) const
  {
    const glm::dvec4 position = this->clip(point);
    return (glm::dvec2(position) / position.w + 1.0) * this->halfSize;
  }

  glm::dvec3 point(const glm::dvec3& barycentrics) const { return this->corners * barycentrics; }

  // The point of the triangle's plane at a position in the image, perspective-correct: with corners
  // (x, y, w), the homogeneous position is their combination (Olano and Greer 1997). False where
  // the plane is seen edge-on or the position shows none of it.
  bool planeBarycentrics(const glm::dvec2& position, glm::dvec3& barycentrics) const
  {
    if (this->orientation == 0.0)
    {
      return false;
    }
    const glm::dvec2 device = position / this->halfSize - 1.0;
    barycentrics = glm::inverse(this->homogeneous) * glm::dvec3(device, 1.0);
    const double sum = barycentrics.x + barycentrics.y + barycentrics.z;
    barycentrics /= sum;
    return sum > 0.0 && std::isfinite(glm::dot(barycentrics, barycentrics));
  }

  // The same, or the nearest point of the border where the position is beside the triangle:
  // hardware covers pixels whose centre is outside by a small part of a pixel.
  glm::dvec3 barycentrics(const glm::dvec2& position) const
  {
    glm::dvec3 result;
    if (this->planeBarycentrics(position, result) && result.x >= 0.0 && result.y >= 0.0 &&
      result.z >= 0.0)
    {
      return result;
    }
    glm::dvec3 nearest(1.0 / 3.0);
    double distance = std::numeric_limits<double>::max();
    for (int i = 0; i < 3; ++i)
    {
      result = this->nearestOfEdge(i, (i + 1) % 3, position);
      const double found = glm::distance(this->pixel(this->point(result)), position);
      if (found < distance)
      {
        distance = found;
        nearest = result;
      }
    }
    return nearest;
  }

  glm::dvec3 normal() const
  {
    return glm::cross(this->corners[1] - this->corners[0], this->corners[2] - this->corners[0]);
  }

  // Scene units per pixel at a point.
  double pixelLength(const glm::dvec3& point) const
  {
    const double scale = std::abs(this->projection[1][1]) * this->halfSize.y;
    return scale > 0.0 ? this->clip(point).w / scale : 0.0;
  }

  bool sameSide(const SeenTriangle& other) const
  {
    return this->orientation * other.orientation > 0.0;
  }

private:
  // The point of an edge that is seen nearest to a position. An edge that passes behind the camera
  // is not a line in the image: there, its end in front.
  glm::dvec3 nearestOfEdge(int first, int second, const glm::dvec2& position) const
  {
    const double depths[] = { this->homogeneous[first].z, this->homogeneous[second].z };
    double part = depths[0] > 0.0 ? 0.0 : 1.0;
    if (depths[0] > 0.0 && depths[1] > 0.0)
    {
      const glm::dvec2 from = this->pixel(this->corners[first]);
      const glm::dvec2 along = this->pixel(this->corners[second]) - from;
      const double length = glm::dot(along, along);
      part = length > 0.0 ? glm::clamp(glm::dot(position - from, along) / length, 0.0, 1.0) : 0.0;
      // From a part of the edge's image to that of the edge.
      part = part * depths[0] / (part * depths[0] + (1.0 - part) * depths[1]);
    }
    glm::dvec3 result(0.0);
    result[first] = 1.0 - part;
    result[second] = part;
    return result;
  }

  glm::dmat4 projection;
  glm::dvec2 halfSize;
  glm::dmat3 corners{ 1.0 };
  glm::dmat3 homogeneous{ 1.0 }; // columns are corners
  double orientation;
};

bool isPerspective(const glm::dmat4& viewToClip)
{
  return viewToClip[2][3] != 0.0;
}

double facing(const MotionScene& scene, const glm::ivec3& corners, const SeenTriangle& triangle,
  const glm::dvec3& barycentrics)
{
  glm::dvec3 normal(0.0);
  if (!scene.normals.empty())
  {
    for (int i = 0; i < 3; ++i)
    {
      normal += barycentrics[i] * scene.normals[static_cast<std::size_t>(corners[i])];
    }
  }
  if (!(glm::length(normal) > 0.0))
  {
    normal = triangle.normal();
  }
  const glm::dvec3 view = isPerspective(scene.before.viewToClip) ? triangle.point(barycentrics)
                                                                 : glm::dvec3(0.0, 0.0, 1.0);
  const double lengths = glm::length(normal) * glm::length(view);
  return lengths > 0.0 ? std::min(1.0, std::abs(glm::dot(normal, view)) / lengths) : 0.0;
}

bool isInside(const glm::dvec4& clip)
{
  const glm::dvec3 size = glm::abs(glm::dvec3(clip));
  return clip.w > 0.0 && std::max({ size.x, size.y, size.z }) <= clip.w;
}

// Whether a point of a triangle is seen in the state after.
class PointAfter
{
public:
  PointAfter(const MotionScene& theScene, std::int32_t theIndex, const SeenTriangle& theTriangle,
    const glm::dvec3& thePoint)
    : scene(theScene)
    , index(theIndex)
    , triangle(theTriangle)
    , point(thePoint)
    , position(theTriangle.pixel(thePoint))
    , tolerance(coincidence * std::abs(thePoint.z))
  {
  }

  bool isSeen(bool turned) const
  {
    const glm::ivec2 pixel = glm::min(glm::ivec2(glm::floor(this->position)), this->scene.size - 1);
    if (this->isCovered(pixel))
    {
      return false;
    }
    const std::int32_t seen = this->seenAt(pixel);
    if (seen == this->index)
    {
      return true;
    }
    // Nothing there: past its own border by a part of a pixel.
    return seen == nothingSeen ? !turned : !this->isBehindNeighbour(this->other(seen), turned);
  }

private:
  std::int32_t seenAt(const glm::ivec2& pixel) const
  {
    const auto width = static_cast<std::size_t>(this->scene.size.x);
    return this->scene.after
      .seen[static_cast<std::size_t>(pixel.y) * width + static_cast<std::size_t>(pixel.x)];
  }

  SeenTriangle other(std::int32_t seen) const
  {
    return { this->scene.after, this->scene.triangles[static_cast<std::size_t>(seen)],
      this->scene.size };
  }

  // Whether a triangle seen at this pixel or beside it lies right over the point.
  bool isCovered(const glm::ivec2& pixel) const
  {
    std::int32_t tried = this->index;
    const glm::ivec2 low = glm::max(pixel - 1, glm::ivec2(0));
    const glm::ivec2 high = glm::min(pixel + 1, this->scene.size - 1);
    for (int y = low.y; y <= high.y; ++y)
    {
      for (int x = low.x; x <= high.x; ++x)
      {
        const std::int32_t seen = this->seenAt({ x, y });
        if (seen == nothingSeen || seen == this->index || seen == tried)
        {
          continue;
        }
        tried = seen;
        if (this->isUnder(this->other(seen)))
        {
          return true;
        }
      }
    }
    return false;
  }

  bool isUnder(const SeenTriangle& cover) const
  {
    glm::dvec3 barycentrics;
    return cover.planeBarycentrics(this->position, barycentrics) &&
      std::min({ barycentrics.x, barycentrics.y, barycentrics.z }) >= 0.0 &&
      -cover.point(barycentrics).z < -this->point.z - this->tolerance;
  }

  // The triangle at the point's pixel, which may lie beside the point by a part of a pixel: whether
  // it is nearer than the point's own triangle, extended to there.
  bool isBehindNeighbour(const SeenTriangle& neighbour, bool turned) const
  {
    const glm::dvec3 seen = neighbour.point(neighbour.barycentrics(this->position));
    const glm::dvec2 seenPosition = neighbour.pixel(seen);
    double depth = -this->point.z;
    double slack = this->tolerance;
    glm::dvec3 extended;
    if (!turned && this->triangle.planeBarycentrics(seenPosition, extended))
    {
      depth = std::min(depth, -this->triangle.point(extended).z);
      slack += glm::distance(seenPosition, this->position) * neighbourSlope *
        this->triangle.pixelLength(this->point);
    }
    return -seen.z < depth - slack;
  }

  const MotionScene& scene;
  std::int32_t index;
  const SeenTriangle& triangle;
  glm::dvec3 point;
  glm::dvec2 position;
  double tolerance;
};

PixelMotion pixelMotion(const MotionScene& scene, std::int32_t index, const glm::dvec2& position)
{
  const auto triangle = static_cast<std::size_t>(index);
  const glm::ivec3& corners = scene.triangles[triangle];
  const SeenTriangle before(scene.before, corners, scene.size);
  const SeenTriangle after(scene.after, corners, scene.size);
  const glm::dvec3 barycentrics = before.barycentrics(position);
  const glm::dvec3 from = before.point(barycentrics);
  const glm::dvec3 to = after.point(barycentrics);

  PixelMotion result;
  result.label = static_cast<float>(scene.labels[triangle]);
  result.distance = static_cast<float>(-from.z);
  result.facing = static_cast<float>(facing(scene, corners, before, barycentrics));
  if (after.clip(to).w > 0.0)
  {
    const glm::dvec2 motion = after.pixel(to) - before.pixel(from);
    result.u = static_cast<float>(motion.x);
    result.v = static_cast<float>(motion.y);
    const bool seen = isInside(after.clip(to)) &&
      PointAfter(scene, index, after, to).isSeen(!before.sameSide(after));
    result.visible = seen ? 1.0f : 0.0f;
  }
  return result;
}

} // namespace

std::vector<PixelMotion> screenMotion(const MotionScene& scene)
{
  check(scene);
  std::vector<PixelMotion> result(scene.before.seen.size());
  parallelForRanges(scene.size.y, 1,
    [&](std::int64_t begin, std::int64_t)
    {
      const auto row = static_cast<std::size_t>(begin) * static_cast<std::size_t>(scene.size.x);
      for (int x = 0; x < scene.size.x; ++x)
      {
        const std::size_t pixel = row + static_cast<std::size_t>(x);
        const std::int32_t seen = scene.before.seen[pixel];
        if (seen != nothingSeen && scene.labels[static_cast<std::size_t>(seen)] != 0)
        {
          result[pixel] = pixelMotion(scene, seen, glm::dvec2(x, begin) + 0.5);
        }
      }
    });
  return result;
}

} // namespace hachure
