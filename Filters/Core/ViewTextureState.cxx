// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewTextureState.h"

#include "Parallel.h"
#include "SrgbColor.h"
#include "ViewTextureBase.h"
#include "ViewTextureHemispheres.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace hachure
{
namespace
{
// A part of the work, in that of all.
ProgressFn partOf(const ProgressFn& progress, double begin, double end)
{
  if (!progress)
  {
    return {};
  }
  return [&progress, begin, end](double fraction)
  { return progress(begin + fraction * (end - begin)); };
}

std::vector<glm::u8vec4> bytesOf(const std::vector<glm::vec4>& colors)
{
  std::vector<glm::u8vec4> bytes(colors.size());
  parallelFor(static_cast<std::int64_t>(colors.size()),
    [&](std::int64_t i)
    {
      const glm::vec4& color = colors[static_cast<std::size_t>(i)];
      bytes[static_cast<std::size_t>(i)] = srgbOf(color);
    });
  return bytes;
}
// All of its cells in one colour, times their masks.
void paint(ViewCellColors& view, const glm::vec4& color)
{
  for (ViewCellColors::Level& level : view.levels)
  {
    for (glm::vec4& cell : level.seen.colors)
    {
      cell = cell.a * color;
    }
  }
}

std::vector<const ViewCellColors*> pointersTo(const std::vector<ViewCellColors>& views)
{
  std::vector<const ViewCellColors*> pointers;
  pointers.reserve(views.size());
  for (const ViewCellColors& view : views)
  {
    pointers.push_back(&view);
  }
  return pointers;
}
} // namespace

ViewTexture::State::Entry& ViewTexture::State::entryAt(std::size_t view)
{
  if (view >= this->entries.size())
  {
    throw std::invalid_argument("view is " + std::to_string(view) + "; expected one of " +
      std::to_string(this->entries.size()));
  }
  return this->entries[view];
}

// What a view has been mixed into.
void ViewTexture::State::forget(const Entry& entry)
{
  if (!entry.image.empty())
  {
    (entry.view.dependent ? this->hasHemispheres : this->hasBase) = false;
  }
}

void ViewTexture::State::setViews(const std::vector<TextureView>& views)
{
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    checkTextureView(views[i], "views[" + std::to_string(i) + "]");
  }
  for (std::size_t i = views.size(); i < this->entries.size(); ++i)
  {
    this->forget(this->entries[i]);
  }
  this->entries.resize(views.size());
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    Entry& entry = this->entries[i];
    const bool sameCamera = haveSameCamera(entry.view, views[i]);
    if (!sameCamera || !haveSameFade(entry.view, views[i]))
    {
      this->forget(entry);
      if (entry.view.width != views[i].width || entry.view.height != views[i].height)
      {
        entry.image.clear();
      }
      entry.view = views[i];
      entry.hasCoverage = entry.hasCoverage && sameCamera;
      this->forget(entry);
    }
  }
}

void ViewTexture::State::setImage(std::size_t view, const TextureImage& image)
{
  Entry& entry = this->entryAt(view);
  checkTextureImage(image, entry.view, "image");
  entry.image.assign(image.pixels.begin(), image.pixels.end());
  entry.hasColors = false;
  this->forget(entry);
}

void ViewTexture::State::cover(Entry& entry)
{
  if (!entry.hasCoverage)
  {
    entry.coverage = viewCoverage(this->surface.mesh(), this->surface.allLayers(), entry.view);
    entry.hasCoverage = true;
    entry.hasColors = false;
  }
}

bool ViewTexture::State::updateViews(const ProgressFn& progress)
{
  for (std::size_t i = 0; i < this->entries.size(); ++i)
  {
    Entry& entry = this->entries[i];
    if (!entry.image.empty())
    {
      this->cover(entry);
      if (!entry.hasColors)
      {
        const glm::u8vec4 color = coverageColor(i);
        entry.colors = viewCellColors(
          this->surface, entry.coverage, entry.image, this->inCoverageColors ? &color : nullptr);
        if (!this->options.classicShares)
        {
          weighByFacing(this->surface, entry.view, entry.colors);
        }
        entry.hasColors = true;
      }
    }
    if (progress &&
      !progress(static_cast<double>(i + 1) / static_cast<double>(this->entries.size())))
    {
      return false;
    }
  }
  return true;
}

bool ViewTexture::State::updateBase(const ProgressFn& progress)
{
  if (this->hasBase)
  {
    return true;
  }
  std::vector<const ViewCellColors*> views;
  views.reserve(this->entries.size());
  for (const Entry& entry : this->entries)
  {
    if (!entry.view.dependent && !entry.image.empty())
    {
      views.push_back(&entry.colors);
    }
  }
  const std::vector<glm::vec4> nodes =
    viewTextureBase(this->surface, views, this->options.propagateUp, progress);
  this->hasBase = nodes.size() == static_cast<std::size_t>(this->surface.nodeCount());
  if (this->hasBase)
  {
    this->base = bytesOf(nodes);
    this->isAssembled = false;
  }
  return this->hasBase;
}

bool ViewTexture::State::updateHemispheres(const ProgressFn& progress)
{
  if (this->hasHemispheres)
  {
    return true;
  }
  std::vector<DependentView> views;
  views.reserve(this->entries.size());
  for (const Entry& entry : this->entries)
  {
    if (entry.view.dependent && !entry.image.empty())
    {
      views.push_back({ &entry.view, &entry.colors });
    }
  }
  std::vector<glm::u8vec4> nodes = viewTextureHemispheres(this->surface, this->table, views,
    { this->options.propagateUp, this->options.classicShares }, progress);
  this->hasHemispheres =
    nodes.size() == static_cast<std::size_t>(this->surface.nodeCount()) * this->table.size();
  if (this->hasHemispheres)
  {
    this->hemispheres = std::move(nodes);
    this->isAssembled = false;
  }
  return this->hasHemispheres;
}

// Moves what was made to the result, or from there.
void ViewTexture::State::assemble(ViewTextureContent content)
{
  if (this->isAssembled && this->assembled == content)
  {
    return;
  }
  const auto nodes = static_cast<std::size_t>(this->surface.nodeCount());
  if (this->base.empty())
  {
    this->base = std::move(this->result.independent);
  }
  if (this->hemispheres.empty())
  {
    this->hemispheres = std::move(this->result.dependent);
  }
  if (content == ViewTextureContent::DependentOnly)
  {
    this->result.independent = bytesOf(viewTextureBase(this->surface, {}, false));
  }
  else
  {
    this->result.independent = std::move(this->base);
    this->base.clear();
  }
  if (content == ViewTextureContent::IndependentOnly)
  {
    this->result.dependent.assign(nodes * this->table.size(), glm::u8vec4(0));
  }
  else
  {
    this->result.dependent = std::move(this->hemispheres);
    this->hemispheres.clear();
  }
  this->assembled = content;
  this->isAssembled = true;
}

const ViewTextureColors& ViewTexture::State::colors(
  ViewTextureContent content, const ProgressFn& progress)
{
  const bool coverage = content == ViewTextureContent::Coverage;
  if (coverage != this->inCoverageColors)
  {
    this->inCoverageColors = coverage;
    this->hasBase = this->hasHemispheres = false;
    for (Entry& entry : this->entries)
    {
      entry.hasColors = false;
    }
  }
  // Shares of the time of many dependent views.
  if (!this->updateViews(partOf(progress, 0.0, 0.3)) ||
    !this->updateBase(partOf(progress, 0.3, 0.4)) ||
    !this->updateHemispheres(partOf(progress, 0.4, 1.0)))
  {
    return this->stopped;
  }
  this->assemble(content);
  return this->result;
}

std::vector<std::vector<float>> ViewTexture::State::nodeShares(const ProgressFn& progress)
{
  if (!this->updateViews(partOf(progress, 0.0, 0.5)))
  {
    return {};
  }
  const auto nodes = static_cast<std::size_t>(this->surface.nodeCount());
  std::vector<std::vector<float>> shares(this->entries.size(), std::vector<float>(nodes, 0.0f));
  std::vector<ViewCellColors> copies;
  copies.reserve(this->entries.size());
  for (const Entry& entry : this->entries)
  {
    copies.push_back(entry.image.empty() ? ViewCellColors() : entry.colors);
  }
  const std::vector<const ViewCellColors*> views = pointersTo(copies);
  // Three views at once, as the channels of a colour.
  for (std::size_t first = 0; first < copies.size(); first += 3)
  {
    const double begin =
      0.5 + 0.5 * static_cast<double>(first) / static_cast<double>(copies.size());
    const double end = 0.5 +
      0.5 * static_cast<double>(std::min(first + 3, copies.size())) /
        static_cast<double>(copies.size());
    for (std::size_t view = 0; view < copies.size(); ++view)
    {
      glm::vec4 channels(0.0f, 0.0f, 0.0f, 1.0f);
      if (view >= first && view < first + 3)
      {
        channels[static_cast<int>(view - first)] = 1.0f;
      }
      paint(copies[view], channels);
    }
    const std::vector<glm::vec4> colors = viewTextureBase(
      this->surface, views, this->options.propagateUp, partOf(progress, begin, end));
    if (colors.size() != nodes)
    {
      return {};
    }
    for (std::size_t view = first; view < std::min(first + 3, copies.size()); ++view)
    {
      for (std::size_t node = 0; node < nodes; ++node)
      {
        shares[view][node] =
          colors[node].a > 0.0f ? colors[node][static_cast<int>(view - first)] : 0.0f;
      }
    }
  }
  return shares;
}

} // namespace hachure
