// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Mixing of colours in linear light. Colours are linear and in [0, 1] unless a name says
// otherwise; ink is coverage in [0, 1].

// Power law that VTK uses where it resolves samples.
const float displayGamma = 2.2f;

vec3 toLinear(vec3 display)
{
  return pow(max(display, vec3(0.0f)), vec3(displayGamma));
}

vec3 fromLinear(vec3 linear)
{
  return pow(max(linear, vec3(0.0f)), vec3(1.0f / displayGamma));
}

// Opaque ink covers what is below.
vec3 blendOver(vec3 below, vec3 inkColor, float ink)
{
  return mix(below, inkColor, ink);
}

// Process ink filters the light of what is below.
vec3 blendMultiply(vec3 below, vec3 inkColor, float ink)
{
  return below * mix(vec3(1.0f), inkColor, ink);
}

// Adds light, as chalk on dark paper.
vec3 blendScreen(vec3 below, vec3 inkColor, float ink)
{
  return vec3(1.0f) - (vec3(1.0f) - below) * (vec3(1.0f) - inkColor * ink);
}

// One channel of overlay: darkens the dark half, lightens the light half.
float overlayChannel(float below, float above)
{
  return below < 0.5f ? 2.0f * below * above : 1.0f - 2.0f * (1.0f - below) * (1.0f - above);
}

vec3 blendOverlay(vec3 below, vec3 inkColor, float ink)
{
  vec3 full = vec3(overlayChannel(below.x, inkColor.x), overlayChannel(below.y, inkColor.y),
    overlayChannel(below.z, inkColor.z));
  return mix(below, full, ink);
}
