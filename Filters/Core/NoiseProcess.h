// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseProcess_h
#define hachure_NoiseProcess_h

#include "Random.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <cstring>

// The Poisson process of NoiseSurface on one triangle: a function of the triangle's key (a hash of
// seed and id) and of its reference area, and of nothing else.
//
// Octave k holds the births from 2^k to 2^(k+1). The lowest octaves, in which the triangle has less
// than 1/21 of a point in all, share one count: most triangles have no point in them, which one
// comparison tells. Every octave above has a count of its own. A triangle with 24 and more points
// in an octave is cut 1 to 4 until each cell has fewer, and every cell has its own count, so that
// the points of any part of a large triangle can be made without those of the rest.
namespace hachure
{

// Floor of the binary logarithm of a positive number.
inline int binaryExponent(double value)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return static_cast<int>((bits >> 52) & 0x7ff) - 1023;
}

// 2^exponent; 0 and infinity beyond the range of doubles.
inline double powerOfTwo(int exponent)
{
  const int biased = exponent < -1023 ? 0 : exponent > 1024 ? 2047 : exponent + 1023;
  const std::uint64_t bits = static_cast<std::uint64_t>(biased) << 52;
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

// What decides on octaves and cells. The areas of many meshes are powers of two or round numbers;
// they must be far from where the exponent changes, or the rounding of a rotation would be enough
// to give a triangle other points.
inline int noiseAreaExponent(double area)
{
  return binaryExponent(1.37 * area);
}

// Octaves up to this one share a count. Its own mean is between 1/88 and 1/43, that of all of them
// twice as much.
inline int noiseSharedOctave(double area)
{
  return -6 - noiseAreaExponent(area);
}

// The highest octave that is not cut into cells. Its mean is between 11 and 24.
inline int noiseWholeOctave(double area)
{
  return 4 - noiseAreaExponent(area);
}

// How often a triangle is cut 1 to 4 for an octave.
inline int noiseCellDepth(double area, int octave)
{
  const int above = octave - noiseWholeOctave(area);
  return above <= 0 ? 0 : (above + 1) / 2;
}

// A part of a triangle.
struct NoiseCell
{
  std::uint64_t key = 0; // hash of seed, triangle and place within it
  int depth = 0;
  // Barycentric weights of the triangle's second and third corner.
  std::array<glm::dvec2, 3> corners{ glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 0.0),
    glm::dvec2(0.0, 1.0) };
};

// The children 0 to 2 lie at the corners, 3 in the middle.
NoiseCell noiseChild(const NoiseCell& cell, int child);

// Numbers of cells: that of the triangle is 0, and those of the children of cell n follow each
// other from 4 n + 1 on.
inline std::int32_t noiseChildNumber(std::int32_t cell, int child)
{
  return 4 * cell + 1 + child;
}

// The cell of a number; keys are not set.
NoiseCell noiseCellOf(std::int32_t number);

// Uniform in (0, 1).
inline double openUnit(std::uint64_t bits)
{
  return (static_cast<double>(bits >> 12) + 0.5) * (1.0 / 4503599627370496.0); // 2^-52
}

// The points of one count. They are independent, so each is made from its index alone.
struct NoiseBatch
{
  std::uint64_t stream = 0;
  int count = 0;
  double lowestBirth = 0.0;
  double birthRange = 0.0;

  std::uint64_t id(int index) const
  {
    return hashMix(this->stream + (static_cast<std::uint64_t>(index) + 1) * 0x9e3779b97f4a7c15ull);
  }
  // A number that single precision holds.
  double birth(std::uint64_t id) const
  {
    const std::uint64_t bits = hashMix(id ^ 0xd6e8feb86659fd93ull);
    const double scale = 1.0 / 8388608.0; // 2^-23
    return this->lowestBirth + this->birthRange * (static_cast<double>(bits >> 41) * scale);
  }
};

// The points of the octaves that share a count.
NoiseBatch noiseSharedBatch(std::uint64_t triangleKey, double area);

// The points of a higher octave in a cell of the depth that belongs to it; `area` is that of the
// whole triangle.
NoiseBatch noiseBatch(const NoiseCell& cell, double area, int octave);

// Where a point of a cell is, as weights of the triangle's second and third corner.
inline glm::dvec2 noiseWeights(const NoiseCell& cell, std::uint64_t id)
{
  const std::uint64_t bits = hashMix(id ^ 0xa0761d6478bd642full);
  const double scale = 1.0 / 4294967296.0; // 2^-32
  double u = (static_cast<double>(bits >> 32) + 0.5) * scale;
  double v = (static_cast<double>(bits & 0xffffffffull) + 0.5) * scale;
  if (u + v > 1.0) // the other half of a parallelogram
  {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  return cell.corners[0] + u * (cell.corners[1] - cell.corners[0]) +
    v * (cell.corners[2] - cell.corners[0]);
}

// Calls visit(cell, batch) for all cells of the octave.
template <class Visit>
void visitNoiseOctave(const NoiseCell& cell, double area, int octave, Visit&& visit)
{
  if (cell.depth >= noiseCellDepth(area, octave))
  {
    visit(cell, noiseBatch(cell, area, octave));
    return;
  }
  for (int child = 0; child < 4; ++child)
  {
    visitNoiseOctave(noiseChild(cell, child), area, octave, visit);
  }
}

// An id of a triangle without one: a hash of where its corners are.
std::uint64_t noiseTriangleId(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

} // namespace hachure

#endif
