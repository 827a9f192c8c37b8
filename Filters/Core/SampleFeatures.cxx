// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleFeatures.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{

namespace
{

constexpr double searchRadius = 2.0; // sample spacings
// Cosine between normals under which two samples lie on different sides of a sheet.
constexpr double otherSide = -0.5;
// What every sample counts, as a part of the mean of its patch.
constexpr double featureless = 0.01;
constexpr std::uint64_t noKey = 0;

// The samples of one patch, sorted by the cell of a grid as wide as the search.
class PatchGrid
{
public:
  PatchGrid(const TrackedSamples& samples, Span<const std::int32_t> members, double spacing)
    : all(samples)
    , radius(searchRadius * spacing)
    , lower(samples.positions[static_cast<std::size_t>(members[0])])
  {
    for (const std::int32_t sample : members)
    {
      this->lower = glm::min(this->lower, samples.positions[static_cast<std::size_t>(sample)]);
    }
    for (const std::int32_t sample : members)
    {
      const glm::ivec3 cell = this->cellOf(samples.positions[static_cast<std::size_t>(sample)]);
      this->sorted.emplace_back(keyOf(cell.x, cell.y, cell.z), sample);
    }
    std::sort(this->sorted.begin(), this->sorted.end());
  }

  SampleNeighbours nearest(std::int32_t sample) const
  {
    const auto self = static_cast<std::size_t>(sample);
    const glm::ivec3 cell = this->cellOf(this->all.positions[self]);
    std::vector<std::pair<double, std::int32_t>> found;
    for (int x = std::max(0, cell.x - 1); x <= cell.x + 1; ++x)
    {
      for (int y = std::max(0, cell.y - 1); y <= cell.y + 1; ++y)
      {
        this->collect(self, x, y, cell.z, found);
      }
    }
    SampleNeighbours result;
    result.fill(-1);
    const std::size_t count = std::min(result.size(), found.size());
    std::partial_sort(
      found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count), found.end());
    for (std::size_t k = 0; k < count; ++k)
    {
      result[k] = found[k].second;
    }
    return result;
  }

private:
  // Cells beyond the last fall into the last: slower, not wrong.
  static constexpr int bits = 21;
  static constexpr int last = (1 << bits) - 1;

  static std::uint64_t keyOf(int x, int y, int z)
  {
    const auto part = [](int i) { return static_cast<std::uint64_t>(std::clamp(i, 0, last)); };
    return part(x) << (2 * bits) | part(y) << bits | part(z);
  }

  glm::ivec3 cellOf(const glm::dvec3& position) const
  {
    const glm::dvec3 cell = glm::floor((position - this->lower) / this->radius);
    return glm::ivec3(glm::min(cell, glm::dvec3(last)));
  }

  // One row of three cells lies in one range of the sorted samples.
  void collect(std::size_t self, int x, int y, int z,
    std::vector<std::pair<double, std::int32_t>>& found) const
  {
    const std::uint64_t end = keyOf(x, y, z + 1);
    auto item = std::lower_bound(this->sorted.begin(), this->sorted.end(),
      std::make_pair(keyOf(x, y, z - 1), std::int32_t(noKey)));
    for (; item != this->sorted.end() && item->first <= end; ++item)
    {
      const auto other = static_cast<std::size_t>(item->second);
      const glm::dvec3 arm = this->all.positions[other] - this->all.positions[self];
      const double distance = glm::dot(arm, arm);
      if (other != self && distance <= this->radius * this->radius &&
        glm::dot(this->all.normals[other], this->all.normals[self]) > otherSide)
      {
        found.emplace_back(distance, item->second);
      }
    }
  }

  const TrackedSamples& all;
  double radius;
  glm::dvec3 lower;
  std::vector<std::pair<std::uint64_t, std::int32_t>> sorted;
};

std::size_t patchOf(Span<const std::int32_t> patches, std::size_t sample)
{
  return patches.empty() ? 0 : static_cast<std::size_t>(patches[sample]);
}

void checkCount(const char* function, const char* name, std::size_t found, std::size_t expected)
{
  if (found != expected)
  {
    throw std::invalid_argument(std::string(function) + ": " + name + " has " +
      std::to_string(found) + " elements, expected " + std::to_string(expected));
  }
}

// Root mean square of difference(i, j) over the neighbours j of every sample i, 0 without any.
template <class SquaredDifference>
std::vector<double> rootMeanSquares(
  Span<const SampleNeighbours> neighbours, SquaredDifference&& difference)
{
  std::vector<double> result(neighbours.size(), 0.0);
  for (std::size_t i = 0; i < neighbours.size(); ++i)
  {
    double sum = 0.0;
    double count = 0.0;
    for (const std::int32_t j : neighbours[i])
    {
      if (j >= 0)
      {
        sum += difference(i, static_cast<std::size_t>(j));
        count += 1.0;
      }
    }
    result[i] = count > 0.0 ? std::sqrt(sum / count) : 0.0;
  }
  return result;
}

} // namespace

std::vector<SampleNeighbours> nearestSamples(const TrackedSamples& samples)
{
  checkSamples(samples);
  const std::size_t count = samples.positions.size();
  SampleNeighbours none;
  none.fill(-1);
  std::vector<SampleNeighbours> result(count, none);
  std::vector<std::int32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  const auto patch = [&](std::int32_t sample)
  { return patchOf(samples.patches, static_cast<std::size_t>(sample)); };
  std::stable_sort(order.begin(), order.end(),
    [&](std::int32_t a, std::int32_t b) { return patch(a) < patch(b); });
  for (std::size_t begin = 0, end = 0; begin < count; begin = end)
  {
    for (end = begin + 1; end < count && patch(order[end]) == patch(order[begin]); ++end)
    {
    }
    const double spacing = samples.patchSpacing[patch(order[begin])];
    if (spacing > 0.0)
    {
      const Span<const std::int32_t> members(order.data() + begin, end - begin);
      const PatchGrid grid(samples, members, spacing);
      for (const std::int32_t sample : members)
      {
        result[static_cast<std::size_t>(sample)] = grid.nearest(sample);
      }
    }
  }
  return result;
}

std::vector<double> normalVariation(
  Span<const glm::dvec3> normals, Span<const SampleNeighbours> neighbours)
{
  checkCount("normalVariation", "normals", normals.size(), neighbours.size());
  return rootMeanSquares(neighbours,
    [&](std::size_t i, std::size_t j)
    {
      const glm::dvec3 difference = normals[j] - normals[i];
      return glm::dot(difference, difference);
    });
}

std::vector<double> localContrast(
  Span<const double> values, Span<const SampleNeighbours> neighbours)
{
  checkCount("localContrast", "values", values.size(), neighbours.size());
  return rootMeanSquares(neighbours,
    [&](std::size_t i, std::size_t j)
    { return (values[j] - values[i]) * (values[j] - values[i]); });
}

std::vector<double> featureFactors(
  Span<const double> strengths, Span<const std::int32_t> patches, double negligible)
{
  if (!patches.empty())
  {
    checkCount("featureFactors", "patches", patches.size(), strengths.size());
  }
  std::vector<double> sums;
  std::vector<double> counts;
  for (std::size_t i = 0; i < strengths.size(); ++i)
  {
    if (!(strengths[i] >= 0.0 && std::isfinite(strengths[i])))
    {
      throw std::invalid_argument("featureFactors: strengths[" + std::to_string(i) + "] is " +
        std::to_string(strengths[i]) + ", expected a finite number of 0 or more");
    }
    const std::size_t patch = patchOf(patches, i);
    sums.resize(std::max(sums.size(), patch + 1), 0.0);
    counts.resize(sums.size(), 0.0);
    sums[patch] += strengths[i];
    counts[patch] += 1.0;
  }
  std::vector<double> factors(strengths.size(), 1.0);
  for (std::size_t i = 0; i < strengths.size(); ++i)
  {
    const std::size_t patch = patchOf(patches, i);
    const double mean = sums[patch] / counts[patch];
    factors[i] = mean > negligible ? strengths[i] / mean + featureless : 1.0;
  }
  return factors;
}

} // namespace hachure
