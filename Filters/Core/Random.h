// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_Random_h
#define hachure_Random_h

// Counter-based random numbers: a value is a pure function of (seed, id, dimension). There is no
// generator state, so the result depends neither on the order of calls nor on the thread count.

#include <cstdint>

namespace hachure
{
/// 64-bit finaliser with full avalanche (the mixing step of SplitMix64, Steele et al. 2014).
inline std::uint64_t hashMix(std::uint64_t value)
{
  value ^= value >> 30;
  value *= 0xbf58476d1ce4e5b9ull;
  value ^= value >> 27;
  value *= 0x94d049bb133111ebull;
  value ^= value >> 31;
  return value;
}

/// Hashes two values of any origin into 64 bits; the order of the two matters.
inline std::uint64_t hashPair(std::uint64_t first, std::uint64_t second)
{
  const std::uint64_t goldenRatio = 0x9e3779b97f4a7c15ull; // 2^64 / golden ratio, odd
  return hashMix(hashMix(first + goldenRatio) ^ (second * goldenRatio + 1));
}

/// A stable 32-bit hash of an id under a seed.
inline std::uint32_t hashCombine(std::uint32_t seed, std::uint64_t id)
{
  return static_cast<std::uint32_t>(hashPair(seed, id) >> 32);
}

/// Uniform in [0, 1), with 53 random bits: one independent number per (seed, id, dimension).
inline double unitRandom(std::uint32_t seed, std::uint64_t id, std::uint32_t dimension)
{
  const std::uint64_t bits = hashPair(hashPair(seed, id), dimension);
  return static_cast<double>(bits >> 11) * (1.0 / 9007199254740992.0); // 2^-53
}
} // namespace hachure

#endif
