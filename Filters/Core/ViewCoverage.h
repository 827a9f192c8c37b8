// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewCoverage_h
#define hachure_ViewCoverage_h

#include "CellLayers.h"
#include "TextureView.h"
#include "TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace hachure
{

// A pixel of an image in which a cell is seen, and how many quarters of it show the cell.
struct CoveredPixel
{
  std::uint32_t pixel : 30; // row by row, from the bottom up
  std::uint32_t quartersLessOne : 2;
  std::uint32_t quarters() const { return this->quartersLessOne + 1u; }
};

// Which cells a view sees, and in which of its pixels (Grimm and Kowalski 2002, section 4.2 and
// 4.3): as long as camera and surface stay only colours have to be read again.
struct ViewCoverage
{
  struct Level
  {
    int number = 0;
    double share = 0.0;               // of the view at this level: 1 - |depth - number|
    std::vector<std::int32_t> cells;  // that are seen, ascending; numbers as in CellLayer
    std::vector<std::uint32_t> first; // of every cell its first pixel, and the number of all
    std::vector<CoveredPixel> pixels;
  };

  // The level at which cells are as large as pixels, between two levels. From the mean number of
  // pixels a cell of level 0 has in the image, over the cells that are seen: its logarithm to the
  // base 4, without the jumps that the paper's formula has at whole levels. 0 to finestLevel.
  double depth = 0.0;
  std::vector<Level> levels; // one or two; none where nothing is seen
};

// Of a checked view. layers: of all levels, 0 first. The image is looked at in twice its
// resolution, as in the paper, for fewer cells without a pixel; those that remain between others
// have the pixels of the cells around. The same for any number of threads.
ViewCoverage viewCoverage(
  const TriangleMesh& mesh, Span<const CellLayer> layers, const TextureView& view);

} // namespace hachure

#endif
