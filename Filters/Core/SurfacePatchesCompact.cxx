// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePatches.h"

#include "Parallel.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{
/// What stands for a patch: the means of its faces, weighted by area.
struct Proxy
{
  glm::dvec3 centroid{ 0.0 };
  glm::dvec3 normal{ 0.0 };
};

/// A face that could join a patch. The lowest cost goes first; ties are settled by numbers.
struct Candidate
{
  double cost = 0.0;
  std::int32_t item = 0;
  std::int32_t patch = 0;

  bool operator<(const Candidate& other) const
  {
    return cost != other.cost ? cost > other.cost
      : item != other.item    ? item > other.item
                              : patch > other.patch;
  }
};

/// Divides some faces of a surface. An item is the position of a face in the list of these.
class FaceDivision
{
public:
  FaceDivision(const FaceGraph& someGraph, Span<const FaceShape> someShapes,
    Span<const std::int32_t> someFaces, const CompactOptions& someOptions)
    : graph(someGraph)
    , shapes(someShapes)
    , faces(someFaces)
    , options(someOptions)
    , itemOfFace(someShapes.size(), -1)
    , patches(someFaces.size(), -1)
  {
    double area = 0.0;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      itemOfFace[faces[i]] = static_cast<std::int32_t>(i);
      area += shapes[faces[i]].area;
    }
    patchCount = static_cast<std::int32_t>(
      std::min<std::size_t>(static_cast<std::size_t>(options.patches), faces.size()));
    // The squared radius of a disc of a patch's mean area; anything positive without area.
    const double pi = 3.14159265358979323846;
    const double squaredRadius = area / (pi * std::max(1, patchCount));
    distanceScale =
      squaredRadius > 0.0 && std::isfinite(1.0 / squaredRadius) ? 1.0 / squaredRadius : 1.0;
    turnScale = options.normalWeight;
  }

  std::vector<std::int32_t> run()
  {
    findPieces();
    placeSeeds();
    std::vector<std::int32_t> previous;
    for (int iteration = 0; iteration < options.iterations; ++iteration)
    {
      if (options.progress &&
        !options.progress(static_cast<double>(iteration) / options.iterations))
      {
        return {};
      }
      grow();
      takeLeftPieces();
      fitProxies();
      if (iteration + 1 == options.iterations || !moveSeeds())
      {
        break;
      }
    }
    return std::move(patches);
  }

private:
  const FaceShape& shape(std::size_t item) const { return shapes[faces[item]]; }

  double cost(std::size_t item, const Proxy& proxy) const
  {
    const glm::dvec3 way = shape(item).centroid - proxy.centroid;
    const glm::dvec3 turn = shape(item).normal - proxy.normal;
    return distanceScale * glm::dot(way, way) + turnScale * glm::dot(turn, turn);
  }

  template <class Body>
  void forEachNeighbour(std::int32_t item, Body&& body) const
  {
    for (const FaceNeighbour& neighbour : graph.neighbours(faces[item]))
    {
      if (itemOfFace[neighbour.face] >= 0)
      {
        body(itemOfFace[neighbour.face]);
      }
    }
  }

  void findPieces()
  {
    pieces.assign(faces.size(), -1);
    std::vector<std::int32_t> stack;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      if (pieces[i] >= 0)
      {
        continue;
      }
      pieces[i] = pieceCount++;
      stack.push_back(static_cast<std::int32_t>(i));
      while (!stack.empty())
      {
        const std::int32_t item = stack.back();
        stack.pop_back();
        forEachNeighbour(item,
          [&](std::int32_t other)
          {
            if (pieces[other] < 0)
            {
              pieces[other] = pieces[item];
              stack.push_back(other);
            }
          });
      }
    }
  }

  /// Places for seeds: evenly spread over the area along the order of the faces, since looking at
  /// all faces for every seed would cost faces times patches.
  std::vector<std::int32_t> seedPlaces() const
  {
    const std::size_t placesPerPatch = 32;
    const std::size_t mostPlaces =
      std::max<std::size_t>(10000, placesPerPatch * static_cast<std::size_t>(patchCount));
    double area = 0.0;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      area += shape(i).area;
    }
    std::vector<std::int32_t> places;
    double sum = 0.0;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      sum += shape(i).area;
      if (faces.size() <= mostPlaces ||
        sum * static_cast<double>(mostPlaces) > area * static_cast<double>(places.size()))
      {
        places.push_back(static_cast<std::int32_t>(i));
      }
    }
    for (std::size_t i = 0; places.size() < static_cast<std::size_t>(patchCount); ++i)
    {
      places.push_back(static_cast<std::int32_t>(i)); // nearly all faces are without area
    }
    return places;
  }

  /// One seed in every piece if they suffice, then always the place farthest from all seeds.
  void placeSeeds()
  {
    if (pieceCount <= patchCount)
    {
      std::int32_t next = 0;
      for (std::size_t i = 0; i < faces.size() && next < pieceCount; ++i)
      {
        if (pieces[i] == next)
        {
          seeds.push_back(static_cast<std::int32_t>(i));
          ++next;
        }
      }
    }
    else
    {
      seeds.push_back(largestItem());
    }
    const std::vector<std::int32_t> places = seedPlaces();
    std::vector<double> distances(places.size(), std::numeric_limits<double>::max());
    for (std::size_t seed = 0; seed < seeds.size() || seeds.size() < wanted(); ++seed)
    {
      const Proxy proxy = proxyOf(seeds[seed]);
      parallelFor(static_cast<std::int64_t>(places.size()),
        [&](std::int64_t i)
        {
          // A seed itself is never taken again, whatever lies in its place.
          distances[i] = places[i] == seeds[seed]
            ? -1.0
            : std::min(distances[i], cost(static_cast<std::size_t>(places[i]), proxy));
        });
      if (seed + 1 == seeds.size() && seeds.size() < wanted())
      {
        const auto farthest = std::max_element(distances.begin(), distances.end());
        seeds.push_back(*farthest < 0.0 ? unusedItem() : places[farthest - distances.begin()]);
      }
    }
    proxies.resize(seeds.size());
    for (std::size_t i = 0; i < seeds.size(); ++i)
    {
      proxies[i] = proxyOf(seeds[i]);
    }
  }

  std::size_t wanted() const { return static_cast<std::size_t>(patchCount); }
  Proxy proxyOf(std::int32_t item) const
  {
    return { shape(static_cast<std::size_t>(item)).centroid,
      shape(static_cast<std::size_t>(item)).normal };
  }

  std::int32_t largestItem() const
  {
    std::size_t best = 0;
    for (std::size_t i = 1; i < faces.size(); ++i)
    {
      best = shape(i).area > shape(best).area ? i : best;
    }
    return static_cast<std::int32_t>(best);
  }

  std::int32_t unusedItem() const
  {
    std::int32_t item = 0;
    while (std::find(seeds.begin(), seeds.end(), item) != seeds.end())
    {
      ++item;
    }
    return item;
  }

  void grow()
  {
    std::fill(patches.begin(), patches.end(), -1);
    std::priority_queue<Candidate> queue;
    const auto add = [&](std::int32_t item, std::int32_t patch)
    {
      patches[item] = patch;
      forEachNeighbour(item,
        [&](std::int32_t other)
        {
          if (patches[other] < 0)
          {
            queue.push({ cost(static_cast<std::size_t>(other), proxies[patch]), other, patch });
          }
        });
    };
    for (std::size_t i = 0; i < seeds.size(); ++i)
    {
      patches[seeds[i]] = static_cast<std::int32_t>(i); // no seed is overrun
    }
    for (std::size_t i = 0; i < seeds.size(); ++i)
    {
      add(seeds[i], static_cast<std::int32_t>(i));
    }
    while (!queue.empty())
    {
      const Candidate best = queue.top();
      queue.pop();
      if (patches[best.item] < 0)
      {
        add(best.item, best.patch);
      }
    }
  }

  /// Pieces that hold no seed join the patch that is nearest to their means.
  void takeLeftPieces()
  {
    if (pieceCount <= patchCount)
    {
      return;
    }
    std::vector<Proxy> means(static_cast<std::size_t>(pieceCount));
    std::vector<double> areas(means.size(), 0.0);
    std::vector<std::int32_t> first(means.size(), -1);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      Proxy& mean = means[pieces[i]];
      mean.centroid += shape(i).area * shape(i).centroid;
      mean.normal += shape(i).area * shape(i).normal;
      areas[pieces[i]] += shape(i).area;
      first[pieces[i]] = first[pieces[i]] < 0 ? static_cast<std::int32_t>(i) : first[pieces[i]];
    }
    parallelFor(static_cast<std::int64_t>(means.size()),
      [&](std::int64_t piece)
      {
        Proxy& mean = means[piece];
        mean = areas[piece] > 0.0
          ? Proxy{ mean.centroid / areas[piece], mean.normal / areas[piece] }
          : proxyOf(first[piece]);
        first[piece] = patches[first[piece]] < 0 ? nearestPatch(mean) : -1;
      });
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      patches[i] = patches[i] < 0 ? first[pieces[i]] : patches[i];
    }
  }

  std::int32_t nearestPatch(const Proxy& mean) const
  {
    std::size_t best = 0;
    double lowest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < proxies.size(); ++i)
    {
      const glm::dvec3 way = mean.centroid - proxies[i].centroid;
      const glm::dvec3 turn = mean.normal - proxies[i].normal;
      const double value = distanceScale * glm::dot(way, way) + turnScale * glm::dot(turn, turn);
      if (value < lowest)
      {
        lowest = value;
        best = i;
      }
    }
    return static_cast<std::int32_t>(best);
  }

  /// Whether an item lies in the same piece as the seed of its patch. Pieces that joined later
  /// neither move the patch nor draw its seed to them.
  bool besideSeed(std::size_t item) const { return pieces[item] == pieces[seeds[patches[item]]]; }

  void fitProxies()
  {
    std::vector<Proxy> sums(proxies.size());
    std::vector<double> areas(proxies.size(), 0.0);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      if (!besideSeed(i))
      {
        continue;
      }
      sums[patches[i]].centroid += shape(i).area * shape(i).centroid;
      sums[patches[i]].normal += shape(i).area * shape(i).normal;
      areas[patches[i]] += shape(i).area;
    }
    for (std::size_t i = 0; i < proxies.size(); ++i)
    {
      if (areas[i] > 0.0)
      {
        proxies[i] = { sums[i].centroid / areas[i], sums[i].normal / areas[i] };
      }
    }
  }

  /// The face nearest to its proxy becomes the seed of every patch. False when the sum of all costs
  /// hardly falls any more.
  bool moveSeeds()
  {
    const double leastGain = 0.01; // further iterations move borders by less than anyone sees
    std::vector<double> lowest(proxies.size(), std::numeric_limits<double>::max());
    double sum = 0.0;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      const double value = cost(i, proxies[patches[i]]);
      sum += shape(i).area * value;
      if (value < lowest[patches[i]] && besideSeed(i))
      {
        lowest[patches[i]] = value;
        seeds[patches[i]] = static_cast<std::int32_t>(i);
      }
    }
    const bool gains = sum < (1.0 - leastGain) * totalCost;
    totalCost = sum;
    return gains;
  }

  const FaceGraph& graph;
  Span<const FaceShape> shapes;
  Span<const std::int32_t> faces;
  const CompactOptions& options;
  std::vector<std::int32_t> itemOfFace;
  std::vector<std::int32_t> patches; // per item
  std::vector<std::int32_t> pieces;  // per item: what hangs together by edges
  std::int32_t pieceCount = 0;
  std::int32_t patchCount = 0;
  double distanceScale = 1.0;
  double turnScale = 1.0;
  std::vector<std::int32_t> seeds; // per patch, an item
  std::vector<Proxy> proxies;
  double totalCost = std::numeric_limits<double>::max();
};

void checkOptions(const CompactOptions& options)
{
  const auto require = [](bool valid, const char* name, double value, const char* expected)
  {
    if (!valid)
    {
      throw std::invalid_argument(
        std::string(name) + " is " + std::to_string(value) + ", expected " + expected);
    }
  };
  require(options.patches >= 1, "patches", options.patches, "1 or more");
  require(options.normalWeight >= 0.0 && std::isfinite(options.normalWeight), "normalWeight",
    options.normalWeight, "0 or more");
  require(options.iterations >= 1, "iterations", options.iterations, "1 or more");
}
} // namespace

std::vector<std::int32_t> divideFaces(const FaceGraph& graph, Span<const FaceShape> shapes,
  Span<const std::int32_t> faces, const CompactOptions& options)
{
  checkOptions(options);
  return faces.empty() ? std::vector<std::int32_t>()
                       : FaceDivision(graph, shapes, faces, options).run();
}

std::vector<std::int32_t> compactPatches(const FaceSurface& surface, const CompactOptions& options)
{
  checkFaceSurface(surface);
  checkOptions(options);
  const FaceGraph graph(surface);
  const std::vector<FaceShape> shapes = faceShapes(surface);
  std::vector<std::int32_t> faces(shapes.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    faces[i] = static_cast<std::int32_t>(i);
  }
  std::vector<std::int32_t> patches = divideFaces(graph, shapes, faces, options);
  numberByLowestFace(patches);
  return patches;
}
} // namespace hachure
