// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CanonicalOrder.h"

#include "Parallel.h"
#include "ParallelSort.h"
#include "Random.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unordered_map>

namespace hachure
{
namespace
{
struct CellKey
{
  std::uint64_t place;
  std::uint64_t corners;
  std::int64_t cell;
  bool operator<(const CellKey& other) const
  {
    return std::tie(place, corners, cell) < std::tie(other.place, other.corners, other.cell);
  }
};

void checkCorners(const PolygonCells& cells, std::size_t points)
{
  for (const std::int64_t corner : cells.corners)
  {
    if (corner < 0 || static_cast<std::uint64_t>(corner) >= points)
    {
      throw std::invalid_argument("cells: corner " + std::to_string(corner) + ", expected one of " +
        std::to_string(points) + " points");
    }
  }
}

// The lowest 21 bits, two zeros after each.
std::uint64_t spreadBits(std::uint64_t value)
{
  value &= 0x1fffff;
  value = (value | value << 32) & 0x1f00000000ffffull;
  value = (value | value << 16) & 0x1f0000ff0000ffull;
  value = (value | value << 8) & 0x100f00f00f00f00full;
  value = (value | value << 4) & 0x10c30c30c30c30c3ull;
  return (value | value << 2) & 0x1249249249249249ull;
}

std::uint64_t placeOf(const glm::dvec3& point, const CellBox& box)
{
  if (!std::isfinite(point.x + point.y + point.z))
  {
    return std::numeric_limits<std::uint64_t>::max();
  }
  constexpr double steps = 2097151.0; // 2^21 - 1
  std::uint64_t place = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double extent = box.high[axis] - box.low[axis];
    const double share = extent > 0.0 ? (point[axis] - box.low[axis]) / extent : 0.0;
    place |= spreadBits(static_cast<std::uint64_t>(std::clamp(share, 0.0, 1.0) * steps)) << axis;
  }
  return place;
}

std::uint64_t bitsOf(double value)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

CellKey keyOf(
  Span<const glm::dvec3> points, const PolygonCells& cells, const CellBox& box, std::int64_t cell)
{
  const auto begin = cells.offsets[static_cast<std::size_t>(cell)];
  const auto end = cells.offsets[static_cast<std::size_t>(cell) + 1];
  glm::dvec3 sum(0.0);
  std::uint64_t hash = 0;
  for (std::int64_t i = begin; i < end; ++i)
  {
    const auto corner = static_cast<std::size_t>(cells.corners[static_cast<std::size_t>(i)]);
    const glm::dvec3& point = points[corner];
    sum += point;
    for (int axis = 0; axis < 3; ++axis)
    {
      hash = hashPair(hash, bitsOf(point[axis]));
    }
  }
  const auto count = static_cast<double>(std::max<std::int64_t>(end - begin, 1));
  return { placeOf(sum / count, box), hash, cell };
}
} // namespace

void CellBox::add(Span<const glm::dvec3> points, const PolygonCells& cells)
{
  checkCorners(cells, points.size());
  for (const std::int64_t corner : cells.corners)
  {
    const glm::dvec3& point = points[static_cast<std::size_t>(corner)];
    if (std::isfinite(point.x + point.y + point.z))
    {
      this->low = glm::min(this->low, point);
      this->high = glm::max(this->high, point);
    }
  }
}

std::vector<std::int64_t> canonicalOrder(Span<const glm::dvec3> points, const PolygonCells& cells)
{
  CellBox box;
  box.add(points, cells);
  return canonicalOrder(points, cells, box);
}

std::vector<std::int64_t> canonicalOrder(
  Span<const glm::dvec3> points, const PolygonCells& cells, const CellBox& box)
{
  checkCorners(cells, points.size());
  std::vector<CellKey> keys(static_cast<std::size_t>(cells.count()));
  parallelFor(cells.count(),
    [&](std::int64_t cell)
    { keys[static_cast<std::size_t>(cell)] = keyOf(points, cells, box, cell); });
  parallelSort(keys);
  std::vector<std::int64_t> order;
  order.reserve(keys.size());
  for (const CellKey& key : keys)
  {
    order.push_back(key.cell);
  }
  return order;
}

DistinctPoints distinctPoints(
  Span<const std::uint64_t> identities, const PolygonCells& cells, Span<const std::int64_t> order)
{
  checkCorners(cells, identities.size());
  if (static_cast<std::int64_t>(order.size()) != cells.count())
  {
    throw std::invalid_argument("order: " + std::to_string(order.size()) + " cells, expected " +
      std::to_string(cells.count()));
  }
  DistinctPoints result;
  result.numbers.assign(identities.size(), -1);
  std::unordered_map<std::uint64_t, std::int64_t> known;
  known.reserve(identities.size());
  for (const std::int64_t cell : order)
  {
    const auto begin = cells.offsets[static_cast<std::size_t>(cell)];
    const auto end = cells.offsets[static_cast<std::size_t>(cell) + 1];
    for (std::int64_t i = begin; i < end; ++i)
    {
      const auto point = cells.corners[static_cast<std::size_t>(i)];
      std::int64_t& number = result.numbers[static_cast<std::size_t>(point)];
      if (number < 0)
      {
        const auto next = static_cast<std::int64_t>(result.first.size());
        const auto added = known.emplace(identities[static_cast<std::size_t>(point)], next);
        number = added.first->second;
        if (added.second)
        {
          result.first.push_back(point);
        }
      }
    }
  }
  return result;
}

} // namespace hachure
