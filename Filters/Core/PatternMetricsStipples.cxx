// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternMetricsStipples.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{

namespace
{

constexpr int ringsPerPrincipal = 8;
constexpr int ringCount = 2 * ringsPerPrincipal;
constexpr std::size_t fewestPoints = 16;
constexpr std::size_t mostPoints = 100000;

void checkPoints(Span<const glm::dvec2> points, const StippleWindow& window)
{
  if (!(window.size.x > 0.0 && window.size.y > 0.0 && std::isfinite(window.size.x) &&
        std::isfinite(window.size.y)))
  {
    throw std::invalid_argument("window: " + std::to_string(window.size.x) + " x " +
      std::to_string(window.size.y) + ", expected sizes above 0");
  }
  if (points.size() < fewestPoints || points.size() > mostPoints)
  {
    throw std::invalid_argument("points: " + std::to_string(points.size()) + ", expected " +
      std::to_string(fewestPoints) + " to " + std::to_string(mostPoints));
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const glm::dvec2 place = (points[i] - window.origin) / window.size;
    constexpr double rounding = 1e-6;
    if (!(place.x >= -rounding && place.y >= -rounding && place.x <= 1.0 + rounding &&
          place.y <= 1.0 + rounding))
    {
      throw std::invalid_argument("points: point " + std::to_string(i) + " is (" +
        std::to_string(points[i].x) + ", " + std::to_string(points[i].y) +
        "), expected one inside the window");
    }
  }
}

// ---- Spectrum ----------------------------------------------------------------------------------

// Powers of the frequencies (x, y) / size of the window, x = -columns..columns. At these the window
// itself has no power, so that they need no correction, periodic or not.
std::vector<double> rowOfPowers(
  Span<const glm::dvec2> points, const StippleWindow& window, int columns, int y)
{
  std::vector<std::complex<double>> sums(static_cast<std::size_t>(2 * columns + 1));
  const double turn = 2.0 * std::acos(-1.0);
  for (const glm::dvec2& point : points)
  {
    const glm::dvec2 place = (point - window.origin) / window.size;
    const std::complex<double> step = std::polar(1.0, -turn * place.x);
    std::complex<double> value = std::polar(1.0, -turn * (y * place.y - columns * place.x));
    const double re = step.real();
    const double im = step.imag();
    for (std::complex<double>& sum : sums)
    {
      sum += value;
      value = { value.real() * re - value.imag() * im, value.real() * im + value.imag() * re };
    }
  }
  std::vector<double> powers;
  powers.reserve(sums.size());
  for (const std::complex<double>& sum : sums)
  {
    powers.push_back(std::norm(sum) / static_cast<double>(points.size()));
  }
  return powers;
}

struct RingSums
{
  double count = 0.0, power = 0.0, squares = 0.0;

  // Variance / mean^2; unbiased, so that a ring of few frequencies is not called isotropic.
  double anisotropy() const
  {
    if (this->count < 2.0 || this->power <= 0.0)
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    const double mean = this->power / this->count;
    return (this->squares - this->count * mean * mean) / (this->count - 1.0) / (mean * mean);
  }
};

double decibels(double ratio)
{
  return 10.0 * std::log10(std::max(ratio, 1e-12));
}

void measureSpectrum(
  Span<const glm::dvec2> points, const StippleWindow& window, StippleMetrics& metrics)
{
  const double principal =
    std::sqrt(static_cast<double>(points.size()) / (window.size.x * window.size.y));
  const int columns = static_cast<int>(2.0 * principal * window.size.x);
  const int rows = static_cast<int>(2.0 * principal * window.size.y);
  std::vector<std::vector<double>> powers(static_cast<std::size_t>(rows + 1));
  parallelForRanges(rows + 1, 1,
    [&](std::int64_t y, std::int64_t)
    {
      powers[static_cast<std::size_t>(y)] =
        rowOfPowers(points, window, columns, static_cast<int>(y));
    });
  std::vector<RingSums> rings(ringCount);
  for (int y = 0; y <= rows; ++y)
  {
    for (int x = y == 0 ? 1 : -columns; x <= columns; ++x) // half of the plane, without 0
    {
      const double frequency = std::hypot(x / window.size.x, y / window.size.y) / principal;
      const auto ring = static_cast<std::size_t>(frequency * ringsPerPrincipal);
      if (ring < rings.size())
      {
        const int column = x + columns;
        const double power = powers[static_cast<std::size_t>(y)][static_cast<std::size_t>(column)];
        rings[ring].count += 1.0;
        rings[ring].power += power;
        rings[ring].squares += power * power;
      }
    }
  }
  RingSums low, all;
  double anisotropy = 0.0, anisotropyCount = 0.0;
  for (std::size_t k = 0; k < rings.size(); ++k)
  {
    const RingSums& ring = rings[k];
    metrics.rings.push_back(
      { (static_cast<double>(k) + 0.5) / ringsPerPrincipal, ring.power / std::max(1.0, ring.count),
        decibels(ring.anisotropy()), static_cast<int>(ring.count) });
    RingSums& band = k < ringsPerPrincipal / 2 ? low : all;
    band.count += ring.count;
    band.power += ring.power;
    if (k >= ringsPerPrincipal / 2 && ring.count >= 2.0 && ring.power > 0.0)
    {
      anisotropy += ring.count * ring.anisotropy();
      anisotropyCount += ring.count;
    }
  }
  metrics.lowFrequencyPower = low.power / std::max(1.0, low.count);
  metrics.meanPower = (low.power + all.power) / std::max(1.0, low.count + all.count);
  metrics.anisotropy = decibels(anisotropy / std::max(1.0, anisotropyCount));
}

// ---- Distances ---------------------------------------------------------------------------------

// Points by the cells of a grid, about two in each.
class PointGrid
{
public:
  PointGrid(Span<const glm::dvec2> somePoints, const StippleWindow& aWindow)
    : points(somePoints)
    , window(aWindow)
  {
    const double side =
      std::sqrt(2.0 * aWindow.size.x * aWindow.size.y / static_cast<double>(somePoints.size()));
    this->cells = glm::max(glm::ivec2(aWindow.size / side), glm::ivec2(1));
    this->members.resize(
      static_cast<std::size_t>(this->cells.x) * static_cast<std::size_t>(this->cells.y));
    for (std::size_t i = 0; i < somePoints.size(); ++i)
    {
      const glm::ivec2 cell = this->cellOf(somePoints[i]);
      this->members[this->index(cell)].push_back(i);
    }
  }

  // Distance to the nearest other point.
  double nearest(std::size_t i) const
  {
    const glm::ivec2 home = this->cellOf(this->points[i]);
    const glm::dvec2 cellSize = this->window.size / glm::dvec2(this->cells);
    double best = std::numeric_limits<double>::infinity();
    const int most = std::max(this->cells.x, this->cells.y);
    for (int reach = 0; reach <= most; ++reach)
    {
      // Cells of ring `reach` are at least (reach - 1) cells away.
      if (best <= (reach - 1) * std::min(cellSize.x, cellSize.y))
      {
        break;
      }
      for (int y = -reach; y <= reach; ++y)
      {
        const int step = std::abs(y) == reach ? 1 : std::max(1, 2 * reach);
        for (int x = -reach; x <= reach; x += step)
        {
          best = std::min(best, this->nearestInCell(i, home + glm::ivec2(x, y)));
        }
      }
    }
    return best;
  }

private:
  glm::ivec2 cellOf(glm::dvec2 point) const
  {
    const glm::dvec2 place = (point - this->window.origin) / this->window.size;
    return glm::clamp(
      glm::ivec2(glm::floor(place * glm::dvec2(this->cells))), glm::ivec2(0), this->cells - 1);
  }
  std::size_t index(glm::ivec2 cell) const
  {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(this->cells.x) +
      static_cast<std::size_t>(cell.x);
  }
  double nearestInCell(std::size_t i, glm::ivec2 cell) const
  {
    const bool inside =
      cell.x >= 0 && cell.y >= 0 && cell.x < this->cells.x && cell.y < this->cells.y;
    if (!inside && !this->window.periodic)
    {
      return std::numeric_limits<double>::infinity();
    }
    const glm::ivec2 wrapped = ((cell % this->cells) + this->cells) % this->cells;
    double best = std::numeric_limits<double>::infinity();
    for (const std::size_t other : this->members[this->index(wrapped)])
    {
      if (other != i)
      {
        glm::dvec2 offset = this->points[other] - this->points[i];
        if (this->window.periodic)
        {
          offset -= this->window.size * glm::round(offset / this->window.size);
        }
        best = std::min(best, glm::length(offset));
      }
    }
    return best;
  }

  Span<const glm::dvec2> points;
  StippleWindow window;
  glm::ivec2 cells{ 1 };
  std::vector<std::vector<std::size_t>> members;
};

void measureDistances(
  Span<const glm::dvec2> points, const StippleWindow& window, StippleMetrics& metrics)
{
  const PointGrid grid(points, window);
  std::vector<double> distances(points.size());
  parallelFor(static_cast<std::int64_t>(points.size()),
    [&](std::int64_t i)
    { distances[static_cast<std::size_t>(i)] = grid.nearest(static_cast<std::size_t>(i)); });
  double sum = 0.0;
  for (const double distance : distances)
  {
    sum += distance;
  }
  const double count = static_cast<double>(points.size());
  const double area = window.size.x * window.size.y;
  double expected = 0.5 * std::sqrt(area / count); // of white noise
  if (!window.periodic)
  {
    // At the edge the nearest point may lie outside, so that distances grow (Donnelly 1978).
    const double edge = 2.0 * (window.size.x + window.size.y);
    expected += (0.0514 + 0.041 / std::sqrt(count)) * edge / count;
  }
  metrics.clarkEvans = sum / count / expected;
  metrics.relativeRadius = *std::min_element(distances.begin(), distances.end()) /
    std::sqrt(2.0 * area / (std::sqrt(3.0) * count));
}

std::vector<std::pair<double, double>> sortedPlaces(Span<const glm::dvec2> points)
{
  std::vector<std::pair<double, double>> places;
  for (const glm::dvec2& point : points)
  {
    places.emplace_back(point.x, point.y);
  }
  std::sort(places.begin(), places.end());
  return places;
}

} // namespace

StippleMetrics measureStipples(Span<const glm::dvec2> points, const StippleWindow& window)
{
  checkPoints(points, window);
  StippleMetrics metrics{};
  measureSpectrum(points, window, metrics);
  measureDistances(points, window, metrics);
  return metrics;
}

StippleMetrics meanOfStipples(Span<const StippleMetrics> sets)
{
  if (sets.empty())
  {
    throw std::invalid_argument("sets: none, expected at least one");
  }
  StippleMetrics mean{};
  const double share = 1.0 / static_cast<double>(sets.size());
  mean.rings = sets.front().rings;
  for (std::size_t k = 0; k < mean.rings.size(); ++k)
  {
    double power = 0.0, ratio = 0.0;
    for (const StippleMetrics& set : sets)
    {
      power += share * set.rings[k].power;
      ratio += share * std::pow(10.0, 0.1 * set.rings[k].anisotropy);
    }
    mean.rings[k].power = power;
    mean.rings[k].anisotropy = decibels(ratio);
  }
  double ratio = 0.0;
  for (const StippleMetrics& set : sets)
  {
    mean.lowFrequencyPower += share * set.lowFrequencyPower;
    mean.meanPower += share * set.meanPower;
    mean.clarkEvans += share * set.clarkEvans;
    mean.relativeRadius += share * set.relativeRadius;
    ratio += share * std::pow(10.0, 0.1 * set.anisotropy);
  }
  mean.anisotropy = decibels(ratio);
  return mean;
}

double nesting(Span<const glm::dvec2> first, Span<const glm::dvec2> second)
{
  if (first.empty() || second.empty())
  {
    return 1.0;
  }
  const auto a = sortedPlaces(first);
  const auto b = sortedPlaces(second);
  std::vector<std::pair<double, double>> shared;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
  return static_cast<double>(shared.size()) / static_cast<double>(std::min(a.size(), b.size()));
}

} // namespace hachure
