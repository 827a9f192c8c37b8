// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_FloatLanes_h
#define hachure_FloatLanes_h

#include "Lanes.h"

#include <cmath>
#include <cstdint>
#include <cstring>

// Eight neighbouring pixels at a time, for functions with HACHURE_WIDE_CLONES. All is inlined into
// them: a function that stays outside would be compiled for the narrowest registers. Files that
// include this are compiled with -Wno-psabi, since no such value is ever passed to a function.
namespace hachure
{

#if defined(__GNUC__)
#define HACHURE_INLINED inline __attribute__((always_inline))
typedef float FloatLanes __attribute__((vector_size(floatLanes * sizeof(float))));
typedef std::int32_t IntLanes __attribute__((vector_size(floatLanes * sizeof(std::int32_t))));
#else
#define HACHURE_INLINED inline
template <class T>
struct PlainLanes
{
  T values[floatLanes];
  T& operator[](int lane) { return this->values[lane]; }
  T operator[](int lane) const { return this->values[lane]; }
};
typedef PlainLanes<float> FloatLanes;
typedef PlainLanes<std::int32_t> IntLanes;
#define HACHURE_LANE_OPERATOR(sign)                                                                \
  inline FloatLanes operator sign(const FloatLanes& a, const FloatLanes& b)                        \
  {                                                                                                \
    FloatLanes result;                                                                             \
    for (int lane = 0; lane < floatLanes; ++lane)                                                  \
    {                                                                                              \
      result[lane] = a[lane] sign b[lane];                                                         \
    }                                                                                              \
    return result;                                                                                 \
  }                                                                                                \
  inline FloatLanes operator sign(const FloatLanes& a, float b)                                    \
  {                                                                                                \
    return a sign FloatLanes{ { b, b, b, b, b, b, b, b } };                                        \
  }                                                                                                \
  inline FloatLanes operator sign(float a, const FloatLanes& b)                                    \
  {                                                                                                \
    return FloatLanes                                                                              \
    {                                                                                              \
      {                                                                                            \
        a, a, a, a, a, a, a, a                                                                     \
      }                                                                                            \
    }                                                                                              \
    sign b;                                                                                        \
  }
HACHURE_LANE_OPERATOR(+)
HACHURE_LANE_OPERATOR(-)
HACHURE_LANE_OPERATOR(*)
HACHURE_LANE_OPERATOR(/)
#undef HACHURE_LANE_OPERATOR
#endif

HACHURE_INLINED FloatLanes loadLanes(const float* values)
{
  FloatLanes result;
  std::memcpy(&result, values, sizeof(result));
  return result;
}

HACHURE_INLINED void storeLanes(const FloatLanes& from, float* values)
{
  std::memcpy(values, &from, sizeof(from));
}

HACHURE_INLINED void addLanes(const FloatLanes& from, float* values)
{
  storeLanes(loadLanes(values) + from, values);
}

// 0, 1, 2, ...
HACHURE_INLINED FloatLanes laneNumbers()
{
  constexpr float numbers[floatLanes] = { 0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f };
  return loadLanes(numbers);
}

// One value where `test` is not negative (nor -0) and another elsewhere, in operations that every
// processor has.
HACHURE_INLINED FloatLanes chooseLanes(
  const FloatLanes& test, const FloatLanes& values, const FloatLanes& otherwise)
{
  FloatLanes result;
#if defined(__GNUC__)
  IntLanes signs, bits, others;
  std::memcpy(&signs, &test, sizeof(signs));
  std::memcpy(&bits, &values, sizeof(bits));
  std::memcpy(&others, &otherwise, sizeof(others));
  signs = signs >> 31;
  bits = (bits & ~signs) | (others & signs);
  std::memcpy(&result, &bits, sizeof(result));
#else
  for (int lane = 0; lane < floatLanes; ++lane)
  {
    result[lane] = test[lane] >= 0.0f ? values[lane] : otherwise[lane];
  }
#endif
  return result;
}

HACHURE_INLINED FloatLanes keepWhere(const FloatLanes& test, const FloatLanes& values)
{
  return chooseLanes(test, values, FloatLanes{});
}

// Values where the bits of `mask` are set: all or none of each.
HACHURE_INLINED FloatLanes maskLanes(const std::int32_t* mask, const FloatLanes& values)
{
  FloatLanes result;
#if defined(__GNUC__)
  IntLanes bits, kept;
  std::memcpy(&bits, mask, sizeof(bits));
  std::memcpy(&kept, &values, sizeof(kept));
  kept &= bits;
  std::memcpy(&result, &kept, sizeof(result));
#else
  for (int lane = 0; lane < floatLanes; ++lane)
  {
    result[lane] = mask[lane] ? values[lane] : 0.0f;
  }
#endif
  return result;
}

HACHURE_INLINED FloatLanes fillLanes(float value)
{
#if defined(__GNUC__)
  return FloatLanes{ value, value, value, value, value, value, value, value };
#else
  return FloatLanes{} + value;
#endif
}

HACHURE_INLINED FloatLanes lowerLanes(const FloatLanes& a, const FloatLanes& b)
{
  return chooseLanes(b - a, a, b);
}

HACHURE_INLINED FloatLanes higherLanes(const FloatLanes& a, const FloatLanes& b)
{
  return chooseLanes(a - b, a, b);
}

// Between 0 and a number.
HACHURE_INLINED FloatLanes limitLanes(const FloatLanes& x, float most)
{
  return lowerLanes(keepWhere(x, x), fillLanes(most));
}

HACHURE_INLINED FloatLanes magnitudeLanes(const FloatLanes& x)
{
  FloatLanes result;
#if defined(__GNUC__)
  IntLanes bits;
  std::memcpy(&bits, &x, sizeof(bits));
  bits &= 0x7fffffff;
  std::memcpy(&result, &bits, sizeof(result));
#else
  for (int lane = 0; lane < floatLanes; ++lane)
  {
    result[lane] = std::abs(x[lane]);
  }
#endif
  return result;
}

// Something negative (or -0) where either is, something else elsewhere.
HACHURE_INLINED FloatLanes eitherNegative(const FloatLanes& a, const FloatLanes& b)
{
  FloatLanes result;
#if defined(__GNUC__)
  IntLanes first, second;
  std::memcpy(&first, &a, sizeof(first));
  std::memcpy(&second, &b, sizeof(second));
  first |= second;
  std::memcpy(&result, &first, sizeof(result));
#else
  for (int lane = 0; lane < floatLanes; ++lane)
  {
    result[lane] = a[lane] < 0.0f || b[lane] < 0.0f ? -1.0f : 0.0f;
  }
#endif
  return result;
}

HACHURE_INLINED bool anyNegative(const FloatLanes& x)
{
#if defined(__GNUC__)
  std::int64_t words[floatLanes / 2];
  std::memcpy(words, &x, sizeof(x));
  const std::int64_t all = (words[0] | words[1]) | (words[2] | words[3]);
  return (all & std::int64_t(0x8000000080000000ull)) != 0;
#else
  bool result = false;
  for (int lane = 0; lane < floatLanes; ++lane)
  {
    result = result || x[lane] < 0.0f;
  }
  return result;
#endif
}

HACHURE_INLINED FloatLanes rootLanes(const FloatLanes& x)
{
  FloatLanes result{};
  for (int lane = 0; lane < floatLanes; ++lane)
  {
    result[lane] = std::sqrt(x[lane]);
  }
  return result;
}

// Values of 0 or more without what is behind the point.
HACHURE_INLINED IntLanes wholeLanes(const FloatLanes& values)
{
#if defined(__GNUC__)
  return __builtin_convertvector(values, IntLanes);
#else
  IntLanes result;
  for (int lane = 0; lane < floatLanes; ++lane)
  {
    result[lane] = static_cast<std::int32_t>(values[lane]);
  }
  return result;
#endif
}

HACHURE_INLINED FloatLanes floatsOf(const IntLanes& values)
{
#if defined(__GNUC__)
  return __builtin_convertvector(values, FloatLanes);
#else
  FloatLanes result;
  for (int lane = 0; lane < floatLanes; ++lane)
  {
    result[lane] = static_cast<float>(values[lane]);
  }
  return result;
#endif
}

// exp(-x) for x from 0 to 3: within 5e-7 of it, relatively. By a polynomial of exp(-x/4).
HACHURE_INLINED FloatLanes decayLanes(const FloatLanes& x)
{
  FloatLanes sum = x * -5.6213269925e-06f + 1.54812207550e-04f;
  sum = sum * x + -2.59218544965e-03f;
  sum = sum * x + 3.12417134151e-02f;
  sum = sum * x + -2.49997886092e-01f;
  sum = sum * x + 9.99999912057e-01f;
  const FloatLanes square = sum * sum;
  return square * square;
}

// Cosine and sine of so many turns, up to 4 million: within 3e-7. By those of half the angle, which
// is at most a quarter of a turn.
HACHURE_INLINED void turnLanes(const FloatLanes& turns, FloatLanes& cosine, FloatLanes& sine)
{
  constexpr float roundsToWhole = 12582912.0f; // 1.5 * 2^23
  const FloatLanes rest = turns - ((turns + roundsToWhole) - roundsToWhole);
  const FloatLanes square = rest * rest;
  FloatLanes s = square * 0.0776559122765f + -0.598290411283f;
  s = s * square + 2.55007738653f;
  s = s * square + -5.16771007667f;
  s = s * square + 3.14159264008f;
  s = s * rest;
  FloatLanes c = square * 0.219682423577f + -1.33187297279f;
  c = c * square + 4.05841079076f;
  c = c * square + -4.93479280249f;
  c = c * square + 0.999999953028f;
  const FloatLanes twice = s + s;
  cosine = 1.0f - twice * s;
  sine = twice * c;
}

// Binary logarithm of positive numbers, within 2e-7; of what is too large for one at least 127.
HACHURE_INLINED FloatLanes logarithmLanes(const FloatLanes& x)
{
#if defined(__GNUC__)
  IntLanes bits;
  std::memcpy(&bits, &x, sizeof(bits));
  // A mantissa from sqrt(1/2) to sqrt(2).
  const IntLanes exponent = (bits - 0x3f3504f3) >> 23;
  bits -= exponent << 23;
  FloatLanes mantissa;
  std::memcpy(&mantissa, &bits, sizeof(mantissa));
  const FloatLanes t = (mantissa - 1.0f) / (mantissa + 1.0f);
  const FloatLanes square = t * t;
  // 2 / ln 2 times the series of the inverse hyperbolic tangent.
  FloatLanes sum = square * 0.412198583f + 0.577078016f;
  sum = sum * square + 0.961796694f;
  sum = sum * square + 2.88539008f;
  return sum * t + floatsOf(exponent);
#else
  FloatLanes result;
  for (int lane = 0; lane < floatLanes; ++lane)
  {
    result[lane] = std::log2(x[lane]);
  }
  return result;
#endif
}

// Asks for the cache lines of something that is read soon.
template <class T>
HACHURE_INLINED void prefetch(const T* place)
{
#if defined(__GNUC__)
  constexpr std::size_t line = 64;
  for (std::size_t offset = 0; offset < sizeof(T); offset += line)
  {
    __builtin_prefetch(reinterpret_cast<const char*>(place) + offset);
  }
#endif
}

} // namespace hachure

#endif
