// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ContourVisibility_h
#define hachure_ContourVisibility_h

#include "ContourSegments.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace hachure
{

// A stretch of a contour in the picture, at most half a pixel long, with one answer to whether it
// is seen.
struct ContourStep
{
  glm::dvec2 from{ 0.0 }, to{ 0.0 }; // pixels of the viewport
  bool isSeen = true;
  bool startsPiece = false; // `from` is the end of a piece, not a place within
  bool isJoined = false;    // goes on where the step before ended
};

// Projects pieces, cuts them off at the viewport and the clipping range, and compares them with the
// depth image.
//
// A contour lies where depth jumps, so at its own place the image may show any of both sides. It is
// seen if the picture beside it, away from its surface, shows nothing that is nearer: pixels are
// looked up along a short way to that side.
class ContourVisibility
{
public:
  ContourVisibility(const ViewProjection& view, const ContourDepth& depth);

  // Appends the steps of a piece, none where nothing of it is within the picture.
  void addSteps(
    const ContourSegment& segment, bool reversed, std::vector<ContourStep>& steps) const;

private:
  struct Beside // what to look for beside a piece
  {
    glm::dvec2 direction{ 0.0 }; // of unit length
    bool bothSides = false;
    double reach = 0.0;     // pixels
    double slack = 0.0;     // window depth
    double steepness = 0.0; // window depth per pixel
  };

  glm::dvec3 toWindow(const glm::dvec4& clip) const;
  glm::dvec2 windowDirection(const glm::dvec3& place, const glm::dvec3& direction) const;
  Beside besideOf(
    const ContourSegment& segment, const glm::dvec3& place, const glm::dvec2& alongLine) const;
  double steepnessOf(const ContourSegment& segment, double depthPerPixel) const;
  bool isSeen(const glm::dvec3& window, const Beside& beside) const;
  bool isSeen(const glm::dvec3& window, const Beside& beside, double side, bool& known) const;

  glm::dmat4 viewToClip;
  glm::dmat4 planeToClip; // view space to clip space, for planes
  glm::dvec2 size;
  ContourDepth depth;
};

} // namespace hachure

#endif
