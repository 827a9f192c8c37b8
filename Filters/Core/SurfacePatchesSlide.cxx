// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePatchesSlide.h"

#include "PatchFit.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{
namespace
{
/// Splits patches and keeps what they slide.
class SlideSplitter
{
public:
  SlideSplitter(const FaceSurface& someSurface, Span<const std::int32_t> facePatches,
    Span<const ViewProjection> someViews, const SlideOptions& someOptions)
    : surface(someSurface)
    , views(someViews)
    , options(someOptions)
    , outward(isInsideOut(someSurface.mesh) ? -1.0 : 1.0)
    , firstTriangles(static_cast<std::size_t>(someSurface.faceCount()) + 1,
        static_cast<std::int32_t>(someSurface.mesh.triangles.size()))
  {
    for (std::size_t i = surface.mesh.triangles.size(); i-- > 0;)
    {
      firstTriangles[surface.faceOf(i)] = static_cast<std::int32_t>(i);
    }
    for (std::size_t i = 0; i < facePatches.size(); ++i)
    {
      const std::int32_t patch = facePatches[i];
      if (patch >= 0)
      {
        faces.resize(std::max(faces.size(), static_cast<std::size_t>(patch) + 1));
        faces[patch].push_back(static_cast<std::int32_t>(i));
      }
    }
  }

  bool measureAll()
  {
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      if (!report(0.5 * static_cast<double>(i) / static_cast<double>(faces.size())))
      {
        return false;
      }
      slides.push_back(measure(faces[i]));
    }
    return true;
  }

  bool splitAll()
  {
    const FaceGraph graph(surface);
    const std::vector<FaceShape> shapes = faceShapes(surface);
    CompactOptions half = options.compact;
    half.patches = 2;
    half.progress = nullptr;
    for (int worst = worstPatch(); worst >= 0; worst = worstPatch())
    {
      if (!report(0.5 + 0.5 * static_cast<double>(faces.size()) / options.maximumPatches))
      {
        return false;
      }
      const std::vector<std::int32_t> all = std::move(faces[worst]);
      const std::vector<std::int32_t> sides = divideFaces(graph, shapes, all, half);
      faces[worst].clear();
      faces.emplace_back();
      for (std::size_t i = 0; i < all.size(); ++i)
      {
        faces[sides[i] == 0 ? static_cast<std::size_t>(worst) : faces.size() - 1].push_back(all[i]);
      }
      slides[worst] = measure(faces[worst]);
      slides.push_back(measure(faces.back()));
    }
    return true;
  }

  SlideSplit result() const
  {
    SlideSplit split;
    split.patches.assign(firstTriangles.size() - 1, -1);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      for (const std::int32_t face : faces[i])
      {
        split.patches[face] = static_cast<std::int32_t>(i);
      }
    }
    for (const std::int32_t old : numberByLowestFace(split.patches))
    {
      split.slides.push_back(slides[old]);
    }
    return split;
  }

  const std::vector<double>& allSlides() const { return slides; }

private:
  bool report(double fraction) const
  {
    return !options.compact.progress || options.compact.progress(std::min(1.0, fraction));
  }

  /// The patch to split next, -1 when done.
  int worstPatch() const
  {
    int worst = -1;
    double most = options.maximumSlide;
    const std::size_t end =
      faces.size() < static_cast<std::size_t>(options.maximumPatches) ? faces.size() : 0;
    for (std::size_t i = 0; i < end; ++i)
    {
      if (slides[i] > most && faces[i].size() > 1)
      {
        most = slides[i];
        worst = static_cast<int>(i);
      }
    }
    return worst;
  }

  double measure(const std::vector<std::int32_t>& someFaces) const
  {
    std::vector<glm::ivec3> triangles;
    for (const std::int32_t face : someFaces)
    {
      for (std::int32_t i = firstTriangles[face]; i < firstTriangles[face + 1]; ++i)
      {
        triangles.push_back(surface.mesh.triangles[i]);
      }
    }
    const TriangleMesh mesh{ surface.mesh.points, triangles, {} };
    SamplingOptions sampling;
    sampling.samplesPerPatch = options.samplesPerPatch;
    const SurfaceSamples samples = sampleSurface(mesh, sampling);
    return samples.triangles.empty() ? 0.0 : largestResidual(mesh, samples);
  }

  double largestResidual(const TriangleMesh& mesh, const SurfaceSamples& samples) const
  {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;
    for (std::size_t i = 0; i < samples.triangles.size(); ++i)
    {
      const glm::ivec3 corners = mesh.triangles[samples.triangles[i]];
      const glm::dvec3 weights = samples.barycentrics[i];
      positions.push_back(weights.x * mesh.points[corners.x] + weights.y * mesh.points[corners.y] +
        weights.z * mesh.points[corners.z]);
      normals.push_back(outward * glm::normalize(triangleAreaVector(mesh, samples.triangles[i])));
    }
    const TrackedSamples tracked{ positions, normals, samples.patches, samples.patchSpacing };
    double largest = 0.0;
    const PatchRuns patches = findPatchRuns(samples.patches, positions.size(), 1);
    ProjectedSamples previous;
    std::vector<double> previousWeights;
    for (std::size_t i = 0; i < views.size(); ++i)
    {
      ProjectedSamples current = projectSamples(tracked, views[i], FacingRule::FrontOnly);
      std::vector<double> weights = facingWeights(current, WeightScheme::Symmetric);
      if (i > 0)
      {
        const WeightedFrame before{ previous, previousWeights };
        const WeightedFrame after{ current, weights };
        const PatchFits fits = fitPatches(before, after, patches, WeightScheme::Symmetric);
        largest = std::max(largest,
          measureResiduals(fits.fits, before, after, patches, WeightScheme::Symmetric)[0].residual);
      }
      previous = std::move(current);
      previousWeights = std::move(weights);
    }
    return largest;
  }

  const FaceSurface& surface;
  Span<const ViewProjection> views;
  const SlideOptions& options;
  double outward;
  std::vector<std::int32_t> firstTriangles;     // per face, and one more
  std::vector<std::vector<std::int32_t>> faces; // per patch
  std::vector<double> slides;                   // per patch
};

void check(const FaceSurface& surface, Span<const std::int32_t> patches,
  Span<const ViewProjection> views, const SlideOptions& options)
{
  checkFaceSurface(surface);
  if (patches.size() != static_cast<std::size_t>(surface.faceCount()))
  {
    throw std::invalid_argument("patches: " + std::to_string(patches.size()) + " values for " +
      std::to_string(surface.faceCount()) + " faces");
  }
  if (views.size() < 2)
  {
    throw std::invalid_argument(
      "views: " + std::to_string(views.size()) + ", expected a path of two views or more");
  }
  for (const ViewProjection& view : views)
  {
    checkView(view);
  }
  if (!(options.maximumSlide > 0.0) || !std::isfinite(options.maximumSlide))
  {
    throw std::invalid_argument(
      "maximumSlide is " + std::to_string(options.maximumSlide) + ", expected more than 0 pixels");
  }
  if (options.maximumPatches < 1)
  {
    throw std::invalid_argument(
      "maximumPatches is " + std::to_string(options.maximumPatches) + ", expected 1 or more");
  }
}
} // namespace

std::vector<double> predictSlides(const FaceSurface& surface, Span<const std::int32_t> patches,
  Span<const ViewProjection> views, const SlideOptions& options)
{
  check(surface, patches, views, options);
  SlideSplitter splitter(surface, patches, views, options);
  return splitter.measureAll() ? splitter.allSlides() : std::vector<double>();
}

SlideSplit splitSlidingPatches(const FaceSurface& surface, Span<const std::int32_t> patches,
  Span<const ViewProjection> views, const SlideOptions& options)
{
  check(surface, patches, views, options);
  SlideSplitter splitter(surface, patches, views, options);
  return splitter.measureAll() && splitter.splitAll() ? splitter.result() : SlideSplit();
}
} // namespace hachure
