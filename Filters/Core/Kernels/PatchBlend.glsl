// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Patches of a surface that overlap near their borders (Breslav et al. 2007, section 3.6): which
// patches a point belongs to and by what weights, and the distribution of their mixed screens.
// At most four patches, kept in the components of a vec4.

// Weights of a triangle's patches at a point of it, from those at its corners. corner: the first
// one; toSecond, toThird: how the weights of the second and third corner grow with the position.
// The sum of the result is 1.
vec4 patchWeights(vec3 point, vec3 corner, vec3 toSecond, vec3 toThird, vec4 atFirst, vec4 atSecond,
  vec4 atThird)
{
  float second = clamp(dot(toSecond, point - corner), 0.0f, 1.0f);
  float third = clamp(dot(toThird, point - corner), 0.0f, 1.0f - second);
  vec4 weights = max(
    (1.0f - second - third) * atFirst + second * atSecond + third * atThird, vec4(0.0f));
  return weights / max(weights.x + weights.y + weights.z + weights.w, 1.0e-6f);
}

// Largest of the weights that do not matter: less than a step of tone that anyone can see.
const float patchLeastWeight = 1.0f / 64.0f;

// Weights of which those that are too small are left out; their sum is 1.
vec4 relevantWeights(vec4 weights)
{
  vec4 kept = weights * step(vec4(patchLeastWeight), weights);
  return kept / max(kept.x + kept.y + kept.z + kept.w, 1.0e-6f);
}

// Lower half of the distribution function below.
float mixedShareBelow(float value, vec4 weights)
{
  // Sum over all subsets of the weights w: (-1)^|subset| (value - sum of subset)^n / (n! prod w).
  float scale = 1.0f;
  float count = 0.0f;
  for (int i = 0; i < 4; ++i)
  {
    count += weights[i] > 0.0f ? 1.0f : 0.0f;
    scale *= weights[i] > 0.0f ? weights[i] * count : 1.0f;
  }
  float total = 0.0f;
  for (int subset = 0; subset < 16; ++subset)
  {
    float rest = value;
    float sign = 1.0f;
    int bits = subset;
    for (int i = 0; i < 4; ++i)
    {
      bool taken = bits - 2 * (bits / 2) == 1;
      // Weights of zero must not be counted: a subset with one of them never contributes.
      rest = taken ? (weights[i] > 0.0f ? rest - weights[i] : -1.0f) : rest;
      sign = taken ? -sign : sign;
      bits /= 2;
    }
    total += rest > 0.0f ? sign * pow(rest, count) : 0.0f;
  }
  return total / max(scale, 1.0e-9f);
}

// Share of a mix of independent screens, each uniform in [0, 1], that lies below a value. With two
// screens it is a trapezoid's distribution. The sum of the weights is 1.
float mixedShare(float value, vec4 weights)
{
  float inside = clamp(value, 0.0f, 1.0f);
  float lower = mixedShareBelow(min(inside, 1.0f - inside), weights);
  return clamp(inside > 0.5f ? 1.0f - lower : lower, 0.0f, 1.0f);
}
