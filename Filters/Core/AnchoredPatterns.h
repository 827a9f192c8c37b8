// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_AnchoredPatterns_h
#define hachure_AnchoredPatterns_h

#include "PatternTracker.h"

#include <functional>
#include <vector>

// Patterns that do not remember the frames drawn before: the same frame gives the same transforms
// in any order of drawing.
namespace hachure
{

// A moment of a recorded path.
struct TrackedScene
{
  TrackedSamples samples; // valid until the path is asked again
  ViewProjection view;
};
using ScenePath = std::function<TrackedScene(double time)>;

// Patterns as a pure function of the frame (mode Anchored without a path). Per patch: the origin is
// the image of the patch's centroid; the size 1 pattern unit = (pixels per model unit at the
// centroid times the diameter of the patch) / 512 pixels; the direction is that of the patch's
// principal axis in the image, or of the second axis, turned by -90 degrees, where the first points
// at the camera. Continuous in the camera except there. A patch behind the camera gets the unit
// frame.
// The locks of the options fix direction and size; its other members do not matter.
std::vector<PatternFrame> anchoredFrames(const TrackedSamples& samples, const ViewProjection& view,
  const TrackerOptions& options = TrackerOptions());

// Patterns as a pure function of a path (mode Anchored with a path): tracked in fixed steps from
// the last key at or before `time` (`time` itself when there is none), without visibility. Throws
// std::invalid_argument on a step of 0 or less, times that are not finite, and no path.
std::vector<PatternFrame> replayFrames(const ScenePath& path, Span<const double> keyTimes,
  double time, double step, const TrackerOptions& options = TrackerOptions());

} // namespace hachure

#endif
