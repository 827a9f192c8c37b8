// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSimilarityTracker
 * @brief   the 2D similarity transforms that carry patterns from one frame to another
 *
 * For every patch of a surface, the translation, rotation and uniform scale of the image that best
 * follow the surface from a camera before to a camera after, and optionally from a mesh before to a
 * mesh after (Breslav et al. 2007, section 3). Patterns that move by these transforms stay rigid in
 * the image and slide as little as they can over the surface.
 *
 * Inputs:
 * - port 0: samples, the output of vtkStratifiedSurfaceSampler. Read are the point data arrays
 *   PatchId (one integer; absent = one patch) and Normals, the field data array PatchSpacing, and
 * with a mesh on port 1 or 2 also PointIds (three integers) and Barycentrics.
 * - port 1, optional: the mesh before; port 2, optional: the mesh after. Default: the samples' own
 *   positions. Both meshes have the points that were sampled, in the same order. Front and back are
 *   carried over from the samples' normals, so the first of the meshes should be turned by less
 * than 90 degrees against the one that was sampled; that of port 2 may then be turned at will.
 *
 * Samples count by the image area that they stand for, on front sides only: what hides a sample is
 * not known here. Image space is in pixels, y up, origin at the lower left of the viewport.
 *
 * The output has one row per patch that has samples, in ascending order of PatchId:
 * - PatchId.
 * - OriginX, OriginY, UX, UY, VX, VY: the pattern's frame after the step, which began upright, with
 *   unit vectors of one pixel and its origin at the weighted centroid of the patch before.
 * - ZReal, ZImaginary: the transform's linear part as a complex number.
 * - Scale: its absolute value. AngleDegrees: its argument, counter-clockwise, in (-180, 180].
 * - WeightSum: the common weight of the samples in square pixels (a number of samples if
 * unweighted).
 * - Residual: weighted mean slide of the pattern over the surface in pixels, sum w |z p - c| / sum
 * w.
 * - Status: "Similarity"; "TranslationOnly" where all samples fall on one pixel position;
 * "NoSamples" where no sample is in sight of both cameras, with the identity.
 */

#ifndef vtkSimilarityTracker_h
#define vtkSimilarityTracker_h

#include "HachureFiltersModule.h" // for the export macro
#include "vtkTableAlgorithm.h"

#include <vtkSmartPointer.h> // for the cameras

class vtkCamera;

class HACHUREFILTERS_EXPORT vtkSimilarityTracker : public vtkTableAlgorithm
{
public:
  static vtkSimilarityTracker* New();
  vtkTypeMacro(vtkSimilarityTracker, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How the weights of the two frames join.
   */
  enum WeightSchemes
  {
    SYMMETRIC = 0, //!< geometric mean: there and back gives the identity
    CLASSIC = 1,   //!< the paper's: the weight after, 0 where the weight before is 0
    UNWEIGHTED = 2 //!< 1 where in sight of both cameras, 0 elsewhere
  };

  ///@{
  /**
   * The cameras of the two frames. Both are needed; the same one may be given twice. Their clipping
   * ranges do not matter. Default none.
   */
  void SetCameraBefore(vtkCamera* camera);
  vtkCamera* GetCameraBefore();
  void SetCameraAfter(vtkCamera* camera);
  vtkCamera* GetCameraAfter();
  ///@}

  ///@{
  /**
   * Width and height of the viewport in logical pixels, each at least 1. Default 800 x 600.
   */
  void SetViewportSize(double width, double height);
  void SetViewportSize(const double size[2]) { this->SetViewportSize(size[0], size[1]); }
  vtkGetVector2Macro(ViewportSize, double);
  ///@}

  ///@{
  /**
   * One of WeightSchemes. Default SYMMETRIC.
   */
  vtkSetClampMacro(WeightScheme, int, SYMMETRIC, UNWEIGHTED);
  vtkGetMacro(WeightScheme, int);
  void SetWeightSchemeToSymmetric() { this->SetWeightScheme(SYMMETRIC); }
  void SetWeightSchemeToClassic() { this->SetWeightScheme(CLASSIC); }
  void SetWeightSchemeToUnweighted() { this->SetWeightScheme(UNWEIGHTED); }
  ///@}

  /**
   * Also the time of the last change to the cameras.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkSimilarityTracker();
  ~vtkSimilarityTracker() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkCamera> CameraBefore;
  vtkSmartPointer<vtkCamera> CameraAfter;
  double ViewportSize[2] = { 800.0, 600.0 };
  int WeightScheme = SYMMETRIC;

private:
  vtkSimilarityTracker(const vtkSimilarityTracker&) = delete;
  void operator=(const vtkSimilarityTracker&) = delete;
};

#endif
