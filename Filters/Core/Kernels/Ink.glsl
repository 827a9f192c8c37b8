// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// From a screen and a threshold to the share of a pixel that is inked.

// Threshold that makes mean ink equal the tone for a screen of constant slope (a ruled hatch)
// drawn with inkCoverage. w is the change of the screen across one pixel, 0 to 1.
float exactThreshold(float tone, float w)
{
  float width = clamp(w, 0.0f, 1.0f);
  float ink = clamp(tone, 0.0f, 1.0f);
  if (ink < 0.5f * width)
  {
    return sqrt(2.0f * width * ink) - 0.5f * width;
  }
  if (ink > 1.0f - 0.5f * width)
  {
    return 1.0f + 0.5f * width - sqrt(2.0f * width * (1.0f - ink));
  }
  return ink;
}

// Analytic anti-aliasing: ink share of a pixel at whose centre the screen has this value and
// across which it changes by w.
float inkCoverage(float screen, float threshold, float w)
{
  return clamp((threshold - screen) / max(w, 1.0e-6f) + 0.5f, 0.0f, 1.0f);
}

// Values of a screen, lowest and highest, that a pixel averages at whose centre it has this value and
// across which it changes by w, above 0.
vec2 screenInterval(float screen, float w)
{
  return vec2(max(screen - 0.5f * w, 0.0f), min(screen + 0.5f * w, 1.0f));
}
