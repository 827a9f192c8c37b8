// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TrianglePatches_h
#define hachure_TrianglePatches_h

#include "Span.h"

#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <vector>

// The patches of every triangle as a shader reads them: one number for every vertex, which a
// triangle takes from its *last* vertex (OpenGL's provoking vertex), and which costs nothing to
// interpolate. (The number of a triangle itself makes software OpenGL split the whole mesh into
// single triangles first.)
//
// A vertex is the last one of a few triangles. Where all of them lie within one patch, its number
// is that patch. Elsewhere it names the first of several records, one for every triangle: the
// shader takes the one in which the point lies that it draws.
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

// What a shader knows of triangles. Small, since every pixel may show a triangle of its own: 76
// bytes.
struct PatchRecords
{
  // (first corner, 1 where another record of the vertex follows), (gradient of the second corner's
  // weight, 0), (gradient of the third corner's, 0), the four patches. Patches ascend; unused ones
  // repeat the first with weight 0.
  std::vector<glm::vec4> shapes;
  // The four patches' weights at the three corners; 255 is 1.
  std::vector<glm::u8vec4> weights;
};

constexpr std::size_t recordShapes = 4;
constexpr std::size_t recordWeights = 3;

// Triangles in the order in which they are drawn. Those without area draw nothing and are left out.
struct TrianglePatches
{
  struct Plain
  {
    std::uint32_t lastVertex;
    int patch;
    std::array<glm::vec3, 3> corners;
  };
  std::vector<Plain> plain; // lie within one patch
  // Those on which patches overlap, with a record each.
  std::vector<std::uint32_t> overlapLastVertex;
  PatchRecords overlapRecords;
};

using TriangleCorners = std::array<glm::dvec3, 3>;

// Appends a triangle that lies within one patch.
void appendTriangle(
  TrianglePatches& all, std::uint32_t lastVertex, const TriangleCorners& points, int patch);

// Appends a triangle with the weights at its corners. Of more than four patches the heaviest four
// are kept, and weights at each corner are made to sum up to 1.
void appendTriangle(TrianglePatches& all, std::uint32_t lastVertex, const TriangleCorners& points,
  const std::array<CornerPatches, 3>& corners);

struct VertexPatches
{
  // Per vertex: the patch, or -1 - (number of its first record); 0 where it ends no triangle.
  std::vector<float> vertices;
  PatchRecords records;
};

VertexPatches patchesOfVertices(const TrianglePatches& triangles, std::size_t vertexCount);

} // namespace hachure

#endif
