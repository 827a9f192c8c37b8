// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Patches of a surface that overlap near their borders (Breslav et al. 2007, section 3.6): which
// patches a point belongs to and by what weights, and the distribution of their mixed screens.
// At most four patches, kept in the components of a vec4.

// Where a point lies in a triangle: the weights of its second (x) and third corner (y), and how well
// it fits (z): the least of the three corners' weights, less the distance from the plane over the size
// of the triangle. That is not below 0 for a point of the triangle, and the larger, the farther
// inside. corner: the first one; toSecond, toThird: how the weights of the second and third corner grow
// with the position.
vec3 placeInTriangle(vec3 point, vec3 corner, vec3 toSecond, vec3 toThird)
{
  vec3 offset = point - corner;
  float second = dot(toSecond, offset);
  float third = dot(toThird, offset);
  // The duals of two edges span the reciprocal of their area.
  vec3 normal = cross(toSecond, toThird);
  float distance = abs(dot(normal, offset)) / sqrt(max(length(normal), 1.0e-30f));
  return vec3(second, third, min(min(second, third), 1.0f - second - third) - distance);
}

// Weights of a triangle's patches at a place in it, from those at its corners; the sum is 1.
vec4 patchWeights(vec3 place, vec4 atFirst, vec4 atSecond, vec4 atThird)
{
  float second = clamp(place.x, 0.0f, 1.0f);
  float third = clamp(place.y, 0.0f, 1.0f - second);
  vec4 weights =
    max((1.0f - second - third) * atFirst + second * atSecond + third * atThird, vec4(0.0f));
  return weights / max(weights.x + weights.y + weights.z + weights.w, 1.0e-6f);
}

// Weights up to this one do not matter: every patch that is drawn costs as much as one alone.
const float patchLeastWeight = 0.1f;

// Weights less what does not matter, so that none begins with a jump; their sum is 1.
vec4 relevantWeights(vec4 weights)
{
  vec4 kept = max(weights - patchLeastWeight, vec4(0.0f));
  return kept / max(kept.x + kept.y + kept.z + kept.w, 1.0e-6f);
}

// Share of a mix of two independent screens, both uniform in [0, 1], that lies below a value:
// (1 - part) of the first, part of the second, 0 to 1. It is the distribution function of a
// trapezoid; the mix becomes uniform by it, and can be mixed with the next screen.
float mixedShare(float value, float part)
{
  float inside = clamp(value, 0.0f, 1.0f);
  float lower = min(inside, 1.0f - inside);
  float lesser = min(part, 1.0f - part);
  float greater = max(1.0f - lesser, 0.5f);
  float share = lower < lesser ? lower * lower / max(2.0f * lesser * greater, 1.0e-9f)
                               : (lower - 0.5f * lesser) / greater;
  return inside > 0.5f ? 1.0f - share : share;
}

// A screen made uniform (x), and its change across a pixel (y).
//
// Mixes another one into it. The directions in which they change are independent.
vec2 mixScreens(vec2 screen, vec2 other, float part)
{
  float mixed = mix(screen.x, other.x, part);
  float spread = 0.5f * length(vec2((1.0f - part) * screen.y, part * other.y));
  float width = mixedShare(mixed + spread, part) - mixedShare(mixed - spread, part);
  return vec2(mixedShare(mixed, part), width);
}
