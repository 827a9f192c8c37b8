// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewTextureColors_h
#define hachure_ViewTextureColors_h

#include <glm/gtc/type_precision.hpp>

#include <vector>

namespace hachure
{

// How directions are stored: see Kernels/ViewCells.glsl.
enum class HemisphereMap
{
  Octahedral, // the whole square
  Disk        // the paper's
};

// Colours at the nodes of a surface's cells, as they are drawn.
struct ViewTextureColors
{
  int hemisphere = 8; // directions a side
  HemisphereMap map = HemisphereMap::Octahedral;
  // One a node: what is seen from everywhere. sRGB; alpha: how much of it is known, 255: all.
  std::vector<glm::u8vec4> independent;
  // hemisphere * hemisphere a node, row by row: what is seen from there. Linear colours times the
  // share, then sRGB; alpha: the share, which hides what is independent.
  std::vector<glm::u8vec4> dependent;
};

// What nobody knows becomes grey.
void paintUnknown(ViewTextureColors& colors);

// What is seen from everywhere, which is all known, is put below what is seen from somewhere, which
// then hides everything, and is gone: a picture needs half as many colours.
void paintBelow(ViewTextureColors& colors);

} // namespace hachure

#endif
