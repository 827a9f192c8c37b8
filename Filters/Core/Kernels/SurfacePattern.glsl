// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Patterns that lie on the surface: which plane of the model they are projected from, and how much
// of them a pixel sees. All derivatives are analytic: the pixel's ray meets the tangent plane.

// Views more oblique than this cosine are treated as if they had it.
const float grazingCosine = 0.02f;

// Change of the point seen on the tangent plane, per unit of normalised device x and y.
struct SurfaceSlopes
{
  vec3 alongX;
  vec3 alongY;
};

float affine(vec4 row, vec3 point)
{
  return row.x * point.x + row.y * point.y + row.z * point.z + row.w;
}

// point, normal (unit): of the surface in model coordinates. clipX, clipY, clipW: rows of the
// matrix from model to clip coordinates.
SurfaceSlopes surfaceSlopes(vec3 point, vec3 normal, vec4 clipX, vec4 clipY, vec4 clipW)
{
  float w = affine(clipW, point);
  float safeW = abs(w) < 1.0e-20f ? 1.0e-20f : w;
  float x = affine(clipX, point) / safeW;
  float y = affine(clipY, point) / safeW;
  // Along the ray of (x, y) both of these planes are zero.
  vec3 a = vec3(clipX.x - x * clipW.x, clipX.y - x * clipW.y, clipX.z - x * clipW.z);
  vec3 b = vec3(clipY.x - y * clipW.x, clipY.y - y * clipW.y, clipY.z - y * clipW.z);
  vec3 ray = cross(a, b);
  float facing = dot(normal, ray);
  float least = max(grazingCosine * length(ray), 1.0e-30f);
  float limited = facing < 0.0f ? min(facing, -least) : max(facing, least);
  SurfaceSlopes slopes;
  slopes.alongX = cross(b, normal) * (w / limited);
  slopes.alongY = cross(normal, a) * (w / limited);
  return slopes;
}

// Weights of the projections along the three axes of the model; they sum to 1, and only near
// the diagonals more than one is above 0.
vec3 triplanarWeights(vec3 normal)
{
  vec3 part = abs(normal) / max(max(abs(normal.x), abs(normal.y)), max(abs(normal.z), 1.0e-6f));
  // The cross-fade begins where a projection is this much weaker than the strongest.
  vec3 weight = max((part - vec3(0.8f)) * 5.0f, vec3(0.0f));
  return weight / max(weight.x + weight.y + weight.z, 1.0e-6f);
}

// Footprint of a pixel that moves (dx, dy) through a pattern: geometric mean (x) and greater (y) of
// its two axes.
vec2 footprintAxes(vec2 dx, vec2 dy)
{
  float area = abs(dx.x * dy.y - dx.y * dy.x);
  float squares = dot(dx, dx) + dot(dy, dy);
  float rest = sqrt(max(squares * squares - 4.0f * area * area, 0.0f));
  float greater = sqrt(max(0.5f * (squares + rest), 0.0f));
  return vec2(max(sqrt(area), 1.0e-6f), max(greater, 1.0e-6f));
}

// Extent of the footprint across strokes whose field rises along `rise`; where no direction is
// known, the mean.
float footprintAcross(vec2 dx, vec2 dy, vec2 rise, float mean)
{
  float steepness = length(rise);
  if (steepness < 1.0e-4f)
  {
    return mean;
  }
  vec2 direction = rise / steepness;
  return max(length(vec2(dot(dx, direction), dot(dy, direction))), 1.0e-6f);
}
