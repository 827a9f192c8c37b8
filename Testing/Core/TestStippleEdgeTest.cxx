// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CallTests.h"
#include "StippleScene.h"

#include "StippleCanvas.h"
#include "StippleEdgeTest.h"
#include "StippleTone.h"

#include <glm/gtc/matrix_transform.hpp>

#include <omp.h>

#include <map>
#include <memory>

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

} // namespace

TEST(StippleEdgeTest, DISABLED_Explore)
{
  struct Named { const char* name; Surface surface; };
  const Named all[] = { { "hexagon", hexagon(0) }, { "hexirr", hexagon(5) }, { "grid", planeOf(20, 0.0, 1) },
    { "jit20", planeOf(20, 0.9, 2) }, { "jit100", planeOf(100, 0.9, 3) }, { "jit200", planeOf(200, 0.9, 3) } };
  for (const Named& named : all)
  {
    const StippleEdges edges = edgesOf(named.surface, 20000, 7);
    for (const double pixels : { 900.0, 450.0, 2000.0 })
    {
    for (const double facing : { 1.0, 0.5, 0.25 })
    {
      if (facing < 1 && pixels < 900) continue;
      for (const bool isFull : { false, true })
      {
        std::printf("%8s %5.0f f %.2f full %d:", named.name, pixels, facing, isFull);
        for (const float tone : { 0.05f, 0.1f, 0.25f, 0.5f, 0.75f, 0.9f })
        {
          StippleLook look; 
          look.diameter = 4.0f;
          const auto drawn = drawnOf(edges, sceneOf(pixels / std::sqrt(facing) , std::acos(facing), tone), look, isFull);
          std::printf(" %+.3f (%5zu)", inkOf(drawn) - tone, drawn.size());
        }
        std::printf("\n");
      }
    }
    }
  }
}
