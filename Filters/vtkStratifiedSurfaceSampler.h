// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkStratifiedSurfaceSampler
 * @brief   spreads sample points evenly over the patches of a surface
 *
 * Stratified point sampling (Nehab and Shilane 2004) of a vtkPolyData or of all vtkPolyData blocks
 * of a composite data set. The samples follow the surface, not its triangulation: the same shape in
 * other triangles gets samples of the same density. They are tied to the input cells by barycentric
 * coordinates, so that they stay on the surface while it deforms. The result is a function of the
 * input and the properties alone, whatever the number of threads.
 *
 * The output has one vertex cell per sample, and as point data:
 * - Normals: unit normal of the triangle. On a (nearly) closed block that is turned inside out,
 * with a negative volume, they are flipped, so that they always point outward.
 * - CellId: the input cell, within its block.
 * - PointIds: the three input points, within the block, that the barycentric coordinates refer to;
 *   polygons and strips are cut into triangles.
 * - Barycentrics: the weights of these three points, each at least 0, their sum 1.
 * - PatchId: the patch.
 * - BlockIndex: flat index of the block; 0 for a plain vtkPolyData.
 * - SampleId: PatchId * SamplesPerPatch + stratum. It does not change when other patches do.
 *
 * Its field data has PatchSpacing, indexed by patch id: the mean distance of neighbouring samples,
 * sqrt(patch area / SamplesPerPatch), in the units of the input; 0 for ids without surface.
 *
 * Vertices, lines, ghost cells and cells without area take no samples. Cells with a coordinate that
 * is not finite are left out with one warning.
 */

#ifndef vtkStratifiedSurfaceSampler_h
#define vtkStratifiedSurfaceSampler_h

#include "HachureFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <limits> // for the ranges of the setters
#include <string> // for PatchArrayName

class HACHUREFILTERS_EXPORT vtkStratifiedSurfaceSampler : public vtkPolyDataAlgorithm
{
public:
  static vtkStratifiedSurfaceSampler* New();
  vtkTypeMacro(vtkStratifiedSurfaceSampler, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of samples wanted on every patch; fewer where the minimum distance forbids them. At
   * least 1, default 500: "typically several hundred" (Breslav et al. 2007, section 3.1).
   */
  vtkSetClampMacro(SamplesPerPatch, int, 1, std::numeric_limits<int>::max() / 2);
  vtkGetMacro(SamplesPerPatch, int);
  ///@}

  ///@{
  /**
   * Least distance between samples of a patch that face the same way, as a fraction of the patch's
   * spacing. Range 0 to 1, default 0.35 as in the authors' program for Breslav et al. 2007.
   */
  vtkSetClampMacro(MinimumDistance, double, 0.0, 1.0);
  vtkGetMacro(MinimumDistance, double);
  ///@}

  ///@{
  /**
   * Number of places tried for every sample; the one farthest from the samples already placed is
   * taken. 1 is plain stratified noise, more is more even. Range 1 to 1000, default 20.
   */
  vtkSetClampMacro(Regularity, int, 1, 1000);
  vtkGetMacro(Regularity, int);
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
   * Name of the cell array of integers with one component that gives the patch of every cell. Ids
   * run from 0 to 16777215; cells with a negative id take no samples. Empty, the default, makes one
   * patch of everything. A name that no such array has is an error.
   */
  vtkSetMacro(PatchArrayName, std::string);
  vtkGetMacro(PatchArrayName, std::string);
  ///@}

  ///@{
  /**
   * Makes every block a patch, whose id is the block's flat index; PatchArrayName is not used then.
   * Default off.
   */
  vtkSetMacro(PatchByBlock, bool);
  vtkGetMacro(PatchByBlock, bool);
  vtkBooleanMacro(PatchByBlock, bool);
  ///@}

protected:
  vtkStratifiedSurfaceSampler();
  ~vtkStratifiedSurfaceSampler() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int SamplesPerPatch = 500;
  double MinimumDistance = 0.35;
  int Regularity = 20;
  unsigned int Seed = 1;
  std::string PatchArrayName;
  bool PatchByBlock = false;

private:
  vtkStratifiedSurfaceSampler(const vtkStratifiedSurfaceSampler&) = delete;
  void operator=(const vtkStratifiedSurfaceSampler&) = delete;
};

#endif
