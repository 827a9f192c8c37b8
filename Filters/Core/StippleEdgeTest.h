// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleEdgeTest_h
#define hachure_StippleEdgeTest_h

#include "Span.h"
#include "StippleEdges.h"
#include "StipplePicture.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace hachure
{

// How far stipples have grown, by rank: 0 to 1, below 0 for those that were not seen, which have
// their full size, or none, as soon as they are.
struct StippleSizes
{
  Span<const float> before; // of as many stipples as there are now; empty: none was seen
  float step = 1.0f;        // of every stipple, toward its end; above 0
  std::vector<float> after;
};

// Which classic stipples a picture shows: those of which the projections of all edges to relevant
// neighbours are longer, in pixels, than a threshold (Meruvia Pastor and Strothotte 2002, sections
// 2.3.3 and 2.5). Edges to a point behind the eye are endless, and a stipple without edges is drawn
// wherever there is any tone. The paper leaves the threshold open; here it is that which makes the
// tone at the stipple, with the discs' diameter, the surface's tilt and the scale there
// (StippleThresholds). Where there are not enough stipples, the picture is one from farther away,
// magnified.
class StippleEdgeTest : private StipplePicture
{
public:
  // Throws std::invalid_argument naming what is out of its range. What the spans hold must stay.
  StippleEdgeTest(const StippleScene& someScene, const StippleLook& someLook);

  // The stipples that are drawn, in the order of their ranks. They grow with their shortest edge,
  // until it is by the growth longer than the threshold: a function of the picture alone.
  void draw(const StippleEdges& edges, std::vector<DrawnStipple>& drawn) const;
  // They grow and shrink from frame to frame. Throws for sizes of another number of stipples.
  void draw(const StippleEdges& edges, StippleSizes& sizes, std::vector<DrawnStipple>& drawn) const;

private:
  struct Verdict;
  struct Wanted;
  using Projections = std::vector<glm::dvec3>; // x and y in pixels, w
  Projections project(const StippleEdges& edges) const;
  Wanted wantedAt(const Place& place, float areaRatio, const StippleThresholds& thresholds) const;
  Verdict judge(const StippleEdges& edges, const StippleThresholds& thresholds,
    const Projections& projections, std::size_t rank) const;
  template <class Size>
  void drawAll(const StippleEdges& edges, const StippleThresholds& thresholds, const Size& size,
    std::vector<DrawnStipple>& drawn) const;

  StippleLook look;
};

} // namespace hachure

#endif
