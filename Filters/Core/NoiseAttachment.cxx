// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseAttachment.h"

#include "NoisePlace.h"
#include "NoiseProjection.h"
#include "NoiseTransfer.h"
#include "Parallel.h"
#include "Random.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <utility>

namespace hachure
{

namespace
{

constexpr double pi = 3.14159265358979323846;
// How far a point may be carried, in diameters of the old surface.
constexpr double reachShare = 0.1;
constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t always = std::numeric_limits<std::int64_t>::min();

// Changes over which points fade.
std::int64_t fadeOf(int life)
{
  return (life + 1) / 2;
}

// Places in the tree by triangle of the mesh.
std::vector<std::int32_t> facetsOf(const NoiseSurfaceTree& tree)
{
  std::vector<std::int32_t> facets(tree.facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i)
  {
    facets[tree.facets[i].index] = static_cast<std::int32_t>(i);
  }
  return facets;
}

std::unordered_set<std::uint64_t> idsOf(const std::vector<NoisePoint>& points)
{
  std::unordered_set<std::uint64_t> ids(2 * points.size());
  for (const NoisePoint& point : points)
  {
    ids.insert(point.id);
  }
  return ids;
}

double reachOf(const NoiseSurfaceTree& tree)
{
  return tree.nodes.empty() ? 0.0 : reachShare * 2.0 * tree.nodes.back().sphere.radius;
}

void checkLife(int life)
{
  if (life < 0)
  {
    throw std::invalid_argument("life is " + std::to_string(life) + ", expected 0 or more");
  }
}

} // namespace

// One replacement of a surface by another.
class NoiseAttachment::Change
{
public:
  Change(NoiseAttachment& attachment, NoiseSurface& next, const NoiseKernelOptions& askedFor)
    : state(attachment)
    , before(*attachment.surface)
    , after(next)
    , asked(askedFor)
    , projection(attachment.lastView, this->asked)
    , closestBefore(this->before.tree(), this->before.positions())
    , closestAfter(this->after.tree(), this->after.positions())
    , reach(reachOf(this->before.tree()))
  {
  }

  void run()
  {
    std::vector<NoiseKernel> none;
    std::vector<NoisePoint> pointsBefore = std::move(this->state.lastPoints);
    if (!this->state.lastControlled)
    {
      this->before.kernels(this->state.lastView, this->state.lastOptions, none, &pointsBefore);
    }
    std::vector<NoisePoint> pointsAfter;
    this->after.kernels(this->state.lastView, this->asked, none, &pointsAfter);
    this->collect(pointsBefore, idsOf(pointsAfter));
    std::vector<Carried> arrived = this->carry();
    this->state.own = this->termsOf(pointsAfter, idsOf(pointsBefore));
    this->state.carried = std::move(arrived);
  }

private:
  // What is carried: points of the old surface that the new one does not have.
  void collect(
    const std::vector<NoisePoint>& points, const std::unordered_set<std::uint64_t>& idsAfter)
  {
    const std::vector<std::int32_t> facets = facetsOf(this->before.tree());
    this->movers.reserve(points.size() + this->state.carried.size());
    this->moving.reserve(points.size() + this->state.carried.size());
    for (const NoisePoint& point : points)
    {
      const auto found = this->state.own.find(point.id);
      const std::int64_t arrival = found == this->state.own.end() ? always : found->second.arrival;
      if (arrival != never && idsAfter.count(point.id) == 0)
      {
        this->addMover({ facets[point.triangle], point.weights, { 1.0, 0.0 }, point.birth, point.id,
          { arrival, this->nextTurn(point.id) } });
      }
    }
    for (const Carried& point : this->state.carried)
    {
      if (this->state.change - point.term.leave < fadeOf(this->state.life))
      {
        this->addMover(point);
      }
    }
  }

  void addMover(const Carried& point)
  {
    this->moving.push_back(point);
    const NoisePlace place(this->before, this->before.tree().facets[point.facet]);
    this->movers.push_back(this->moverAt(place, point.weights));
    this->directions.push_back(place.fromEdges(point.direction));
  }

  NoiseMover moverAt(const NoisePlace& place, const glm::dvec2& weights) const
  {
    NoiseMover mover;
    mover.position = place.at(weights);
    mover.normal = place.normal;
    mover.radius = this->projection.radiusAt(mover.position);
    return mover;
  }

  std::vector<Carried> carry()
  {
    transferNoisePoints(this->closestBefore, this->closestAfter, this->reach, this->movers);
    measureNoiseGrowth(this->movers);
    std::vector<Carried> result;
    result.reserve(this->movers.size());
    for (std::size_t i = 0; i < this->movers.size(); ++i)
    {
      const NoiseMover& mover = this->movers[i];
      const bool jumps =
        mover.foot.facet < 0 || (!mover.returns && mover.foot.distance > mover.radius);
      if (!jumps)
      {
        this->land(i, result);
      }
    }
    return result;
  }

  void land(std::size_t i, std::vector<Carried>& result) const
  {
    const NoiseMover& mover = this->movers[i];
    const NoiseFacet& facet = this->after.tree().facets[mover.foot.facet];
    Carried point = this->moving[i];
    point.facet = mover.foot.facet;
    point.weights = mover.foot.weights;
    point.direction = NoisePlace(this->after, facet).inEdges(this->directions[i]);
    point.birth /= mover.growth;
    if (!mover.returns)
    {
      point.term.leave = std::min(point.term.leave, this->state.change);
    }
    NoiseKernel kernel;
    if (makeCarriedKernel(this->after, this->projection, facet,
          { facet.index, point.weights, point.birth, point.id }, point.direction, kernel))
    {
      result.push_back(point);
    }
  }

  // Of the new surface's points that do not count in full.
  std::unordered_map<std::uint64_t, Term> termsOf(
    const std::vector<NoisePoint>& points, const std::unordered_set<std::uint64_t>& idsBefore) const
  {
    const std::vector<std::int32_t> facets = facetsOf(this->after.tree());
    std::unordered_map<std::uint64_t, Term> result;
    std::vector<NoiseMover> candidates;
    std::vector<const NoisePoint*> others;
    candidates.reserve(points.size());
    others.reserve(points.size());
    for (const NoisePoint& point : points)
    {
      if (idsBefore.count(point.id) > 0)
      {
        this->keep(point.id, result);
        continue;
      }
      const NoisePlace place(this->after, this->after.tree().facets[facets[point.triangle]]);
      candidates.push_back(this->moverAt(place, point.weights));
      others.push_back(&point);
    }
    transferNoisePoints(this->closestAfter, this->closestBefore, this->reach, candidates);
    measureNoiseGrowth(candidates);
    for (std::size_t i = 0; i < others.size(); ++i)
    {
      if (this->wasInUse(candidates[i], *others[i]))
      {
        result.insert({ others[i]->id, this->termOf(others[i]->id) });
      }
    }
    return result;
  }

  // Whether the old surface had points of this density here, so that carried ones are there.
  bool wasInUse(const NoiseMover& back, const NoisePoint& point) const
  {
    if (!back.returns || this->state.lastControlled)
    {
      return back.returns;
    }
    const NoiseFacet& facet = this->before.tree().facets[back.foot.facet];
    NoiseKernel kernel;
    return makeCarriedKernel(this->before, this->projection, facet,
      { facet.index, back.foot.weights, point.birth / back.growth, point.id }, { 1.0, 0.0 },
      kernel);
  }

  // Of a point that both surfaces have.
  void keep(std::uint64_t id, std::unordered_map<std::uint64_t, Term>& terms) const
  {
    const auto found = this->state.own.find(id);
    if (found == this->state.own.end())
    {
      return;
    }
    const Term term = found->second.arrival == never ? this->termOf(id) : found->second;
    if (term.arrival == never || this->state.change - term.arrival < fadeOf(this->state.life))
    {
      terms.insert({ id, term });
    }
  }

  Term termOf(std::uint64_t id) const
  {
    return { this->nextTurn(id) == this->state.change ? this->state.change : never, never };
  }

  // The change, this one or later, in which a point comes or goes.
  std::int64_t nextTurn(std::uint64_t id) const
  {
    const auto shares = static_cast<std::uint64_t>(this->state.life);
    const std::uint64_t share = hashMix(id ^ 0x2545f4914f6cdd1dull) % shares;
    const std::uint64_t turn = static_cast<std::uint64_t>(this->state.change) % shares;
    return this->state.change + static_cast<std::int64_t>((share + shares - turn) % shares);
  }

  NoiseAttachment& state;
  NoiseSurface& before;
  NoiseSurface& after;
  const NoiseKernelOptions asked;
  const NoiseProjection projection; // refers to what was asked
  const NoiseClosestPoint closestBefore;
  const NoiseClosestPoint closestAfter;
  const double reach;
  std::vector<NoiseMover> movers;
  std::vector<Carried> moving; // as they were
  std::vector<glm::dvec3> directions;
};

NoiseAttachment::NoiseAttachment(int changes)
  : life(changes)
{
  checkLife(changes);
}

void NoiseAttachment::reset()
{
  this->surface.reset();
  this->lastPoints.clear();
  this->carried.clear();
  this->own.clear();
}

void NoiseAttachment::setLife(int changes)
{
  checkLife(changes);
  if (this->life != changes)
  {
    this->life = changes;
    this->reset();
  }
}

void NoiseAttachment::kernels(const std::shared_ptr<NoiseSurface>& next, const NoiseView& view,
  const NoiseKernelOptions& options, std::vector<NoiseKernel>& result, const NoiseOcclusion* hidden)
{
  if (!next)
  {
    throw std::invalid_argument("next is null, expected a surface");
  }
  checkNoiseView(view);
  checkNoiseOptions(options);
  if (next != this->surface)
  {
    this->replace(next, options);
  }
  this->lastControlled = static_cast<bool>(options.control);
  if (this->lastControlled && this->life > 0)
  {
    // What is hidden now is carried, too.
    next->kernels(view, options, result, &this->lastPoints);
  }
  else
  {
    next->kernels(view, options, result, nullptr, hidden);
  }
  this->lastView = view;
  this->lastOptions = options;
  this->lastOptions.control = nullptr;
  this->weigh(result);
  this->addCarried(view, options, result);
}

void NoiseAttachment::replace(
  const std::shared_ptr<NoiseSurface>& next, const NoiseKernelOptions& options)
{
  if (this->surface && this->life > 0)
  {
    ++this->change;
    NoiseKernelOptions asked = this->lastOptions;
    asked.control = options.control;
    asked.bandwidthRange = options.bandwidthRange;
    Change(*this, *next, asked).run();
  }
  this->surface = next;
}

double NoiseAttachment::weight(const Term& term) const
{
  const std::int64_t fade = fadeOf(this->life);
  const double quarter = 0.5 * pi / static_cast<double>(fade + 1);
  double result = term.arrival > this->change ? 0.0 : 1.0;
  if (term.arrival != always && this->change - term.arrival < fade)
  {
    result *= std::sin(quarter * static_cast<double>(this->change - term.arrival + 1));
  }
  if (this->change >= term.leave)
  {
    const std::int64_t step = std::min(this->change - term.leave, fade) + 1;
    result *= std::cos(quarter * static_cast<double>(step));
  }
  return result;
}

// The surface's own points by their terms.
void NoiseAttachment::weigh(std::vector<NoiseKernel>& kernels) const
{
  if (this->own.empty())
  {
    return;
  }
  parallelFor(static_cast<std::int64_t>(kernels.size()),
    [&](std::int64_t i)
    {
      const auto found = this->own.find(kernels[i].id);
      if (found != this->own.end())
      {
        kernels[i].weight *= static_cast<float>(this->weight(found->second));
      }
    });
  kernels.erase(std::remove_if(kernels.begin(), kernels.end(),
                  [](const NoiseKernel& kernel) { return !(kernel.weight > 0.0f); }),
    kernels.end());
}

void NoiseAttachment::addCarried(
  const NoiseView& view, const NoiseKernelOptions& options, std::vector<NoiseKernel>& result) const
{
  if (this->carried.empty())
  {
    return;
  }
  const NoiseProjection projection(view, options);
  std::vector<NoiseKernel> kernels(this->carried.size());
  parallelFor(static_cast<std::int64_t>(kernels.size()),
    [&](std::int64_t i)
    {
      const Carried& point = this->carried[i];
      const NoiseFacet& facet = this->surface->tree().facets[point.facet];
      const bool isThere = makeCarriedKernel(*this->surface, projection, facet,
        { facet.index, point.weights, point.birth, point.id }, point.direction, kernels[i]);
      kernels[i].weight *= isThere ? static_cast<float>(this->weight(point.term)) : 0.0f;
    });
  result.reserve(result.size() + kernels.size());
  std::copy_if(kernels.begin(), kernels.end(), std::back_inserter(result),
    [](const NoiseKernel& kernel) { return kernel.weight > 0.0f; });
}

} // namespace hachure
