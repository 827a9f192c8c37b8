// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewTextureHemispheres.h"

#include "CellBlocks.h"
#include "Parallel.h"
#include "SrgbColor.h"
#include "ViewContributions.h"
#include "ViewFade.h"

#include <algorithm>
#include <cmath>

namespace hachure
{
namespace
{
struct HemisphereLevel
{
  CellBlocks<glm::vec4> colors; // times their share, and the share
  // Of directions: whether a view is to be seen there, whatever its mask. Empty blocks: nothing.
  CellBlocks<std::uint8_t> known;
};

bool hasColor(Span<const ViewContribution> contributions)
{
  return std::any_of(contributions.begin(), contributions.end(),
    [](const ViewContribution& contribution) { return contribution.color.a > 0.0f; });
}

struct Scratch
{
  std::vector<glm::vec3> directions;
  std::vector<float> fades, shares, weights;
  std::vector<glm::vec4> sums;
  HemisphereTable::Taps taps;
  std::vector<NodeCells::Share> sources;

  explicit Scratch(std::size_t size)
    : directions(size)
    , fades(size)
    , shares(size)
    , weights(size)
    , sums(size)
  {
  }
};

class Builder
{
public:
  Builder(const ViewTextureSurface& ofSurface, const HemisphereTable& ofTable,
    Span<const DependentView> ofViews, const HemisphereOptions& ofOptions);

  // From the finest level on.
  void addLevel(int number);
  // From the coarsest on.
  void fillUp(int number);
  void writeNodes(int number, std::vector<glm::u8vec4>& nodes) const;

private:
  HemisphereLevel& levelAt(int number) { return this->levels[static_cast<std::size_t>(number)]; }
  const HemisphereLevel& levelAt(int number) const
  {
    return this->levels[static_cast<std::size_t>(number)];
  }
  void openBlocks(int number, const ViewContributions& contributions);
  void mixViews(
    int number, std::int32_t cell, Span<const ViewContribution> contributions, Scratch& scratch);
  void filterDown(int number, std::int32_t cell, Scratch& scratch);
  std::vector<std::int32_t> cellsToFill(int number) const;
  void mixFromBelow(int number, std::int32_t cell, Scratch& scratch);
  float depthShare(std::int32_t view, int number) const;
  template <class Body>
  void forCells(std::int64_t count, Body&& body) const;

  const ViewTextureSurface& surface;
  const HemisphereTable& table;
  Span<const DependentView> views;
  HemisphereOptions options;
  std::vector<ViewFade> fades;
  std::vector<HemisphereLevel> levels;
  int finest = -1; // level that any view has colours at
};

Builder::Builder(const ViewTextureSurface& ofSurface, const HemisphereTable& ofTable,
  Span<const DependentView> ofViews, const HemisphereOptions& ofOptions)
  : surface(ofSurface)
  , table(ofTable)
  , views(ofViews)
  , options(ofOptions)
{
  this->fades.reserve(ofViews.size());
  for (const DependentView& view : ofViews)
  {
    this->fades.emplace_back(*view.view);
    for (const ViewCellColors::Level& level : view.colors->levels)
    {
      this->finest = std::max(this->finest, level.number);
    }
  }
  this->levels.reserve(static_cast<std::size_t>(ofSurface.levels()));
  for (int number = 0; number < ofSurface.levels(); ++number)
  {
    const std::int32_t cells = ofSurface.layer(number).size();
    this->levels.push_back({ { cells, ofTable.size() }, { cells, ofTable.size() } });
  }
}

// Calls body(i, scratch).
template <class Body>
void Builder::forCells(std::int64_t count, Body&& body) const
{
  constexpr std::int64_t grain = 64; // a cell takes microseconds
  parallelForRanges(count, grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      Scratch scratch(this->table.size());
      for (std::int64_t i = begin; i < end; ++i)
      {
        body(i, scratch);
      }
    });
}

float Builder::depthShare(std::int32_t view, int number) const
{
  const ViewCellColors::Level* level =
    levelOf(*this->views[static_cast<std::size_t>(view)].colors, number);
  return level != nullptr ? level->share : 0.0f;
}

void Builder::openBlocks(int number, const ViewContributions& contributions)
{
  const CellLayer& layer = this->surface.layer(number);
  const bool hasFiner = number + 1 < this->surface.levels();
  std::vector<std::int32_t> colored;
  std::vector<std::int32_t> known;
  colored.reserve(static_cast<std::size_t>(layer.size()));
  known.reserve(static_cast<std::size_t>(layer.size()));
  for (std::int32_t cell = 0; cell < layer.size(); ++cell)
  {
    const Span<const ViewContribution> own = contributions.of(cell);
    bool isColored = hasColor(own);
    bool isKnown = !own.empty();
    if (hasFiner)
    {
      const CellLayer::Children children = layer.childrenOf(cell, this->surface.layer(number + 1));
      for (int i = 0; i < children.count; ++i)
      {
        const std::int32_t child = children.cells[static_cast<std::size_t>(i)];
        isColored = isColored || this->levelAt(number + 1).colors.has(child);
        isKnown = isKnown || this->levelAt(number + 1).known.has(child);
      }
    }
    if (isColored)
    {
      colored.push_back(cell);
    }
    if (isKnown)
    {
      known.push_back(cell);
    }
  }
  this->levelAt(number).colors.add(colored);
  this->levelAt(number).known.add(known);
}

void Builder::addLevel(int number)
{
  const ViewContributions contributions =
    viewContributions(this->surface, this->views, number, this->finest);
  this->openBlocks(number, contributions);
  const bool hasFiner = number + 1 < this->surface.levels();
  this->forCells(this->surface.layer(number).size(),
    [&](std::int64_t i, Scratch& scratch)
    {
      const auto cell = static_cast<std::int32_t>(i);
      const Span<const ViewContribution> own = contributions.of(cell);
      if (!own.empty())
      {
        this->mixViews(number, cell, own, scratch);
      }
      if (hasFiner && this->levelAt(number).known.has(cell))
      {
        this->filterDown(number, cell, scratch);
      }
    });
}

void Builder::mixViews(
  int number, std::int32_t cell, Span<const ViewContribution> contributions, Scratch& scratch)
{
  const glm::dvec3& place = this->surface.placeOfCell(number, cell);
  this->table.directionsIn(this->surface.turnOfCell(number, cell), scratch.directions);
  std::uint8_t* known = this->levelAt(number).known.of(cell);
  glm::vec4* colors = this->levelAt(number).colors.of(cell);
  std::fill(scratch.sums.begin(), scratch.sums.end(), glm::vec4(0.0f));
  std::fill(scratch.shares.begin(), scratch.shares.end(), 0.0f);
  for (const ViewContribution& contribution : contributions)
  {
    const auto view = static_cast<std::size_t>(contribution.view);
    const float depth = this->depthShare(contribution.view, number);
    this->fades[view].shares(
      place, this->views[view].colors->fromMiddle(place), scratch.directions, scratch.fades);
    const float share = contribution.color.a * (this->options.classicShares ? depth : 1.0f);
    for (std::size_t i = 0; i < scratch.fades.size(); ++i)
    {
      const float fade = scratch.fades[i];
      known[i] = static_cast<std::uint8_t>(known[i] | (fade > 0.0f ? 1 : 0));
      scratch.sums[i] += depth * fade * contribution.weight * contribution.color;
      scratch.shares[i] += share * fade;
    }
  }
  for (std::size_t i = 0; colors != nullptr && i < scratch.sums.size(); ++i)
  {
    const glm::vec4& sum = scratch.sums[i];
    colors[i] = sum.a > 0.0f ? sum * (std::min(scratch.shares[i], 1.0f) / sum.a) : glm::vec4(0.0f);
  }
}

// Of children that views see: where a mask leaves nothing of one it counts as such.
void Builder::filterDown(int number, std::int32_t cell, Scratch& scratch)
{
  const CellLayer& layer = this->surface.layer(number);
  const HemisphereLevel& finer = this->levelAt(number + 1);
  const CellLayer::Children children = layer.childrenOf(cell, this->surface.layer(number + 1));
  const glm::quat& turn = this->surface.turnOfCell(number, cell);
  std::uint8_t* known = this->levelAt(number).known.of(cell);
  glm::vec4* colors = this->levelAt(number).colors.of(cell);
  std::fill(scratch.sums.begin(), scratch.sums.end(), glm::vec4(0.0f));
  float count = 0.0f;
  for (int i = 0; i < children.count; ++i)
  {
    const std::int32_t child = children.cells[static_cast<std::size_t>(i)];
    if (!finer.known.has(child))
    {
      continue;
    }
    count += 1.0f;
    this->table.findTaps(turn, this->surface.turnOfCell(number + 1, child), scratch.taps);
    this->table.join(scratch.taps, finer.known.of(child), known);
    if (finer.colors.has(child))
    {
      this->table.add(scratch.taps, 1.0f, finer.colors.of(child), scratch.sums.data());
    }
  }
  for (std::size_t i = 0; colors != nullptr && count > 0.0f && i < scratch.sums.size(); ++i)
  {
    colors[i] = colors[i].a > 0.0f ? colors[i] : scratch.sums[i] / count;
  }
}

// Cells that something below can be mixed into.
std::vector<std::int32_t> Builder::cellsToFill(int number) const
{
  const CellLayer& layer = this->surface.layer(number);
  const HemisphereLevel& level = this->levelAt(number);
  std::vector<std::uint8_t> wanted(static_cast<std::size_t>(layer.size()), 0);
  this->forCells(layer.size(),
    [&](std::int64_t i, Scratch& scratch)
    {
      const auto cell = static_cast<std::int32_t>(i);
      const std::uint8_t* known = level.known.of(cell);
      if (known != nullptr &&
        std::all_of(known, known + this->table.size(), [](std::uint8_t flag) { return flag != 0; }))
      {
        return;
      }
      this->surface.mixFromBelow(number, cell, scratch.sources);
      wanted[static_cast<std::size_t>(i)] =
        std::any_of(scratch.sources.begin(), scratch.sources.end(),
          [&](const NodeCells::Share& share)
          { return this->levelAt(number - 1).colors.has(share.cell); });
    });
  std::vector<std::int32_t> cells;
  cells.reserve(wanted.size());
  for (std::size_t cell = 0; cell < wanted.size(); ++cell)
  {
    if (wanted[cell] != 0)
    {
      cells.push_back(static_cast<std::int32_t>(cell));
    }
  }
  return cells;
}

void Builder::fillUp(int number)
{
  const std::vector<std::int32_t> cells = this->cellsToFill(number);
  this->levelAt(number).colors.add(cells);
  this->forCells(static_cast<std::int64_t>(cells.size()),
    [&](std::int64_t i, Scratch& scratch)
    { this->mixFromBelow(number, cells[static_cast<std::size_t>(i)], scratch); });
}

void Builder::mixFromBelow(int number, std::int32_t cell, Scratch& scratch)
{
  const HemisphereLevel& below = this->levelAt(number - 1);
  const glm::quat& turn = this->surface.turnOfCell(number, cell);
  this->surface.mixFromBelow(number, cell, scratch.sources);
  std::fill(scratch.sums.begin(), scratch.sums.end(), glm::vec4(0.0f));
  for (const NodeCells::Share& source : scratch.sources)
  {
    if (below.colors.has(source.cell))
    {
      this->table.findTaps(turn, this->surface.turnOfCell(number - 1, source.cell), scratch.taps);
      this->table.add(
        scratch.taps, source.weight, below.colors.of(source.cell), scratch.sums.data());
    }
  }
  const std::uint8_t* known = this->levelAt(number).known.of(cell);
  glm::vec4* colors = this->levelAt(number).colors.of(cell);
  for (std::size_t i = 0; i < scratch.sums.size(); ++i)
  {
    if (colors[i].a == 0.0f && (known == nullptr || known[i] == 0))
    {
      colors[i] = scratch.sums[i];
    }
  }
}

void write(Span<const glm::vec4> colors, glm::u8vec4* bytes)
{
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const glm::vec4& color = colors[i];
    if (color.a > 0.0f)
    {
      bytes[i] = srgbOf(color);
    }
  }
}

// Nodes without anything keep their zeros.
void Builder::writeNodes(int number, std::vector<glm::u8vec4>& nodes) const
{
  const CellLayer& layer = this->surface.layer(number);
  const HemisphereLevel& level = this->levelAt(number);
  const NodeCells& lists = this->surface.nodeCells(number);
  const std::size_t size = this->table.size();
  // Of every list its node among all levels'.
  std::vector<std::int64_t> numbers;
  numbers.reserve(static_cast<std::size_t>(layer.nodeCount()));
  for (std::size_t chart = 0; chart < layer.surface().charts.size(); ++chart)
  {
    const auto index = static_cast<std::int32_t>(chart);
    const std::int64_t count = layer.firstLevelNodeOf(index + 1) - layer.firstLevelNodeOf(index);
    for (std::int64_t node = 0; node < count; ++node)
    {
      numbers.push_back(layer.firstNode(index) + node);
    }
  }
  this->forCells(layer.nodeCount(),
    [&](std::int64_t i, Scratch& scratch)
    {
      const auto list = static_cast<std::size_t>(i);
      bool isEmpty = true;
      for (std::int64_t j = lists.first[list]; j < lists.first[list + 1]; ++j)
      {
        const NodeCells::Share& share = lists.shares[static_cast<std::size_t>(j)];
        if (!level.colors.has(share.cell))
        {
          continue;
        }
        if (isEmpty)
        {
          std::fill(scratch.sums.begin(), scratch.sums.end(), glm::vec4(0.0f));
          isEmpty = false;
        }
        this->table.findTaps(this->surface.turnOfNode(numbers[list]),
          this->surface.turnOfCell(number, share.cell), scratch.taps);
        this->table.add(
          scratch.taps, share.weight, level.colors.of(share.cell), scratch.sums.data());
      }
      if (!isEmpty)
      {
        write(scratch.sums, &nodes[static_cast<std::size_t>(numbers[list]) * size]);
      }
    });
}
} // namespace

std::vector<glm::u8vec4> viewTextureHemispheres(const ViewTextureSurface& surface,
  const HemisphereTable& table, Span<const DependentView> views, const HemisphereOptions& options,
  const ProgressFn& progress)
{
  std::vector<glm::u8vec4> nodes(
    static_cast<std::size_t>(surface.nodeCount()) * table.size(), glm::u8vec4(0));
  if (views.empty())
  {
    return nodes;
  }
  const int count = surface.levels();
  Builder builder(surface, table, views, options);
  for (int number = count - 1; number >= 0; --number)
  {
    builder.addLevel(number);
    if (progress && !progress(0.6 * (count - number) / count))
    {
      return {};
    }
  }
  for (int number = 0; number < count; ++number)
  {
    if (options.propagateUp && number > 0)
    {
      builder.fillUp(number);
    }
    builder.writeNodes(number, nodes);
    if (progress && !progress(0.6 + 0.4 * (number + 1) / count))
    {
      return {};
    }
  }
  return nodes;
}

} // namespace hachure
