// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NestedPoints_h
#define hachure_NestedPoints_h

#include <cmath>
#include <cstdint>
#include <vector>

// Blue noise for tiles. The square tile is a torus of width 1. A set of marks survives the change
// to the half-size copy of a tile when it is closed under doubling: a mark at x stays because the
// copy draws at x what the tile has at 2x (modulo 1).
namespace hachure
{

struct TorusPoint
{
  double x = 0.0; // in [0, 1)
  double y = 0.0;
};

// Points of a torus by cells, for searches near a place.
class TorusGrid
{
public:
  // About one point per cell is best.
  explicit TorusGrid(int cellsAcross);

  void add(const TorusPoint& point);
  int cellsAcross() const { return this->cells; }
  const std::vector<TorusPoint>& points() const { return this->all; }

  // Calls visit(index, dx, dy) for all points, and for their repetitions, in the cells up to
  // `rings` away from (x, y) in [0, 1)^2; (dx, dy) leads from there to the point, not wrapped.
  template <class Visit>
  void visitNear(double x, double y, int rings, Visit&& visit) const
  {
    const int column = this->cellOf(x);
    const int row = this->cellOf(y);
    for (int j = row - rings; j <= row + rings; ++j)
    {
      for (int i = column - rings; i <= column + rings; ++i)
      {
        this->visitCell(i, j, x, y, visit);
      }
    }
  }

  // Squared distance to the nearest point, its repetitions included; 2 without any.
  double nearestSquared(double x, double y) const;

private:
  int cellOf(double position) const;
  int wrap(int cell) const { return ((cell % this->cells) + this->cells) % this->cells; }

  // Whole tiles from a wrapped cell to this one.
  int turns(int cell) const { return (cell - this->wrap(cell)) / this->cells; }

  template <class Visit>
  void visitCell(int i, int j, double x, double y, Visit& visit) const
  {
    const int column = this->wrap(i);
    const int row = this->wrap(j);
    const double shiftX = this->turns(i) - x;
    const double shiftY = this->turns(j) - y;
    for (const int index : this->members[static_cast<std::size_t>(row) * this->cells + column])
    {
      visit(index, this->all[index].x + shiftX, this->all[index].y + shiftY);
    }
  }

  int cells;
  std::vector<std::vector<int>> members;
  std::vector<TorusPoint> all;
};

// `count` points (1 to 131072) whose first n, for every n past the first few, are blue noise: twice
// every point lies near an earlier one, so that the first n are closed under doubling, and the
// half-size copy has a point within .35 mean spacings of all points.
std::vector<TorusPoint> nestedPoints(int count, std::uint32_t seed);

} // namespace hachure

#endif
