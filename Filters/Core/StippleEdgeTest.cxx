// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleEdgeTest.h"

#include "Parallel.h"
#include "StippleTone.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double leastDensity = 1e-300;

// The shortest edge of a point in the picture, pixels.
double shortestEdge(
  const StippleEdges& edges, const std::vector<glm::dvec3>& projections, std::size_t rank)
{
  const glm::dvec3& own = projections[rank];
  double square = endless;
  for (const std::int32_t neighbour : edges.neighbours(rank))
  {
    const glm::dvec3& other = projections[static_cast<std::size_t>(neighbour)];
    if (other.z > 0.0)
    {
      const glm::dvec2 edge(other.x - own.x, other.y - own.y);
      square = std::min(square, glm::dot(edge, edge));
    }
  }
  return std::sqrt(square);
}

// Toward the end by a step, of which the end is a whole number away but for rounding.
float grownBy(float step, float before, float end)
{
  if (before < 0.0f || std::abs(end - before) < 1.5f * step)
  {
    return end;
  }
  return before + (end > before ? step : -step);
}

} // namespace

// The grown discs, and the threshold of the edges of those that are drawn, pixels.
struct StippleEdgeTest::Wanted
{
  double diameter, threshold;
};

struct StippleEdgeTest::Verdict
{
  bool isSeen;
  StippleDisc disc;       // where it is fully grown
  float nearest;          // as of the drawn stipple
  double edgeOfThreshold; // shortest edge over the threshold
};

StippleEdgeTest::StippleEdgeTest(const StippleScene& someScene, const StippleLook& someLook)
  : StipplePicture(someScene)
  , look(someLook)
{
  checkStippleLook(this->look);
}

StippleEdgeTest::Projections StippleEdgeTest::project(const StippleEdges& edges) const
{
  Projections projections(edges.size());
  parallelFor(static_cast<std::int64_t>(edges.size()),
    [&](std::int64_t i)
    {
      const auto rank = static_cast<std::size_t>(i);
      const glm::dvec4 place(edges.places()[rank], 1.0);
      const double w = glm::dot(this->rowW, place);
      projections[rank] = { glm::dot(this->rowX, place) / w, glm::dot(this->rowY, place) / w, w };
    });
  return projections;
}

// Thresholds are of a surface that faces the viewer, in the reference's units.
StippleEdgeTest::Wanted StippleEdgeTest::wantedAt(
  const Place& place, float areaRatio, const StippleThresholds& thresholds) const
{
  const auto diameter = static_cast<double>(this->look.diameter);
  const auto growth = static_cast<float>(thresholds.growth());
  const float ink = std::clamp(this->scene.toneOf[this->toneAt(place.x, place.y)], 0.0f, 1.0f);
  const auto perPixel = static_cast<double>(place.perPixel * areaRatio); // of the reference
  if (!(ink > 0.0f) || !std::isfinite(perPixel))
  {
    return { diameter, endless };
  }
  auto area = static_cast<double>(stippleClassicDiscArea(ink, place.facing, growth));
  double magnified = 1.0;
  if (this->look.toneBySize)
  {
    const auto most = static_cast<double>(stippleClassicDiscArea(1.0f, place.facing, growth));
    magnified = std::sqrt(area / most);
    area = most;
  }
  constexpr double discOfSquare = 0.78539816339745; // area of a disc over that of its square
  const double density = area / (discOfSquare * diameter * diameter * perPixel);
  const double used = density / std::max(thresholds.highest(), leastDensity);
  const auto lack = static_cast<double>(stippleEdgeLack(place.facing, static_cast<float>(used)));
  magnified *= std::sqrt(std::max(used, 1.0) / (1.0 - lack));
  const double tilt =
    std::sqrt(static_cast<double>(stippleEdgeCrowd(place.facing) / stippleEdgeCrowd(1.0f)));
  return { diameter * magnified, thresholds.threshold(density) * tilt / std::sqrt(perPixel) };
}

StippleEdgeTest::Verdict StippleEdgeTest::judge(const StippleEdges& edges,
  const StippleThresholds& thresholds, const Projections& projections, std::size_t rank) const
{
  const glm::dvec3& own = projections[rank];
  const double width = this->scene.rectangle[2], height = this->scene.rectangle[3];
  if (!(own.z > 0.0) || !std::isfinite(own.x + own.y))
  {
    return {};
  }
  const double shortest = shortestEdge(edges, projections, rank);
  // A disc is never larger than this in comparison with the edges.
  constexpr double mostRadius = 2.0;
  const double margin =
    std::max(0.5 * static_cast<double>(this->look.diameter), mostRadius * shortest);
  const bool isNear =
    own.x > -margin && own.y > -margin && own.x < width + margin && own.y < height + margin;
  Place place;
  const Rows rows = isNear ? this->rowsAt(edges.places()[rank]) : Rows();
  const glm::vec3& normal = edges.normals()[rank];
  if (!isNear || !locate(rows, glm::vec3(0.0f), normal, place))
  {
    return {};
  }
  const Wanted wanted = this->wantedAt(place, edges.areaRatios()[rank], thresholds);
  const double radius = 0.5 * wanted.diameter;
  if (!(own.x > -radius && own.y > -radius && own.x < width + radius && own.y < height + radius))
  {
    return {};
  }
  this->setDepth(rows, normal, place);
  const float visible = this->visibleShare(place);
  return { visible > 0.0f,
    { static_cast<float>(own.x), static_cast<float>(own.y), static_cast<float>(radius) * visible },
    place.depth - place.tolerance,
    std::isfinite(wanted.threshold) ? shortest / wanted.threshold : 0.0 };
}

// size(rank, verdict): 0 to 1.
template <class Size>
void StippleEdgeTest::drawAll(const StippleEdges& edges, const StippleThresholds& thresholds,
  const Size& size, std::vector<DrawnStipple>& drawn) const
{
  const Projections projections = this->project(edges);
  constexpr std::int64_t grain = 512;
  const auto count = static_cast<std::int64_t>(edges.size());
  std::vector<std::vector<DrawnStipple>> parts(static_cast<std::size_t>(count / grain + 1));
  parallelForRanges(count, grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<DrawnStipple>& part = parts[static_cast<std::size_t>(begin / grain)];
      for (std::int64_t i = begin; i < end; ++i)
      {
        const auto rank = static_cast<std::size_t>(i);
        const Verdict verdict = this->judge(edges, thresholds, projections, rank);
        StippleDisc disc = verdict.disc;
        disc.radius *= size(rank, verdict);
        if (verdict.isSeen && disc.radius > leastRadius)
        {
          part.push_back({ disc, -1, static_cast<std::int32_t>(rank), verdict.nearest });
        }
      }
    });
  drawn.clear();
  for (const std::vector<DrawnStipple>& part : parts)
  {
    drawn.insert(drawn.end(), part.begin(), part.end());
  }
}

void StippleEdgeTest::draw(const StippleEdges& edges, std::vector<DrawnStipple>& drawn) const
{
  const auto growth = static_cast<double>(this->look.growth);
  const auto size = [&](std::size_t, const Verdict& verdict)
  { return static_cast<float>(std::clamp((verdict.edgeOfThreshold - 1.0) / growth, 0.0, 1.0)); };
  this->drawAll(edges, StippleThresholds(edges.lengths(), growth), size, drawn);
}

void StippleEdgeTest::draw(
  const StippleEdges& edges, StippleSizes& sizes, std::vector<DrawnStipple>& drawn) const
{
  if (!sizes.before.empty() && sizes.before.size() != edges.size())
  {
    throw std::invalid_argument("sizes.before: " + std::to_string(sizes.before.size()) +
      ", expected " + std::to_string(edges.size()));
  }
  if (!(sizes.step > 0.0f))
  {
    throw std::invalid_argument(
      "sizes.step is " + std::to_string(sizes.step) + ", expected more than 0");
  }
  constexpr float notSeen = -1.0f;
  sizes.after.assign(edges.size(), notSeen);
  const auto size = [&](std::size_t rank, const Verdict& verdict)
  {
    const float before = sizes.before.empty() ? notSeen : sizes.before[rank];
    const float after = grownBy(sizes.step, before, verdict.edgeOfThreshold > 1.0 ? 1.0f : 0.0f);
    sizes.after[rank] = verdict.isSeen ? after : notSeen;
    return verdict.isSeen ? after : 0.0f;
  };
  this->drawAll(edges, StippleThresholds(edges.lengths(), 0.0), size, drawn);
}

} // namespace hachure
