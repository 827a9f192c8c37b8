// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Level of detail of a pattern that scales with the surface (Breslav et al. 2007, section 3.3):
// the scale is wrapped into [1, 2) and the half-size copy, uv * 2 about the same origin, takes
// over on the way. The picture at scale 2 is the picture at scale 1.

// Scale wrapped into [1, 2) by whole octaves, growing and shrinking alike. Not positive: 1.
float wrapScale(float s)
{
  if (!(s > 0.0f))
  {
    return 1.0f;
  }
  float wrapped = s * exp2(-floor(log2(s)));
  // log2 may round across a whole octave.
  if (wrapped >= 2.0f)
  {
    wrapped *= 0.5f;
  }
  if (wrapped < 1.0f)
  {
    wrapped *= 2.0f;
  }
  return clamp(wrapped, 1.0f, 1.9999999f);
}

// Weight of the half-size copy at wrapped scale s: 0 up to s0, 1 from s1 on.
float lodBlend(float s, float s0, float s1)
{
  if (s1 <= s0)
  {
    return s < s0 ? 0.0f : 1.0f;
  }
  return clamp((s - s0) / (s1 - s0), 0.0f, 1.0f);
}
