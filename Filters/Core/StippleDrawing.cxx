// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleDrawing.h"

#include "FloatLanes.h"
#include "Parallel.h"
#include "StippleTone.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure
{

namespace
{

constexpr std::size_t tonesOfAll = 256;
constexpr std::size_t fullTone = tonesOfAll; // row of tone 1
constexpr int cellSide = 32;                 // pixels
// Cosines of the angle of sight for which crowds are known, from the least to 1.
constexpr std::size_t facingCount = 39;
constexpr float leastFacing = 0.05f;
constexpr float facingStep = (1.0f - leastFacing) / (facingCount - 1);
constexpr float leastNumber = 1e-30f;

NoiseKernelOptions reachOf(const StippleLook& look)
{
  checkStippleLook(look);
  NoiseKernelOptions options;
  options.radius = 0.5 * look.diameter;
  return options;
}

double at(const glm::dvec4& row, const glm::dvec3& point)
{
  return glm::dot(glm::dvec3(row), point) + row.w;
}

HACHURE_INLINED FloatLanes alongLanes(
  const glm::vec4& row, const FloatLanes& x, const FloatLanes& y, const FloatLanes& z)
{
  return x * row.x + y * row.y + (z * row.z + row.w);
}

// Up to which density all stipples around a place in a node are there: that of the smallest node
// which has the place in its box, and is nearest to it.
float heldAround(const StippleTree& tree, std::int32_t node, const glm::dvec3& place)
{
  std::int32_t smallest = node;
  while (tree.node(smallest).childCount > 0)
  {
    const StippleNode& parent = tree.node(smallest);
    double least = std::numeric_limits<double>::infinity();
    for (std::int32_t i = 0; i < parent.childCount; ++i)
    {
      const std::int32_t child = parent.children[static_cast<std::size_t>(i)];
      const StippleBounds& bounds = tree.node(child).bounds;
      const glm::dvec3 outside = place - glm::clamp(place, bounds.low, bounds.high);
      const double away = glm::dot(outside, outside);
      if (!bounds.isEmpty() && away < least)
      {
        least = away;
        smallest = child;
      }
    }
    if (!std::isfinite(least))
    {
      break;
    }
  }
  return static_cast<float>(tree.node(smallest).heldDensity);
}

} // namespace

StippleDrawing::StippleDrawing(const StippleScene& someScene, const StippleLook& someLook)
  : StipplePicture(someScene)
  , look(someLook)
  , reach(reachOf(someLook))
  , projection(someScene.view, this->reach)
{
  this->tabulateCrowds();
  this->findCells();
}

void StippleDrawing::tabulateCrowds()
{
  const bool even = this->scene.tones.empty();
  const auto mostOf = [](const std::array<float, tonesOfAll>& tones) {
    return static_cast<std::size_t>(std::max_element(tones.begin(), tones.end()) - tones.begin());
  };
  this->darkest = this->look.toneBySize ? fullTone : even ? 0 : mostOf(this->scene.toneOf);
  const float perPixel = 1.0f / (this->look.diameter * this->look.diameter);
  this->crowds.resize((tonesOfAll + 1) * facingCount);
  for (std::size_t tone = 0; tone <= fullTone; ++tone)
  {
    if (even && tone > 0 && tone < fullTone)
    {
      continue;
    }
    const float ink = tone == fullTone ? 1.0f : std::clamp(this->scene.toneOf[tone], 0.0f, 1.0f);
    for (std::size_t i = 0; i < facingCount; ++i)
    {
      const float facing = leastFacing + static_cast<float>(i) * facingStep;
      this->crowds[tone * facingCount + i] =
        ink > 0.0f ? perPixel * stippleCrowd(ink, facing, this->look.growth) : 0.0f;
    }
  }
}

float StippleDrawing::crowdAt(std::size_t tone, float facing) const
{
  constexpr auto last = static_cast<float>(facingCount - 1);
  const float place = std::clamp((facing - leastFacing) / facingStep, 0.0f, last);
  const auto first = std::min(static_cast<std::size_t>(place), facingCount - 2);
  const float* const entries = this->crowds.data() + tone * facingCount + first;
  return entries[0] + (place - static_cast<float>(first)) * (entries[1] - entries[0]);
}

void StippleDrawing::findCells()
{
  const bool even = this->scene.tones.empty() || this->look.toneBySize;
  if (even && this->scene.depth.empty())
  {
    return;
  }
  const auto width = static_cast<std::size_t>(this->scene.rectangle[2]);
  const auto height = static_cast<std::size_t>(this->scene.rectangle[3]);
  this->cellColumns = (this->scene.rectangle[2] + cellSide - 1) / cellSide;
  this->cellRows = (this->scene.rectangle[3] + cellSide - 1) / cellSide;
  const auto columns = static_cast<std::size_t>(this->cellColumns);
  this->cells.assign(columns * static_cast<std::size_t>(this->cellRows), Cell());
  std::array<float, tonesOfAll> crowdOf;
  for (std::size_t tone = 0; tone < tonesOfAll; ++tone)
  {
    crowdOf[tone] = this->crowdAt(even ? this->darkest : tone, 1.0f);
  }
  const auto stride = static_cast<std::size_t>(this->scene.toneStride);
  parallelForRanges(this->cellRows, 1,
    [&](std::int64_t cellRow, std::int64_t)
    {
      Cell* const row = this->cells.data() + static_cast<std::size_t>(cellRow) * columns;
      const std::size_t first = static_cast<std::size_t>(cellRow) * cellSide * width;
      const std::size_t end = std::min(first + cellSide * width, width * height);
      for (std::size_t pixel = first; pixel < end; ++pixel)
      {
        const float depth = this->scene.depth.empty() ? 0.0f : this->scene.depth[pixel];
        if (depth < 1.0f)
        {
          Cell& cell = row[pixel % width / cellSide];
          const std::size_t tone = even ? 0 : this->scene.tones[pixel * stride];
          cell.crowd = std::max(cell.crowd, crowdOf[tone]);
          cell.farthest = std::max(cell.farthest, depth);
        }
      }
    });
}

// Where the near plane is level in space and depth is a function of the distance from the eye
// alone, which skewed projections have not; -1 otherwise.
float StippleDrawing::nearestDepth(const NoiseSphere& sphere) const
{
  const glm::dvec3 z(this->rowZ), w(this->rowW);
  const double square = glm::dot(w, w);
  const double factor = square > 0.0 ? glm::dot(z, w) / square : 0.0;
  if (glm::length(z - factor * w) > 1e-9 * glm::length(z) && square > 0.0)
  {
    return -1.0f;
  }
  const glm::dvec4& along = square > 0.0 ? this->rowW : this->rowZ;
  const double least = at(along, sphere.center) - sphere.radius * glm::length(glm::dvec3(along));
  const double depth =
    square > 0.0 ? factor + (this->rowZ.w - factor * this->rowW.w) / least : least / this->rowW.w;
  return static_cast<float>(0.5 * depth + 0.5);
}

// Of all that is seen around the picture of the sphere, with a pixel more: a stipple beside the
// surface's picture, or beside the rectangle, has the tone of a pixel next to it.
float StippleDrawing::mostCrowd(const NoiseSphere& sphere) const
{
  const double least =
    at(this->rowW, sphere.center) - sphere.radius * glm::length(glm::dvec3(this->rowW));
  if (this->cells.empty() || !(least > 0.0))
  {
    return this->crowdAt(this->darkest, 1.0f);
  }
  const double w = at(this->rowW, sphere.center);
  const glm::dvec4* const rows[2] = { &this->rowX, &this->rowY };
  const int counts[2] = { this->cellColumns, this->cellRows };
  int first[2], last[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double middle = at(*rows[axis], sphere.center) / w;
    const glm::dvec3 change = glm::dvec3(*rows[axis]) - middle * glm::dvec3(this->rowW);
    const double extent = sphere.radius * glm::length(change) / least + 2.0;
    const double most = counts[axis] - 1;
    first[axis] = static_cast<int>(std::clamp((middle - extent) / cellSide, 0.0, most));
    last[axis] = static_cast<int>(std::clamp((middle + extent) / cellSide, 0.0, most));
  }
  // More than the tolerance of most stipples.
  constexpr float tolerance = 8.0f;
  const float nearest = this->scene.depth.empty()
    ? -1.0f
    : this->nearestDepth(sphere) - tolerance * this->scene.depthPerPixel;
  float crowd = 0.0f;
  for (int row = first[1]; row <= last[1]; ++row)
  {
    const Cell* const cellsOfRow = this->cells.data() +
      static_cast<std::size_t>(row) * static_cast<std::size_t>(this->cellColumns);
    for (int column = first[0]; column <= last[0]; ++column)
    {
      const Cell& cell = cellsOfRow[column];
      crowd = nearest <= cell.farthest ? std::max(crowd, cell.crowd) : crowd;
    }
  }
  return crowd;
}

// Cosine of the angle of sight, of all normals of the cone and all places in the sphere.
double StippleDrawing::mostFacing(const StippleBounds& bounds) const
{
  const Rows rows = this->rowsAt(bounds.middle());
  const double distance = static_cast<double>(glm::length(rows.toViewer));
  if (bounds.cosine <= 0.0f || !(distance > 0.0))
  {
    return 1.0;
  }
  // All around the eye; of a parallel projection the angle is the same everywhere.
  const double turned = std::abs(static_cast<double>(rows.turn)) * bounds.radius / distance;
  if (turned >= 1.0)
  {
    return 1.0;
  }
  const double along =
    std::abs(static_cast<double>(glm::dot(rows.toViewer, bounds.axis))) / distance;
  const double angle = std::acos(std::min(1.0, along)) -
    std::acos(std::min(1.0, static_cast<double>(bounds.cosine))) - std::asin(turned);
  return std::cos(std::max(0.0, angle));
}

double StippleDrawing::mostWanted(const StippleBounds& bounds) const
{
  const NoiseSphere sphere = { bounds.middle(), bounds.radius };
  if (bounds.isEmpty() || this->projection.misses(sphere))
  {
    return 0.0;
  }
  const float crowd = this->mostCrowd(sphere);
  if (!(crowd > 0.0f))
  {
    return 0.0;
  }
  // Tilted surfaces want more in a pixel, of dark tones most, and have fewer pixels.
  const auto facing = static_cast<float>(this->mostFacing(bounds));
  const float tilted = facing * this->crowdAt(fullTone, facing) / this->crowdAt(fullTone, 1.0f);
  return static_cast<double>(tilted * crowd) * this->projection.magnificationBound(sphere);
}

// Bits of those out of eight that may be wanted.
HACHURE_WIDE_CLONES std::uint32_t StippleDrawing::candidates(
  const Rows& rows, const StippleNode& node, std::int32_t first) const
{
  const FloatLanes x = loadLanes(node.place(0) + first), y = loadLanes(node.place(1) + first);
  const FloatLanes z = loadLanes(node.place(2) + first);
  const FloatLanes viewX = x * rows.turn + rows.toViewer.x;
  const FloatLanes viewY = y * rows.turn + rows.toViewer.y;
  const FloatLanes viewZ = z * rows.turn + rows.toViewer.z;
  const FloatLanes area = magnitudeLanes(viewX * loadLanes(node.normal(0) + first) +
    viewY * loadLanes(node.normal(1) + first) + viewZ * loadLanes(node.normal(2) + first));
  const FloatLanes facing =
    area / (rootLanes(viewX * viewX + viewY * viewY + viewZ * viewZ) + leastNumber);
  // Crowds fall with the facing ever more slowly: between two facings they are below the line.
  constexpr std::size_t middle = facingCount / 4;
  constexpr float middleFacing = leastFacing + middle * facingStep;
  const float* const darkestCrowds = this->crowds.data() + this->darkest * facingCount;
  const float slopeBelow =
    (darkestCrowds[middle] - darkestCrowds[0]) / (middleFacing - leastFacing);
  const float slopeAbove =
    (darkestCrowds[facingCount - 1] - darkestCrowds[middle]) / (1.0f - middleFacing);
  const FloatLanes beyond = facing - middleFacing;
  const FloatLanes crowd =
    higherLanes(beyond * slopeBelow, beyond * slopeAbove) + darkestCrowds[middle];
  const FloatLanes w = alongLanes(rows.w, x, y, z);
  // wanted * w^3 - density * w^3; infinite densities fail, as does what is behind the eye.
  const FloatLanes rest = crowd * area - loadLanes(node.density() + first) * (w * w * w);
  const FloatLanes column = alongLanes(rows.x, x, y, z), row = alongLanes(rows.y, x, y, z);
  const auto margin = 0.5f * this->look.diameter;
  const FloatLanes right = w * (static_cast<float>(this->scene.rectangle[2]) + margin) - column;
  const FloatLanes top = w * (static_cast<float>(this->scene.rectangle[3]) + margin) - row;
  const FloatLanes inside = lowerLanes(
    lowerLanes(column + w * margin, row + w * margin), lowerLanes(lowerLanes(right, top), w));
  const FloatLanes wanted = lowerLanes(rest, inside);
  float margins[floatLanes];
  storeLanes(wanted, margins);
  std::uint32_t bits = 0;
  for (int lane = 0; lane < floatLanes; ++lane)
  {
    bits |= (margins[lane] > 0.0f ? 1u : 0u) << lane;
  }
  return bits;
}

bool StippleDrawing::finish(
  const Rows& rows, const StippleTree& tree, const Task& task, DrawnStipple& stipple) const
{
  const StippleNode& node = tree.node(task.node);
  const std::int32_t index = stipple.index;
  const glm::vec3 from(node.place(0)[index], node.place(1)[index], node.place(2)[index]);
  const glm::vec3 normal(node.normal(0)[index], node.normal(1)[index], node.normal(2)[index]);
  Place place;
  if (!locate(rows, from, normal, place))
  {
    return false;
  }
  const std::size_t tone = this->toneAt(place.x, place.y);
  float crowd = this->crowdAt(tone, place.facing);
  float diameter = this->look.diameter;
  if (this->look.toneBySize)
  {
    const float most = this->crowdAt(fullTone, place.facing);
    diameter *= std::sqrt(crowd / most);
    crowd = most;
  }
  // Where there are not enough stipples, they are larger: the same picture, magnified.
  if (task.lacks)
  {
    const float there =
      heldAround(tree, task.node, node.origin + glm::dvec3(from)) * place.perPixel;
    diameter *= std::sqrt(std::max(1.0f, crowd / there));
    crowd = std::min(crowd, there);
  }
  const float grown =
    stippleGrowth(crowd / (node.density()[index] * place.perPixel), this->look.growth);
  if (!(0.5f * diameter * grown > leastRadius))
  {
    return false;
  }
  this->setDepth(rows, normal, place);
  const float radius = 0.5f * diameter * grown * this->visibleShare(place);
  stipple.disc = { place.x, place.y, radius };
  stipple.nearest = place.depth - place.tolerance;
  return radius > leastRadius;
}

void StippleDrawing::draw(
  const StippleTree& tree, const Task& task, std::vector<DrawnStipple>& drawn) const
{
  const StippleNode& node = tree.node(task.node);
  const Rows rows = this->rowsAt(node.origin);
  DrawnStipple stipple;
  stipple.node = task.node;
  for (std::int32_t first = 0; first < node.count; first += floatLanes)
  {
    if (node.leastOfBlocks()[first / floatLanes] > task.wanted)
    {
      break;
    }
    std::uint32_t bits = this->candidates(rows, node, first);
    for (stipple.index = first; bits != 0; ++stipple.index, bits >>= 1)
    {
      if ((bits & 1u) != 0 && this->finish(rows, tree, task, stipple))
      {
        drawn.push_back(stipple);
      }
    }
  }
}

namespace
{

// Nodes that a picture shows, and those of them that have not enough.
struct Walk
{
  std::vector<StippleDrawing::Task> seen;
  std::vector<StippleRequest> lacking;
};

Walk walk(const StippleTree& tree, const StippleDrawing& drawing)
{
  Walk result;
  std::vector<std::int32_t> open;
  if (!tree.nodes().empty())
  {
    open.push_back(0);
  }
  while (!open.empty())
  {
    const std::int32_t index = open.back();
    const StippleNode& node = tree.node(index);
    open.pop_back();
    const double wanted = drawing.mostWanted(node.bounds);
    if (wanted <= 0.0 || node.leastDensity > wanted)
    {
      continue;
    }
    const bool lacks = node.childCount == 0 && wanted > node.heldDensity;
    result.seen.push_back({ index, wanted, lacks });
    if (lacks)
    {
      result.lacking.push_back({ index, wanted });
    }
    open.insert(open.end(), node.children.begin(), node.children.begin() + node.childCount);
  }
  return result;
}

// Whether at least half of what refinements hold is in the picture.
bool isMostlySeen(const StippleTree& tree, const Walk& shown)
{
  std::size_t bytes = 0;
  for (const StippleDrawing::Task& task : shown.seen)
  {
    const StippleNode& node = tree.node(task.node);
    bytes += node.ranks.empty() ? node.memory() : 0;
  }
  return 2 * bytes >= tree.refinedMemory();
}

// Stipples of a node above those that lack some may be among them, too.
void markAncestors(const StippleTree& tree, Walk& shown)
{
  std::vector<char> lacks(tree.nodes().size(), 0);
  for (const StippleRequest& request : shown.lacking)
  {
    for (std::int32_t node = request.node; node >= 0 && lacks[static_cast<std::size_t>(node)] == 0;
         node = tree.node(node).parent)
    {
      lacks[static_cast<std::size_t>(node)] = 1;
    }
  }
  for (StippleDrawing::Task& task : shown.seen)
  {
    task.lacks = lacks[static_cast<std::size_t>(task.node)] != 0;
  }
}

} // namespace

bool drawStipples(
  StippleTree& tree, const StippleDrawing& drawing, bool refines, std::vector<DrawnStipple>& drawn)
{
  Walk shown = walk(tree, drawing);
  bool mayForget = true;
  while (refines && tree.canRefine() && !shown.lacking.empty())
  {
    const std::size_t before = tree.nodes().size();
    const bool isMade = tree.refine(shown.lacking);
    const bool isMore = tree.nodes().size() > before;
    shown = walk(tree, drawing);
    if (!isMade && mayForget && !isMostlySeen(tree, shown))
    {
      // Other views have spent the budget.
      mayForget = false;
      tree.dropRefinements();
      shown = walk(tree, drawing);
    }
    else if (!isMade || !isMore)
    {
      break;
    }
  }
  markAncestors(tree, shown);
  constexpr std::int64_t grain = 8; // nodes
  const auto count = static_cast<std::int64_t>(shown.seen.size());
  std::vector<std::vector<DrawnStipple>> parts(static_cast<std::size_t>(count / grain + 1));
  parallelForRanges(count, grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        drawing.draw(tree, shown.seen[static_cast<std::size_t>(i)],
          parts[static_cast<std::size_t>(begin / grain)]);
      }
    });
  drawn.clear();
  for (const std::vector<DrawnStipple>& part : parts)
  {
    drawn.insert(drawn.end(), part.begin(), part.end());
  }
  return shown.lacking.empty();
}

} // namespace hachure
