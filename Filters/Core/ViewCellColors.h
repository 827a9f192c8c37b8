// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewCellColors_h
#define hachure_ViewCellColors_h

#include "TextureView.h"
#include "ViewCoverage.h"
#include "ViewTextureSurface.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace hachure
{

// Colours of some cells of a level: linear light times the mask, and the mask.
struct CellColors
{
  std::vector<std::int32_t> cells;
  std::vector<glm::vec4> colors;
};

// What one view says of cells at its levels.
struct ViewCellColors
{
  struct Level
  {
    int number = 0;
    float share = 0.0f; // of the view's depth
    CellColors seen;    // ascending
    // How much they count beside other views, more than 0: seen from aside less. Empty: all alike.
    std::vector<float> weights;
    float weightAt(std::size_t i) const { return this->weights.empty() ? 1.0f : this->weights[i]; }
  };
  std::vector<Level> levels;
  // Of the places of cells that the mask leaves, by its weight, and the largest distance of such a
  // cell from there; 0: there is none.
  glm::dvec3 middle{ 0.0 };
  double reach = 0.0;

  // 0 to 1, for FadeMode::Middle.
  float fromMiddle(const glm::dvec3& place) const;
};

// The mean of the pixels of every cell; pixels count by their mask. In place of those of the image
// a colour (sRGB, alpha 255) can be given.
ViewCellColors viewCellColors(const ViewTextureSurface& surface, const ViewCoverage& coverage,
  Span<const glm::u8vec4> image, const glm::u8vec4* color = nullptr);

// Spreads colours to cells around: ring by ring over edges, each cell the mean of those of its
// neighbours that have a colour by then. `closed` cells, one flag for each cell of the level, get
// none. Returns the new ones, ring by ring, ascending in each.
CellColors spreadColors(const CellLayer& layer, const CellColors& from,
  const std::vector<std::uint8_t>& closed, int rings);

// How far colours are spread (section 6.2): at the finest level that has any over half the size of
// a cell of level 0, which are as many rings as it has cells there, at others over one ring.
// Weights of the cells of a view by how squarely it sees them, so that it goes over into others
// where it ends instead of at an edge.
void weighByFacing(
  const ViewTextureSurface& surface, const TextureView& view, ViewCellColors& colors);

inline int spreadRings(int level, int finestWithColors)
{
  return level == finestWithColors ? 1 << level : 1;
}

} // namespace hachure

#endif
