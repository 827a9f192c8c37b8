// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseProcess.h"

#include <cassert>
#include <cmath>

namespace hachure
{

namespace
{

// Number of points of a Poisson process of this mean, below 64: its distribution inverted.
int poissonCount(double mean, double uniform)
{
  assert(!(mean >= 64.0));
  if (uniform < 1.0 - mean) // below exp(-mean), which is not needed then
  {
    return 0;
  }
  const int most = 256; // never met: its probability is under 1e-60
  double probability = std::exp(-mean);
  double sum = probability;
  int count = 0;
  while (uniform >= sum && count < most)
  {
    ++count;
    probability *= mean / count;
    sum += probability;
  }
  return count;
}

std::uint64_t bitsOf(double value)
{
  const double withoutSign = value + 0.0; // -0 is 0
  std::uint64_t bits = 0;
  std::memcpy(&bits, &withoutSign, sizeof(bits));
  return bits ^ (bits >> 32); // round numbers end in zeros, and products carry upwards only
}

} // namespace

NoiseCell noiseChild(const NoiseCell& cell, int child)
{
  const std::array<glm::dvec2, 3>& corners = cell.corners;
  NoiseCell result;
  result.key = hashMix(cell.key + static_cast<std::uint64_t>(child + 1) * 0x8ebc6af09c88c6e3ull);
  result.depth = cell.depth + 1;
  for (int i = 0; i < 3; ++i)
  {
    result.corners[i] = child < 3 ? 0.5 * (corners[i] + corners[child])
                                  : 0.5 * (corners[(i + 1) % 3] + corners[(i + 2) % 3]);
  }
  return result;
}

NoiseCell noiseCellOf(std::int32_t number)
{
  return number == 0 ? NoiseCell{} : noiseChild(noiseCellOf((number - 1) / 4), (number - 1) % 4);
}

NoiseBatch noiseSharedBatch(std::uint64_t triangleKey, double area)
{
  NoiseBatch batch;
  batch.birthRange = powerOfTwo(noiseSharedOctave(area) + 1);
  // The key itself is as random as a hash of it.
  batch.count = poissonCount(area * batch.birthRange, openUnit(triangleKey));
  batch.stream = hashMix(triangleKey ^ 0xe7037ed1a0b428dbull);
  return batch;
}

NoiseBatch noiseBatch(const NoiseCell& cell, double area, int octave)
{
  NoiseBatch batch;
  batch.lowestBirth = powerOfTwo(octave);
  batch.birthRange = batch.lowestBirth;
  const std::uint64_t bits = hashMix(cell.key ^
    (static_cast<std::uint64_t>(static_cast<std::int64_t>(octave)) * 0x589965cc75374cc3ull));
  const double mean = area * batch.birthRange * powerOfTwo(-2 * cell.depth);
  batch.count = poissonCount(mean, openUnit(bits));
  batch.stream = hashMix(bits ^ 0x1d8e4e27c47d124full);
  return batch;
}

std::uint64_t noiseTriangleId(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  // Nine products that do not wait for each other; the factors are odd and random.
  const std::uint64_t sum = bitsOf(a.x) * 0xa0761d6478bd642full +
    bitsOf(a.y) * 0xe7037ed1a0b428dbull + bitsOf(a.z) * 0x8ebc6af09c88c6e3ull +
    bitsOf(b.x) * 0x589965cc75374cc3ull + bitsOf(b.y) * 0x1d8e4e27c47d124full +
    bitsOf(b.z) * 0xeb44accab455d165ull + bitsOf(c.x) * 0x9fb21c651e98df25ull +
    bitsOf(c.y) * 0xd6e8feb86659fd93ull + bitsOf(c.z) * 0xc2b2ae3d27d4eb4full;
  return hashMix(sum);
}

} // namespace hachure
