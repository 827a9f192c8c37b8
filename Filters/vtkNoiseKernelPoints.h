// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNoiseKernelPoints
 * @brief   the points on a surface at which the kernels of a noise are drawn
 *
 * Noise that moves with a surface and looks flat is a sum of kernels that are defined in the
 * picture and attached to points of the surface (Benard et al. 2010). This filter gives the kernels
 * that a camera sees of a vtkPolyData, or of all vtkPolyData blocks of a composite data set: as
 * many as the picture needs, whatever the triangles. Points come in with weight 0 and gain weight
 * slowly while the camera comes nearer, and a point is the same in every picture. Back faces have
 * kernels too; what hides a kernel is not known here. What lies before the camera's clipping range
 * is left out.
 *
 * The points of a triangle are a function of Seed, of the triangle's id and of its area. The id
 * comes from the global ids of the cells where a block has some, and is a hash of the places of its
 * corners otherwise: give global ids where the surface moves. Where it deforms, points stay as far
 * as the areas of the triangles do.
 *
 * The output has one vertex cell per kernel, in an order that depends on the input alone, and as
 * point data:
 * - KernelId: 64 random bits, always the same for a point.
 * - CellId: the input cell, within its block.
 * - BlockIndex: flat index of the block; 0 for a plain vtkPolyData.
 * - Level: octave of the density, in points per unit of area, at which the point comes in: floor of
 * its binary logarithm. Classic: of the number of points on the triangle's image.
 * - Weight: 0 to 1.
 * - Center: x and y of the kernel in pixels, y up, origin at the lower left of the viewport.
 * - Radius in pixels; Bandwidth in 1 / pixels, which belongs to it; Frequency in cycles per pixel.
 * - Orientation of the wave vector, in degrees counter-clockwise from +x; Phase in degrees.
 *
 * Vertices, lines, ghost cells and cells without area have no points. Cells with a coordinate that
 * is not finite are left out with one warning.
 */

#ifndef vtkNoiseKernelPoints_h
#define vtkNoiseKernelPoints_h

#include "HachureFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <vtkSmartPointer.h> // for the camera

class vtkCamera;

class HACHUREFILTERS_EXPORT vtkNoiseKernelPoints : public vtkPolyDataAlgorithm
{
public:
  static vtkNoiseKernelPoints* New();
  vtkTypeMacro(vtkNoiseKernelPoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The camera, which is needed. Default none.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * Width and height of the viewport in pixels, each at least 1. Default 800 x 600.
   */
  void SetViewportSize(double width, double height);
  void SetViewportSize(const double size[2]) { this->SetViewportSize(size[0], size[1]); }
  vtkGetVector2Macro(ViewportSize, double);
  ///@}

  ///@{
  /**
   * Mean number of kernels over a pixel, as the sum of their squared weights. Range 1 to 1024,
   * default 32; "typical values range from 16 to 128" (Benard et al. 2010, section 3.1).
   */
  vtkSetClampMacro(Overlap, double, 1.0, 1024.0);
  vtkGetMacro(Overlap, double);
  ///@}

  ///@{
  /**
   * Radius of the kernels in pixels, where their envelope has fallen to 5 %. Range 0.5 to 1000,
   * default 16.
   */
  vtkSetClampMacro(Radius, double, 0.5, 1000.0);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Frequency of the noise in cycles per pixel. Range 0 to 0.5, default 0.125.
   */
  vtkSetClampMacro(Frequency, double, 0.0, 0.5);
  vtkGetMacro(Frequency, double);
  ///@}

  ///@{
  /**
   * Direction of the wave vector, across the lines, in degrees counter-clockwise from +x. Default
   * 0.
   */
  vtkSetMacro(Orientation, double);
  vtkGetMacro(Orientation, double);
  ///@}

  ///@{
  /**
   * How far directions are spread at random to both sides, in degrees. Range 0, anisotropic noise,
   * to 90, isotropic noise; default 0.
   */
  vtkSetClampMacro(Spread, double, 0.0, 90.0);
  vtkGetMacro(Spread, double);
  ///@}

  ///@{
  /**
   * Octaves of density over which a point gains its weight. Range 0.01 to 16, default 1. Classic
   * does not read it.
   */
  vtkSetClampMacro(Fade, double, 0.01, 16.0);
  vtkGetMacro(Fade, double);
  ///@}

  ///@{
  /**
   * Seed of all random choices. Any value, default 1.
   */
  vtkSetMacro(Seed, unsigned int);
  vtkGetMacro(Seed, unsigned int);
  ///@}

  ///@{
  /**
   * The points of the paper (Benard et al. 2010, section 3.3): their number is a power of two for
   * every triangle, and at least one. For comparison: where triangles are small, there are too
   * many points with too little weight. Default off.
   */
  vtkSetMacro(Classic, bool);
  vtkGetMacro(Classic, bool);
  vtkBooleanMacro(Classic, bool);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkNoiseKernelPoints();
  ~vtkNoiseKernelPoints() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkCamera> Camera;
  double ViewportSize[2] = { 800.0, 600.0 };
  double Overlap = 32.0;
  double Radius = 16.0;
  double Frequency = 0.125;
  double Orientation = 0.0;
  double Spread = 0.0;
  double Fade = 1.0;
  unsigned int Seed = 1;
  bool Classic = false;

private:
  vtkNoiseKernelPoints(const vtkNoiseKernelPoints&) = delete;
  void operator=(const vtkNoiseKernelPoints&) = delete;
};

#endif
