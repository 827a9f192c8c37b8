// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CallTests.h"
#include "Random.h"
#include "StippleScene.h"

#include "StippleCanvas.h"
#include "StippleEdgeTest.h"
#include "StippleTone.h"

#include <glm/gtc/matrix_transform.hpp>

#include <omp.h>

#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace hachure;

namespace
{

constexpr int side = 320; // pixels of the picture

// Looked at from straight above, a unit `pixels` wide, turned away by an angle.
StippleScene sceneOf(double pixels, double tilt, float tone)
{
  StippleScene scene;
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), tilt, glm::dvec3(0.8, 0.6, 0.0));
  const double half = 0.5 * side / pixels;
  scene.view.modelToClip = glm::ortho(-half, half, -half, half, -2.0, 2.0) * turn;
  scene.view.viewportSize = glm::dvec2(side);
  scene.rectangle = { 0, 0, side, side };
  scene.toneOf.fill(tone);
  return scene;
}

// Around the origin; its inner points are moved by up to half of `jitter` squares.
Surface planeOf(int grid, double jitter, std::uint32_t seed)
{
  Surface plane = unitPlane(grid);
  for (std::size_t i = 0; i < plane.points.size(); ++i)
  {
    glm::dvec3& point = plane.points[i];
    point -= glm::dvec3(0.5, 0.5, 0.0);
    const bool isInside = std::max(std::abs(point.x), std::abs(point.y)) < 0.499;
    const double most = isInside ? jitter / grid : 0.0;
    point.x += most * (unitRandom(seed, i, 0) - 0.5);
    point.y += most * (unitRandom(seed, i, 1) - 0.5);
  }
  return plane;
}

// Six corners and a point inside; irregular with a seed.
Surface hexagon(std::uint32_t seed)
{
  Surface surface;
  const auto random = [seed](std::uint64_t id, std::uint32_t dimension)
  { return seed > 0 ? 0.5 * (unitRandom(seed, id, dimension) - 0.5) : 0.0; };
  for (int i = 0; i < 6; ++i)
  {
    const double angle = i * std::acos(0.5) + random(static_cast<std::uint64_t>(i), 2);
    surface.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    surface.triangles.emplace_back(i, (i + 1) % 6, 6);
  }
  surface.points.emplace_back(random(9, 0), random(9, 1), 0.0);
  return surface;
}

StippleOptions classic(std::int64_t count, std::uint32_t seed = 1)
{
  StippleOptions options;
  options.order = StippleOrder::Classic;
  options.count = count;
  options.seed = seed;
  return options;
}

StippleEdges edgesOf(const Surface& surface, std::int64_t count, std::uint32_t seed = 1)
{
  return StippleEdges(surface.mesh(), stippleSurface(surface.mesh(), classic(count, seed)));
}

double inkOf(const std::vector<DrawnStipple>& drawn)
{
  std::vector<StippleDisc> discs;
  discs.reserve(drawn.size());
  for (const DrawnStipple& stipple : drawn)
  {
    discs.push_back(stipple.disc);
  }
  StippleCanvas canvas;
  std::vector<std::uint8_t> covered;
  canvas.draw(discs, side, side, covered);
  double sum = 0.0;
  for (const std::uint8_t places : covered)
  {
    sum += places;
  }
  return sum / (static_cast<double>(covered.size()) * StippleCanvas::samplesPerPixel);
}

std::vector<DrawnStipple> drawnOf(
  const StippleEdges& edges, const StippleScene& scene, const StippleLook& look, bool isFull)
{
  std::vector<DrawnStipple> drawn;
  StippleSizes sizes;
  const StippleEdgeTest test(scene, look);
  isFull ? test.draw(edges, sizes, drawn) : test.draw(edges, drawn);
  return drawn;
}

const StippleEdges& manyEdges()
{
  static const StippleEdges edges = edgesOf(planeOf(20, 0.0, 1), 20000);
  return edges;
}

void expectInk(const StippleEdges& edges, const StippleScene& scene, float diameter, float tone,
  double tolerance, const std::string& what)
{
  for (const bool isFull : { false, true })
  {
    StippleLook look;
    look.diameter = diameter;
    EXPECT_NEAR(inkOf(drawnOf(edges, scene, look, isFull)), tone, tolerance)
      << what << ", diameter " << diameter << (isFull ? ", full size" : "");
  }
}

// Pixels of the picture, y up; z: w.
glm::dvec3 projected(const StippleScene& scene, const glm::dvec3& point)
{
  const glm::dvec4 clip = scene.view.modelToClip * glm::dvec4(point, 1.0);
  return { (0.5 * clip.x / clip.w + 0.5) * side, (0.5 * clip.y / clip.w + 0.5) * side, clip.w };
}

double shortestOf(const StippleEdges& edges, const StippleScene& scene, std::size_t rank)
{
  double shortest = std::numeric_limits<double>::infinity();
  const glm::dvec2 own(projected(scene, edges.places()[rank]));
  for (const std::int32_t neighbour : edges.neighbours(rank))
  {
    const glm::dvec3 other = projected(scene, edges.places()[static_cast<std::size_t>(neighbour)]);
    shortest = other.z > 0.0 ? std::min(shortest, glm::length(glm::dvec2(other) - own)) : shortest;
  }
  return shortest;
}

// The threshold at a point of the plane z = 0, from differences of projections.
double thresholdOf(const StippleThresholds& thresholds, const StippleScene& scene,
  const glm::dvec3& eye, const StippleLook& look, const glm::dvec3& place)
{
  const double step = 1e-5;
  const glm::dvec2 here(projected(scene, place));
  const glm::dvec2 u = (glm::dvec2(projected(scene, place + glm::dvec3(step, 0, 0))) - here) / step;
  const glm::dvec2 v = (glm::dvec2(projected(scene, place + glm::dvec3(0, step, 0))) - here) / step;
  const double magnification = std::abs(u.x * v.y - u.y * v.x);
  const auto facing = static_cast<float>(std::abs(glm::normalize(eye - place).z));
  const double discs = stippleClassicDiscArea(scene.toneOf[0], facing, 0.0f) /
    (0.25 * std::acos(-1.0) * look.diameter * look.diameter);
  return thresholds.threshold(discs * magnification) *
    std::sqrt(magnification * stippleEdgeCrowd(facing) / stippleEdgeCrowd(1.0f));
}

} // namespace

TEST(StippleEdgeTest, InkIsTheTone)
{
  const std::pair<std::string, Surface> planes[] = { { "hexagon", hexagon(0) },
    { "irregular hexagon", hexagon(5) }, { "grid", planeOf(20, 0.0, 1) },
    { "irregular", planeOf(20, 0.9, 2) }, { "fine", planeOf(100, 0.9, 3) },
    { "finer", planeOf(160, 0.9, 4) } };
  std::uint32_t seed = 0;
  for (const auto& [name, plane] : planes)
  {
    const StippleEdges edges = edgesOf(plane, 16000, ++seed);
    for (const float tone : { 0.05f, 0.1f, 0.25f, 0.5f, 0.75f, 0.9f })
    {
      for (const float diameter : { 2.4f, 6.0f })
      {
        expectInk(edges, sceneOf(440.0, 0.0, tone), diameter, tone, 0.02, name);
      }
    }
  }
}

TEST(StippleEdgeTest, InkIsTheToneOfTiltedSurfaces)
{
  for (const double facing : { 0.8, 0.5, 0.25 })
  {
    for (const float tone : { 0.1f, 0.3f, 0.6f, 0.85f })
    {
      const StippleScene scene = sceneOf(900.0 / std::sqrt(facing), std::acos(facing), tone);
      expectInk(manyEdges(), scene, 4.0f, tone, 0.025, std::to_string(facing));
    }
  }
}

TEST(StippleEdgeTest, InkIsTheToneForAnyGrowthAndBySize)
{
  for (const float growth : { 0.05f, 1.0f })
  {
    StippleLook look;
    look.growth = growth;
    look.diameter = 4.0f;
    for (const float tone : { 0.4f, 0.75f })
    {
      EXPECT_NEAR(inkOf(drawnOf(manyEdges(), sceneOf(450, 0.0, tone), look, false)), tone, 0.02);
    }
  }
  StippleLook look;
  look.diameter = 6.0f;
  look.toneBySize = true;
  for (const float tone : { 0.1f, 0.4f, 0.8f })
  {
    const auto drawn = drawnOf(manyEdges(), sceneOf(450, 0.0, tone), look, true);
    EXPECT_NEAR(inkOf(drawn), tone, 0.03);
    const float largest = std::max_element(drawn.begin(), drawn.end(),
      [](const auto& a, const auto& b) {
        return a.disc.radius < b.disc.radius;
      })->disc.radius;
    EXPECT_NEAR(drawn.front().disc.radius, largest, 1e-4);
  }
}

TEST(StippleEdgeTest, WhereStipplesRunOutTheyAreLarger)
{
  for (const double pixels : { 900.0, 2000.0 })
  {
    for (const float tone : { 0.25f, 0.5f, 0.75f })
    {
      expectInk(manyEdges(), sceneOf(pixels, 0.0, tone), 2.4f, tone, 0.025, "few");
    }
  }
  const auto few = drawnOf(manyEdges(), sceneOf(900.0, 0.0, 0.5f), StippleLook(), true);
  EXPECT_GT(few.front().disc.radius, 1.5f);
}

TEST(StippleEdgeTest, StipplesOfEdgesLongerThanTheThresholdAreDrawn)
{
  StippleLook look;
  look.diameter = 6.0f;
  const StippleThresholds thresholds(manyEdges().lengths(), 0.0);
  for (std::uint32_t view = 0; view < 12; ++view)
  {
    const auto random = [view](std::uint32_t i) { return unitRandom(3, view, i); };
    const glm::dvec3 eye(random(0) - 0.5, random(1) - 0.5, 0.6 + random(2));
    const glm::dvec3 target(0.4 * random(3) - 0.2, 0.4 * random(4) - 0.2, 0.0);
    StippleScene scene = sceneOf(side, 0.0, 0.1f + 0.4f * static_cast<float>(random(5)));
    scene.view.modelToClip =
      glm::perspective(0.6, 1.0, 0.1, 5.0) * glm::lookAt(eye, target, glm::dvec3(0.0, 1.0, 0.0));
    std::map<std::int32_t, StippleDisc> drawn;
    for (const DrawnStipple& stipple : drawnOf(manyEdges(), scene, look, true))
    {
      drawn[stipple.index] = stipple.disc;
    }
    EXPECT_GT(drawn.size(), 100u);
    std::size_t checked = 0;
    for (std::size_t rank = 0; rank < manyEdges().size(); ++rank)
    {
      const glm::dvec3 place = projected(scene, manyEdges().places()[rank]);
      if (std::min(place.x, place.y) < 0.0 || std::max(place.x, place.y) > side)
      {
        continue;
      }
      const double ratio = shortestOf(manyEdges(), scene, rank) /
        thresholdOf(thresholds, scene, eye, look, manyEdges().places()[rank]);
      const auto found = drawn.find(static_cast<std::int32_t>(rank));
      if (std::abs(ratio - 1.0) > 1e-4) // else it is rounding
      {
        ASSERT_EQ(found != drawn.end(), ratio > 1.0) << rank << " " << ratio;
      }
      if (found != drawn.end())
      {
        EXPECT_NEAR(found->second.x, place.x, 1e-3);
        EXPECT_NEAR(found->second.y, place.y, 1e-3);
      }
      ++checked;
    }
    EXPECT_GT(checked, 1000u);
  }
}

TEST(StippleEdgeTest, ZoomingInAndDarkeningOnlyAdd)
{
  for (const bool isFull : { false, true })
  {
    std::map<std::int32_t, float> before;
    for (int step = 0; step < 16; ++step)
    {
      const float tone = 0.2f + 0.03f * static_cast<float>(step);
      const auto drawn = drawnOf(
        manyEdges(), sceneOf(200.0 * std::pow(1.03, step), 0.0, tone), StippleLook(), isFull);
      std::map<std::int32_t, float> radii;
      for (const DrawnStipple& stipple : drawn)
      {
        radii[stipple.index] = stipple.disc.radius;
      }
      for (const auto& [rank, radius] : before)
      {
        ASSERT_EQ(radii.count(rank), 1u);
        EXPECT_GE(radii[rank], radius - 1e-4f);
      }
      EXPECT_GT(radii.size(), before.size());
      before = radii;
    }
  }
}

TEST(StippleEdgeTest, StipplesGrowAndShrinkFromFrameToFrame)
{
  const StippleLook look;
  std::vector<DrawnStipple> drawn;
  StippleSizes sizes;
  const StippleScene light = sceneOf(300.0, 0.0, 0.2f), dark = sceneOf(300.0, 0.0, 0.4f);
  StippleEdgeTest(light, look).draw(manyEdges(), sizes, drawn);
  const std::vector<float> lightSizes = sizes.after;
  for (const float size : lightSizes)
  {
    ASSERT_TRUE(size == 0.0f || size == 1.0f || size == -1.0f);
  }
  double ink = inkOf(drawn);
  sizes.step = 1.0f / 7.0f;
  for (int frame = 0; frame < 7; ++frame)
  {
    const std::vector<float> before = sizes.after;
    sizes.before = before;
    StippleEdgeTest(dark, look).draw(manyEdges(), sizes, drawn);
    EXPECT_GT(inkOf(drawn), ink);
    ink = inkOf(drawn);
  }
  StippleSizes atOnce;
  StippleEdgeTest(dark, look).draw(manyEdges(), atOnce, drawn);
  EXPECT_EQ(sizes.after, atOnce.after);
  EXPECT_NEAR(ink, 0.4 * 300.0 * 300.0 / (side * side), 0.02);
  for (int frame = 0; frame < 7; ++frame)
  {
    const std::vector<float> before = sizes.after;
    sizes.before = before;
    StippleEdgeTest(light, look).draw(manyEdges(), sizes, drawn);
    EXPECT_LT(inkOf(drawn), ink);
    ink = inkOf(drawn);
  }
  EXPECT_EQ(sizes.after, lightSizes);
}

TEST(StippleEdgeTest, StipplesThatWereNotSeenAreGrownAtOnce)
{
  // Something that hides the left half goes away.
  StippleScene scene = sceneOf(300.0, 0.0, 0.3f);
  std::vector<float> depth(static_cast<std::size_t>(side) * side, 0.5f);
  for (std::size_t i = 0; i < depth.size(); ++i)
  {
    depth[i] = i % side < side / 2 ? 0.4f : 0.5f;
  }
  scene.depth = depth;
  StippleSizes sizes;
  std::vector<DrawnStipple> drawn;
  StippleEdgeTest(scene, {}).draw(manyEdges(), sizes, drawn);
  EXPECT_GT(drawn.size(), 300u);
  for (const DrawnStipple& stipple : drawn)
  {
    EXPECT_GT(stipple.disc.x, 0.5f * side - 0.5f);
  }
  scene.depth = {};
  const std::vector<float> before = sizes.after;
  sizes.before = before;
  sizes.step = 0.01f;
  StippleEdgeTest(scene, {}).draw(manyEdges(), sizes, drawn);
  EXPECT_NEAR(inkOf(drawn), 0.3 * 300.0 * 300.0 / (side * side), 0.02);
}

TEST(StippleEdgeTest, StretchedSurfacesKeepTheirTone)
{
  const Surface plane = planeOf(20, 0.0, 1);
  StippleEdges edges = edgesOf(plane, 20000);
  std::vector<glm::dvec3> points = plane.points;
  for (glm::dvec3& point : points)
  {
    point *= 1.7;
  }
  edges.setPositions(points);
  expectInk(edges, sceneOf(250.0, 0.0, 0.4f), 2.4f, 0.4f, 0.02, "stretched");
  // It is the picture of a nearer surface.
  const StippleScene near = sceneOf(1.7 * 250.0, 0.0, 0.4f);
  const auto stretched = drawnOf(edges, sceneOf(250.0, 0.0, 0.4f), {}, true);
  EXPECT_NEAR(static_cast<double>(stretched.size()),
    static_cast<double>(drawnOf(manyEdges(), near, {}, true).size()), 3.0);
}

TEST(StippleEdgeTest, ThreadsDoNotMatter)
{
  const int before = omp_get_max_threads();
  const StippleScene scene = sceneOf(400.0, 0.7, 0.4f);
  std::vector<std::vector<DrawnStipple>> pictures;
  for (const int threads : { 1, 5 })
  {
    omp_set_num_threads(threads);
    pictures.push_back(drawnOf(manyEdges(), scene, {}, false));
  }
  omp_set_num_threads(before);
  ASSERT_EQ(pictures[0].size(), pictures[1].size());
  for (std::size_t i = 0; i < pictures[0].size(); ++i)
  {
    ASSERT_EQ(pictures[0][i].index, pictures[1][i].index);
    ASSERT_EQ(pictures[0][i].disc.x, pictures[1][i].disc.x);
    ASSERT_EQ(pictures[0][i].disc.radius, pictures[1][i].disc.radius);
  }
}

TEST(StippleEdgeTest, StipplesWithoutEdgesAreAlwaysDrawn)
{
  const Surface plane = planeOf(1, 0.0, 1);
  const StippleEdges edges = edgesOf(plane, 3);
  for (std::size_t rank = 0; rank < edges.size(); ++rank)
  {
    EXPECT_TRUE(edges.neighbours(rank).size() == 0);
  }
  for (const bool isFull : { false, true })
  {
    EXPECT_EQ(drawnOf(edges, sceneOf(200.0, 0.0, 0.01f), {}, isFull).size(), 3u);
    EXPECT_TRUE(drawnOf(edges, sceneOf(200.0, 0.0, 0.0f), {}, isFull).empty());
    EXPECT_TRUE(drawnOf(edgesOf(plane, 0), sceneOf(200.0, 0.0, 0.5f), {}, isFull).empty());
    EXPECT_TRUE(drawnOf(StippleEdges(), sceneOf(200.0, 0.0, 0.5f), {}, isFull).empty());
  }
}

TEST(StippleEdgeTest, DegenerateTrianglesAndEyesInTheSurfaceAreSilent)
{
  Surface plane = planeOf(6, 0.0, 1);
  plane.triangles.push_back(plane.triangles.front());
  plane.triangles.emplace_back(0, 0, 1);
  plane.patches.clear();
  StippleEdges edges = edgesOf(plane, 2000);
  StippleScene scene = sceneOf(side, 0.0, 0.3f);
  scene.view.modelToClip = glm::perspective(0.6, 1.0, 0.01, 5.0) *
    glm::lookAt(glm::dvec3(0.0, 0.0, 0.02), glm::dvec3(0.3, 0.0, 0.0), glm::dvec3(0.0, 0.0, 1.0));
  for (const DrawnStipple& stipple : drawnOf(edges, scene, {}, true))
  {
    EXPECT_TRUE(std::isfinite(stipple.disc.x + stipple.disc.y + stipple.disc.radius));
  }
  edges.setPositions(std::vector<glm::dvec3>(plane.points.size(), glm::dvec3(0.1)));
  EXPECT_TRUE(drawnOf(edges, scene, {}, true).empty());
}

TEST(StippleEdgeTest, WrongInputIsRefused)
{
  const Surface plane = planeOf(4, 0.0, 1);
  const StippleHierarchy good = stippleSurface(plane.mesh(), classic(100));
  const auto refusal = [&](const StippleHierarchy& hierarchy)
  { return messageOf([&] { StippleEdges(plane.mesh(), hierarchy); }); };
  StippleHierarchy wrong = good;
  wrong.firstNeighbour.pop_back();
  EXPECT_NE(refusal(wrong).find("classic.firstNeighbour: 100, expected 101"), std::string::npos);
  wrong = good;
  wrong.neighbours[5] = 100;
  EXPECT_NE(refusal(wrong).find("classic.neighbours[5]: 100 of 100"), std::string::npos);
  wrong = good;
  wrong.firstNeighbour[50] = 100000;
  EXPECT_NE(refusal(wrong).find("classic.firstNeighbour[50]: 100000"), std::string::npos);
  wrong = good;
  wrong.points[7].triangle = 1000;
  EXPECT_NE(refusal(wrong).find("base.points[7]"), std::string::npos);
  StippleEdges edges(plane.mesh(), good);
  EXPECT_NE(
    messageOf([&] { edges.setPositions({}); }).find("points: 0, expected 25"), std::string::npos);
  std::vector<glm::dvec3> points = plane.points;
  points[3].y = std::nan("");
  EXPECT_NE(messageOf([&] { edges.setPositions(points); }).find("points[3]"), std::string::npos);
  StippleSizes sizes;
  std::vector<DrawnStipple> drawn;
  const std::vector<float> three(3, 1.0f);
  const StippleScene scene = sceneOf(200.0, 0.0, 0.3f);
  sizes.before = three;
  const auto draw = [&] { StippleEdgeTest(scene, {}).draw(edges, sizes, drawn); };
  EXPECT_NE(messageOf(draw).find("sizes.before: 3, expected 100"), std::string::npos);
  sizes.before = {};
  sizes.step = 0.0f;
  EXPECT_NE(messageOf(draw).find("sizes.step is 0"), std::string::npos);
}
