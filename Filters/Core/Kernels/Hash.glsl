// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Integer hashes: equal bits on every GPU and in C++. Inputs are ids or cell indices, never time.

// One round of a 32-bit multiply-xorshift permutation with full avalanche.
uint hashBits(uint value)
{
  uint bits = value;
  bits ^= bits >> 16u;
  bits *= 0x7feb352du;
  bits ^= bits >> 15u;
  bits *= 0x846ca68bu;
  bits ^= bits >> 16u;
  return bits;
}

// Hash of an ordered pair.
uint hashPair(uint first, uint second)
{
  return hashBits(first ^ (hashBits(second) + 0x9e3779b9u));
}

// Hash bits to [0, 1): the upper 24 bits, which a float holds exactly.
float hashToUnit(uint bits)
{
  return float(bits >> 8u) * (1.0f / 16777216.0f);
}
