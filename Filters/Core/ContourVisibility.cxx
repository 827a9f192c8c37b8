// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourVisibility.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hachure
{
namespace
{

constexpr double stepLength = 0.5; // pixels
constexpr double samePlace = 1e-3; // pixels
// The centre of the pixel so far from a straight edge is on the other side of it.
constexpr double shortestReach = 1.0;
// Coarse meshes: the line lies within the outline of its own triangles. Farther out, others may be.
constexpr double longestReach = 8.0;
// What is nearer by less than so many pixels, as a length in space, hides nothing.
constexpr double slackInPixels = 0.25;
// Rounding of a depth buffer with 24 bits.
constexpr double depthRounding = 1e-6;
// Faces that are steeper, in pixels of depth per pixel, are seen edge-on.
constexpr double largestSteepness = 10.0;

// The part of a piece, from 0 to 1, on the inner side of the six clipping planes.
bool clipPiece(const glm::dvec4& from, const glm::dvec4& to, double& begin, double& end)
{
  begin = 0.0;
  end = 1.0;
  for (int plane = 0; plane < 6; ++plane)
  {
    const double sign = plane % 2 == 0 ? 1.0 : -1.0;
    const double a = from.w + sign * from[plane / 2];
    const double b = to.w + sign * to[plane / 2];
    if (a < 0.0 && b < 0.0)
    {
      return false;
    }
    if (a < 0.0)
    {
      begin = std::max(begin, a / (a - b));
    }
    else if (b < 0.0)
    {
      end = std::min(end, a / (a - b));
    }
  }
  return begin < end;
}

} // namespace

ContourVisibility::ContourVisibility(const ViewProjection& view, const ContourDepth& depthImage)
  : viewToClip(view.viewToClip)
  , planeToClip(glm::transpose(glm::inverse(view.viewToClip)))
  , size(view.viewportSize)
  , depth(depthImage)
{
}

glm::dvec3 ContourVisibility::toWindow(const glm::dvec4& clip) const
{
  const glm::dvec3 normalized = glm::dvec3(clip) / clip.w;
  return (0.5 * normalized + 0.5) * glm::dvec3(this->size, 1.0);
}

// Not 0, whose direction in the picture is that of a small move in space.
glm::dvec2 ContourVisibility::windowDirection(
  const glm::dvec3& place, const glm::dvec3& direction) const
{
  const glm::dvec4 clip = this->viewToClip * glm::dvec4(place, 1.0);
  const glm::dvec4 change = this->viewToClip * glm::dvec4(direction, 0.0);
  const glm::dvec2 moved = (glm::dvec2(change) * clip.w - glm::dvec2(clip) * change.w) * this->size;
  const double length = glm::length(moved);
  return length > 0.0 ? moved / length : glm::dvec2(0.0);
}

double ContourVisibility::steepnessOf(const ContourSegment& segment, double depthPerPixel) const
{
  double steepness = 0.0;
  for (const glm::dvec3& normal : segment.planeNormals)
  {
    const glm::dvec4 plane =
      this->planeToClip * glm::dvec4(normal, -glm::dot(normal, segment.ends[0]));
    const double slope = glm::length(glm::dvec2(plane) / this->size);
    const double most = largestSteepness * depthPerPixel;
    steepness =
      std::max(steepness, slope < most * std::abs(plane.z) ? slope / std::abs(plane.z) : most);
  }
  return segment.planeNormals[0] == glm::dvec3(0.0) ? 0.0 : steepness;
}

ContourVisibility::Beside ContourVisibility::besideOf(
  const ContourSegment& segment, const glm::dvec3& place, const glm::dvec2& alongLine) const
{
  const glm::dvec4 clip = this->viewToClip * glm::dvec4(place, 1.0);
  // The size of a pixel there, and how much farther a place is by that.
  const double unit = 2.0 * clip.w / (std::abs(this->viewToClip[1][1]) * this->size.y);
  const glm::dvec4 behind = this->viewToClip * glm::dvec4(place.x, place.y, place.z - unit, 1.0);
  const double depthPerPixel = std::abs(0.5 * (behind.z / behind.w - clip.z / clip.w));
  Beside beside;
  beside.bothSides = segment.side == ContourSide::Both;
  beside.direction = this->windowDirection(place, segment.away);
  if (segment.side != ContourSide::Along)
  {
    const glm::dvec2 across(-alongLine.y, alongLine.x);
    beside.direction = glm::dot(across, beside.direction) < 0.0 ? -across : across;
  }
  beside.reach = std::min(shortestReach + 1.5 * segment.inset / unit, longestReach);
  beside.slack = depthRounding + slackInPixels * depthPerPixel;
  beside.steepness = this->steepnessOf(segment, depthPerPixel);
  return beside;
}

bool ContourVisibility::isSeen(
  const glm::dvec3& window, const Beside& beside, double side, bool& known) const
{
  for (double distance = stepLength; distance <= beside.reach; distance += stepLength)
  {
    const glm::dvec2 place = glm::floor(glm::dvec2(window) + side * distance * beside.direction);
    const glm::dvec2 pixel = place - glm::dvec2(this->depth.rectangle[0], this->depth.rectangle[1]);
    if (pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < this->depth.rectangle[2] &&
      pixel.y < this->depth.rectangle[3])
    {
      known = true;
      const double tolerance =
        beside.slack + beside.steepness * glm::distance(place + 0.5, glm::dvec2(window));
      const double shown = this->depth.values[static_cast<std::size_t>(pixel.y) *
          static_cast<std::size_t>(this->depth.rectangle[2]) +
        static_cast<std::size_t>(pixel.x)];
      if (shown >= window.z - tolerance)
      {
        return true;
      }
    }
  }
  return false;
}

// Where no depth is known, at the border of the image, nothing hides.
bool ContourVisibility::isSeen(const glm::dvec3& window, const Beside& beside) const
{
  bool known = false;
  return this->isSeen(window, beside, 1.0, known) ||
    (beside.bothSides && this->isSeen(window, beside, -1.0, known)) || !known;
}

void ContourVisibility::addSteps(
  const ContourSegment& segment, bool reversed, std::vector<ContourStep>& steps) const
{
  const glm::dvec3 first = segment.ends[reversed ? 1 : 0];
  const glm::dvec3 last = segment.ends[reversed ? 0 : 1];
  const glm::dvec4 firstClip = this->viewToClip * glm::dvec4(first, 1.0);
  const glm::dvec4 lastClip = this->viewToClip * glm::dvec4(last, 1.0);
  double begin = 0.0;
  double end = 1.0;
  if (!clipPiece(firstClip, lastClip, begin, end))
  {
    return;
  }
  const glm::dvec3 from = this->toWindow(glm::mix(firstClip, lastClip, begin));
  const glm::dvec3 to = this->toWindow(glm::mix(firstClip, lastClip, end));
  const double length = glm::distance(glm::dvec2(from), glm::dvec2(to));
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return;
  }
  const glm::dvec2 along = glm::dvec2(to - from) / length;
  const Beside beside = this->besideOf(segment, glm::mix(first, last, 0.5 * (begin + end)), along);
  const int count = std::max(1, static_cast<int>(std::ceil(length / stepLength)));
  const bool joined =
    !steps.empty() && begin == 0.0 && glm::distance(steps.back().to, glm::dvec2(from)) < samePlace;
  for (int i = 0; i < count; ++i)
  {
    ContourStep step;
    step.from = glm::dvec2(glm::mix(from, to, static_cast<double>(i) / count));
    step.to = glm::dvec2(glm::mix(from, to, static_cast<double>(i + 1) / count));
    step.startsPiece = i == 0;
    step.isJoined = i > 0 || joined;
    step.isSeen =
      this->depth.values.empty() || this->isSeen(glm::mix(from, to, (i + 0.5) / count), beside);
    steps.push_back(step);
  }
}

} // namespace hachure
