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

const float quarterTurn = 1.5707963267948966f;

// Weight of the half-size copy after a share x of a transition, 0 to 1, so that pictures change at
// an even pace. Two uncorrelated pictures are at right angles to each other, in the sense that the
// cosine is the correlation. Mixed by 1 - t and t the picture has turned by the angle
// a = atan(contrast t / (1 - t)), where contrast is the deviation of the second over that of the
// first. With a = x pi / 2: t = sin(a) / (sin(a) + contrast cos(a)).
float evenBlend(float x, float contrast)
{
  float a = quarterTurn * clamp(x, 0.0f, 1.0f);
  float rise = sin(a);
  return rise / (rise + contrast * max(cos(a), 0.0f));
}

// The share of a transition after which a weight is reached: inverse of evenBlend.
float evenShare(float t, float contrast)
{
  return atan(contrast * t, 1.0f - t) / quarterTurn;
}

// Weight of the half-size copy at wrapped scale s: 0 up to s0, 1 from s1 on. contrast: above 0, at
// an even pace of relative growth, x = log(s / s0) / log(s1 / s0), for octaves of this contrast; 0,
// the ramp (s - s0) / (s1 - s0) of Breslav et al. 2007, section 3.4.
float lodBlend(float s, float s0, float s1, float contrast)
{
  if (s <= s0 || s >= s1)
  {
    return s < s1 ? 0.0f : 1.0f;
  }
  return contrast > 0.0f ? evenBlend(log(s / s0) / log(s1 / s0), contrast) : (s - s0) / (s1 - s0);
}

// The wrapped scale of a weight t: inverse of lodBlend.
float lodScale(float t, float s0, float s1, float contrast)
{
  return contrast > 0.0f ? s0 * pow(s1 / s0, evenShare(t, contrast)) : mix(s0, s1, t);
}
