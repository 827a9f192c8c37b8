// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Kernels of a surface that is replaced frame by frame by others with other triangles: they keep
// their density and their deviation, stay where they are, and come and go slowly.

#include "CallTests.h"
#include "NoiseAttachment.h"
#include "NoiseField.h"
#include "NoiseOcclusion.h"
#include "NoiseScene.h"

#include <gtest/gtest.h>

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

using namespace hachure;
using namespace hachure::testing;

namespace
{

constexpr double pi = 3.14159265358979323846;

// With the mesh that it is of.
std::shared_ptr<NoiseSurface> attachable(Surface surface, std::uint32_t seed = 1)
{
  struct Owner
  {
    Surface surface;
    std::unique_ptr<NoiseSurface> points;
  };
  const auto owner = std::make_shared<Owner>();
  owner->surface = std::move(surface);
  owner->points = std::make_unique<NoiseSurface>(
    owner->surface.mesh(), Span<const std::uint64_t>(), Span<const std::int32_t>(), seed);
  return { owner, owner->points.get() };
}

// The same sphere in other triangles for every frame.
Surface sphereOf(int frame, double radius = 1.0)
{
  Surface sphere = makeNoiseSphere(20 + frame % 5);
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1.0, 2.0, 0.5 + 0.1 * frame));
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.37 * frame, axis);
  for (glm::dvec3& point : sphere.points)
  {
    point = radius * glm::normalize(glm::dvec3(turn * glm::dvec4(point, 1.0)));
  }
  return sphere;
}

NoiseView viewAt(double distance)
{
  return perspectiveView({ 260, 260 }, { 0.0, 0.0, distance }, { 0.0, 0.0, 0.0 });
}

NoiseKernelOptions isotropic()
{
  NoiseKernelOptions options;
  options.radius = 8.0;
  options.spread = 0.5 * pi;
  options.turning = true;
  return options;
}

// Mean overlap of the kernels on a sphere's visible side, from the sum over all of them.
double overlapOnSphere(
  const std::vector<NoiseKernel>& front, double radius, double distance, double kernelRadius)
{
  double sum = 0.0;
  for (const NoiseKernel& kernel : front)
  {
    sum += static_cast<double>(kernel.weight * kernel.weight);
  }
  const double focus = 130.0 / std::tan(glm::radians(15.0));
  const double pixels = focus * radius / std::sqrt(distance * distance - radius * radius);
  return sum * kernelRadius * kernelRadius / (pixels * pixels);
}

struct Frame
{
  Surface surface;
  std::vector<NoiseKernel> front;
  std::vector<float> field; // in the middle, of deviation 1
};

Frame drawFrame(NoiseAttachment& attachment, const Surface& surface, const NoiseView& view,
  const NoiseKernelOptions& options, std::uint32_t seed = 1)
{
  Frame frame;
  frame.surface = surface;
  std::vector<NoiseKernel> kernels;
  attachment.kernels(attachable(surface, seed), view, options, kernels);
  frame.front = frontKernels(surface, view, kernels);
  NoiseSurroundings surroundings;
  surroundings.rectangle = { 65, 65, 130, 130 };
  const NoiseSums sums = noiseSums(frame.front, surroundings, {});
  frame.field.reserve(sums.x.size());
  for (std::size_t i = 0; i < sums.x.size(); ++i)
  {
    frame.field.push_back(sums.x[i] / std::sqrt(sums.z[i] + 1e-6f));
  }
  return frame;
}

double meanProduct(const std::vector<float>& a, const std::vector<float>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
  }
  return sum / static_cast<double>(a.size());
}

// 0 where two fields are equal, 1 where they have nothing in common.
double changeOf(const std::vector<float>& a, const std::vector<float>& b)
{
  return 1.0 - meanProduct(a, b) / std::sqrt(meanProduct(a, a) * meanProduct(b, b));
}

// Calls body(kernel before, kernel after) for those that are in both.
template <class Body>
void forShared(
  const std::vector<NoiseKernel>& before, const std::vector<NoiseKernel>& after, Body&& body)
{
  std::map<std::uint64_t, const NoiseKernel*> known;
  for (const NoiseKernel& kernel : before)
  {
    known[kernel.id] = &kernel;
  }
  for (const NoiseKernel& kernel : after)
  {
    const auto found = known.find(kernel.id);
    if (found != known.end())
    {
      body(*found->second, kernel);
    }
  }
}

} // namespace

// On a surface that grows or shrinks by half and more, for many lives.
TEST(NoiseAttachment, KeepsOverlapAndDeviation)
{
  for (const double growth : { 1.0, 1.012, 0.988 })
  {
    NoiseAttachment attachment(8);
    double overlap = 0.0, square = 0.0;
    int frames = 0;
    for (int i = 0; i < 30; ++i)
    {
      const double radius = std::pow(growth, i - 15);
      const Frame frame = drawFrame(attachment, sphereOf(i, radius), viewAt(5.0), isotropic());
      const double found = overlapOnSphere(frame.front, radius, 5.0, 8.0);
      EXPECT_NEAR(found, 32.0, 1.6) << growth << " " << i;
      const double deviation = std::sqrt(meanProduct(frame.field, frame.field));
      EXPECT_NEAR(deviation, 1.0, 0.05) << growth << " " << i;
      overlap += found;
      square += deviation * deviation;
      ++frames;
    }
    EXPECT_NEAR(overlap / frames, 32.0, 0.8) << growth;
    EXPECT_NEAR(square / frames, 1.0, 0.05) << growth;
  }
}

TEST(NoiseAttachment, KernelsStayAndKeepTheirLook)
{
  NoiseAttachment attachment(8);
  Frame before = drawFrame(attachment, sphereOf(0), viewAt(4.0), isotropic());
  for (int i = 1; i < 20; ++i)
  {
    const Frame after = drawFrame(attachment, sphereOf(i), viewAt(4.0), isotropic());
    double farthest = 0.0, squares = 0.0, shared = 0.0, turned = 0.0;
    forShared(before.front, after.front,
      [&](const NoiseKernel& a, const NoiseKernel& b)
      {
        farthest = std::max(farthest, static_cast<double>(glm::length(a.center - b.center)));
        turned +=
          std::abs(std::remainder(static_cast<double>(a.orientation - b.orientation), 2.0 * pi));
        shared += static_cast<double>(a.weight * b.weight);
        squares += 1.0;
        EXPECT_EQ(a.phase, b.phase);
        // A step of a fade; of kernels that are seen at a slant density differs by triangle.
        const bool isInside = glm::length(a.center - glm::vec2(130.0f)) < 80.0f;
        EXPECT_TRUE(!isInside || std::abs(a.weight - b.weight) < 0.34f) << a.weight << b.weight;
      });
    EXPECT_LT(farthest, 0.5) << i;
    EXPECT_LT(turned / squares, 0.02) << i;
    double all = 0.0;
    for (const NoiseKernel& kernel : after.front)
    {
      all += static_cast<double>(kernel.weight * kernel.weight);
    }
    EXPECT_GT(shared / all, 0.95) << i;
    before = after;
  }
}

// Every frame changes the field by as much as the one before, and by little; without attachment all
// of it changes.
TEST(NoiseAttachment, FieldDoesNotPop)
{
  for (const int life : { 8, 20, 0 })
  {
    NoiseAttachment attachment(life);
    std::vector<double> changes;
    Frame before = drawFrame(attachment, sphereOf(0), viewAt(4.0), isotropic());
    for (int i = 1; i < 16; ++i)
    {
      const Frame after = drawFrame(attachment, sphereOf(i), viewAt(4.0), isotropic());
      changes.push_back(changeOf(before.field, after.field));
      before = after;
    }
    std::sort(changes.begin(), changes.end());
    const double median = changes[changes.size() / 2];
    const double expected = life == 0 ? 1.1 : life == 8 ? 0.04 : 0.015;
    EXPECT_LT(changes.back(), expected) << life;
    EXPECT_LT(changes.back(), 2.0 * median) << life;
    EXPECT_TRUE(life > 0 || changes.front() > 0.9) << "nothing in common";
  }
}

TEST(NoiseAttachment, NothingFadesBetweenChanges)
{
  NoiseAttachment attachment(8);
  NoiseAttachment other(8);
  std::vector<NoiseKernel> first, again, kernels;
  for (int i = 0; i < 12; ++i)
  {
    const auto surface = attachable(sphereOf(i, 1.0 + 0.01 * i));
    attachment.kernels(surface, viewAt(4.0), isotropic(), first);
    attachment.kernels(surface, viewAt(4.0), isotropic(), again);
    EXPECT_TRUE(sameKernels(first, again)) << i;
    // Nor does a look from elsewhere change anything, where the last one before the change was the
    // same.
    attachment.kernels(surface, viewAt(3.0), isotropic(), again);
    attachment.kernels(surface, viewAt(4.0), isotropic(), again);
    EXPECT_TRUE(sameKernels(first, again)) << i;
    other.kernels(surface, viewAt(4.0), isotropic(), kernels);
    EXPECT_TRUE(sameKernels(first, kernels)) << i;
  }
  EXPECT_GT(attachment.carriedCount(), first.size() / 2);
}

TEST(NoiseAttachment, ThreadsDoNotMatter)
{
  const int before = omp_get_max_threads();
  std::vector<std::vector<NoiseKernel>> results;
  for (const int threads : { 1, 3, 4 })
  {
    omp_set_num_threads(threads);
    NoiseAttachment attachment(4);
    std::vector<NoiseKernel> kernels;
    for (int i = 0; i < 6; ++i)
    {
      attachment.kernels(
        attachable(sphereOf(i, 1.0 - 0.02 * i)), viewAt(4.0), isotropic(), kernels);
    }
    results.push_back(kernels);
  }
  omp_set_num_threads(before);
  EXPECT_TRUE(sameKernels(results[0], results[1]));
  EXPECT_TRUE(sameKernels(results[0], results[2]));
}

// What lies outside of the last view, or is looked at more closely, has the same density.
TEST(NoiseAttachment, OtherViewsHaveTheSameOverlap)
{
  NoiseAttachment attachment(6);
  const NoiseView close = perspectiveView({ 260, 260 }, { 0.4, 0.1, 2.5 }, { 0.4, 0.0, 0.0 });
  int frame = 0;
  for (const bool isClose : { false, true, false })
  {
    for (int i = 0; i < 5; ++i, ++frame)
    {
      drawFrame(attachment, sphereOf(frame), isClose ? close : viewAt(4.0), isotropic());
    }
    const Surface surface = sphereOf(frame);
    NoiseAttachment copy(attachment);
    const std::vector<NoiseKernel> near = drawFrame(copy, surface, close, isotropic()).front;
    NoiseAttachment none(0);
    const std::vector<NoiseKernel> fresh = drawFrame(none, surface, close, isotropic()).front;
    EXPECT_NEAR(
      meanOverlap(near, { 0, 0 }, { 260, 260 }) / meanOverlap(fresh, { 0, 0 }, { 260, 260 }), 1.0,
      0.05)
      << frame;
    for (const double distance : { 4.0, 5.0, 8.0 })
    {
      copy = attachment;
      const auto front = drawFrame(copy, surface, viewAt(distance), isotropic()).front;
      EXPECT_NEAR(overlapOnSphere(front, 1.0, distance, 8.0), 32.0, 1.9)
        << frame << " " << distance;
    }
  }
}

// The surface's other half is what it was: so are its points, which never fade.
TEST(NoiseAttachment, PointsOfEqualTrianglesStay)
{
  NoiseAttachment attachment(3);
  const NoiseView view = parallelView({ 400, 300 });
  for (int i = 0; i < 9; ++i)
  {
    Surface surface;
    addGrid(surface, { -200, -150, 0 }, { 200, 0, 0 }, { 0, 300, 0 }, 12);
    addGrid(surface, { 0, -150, 0 }, { 200, 0, 0 }, { 0, 300, 0 }, 9 + i % 4);
    std::vector<NoiseKernel> kernels;
    attachment.kernels(attachable(surface), view, isotropic(), kernels);
    EXPECT_NEAR(meanOverlap(kernels, { 20, 20 }, { 180, 280 }), 32.0, 1.6);
    EXPECT_NEAR(meanOverlap(kernels, { 190, 20 }, { 210, 280 }), 32.0, 3.2) << "the border";
    EXPECT_NEAR(meanOverlap(kernels, { 220, 20 }, { 380, 280 }), 32.0, 1.6);
    NoiseAttachment none(0);
    std::vector<NoiseKernel> fresh;
    none.kernels(attachable(surface), view, isotropic(), fresh);
    std::map<std::uint64_t, float> weights;
    for (const NoiseKernel& kernel : kernels)
    {
      weights[kernel.id] = kernel.weight;
    }
    for (const NoiseKernel& kernel : fresh)
    {
      EXPECT_TRUE(kernel.triangle >= 288 || weights[kernel.id] == kernel.weight);
    }
  }
}

// A sheet moves by more than its thickness: its front does not go to its back.
TEST(NoiseAttachment, SidesOfThinWallsKeepTheirPoints)
{
  NoiseAttachment attachment(8);
  const NoiseView view = perspectiveView({ 400, 400 }, { 0.0, 0.0, 8.0 }, { 0.0, 0.0, 0.0 });
  std::vector<NoiseKernel> before, kernels;
  for (int i = 0; i < 4; ++i)
  {
    Surface sheet;
    const double front = 0.05 * i;
    addGrid(sheet, { -3, -3, front }, { 6, 0, 0 }, { 0, 6, 0 }, 20 + i);
    addGrid(sheet, { -3, -3, front - 0.02 }, { 0, 6, 0 }, { 6, 0, 0 }, 20 + i);
    attachment.kernels(attachable(sheet), view, isotropic(), kernels);
    kernels = frontKernels(sheet, view, kernels);
    int shared = 0;
    forShared(before, kernels, [&](const NoiseKernel&, const NoiseKernel&) { ++shared; });
    EXPECT_TRUE(i == 0 || shared > 0.7 * static_cast<double>(kernels.size()));
    EXPECT_NEAR(meanOverlap(kernels, { 50, 50 }, { 350, 350 }), 32.0, 1.6);
    before = kernels;
  }
}

// A part that was not there has its own points at once; a part that is gone takes its points along.
TEST(NoiseAttachment, PartsThatComeAndGo)
{
  NoiseAttachment attachment(8);
  const NoiseView view = parallelView({ 400, 200 });
  for (int i = 0; i < 8; ++i)
  {
    Surface surface;
    addGrid(surface, { -180, -80, 0 }, { 160, 0, 0 }, { 0, 160, 0 }, 10 + i);
    if (i % 4 >= 2)
    {
      addGrid(surface, { 20, -80, 0 }, { 160, 0, 0 }, { 0, 160, 0 }, 10 + i);
    }
    std::vector<NoiseKernel> kernels;
    attachment.kernels(attachable(surface), view, isotropic(), kernels);
    EXPECT_NEAR(meanOverlap(kernels, { 40, 40 }, { 160, 160 }), 32.0, 1.9) << i;
    EXPECT_NEAR(meanOverlap(kernels, { 240, 40 }, { 360, 160 }), i % 4 >= 2 ? 32.0 : 0.0, 1.9) << i;
  }
}

// So does a strip at the border, where the closest points of the old surface are all on its border.
TEST(NoiseAttachment, GrowingBorder)
{
  NoiseAttachment attachment(8);
  NoiseAttachment none(0);
  const NoiseView view = parallelView({ 400, 400 });
  for (int i = 0; i < 6; ++i)
  {
    Surface surface;
    const double width = 200.0 + 16.0 * i;
    addGrid(surface, { -180, -190, 0 }, { width, 0, 0 }, { 0, 380, 0 }, 10 + i);
    std::vector<NoiseKernel> kernels, fresh;
    attachment.kernels(attachable(surface), view, isotropic(), kernels);
    none.kernels(attachable(surface), view, isotropic(), fresh);
    const glm::dvec2 low(20.0 + width - 14.0, 20.0), high(20.0 + width, 380.0);
    const double share = meanOverlap(kernels, low, high, 2.0) / meanOverlap(fresh, low, high, 2.0);
    EXPECT_NEAR(share, 1.0, 0.2) << i;
  }
}

TEST(NoiseAttachment, OddSurfaces)
{
  Surface triangle;
  triangle.points = { { -1, -1, 0 }, { 1, -1, 0 }, { 0, 1, 0 } };
  triangle.triangles = { { 0, 1, 2 } };
  Surface line = triangle;
  line.points[2] = { 3, -1, 0 };
  NoiseAttachment attachment(8);
  std::vector<NoiseKernel> kernels, fresh;
  const auto draw = [&](const Surface& surface)
  { attachment.kernels(attachable(surface), viewAt(4.0), isotropic(), kernels); };
  for (const Surface& odd : { Surface(), line })
  {
    draw(triangle);
    EXPECT_GT(kernels.size(), 100u);
    fresh = kernels;
    draw(triangle);
    EXPECT_TRUE(sameKernels(kernels, fresh)) << "an equal triangle";
    draw(odd);
    EXPECT_TRUE(kernels.empty());
    draw(triangle);
    EXPECT_TRUE(sameKernels(kernels, fresh));
  }
  // Another triangle in the same place, then one that is far away.
  Surface moved = triangle;
  moved.points[2].x = 0.001;
  draw(moved);
  EXPECT_GT(attachment.carriedCount(), 100u);
  EXPECT_FALSE(sameKernels(kernels, fresh));
  for (glm::dvec3& point : moved.points)
  {
    point.z -= 3.0;
  }
  draw(moved);
  EXPECT_EQ(attachment.carriedCount(), 0u);
  NoiseAttachment none(0);
  none.kernels(attachable(moved), viewAt(4.0), isotropic(), fresh);
  EXPECT_TRUE(sameKernels(kernels, fresh));
}

// Kernels that are hidden in a frame come to light in one after the change.
TEST(NoiseAttachment, HiddenKernelsAreCarried)
{
  const std::vector<float> wall(260 * 260, 0.1f);
  NoiseSurroundings before;
  before.rectangle = { 0, 0, 260, 260 };
  before.depth = wall;
  const NoiseOcclusion hidden(before, static_cast<float>(isotropic().radius));
  for (const bool controlled : { false, true })
  {
    NoiseKernelOptions options = isotropic();
    if (controlled)
    {
      options.control = [](const NoisePoint&) { return NoiseKernelOptions::Control{}; };
    }
    std::vector<NoiseKernel> kernels, expected;
    NoiseAttachment attachment(8), other(8);
    attachment.kernels(attachable(sphereOf(0)), viewAt(4.0), options, kernels, &hidden);
    other.kernels(attachable(sphereOf(0)), viewAt(4.0), options, expected);
    attachment.kernels(attachable(sphereOf(1)), viewAt(4.0), options, kernels);
    other.kernels(attachable(sphereOf(1)), viewAt(4.0), options, expected);
    EXPECT_TRUE(sameKernels(kernels, expected)) << controlled;
    EXPECT_GT(attachment.carriedCount(), 100u);
  }
}

TEST(NoiseAttachment, ControlledKernelsKeepTheirOverlap)
{
  NoiseAttachment attachment(6);
  NoiseKernelOptions options = isotropic();
  for (int i = 0; i < 14; ++i)
  {
    Surface square;
    addGrid(square, { -400, -200, 0 }, { 800, 0, 0 }, { 0, 400, 0 }, 10 + i % 5);
    const int half = static_cast<int>(square.triangles.size()) / 2;
    const int columns = 10 + i % 5;
    options.control = [&](const NoisePoint& point)
    {
      NoiseKernelOptions::Control control;
      control.bandwidth = point.triangle < half ? 0.5 : 1.5;
      return control;
    };
    std::vector<NoiseKernel> kernels;
    attachment.kernels(attachable(square), parallelView({ 800, 400 }), options, kernels);
    options.control = nullptr; // and what it refers to is gone
    if (columns % 2 == 0)
    {
      EXPECT_NEAR(meanOverlap(kernels, { 0, 0 }, { 300, 400 }), 32.0, 3.2) << i;
      EXPECT_NEAR(meanOverlap(kernels, { 500, 0 }, { 800, 400 }), 32.0, 1.6) << i;
    }
  }
}

TEST(NoiseAttachment, AreasOfTrianglesThatWereKnown)
{
  Surface square;
  addGrid(square, { -200, -150, 0 }, { 400, 0, 0 }, { 0, 300, 0 }, 6);
  const std::vector<std::uint64_t> ids = [&]
  {
    std::vector<std::uint64_t> result(square.triangles.size());
    for (std::size_t i = 0; i < result.size(); ++i)
    {
      result[i] = 1000 + i;
    }
    return result;
  }();
  const std::vector<double> areas(ids.size(), 0.5 * 400.0 * 300.0 / 36.0);
  // Stretched, and without some of its triangles.
  Surface later = square;
  for (glm::dvec3& point : later.points)
  {
    point.x *= 1.2;
  }
  later.triangles.resize(40);
  later.patches.clear();
  const NoiseView view = parallelView({ 400, 300 });
  std::vector<NoiseKernel> before, after;
  NoiseAttachment attachment(8);
  const auto first = std::make_shared<NoiseSurface>(square.mesh(), ids);
  attachment.kernels(first, view, isotropic(), before);
  const auto second =
    std::make_shared<NoiseSurface>(later.mesh(), Span<const std::uint64_t>(ids.data(), 40),
      Span<const std::int32_t>(), 1, Span<const double>(areas.data(), 40));
  attachment.kernels(second, view, isotropic(), after);
  NoiseSurface same(square.mesh(), ids);
  same.setPositions(later.points);
  std::vector<NoiseKernel> expected = same.kernels(view, isotropic());
  expected.erase(std::remove_if(expected.begin(), expected.end(),
                   [](const NoiseKernel& kernel) { return kernel.triangle >= 40; }),
    expected.end());
  ASSERT_GT(expected.size(), 1000u);
  std::map<std::uint64_t, NoiseKernel> found;
  for (const NoiseKernel& kernel : after)
  {
    found[kernel.id] = kernel;
  }
  for (const NoiseKernel& kernel : expected)
  {
    // But for rounding, which depends on the triangles near by.
    const NoiseKernel& other = found[kernel.id];
    EXPECT_NEAR(glm::distance(other.center, kernel.center), 0.0f, 1e-3f);
    EXPECT_NEAR(other.weight, kernel.weight, 1e-4f);
    EXPECT_NEAR(other.orientation, kernel.orientation, 1e-4f);
    EXPECT_EQ(other.phase, kernel.phase);
    EXPECT_EQ(other.triangle, kernel.triangle);
  }
}

TEST(NoiseAttachment, WrongInputIsRefused)
{
  EXPECT_EQ(messageOf([] { NoiseAttachment(-1); }), "life is -1, expected 0 or more");
  NoiseAttachment attachment(8);
  EXPECT_EQ(messageOf([&] { attachment.setLife(-2); }), "life is -2, expected 0 or more");
  std::vector<NoiseKernel> kernels;
  EXPECT_EQ(messageOf([&] { attachment.kernels(nullptr, viewAt(4.0), {}, kernels); }),
    "next is null, expected a surface");
  const auto first = attachable(sphereOf(0));
  attachment.kernels(first, viewAt(4.0), {}, kernels);
  NoiseView view = viewAt(4.0);
  view.viewportSize.x = -1.0;
  EXPECT_NE(
    messageOf([&] { attachment.kernels(attachable(sphereOf(1)), view, {}, kernels); }), "no error");
  std::vector<NoiseKernel> same;
  attachment.kernels(first, viewAt(4.0), {}, same);
  EXPECT_TRUE(sameKernels(kernels, same)) << "as it was";

  Surface square;
  addGrid(square, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 2);
  const auto withAreas = [&](const std::vector<double>& areas)
  { return messageOf([&] { NoiseSurface(square.mesh(), {}, {}, 1, Span<const double>(areas)); }); };
  EXPECT_EQ(withAreas(std::vector<double>(3)), "areas: 3 values for 8 triangles");
  EXPECT_EQ(withAreas(std::vector<double>(8, -1.0)),
    "areas[0] is -1.000000, expected a finite number, 0 or more");
  EXPECT_EQ(withAreas(std::vector<double>(8, 0.5)), "no error");
}
