// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PatternTileImage_h
#define PatternTileImage_h

#include "Core/PaintTile.h"

class vtkImageData;

// Tiles as image data: point arrays Screen and Gradient, field arrays Periods and Levels.
namespace hachure
{

void writeTile(const PatternTile& tile, vtkImageData* image);

// With the point arrays DabOffset, DabAlpha, DabIndex, the same three with LowerDab, and
// PaintHeight.
void writePaint(const PaintTile& tile, vtkImageData* image);

// Throws std::invalid_argument when the image is not a tile. periodsKnown tells whether the image
// has Periods; without it 1 is assumed.
PatternTile readTile(vtkImageData* image, bool& periodsKnown);

} // namespace hachure

#endif
