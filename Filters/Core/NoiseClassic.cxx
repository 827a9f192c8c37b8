// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseProcess.h"
#include "NoiseProjection.h"
#include "NoiseSurface.h"
#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace hachure
{

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr std::int64_t triangleGrain = 4096;
constexpr double mostPoints = 32768.0; // M of a triangle

void checkCount(const char* name, std::size_t count, std::size_t triangles)
{
  if (count != 0 && count != triangles)
  {
    std::string message = name;
    message += ": ";
    message += std::to_string(count);
    message += " values for ";
    message += std::to_string(triangles);
    message += " triangles";
    throw std::invalid_argument(message);
  }
}

// Area in pixels of what of a triangle is before the near plane.
double imageArea(const NoiseTriangle& triangle, const NoiseView& view)
{
  const glm::dvec4 origin = view.modelToClip * glm::dvec4(triangle.origin, 1.0);
  const std::array<glm::dvec4, 3> corners{ origin,
    origin + view.modelToClip * glm::dvec4(triangle.u, 0.0),
    origin + view.modelToClip * glm::dvec4(triangle.v, 0.0) };
  std::array<glm::dvec2, 4> polygon;
  std::size_t count = 0;
  const auto add = [&](const glm::dvec4& corner)
  { polygon[count++] = glm::dvec2(corner) / corner.w * 0.5 * view.viewportSize; };
  for (std::size_t i = 0; i < 3; ++i)
  {
    const glm::dvec4& a = corners[i];
    const glm::dvec4& b = corners[(i + 1) % 3];
    const double before = a.z + a.w;
    const double after = b.z + b.w;
    if (before > 0.0 && a.w > 0.0)
    {
      add(a);
    }
    if ((before > 0.0) != (after > 0.0))
    {
      add(glm::mix(a, b, before / (before - after)));
    }
  }
  double twice = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::dvec2& a = polygon[i];
    const glm::dvec2& b = polygon[(i + 1) % count];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::isfinite(twice) ? 0.5 * std::abs(twice) : 0.0;
}

// Points of a triangle and their weights, for the N that are expected.
struct ClassicCount
{
  int full = 0;   // points of weight 1, or of weight N
  int fading = 0; // as many again, of weight alpha
  double weight = 1.0;
  double alpha = 0.0;

  explicit ClassicCount(double expected)
  {
    if (expected < 1.0)
    {
      this->full = expected > 0.0 ? 1 : 0;
      this->weight = expected;
      return;
    }
    const double half = std::min(mostPoints, powerOfTwo(binaryExponent(expected))); // equation 2
    this->alpha = std::sqrt(std::min(expected / half - 1.0, 1.0));                  // equation 4
    this->full = static_cast<int>(half);
    this->fading = this->alpha > 0.0 ? this->full : 0;
  }
};

class ClassicKernels
{
public:
  ClassicKernels(const NoiseView& noiseView, const NoiseKernelOptions& options)
    : view(noiseView)
    , projection(noiseView, options)
    , density(options.overlap / (pi * options.radius * options.radius))
  {
  }

  void add(const NoiseTriangle& triangle, std::int32_t index, std::int32_t object,
    std::uint64_t key, NoiseOutput& output) const
  {
    const double expected = this->density * imageArea(triangle, this->view);
    const ClassicCount count(expected);
    NoiseBatch batch;
    batch.stream = key;
    const double size = glm::length(triangle.u);
    const NoiseFrame frame{ triangle.origin, size > 0.0 ? powerOfTwo(binaryExponent(size)) : 1.0 };
    const NoiseBlockView blockView = this->projection.blockView(frame);
    const int total = count.full + count.fading;
    for (int first = 0; first < total; first += floatLanes)
    {
      std::array<NoisePoint, floatLanes> points;
      NoiseBlock block{};
      block.count = std::min(floatLanes, total - first);
      for (int lane = 0; lane < block.count; ++lane)
      {
        const std::uint64_t id = batch.id(first + lane);
        points[lane] = { index, noiseWeights({}, id),
          powerOfTwo(binaryExponent(std::max(first + lane, 1))), id };
        block.place(lane, triangle, points[lane].weights, frame);
      }
      NoiseImages images;
      projectNoiseBlock(blockView, block, images);
      for (int lane = 0; lane < block.count; ++lane)
      {
        const double weight = first + lane < count.full ? count.weight : count.alpha;
        NoiseKernel kernel;
        if (!std::signbit(images.seen[lane]) &&
          this->projection.placeKernel(
            images, lane, points[lane], this->projection.control(points[lane]), weight, kernel))
        {
          kernel.object = object;
          output.add(kernel, points[lane]);
        }
      }
    }
  }

private:
  const NoiseView& view;
  const NoiseProjection projection;
  const double density; // kernels per square pixel
};

} // namespace

std::vector<NoiseKernel> classicNoiseKernels(const TriangleMesh& mesh,
  Span<const std::uint64_t> ids, Span<const std::int32_t> objects, std::uint32_t seed,
  const NoiseView& view, const NoiseKernelOptions& options, std::vector<NoisePoint>* points)
{
  checkTriangleMesh(mesh);
  checkCount("ids", ids.size(), mesh.triangles.size());
  checkCount("objects", objects.size(), mesh.triangles.size());
  checkNoiseView(view);
  checkNoiseOptions(options);
  const ClassicKernels classic(view, options);
  const auto count = static_cast<std::int64_t>(mesh.triangles.size());
  NoiseOutputs outputs;
  outputs.restart(count / triangleGrain + 1, points != nullptr);
  parallelForRanges(count, triangleGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        const glm::ivec3 corners = mesh.triangles[i];
        const glm::dvec3& a = mesh.points[corners.x];
        const glm::dvec3& b = mesh.points[corners.y];
        const glm::dvec3& c = mesh.points[corners.z];
        const std::uint64_t id = ids.empty() ? noiseTriangleId(a, b, c) : ids[i];
        // Here areas are those of the image; 1 stands in for that of the reference.
        classic.add(noiseTriangleAt(mesh.points, corners, 1.0), static_cast<std::int32_t>(i),
          objects.empty() ? 0 : objects[i], noiseTriangleKey(seed, id),
          outputs.parts[begin / triangleGrain]);
      }
    });
  std::vector<NoiseKernel> result;
  outputs.join(result, points);
  return result;
}

} // namespace hachure
