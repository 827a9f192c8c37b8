// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfacePart
 * @brief   what a process draws of a surface that it holds a part of
 *
 * Input 0 is a part, as vtkWholeSurface gives it or made of such parts since; input 1, which is
 * optional, the whole surface, by default the one that the part was taken from. The output is a
 * composite like the part, with the part's polygons out of the whole surface: a block shares the
 * points and the point arrays of the whole's block, and has its cells' arrays with WholeCellIds.
 * Vertices and lines come with points of their own behind them. Where the part is all of a block,
 * that is the whole's block itself.
 *
 * Behind those blocks there are blocks of the surroundings of the part: polygons that others hold,
 * up to Surroundings away from it (all of a small surface), so that contours, marks and visibility
 * know how the surface goes on. They have a field array "NotDrawn": vtkPatternMapper leaves their
 * pixels to whoever holds them. Other blocks that the part touches surround it too. With other
 * Surroundings alone, the other blocks of the output stay the same objects.
 *
 * A part of no known whole passes as it is.
 *
 * @sa vtkWholeSurface vtkPatternMapper
 */

#ifndef vtkSurfacePart_h
#define vtkSurfacePart_h

#include "HachureFiltersModule.h" // for the export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

#include <memory> // for what is kept
#include <vector> // for the blocks

class vtkPoints;
class vtkPolyData;

class HACHUREFILTERS_EXPORT vtkSurfacePart : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkSurfacePart* New();
  vtkTypeMacro(vtkSurfacePart, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Width of the surroundings, in diagonals of the whole surface's bounds. Range 0 to 1, default
   * 0.03.
   */
  vtkSetClampMacro(Surroundings, double, 0.0, 1.0);
  vtkGetMacro(Surroundings, double);
  ///@}

  ///@{
  /**
   * Polygons up to which the surroundings of a part are all of the surface, so that nothing is
   * missing of what hides it or is seen behind it. At least 0, default 50000: drawing them in
   * addition takes about 10 ms in software OpenGL.
   */
  vtkSetClampMacro(MaximumNumberOfCells, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfCells, vtkIdType);
  ///@}

  /** Whether a block of the output is of the surroundings. */
  static bool IsSurroundings(vtkPolyData* block);

  /**
   * Of which leaf of the part a block of the surroundings goes on, counting also empty ones; -1
   * where the block is not of the surroundings.
   */
  static int GetSurroundedBlock(vtkPolyData* block);

  /**
   * The points of the whole surface's block that a block of the output was taken from: its first
   * points have their numbers, as its WholeCellIds have those of its cells. Where a block was not
   * taken from any, its own points.
   */
  static vtkPoints* GetPointsOfWhole(vtkPolyData* block);

protected:
  vtkSurfacePart();
  ~vtkSurfacePart() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSurfacePart(const vtkSurfacePart&) = delete;
  void operator=(const vtkSurfacePart&) = delete;

  struct Internals;
  void Draw(const std::vector<vtkPolyData*>& part, const std::vector<vtkPolyData*>& whole);

  double Surroundings = 0.03;
  vtkIdType MaximumNumberOfCells = 50000;
  std::unique_ptr<Internals> Internal;
};

#endif
