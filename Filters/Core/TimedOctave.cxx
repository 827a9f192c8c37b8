// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TimedOctave.h"

#include "TileChecks.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace hachure
{
namespace
{

void finish(TimedOctave& octave, bool up)
{
  octave.octave += up ? 1 : 0;
  octave.share = 0.0;
  octave.direction = 0;
}

// A scale that is no number, or none at all, is drawn as 1, as wrapScale has it.
double usable(double scale)
{
  return scale > 0.0 && std::isfinite(scale) ? scale : 1.0;
}

double sizeIn(const TimedOctave& octave, double scale)
{
  return std::ldexp(usable(scale), -octave.octave);
}

// Ends what runs, and moves on by whole octaves, where the size lies beyond what can be drawn.
void keepInReach(TimedOctave& octave, double scale)
{
  const double size = sizeIn(octave, scale);
  if (octave.direction != 0 && (size < 1.0 || size >= 2.0))
  {
    finish(octave, size >= 2.0);
  }
  const double rest = sizeIn(octave, scale);
  if (rest < 0.5 || rest >= 2.0)
  {
    const int octaves = static_cast<int>(std::floor(std::log2(rest)));
    octave.octave += rest < 0.5 ? octaves + 1 : octaves;
  }
}

// Starts a transition, or turns the one that runs.
void aim(TimedOctave& octave, double scale, const TimedOctaveOptions& options)
{
  const double size = sizeIn(octave, scale);
  if (octave.direction == 0 && size < 0.5 * options.lodStart)
  {
    --octave.octave;
    octave.share = 1.0;
    octave.direction = -1;
  }
  else if (octave.direction <= 0 && size >= options.lodEnd)
  {
    octave.direction = 1;
  }
  else if (octave.direction > 0 && size < options.lodStart)
  {
    octave.direction = -1;
  }
}

} // namespace

TimedOctave advanceOctave(
  TimedOctave octave, double scale, double passed, const TimedOctaveOptions& options)
{
  if (!(options.duration > 0.0))
  {
    check::fail("advanceOctave", "duration",
      std::to_string(options.duration) + ", expected a positive number");
  }
  const bool starts = !octave.known;
  if (starts)
  {
    octave = TimedOctave();
    octave.known = true;
    octave.octave = static_cast<int>(std::floor(std::log2(usable(scale))));
  }
  // The time belongs to the transition that ran while it passed.
  if (octave.direction != 0)
  {
    const double part = passed > 0.0 ? passed / options.duration : 1.0;
    octave.share = std::clamp(octave.share + octave.direction * part, 0.0, 1.0);
    if (octave.share <= 0.0 || octave.share >= 1.0)
    {
      finish(octave, octave.direction > 0);
    }
  }
  keepInReach(octave, scale);
  aim(octave, scale, options);
  if (octave.direction != 0 && (starts || !(passed > 0.0)))
  {
    finish(octave, octave.direction > 0);
  }
  return octave;
}

DrawnOctave drawnOctave(const TimedOctave& octave, double scale)
{
  TimedOctave drawn = octave;
  keepInReach(drawn, scale);
  const double size = sizeIn(drawn, scale);
  if (size < 1.0)
  {
    return { 2.0 * size, 1.0 };
  }
  return { size, drawn.share };
}

} // namespace hachure
