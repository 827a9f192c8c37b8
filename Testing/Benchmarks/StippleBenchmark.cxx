// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// hachure-stipple-benchmark: what it costs to rank stipples on a wavy surface, in both orders,
/// with one thread and two: time by the clock and of the processors, and bytes held per stipple.
/// Then for the tree of a tenth of them: to build it, to move the mesh, and to refine a part
/// 64-fold.

#include "Core/StippleHierarchy.h"
#include "Core/StippleTree.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <omp.h>
#include <vector>

namespace
{
using namespace hachure;

struct WavySurface
{
  std::vector<glm::dvec3> points;
  std::vector<glm::ivec3> triangles;

  explicit WavySurface(int triangleCount)
  {
    const int n = std::max(1, static_cast<int>(std::lround(std::sqrt(0.5 * triangleCount))));
    this->points.reserve(static_cast<std::size_t>(n + 1) * static_cast<std::size_t>(n + 1));
    this->triangles.reserve(2 * static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        const double x = static_cast<double>(i) / n;
        const double y = static_cast<double>(j) / n;
        this->points.emplace_back(x, y, 0.1 * std::sin(9.0 * x) * std::cos(7.0 * y));
      }
    }
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const int a = j * (n + 1) + i;
        this->triangles.emplace_back(a, a + 1, a + n + 2);
        this->triangles.emplace_back(a, a + n + 2, a + n + 1);
      }
    }
  }
};

void measure(const WavySurface& surface, StippleOrder order, std::int64_t count, int threads)
{
  using Clock = std::chrono::steady_clock;
  omp_set_num_threads(threads);
  StippleOptions options;
  options.count = count;
  options.order = order;
  const Clock::time_point start = Clock::now();
  const std::clock_t before = std::clock();
  const StippleHierarchy hierarchy =
    stippleSurface({ surface.points, surface.triangles, {} }, options);
  const double used = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  const std::chrono::duration<double> passed = Clock::now() - start;
  const auto stipples = static_cast<double>(std::max<std::size_t>(1, hierarchy.points.size()));
  std::printf("{\"order\": \"%s\", \"threads\": %d, \"triangles\": %zu, \"stipples\": %zu, "
              "\"seconds\": %.2f, \"cpu_seconds\": %.2f, \"ns_per_stipple\": %.0f, "
              "\"bytes_per_stipple\": %.1f}\n",
    order == StippleOrder::Classic ? "classic" : "progressive", threads, surface.triangles.size(),
    hierarchy.points.size(), passed.count(), used, 1e9 * passed.count() / stipples,
    static_cast<double>(hierarchy.memory()) / stipples);
}
class Timer
{
public:
  void print(const char* what, std::size_t stipples) const
  {
    const double used = static_cast<double>(std::clock() - this->before) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> passed = Clock::now() - this->start;
    std::printf("{\"tree\": \"%s\", \"stipples\": %zu, \"seconds\": %.3f, \"cpu_seconds\": %.3f}\n",
      what, stipples, passed.count(), used);
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start = Clock::now();
  std::clock_t before = std::clock();
};

// Until all nodes that reach into the corner of the surface hold the density.
void refineCorner(StippleTree& tree, double density)
{
  constexpr double side = 0.1;
  std::vector<StippleRequest> requests;
  do
  {
    requests.clear();
    for (std::size_t i = 0; i < tree.nodes().size(); ++i)
    {
      const StippleNode& node = tree.nodes()[i];
      if (node.childCount == 0 && node.heldDensity < density && node.bounds.low.x < side &&
        node.bounds.low.y < side)
      {
        requests.push_back({ static_cast<std::int32_t>(i), density });
      }
    }
  } while (!requests.empty() && tree.refine(requests));
}

void measureTree(const WavySurface& surface, std::int64_t count)
{
  const TriangleMesh mesh{ surface.points, surface.triangles, {} };
  StippleOptions options;
  options.count = count;
  const StippleHierarchy base = stippleSurface(mesh, options);
  const Timer building;
  StippleTree tree(mesh, base);
  building.print("build", base.points.size());
  const std::size_t nodes = tree.nodes().size();
  const Timer refining;
  refineCorner(tree, 64.0 * static_cast<double>(base.points.size()) / base.area);
  std::size_t made = 0;
  for (std::size_t i = nodes; i < tree.nodes().size(); ++i)
  {
    made += static_cast<std::size_t>(tree.nodes()[i].count);
  }
  refining.print("refine", made);
  const Timer moving;
  tree.setPositions(surface.points);
  moving.print("move", base.points.size() + made);
}
} // namespace

int main(int argumentCount, char** arguments)
{
  const long stipples = argumentCount > 1 ? std::atol(arguments[1]) : 1000000;
  const int triangles = argumentCount > 2 ? std::atoi(arguments[2]) : 500000;
  if (stipples < 1 || stipples > (1 << 27) || triangles < 2 || argumentCount > 3)
  {
    std::fputs("usage: hachure-stipple-benchmark [stipples [triangles]]\n", stderr);
    return 2;
  }
  const WavySurface surface(triangles);
  for (const int threads : { 1, 2 })
  {
    measure(surface, StippleOrder::Progressive, stipples, threads);
    measure(surface, StippleOrder::Classic, stipples, threads);
  }
  measureTree(surface, std::max(1l, stipples / 10));
  return 0;
}
