// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternMetrics.h"

#include "PatternMetricsImage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

void checkMotionSizes(const MotionView& motion, const std::string& name)
{
  const auto pixels =
    static_cast<std::size_t>(motion.width) * static_cast<std::size_t>(motion.height);
  const auto wrong = [&](const Span<const float>& values, bool optional)
  { return values.size() != pixels && !(optional && values.empty()); };
  if (wrong(motion.u, false) || wrong(motion.v, false) || wrong(motion.visible, false) ||
    wrong(motion.facing, true) || wrong(motion.distance, true))
  {
    throw std::invalid_argument(
      name + ": expected " + std::to_string(pixels) + " values of every component");
  }
}

// Values count where the surface is visible; elsewhere anything may stand.
void checkMotion(const MotionView& motion, const std::string& name)
{
  checkMotionSizes(motion, name);
  bool anyVisible = false;
  for (std::size_t i = 0; i < motion.u.size(); ++i)
  {
    const auto complain = [&](const char* what, float value, const char* expected)
    {
      throw std::invalid_argument(name + ": " + what + " " + std::to_string(value) + " at pixel " +
        pixelName(i, motion.width) + ", expected " + expected);
    };
    if (!std::isfinite(motion.visible[i]))
    {
      complain("visible", motion.visible[i], "0 or 1");
    }
    if (motion.visible[i] <= 0.5f)
    {
      continue;
    }
    anyVisible = true;
    if (!std::isfinite(motion.u[i]) || !std::isfinite(motion.v[i]))
    {
      complain("motion", std::isfinite(motion.u[i]) ? motion.v[i] : motion.u[i], "finite pixels");
    }
    if (!motion.facing.empty() && !std::isfinite(motion.facing[i]))
    {
      complain("facing", motion.facing[i], "a finite n.v");
    }
    if (!motion.distance.empty() && !(std::isfinite(motion.distance[i]) && motion.distance[i] > 0))
    {
      complain("distance", motion.distance[i], "a finite number above 0");
    }
  }
  if (!anyVisible)
  {
    throw std::invalid_argument(name + ": no pixel is visible, expected at least one");
  }
}

} // namespace

void checkClip(const PatternClip& clip)
{
  if (clip.frames.size() < 2)
  {
    throw std::invalid_argument(
      "frames: " + std::to_string(clip.frames.size()) + ", expected at least 2");
  }
  if (clip.motions.empty())
  {
    throw std::invalid_argument("motions: none, expected one for every step between frames");
  }
  if (clip.motions.size() + 1 != clip.frames.size() && clip.motions.size() != clip.frames.size())
  {
    throw std::invalid_argument("motions: " + std::to_string(clip.motions.size()) + " for " +
      std::to_string(clip.frames.size()) + " frames, expected one for every step between frames");
  }
  const ImageView& first = clip.frames.front();
  for (std::size_t t = 0; t < clip.frames.size(); ++t)
  {
    const std::string name = "frame " + std::to_string(t);
    checkSameSize(clip.frames[t].width, clip.frames[t].height, first, name);
    checkInk(clip.frames[t], name);
  }
  for (std::size_t t = 0; t < clip.motions.size(); ++t)
  {
    const std::string name = "motion " + std::to_string(t);
    checkSameSize(clip.motions[t].width, clip.motions[t].height, first, name);
    checkMotion(clip.motions[t], name);
  }
}

std::vector<std::uint8_t> usablePixels(const MotionView& motion, double minimumFacing)
{
  std::vector<std::uint8_t> usable(motion.visible.size());
  for (std::size_t i = 0; i < usable.size(); ++i)
  {
    const bool facing = motion.facing.empty() || motion.facing[i] >= minimumFacing;
    usable[i] = motion.visible[i] > 0.5f && facing ? 1 : 0;
  }
  return usable;
}

double medianOf(std::vector<double> values)
{
  values.erase(std::remove_if(values.begin(), values.end(), [](double x) { return std::isnan(x); }),
    values.end());
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

} // namespace hachure
