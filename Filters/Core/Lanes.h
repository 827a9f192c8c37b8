// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_Lanes_h
#define hachure_Lanes_h

#include <cstddef>

// Sums over many samples run in four lanes, whatever the processor: the same bytes everywhere, and
// no sum waits for the one before.
namespace hachure
{

// Functions compiled for wider registers too, chosen when the program starts. Without fused
// multiplication and addition: its rounding differs.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) &&                             \
  !defined(__SANITIZE_ADDRESS__)
#define HACHURE_WIDE_CLONES __attribute__((target_clones("default", "avx2")))
#else
#define HACHURE_WIDE_CLONES
#endif

constexpr std::size_t lanes = 4;
constexpr int floatLanes = 8; // of single precision, see FloatLanes.h

#if defined(__GNUC__)
typedef double Lanes __attribute__((vector_size(lanes * sizeof(double))));
#else
struct Lanes
{
  double values[lanes];
  double& operator[](std::size_t lane) { return this->values[lane]; }
  double operator[](std::size_t lane) const { return this->values[lane]; }
};
inline Lanes operator+(const Lanes& a, const Lanes& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3] } };
}
inline Lanes operator-(const Lanes& a, const Lanes& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3] } };
}
inline Lanes operator*(const Lanes& a, const Lanes& b)
{
  return { { a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3] } };
}
#endif

// Results by reference: registers of this width cannot be returned everywhere.
inline void load(const double* values, Lanes& result)
{
  result = Lanes{ values[0], values[1], values[2], values[3] };
}

inline void fill(double value, Lanes& result)
{
  result = Lanes{ value, value, value, value };
}

inline double total(const Lanes& sums)
{
  return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

} // namespace hachure

#endif
