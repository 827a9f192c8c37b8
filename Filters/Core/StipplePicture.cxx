// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StipplePicture.h"

#include "NoiseProjection.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

constexpr float leastNumber = 1e-30f;
constexpr float backTolerance = 0.15f; // over that of fronts

void require(bool isGood, const char* name, double value, const char* expected)
{
  if (!isGood || !std::isfinite(value))
  {
    std::string message(name);
    message.append(" is ").append(std::to_string(value)).append(", expected ").append(expected);
    throw std::invalid_argument(message);
  }
}

double largestOf(const glm::dvec4& row)
{
  const glm::dvec4 size = glm::abs(row);
  return std::max(std::max(size.x, size.y), std::max(size.z, size.w));
}

double at(const glm::dvec4& row, const glm::dvec3& point)
{
  return glm::dot(glm::dvec3(row), point) + row.w;
}

float at(const glm::vec4& row, const glm::vec3& point)
{
  return glm::dot(glm::vec3(row), point) + row.w;
}

void checkScene(const StippleScene& scene)
{
  checkNoiseView(scene.view);
  const std::array<int, 4>& part = scene.rectangle;
  require(part[2] >= 0, "scene.rectangle[2]", part[2], "0 or more");
  require(part[3] >= 0, "scene.rectangle[3]", part[3], "0 or more");
  require(scene.toneStride >= 1, "scene.toneStride", scene.toneStride, "1 or more");
  const std::size_t pixels = static_cast<std::size_t>(part[2]) * static_cast<std::size_t>(part[3]);
  require(scene.depth.empty() || scene.depth.size() == pixels, "scene.depth.size()",
    static_cast<double>(scene.depth.size()), "one for every pixel, or none");
  require(scene.tones.empty() ||
      scene.tones.size() + static_cast<std::size_t>(scene.toneStride) >
        pixels * static_cast<std::size_t>(scene.toneStride),
    "scene.tones.size()", static_cast<double>(scene.tones.size()), "one for every pixel, or none");
}

} // namespace

void checkStippleLook(const StippleLook& look)
{
  require(look.diameter > 0.0f, "look.diameter", look.diameter, "more than 0");
  require(look.growth > 0.0f, "look.growth", look.growth, "more than 0");
}

StipplePicture::StipplePicture(const StippleScene& someScene)
  : scene(someScene)
{
  checkScene(this->scene);
  const std::array<int, 4>& part = this->scene.rectangle;
  const glm::dmat4 rows = glm::transpose(this->scene.view.modelToClip);
  const glm::dvec2 half = 0.5 * this->scene.view.viewportSize;
  const glm::dvec2 middle = this->scene.view.viewportOrigin + half - glm::dvec2(part[0], part[1]);
  this->rowX = half.x * rows[0] + middle.x * rows[3];
  this->rowY = half.y * rows[1] + middle.y * rows[3];
  this->rowZ = rows[2];
  this->rowW = rows[3];
  const glm::dvec3 x(this->rowX), y(this->rowY), w(this->rowW);
  const double volume = glm::dot(x, glm::cross(y, w));
  const glm::dvec3 parallel = this->rowW.w * glm::cross(x, y) + this->rowX.w * glm::cross(y, w) +
    this->rowY.w * glm::cross(w, x);
  const bool isPerspective = glm::dot(w, w) > 0.0;
  const bool away = isPerspective ? volume > 0.0 : glm::dot(glm::dvec3(this->rowZ), parallel) > 0.0;
  this->towardViewer = away ? -1.0 : 1.0;
}

StipplePicture::Rows StipplePicture::rowsAt(const glm::dvec3& origin) const
{
  glm::dvec4 x(glm::dvec3(this->rowX), at(this->rowX, origin));
  glm::dvec4 y(glm::dvec3(this->rowY), at(this->rowY, origin));
  glm::dvec4 z(glm::dvec3(this->rowZ), at(this->rowZ, origin));
  glm::dvec4 w(glm::dvec3(this->rowW), at(this->rowW, origin));
  // Cubes of lengths of any unit would not fit into single precision; all that counts are
  // quotients.
  const double scale = 1.0 / std::max({ largestOf(x), largestOf(y), largestOf(w), 1e-300 });
  x *= scale;
  y *= scale;
  z *= scale;
  w *= scale;
  Rows rows;
  rows.x = glm::vec4(x);
  rows.y = glm::vec4(y);
  rows.z = glm::vec4(z);
  rows.w = glm::vec4(w);
  const glm::dvec3 yw = glm::cross(glm::dvec3(y), glm::dvec3(w));
  const glm::dvec3 wx = glm::cross(glm::dvec3(w), glm::dvec3(x));
  const glm::dvec3 xy = glm::cross(glm::dvec3(x), glm::dvec3(y));
  rows.toViewer = this->towardViewer * (w.w * xy + x.w * yw + y.w * wx);
  rows.turn = static_cast<float>(this->towardViewer * glm::dot(glm::dvec3(x), yw));
  return rows;
}

bool StipplePicture::locate(
  const Rows& rows, const glm::vec3& from, const glm::vec3& normal, Place& place)
{
  const glm::vec3 view = rows.toViewer + rows.turn * from;
  const float area = glm::dot(view, normal);
  const float w = at(rows.w, from);
  place.z = at(rows.z, from) / w;
  if (!(std::abs(place.z) <= 1.0f))
  {
    return false;
  }
  place.x = at(rows.x, from) / w;
  place.y = at(rows.y, from) / w;
  place.facing = std::abs(area) / (glm::length(view) + leastNumber);
  place.perPixel = w * w * w / std::abs(area);
  place.isFront = area > 0.0f;
  return true;
}

// n.p is constant on the plane.
void StipplePicture::setDepth(const Rows& rows, const glm::vec3& normal, Place& place) const
{
  const glm::vec3 axisX = glm::vec3(rows.x) - place.x * glm::vec3(rows.w);
  const glm::vec3 axisY = glm::vec3(rows.y) - place.y * glm::vec3(rows.w);
  const glm::vec3 axisZ = glm::vec3(rows.z) - place.z * glm::vec3(rows.w);
  const float volume = glm::dot(normal, glm::cross(axisX, axisY));
  const float inverse = volume != 0.0f ? 1.0f / volume : 0.0f;
  place.slope.x = 0.5f * inverse * glm::dot(normal, glm::cross(axisZ, axisY));
  place.slope.y = 0.5f * inverse * glm::dot(normal, glm::cross(axisX, axisZ));
  place.depth = 0.5f * place.z + 0.5f;
  // Where the back of a thin sheet is seen, its stipples are on what is seen, and where its front
  // is, those of the back are behind it.
  place.tolerance = (place.isFront ? 1.0f : backTolerance) *
    (this->scene.depthPerPixel + 0.5f * (std::abs(place.slope.x) + std::abs(place.slope.y)));
}

std::size_t StipplePicture::toneAt(float x, float y) const
{
  if (this->scene.tones.empty())
  {
    return 0;
  }
  const std::array<int, 4>& part = this->scene.rectangle;
  const int column = std::clamp(static_cast<int>(std::floor(x)), 0, part[2] - 1);
  const int row = std::clamp(static_cast<int>(std::floor(y)), 0, part[3] - 1);
  const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(part[2]) +
    static_cast<std::size_t>(column);
  return this->scene.tones[pixel * static_cast<std::size_t>(this->scene.toneStride)];
}

// Whether something is in front of the stipple's plane at a pixel.
bool StipplePicture::isHiddenAt(int column, int row, const Place& place) const
{
  const std::array<int, 4>& part = this->scene.rectangle;
  const int inColumn = std::clamp(column, 0, part[2] - 1);
  const int inRow = std::clamp(row, 0, part[3] - 1);
  const float seen =
    this->scene.depth[static_cast<std::size_t>(inRow) * static_cast<std::size_t>(part[2]) +
      static_cast<std::size_t>(inColumn)];
  const float own = place.depth + place.slope.x * (static_cast<float>(inColumn) + 0.5f - place.x) +
    place.slope.y * (static_cast<float>(inRow) + 0.5f - place.y);
  return own > seen + place.tolerance;
}

float StipplePicture::visibleShare(const Place& place) const
{
  if (this->scene.depth.empty())
  {
    return 1.0f;
  }
  const float left = std::floor(place.x - 0.5f), bottom = std::floor(place.y - 0.5f);
  const float right = place.x - 0.5f - left, above = place.y - 0.5f - bottom;
  const int column = static_cast<int>(left), row = static_cast<int>(bottom);
  float share = 1.0f;
  share -= this->isHiddenAt(column, row, place) ? (1.0f - right) * (1.0f - above) : 0.0f;
  share -= this->isHiddenAt(column + 1, row, place) ? right * (1.0f - above) : 0.0f;
  share -= this->isHiddenAt(column, row + 1, place) ? (1.0f - right) * above : 0.0f;
  share -= this->isHiddenAt(column + 1, row + 1, place) ? right * above : 0.0f;
  return share;
}

} // namespace hachure
