// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SampleProjection_h
#define hachure_SampleProjection_h

#include "Span.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

// Where the samples of a surface lie in the image, and how much of the image each stands for.
// Image space: logical pixels, y up, origin at the lower left corner of the viewport.
namespace hachure
{

// One view of a model. modelToView ends in a space with the camera at the origin, looking along -z;
// viewToClip is the projection alone, OpenGL's convention for depth.
struct ViewProjection
{
  glm::dmat4 modelToView{ 1.0 };
  glm::dmat4 viewToClip{ 1.0 };
  glm::dvec2 viewportSize{ 1.0, 1.0 }; // logical pixels

  bool operator==(const ViewProjection& other) const;
};

// The samples of one frame, in model space. Samples keep their index from frame to frame.
struct TrackedSamples
{
  Span<const glm::dvec3> positions;
  Span<const glm::dvec3> normals;   // outward, of unit length; 0 = never faces the viewer
  Span<const std::int32_t> patches; // patch of each sample from 0 on; empty = all 0
  Span<const double> patchSpacing;  // distance between samples, model units; index = patch
  // Factors of the weights, finite and 0 or more, as from featureFactors; empty = all 1.
  Span<const double> features = {};
};

enum class FacingRule
{
  FrontOnly, // max(0, n.v)
  BothSides, // |n.v|
  Signed     // n.v: a negative weight for a surface seen from its inner side
};

// The weight is the area, in square pixels, of the image of the disc that lies tangent to the
// surface at the sample and has the sample spacing as its diameter (Breslav et al. 2007,
// section 3.1), times the sample's feature. It is 0 behind the camera and outside a frustum widened
// by `frustumMargin`. Where it is 0 the position may be meaningless, but is finite.
struct ProjectedSample
{
  glm::dvec2 position{ 0.0 };
  double weight = 0.0;
};

// One frame, an array for each component, so that several samples are read at once.
struct ProjectedSamples
{
  std::vector<double> x, y, weights;

  std::size_t size() const { return this->weights.size(); }
  ProjectedSample operator[](std::size_t i) const
  {
    return { { this->x[i], this->y[i] }, this->weights[i] };
  }
  bool operator==(const ProjectedSamples& other) const;
};

// Samples this far out, in halves of the viewport from its centre, still steer a pattern.
constexpr double frustumMargin = 1.2;

// Throws std::invalid_argument on arrays of different sizes, values that are not finite, a patch
// without spacing, and an empty viewport.
ProjectedSamples projectSamples(
  const TrackedSamples& samples, const ViewProjection& view, FacingRule facing);
// The same into the memory of a frame before. What it holds after an exception is unspecified.
void projectSamples(const TrackedSamples& samples, const ViewProjection& view, FacingRule facing,
  ProjectedSamples& projected);

// n.v of every sample: the cosine of the angle between its normal and the way to the eye, below 0
// for a surface seen from its inner side; 0 where the normal is. Throws as projectSamples does.
std::vector<double> sampleFacing(const TrackedSamples& samples, const ViewProjection& view);

// 1 + the highest patch, 0 without samples.
std::size_t patchCount(const TrackedSamples& samples);

// The checks of projectSamples alone.
void checkSamples(const TrackedSamples& samples);
void checkView(const ViewProjection& view);

} // namespace hachure

#endif
