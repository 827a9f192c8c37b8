// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// hachure-stipple-benchmark: what it costs to rank stipples on a wavy surface, in both orders,
/// with one thread and two: time by the clock and of the processors, and bytes held per stipple.
/// Then for their tree: to build it, to move the mesh, to find the stipples of a picture of 1280 x
/// 720 pixels and to cover its pixels; and to refine a part of the tree of a tenth of them 64-fold.

#include "Core/StippleDrawing.h"
#include "Core/StippleHierarchy.h"
#include "Core/StippleTree.h"

#include <glm/gtc/matrix_transform.hpp>

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

// The surface from above, in a tone that grows from paper to ink; the best of some pictures.
void measureDrawing(StippleTree& tree, std::size_t stored)
{
  constexpr int width = 1280, height = 720, pictures = 7;
  std::vector<std::uint8_t> tones(static_cast<std::size_t>(width) * height);
  for (std::size_t i = 0; i < tones.size(); ++i)
  {
    tones[i] = static_cast<std::uint8_t>(i % width * 255 / width);
  }
  StippleScene scene;
  scene.view.modelToClip = glm::ortho(0.0, 1.0, 0.0, 1.0, -1.0, 1.0);
  scene.view.viewportSize = { width, height };
  scene.rectangle = { 0, 0, width, height };
  scene.tones = tones;
  for (std::size_t i = 0; i < scene.toneOf.size(); ++i)
  {
    scene.toneOf[i] = static_cast<float>(i) / 255.0f;
  }
  double finding = 1e9, covering = 1e9;
  std::vector<DrawnStipple> drawn;
  StippleCanvas canvas;
  std::vector<StippleDisc> discs;
  std::vector<std::uint8_t> covered;
  for (int picture = 0; picture < pictures; ++picture)
  {
    std::clock_t before = std::clock();
    drawStipples(tree, StippleDrawing(scene, {}), false, drawn);
    finding = std::min(finding, static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    discs.clear();
    discs.reserve(drawn.size());
    for (const DrawnStipple& stipple : drawn)
    {
      discs.push_back(stipple.disc);
    }
    before = std::clock();
    canvas.draw(discs, width, height, covered);
    covering = std::min(covering, static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  }
  std::printf("{\"picture\": \"%d x %d\", \"stipples\": %zu, \"drawn\": %zu, "
              "\"find_cpu_ms\": %.2f, \"find_ns_per_stipple\": %.1f, \"cover_cpu_ms\": %.2f}\n",
    width, height, stored, drawn.size(), 1e3 * finding, 1e9 * finding / static_cast<double>(stored),
    1e3 * covering);
}

StippleTree makeTree(const WavySurface& surface, std::int64_t count)
{
  const TriangleMesh mesh{ surface.points, surface.triangles, {} };
  StippleOptions options;
  options.count = count;
  const StippleHierarchy base = stippleSurface(mesh, options);
  const Timer building;
  StippleTree tree(mesh, base);
  building.print("build", base.points.size());
  return tree;
}

std::size_t stipplesFrom(const StippleTree& tree, std::size_t firstNode)
{
  std::size_t count = 0;
  for (std::size_t i = firstNode; i < tree.nodes().size(); ++i)
  {
    count += static_cast<std::size_t>(tree.nodes()[i].count);
  }
  return count;
}

void measureTree(const WavySurface& surface, std::int64_t count)
{
  StippleTree tree = makeTree(surface, count);
  const std::size_t stored = stipplesFrom(tree, 0);
  measureDrawing(tree, stored);
  const Timer moving;
  tree.setPositions(surface.points);
  moving.print("move", stored);
}

void measureRefinement(const WavySurface& surface, std::int64_t count)
{
  StippleTree tree = makeTree(surface, count);
  const std::size_t nodes = tree.nodes().size();
  const Timer refining;
  // The wavy surface has about the area 1.
  refineCorner(tree, 64.0 * static_cast<double>(count));
  refining.print("refine", stipplesFrom(tree, nodes));
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
  measureTree(surface, stipples);
  measureRefinement(surface, std::max(1l, stipples / 10));
  return 0;
}
