// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/TimedOctave.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace hachure;

namespace
{

constexpr double frame = 0.1; // a quarter of a transition

// A pattern that is drawn frame by frame.
struct Clip
{
  TimedOctaveOptions options;
  TimedOctave octave;

  DrawnOctave draw(double scale, double passed = frame)
  {
    this->octave = advanceOctave(this->octave, scale, passed, this->options);
    return drawnOctave(this->octave, scale);
  }
};

void expectDrawn(const DrawnOctave& drawn, double scale, double share)
{
  EXPECT_NEAR(drawn.scale, scale, 1e-12);
  EXPECT_NEAR(drawn.share, share, 1e-12);
}

} // namespace

TEST(TimedOctave, FirstFrameIsInNoTransition)
{
  for (int octave = -3; octave <= 3; ++octave)
  {
    const double whole = std::ldexp(1.0, octave);
    expectDrawn(Clip().draw(1.0 * whole), 1.0, 0.0);
    expectDrawn(Clip().draw(1.69 * whole), 1.69, 0.0);
    expectDrawn(Clip().draw(1.71 * whole), 1.71, 1.0);
  }
}

TEST(TimedOctave, TransitionTakesItsTimeWhateverTheScale)
{
  Clip clip;
  expectDrawn(clip.draw(1.6), 1.6, 0.0);
  expectDrawn(clip.draw(1.75), 1.75, 0.0); // starts
  expectDrawn(clip.draw(1.76), 1.76, 0.25);
  expectDrawn(clip.draw(1.75), 1.75, 0.5);
  expectDrawn(clip.draw(1.5), 1.5, 0.75);
  EXPECT_EQ(clip.octave.octave, 0);
  expectDrawn(clip.draw(1.5), 1.5, 1.0); // complete: the half-size copy alone
  EXPECT_EQ(clip.octave.octave, 1);
  EXPECT_EQ(clip.octave.direction, 0);
  expectDrawn(clip.draw(2.2), 1.1, 0.0);
}

TEST(TimedOctave, ShrinkingGoesTheSameWayBack)
{
  Clip clip;
  expectDrawn(clip.draw(1.1), 1.1, 0.0);
  expectDrawn(clip.draw(0.7), 1.4, 1.0);
  expectDrawn(clip.draw(0.64), 1.28, 1.0); // starts
  expectDrawn(clip.draw(0.63), 1.26, 0.75);
  expectDrawn(clip.draw(0.63), 1.26, 0.5);
  expectDrawn(clip.draw(0.63, 2.0 * frame), 1.26, 0.0);
  EXPECT_EQ(clip.octave.octave, -1);
  EXPECT_EQ(clip.octave.direction, 0);
}

TEST(TimedOctave, OctavesStayBetweenTheTwoScales)
{
  Clip clip;
  clip.draw(1.2);
  for (const double scale : { 1.31, 1.69, 1.0, 0.66, 1.5 })
  {
    EXPECT_EQ(clip.draw(scale).share, scale < 1.0 ? 1.0 : 0.0);
    EXPECT_EQ(clip.octave.octave, 0);
  }
  clip.draw(1.71);
  clip.draw(1.71, 5.0 * frame);
  for (const double scale : { 1.69, 1.31, 1.5 }) // only below the first does it go back
  {
    EXPECT_EQ(clip.draw(scale).share, 1.0);
    EXPECT_EQ(clip.octave.octave, 1);
  }
}

TEST(TimedOctave, TurnsWhereItIs)
{
  Clip clip;
  clip.draw(1.6);
  clip.draw(1.8);
  expectDrawn(clip.draw(1.8), 1.8, 0.25);
  expectDrawn(clip.draw(1.2), 1.2, 0.5); // what has passed still belongs to the way there
  expectDrawn(clip.draw(1.2), 1.2, 0.25);
  expectDrawn(clip.draw(1.75), 1.75, 0.0);
  EXPECT_EQ(clip.octave.octave, 0);
  EXPECT_EQ(clip.octave.direction, 1);
}

TEST(TimedOctave, EndsAtOnceWhereAnOctaveLeavesItsSizes)
{
  Clip up;
  up.draw(1.6);
  up.draw(1.9);
  expectDrawn(up.draw(2.1), 1.05, 0.0);
  EXPECT_EQ(up.octave.octave, 1);
  Clip down;
  down.draw(1.0);
  down.draw(0.6);
  expectDrawn(down.draw(0.49), 1.96, 1.0);
  EXPECT_EQ(down.octave.octave, -1);
  Clip far;
  far.draw(1.0);
  expectDrawn(far.draw(35.0), 35.0 / 32.0, 0.0);
  expectDrawn(far.draw(0.26), 1.04, 1.0);
}

TEST(TimedOctave, EndsAtOnceWhereTimeDoesNotGoOn)
{
  for (const double passed : { 0.0, -frame, std::numeric_limits<double>::quiet_NaN() })
  {
    Clip running;
    running.draw(1.6);
    running.draw(1.75);
    expectDrawn(running.draw(1.75, passed), 1.75, 1.0);
    EXPECT_EQ(running.octave.octave, 1);
    Clip starting;
    starting.draw(1.6);
    expectDrawn(starting.draw(1.75, passed), 1.75, 1.0);
    expectDrawn(starting.draw(1.2, passed), 1.2, 0.0);
  }
}

TEST(TimedOctave, LookingChangesNothing)
{
  Clip clip;
  clip.draw(1.6);
  clip.draw(1.75);
  clip.draw(1.75);
  expectDrawn(drawnOctave(clip.octave, 1.75), 1.75, 0.25);
  expectDrawn(drawnOctave(clip.octave, 2.5), 1.25, 0.0);
  expectDrawn(drawnOctave(clip.octave, 1.75), 1.75, 0.25);
}

TEST(TimedOctave, WrongArgumentsAreNamed)
{
  for (const double scale : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    expectDrawn(Clip().draw(scale), 1.0, 0.0);
  }
  TimedOctaveOptions options;
  options.duration = 0.0;
  EXPECT_THROW(advanceOctave({}, 1.0, 0.1, options), std::invalid_argument);
}
