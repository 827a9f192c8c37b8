// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewTextureLevel.h"

#include "Kernels.h"
#include "Parallel.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace hachure
{
namespace
{
struct Areas
{
  double surface = 0.0;
  double picture = 0.0;
};

// Rows of the matrix to pixels times w.
struct PixelRows
{
  glm::vec4 x, y, w;
};

void add(Areas& areas, const TriangleMesh& mesh, std::int64_t triangle, const PixelRows& rows)
{
  const glm::ivec3& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
  glm::dvec3 middle(0.0);
  for (int corner = 0; corner < 3; ++corner)
  {
    middle += mesh.points[static_cast<std::size_t>(corners[corner])] / 3.0;
  }
  const glm::vec3 place(middle);
  const glm::dvec3 areaVector = triangleAreaVector(mesh, triangle);
  const double twice = glm::length(areaVector);
  if (glm::dot(rows.w, glm::vec4(place, 1.0f)) > 0.0f && twice > 0.0)
  {
    const float scale =
      glsl::pictureArea(place, glm::vec3(areaVector / twice), rows.x, rows.y, rows.w);
    areas.surface += 0.5 * twice;
    areas.picture += 0.5 * twice * static_cast<double>(scale);
  }
}
} // namespace

double levelOfSurface(const TriangleMesh& mesh, const glm::dmat4& modelToClip,
  const glm::dvec2& pictureSize, double cellArea)
{
  checkTriangleMesh(mesh);
  const PixelRows rows = { glm::vec4(0.5 * pictureSize.x * glm::row(modelToClip, 0)),
    glm::vec4(0.5 * pictureSize.y * glm::row(modelToClip, 1)),
    glm::vec4(glm::row(modelToClip, 3)) };
  const auto count = static_cast<std::int64_t>(mesh.triangles.size());
  constexpr std::int64_t grain = 4096;
  std::vector<Areas> parts(static_cast<std::size_t>((count + grain - 1) / grain));
  parallelForRanges(count, grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        add(parts[static_cast<std::size_t>(begin / grain)], mesh, i, rows);
      }
    });
  Areas all;
  for (const Areas& part : parts)
  {
    all.surface += part.surface;
    all.picture += part.picture;
  }
  return all.surface > 0.0 ? static_cast<double>(glsl::levelOfArea(
                               static_cast<float>(cellArea * all.picture / all.surface)))
                           : 0.0;
}

} // namespace hachure
