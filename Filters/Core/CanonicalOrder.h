// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_CanonicalOrder_h
#define hachure_CanonicalOrder_h

#include "Span.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>
#include <vector>

// An order of a surface's cells and points that depends on where they are alone: not on how the
// surface is divided among processes, nor on the order in which its parts are put together. What is
// made of the surface in that order is the same for any number of processes.
namespace hachure
{

/// Corners of polygons: those of cell i are corners[offsets[i]] to corners[offsets[i + 1]] - 1.
struct PolygonCells
{
  Span<const std::int64_t> offsets; ///< one more than cells, ascending from 0
  Span<const std::int64_t> corners; ///< indices of points

  std::int64_t count() const
  {
    return this->offsets.size() > 0 ? static_cast<std::int64_t>(this->offsets.size()) - 1 : 0;
  }
};

/// Bounds of cells; none, with low above high, at first.
struct CellBox
{
  glm::dvec3 low{ std::numeric_limits<double>::infinity() };
  glm::dvec3 high{ -std::numeric_limits<double>::infinity() };
  /// Extends it by the finite corners of cells. Throws as canonicalOrder() does.
  void add(Span<const glm::dvec3> points, const PolygonCells& cells);
};

/// The cells along a space-filling curve through the middles of their corners, then by a hash of
/// their corners' coordinates; only cells whose corners are equal and in the same order keep the
/// order that they have. Cells with a corner that is not finite come last. box: what the curve
/// fills; cells have the same order in all surfaces that share one. Throws std::invalid_argument
/// where a corner is not a point.
std::vector<std::int64_t> canonicalOrder(
  Span<const glm::dvec3> points, const PolygonCells& cells, const CellBox& box);
/// The same in the bounds of these cells.
std::vector<std::int64_t> canonicalOrder(Span<const glm::dvec3> points, const PolygonCells& cells);

/// Points that are told apart by a number.
struct DistinctPoints
{
  std::vector<std::int64_t> first;   ///< of every distinct point the point that stands for it
  std::vector<std::int64_t> numbers; ///< of every point its distinct point; -1: of no cell
};

/// Points with equal identities are one; they are numbered as the cells in this order use them.
/// Throws std::invalid_argument where a corner is not a point, or the order has other cells.
DistinctPoints distinctPoints(
  Span<const std::uint64_t> identities, const PolygonCells& cells, Span<const std::int64_t> order);

} // namespace hachure

#endif
