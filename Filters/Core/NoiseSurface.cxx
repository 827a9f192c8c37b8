// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseSurface.h"

#include "NoiseDescent.h"
#include "NoiseProcess.h"
#include "NoiseProjection.h"
#include "NoiseSurfaceTree.h"
#include "Parallel.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{

namespace
{

constexpr std::int64_t visitGrain = 16;
constexpr std::int64_t triangleGrain = 4096;
constexpr std::size_t defaultBudget = std::size_t{ 64 } << 20;

// Points of nodes that were made, and when they were met last.
struct CachedPoints
{
  std::vector<NoiseRecord> records;
  std::uint64_t lastCall = 0;
  bool isCounted = false;

  std::size_t bytes() const
  {
    return sizeof(CachedPoints) + this->records.capacity() * sizeof(NoiseRecord);
  }
};

void prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  static_cast<void>(address);
#endif
}

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
  NoiseOutputs outputs; // of the last call, for their memory

  void emit(const NoiseVisit& visit, const NoiseProjection& projection, NoiseOutput& output)
  {
    if (visit.node < 0)
    {
      this->emitCell(visit, projection, output);
      return;
    }
    const std::uint32_t first = this->tree.sharedFirst[visit.node];
    this->emitRecords(Span<const NoiseRecord>(this->tree.shared)
                        .subspan(first, this->tree.sharedFirst[visit.node + 1] - first),
      visit.density, projection, output);
    if (this->tree.nodes[visit.node].shared < visit.octave)
    {
      std::unique_ptr<CachedPoints>& cached = this->cache[visit.node];
      if (!cached)
      {
        cached = std::make_unique<CachedPoints>();
        cached->records = makeNodePoints(this->tree, visit.node, visit.octaveBelow);
      }
      cached->lastCall = this->calls;
      this->emitRecords(cached->records, visit.density, projection, output);
    }
  }

  void emitRecords(Span<const NoiseRecord> records, double density,
    const NoiseProjection& projection, NoiseOutput& output) const
  {
    constexpr std::size_t blockSize = 256;
    std::array<const NoiseRecord*, blockSize> block;
    std::size_t count = 0;
    for (std::size_t i = 0; i < records.size(); ++i)
    {
      if (records[i].birth < density)
      {
        block[count++] = &records[i];
      }
      if (count == blockSize || i + 1 == records.size())
      {
        this->emitBlock({ block.data(), count }, projection, output);
        count = 0;
      }
    }
  }

  void emitBlock(Span<const NoiseRecord* const> records, const NoiseProjection& projection,
    NoiseOutput& output) const
  {
    constexpr std::size_t ahead = 8; // hides the way to memory
    for (std::size_t i = 0; i < records.size(); ++i)
    {
      if (i + 2 * ahead < records.size())
      {
        prefetch(&this->tree.facets[records[i + 2 * ahead]->triangle]);
      }
      if (i + ahead < records.size())
      {
        const glm::ivec3& corners = this->tree.facets[records[i + ahead]->triangle].corners;
        prefetch(&this->positions[corners.x]);
        prefetch(&this->positions[corners.y]);
        prefetch(&this->positions[corners.z]);
      }
      const NoiseRecord& record = *records[i];
      NoiseCell cell;
      if (record.cell > 0)
      {
        cell = noiseChild(cell, record.cell - 1);
      }
      this->emitPoint({ record.triangle, noiseWeights(cell, record.id), record.birth, record.id },
        projection, output);
    }
  }

  void emitCell(
    const NoiseVisit& visit, const NoiseProjection& projection, NoiseOutput& output) const
  {
    const double area = this->tree.facets[visit.triangle].area;
    const std::int32_t shared = noiseSharedOctave(area);
    if (shared > visit.octaveBelow)
    {
      this->emitBatch(visit, noiseSharedBatch(visit.cell.key, area), projection, output);
    }
    for (std::int32_t octave = std::max(shared, visit.octaveBelow) + 1;
         octave <= visit.octave && powerOfTwo(octave) < visit.density; ++octave)
    {
      // A leaf may own octaves in which the triangle is cut, but cells come only after those.
      assert(noiseCellDepth(area, octave) == visit.cell.depth);
      this->emitBatch(visit, noiseBatch(visit.cell, area, octave), projection, output);
    }
  }

  void emitBatch(const NoiseVisit& visit, const NoiseBatch& batch,
    const NoiseProjection& projection, NoiseOutput& output) const
  {
    const double lowest = lowestBirthAbove(visit.octaveBelow);
    for (int i = 0; i < batch.count; ++i)
    {
      const std::uint64_t id = batch.id(i);
      const double birth = batch.birth(id);
      if (birth >= lowest && birth < visit.density)
      {
        this->emitPoint(
          { visit.triangle, noiseWeights(visit.cell, id), birth, id }, projection, output);
      }
    }
  }

  // The triangle of `point` is in the order of the tree.
  void emitPoint(NoisePoint point, const NoiseProjection& projection, NoiseOutput& output) const
  {
    const NoiseFacet& facet = this->tree.facets[point.triangle];
    point.triangle = facet.index;
    NoiseKernel kernel;
    if (projection.makeKernel(
          noiseTriangleAt(this->positions, facet.corners, facet.area), point, kernel))
    {
      kernel.object = this->objects.empty() ? 0 : this->objects[point.triangle];
      output.add(kernel, point);
    }
  }

  // Counts what was made for these visits, and drops what is over the budget.
  void trim(const std::vector<NoiseVisit>& visits)
  {
    for (const NoiseVisit& visit : visits)
    {
      CachedPoints* cached = visit.node >= 0 ? this->cache[visit.node].get() : nullptr;
      if (cached && !cached->isCounted)
      {
        cached->isCounted = true;
        this->cacheBytes += cached->bytes();
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
      this->cacheBytes -= cached->bytes();
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
  std::vector<NoiseKernel>& result, std::vector<NoisePoint>* points)
{
  checkNoiseView(view);
  checkNoiseOptions(options);
  ++this->data->calls;
  const NoiseProjection projection(view, options);
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
        this->data->emit(visits[i], projection, outputs.parts[begin / visitGrain]);
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
