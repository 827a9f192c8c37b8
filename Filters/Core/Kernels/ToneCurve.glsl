// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a layer makes of the tone of its source.

// First component of a remap; the others are the number of levels, or where a smooth step begins
// and ends.
const float remapSteps = 1.0f;
const float remapSmoothStep = 2.0f;

// One of `levels` flat tones, 2 or more, from 0 to 1; each takes an equal share of the tones.
float toonSteps(float tone, float levels)
{
  float last = max(levels, 2.0f) - 1.0f;
  return min(floor(max(tone, 0.0f) * (last + 1.0f)), last) / last;
}

// 0 at `low`, 1 at `high`, level at both; falls where low is the larger one, and steps where they
// are equal.
float smoothRemap(float tone, float low, float high)
{
  float extent = high - low;
  float along = tone < low ? 0.0f : 1.0f;
  if (abs(extent) > 1.0e-6f)
  {
    along = clamp((tone - low) / extent, 0.0f, 1.0f);
  }
  return along * along * (3.0f - 2.0f * along);
}

// invert: 1 exchanges light and dark.
float tonePower(float tone, float gamma, float invert)
{
  return pow(max(mix(tone, 1.0f - tone, invert), 0.0f), gamma);
}

float toneCurve(float tone, float gamma, float invert, vec3 remap)
{
  float curved = tonePower(tone, gamma, invert);
  if (remap.x == remapSteps)
  {
    return toonSteps(curved, remap.y);
  }
  if (remap.x == remapSmoothStep)
  {
    return smoothRemap(curved, remap.y, remap.z);
  }
  return curved;
}
