// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceChartsRing_h
#define hachure_SurfaceChartsRing_h

#include "SurfaceChartsMesh.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

// Internal: the triangles around a vertex that is to go, laid into a plane.
namespace hachure
{

// What a collapse must keep.
struct RingLimits
{
  double cosine;      // between the normals before and after, at least
  double quality;     // of triangles, 1 for equal sides: at least
  double flatQuality; // in the plane
  double borderTurn;  // radians that a border may turn at the vertex
  int ends;           // neighbours that the other vertex may get, where it gets more
};

// First what keeps the surface's shape, then what keeps the corners of its borders, then what is
// possible. Skewed triangles would be no
// obstacle to the map, but over their rims small triangles of the mesh would be turned over.
constexpr RingLimits strictLimits = { 0.3, 0.3, 0.35, 0.7, 8 };
constexpr RingLimits looseLimits = { -1.0, 0.1, 0.2, 1.3, 9 };
constexpr RingLimits lastLimits = { -1.0, 0.1, 0.2, 4.0, 9 };

// A new triangle, in the place of an old one.
struct FlatTriangle
{
  std::size_t place = 0; // in the ring
  double share = 0.0;    // of the ring's area
  glm::dvec2 first{ 0.0 };
  glm::dvec2 second{ 0.0 };
  glm::dvec2 third{ 0.0 };

  // Inside, up to rounding: none is negative.
  glm::dvec3 weightsOf(const glm::dvec2& point) const;
};

class FlatRing
{
public:
  // The vertex is at the origin. Angles are scaled to a full turn, at borders to half of one, and
  // distances as z^a does it. False if there is no such map.
  bool lay(const CornerMesh& mesh, std::int32_t vertex, const VertexRing& ring);

  // How good the triangles would be if the vertex became an end of the ring; 0 where it must not.
  // mostShare: of the ring's area in one of them.
  double score(const RingLimits& limits, int target, double mostShare) const;

  // Afterwards `fan` has the triangles.
  void makeFan(int target);
  const FlatTriangle& under(const glm::dvec2& place) const;
  std::vector<FlatTriangle> fan;

  // In the triangle at a place of the ring, by the weights of its two ends.
  glm::dvec2 inPlane(std::size_t place, double first, double second) const
  {
    return first * this->places[place] + second * this->places[(place + 1) % this->places.size()];
  }

private:
  void flatten(double scale); // of angles
  void rate();                // the triangles as they are
  // Of the triangles that stay: place in the ring and the place after it.
  template <class Visit>
  void visitFan(int target, Visit&& visit) const;

  bool keepsNormal(std::size_t apex, std::size_t one, std::size_t other, double cosine) const;

  bool isClosed = false;
  double worstNow = 1.0;  // quality of a triangle now, in space
  double worstFlat = 1.0; // and in the plane
  double borderTurn = 0.0;
  glm::dvec3 centre{ 0.0 };
  std::vector<glm::dvec3> corners; // of ends, in space
  std::vector<glm::dvec2> places;  // and in the plane
  std::vector<double> angles;
};

} // namespace hachure

#endif
