// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TimedOctave_h
#define hachure_TimedOctave_h

// Transitions between a pattern and its half-size copy that take a time, however fast the pattern
// grows. Octave n is the pattern at scale / 2^n of its size; n + 1 is the half-size copy of n. A
// transition begins when the size drawn leaves [lodStart / 2, lodEnd), so that a pattern which
// grows and shrinks a little changes once only.
namespace hachure
{

struct TimedOctaveOptions
{
  // As those of ToneTableOptions.
  double lodStart = 1.3;
  double lodEnd = 1.7;
  // Of a transition, in the unit of the times that pass; > 0.
  double duration = 0.4;
};

// What must be remembered between frames.
struct TimedOctave
{
  bool known = false; // an octave has been chosen
  int octave = 0;     // the larger of the two in a transition
  // How far the transition to octave + 1 has come, 0 to 1, and where it goes: 1 up, -1 back, 0 it
  // does not run.
  double share = 0.0;
  int direction = 0;
};

// The octave and its transition after `passed` of time, where the pattern's scale is now `scale`,
// > 0. A transition ends at once where no time passes although something moves, where time runs
// backwards, and where one of its two octaves leaves the sizes from 1/2 to 2. With passed = 0 and
// an unchanged scale call nothing: what is drawn stays.
TimedOctave advanceOctave(
  TimedOctave octave, double scale, double passed, const TimedOctaveOptions& options);

// How it is drawn: wrapped scale in [1, 2), and share of the transition to its half-size copy.
struct DrawnOctave
{
  double scale = 1.0;
  double share = 0.0;
};
DrawnOctave drawnOctave(const TimedOctave& octave, double scale);

} // namespace hachure

#endif
