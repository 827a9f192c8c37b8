// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewFade_h
#define hachure_ViewFade_h

#include "TextureView.h"

#include <glm/vec3.hpp>

#include <vector>

// From where a dependent view is seen (Grimm and Kowalski 2002, section 5 and figure 2). The
// paper projects four extreme points onto a plane, where their polygon need not be convex; here all
// is done with angles on the sphere of directions, for any number of points.
namespace hachure
{

// A part of the sphere of directions around its centre. Its border goes through the extreme
// directions, in the order in which they lie around the centre: along great circles between
// neighbours that are less than half a turn apart there, else the angle from the centre is
// interpolated. One extreme direction gives a cone, none the whole sphere.
class FadeRegion
{
public:
  // Directions of any length; those that are equal to the centre are left out, and where only such
  // are given the region is the centre alone.
  FadeRegion(const glm::dvec3& centre, Span<const glm::dvec3> extremes);

  // Of a direction of unit length: its angle from the centre over that of the border on the same
  // side, 0 or more. Beyond twice the border any number of at least 1 is given.
  float relativeAngle(const glm::vec3& direction) const;

private:
  struct Sector // from an extreme direction to the next
  {
    glm::vec3 direction{ 0.0f };
    float cosine = 1.0f, sine = 0.0f; // from the centre
    float order = 0.0f;               // rises with the angle around the centre
    bool isGreatCircle = false;
    glm::vec3 normal{ 0.0f }; // of the great circle
    float height = 0.0f;      // of the centre over it
    // Others, radians: around the centre, and from the centre at both ends.
    float begin = 0.0f, width = 0.0f;
    float angle = 0.0f, nextAngle = 0.0f;
  };

  void closeSector(Sector& sector, const Sector& next) const;
  const Sector& sectorAt(const glm::vec3& direction) const;
  float aroundOf(const glm::vec3& direction) const;
  float borderAt(const glm::vec3& direction, float cosine, float sine) const;

  glm::vec3 centre{ 0.0f, 0.0f, 1.0f };
  glm::vec3 side{ 1.0f, 0.0f, 0.0f }; // both at right angles to the centre and each other
  glm::vec3 up{ 0.0f, 1.0f, 0.0f };
  bool isEverywhere = false;
  float cone = -1.0f;          // radians; negative: none
  float leastCosine = -1.0f;   // from the centre; whatever is less is beyond
  std::vector<Sector> sectors; // by `order`
};

// The value of a fade curve at a relative angle.
float fadeCurveAt(Span<const glm::dvec2> curve, float relativeAngle);

// The shares of a view in the directions of a cell.
class ViewFade
{
public:
  // Of a checked view, which must stay.
  explicit ViewFade(const TextureView& view);

  // directions: from the cell, of unit length; shares: as many, 0 to 1. fromMiddle, 0 to 1: how far
  // from the middle of what the view shows the cell is, for FadeMode::Middle. There the view is
  // taken from the curve as if further out: for m from the middle and relative angle r at
  // 1 - clamp(2 (1 - r) - m, 0, 1), so that the middle is whole at r = 1/2, where the outermost
  // begins, and all is whole at 0. Beyond the border the share is 0.
  void shares(const glm::dvec3& cell, float fromMiddle, Span<const glm::vec3> directions,
    Span<float> shares) const;

private:
  FadeRegion regionOf(const glm::dvec3& from) const;
  float shareOf(float relativeAngle, float fromMiddle) const;
  glm::vec3 fromFocus(const glm::dvec3& cell, const glm::vec3& direction) const;

  const TextureView* view;
  FadeRegion even; // about the focus
};

} // namespace hachure

#endif
