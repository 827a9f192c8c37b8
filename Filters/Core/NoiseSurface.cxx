// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseSurface.h"

#include "NoiseDescent.h"
#include "NoiseOcclusion.h"
#include "NoiseProcess.h"
#include "NoiseProjection.h"
#include "NoiseSurfaceTree.h"
#include "Parallel.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{

namespace
{

constexpr std::int64_t visitGrain = 16;
constexpr std::int64_t triangleGrain = 4096;
constexpr std::size_t defaultBudget = std::size_t{ 256 } << 20;

// Points of a node, by their births, where the surface was at some time.
struct CachedPoints
{
  std::vector<NoiseBlock> blocks;
  NoiseFrame frame;
  std::int32_t octave = noNoiseOctave; // up to this one
  std::uint64_t version = 0;           // of the positions
  std::uint64_t lastCall = 0;
  std::size_t countedBytes = 0;

  std::size_t bytes() const
  {
    return sizeof(CachedPoints) + this->blocks.capacity() * sizeof(NoiseBlock);
  }
};

// What all visits of a call have in common.
struct EmissionTask
{
  const NoiseProjection& projection;
  const NoiseBlockView& view; // of the whole surface's frame
  const NoiseOcclusion* hidden;
};

template <class T>
std::size_t bytesOf(const std::vector<T>& values)
{
  return values.capacity() * sizeof(T);
}

} // namespace

struct NoiseSurface::Data
{
  NoiseSurfaceTree tree;
  std::vector<std::int32_t> objects;
  Span<const glm::dvec3> positions;
  std::vector<std::unique_ptr<CachedPoints>> cache; // per node
  std::size_t cacheBytes = 0;
  std::size_t budget = defaultBudget;
  std::uint64_t calls = 0;
  std::uint64_t version = 1; // of the positions
  double unit = 1.0;         // of the frames
  NoiseOutputs outputs;      // of the last call, for their memory

  void emit(const NoiseVisit& visit, const EmissionTask& task, NoiseOutput& output)
  {
    if (visit.node >= 0)
    {
      this->emitNode(visit, task, output);
    }
    else
    {
      this->emitCell(visit, task, output);
    }
  }

  void emitNode(const NoiseVisit& visit, const EmissionTask& task, NoiseOutput& output)
  {
    std::unique_ptr<CachedPoints>& cached = this->cache[visit.node];
    if (!cached)
    {
      cached = std::make_unique<CachedPoints>();
    }
    const std::int32_t wanted = std::min(visit.octave, binaryExponent(visit.density));
    if (cached->octave < wanted)
    {
      this->fillBlocks(visit, wanted, *cached);
    }
    if (cached->version != this->version)
    {
      this->placeBlocks(visit, *cached);
    }
    cached->lastCall = this->calls;
    const NoiseBlockView view = task.projection.movedTo(task.view, cached->frame);
    const auto limit = static_cast<float>(visit.density * this->unit * this->unit);
    for (const NoiseBlock& block : cached->blocks)
    {
      if (!(block.birth[0] < limit))
      {
        return;
      }
      this->emitBlock(block, view, task, output,
        [&](int lane) { return noiseWeights(noiseCellOf(block.cell[lane]), block.id[lane]); });
    }
  }

  // The points that the node owns, up to an octave.
  void fillBlocks(const NoiseVisit& visit, std::int32_t octave, CachedPoints& cached) const
  {
    const std::uint32_t first = this->tree.sharedFirst[visit.node];
    const std::uint32_t last = this->tree.sharedFirst[visit.node + 1];
    std::vector<NoiseRecord> records;
    if (this->tree.nodes[visit.node].shared < octave)
    {
      records = makeNodePoints(this->tree, visit.node, visit.octaveBelow, octave);
    }
    records.insert(
      records.end(), this->tree.shared.begin() + first, this->tree.shared.begin() + last);
    std::sort(records.begin(), records.end(),
      [](const NoiseRecord& a, const NoiseRecord& b)
      { return a.birth != b.birth ? a.birth < b.birth : a.id < b.id; });
    cached.octave = octave;
    cached.version = 0;
    cached.blocks.assign((records.size() + floatLanes - 1) / floatLanes, {});
    for (std::size_t i = 0; i < cached.blocks.size() * floatLanes; ++i)
    {
      NoiseBlock& block = cached.blocks[i / floatLanes];
      const auto lane = static_cast<int>(i % floatLanes);
      // Lanes without a point repeat one.
      const NoiseRecord& record = records[std::min(i, records.size() - 1)];
      block.id[lane] = record.id;
      block.birth[lane] = static_cast<float>(record.birth * this->unit * this->unit);
      block.triangle[lane] = record.triangle;
      block.cell[lane] = static_cast<std::int8_t>(record.cell);
      block.count = i < records.size() ? lane + 1 : block.count;
    }
  }

  void placeBlocks(const NoiseVisit& visit, CachedPoints& cached) const
  {
    cached.version = this->version;
    cached.frame = { this->tree.nodes[visit.node].sphere.center, this->unit };
    for (NoiseBlock& block : cached.blocks)
    {
      for (int lane = 0; lane < floatLanes; ++lane)
      {
        const NoiseFacet& facet = this->tree.facets[block.triangle[lane]];
        block.place(lane, noiseTriangleAt(this->positions, facet.corners, facet.area),
          noiseWeights(noiseCellOf(block.cell[lane]), block.id[lane]), cached.frame);
      }
    }
  }

  // weightsOf: of the point of a lane.
  template <class Weights>
  void emitBlock(const NoiseBlock& block, const NoiseBlockView& view, const EmissionTask& task,
    NoiseOutput& output, Weights&& weightsOf) const
  {
    NoiseImages images;
    projectNoiseBlock(view, block, images);
    const bool controlled = task.projection.isControlled();
    for (int lane = 0; lane < block.count; ++lane)
    {
      const bool drawn = controlled ? !std::signbit(images.seen[lane]) &&
          images.density[lane] * view.highestDensity > block.birth[lane]
                                    : images.weight[lane] > 0.0f;
      if (drawn && !(task.hidden && isHidden(*task.hidden, images, lane)))
      {
        this->emitPoint(block, images, lane, task.projection, output, weightsOf);
      }
    }
  }

  static bool isHidden(const NoiseOcclusion& occlusion, const NoiseImages& images, int lane)
  {
    const float slope = std::sqrt(
      images.slopeX[lane] * images.slopeX[lane] + images.slopeY[lane] * images.slopeY[lane]);
    return occlusion.hides(images.x[lane], images.y[lane], images.depth[lane], slope);
  }

  template <class Weights>
  void emitPoint(const NoiseBlock& block, const NoiseImages& images, int lane,
    const NoiseProjection& projection, NoiseOutput& output, Weights&& weightsOf) const
  {
    NoisePoint point;
    point.triangle = this->tree.facets[block.triangle[lane]].index;
    point.id = block.id[lane];
    NoiseKernelOptions::Control control;
    double weight = static_cast<double>(images.weight[lane]);
    if (output.wantsPoints || projection.isControlled())
    {
      point.weights = weightsOf(lane);
      point.birth = static_cast<double>(block.birth[lane]) / (this->unit * this->unit);
      control = projection.control(point);
      weight = projection.weight(images, block, lane, control);
    }
    NoiseKernel kernel;
    if (weight > 0.0 && projection.placeKernel(images, lane, point, control, weight, kernel))
    {
      kernel.object = this->objects.empty() ? 0 : this->objects[point.triangle];
      output.add(kernel, point);
    }
  }

  void emitCell(const NoiseVisit& visit, const EmissionTask& task, NoiseOutput& output) const
  {
    const double area = this->tree.facets[visit.triangle].area;
    const std::int32_t shared = noiseSharedOctave(area);
    if (shared > visit.octaveBelow)
    {
      this->emitBatch(visit, noiseSharedBatch(visit.cell.key, area), task, output);
    }
    for (std::int32_t octave = std::max(shared, visit.octaveBelow) + 1;
         octave <= visit.octave && powerOfTwo(octave) < visit.density; ++octave)
    {
      // A leaf may own octaves in which the triangle is cut, but cells come only after those.
      assert(noiseCellDepth(area, octave) == visit.cell.depth);
      this->emitBatch(visit, noiseBatch(visit.cell, area, octave), task, output);
    }
  }

  void emitBatch(const NoiseVisit& visit, const NoiseBatch& batch, const EmissionTask& task,
    NoiseOutput& output) const
  {
    const double lowest = lowestBirthAbove(visit.octaveBelow);
    const NoiseFacet& facet = this->tree.facets[visit.triangle];
    const NoiseTriangle triangle = noiseTriangleAt(this->positions, facet.corners, facet.area);
    const glm::dvec2 corner = visit.cell.corners[0];
    const NoiseFrame frame = { triangle.origin + corner.x * triangle.u + corner.y * triangle.v,
      this->unit };
    const NoiseBlockView view = task.projection.movedTo(task.view, frame);
    NoiseBlock block{};
    const auto flush = [&]
    {
      this->emitBlock(block, view, task, output,
        [&](int lane) { return noiseWeights(visit.cell, block.id[lane]); });
      block.count = 0;
    };
    for (int i = 0; i < batch.count; ++i)
    {
      const std::uint64_t id = batch.id(i);
      const double birth = batch.birth(id);
      if (birth >= lowest && birth < visit.density)
      {
        const int lane = block.count++;
        block.place(lane, triangle, noiseWeights(visit.cell, id), frame);
        block.birth[lane] = static_cast<float>(birth * this->unit * this->unit);
        block.id[lane] = id;
        block.triangle[lane] = visit.triangle;
        if (block.count == floatLanes)
        {
          flush();
        }
      }
    }
    flush();
  }

  // Counts what was made for these visits, and drops what is over the budget.
  void trim(const std::vector<NoiseVisit>& visits)
  {
    for (const NoiseVisit& visit : visits)
    {
      CachedPoints* cached = visit.node >= 0 ? this->cache[visit.node].get() : nullptr;
      if (cached && cached->countedBytes != cached->bytes())
      {
        this->cacheBytes += cached->bytes() - cached->countedBytes;
        cached->countedBytes = cached->bytes();
      }
    }
    if (this->cacheBytes > this->budget)
    {
      this->dropOldest(this->budget / 4 * 3); // not a few every time
    }
  }

  void dropOldest(std::size_t target)
  {
    std::vector<std::pair<std::uint64_t, std::size_t>> byAge;
    byAge.reserve(this->cache.size());
    for (std::size_t node = 0; node < this->cache.size(); ++node)
    {
      if (this->cache[node])
      {
        byAge.emplace_back(this->cache[node]->lastCall, node);
      }
    }
    std::sort(byAge.begin(), byAge.end());
    for (std::size_t i = 0; i < byAge.size() && this->cacheBytes > target; ++i)
    {
      std::unique_ptr<CachedPoints>& cached = this->cache[byAge[i].second];
      this->cacheBytes -= cached->countedBytes;
      cached.reset();
    }
  }

  // Of one triangle, below the density.
  void addPoints(std::int64_t place, double density, std::vector<NoisePoint>& points) const
  {
    const NoiseFacet& facet = this->tree.facets[place];
    const double area = facet.area;
    if (!(area > 0.0))
    {
      return;
    }
    NoiseCell whole;
    whole.key = facet.key;
    const auto add = [&](const NoiseCell& cell, const NoiseBatch& batch)
    {
      for (int i = 0; i < batch.count; ++i)
      {
        const std::uint64_t id = batch.id(i);
        const double birth = batch.birth(id);
        if (birth < density)
        {
          points.push_back({ facet.index, noiseWeights(cell, id), birth, id });
        }
      }
    };
    add(whole, noiseSharedBatch(whole.key, area));
    for (std::int32_t octave = noiseSharedOctave(area) + 1; powerOfTwo(octave) < density; ++octave)
    {
      visitNoiseOctave(whole, area, octave, add);
    }
  }
};

NoiseSurface::NoiseSurface(const TriangleMesh& reference, Span<const std::uint64_t> ids,
  Span<const std::int32_t> objects, std::uint32_t seed, Span<const double> areas)
  : data(std::make_unique<Data>())
{
  if (!objects.empty() && objects.size() != reference.triangles.size())
  {
    throw std::invalid_argument("objects: " + std::to_string(objects.size()) + " values for " +
      std::to_string(reference.triangles.size()) + " triangles");
  }
  this->data->tree = buildNoiseSurfaceTree(reference, ids, seed, areas);
  this->data->objects.assign(objects.begin(), objects.end());
  this->data->positions = reference.points;
  this->data->cache.resize(this->data->tree.nodes.size());
  if (!this->data->tree.nodes.empty())
  {
    const double radius = this->data->tree.nodes.back().sphere.radius;
    this->data->unit = radius > 0.0 ? powerOfTwo(binaryExponent(radius)) : 1.0;
  }
}

NoiseSurface::~NoiseSurface() = default;
NoiseSurface::NoiseSurface(NoiseSurface&&) noexcept = default;
NoiseSurface& NoiseSurface::operator=(NoiseSurface&&) noexcept = default;

void NoiseSurface::setPositions(Span<const glm::dvec3> positions)
{
  if (positions.size() != this->data->positions.size())
  {
    throw std::invalid_argument("positions: " + std::to_string(positions.size()) +
      " points, expected " + std::to_string(this->data->positions.size()));
  }
  placeNoiseSurfaceTree(this->data->tree, positions);
  this->data->positions = positions;
  ++this->data->version;
}

std::vector<NoisePoint> NoiseSurface::points(double density) const
{
  const auto& facets = this->data->tree.facets;
  double area = 0.0;
  for (std::size_t i = 0; i < facets.size(); ++i)
  {
    area += facets[i].area;
  }
  if (!(density >= 0.0 && area * density <= 1073741824.0))
  {
    throw std::invalid_argument(
      "density is " + std::to_string(density) + ", expected 0 or more, and 2^30 points at most");
  }
  const auto count = static_cast<std::int64_t>(facets.size());
  NoiseOutputs outputs;
  outputs.restart(count / triangleGrain + 1, true);
  parallelForRanges(count, triangleGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        this->data->addPoints(i, density, outputs.parts[begin / triangleGrain].points);
      }
    });
  std::vector<NoiseKernel> none;
  std::vector<NoisePoint> result;
  outputs.join(none, &result);
  return result;
}

std::vector<NoiseKernel> NoiseSurface::kernels(
  const NoiseView& view, const NoiseKernelOptions& options)
{
  std::vector<NoiseKernel> result;
  this->kernels(view, options, result);
  return result;
}

void NoiseSurface::kernels(const NoiseView& view, const NoiseKernelOptions& options,
  std::vector<NoiseKernel>& result, std::vector<NoisePoint>* points, const NoiseOcclusion* hidden)
{
  checkNoiseView(view);
  checkNoiseOptions(options);
  ++this->data->calls;
  const NoiseProjection projection(view, options);
  NoiseFrame whole{ glm::dvec3(0.0), this->data->unit };
  if (!this->data->tree.nodes.empty())
  {
    whole.origin = this->data->tree.nodes.back().sphere.center;
  }
  const NoiseBlockView blockView = projection.blockView(whole);
  const EmissionTask task = { projection, blockView, hidden };
  const std::vector<NoiseVisit> visits =
    findNoiseVisits(this->data->tree, this->data->positions, projection);
  const auto count = static_cast<std::int64_t>(visits.size());
  NoiseOutputs& outputs = this->data->outputs;
  outputs.restart(count / visitGrain + 1, points != nullptr);
  parallelForRanges(count, visitGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        this->data->emit(visits[i], task, outputs.parts[begin / visitGrain]);
      }
    });
  this->data->trim(visits);
  outputs.join(result, points);
}

std::size_t NoiseSurface::memory() const
{
  const NoiseSurfaceTree& tree = this->data->tree;
  return sizeof(Data) + tree.facets.size() * sizeof(NoiseFacet) + bytesOf(tree.nodes) +
    bytesOf(tree.levelFirst) + bytesOf(tree.shared) + bytesOf(tree.sharedFirst) +
    bytesOf(this->data->objects) + bytesOf(this->data->cache) + this->data->cacheBytes;
}

void NoiseSurface::setMemoryBudget(std::size_t bytes)
{
  this->data->budget = bytes;
  this->data->trim({});
}

const NoiseSurfaceTree& NoiseSurface::tree() const
{
  return this->data->tree;
}

Span<const glm::dvec3> NoiseSurface::positions() const
{
  return this->data->positions;
}

Span<const std::int32_t> NoiseSurface::objects() const
{
  return this->data->objects;
}

} // namespace hachure
