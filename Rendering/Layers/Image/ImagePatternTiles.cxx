// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImagePatternTiles.h"

#include "PaperTile.h"
#include "PatternImageFile.h"
#include "vtkImageData.h"
#include "vtkImagePatternLayer.h"

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <stdexcept>

namespace hachure
{
namespace
{
// All that a procedural tile depends on.
using TileKey = std::array<double, 8>;

// Texels and periods of the built-in tiles: enough periods that a loose hand does not repeat
// itself visibly, 32 texels a period.
constexpr int tileSize = 512;
constexpr int tilePeriods = 16;
constexpr int ruledSize = 256;
constexpr int ruledPeriods = 8;
constexpr int denseSize = 1024; // 8 texels at least between the densest strokes
// A dab shows bristles, which take more texels; a grain of paper is a mere bump.
constexpr int dabPeriods = 8;
constexpr int paperPeriods = 32;

// What `make` returns for this key, made where nobody holds it.
template <class Value, class Make>
std::shared_ptr<const Value> sharedValue(const TileKey& key, Make&& make)
{
  static std::mutex mutex;
  static std::map<TileKey, std::weak_ptr<const Value>> values;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<const Value> value = values[key].lock();
  if (!value)
  {
    value = std::make_shared<const Value>(make());
    values[key] = value;
  }
  return value;
}

TileKey keyOf(vtkImagePatternLayer* layer)
{
  const bool paint = layer->GetPattern() == vtkImagePatternLayer::PAINT;
  const double none = 0.0;
  return { { double(layer->GetPattern()), layer->GetIrregularity(), double(layer->GetSeed()),
    double(layer->GetDensities()), paint ? layer->GetDabLength() : none,
    paint ? layer->GetDabJitter() : none, paint ? layer->GetBristles() : none,
    paint ? layer->GetDabDensity() : none } };
}

CrossHatchOptions strokeOptions(vtkImagePatternLayer* layer)
{
  CrossHatchOptions options;
  options.irregularity = layer->GetIrregularity();
  options.seed = layer->GetSeed();
  options.densities = layer->GetDensities();
  const bool ruled = options.irregularity <= 0.0;
  options.size = ruled ? ruledSize : tileSize;
  options.periods = ruled ? ruledPeriods : tilePeriods;
  // Ruled strokes of one density come in all at once, those of a loose hand one by one: they need
  // a tile in which many lie, or those that are there already gather in bands.
  if (options.densities > 1 && !ruled)
  {
    options.size = denseSize;
  }
  else
  {
    options.periods >>= options.densities - 1;
  }
  return options;
}

PatternTile makeTile(vtkImagePatternLayer* layer)
{
  CrossHatchOptions options = strokeOptions(layer);
  PatternTile tile;
  switch (layer->GetPattern())
  {
    case vtkImagePatternLayer::CROSS_HATCH:
      tile = crossHatchTile(options);
      break;
    case vtkImagePatternLayer::HALFTONE:
      options.densities = 1;
      tile = halftoneTile(options);
      break;
    case vtkImagePatternLayer::STIPPLE:
      options.densities = 1;
      options.size = tileSize;
      options.periods = tilePeriods;
      return stippleTile(options);
    case vtkImagePatternLayer::PAPER:
    {
      PaperOptions paper;
      paper.size = tileSize;
      paper.periods = paperPeriods;
      paper.seed = layer->GetSeed();
      return paperTile(paper);
    }
    default:
      tile = hatchTile(options);
  }
  return tile;
}

PaintTile makeDabs(vtkImagePatternLayer* layer)
{
  PaintOptions options;
  options.size = tileSize;
  options.periods = dabPeriods;
  options.seed = layer->GetSeed();
  options.aspect = layer->GetDabLength();
  options.angleJitter = layer->GetDabJitter();
  options.bristles = layer->GetBristles();
  options.density = layer->GetDabDensity();
  return paintTile(options);
}

// The user's image, dark = inked first.
TileMips userTile(vtkImageData* image)
{
  const TileKey key = { { -2.0, double(reinterpret_cast<std::uintptr_t>(image)),
    image ? double(image->GetMTime()) : 0.0 } };
  return sharedValue<std::vector<PatternTile>>(key,
    [image]
    {
      const GreyImage grey = greyImage(image, "pattern IMAGE");
      return mipChain(imageTile(grey.values, grey.width, grey.height));
    });
}
} // namespace

TileMips layerTile(vtkImagePatternLayer* layer)
{
  if (layer->GetPattern() == vtkImagePatternLayer::IMAGE)
  {
    return userTile(layer->GetImage());
  }
  return sharedValue<std::vector<PatternTile>>(keyOf(layer),
    [layer]
    {
      const PaintMips dabs = layerDabs(layer);
      return mipChain(dabs ? dabs->front().pattern : makeTile(layer));
    });
}

PaintMips layerDabs(vtkImagePatternLayer* layer)
{
  if (layer->GetPattern() != vtkImagePatternLayer::PAINT)
  {
    return nullptr;
  }
  return sharedValue<std::vector<PaintTile>>(
    keyOf(layer), [layer] { return paintMipChain(makeDabs(layer)); });
}

TileMips layerPaper(vtkImagePatternLayer* layer)
{
  if (layer->GetPaperContrast() <= 0.0)
  {
    return nullptr;
  }
  const TileKey key = { { -1.0, double(layer->GetSeed()) } };
  return sharedValue<std::vector<PatternTile>>(key,
    [layer]
    {
      PaperOptions options;
      options.size = tileSize;
      options.periods = paperPeriods;
      options.seed = layer->GetSeed();
      return mipChain(paperTile(options));
    });
}

} // namespace hachure
