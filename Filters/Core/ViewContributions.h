// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewContributions_h
#define hachure_ViewContributions_h

#include "ViewCellColors.h"
#include "ViewTextureHemispheres.h"
#include "ViewTextureSurface.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace hachure
{

// What dependent views say of a cell.
struct ViewContribution
{
  std::int32_t view;
  float weight;    // beside other views
  glm::vec4 color; // linear, times the mask, and the mask
};
struct ViewContributions
{
  std::vector<std::int32_t> first; // of every cell of a level, and the number of all
  std::vector<ViewContribution> all;

  Span<const ViewContribution> of(std::int32_t cell) const
  {
    const auto begin = static_cast<std::size_t>(this->first[static_cast<std::size_t>(cell)]);
    const auto end = static_cast<std::size_t>(this->first[static_cast<std::size_t>(cell) + 1]);
    return Span<const ViewContribution>(this->all).subspan(begin, end - begin);
  }
};

// Of all cells of a level: of those that views see, and around these where no view sees anything,
// each view's own colours spread. finest: the finest level at which any of them sees something.
ViewContributions viewContributions(
  const ViewTextureSurface& surface, Span<const DependentView> views, int level, int finest);

// What a view says of a level; null: nothing.
const ViewCellColors::Level* levelOf(const ViewCellColors& colors, int number);

} // namespace hachure

#endif
