// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The surfaces of a mapper's input, and what became of them since the last look: what is attached
 * to a surface stays while its points move, and starts anew where its cells are others.
 */
#ifndef vtkPatternGeometry_h
#define vtkPatternGeometry_h

#include <cstdint>
#include <vector>

class vtkDataObject;
class vtkPolyData;

class vtkPatternGeometry
{
public:
  struct Block
  {
    vtkPolyData* Data = nullptr;
    unsigned int FlatIndex = 0;
    std::uint64_t CellTime = 0;
    std::uint64_t PointTime = 0;
    std::uint64_t PointCount = 0;
    std::uint64_t CellHash = 0;
  };

  enum Change
  {
    NOTHING,
    MOVED,   // other positions of the same points
    REPLACED // other cells, other numbers of points, other blocks
  };

  /// Looks at the polydata, or at those in a composite; the first look finds them replaced.
  Change Update(vtkDataObject* input);

  /// Those with points, in the composite's order; the data are borrowed from the last input.
  const std::vector<Block>& GetBlocks() const { return this->Blocks; }

private:
  std::vector<Block> Collect(vtkDataObject* input) const;

  std::vector<Block> Blocks;
  bool Known = false;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternGeometry.h
