// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseScene_h
#define hachure_NoiseScene_h

// Surfaces and views for the tests of the kernels of a noise, and how many overlap in a picture.

#include "NoiseSurface.h"
#include "TestSurfaces.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace hachure::testing
{

// The sphere of radius 1 as a cube of 12 n^2 triangles, facing outward.
inline Surface makeNoiseSphere(int n)
{
  Surface sphere;
  const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  for (const glm::dvec3& normal : { x, y, z, -x, -y, -z })
  {
    const glm::dvec3 u = std::abs(normal.x) > 0.5 ? y : x;
    const glm::dvec3 v = glm::cross(normal, u);
    addGrid(sphere, normal - u - v, 2.0 * u, 2.0 * v, n);
  }
  for (glm::dvec3& point : sphere.points)
  {
    point = glm::normalize(point);
  }
  return sphere;
}

// One pixel per unit, the origin in the middle, looking along -z.
inline NoiseView parallelView(glm::dvec2 size, double zoom = 1.0, glm::dvec2 pan = glm::dvec2(0.0))
{
  NoiseView view;
  view.viewportSize = size;
  glm::dmat4 matrix(1.0);
  matrix = glm::scale(matrix, glm::dvec3(2.0 / size, -0.001));
  matrix = glm::translate(matrix, glm::dvec3(pan, 0.0));
  view.modelToClip = glm::scale(matrix, glm::dvec3(zoom, zoom, 1.0));
  return view;
}

inline NoiseView perspectiveView(
  glm::dvec2 size, const glm::dvec3& eye, const glm::dvec3& target, double degrees = 30.0)
{
  NoiseView view;
  view.viewportSize = size;
  view.modelToClip = glm::perspective(glm::radians(degrees), size.x / size.y, 0.1, 5000.0) *
    glm::lookAt(eye, target, glm::dvec3(0.0, 1.0, 0.0));
  return view;
}

// Kernels of the triangles that face the viewer.
inline std::vector<NoiseKernel> frontKernels(
  const Surface& surface, const NoiseView& view, const std::vector<NoiseKernel>& kernels)
{
  std::vector<NoiseKernel> result;
  for (const NoiseKernel& kernel : kernels)
  {
    glm::dvec2 image[3];
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec4 clip =
        view.modelToClip * glm::dvec4(surface.points[surface.triangles[kernel.triangle][i]], 1.0);
      image[i] = glm::dvec2(clip) / clip.w;
    }
    const glm::dvec2 u = image[1] - image[0];
    const glm::dvec2 v = image[2] - image[0];
    if (u.x * v.y > u.y * v.x)
    {
      result.push_back(kernel);
    }
  }
  return result;
}

// Mean sum of squared weights of the kernels over the pixels of a rectangle.
inline double meanOverlap(
  const std::vector<NoiseKernel>& kernels, glm::dvec2 low, glm::dvec2 high, double step = 4.0)
{
  const glm::dvec2 steps = glm::floor((high - low) / step);
  double sum = 0.0;
  for (const NoiseKernel& kernel : kernels)
  {
    const double radius = static_cast<double>(noiseRadius(kernel.bandwidth));
    const glm::dvec2 center = (glm::dvec2(kernel.center) - low) / step - 0.5;
    const double reach = radius / step;
    const glm::dvec2 from = glm::max(glm::ceil(center - reach), glm::dvec2(0.0));
    const glm::dvec2 to = glm::min(glm::floor(center + reach), steps - 1.0);
    int hits = 0;
    for (double y = from.y; y <= to.y; y += 1.0)
    {
      for (double x = from.x; x <= to.x; x += 1.0)
      {
        hits += glm::length(glm::dvec2(x, y) - center) < reach ? 1 : 0;
      }
    }
    sum += hits * static_cast<double>(kernel.weight) * static_cast<double>(kernel.weight);
  }
  return sum / (steps.x * steps.y);
}

inline bool sameKernel(const NoiseKernel& a, const NoiseKernel& b)
{
  return a.center == b.center && a.weight == b.weight && a.phase == b.phase &&
    a.frequency == b.frequency && a.bandwidth == b.bandwidth && a.orientation == b.orientation &&
    a.depth == b.depth && a.depthSlope == b.depthSlope && a.triangle == b.triangle &&
    a.object == b.object && a.id == b.id;
}

inline bool sameKernels(const std::vector<NoiseKernel>& a, const std::vector<NoiseKernel>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), sameKernel);
}

// Ids in ascending order.
template <class Items>
std::vector<std::uint64_t> sortedIds(const Items& items)
{
  std::vector<std::uint64_t> ids;
  ids.reserve(items.size());
  for (const auto& item : items)
  {
    ids.push_back(item.id);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

} // namespace hachure::testing

#endif
