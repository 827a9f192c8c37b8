// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The tiles that image-pattern layers draw. Equal tiles are made once, for all windows and mappers
 * that use them.
 */
#ifndef ImagePatternTiles_h
#define ImagePatternTiles_h

#include "PaintTile.h"
#include "PatternTile.h"

#include <memory>
#include <vector>

class vtkImagePatternLayer;

namespace hachure
{
using TileMips = std::shared_ptr<const std::vector<PatternTile>>;
using PaintMips = std::shared_ptr<const std::vector<PaintTile>>;

/// The screen of a layer and its copies at half, quarter, ... size. Throws std::invalid_argument
/// where the user's image cannot be used.
TileMips layerTile(vtkImagePatternLayer* layer);

/// The dabs of a layer of paint, on the same levels; null for any other pattern.
PaintMips layerDabs(vtkImagePatternLayer* layer);

/// The paper below a layer; null where it has no contrast.
TileMips layerPaper(vtkImagePatternLayer* layer);
} // namespace hachure

#endif
// VTK-HeaderTest-Exclude: ImagePatternTiles.h
