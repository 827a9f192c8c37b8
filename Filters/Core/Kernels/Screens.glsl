// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Closed-form screens: fields in [0, 1] with an exactly uniform distribution over one period. Ink
// goes where screen < tone. `position` is in periods, y up; a screen repeats at every whole
// number, where it is darkest: in the half-size copy about the origin all marks keep their places
// and new ones come in between.

const float screenPi = 3.14159265358979f;

// Distance to the nearest whole number, 0 to .5.
float distanceToInteger(float value)
{
  return abs(value - floor(value + 0.5f));
}

// Lines along x at whole y, growing to both sides.
float hatchScreen(vec2 position)
{
  return 2.0f * distanceToInteger(position.y);
}

// Area of the disc of this radius about the centre of a unit square that lies inside the square.
float discInSquare(float radius)
{
  float square = radius * radius;
  if (square <= 0.25f)
  {
    return screenPi * square;
  }
  if (square >= 0.5f)
  {
    return 1.0f;
  }
  float cap = square * acos(clamp(0.5f / radius, -1.0f, 1.0f)) - 0.5f * sqrt(square - 0.25f);
  return clamp(screenPi * square - 4.0f * cap, 0.0f, 1.0f);
}

// Round dots that touch at tone pi / 4 and close to full ink.
float dotScreen(vec2 position)
{
  float x = distanceToInteger(position.x);
  float y = distanceToInteger(position.y);
  return discInSquare(sqrt(x * x + y * y));
}

// Distribution function of min(a, b / (1 - delay) + delay), a and b independent and uniform: the
// share of a period with a value below `level`.
float delayedMinimumShare(float level, float delay)
{
  float rest = max(1.0f - delay, 1.0e-6f);
  float second = clamp((level - delay) / rest, 0.0f, 1.0f);
  return 1.0f - (1.0f - clamp(level, 0.0f, 1.0f)) * (1.0f - second);
}

// Two directions of lines: along x from tone 0 on, along y from tone `delay` (0 to 1) on.
float crossHatchScreen(vec2 position, float delay)
{
  float rest = max(1.0f - delay, 1.0e-6f);
  float first = hatchScreen(position);
  float second = delay + rest * hatchScreen(vec2(position.y, position.x));
  return delayedMinimumShare(min(first, second), delay);
}
