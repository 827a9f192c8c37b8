// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkViewDependentTexture
 * @brief   the cells on which pictures of a surface are put together, and their colours
 *
 * What vtkViewTextureLayer draws (Grimm and Kowalski 2002, Creating View-dependent Texture Maps),
 * as data: a vtkPolyData, or all vtkPolyData blocks of a composite data set together, is divided
 * into cells, and the views of a vtkTextureViews are blended on these. The result is a function of
 * the input and the properties alone, whatever the number of threads.
 *
 * The first output has the cells of a level as triangles, whose corners lie on the surface. Corners
 * are shared with neighbours, but not where these are larger. Its cell data are:
 * - Chart: a chart is one cell at some level and is divided at finer ones.
 * - Level: the level whose cells are as large as this one: that of the output, or a finer one of
 *   a small chart.
 * - Area of the triangle.
 * - Independent: RGBA in sRGB, what is seen from everywhere. Alpha is 0, and the colour grey, where
 *   nothing is known.
 * - DependentShare: how much dependent views hide of that, 0 to 1; the most over all directions.
 * - ViewShares: of every view, by the order and names of the views, 0 to 1, whatever the direction.
 *   They sum to 1, or to 0 where nothing is known. Without views there is no such array.
 * - View: the view with the largest share, the first of several; -1: none.
 * - Coverage: RGBA in sRGB, a colour of its own for every view, mixed by their shares.
 *
 * The second output has the outlines of what the views cover (figure 6 of the paper): the edges
 * between cells of different View as lines, with the cell data Views, both of them, in ascending
 * order.
 *
 * The third output is for a camera: the input with the point data Colors, RGBA in sRGB, that this
 * camera sees of the texture; they are the active scalars. Alpha is 0 at points of no
 * polygon or strip. On creases the side that faces the camera most counts. Without a camera it is
 * empty. It is of the input's type; for composite input get it as GetOutputDataObject(2).
 *
 * Vertices, lines, ghost cells and cells without area are left out. Cells with a coordinate that is
 * not finite are left out with one warning.
 *
 * @sa vtkTextureViews
 */

#ifndef vtkViewDependentTexture_h
#define vtkViewDependentTexture_h

#include "HachureFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <vtkSmartPointer.h> // for views and camera

class vtkCamera;
class vtkTextureViews;

class HACHUREFILTERS_EXPORT vtkViewDependentTexture : public vtkPolyDataAlgorithm
{
public:
  static vtkViewDependentTexture* New();
  vtkTypeMacro(vtkViewDependentTexture, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The views, which also say how large cells are and how many levels there are. Every filter has
   * some of its own at first, without any view; null is refused with an error.
   */
  void SetViews(vtkTextureViews* views);
  vtkTextureViews* GetViews();
  ///@}

  ///@{
  /**
   * Level of the first two outputs. Range -1 to 8; -1, the default, and levels that there are not
   * are the finest one.
   */
  vtkSetClampMacro(Level, int, -1, 8);
  vtkGetMacro(Level, int);
  ///@}

  ///@{
  /**
   * Whether levels finer than all views have the colours of the finest one that has some (section
   * 6.2 of the paper mentions it). Default on.
   */
  vtkSetMacro(PropagateUp, bool);
  vtkGetMacro(PropagateUp, bool);
  vtkBooleanMacro(PropagateUp, bool);
  ///@}

  ///@{
  /**
   * Whether dependent views that count little for a level of detail give way to what is seen from
   * everywhere, as in the paper; otherwise they only give way to other views. Default off.
   */
  vtkSetMacro(ClassicShares, bool);
  vtkGetMacro(ClassicShares, bool);
  vtkBooleanMacro(ClassicShares, bool);
  ///@}

  ///@{
  /**
   * Memory that the colours may take, MiB; there are fewer levels where they would take more.
   * Range 1 to 16384, default 512, as vtkViewTextureLayer has it.
   */
  vtkSetClampMacro(MemoryBudget, int, 1, 16384);
  vtkGetMacro(MemoryBudget, int);
  ///@}

  ///@{
  /**
   * The camera of the third output, in the coordinates of the input. Default none.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * Width and height of its picture in pixels, which the level of detail depends on; each at least
   * 1. Default 800 x 600.
   */
  void SetViewportSize(double width, double height);
  void SetViewportSize(const double size[2]) { this->SetViewportSize(size[0], size[1]); }
  vtkGetVector2Macro(ViewportSize, double);
  ///@}

  vtkMTimeType GetMTime() override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkViewDependentTexture();
  ~vtkViewDependentTexture() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkTextureViews> Views;
  vtkSmartPointer<vtkCamera> Camera;
  double ViewportSize[2] = { 800.0, 600.0 };
  int Level = -1;
  bool PropagateUp = true;
  bool ClassicShares = false;
  int MemoryBudget = 512;

private:
  vtkViewDependentTexture(const vtkViewDependentTexture&) = delete;
  void operator=(const vtkViewDependentTexture&) = delete;

  struct Parts;
  bool Blend(vtkDataObject* input, Parts& parts);
  void Attach(vtkDataObject* input, Parts& parts, vtkInformationVector* outputVector);
};

#endif
