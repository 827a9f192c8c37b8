// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseTriangleOrder.h"

#include "Parallel.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace hachure
{

namespace
{

constexpr int gridBits = 5; // per axis
constexpr int gridSize = 1 << gridBits;
constexpr std::size_t cellCount = std::size_t{ 1 } << (3 * gridBits);
// Sorting is split into this many parts at most; each needs a counter for every cell.
constexpr std::int64_t sortingParts = 8;
constexpr std::int64_t smallestPart = 1 << 16;
constexpr std::int64_t pointGrain = 1 << 16;

struct Box
{
  glm::dvec3 low{ std::numeric_limits<double>::max() };
  glm::dvec3 high{ -std::numeric_limits<double>::max() };
};

// Of the finite points.
Box boundingBox(Span<const glm::dvec3> points)
{
  const auto count = static_cast<std::int64_t>(points.size());
  std::vector<Box> boxes(static_cast<std::size_t>(count / pointGrain + 1));
  parallelForRanges(count, pointGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      Box box;
      for (std::int64_t i = begin; i < end; ++i)
      {
        const glm::dvec3& point = points[i];
        if (std::isfinite(point.x + point.y + point.z))
        {
          box.low = glm::min(box.low, point);
          box.high = glm::max(box.high, point);
        }
      }
      boxes[static_cast<std::size_t>(begin / pointGrain)] = box;
    });
  Box all;
  for (const Box& box : boxes)
  {
    all.low = glm::min(all.low, box.low);
    all.high = glm::max(all.high, box.high);
  }
  return all;
}

// The bits of a coordinate, two places apart.
std::array<std::uint16_t, gridSize> spreadBits()
{
  std::array<std::uint16_t, gridSize> result{};
  for (int value = 0; value < gridSize; ++value)
  {
    int spread = 0;
    for (int bit = 0; bit < gridBits; ++bit)
    {
      spread |= ((value >> bit) & 1) << (3 * bit);
    }
    result[value] = static_cast<std::uint16_t>(spread);
  }
  return result;
}

class Grid
{
public:
  explicit Grid(const Box& box)
    : low(box.low)
    , spread(spreadBits())
  {
    const glm::dvec3 size = box.high - box.low;
    const double largest = std::max({ size.x, size.y, size.z });
    // The highest coordinate is just inside.
    this->scale = largest > 0.0 && std::isfinite(largest) ? 0.999999 * gridSize / largest : 0.0;
  }

  std::uint16_t cell(const glm::dvec3& point) const
  {
    const glm::dvec3 place = (point - this->low) * this->scale;
    return static_cast<std::uint16_t>(
      this->axis(place.x) | this->axis(place.y) << 1 | this->axis(place.z) << 2);
  }

private:
  int axis(double place) const
  {
    return this
      ->spread[static_cast<std::size_t>(std::clamp(static_cast<int>(place), 0, gridSize - 1))];
  }

  glm::dvec3 low;
  double scale = 0.0;
  std::array<std::uint16_t, gridSize> spread;
};

// The cell of a triangle, which is that of its first corner; of one without, the first.
std::uint16_t findCell(const TriangleMesh& mesh, const Grid& grid, std::int64_t triangle)
{
  const auto corner = static_cast<std::uint32_t>(mesh.triangles[triangle].x);
  return corner < mesh.points.size() ? grid.cell(mesh.points[corner]) : std::uint16_t{ 0 };
}

using Counts = std::vector<std::vector<std::int32_t>>;

// Turns counts, per part and cell, into where the first of them goes.
void makeSlots(Counts& counts)
{
  std::int32_t first = 0;
  for (std::size_t cell = 0; cell < cellCount; ++cell)
  {
    for (std::vector<std::int32_t>& part : counts)
    {
      first += std::exchange(part[cell], first);
    }
  }
}

} // namespace

void* allocateUninitialised(std::size_t bytes)
{
  void* memory = nullptr;
#if defined(__linux__)
  constexpr std::size_t page = std::size_t{ 2 } << 20;
  if (bytes >= 2 * page)
  {
    const std::size_t whole = (bytes + page - 1) / page * page;
    memory = std::aligned_alloc(page, whole);
    if (memory)
    {
      madvise(memory, whole, MADV_HUGEPAGE); // a hint: nothing is lost where it is refused
    }
  }
#endif
  memory = memory ? memory : std::malloc(std::max<std::size_t>(bytes, 1));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

UninitialisedArray<std::int32_t> orderNoiseTriangles(const TriangleMesh& mesh)
{
  const auto count = static_cast<std::int64_t>(mesh.triangles.size());
  UninitialisedArray<std::int32_t> order(mesh.triangles.size());
  if (count == 0)
  {
    return order;
  }
  const Grid grid(boundingBox(mesh.points));
  const std::int64_t part = std::max(smallestPart, (count + sortingParts - 1) / sortingParts);
  UninitialisedArray<std::uint16_t> cells(mesh.triangles.size());
  Counts slots(static_cast<std::size_t>((count - 1) / part + 1));
  parallelForRanges(count, part,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<std::int32_t> counts(cellCount, 0);
      for (std::int64_t i = begin; i < end; ++i)
      {
        cells[i] = findCell(mesh, grid, i);
        ++counts[cells[i]];
      }
      slots[begin / part] = std::move(counts);
    });
  makeSlots(slots);
  parallelForRanges(count, part,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<std::int32_t>& next = slots[begin / part];
      for (std::int64_t i = begin; i < end; ++i)
      {
        order[next[cells[i]]++] = static_cast<std::int32_t>(i);
      }
    });
  return order;
}

} // namespace hachure
