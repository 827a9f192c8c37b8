// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSampling.h"

#include "Parallel.h"
#include "Random.h"
#include "SurfaceVoxels.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

// Stratified point sampling after Nehab and Shilane, "Stratified Point Sampling of 3D Models",
// 2004. As there, the surface is voxelised, the voxels are the strata, and samples that come too
// close to another are left out. Two things differ:
//
// - A voxel holds between nearly nothing and several times the area of its face, so one sample per
//   voxel gives a density that depends on the orientation of the surface. Here the pieces of
//   surface are lined up along a space-filling curve through the voxels, and the line is divided
//   into samplesPerPatch *strata* of exactly equal area. A stratum is about one voxel's worth of
//   surface and nearly always compact.
// - The paper pulls samples towards the centre of their voxel. Here every sample is the best of
//   several *candidates*, uniform in its stratum: the one farthest from the samples already placed.
//
// Sheets that lie back to back (a thin plate) do not push each other's samples away: only samples
// whose surfaces face the same way are neighbours.
//
// All lengths below are in units of the patch's largest extent, with the patch at the origin.

namespace hachure
{
namespace
{
// Independent random numbers for one candidate, and for the patch's grid.
enum RandomDimension : std::uint32_t
{
  AlongStratum,
  FirstInFragment,
  SecondInFragment,
  PlacingOrder,
  GridOffset // and the two after it
};

struct PatchSample
{
  std::int32_t triangle; // in the patch
  std::int32_t stratum;
  glm::dvec3 barycentrics;
  glm::dvec3 position;
  glm::dvec3 normal;
};

/// The samples placed so far, by place.
class PlacedSamples
{
public:
  PlacedSamples(double spacing, std::size_t capacity)
    : reach(spacing)
    , cellSide(2.0 * spacing)
  {
    std::size_t buckets = 16;
    while (buckets < 2 * capacity)
    {
      buckets *= 2;
    }
    heads.assign(buckets, -1);
    samples.reserve(capacity);
    next.reserve(capacity);
  }

  void add(const PatchSample& sample)
  {
    const glm::dvec3 cell = glm::floor(sample.position / cellSide);
    std::int32_t& head = heads[bucket(cell)];
    next.push_back(head);
    head = static_cast<std::int32_t>(samples.size());
    samples.push_back(sample);
  }

  /// Distance to the nearest sample that faces the same way, at most one spacing. Cells are two
  /// spacings wide, so the eight cells around the nearest cell corner hold all within reach.
  /// Stops early, with any smaller value, once it is known to be below the distance to beat.
  double nearestDistance(const PatchSample& candidate, double toBeat) const
  {
    double nearestSquared = reach * reach;
    const double stopSquared = toBeat * toBeat;
    const glm::dvec3 firstCell = glm::floor(candidate.position / cellSide - 0.5);
    for (int corner = 0; corner < 8 && nearestSquared > stopSquared; ++corner)
    {
      const glm::dvec3 cell = firstCell + glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2);
      for (std::int32_t i = heads[bucket(cell)]; i >= 0; i = next[i])
      {
        const glm::dvec3 offset = samples[i].position - candidate.position;
        if (glm::dot(samples[i].normal, candidate.normal) > 0.0)
        {
          nearestSquared = std::min(nearestSquared, glm::dot(offset, offset));
        }
      }
    }
    return std::sqrt(nearestSquared);
  }

  std::vector<PatchSample> samples;

private:
  std::size_t bucket(const glm::dvec3& cell) const
  {
    // Cells that share a bucket cost time only: distances decide.
    const std::uint64_t x = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.x));
    const std::uint64_t y = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.y));
    const std::uint64_t z = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.z));
    const std::uint64_t mixed =
      hashMix(x * 0x9e3779b97f4a7c15ull ^ y * 0xc2b2ae3d27d4eb4full ^ z * 0x165667b19e3779f9ull);
    return static_cast<std::size_t>(mixed) & (heads.size() - 1);
  }

  double reach;
  double cellSide;
  std::vector<std::int32_t> heads;
  std::vector<std::int32_t> next;
};

/// Samples one patch, on one thread.
class PatchSampler
{
public:
  PatchSampler(const SamplingOptions& samplingOptions, std::int32_t patch)
    : options(samplingOptions)
    , seed(hashCombine(samplingOptions.seed, static_cast<std::uint64_t>(patch)))
  {
  }

  /// Takes the triangles of the patch in model space. False when the progress function said stop.
  bool run(std::vector<TriangleCorners>&& patchTriangles, const ProgressFn& progress)
  {
    triangles = std::move(patchTriangles);
    if (!normalise())
    {
      return true;
    }
    cutIntoFragments();
    if (progress && !progress(0.5))
    {
      return false;
    }
    return placeSamples(progress);
  }

  double modelSpacing() const { return spacing > 0.0 ? spacing * scale : 0.0; }

  std::vector<PatchSample> samples;

private:
  /// Moves the patch to the unit cube and finds the spacing; false when it has no area.
  bool normalise()
  {
    if (triangles.empty())
    {
      return false;
    }
    glm::dvec3 low(std::numeric_limits<double>::max());
    glm::dvec3 high(std::numeric_limits<double>::lowest());
    for (const TriangleCorners& corners : triangles)
    {
      low = glm::min(low, glm::min(corners[0], glm::min(corners[1], corners[2])));
      high = glm::max(high, glm::max(corners[0], glm::max(corners[1], corners[2])));
    }
    const glm::dvec3 extent = high - low;
    scale = std::max(extent.x, std::max(extent.y, extent.z));
    double area = 0.0;
    totalLength = 0.0;
    for (TriangleCorners& corners : triangles)
    {
      for (glm::dvec3& corner : corners)
      {
        corner = (corner - low) / scale;
      }
      const glm::dvec3 edge = corners[1] - corners[0];
      const glm::dvec3 otherEdge = corners[2] - corners[0];
      area += 0.5 * glm::length(glm::cross(edge, otherEdge));
      totalLength += glm::length(edge) + glm::length(otherEdge);
    }
    spacing = std::sqrt(area / options.samplesPerPatch);
    return spacing > 0.0;
  }

  void cutIntoFragments()
  {
    // Voxels as large as the spacing, but never so small that long thin triangles are cut into
    // more pieces than the surface has triangles and samples, a few times over.
    const double cutsPerItem = 16.0;
    const double items = static_cast<double>(triangles.size()) + options.samplesPerPatch;
    const double side =
      std::max({ spacing, totalLength / (cutsPerItem * items), 4.0 / maximumVoxelsPerAxis });
    // A random offset: surfaces in the planes of the grid would be cut by rounding errors.
    glm::dvec3 origin;
    for (int axis = 0; axis < 3; ++axis)
    {
      origin[axis] = -side * unitRandom(seed, 0, GridOffset + static_cast<std::uint32_t>(axis));
    }
    surface = voxeliseSurface(triangles, origin, side);
    areaBefore.resize(surface.fragments.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < areaBefore.size(); ++i)
    {
      areaBefore[i] = sum;
      sum += surface.fragments[i].area;
    }
    totalArea = sum;
  }

  bool placeSamples(const ProgressFn& progress)
  {
    const std::int32_t count = options.samplesPerPatch;
    // In random order, so that all samples of a neighbourhood have a similar choice.
    std::vector<std::uint64_t> order(count);
    for (std::int32_t i = 0; i < count; ++i)
    {
      const std::uint64_t key = hashCombine(seed, hashPair(PlacingOrder, i));
      order[i] = key << 32 | static_cast<std::uint32_t>(i);
    }
    std::sort(order.begin(), order.end());

    PlacedSamples placed(spacing, count);
    for (std::int32_t i = 0; i < count; ++i)
    {
      const std::int32_t samplesPerProgress = 4096;
      if (i % samplesPerProgress == 0 && progress && !progress(0.5 + 0.5 * i / count))
      {
        return false;
      }
      placeBestCandidate(static_cast<std::int32_t>(order[i] & 0xffffffffu), placed);
    }
    samples = std::move(placed.samples);
    std::sort(samples.begin(), samples.end(),
      [](const PatchSample& a, const PatchSample& b) { return a.stratum < b.stratum; });
    return true;
  }

  void placeBestCandidate(std::int32_t stratum, PlacedSamples& placed) const
  {
    PatchSample best{};
    double bestDistance = 0.0;
    for (int i = 0; i < options.regularity; ++i)
    {
      const PatchSample candidate = drawCandidate(stratum, i);
      const double distance = placed.nearestDistance(candidate, bestDistance);
      if (distance > bestDistance)
      {
        best = candidate;
        bestDistance = distance;
      }
    }
    // A distance of 0 is a repeated triangle's: not worth keeping with any minimum distance.
    if (bestDistance > 0.0 && bestDistance >= options.minimumDistance * spacing)
    {
      placed.add(best);
    }
  }

  PatchSample drawCandidate(std::int32_t stratum, int number) const
  {
    const std::uint64_t id =
      static_cast<std::uint64_t>(stratum) << 32 | static_cast<std::uint32_t>(number);
    const double target =
      (stratum + unitRandom(seed, id, AlongStratum)) * totalArea / options.samplesPerPatch;
    const auto after = std::upper_bound(areaBefore.begin(), areaBefore.end(), target);
    const SurfaceFragment& fragment = surface.fragments[after - areaBefore.begin() - 1];

    // Uniform in a triangle: Osada et al. 2002, equation 1.
    const double root = std::sqrt(unitRandom(seed, id, FirstInFragment));
    const double second = unitRandom(seed, id, SecondInFragment);
    const glm::dvec3 local(1.0 - root, root * (1.0 - second), root * second);

    PatchSample sample;
    sample.triangle = fragment.triangle;
    sample.stratum = stratum;
    sample.barycentrics = local;
    if (fragment.corners >= 0)
    {
      const std::array<glm::dvec3, 3>& corners = surface.corners[fragment.corners];
      sample.barycentrics = local.x * corners[0] + local.y * corners[1] + local.z * corners[2];
    }
    sample.barycentrics = glm::max(sample.barycentrics, glm::dvec3(0.0));
    sample.barycentrics /= sample.barycentrics.x + sample.barycentrics.y + sample.barycentrics.z;
    const TriangleCorners& corners = triangles[fragment.triangle];
    sample.position = sample.barycentrics.x * corners[0] + sample.barycentrics.y * corners[1] +
      sample.barycentrics.z * corners[2];
    sample.normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    return sample;
  }

  const SamplingOptions& options;
  const std::uint32_t seed;
  std::vector<TriangleCorners> triangles;
  double scale = 0.0;       // model units
  double spacing = 0.0;     // mean distance of samples
  double totalLength = 0.0; // of two edges of every triangle
  double totalArea = 0.0;
  VoxelisedSurface surface;
  std::vector<double> areaBefore; // running sum, per fragment
};

/// Triangles with area, ordered by patch: those of patch p are first[p] to first[p + 1].
struct TrianglesByPatch
{
  std::vector<std::int32_t> triangles;
  std::vector<std::int64_t> first;
};

std::int32_t countPatches(const TriangleMesh& mesh)
{
  if (mesh.patches.empty())
  {
    return mesh.triangles.empty() ? 0 : 1;
  }
  const std::int32_t largest = *std::max_element(mesh.patches.begin(), mesh.patches.end());
  if (largest >= maximumPatchCount)
  {
    throw std::invalid_argument("mesh.patches: id " + std::to_string(largest) + " is not below " +
      std::to_string(maximumPatchCount));
  }
  return std::max(largest, -1) + 1;
}

TrianglesByPatch sortByPatch(const TriangleMesh& mesh, std::int32_t patchCount)
{
  const std::int32_t triangleCount = static_cast<std::int32_t>(mesh.triangles.size());
  std::vector<std::int32_t> patches(triangleCount);
  parallelFor(triangleCount,
    [&](std::int64_t i)
    {
      const glm::ivec3 corners = mesh.triangles[i];
      const bool isDegenerate = isDegenerateTriangle(
        mesh.points[corners.x], mesh.points[corners.y], mesh.points[corners.z]);
      patches[i] = isDegenerate ? -1 : mesh.patches.empty() ? 0 : mesh.patches[i];
    });

  TrianglesByPatch result;
  result.first.assign(patchCount + 1, 0);
  for (const std::int32_t patch : patches)
  {
    if (patch >= 0)
    {
      ++result.first[patch + 1];
    }
  }
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  result.triangles.resize(result.first.back());
  std::vector<std::int64_t> slot(result.first);
  for (std::int32_t i = 0; i < triangleCount; ++i)
  {
    if (patches[i] >= 0)
    {
      result.triangles[slot[patches[i]]++] = i;
    }
  }
  return result;
}

void checkOptions(const SamplingOptions& options)
{
  if (options.samplesPerPatch < 1)
  {
    throw std::invalid_argument(
      "samplesPerPatch: " + std::to_string(options.samplesPerPatch) + " is not at least 1");
  }
  if (!(options.minimumDistance >= 0.0 && options.minimumDistance <= 1.0))
  {
    throw std::invalid_argument(
      "minimumDistance: " + std::to_string(options.minimumDistance) + " is not in [0, 1]");
  }
  if (options.regularity < 1)
  {
    throw std::invalid_argument(
      "regularity: " + std::to_string(options.regularity) + " is not at least 1");
  }
}

/// Samples one patch into its own slots; false when the progress function said stop.
bool samplePatch(const TriangleMesh& mesh, const TrianglesByPatch& sorted, std::int32_t patch,
  const SamplingOptions& options, const ProgressFn& progress, SurfaceSamples& result)
{
  const std::int64_t first = sorted.first[patch];
  const std::int64_t count = sorted.first[patch + 1] - first;
  std::vector<TriangleCorners> triangles(count);
  for (std::int64_t i = 0; i < count; ++i)
  {
    const glm::ivec3 corners = mesh.triangles[sorted.triangles[first + i]];
    triangles[i] = { mesh.points[corners.x], mesh.points[corners.y], mesh.points[corners.z] };
  }
  PatchSampler sampler(options, patch);
  if (!sampler.run(std::move(triangles), progress))
  {
    return false;
  }
  for (const PatchSample& sample : sampler.samples)
  {
    result.triangles.push_back(sorted.triangles[first + sample.triangle]);
    result.barycentrics.push_back(sample.barycentrics);
    result.patches.push_back(patch);
    result.strata.push_back(sample.stratum);
  }
  result.patchSpacing.push_back(sampler.modelSpacing());
  return true;
}

template <class T>
void append(std::vector<T>& target, const std::vector<T>& source)
{
  target.insert(target.end(), source.begin(), source.end());
}
} // namespace

SurfaceSamples sampleSurface(const TriangleMesh& mesh, const SamplingOptions& options)
{
  checkOptions(options);
  checkTriangleMesh(mesh);
  const std::int32_t patchCount = countPatches(mesh);
  const TrianglesByPatch sorted = sortByPatch(mesh, patchCount);

  SurfaceSamples result;
  if (patchCount == 1)
  {
    return samplePatch(mesh, sorted, 0, options, options.progress, result) ? result
                                                                           : SurfaceSamples();
  }
  // Patches are independent, so the thread count cannot matter. In batches, to report progress.
  const std::int32_t batch = 64;
  for (std::int32_t begin = 0; begin < patchCount; begin += batch)
  {
    if (options.progress && !options.progress(static_cast<double>(begin) / patchCount))
    {
      return SurfaceSamples();
    }
    std::vector<SurfaceSamples> parts(std::min(batch, patchCount - begin));
    parallelFor(static_cast<std::int64_t>(parts.size()),
      [&](std::int64_t i) {
        samplePatch(mesh, sorted, begin + static_cast<std::int32_t>(i), options, nullptr, parts[i]);
      });
    for (const SurfaceSamples& part : parts)
    {
      append(result.triangles, part.triangles);
      append(result.barycentrics, part.barycentrics);
      append(result.patches, part.patches);
      append(result.strata, part.strata);
      append(result.patchSpacing, part.patchSpacing);
    }
  }
  return result;
}
} // namespace hachure
