// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewTextureBase.h"

#include "Parallel.h"

#include <algorithm>
#include <utility>

namespace hachure
{
namespace
{
// Of a level's cells: colours times alpha, which is 0 or 1.
struct BaseLevel
{
  std::vector<glm::vec4> colors;
  std::vector<std::uint8_t> known; // seen, or filled
};

glm::vec4 wholeOf(const glm::vec4& color)
{
  return color.a > 0.0f ? color / color.a : glm::vec4(0.0f);
}

// A level that is finer than any view has no number.
int finestOf(Span<const ViewCellColors* const> views)
{
  int finest = -1;
  for (const ViewCellColors* view : views)
  {
    for (const ViewCellColors::Level& level : view->levels)
    {
      finest = std::max(finest, level.number);
    }
  }
  return finest;
}

// endedOnly: of views that have no finer level.
BaseLevel mixViews(
  const CellLayer& layer, Span<const ViewCellColors* const> views, bool endedOnly = false)
{
  BaseLevel mixed;
  mixed.colors.assign(static_cast<std::size_t>(layer.size()), glm::vec4(0.0f));
  mixed.known.assign(mixed.colors.size(), 0);
  for (const ViewCellColors* view : views)
  {
    if (endedOnly && finestOf({ &view, 1 }) != layer.number())
    {
      continue;
    }
    for (const ViewCellColors::Level& level : view->levels)
    {
      const CellColors& seen = level.seen;
      for (std::size_t i = 0; level.number == layer.number() && i < seen.cells.size(); ++i)
      {
        const auto cell = static_cast<std::size_t>(seen.cells[i]);
        mixed.colors[cell] += level.share * level.weightAt(i) * seen.colors[i];
        mixed.known[cell] = 1;
      }
    }
  }
  for (glm::vec4& color : mixed.colors)
  {
    color = wholeOf(color);
  }
  return mixed;
}

void spread(const CellLayer& layer, int rings, BaseLevel& level)
{
  CellColors seen;
  seen.cells.reserve(level.known.size());
  seen.colors.reserve(level.known.size());
  for (std::int32_t cell = 0; cell < layer.size(); ++cell)
  {
    if (level.known[static_cast<std::size_t>(cell)] != 0)
    {
      seen.cells.push_back(cell);
      seen.colors.push_back(level.colors[static_cast<std::size_t>(cell)]);
    }
  }
  const CellColors found = spreadColors(layer, seen, level.known, rings);
  for (std::size_t i = 0; i < found.cells.size(); ++i)
  {
    const auto cell = static_cast<std::size_t>(found.cells[i]);
    level.colors[cell] = wholeOf(found.colors[i]);
    level.known[cell] = 1;
  }
}

void filterDown(
  const CellLayer& layer, const CellLayer& nextLayer, const BaseLevel& next, BaseLevel& level)
{
  parallelFor(layer.size(),
    [&](std::int64_t i)
    {
      const auto cell = static_cast<std::size_t>(i);
      const CellLayer::Children children =
        layer.childrenOf(static_cast<std::int32_t>(i), nextLayer);
      glm::vec4 sum(0.0f);
      for (int child = 0; child < children.count; ++child)
      {
        const auto index =
          static_cast<std::size_t>(children.cells[static_cast<std::size_t>(child)]);
        sum += next.colors[index];
        level.known[cell] = static_cast<std::uint8_t>(level.known[cell] | next.known[index]);
      }
      level.colors[cell] = level.colors[cell].a > 0.0f ? level.colors[cell] : wholeOf(sum);
    });
}

// Cells of which nothing is known take all that is below, such of which masks have left nothing
// only what views say that have ended there: else marks would be blurred by their own coarser
// level.
void fillUp(const ViewTextureSurface& surface, int number, const BaseLevel& below,
  const BaseLevel& endedBelow, BaseLevel& level)
{
  constexpr std::int64_t grain = 512;
  parallelForRanges(static_cast<std::int64_t>(level.colors.size()), grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<NodeCells::Share> shares;
      for (std::int64_t i = begin; i < end; ++i)
      {
        const auto cell = static_cast<std::size_t>(i);
        if (level.colors[cell].a > 0.0f)
        {
          continue;
        }
        const BaseLevel& from = level.known[cell] != 0 ? endedBelow : below;
        surface.mixFromBelow(number, static_cast<std::int32_t>(i), shares);
        glm::vec4 sum(0.0f);
        for (const NodeCells::Share& share : shares)
        {
          sum += share.weight * from.colors[static_cast<std::size_t>(share.cell)];
        }
        level.colors[cell] = wholeOf(sum);
      }
    });
}

void mixNodes(const ViewTextureSurface& surface, int number, const BaseLevel& level,
  std::vector<glm::vec4>& nodes)
{
  constexpr float gray = 0.21404114f; // of sRGB's 0.5
  const CellLayer& layer = surface.layer(number);
  const NodeCells& lists = surface.nodeCells(number);
  const auto charts = static_cast<std::int64_t>(layer.surface().charts.size());
  parallelFor(charts,
    [&](std::int64_t i)
    {
      const auto chart = static_cast<std::int32_t>(i);
      const std::int64_t count = layer.firstLevelNodeOf(chart + 1) - layer.firstLevelNodeOf(chart);
      for (std::int64_t node = 0; node < count; ++node)
      {
        const auto list = static_cast<std::size_t>(layer.firstLevelNodeOf(chart) + node);
        glm::vec4 sum(0.0f);
        for (std::int64_t j = lists.first[list]; j < lists.first[list + 1]; ++j)
        {
          const NodeCells::Share& share = lists.shares[static_cast<std::size_t>(j)];
          sum += share.weight * level.colors[static_cast<std::size_t>(share.cell)];
        }
        const glm::vec4 mean = sum.a > 0.0f ? sum / sum.a : glm::vec4(gray);
        nodes[static_cast<std::size_t>(layer.firstNode(chart) + node)] =
          glm::vec4(glm::vec3(mean), std::min(sum.a, 1.0f));
      }
    });
}
} // namespace

std::vector<glm::vec4> viewTextureBase(const ViewTextureSurface& surface,
  Span<const ViewCellColors* const> views, bool propagateUp, const ProgressFn& progress)
{
  const int count = surface.levels();
  const int finest = finestOf(views);
  std::vector<BaseLevel> levels(static_cast<std::size_t>(count));
  const auto levelAt = [&](int number) -> BaseLevel&
  { return levels[static_cast<std::size_t>(number)]; };
  for (int number = count - 1; number >= 0; --number)
  {
    levelAt(number) = mixViews(surface.layer(number), views);
    spread(surface.layer(number), spreadRings(number, finest), levelAt(number));
    if (number + 1 < count)
    {
      filterDown(
        surface.layer(number), surface.layer(number + 1), levelAt(number + 1), levelAt(number));
    }
    if (progress && !progress(0.5 * (count - number) / count))
    {
      return {};
    }
  }
  std::vector<glm::vec4> nodes(static_cast<std::size_t>(surface.nodeCount()));
  BaseLevel endedBelow;
  for (int number = 0; number < count; ++number)
  {
    if (propagateUp)
    {
      BaseLevel ended = mixViews(surface.layer(number), views, true);
      if (number > 0)
      {
        fillUp(surface, number, levelAt(number - 1), endedBelow, levelAt(number));
        fillUp(surface, number, endedBelow, endedBelow, ended);
      }
      endedBelow = std::move(ended);
    }
    mixNodes(surface, number, levelAt(number), nodes);
    if (progress && !progress(0.5 + 0.5 * (number + 1) / count))
    {
      return {};
    }
  }
  return nodes;
}

} // namespace hachure
