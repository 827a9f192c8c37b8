// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The polydata in a mapper's input, plain or composite.
 */
#ifndef vtkPatternBlocks_h
#define vtkPatternBlocks_h

#include <vector>

class vtkCompositeDataDisplayAttributes;
class vtkDataObject;
class vtkPolyData;

namespace vtkPattern
{
struct Block
{
  vtkPolyData* Data;
  unsigned int FlatIndex; ///< in the composite, 0 for plain polydata
};

/// Every block that is polydata, in the composite's order; empty blocks are left out.
std::vector<Block> Blocks(vtkDataObject* input);

/// Whether the leaves of the input are visible, counting also empty ones; as with the mapper, a
/// leaf without a visibility of its own has that of what it is in.
std::vector<bool> VisibleLeaves(
  vtkDataObject* input, vtkCompositeDataDisplayAttributes* attributes);
} // namespace vtkPattern

#endif
// VTK-HeaderTest-Exclude: vtkPatternBlocks.h
