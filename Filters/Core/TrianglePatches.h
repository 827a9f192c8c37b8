// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TrianglePatches_h
#define hachure_TrianglePatches_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <vector>

// The patches of every triangle as a shader reads them. Most triangles lie within one patch and
// take one number; those on which patches overlap also take a record of 7 x 16 bytes.
namespace hachure
{

// Patches 0 to maximumDrawnPatches - 1 can be drawn: Kernels/PatchBlend.glsl.
constexpr int maximumDrawnPatches = 8192;

// The weight of every patch at a corner: a list of up to four, ended by -1.
struct CornerPatches
{
  std::array<int, 4> patches{ -1, -1, -1, -1 };
  glm::vec4 weights{ 0.0f };
};

struct TrianglePatches
{
  // Per triangle: the patch, or -1 - (number of its record).
  std::vector<float> triangles;
  // Per record: (first corner, patch 0), (gradient of the second corner's weight, patch 1),
  // (gradient of the third corner's, patch 2), (patch 3, 0, 0, 0), then the four patches' weights
  // at the three corners. Unused patches repeat the first one with weight 0.
  std::vector<glm::vec4> records;
};

constexpr std::size_t patchRecordTexels = 7;

// Appends a triangle that lies within one patch.
void appendTriangle(TrianglePatches& all, int patch);

// Appends a triangle with the weights at its corners. Of more than four patches the heaviest four
// are kept, and weights at each corner are made to sum up to 1.
void appendTriangle(TrianglePatches& all, const std::array<glm::dvec3, 3>& points,
  const std::array<CornerPatches, 3>& corners);

} // namespace hachure

#endif
