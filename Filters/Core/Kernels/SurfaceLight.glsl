// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Light on a surface as VTK computes it, in any coordinates with the eye at the origin.

// Direction in which a light's rays travel at a point (xyz), and their strength there (w).
// direction: of the light's axis; w: cosine of half the angle of its cone, -1 without one.
// position: w: how fast the light fades away from its axis. attenuation: constant, linear and
// quadratic in the distance. positional: 0 for a light infinitely far away.
vec4 lightRays(vec3 point, vec4 direction, vec4 position, vec3 attenuation, float positional)
{
  vec3 axis = vec3(direction.x, direction.y, direction.z);
  vec3 path = point - vec3(position.x, position.y, position.z);
  float distance = length(path);
  vec3 ray = path / max(distance, 1.0e-20f);
  float weakening = attenuation.x + (attenuation.y + attenuation.z * distance) * distance;
  float strength = 1.0f / max(weakening, 1.0e-20f);
  float along = dot(ray, axis);
  if (direction.w >= 0.0f)
  {
    strength *= along >= direction.w ? pow(max(along, 1.0e-6f), position.w) : 0.0f;
  }
  return positional > 0.0f ? vec4(ray, strength) : vec4(axis, 1.0f);
}

// Lambert's cosine.
float diffuseShare(vec3 normal, vec4 rays)
{
  return max(0.0f, -rays.w * (normal.x * rays.x + normal.y * rays.y + normal.z * rays.z));
}

// Phong's mirrored light, seen from the origin.
float highlightShare(vec3 normal, vec4 rays, vec3 point, float power)
{
  vec3 ray = vec3(rays.x, rays.y, rays.z);
  vec3 toEye = -point / max(length(point), 1.0e-20f);
  float mirrored = max(dot(reflect(ray, normal), toEye), 1.0e-6f);
  return dot(normal, ray) < 0.0f ? rays.w * pow(mirrored, power) : 0.0f;
}
