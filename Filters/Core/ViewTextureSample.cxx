// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewTextureSample.h"

#include "Kernels.h"
#include "Parallel.h"
#include "SrgbColor.h"
#include "TextureView.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{
constexpr double farAway = 1e-9; // w of points at infinity, of their length

// As a texture that the window decodes: colours linear, alpha as it is.
glm::vec4 texel(const glm::u8vec4& color)
{
  constexpr float whole = 255.0f;
  const glm::vec3 linear = linearColorOf(color);
  return { linear, static_cast<float>(color.a) / whole };
}

// Of a node's square of directions, between four of them.
glm::vec4 dependentAt(const ViewTextureColors& colors, std::size_t node, const glm::vec2& square)
{
  if (colors.dependent.empty())
  {
    return glm::vec4(0.0f);
  }
  const int side = colors.hemisphere;
  const glm::vec2 place = glm::clamp(static_cast<float>(side) * square - 0.5f, glm::vec2(0.0f),
    glm::vec2(static_cast<float>(side - 1)));
  const int column = std::min(static_cast<int>(place.x), side - 2);
  const int row = std::min(static_cast<int>(place.y), side - 2);
  const glm::vec2 part = place - glm::vec2(column, row);
  const glm::u8vec4* const from = colors.dependent.data() +
    node * static_cast<std::size_t>(side * side) + static_cast<std::size_t>(row * side + column);
  const glm::vec4 low = glm::mix(texel(from[0]), texel(from[1]), part.x);
  const glm::vec4 high = glm::mix(texel(from[side]), texel(from[side + 1]), part.x);
  return glm::mix(low, high, part.y);
}

// What nobody knows is grey.
glm::vec4 independentAt(const ViewTextureColors& colors, std::size_t node)
{
  return colors.independent.empty() ? glm::vec4(0.0f)
                                    : glm::vec4(glm::vec3(texel(colors.independent[node])), 1.0f);
}

// What is stored for a place and a direction.
struct Stored
{
  glm::vec4 dependent{ 0.0f }; // times its share, which is a
  glm::vec4 independent{ 0.0f };
};

Stored storedAt(const SurfaceCells& cells, const ViewTextureColors& colors, int level,
  const ChartPlace& place, const glm::vec2& square)
{
  const auto chart = static_cast<std::size_t>(place.chart);
  const auto first = static_cast<std::size_t>(firstNodeOf(cells, chart, level));
  const glsl::NodeMix nodes =
    glsl::nodesAt(place.place, 1 << subdivisionsOf(cells.charts[chart], level));
  const int numbers[] = { nodes.cell, nodes.corner, nodes.next };
  Stored stored;
  for (int i = 0; i < 3; ++i)
  {
    const std::size_t node = first + static_cast<std::size_t>(numbers[i]);
    stored.dependent += nodes.weights[i] * dependentAt(colors, node, square);
    stored.independent += nodes.weights[i] * independentAt(colors, node);
  }
  return stored;
}

glm::vec4 numbersOf(const glm::quat& turn)
{
  return { turn.x, turn.y, turn.z, turn.w };
}

// The camera about an origin near the surface, in single precision as shaders have it.
struct Viewer
{
  glm::dvec3 origin;
  glm::vec4 rowX, rowY, rowW; // to pixels times w, and to w
  glm::vec4 eye;

  Viewer(const ViewTextureCamera& camera, const glm::dvec3& about)
    : origin(about)
  {
    const glm::dmat4 toClip = glm::translate(camera.modelToClip, about);
    this->rowX = glm::vec4(0.5 * camera.pictureSize.x * glm::row(toClip, 0));
    this->rowY = glm::vec4(0.5 * camera.pictureSize.y * glm::row(toClip, 1));
    this->rowW = glm::vec4(glm::row(toClip, 3));
    this->eye = glm::vec4(viewerOf(toClip));
  }
  glm::vec3 directionFrom(const glm::dvec3& point) const
  {
    return glm::vec3(this->eye) - this->eye.w * glm::vec3(point - this->origin);
  }
  // How much of the picture a unit of surface takes, in pixels.
  float areaAt(const glm::dvec3& point, const glm::vec3& normal) const
  {
    return glsl::pictureArea(
      glm::vec3(point - this->origin), normal, this->rowX, this->rowY, this->rowW);
  }
};

glm::dvec3 middleOf(const TriangleMesh& mesh)
{
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(std::numeric_limits<double>::lowest());
  for (const glm::ivec3& triangle : mesh.triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const glm::dvec3& point = mesh.points[static_cast<std::size_t>(triangle[corner])];
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
  }
  return mesh.triangles.empty() ? glm::dvec3(0.0) : 0.5 * (low + high);
}

NodePlace placeOfCorner(std::size_t triangle, int corner)
{
  return { static_cast<std::int32_t>(triangle),
    glm::vec2(corner == 1 ? 1.0f : 0.0f, corner == 2 ? 1.0f : 0.0f) };
}

glm::vec3 normalOf(const glm::quat& turn)
{
  return turn * glm::vec3(0.0f, 1.0f, 0.0f);
}

// Of every point the corner of a triangle that faces the camera most; -1 triangles where there is
// none.
std::vector<NodePlace> facingCorners(const TriangleMesh& mesh, const SurfaceCells& cells,
  const SurfaceFrames& frames, const Viewer& viewer)
{
  std::vector<NodePlace> found(mesh.points.size());
  std::vector<float> facings(mesh.points.size(), std::numeric_limits<float>::lowest());
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
  {
    for (int corner = 0; cells.chartOfTriangle[triangle] >= 0 && corner < 3; ++corner)
    {
      const auto point = static_cast<std::size_t>(mesh.triangles[triangle][corner]);
      const auto frame = static_cast<std::size_t>(frames.corners[triangle][corner]);
      const float facing =
        glm::dot(normalOf(frames.turns[frame]), viewer.directionFrom(mesh.points[point]));
      if (facing > facings[point])
      {
        facings[point] = facing;
        found[point] = placeOfCorner(triangle, corner);
      }
    }
  }
  return found;
}

void require(bool holds, const std::string& problem)
{
  if (!holds)
  {
    throw std::invalid_argument(problem);
  }
}

void checkFrames(const TriangleMesh& mesh, const SurfaceCells& cells, const SurfaceFrames& frames)
{
  require(frames.corners.size() == mesh.triangles.size(),
    "frames.corners: " + std::to_string(frames.corners.size()) + " for " +
      std::to_string(mesh.triangles.size()) + " triangles");
  require(
    frames.others.size() == frames.turns.size() && frames.facesDown.size() == cells.charts.size(),
    "frames.others, facesDown: " + std::to_string(frames.others.size()) + " and " +
      std::to_string(frames.facesDown.size()) + " for " + std::to_string(frames.turns.size()) +
      " frames and " + std::to_string(cells.charts.size()) + " charts");
  const auto count = static_cast<int>(frames.turns.size());
  for (std::size_t triangle = 0; triangle < frames.corners.size(); ++triangle)
  {
    const glm::ivec3& corners = frames.corners[triangle];
    const bool isThere = cells.chartOfTriangle[triangle] < 0 ||
      (std::min({ corners.x, corners.y, corners.z }) >= 0 &&
        std::max({ corners.x, corners.y, corners.z }) < count);
    require(isThere,
      "frames.corners: triangle " + std::to_string(triangle) + " has one that is not among " +
        std::to_string(count) + " frames");
  }
}

void checkColors(const SurfaceCells& cells, const ViewTextureColors& colors)
{
  const std::size_t nodes =
    cells.firstNode.empty() ? 0 : static_cast<std::size_t>(cells.firstNode.back());
  const std::string expected = " for " + std::to_string(nodes) + " nodes";
  require(colors.hemisphere >= 2,
    "colors.hemisphere is " + std::to_string(colors.hemisphere) + "; expected 4, 8 or 16");
  const auto side = static_cast<std::size_t>(colors.hemisphere);
  require(colors.independent.empty() || colors.independent.size() == nodes,
    "colors.independent: " + std::to_string(colors.independent.size()) + expected);
  require(colors.dependent.empty() || colors.dependent.size() == side * side * nodes,
    "colors.dependent: " + std::to_string(colors.dependent.size()) + expected);
}

void checkCamera(const ViewTextureCamera& camera)
{
  TextureView view;
  view.modelToClip = camera.modelToClip;
  view.width = view.height = 1;
  checkTextureView(view, "camera");
  for (int axis = 0; axis < 2; ++axis)
  {
    const double size = camera.pictureSize[axis];
    require(std::isfinite(size) && size > 0.0,
      "camera.pictureSize is " + std::to_string(size) + "; expected pixels, above 0");
  }
  require(camera.independentShare >= 0.0 && camera.independentShare <= 1.0,
    "camera.independentShare is " + std::to_string(camera.independentShare) + "; expected 0 to 1");
}
} // namespace

glm::dvec4 viewerOf(const glm::dmat4& modelToClip)
{
  // What all of its depths are drawn to one point of the picture is the eye.
  const glm::dvec4 eye = glm::inverse(modelToClip) * glm::dvec4(0.0, 0.0, -1.0, 0.0);
  const bool parallel = std::abs(eye.w) < farAway * glm::length(glm::dvec3(eye));
  return parallel ? glm::dvec4(glm::dvec3(eye), 0.0) : glm::dvec4(glm::dvec3(eye) / eye.w, 1.0);
}

ViewTexturePlace viewTexturePlace(
  const SurfaceCells& cells, const SurfaceFrames& frames, const NodePlace& place)
{
  const auto triangle = static_cast<std::size_t>(place.triangle);
  const std::int32_t chart = cells.chartOfTriangle[triangle];
  if (chart < 0)
  {
    return {};
  }
  const glm::vec3 weights(
    1.0f - place.weights.x - place.weights.y, place.weights.x, place.weights.y);
  const std::array<glm::vec2, 3>& places = cells.places[triangle];
  const glm::vec2 own = weights.x * places[0] + weights.y * places[1] + weights.z * places[2];
  const ChartPlace found = placeInside(cells, { chart, own });
  const glm::ivec3 corners = cornerFrames(frames, triangle, chart, found.chart);
  const auto turnAt = [&](int corner)
  { return numbersOf(frames.turns[static_cast<std::size_t>(corners[corner])]); };
  const glm::vec4 turn = glsl::mixedTurn(turnAt(0), turnAt(1), turnAt(2), weights);
  return { found, glm::quat(turn.w, turn.x, turn.y, turn.z) };
}

glm::vec4 viewTextureColorAt(const SurfaceCells& cells, const ViewTextureColors& colors,
  const ViewTexturePlace& place, const glm::vec3& direction, float level, float independentShare)
{
  if (place.place.chart < 0)
  {
    return glm::vec4(0.0f);
  }
  const glm::vec3 local = glm::normalize(glsl::turnedBack(numbersOf(place.turn), direction));
  const glm::vec2 square =
    colors.map == HemisphereMap::Disk ? glsl::hemisphereDisk(local) : glsl::hemisphereSquare(local);
  const float inside = glm::clamp(level, 0.0f, static_cast<float>(cells.finestLevel));
  const int coarse = static_cast<int>(inside);
  const Stored below = storedAt(cells, colors, coarse, place.place, square);
  const Stored above =
    storedAt(cells, colors, std::min(coarse + 1, cells.finestLevel), place.place, square);
  const float part = inside - static_cast<float>(coarse);
  const glm::vec4 dependent =
    (1.0f - independentShare) * glm::mix(below.dependent, above.dependent, part);
  const glm::vec4 independent = glm::mix(below.independent, above.independent, part);
  const float base = (1.0f - dependent.a) * independent.a;
  const float alpha = dependent.a + base;
  constexpr float leastAlpha = 1e-4f;
  return { (glm::vec3(dependent) + base * glm::vec3(independent)) / std::max(alpha, leastAlpha),
    alpha };
}

std::vector<glm::u8vec4> viewTexturePointColors(const TriangleMesh& mesh, const SurfaceCells& cells,
  const SurfaceFrames& frames, const ViewTextureColors& colors, const ViewTextureCamera& camera)
{
  checkTriangleMesh(mesh);
  checkSurfaceCells(mesh, cells);
  checkFrames(mesh, cells, frames);
  checkColors(cells, colors);
  checkCamera(camera);
  const Viewer viewer(camera, middleOf(mesh));
  const std::vector<NodePlace> places = facingCorners(mesh, cells, frames, viewer);
  std::vector<glm::u8vec4> found(mesh.points.size(), glm::u8vec4(0));
  parallelFor(static_cast<std::int64_t>(found.size()),
    [&](std::int64_t i)
    {
      const auto index = static_cast<std::size_t>(i);
      if (places[index].triangle < 0)
      {
        return;
      }
      const ViewTexturePlace place = viewTexturePlace(cells, frames, places[index]);
      const glm::dvec3& point = mesh.points[index];
      const float area =
        static_cast<float>(cells.cellArea) * viewer.areaAt(point, normalOf(place.turn));
      const glm::vec4 color = viewTextureColorAt(cells, colors, place, viewer.directionFrom(point),
        glsl::levelOfArea(area), static_cast<float>(camera.independentShare));
      found[index] = srgbOf(color);
    });
  return found;
}

} // namespace hachure
