// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewContributions.h"

#include "Parallel.h"

namespace hachure
{
namespace
{
// Of every view the colours around what it sees, where no view sees anything.
std::vector<CellColors> spreadAt(
  const ViewTextureSurface& surface, Span<const DependentView> views, int number, int finest)
{
  const CellLayer& layer = surface.layer(number);
  std::vector<std::uint8_t> closed(static_cast<std::size_t>(layer.size()), 0);
  for (const DependentView& view : views)
  {
    const ViewCellColors::Level* level = levelOf(*view.colors, number);
    for (std::size_t i = 0; level != nullptr && i < level->seen.cells.size(); ++i)
    {
      closed[static_cast<std::size_t>(level->seen.cells[i])] = 1;
    }
  }
  std::vector<CellColors> spread(views.size());
  const int rings = spreadRings(number, finest);
  parallelForRanges(static_cast<std::int64_t>(views.size()), 1,
    [&](std::int64_t view, std::int64_t)
    {
      const auto index = static_cast<std::size_t>(view);
      const ViewCellColors::Level* level = levelOf(*views[index].colors, number);
      if (level != nullptr)
      {
        spread[index] = spreadColors(layer, level->seen, closed, rings);
      }
    });
  return spread;
}
} // namespace

const ViewCellColors::Level* levelOf(const ViewCellColors& colors, int number)
{
  for (const ViewCellColors::Level& level : colors.levels)
  {
    if (level.number == number)
    {
      return &level;
    }
  }
  return nullptr;
}

ViewContributions viewContributions(
  const ViewTextureSurface& surface, Span<const DependentView> views, int number, int finest)
{
  const std::vector<CellColors> spread = spreadAt(surface, views, number, finest);
  ViewContributions found;
  found.first.assign(static_cast<std::size_t>(surface.layer(number).size()) + 1, 0);
  const auto forAll = [&](auto&& body)
  {
    for (std::size_t view = 0; view < views.size(); ++view)
    {
      const ViewCellColors::Level* level = levelOf(*views[view].colors, number);
      for (const CellColors* colors : { level != nullptr ? &level->seen : nullptr, &spread[view] })
      {
        for (std::size_t i = 0; colors != nullptr && i < colors->cells.size(); ++i)
        {
          const float weight = colors == &spread[view] ? 1.0f : level->weightAt(i);
          body(static_cast<std::size_t>(colors->cells[i]),
            ViewContribution{ static_cast<std::int32_t>(view), weight, colors->colors[i] });
        }
      }
    }
  };
  forAll([&](std::size_t cell, const ViewContribution&) { ++found.first[cell + 1]; });
  for (std::size_t cell = 1; cell < found.first.size(); ++cell)
  {
    found.first[cell] += found.first[cell - 1];
  }
  found.all.resize(static_cast<std::size_t>(found.first.back()));
  std::vector<std::int32_t> next(found.first.begin(), found.first.end());
  forAll([&](std::size_t cell, const ViewContribution& contribution)
    { found.all[static_cast<std::size_t>(next[cell]++)] = contribution; });
  return found;
}

} // namespace hachure
