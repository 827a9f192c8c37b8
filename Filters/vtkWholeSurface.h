// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWholeSurface
 * @brief   puts together a surface of which every process holds a part
 *
 * Patterns are made of the surface as a whole, so that they are the same in all parts of it. Input
 * is a vtkPolyData or a composite of vtkPolyData, of the same structure in every process, blocks
 * that a process has nothing of being empty or missing. Output 0 is the input with one more cell
 * array, WholeCellIds: the cell of the whole surface, -1 for vertices and lines. Output 1, the same
 * in every process, is the whole surface: all polygons, in an order that depends on where they are
 * alone, not on who holds them; without ghosts, strips as triangles, points with equal places and
 * data as one. A surface whose connectivity stays keeps its order while it moves. The two outputs
 * know each other, see GetWhole().
 *
 * A filter may run on the whole surface, such as one that divides it into patches; the arrays that
 * it adds are added to output 0 as well.
 *
 * Every process holds the whole surface, so it cannot be larger than MaximumNumberOfCells: then, as
 * where structures differ, an error says so, each process's part passes with the filter run on it
 * alone, and output 1 is empty.
 *
 * All processes of the controller must update the filter together.
 *
 * @sa vtkSurfacePart vtkPatternMapper
 */

#ifndef vtkWholeSurface_h
#define vtkWholeSurface_h

#include "HachureFiltersModule.h" // for the export macro
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSmartPointer.h" // for the controller and the filter

#include <memory> // for the blocks

class vtkMultiProcessController;

class HACHUREFILTERS_EXPORT vtkWholeSurface : public vtkPassInputTypeAlgorithm
{
public:
  static vtkWholeSurface* New();
  vtkTypeMacro(vtkWholeSurface, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The processes that hold parts. Null: this one alone. Default: the global controller.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  virtual vtkMultiProcessController* GetController();
  ///@}

  ///@{
  /**
   * A filter of one input and one output that keeps points and cells; it runs on the whole surface.
   * Default null: none.
   */
  virtual void SetFilter(vtkAlgorithm* filter);
  virtual vtkAlgorithm* GetFilter();
  ///@}

  ///@{
  /**
   * Polygons of the largest surface that is put together. At least 0, default 20 million: about
   * 1 GB in every process, with a normal per point.
   */
  vtkSetClampMacro(MaximumNumberOfCells, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfCells, vtkIdType);
  ///@}

  /** Name of the cell array that tells cells of the whole surface. */
  static const char* GetCellIdsName() { return "WholeCellIds"; }

  /**
   * The whole surface that a part was taken from; null where it is none, or came from another
   * process since.
   */
  static vtkDataObject* GetWhole(vtkDataObject* part);

  vtkMTimeType GetMTime() override;

protected:
  vtkWholeSurface();
  ~vtkWholeSurface() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkWholeSurface(const vtkWholeSurface&) = delete;
  void operator=(const vtkWholeSurface&) = delete;

  struct Internals;
  bool CanBeWhole(vtkDataObject* input);
  bool Assemble(vtkDataObject* input);
  vtkSmartPointer<vtkDataObject> Filtered(vtkDataObject* surface);
  void StorePart(vtkDataObject* whole, vtkDataObject* filtered, vtkDataObject* part);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkSmartPointer<vtkAlgorithm> Filter;
  vtkIdType MaximumNumberOfCells = 20000000;
  std::unique_ptr<Internals> Internal;
};

#endif
