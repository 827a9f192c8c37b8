// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseProjection_h
#define hachure_NoiseProjection_h

#include "NoiseBlock.h"
#include "NoiseSurface.h"
#include "NoiseSurfaceTree.h"

#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace hachure
{

// Throws std::invalid_argument naming what is out of its range.
void checkNoiseView(const NoiseView& view);
void checkNoiseOptions(const NoiseKernelOptions& options);

inline NoiseTriangle noiseTriangleAt(
  Span<const glm::dvec3> positions, const glm::ivec3& corners, double area)
{
  const glm::dvec3& origin = positions[corners.x];
  return { origin, positions[corners.y] - origin, positions[corners.z] - origin, area };
}

// A view and the options of its kernels, ready for many points.
class NoiseProjection
{
public:
  NoiseProjection(const NoiseView& view, const NoiseKernelOptions& options);

  // Whether no kernel of a point in the sphere can meet the viewport.
  bool misses(const NoiseSphere& sphere) const;

  // No surface in the sphere that meets the viewport has a picture of more square pixels per unit
  // of its area.
  double magnificationBound(const NoiseSphere& sphere) const;

  // No point in the sphere that meets the viewport has a higher density than this.
  double densityBound(const NoiseSphere& sphere, double stretch) const;

  // For blocks of a frame; and the same for another frame with this unit.
  NoiseBlockView blockView(const NoiseFrame& frame) const;
  NoiseBlockView movedTo(NoiseBlockView view, const NoiseFrame& frame) const;

  // The kernel of a point that is seen, with a weight; false where its disc does not meet the
  // viewport.
  bool placeKernel(const NoiseImages& images, int lane, const NoisePoint& point,
    const NoiseKernelOptions::Control& control, double weight, NoiseKernel& kernel) const;

  // Whether a single point of a triangle has a kernel; sets all of it but the object.
  bool makeKernel(
    const NoiseTriangle& triangle, const NoisePoint& point, NoiseKernel& kernel) const;

  // Weight of a point of a block, with its control.
  double weight(const NoiseImages& images, const NoiseBlock& block, int lane,
    const NoiseKernelOptions::Control& control) const;

  bool isControlled() const { return static_cast<bool>(this->options.control); }
  NoiseKernelOptions::Control control(const NoisePoint& point) const;

  // Length on a surface that faces the viewer at this point, which spans the radius of a kernel
  // without a control; infinite behind the eye.
  double radiusAt(const glm::dvec3& point) const;

private:
  bool meetsViewport(const glm::vec2& center, double radius) const;
  double orientation(const NoiseImages& images, int lane, const glm::dvec3& direction) const;

  const NoiseKernelOptions& options;
  glm::dvec2 origin, size;
  // Rows of the matrix to clip space.
  glm::dvec4 rowX, rowY, rowZ, rowW;
  double densityPerMagnification; // kernels per square pixel where all of them have the radius
  double largestRadius;
  double highestDensityFactor;      // of a control
  std::array<glm::dvec4, 6> planes; // inside: above 0; of unit normals
  double nearest = 0.0;             // w at the near plane; 0: unknown
  double normLimit = 0.0;           // of the image of a unit of surface at w = 1, square pixels
  double rowWLength = 0.0;
};

// Kernels, and the points of each where they are wanted.
struct NoiseOutput
{
  bool wantsPoints = false;
  std::vector<NoiseKernel> kernels;
  std::vector<NoisePoint> points;

  void add(const NoiseKernel& kernel, const NoisePoint& point)
  {
    this->kernels.push_back(kernel);
    if (this->wantsPoints)
    {
      this->points.push_back(point);
    }
  }
};

// What threads find in parts, and in the end all of it in the order of the parts.
struct NoiseOutputs
{
  std::vector<NoiseOutput> parts;

  // Empty parts, with the memory of those before.
  void restart(std::int64_t count, bool wantsPoints);
  void join(std::vector<NoiseKernel>& kernels, std::vector<NoisePoint>* points) const;
};

} // namespace hachure

#endif
