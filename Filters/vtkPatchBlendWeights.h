// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPatchBlendWeights
 * @brief   how the patterns of patches fade into each other across their borders
 *
 * A weight per point and patch (Breslav et al. 2007, section 3.6). Input is a vtkPolyData or a
 * composite of vtkPolyData with a patch id per cell, as from vtkSurfacePatches; the output has two
 * more point arrays:
 * - BlendPatches: four integers, the patches at the point by falling weight, -1 = none.
 * - BlendWeights: four floats, their weights, which add up to 1.
 *
 * Away from borders that is the one patch of the point with a weight of 1, on the border of two
 * patches about 1/2 for each. Of more than four patches the four strongest are kept. Points of no
 * patch have no patches and weights of 0. Memory: 32 bytes per point; time follows the points near
 * borders, not the number of patches.
 *
 * Points in the same place are one, so that seams of normals or texture coordinates do not show.
 * The power to which the paper raises weights is PatchPower of the layer that draws. A corner of a
 * polygon or strip that is not finite is an error.
 */

#ifndef vtkPatchBlendWeights_h
#define vtkPatchBlendWeights_h

#include "HachureFiltersModule.h" // for the export macro
#include "vtkPassInputTypeAlgorithm.h"

#include <limits> // for the ranges of the setters
#include <string> // for PatchArrayName

class HACHUREFILTERS_EXPORT vtkPatchBlendWeights : public vtkPassInputTypeAlgorithm
{
public:
  static vtkPatchBlendWeights* New();
  vtkTypeMacro(vtkPatchBlendWeights, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How the width of the blend is given.
   */
  enum WidthModes
  {
    RINGS = 0,   //!< rings of points about the border, as in the paper
    DISTANCE = 1 //!< a distance along the surface, for irregular meshes
  };

  /**
   * The weights on a border before they are smoothed.
   */
  enum InitialWeights
  {
    EQUAL = 0, //!< 1/k where k patches meet: the text of the paper
    FACES = 1  //!< the fraction of the cells at the point: the authors' program
  };

  ///@{
  /**
   * One of WidthModes. Default RINGS.
   */
  vtkSetClampMacro(WidthMode, int, RINGS, DISTANCE);
  vtkGetMacro(WidthMode, int);
  void SetWidthModeToRings() { this->SetWidthMode(RINGS); }
  void SetWidthModeToDistance() { this->SetWidthMode(DISTANCE); }
  ///@}

  ///@{
  /**
   * RINGS: n of the paper. Weights are 0 from the n-th ring of points outside a patch on, and 1
   * from the n-th ring inside: they are averaged n - 1 times over neighbouring points. At least 1,
   * default 1.
   */
  vtkSetClampMacro(Rings, int, 1, std::numeric_limits<int>::max());
  vtkGetMacro(Rings, int);
  ///@}

  ///@{
  /**
   * DISTANCE: how far a pattern fades on each side of its border, along the surface, in the units
   * of the input. Above 0, default 1. With t the distance to the border, negative outside, the
   * weight is smoothstep(-Distance, Distance, t), then normalised.
   */
  vtkSetClampMacro(Distance, double, 1e-300, 1e300);
  vtkGetMacro(Distance, double);
  ///@}

  ///@{
  /**
   * RINGS: one of InitialWeights. Default EQUAL.
   */
  vtkSetClampMacro(Initial, int, EQUAL, FACES);
  vtkGetMacro(Initial, int);
  void SetInitialToEqual() { this->SetInitial(EQUAL); }
  void SetInitialToFaces() { this->SetInitial(FACES); }
  ///@}

  ///@{
  /**
   * Name of the cell array of integers with one component that gives the patch of every cell, from
   * 0 to 16777215; negative: no patch. Default PatchId. A missing array is an error.
   */
  vtkSetMacro(PatchArrayName, std::string);
  vtkGetMacro(PatchArrayName, std::string);
  ///@}

  ///@{
  /**
   * Whether points in the same place are one also when they belong to different blocks. Default on.
   */
  vtkSetMacro(JoinBlocks, bool);
  vtkGetMacro(JoinBlocks, bool);
  vtkBooleanMacro(JoinBlocks, bool);
  ///@}

protected:
  vtkPatchBlendWeights();
  ~vtkPatchBlendWeights() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int WidthMode = RINGS;
  int Rings = 1;
  double Distance = 1.0;
  int Initial = EQUAL;
  std::string PatchArrayName = "PatchId";
  bool JoinBlocks = true;

private:
  vtkPatchBlendWeights(const vtkPatchBlendWeights&) = delete;
  void operator=(const vtkPatchBlendWeights&) = delete;
};

#endif
