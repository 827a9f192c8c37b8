// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TrianglePatches.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace hachure
{
namespace
{
struct Share
{
  int patch;
  float total;
};

// Every patch of the corners with its total weight, the heaviest first, equal ones by number.
std::vector<Share> sharesOf(const std::array<CornerPatches, 3>& corners)
{
  std::vector<Share> shares;
  for (const CornerPatches& corner : corners)
  {
    for (int i = 0; i < 4; ++i)
    {
      const int patch = corner.patches[static_cast<std::size_t>(i)];
      if (patch < 0 || !(corner.weights[i] > 0.0f))
      {
        continue;
      }
      const auto known = std::find_if(
        shares.begin(), shares.end(), [patch](const Share& share) { return share.patch == patch; });
      if (known == shares.end())
      {
        shares.push_back({ patch, corner.weights[i] });
      }
      else
      {
        known->total += corner.weights[i];
      }
    }
  }
  std::sort(shares.begin(), shares.end(),
    [](const Share& a, const Share& b)
    { return a.total != b.total ? a.total > b.total : a.patch < b.patch; });
  return shares;
}

// Weights of the kept patches at a corner.
glm::vec4 weightsAt(const CornerPatches& corner, const std::vector<Share>& kept)
{
  glm::vec4 weights(0.0f);
  float sum = 0.0f;
  for (std::size_t slot = 0; slot < kept.size(); ++slot)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (corner.patches[static_cast<std::size_t>(i)] == kept[slot].patch)
      {
        weights[static_cast<int>(slot)] += corner.weights[i];
        sum += corner.weights[i];
      }
    }
  }
  return sum > 0.0f ? weights / sum : glm::vec4(1.0f, 0.0f, 0.0f, 0.0f);
}
} // namespace

void appendTriangle(TrianglePatches& all, int patch)
{
  all.triangles.push_back(static_cast<float>(std::clamp(patch, 0, maximumDrawnPatches - 1)));
}

void appendTriangle(TrianglePatches& all, const std::array<glm::dvec3, 3>& points,
  const std::array<CornerPatches, 3>& corners)
{
  constexpr std::size_t slots = 4;
  std::vector<Share> kept = sharesOf(corners);
  kept.resize(std::min(kept.size(), slots));
  if (kept.size() <= 1)
  {
    appendTriangle(all, kept.empty() ? 0 : kept[0].patch);
    return;
  }
  std::array<float, slots> numbers{};
  for (std::size_t slot = 0; slot < slots; ++slot)
  {
    numbers[slot] = static_cast<float>(kept[slot < kept.size() ? slot : 0].patch);
  }
  // The weight of a corner is the dot product with the dual of its edge; none without area.
  const glm::dvec3 second = points[1] - points[0];
  const glm::dvec3 third = points[2] - points[0];
  const double ss = glm::dot(second, second);
  const double st = glm::dot(second, third);
  const double tt = glm::dot(third, third);
  const double area = ss * tt - st * st;
  const bool flat = !(area > 0.0);
  const glm::dvec3 toSecond = flat ? glm::dvec3(0.0) : (tt * second - st * third) / area;
  const glm::dvec3 toThird = flat ? glm::dvec3(0.0) : (ss * third - st * second) / area;

  const std::size_t record = all.records.size() / patchRecordTexels;
  all.triangles.push_back(-1.0f - static_cast<float>(record));
  all.records.emplace_back(glm::vec3(points[0]), numbers[0]);
  all.records.emplace_back(glm::vec3(toSecond), numbers[1]);
  all.records.emplace_back(glm::vec3(toThird), numbers[2]);
  all.records.emplace_back(numbers[3], 0.0f, 0.0f, 0.0f);
  for (const CornerPatches& corner : corners)
  {
    all.records.push_back(weightsAt(corner, kept));
  }
}

} // namespace hachure
