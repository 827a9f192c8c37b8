// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which cells of a whole surface a part of it draws, also after the part was moved from process to
 * process and its cells were cut where they lie in two.
 */
#ifndef OwnedCells_h
#define OwnedCells_h

#include <vtkType.h>

#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace hachure
{
/// For every polygon of the whole's block, 1 where the part has it. ids: the cell array of the part
/// that tells cells of the whole; a part without it, or null, has none. Of a cell that was cut, the
/// part that has one certain point of it draws all.
std::vector<std::uint8_t> ownedCells(vtkPolyData* part, vtkPolyData* whole, const std::string& ids);
} // namespace hachure

#endif
