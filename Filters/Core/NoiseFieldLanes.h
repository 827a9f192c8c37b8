// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseFieldLanes_h
#define hachure_NoiseFieldLanes_h

#include "FloatLanes.h"
#include "Kernels.h"

// Functions of NoiseKernel.glsl for eight pixels at a time.
namespace hachure
{

// Something negative where ids differ from one.
HACHURE_INLINED FloatLanes equalLanes(const std::int32_t* ids, std::int32_t id)
{
  FloatLanes result{};
#if defined(__GNUC__)
  IntLanes bits;
  std::memcpy(&bits, ids, sizeof(bits));
  // Of a difference and its negative one is negative, unless both are 0.
  bits = bits ^ id;
  bits |= -bits;
  std::memcpy(&result, &bits, sizeof(result));
#else
  for (int lane = 0; lane < floatLanes; ++lane)
  {
    result[lane] = ids[lane] == id ? 0.0f : -1.0f;
  }
#endif
  return result;
}

// Values where the ids are equal to one, 0 elsewhere.
HACHURE_INLINED FloatLanes keepEqual(
  const std::int32_t* ids, std::int32_t id, const FloatLanes& values)
{
  return keepWhere(equalLanes(ids, id), values);
}

// A number that is not negative where something is there.
HACHURE_INLINED FloatLanes seenLanes(const FloatLanes& depth)
{
  return 0.99999994f - depth; // the largest number below 1
}

// How far a deviation of depth is on its way from once to twice the tolerance, 0 to 1; and the
// weight that leaves.
HACHURE_INLINED FloatLanes depthExcessLanes(
  const FloatLanes& deviation, const FloatLanes& tolerance)
{
  const FloatLanes beyond = magnitudeLanes(deviation) / tolerance - 1.0f;
  const FloatLanes rest = 1.0f - keepWhere(beyond, beyond);
  return 1.0f - keepWhere(rest, rest);
}

HACHURE_INLINED FloatLanes excessWeightLanes(const FloatLanes& excess)
{
  return 1.0f - excess * excess * (3.0f - 2.0f * excess);
}

HACHURE_INLINED FloatLanes depthWeightLanes(
  const FloatLanes& deviation, const FloatLanes& tolerance)
{
  return excessWeightLanes(depthExcessLanes(deviation, tolerance));
}

// Magnitude of the angle of (x, y) over pi: 0 to 1, within 1e-7.
HACHURE_INLINED FloatLanes turnShareLanes(const FloatLanes& x, const FloatLanes& y)
{
  const FloatLanes width = magnitudeLanes(x);
  const FloatLanes height = magnitudeLanes(y);
  const FloatLanes steep = height - width;
  const FloatLanes t =
    chooseLanes(steep, width, height) / (chooseLanes(steep, height, width) + 1e-30f);
  const FloatLanes square = t * t;
  // atan(t) / pi for t from 0 to 1 (Abramowitz & Stegun 1964, 4.4.49).
  FloatLanes sum = square * 0.0028662257f + -0.0161657367f;
  sum = sum * square + 0.0429096138f;
  sum = sum * square + -0.0752896400f;
  sum = sum * square + 0.1065626393f;
  sum = sum * square + -0.1420889944f;
  sum = sum * square + 0.1999355085f;
  sum = sum * square + -0.3333314528f;
  FloatLanes share = (t + (sum * square) * t) * 0.318309886f;
  share = chooseLanes(steep, 0.5f - share, share);
  return chooseLanes(x, share, 1.0f - share);
}

} // namespace hachure

#endif
