// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseOcclusion_h
#define hachure_NoiseOcclusion_h

#include "NoiseField.h"

#include <vector>

namespace hachure
{

// Which kernels are hidden for certain: those that a depth image leaves no share of
// (NoiseVisibility), told from their centre and plane alone, so that they need not be made. Where
// neither the depth test nor partial visibility is on, nothing is hidden.
class NoiseOcclusion
{
public:
  // radius: the largest of a kernel, pixels. Throws as noiseField does.
  NoiseOcclusion(const NoiseSurroundings& surroundings, float radius);

  // Of a kernel at a place in the framebuffer; slope: change of its plane's depth per pixel.
  bool hides(float x, float y, float depth, float slope) const
  {
    const float column = (x - this->left) * (1.0f / cellSize);
    const float row = (y - this->bottom) * (1.0f / cellSize);
    if (!(column >= 0.0f && row >= 0.0f && column < this->width && row < this->height))
    {
      return false;
    }
    const std::size_t cell =
      static_cast<std::size_t>(row) * this->columns + static_cast<std::size_t>(column);
    // The nearest of its plane, less what may be off it.
    return depth - this->steepening * slope > this->farthest[cell] + this->tolerance;
  }

private:
  static constexpr float cellSize = 8.0f; // pixels
  float left = 0.0f, bottom = 0.0f;
  float width = 0.0f, height = 0.0f; // cells, parts of them too
  float steepening = 0.0f, tolerance = 0.0f;
  std::size_t columns = 0;
  std::vector<float> farthest; // depth that is seen within reach of the cell; 0: nothing is
};

} // namespace hachure

#endif
