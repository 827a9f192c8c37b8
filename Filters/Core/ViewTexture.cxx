// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewTexture.h"

#include "SrgbColor.h"
#include "ViewTextureState.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{
// A hue in turns; neither dark nor pale.
glm::vec3 hueColor(double hue)
{
  constexpr double least = 0.25;
  constexpr double most = 0.95;
  glm::vec3 color;
  for (int channel = 0; channel < 3; ++channel)
  {
    const double place = hue + (3 - channel) / 3.0;
    const double turned = 6.0 * (place - std::floor(place));
    const double share = std::clamp(std::abs(turned - 3.0) - 1.0, 0.0, 1.0);
    color[channel] = static_cast<float>(least + (most - least) * share);
  }
  return color;
}

const ViewTextureOptions& checked(const ViewTextureOptions& options)
{
  if (options.hemisphere != 4 && options.hemisphere != 8 && options.hemisphere != 16)
  {
    throw std::invalid_argument("options.hemisphere is " + std::to_string(options.hemisphere) +
      "; expected 4, 8 or 16 directions a side");
  }
  return options;
}
} // namespace

glm::u8vec4 coverageColor(std::size_t view)
{
  constexpr double golden = 0.61803398874989485; // turns: no two of few are alike
  const glm::vec3 color = hueColor(static_cast<double>(view) * golden);
  return { byteOf(color.r), byteOf(color.g), byteOf(color.b), 255 };
}

ViewTexture::ViewTexture(const TriangleMesh& mesh, const SurfaceCells& cells,
  const SurfaceFrames& frames, const ViewTextureOptions& options)
  : state(std::make_unique<State>(mesh, cells, frames, checked(options)))
{
}

ViewTexture::~ViewTexture() = default;
ViewTexture::ViewTexture(ViewTexture&&) noexcept = default;
ViewTexture& ViewTexture::operator=(ViewTexture&&) noexcept = default;

void ViewTexture::setViews(const std::vector<TextureView>& views)
{
  this->state->setViews(views);
}

std::size_t ViewTexture::viewCount() const
{
  return this->state->entries.size();
}

void ViewTexture::setImage(std::size_t view, const TextureImage& image)
{
  this->state->setImage(view, image);
}

const ViewTextureColors& ViewTexture::colors(ViewTextureContent content, const ProgressFn& progress)
{
  return this->state->colors(content, progress);
}

double ViewTexture::depthOf(std::size_t view)
{
  State::Entry& entry = this->state->entryAt(view);
  this->state->cover(entry);
  return entry.coverage.depth;
}

std::vector<std::vector<float>> ViewTexture::nodeShares(const ProgressFn& progress)
{
  return this->state->nodeShares(progress);
}

} // namespace hachure
