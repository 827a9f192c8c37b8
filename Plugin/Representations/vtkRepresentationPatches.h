// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Divides the surface of a representation into patches, and adds the weights by which patterns fade
 * across their borders: vtkSurfacePatches, then vtkPatchBlendWeights.
 *
 * Where that fails, after the error of the filter that failed, the surface passes undivided. A
 * surface without cells, which processes without data have, passes silently.
 */
#ifndef vtkRepresentationPatches_h
#define vtkRepresentationPatches_h

#include "vtkPassInputTypeAlgorithm.h"

#include <string>

class vtkRepresentationPatches : public vtkPassInputTypeAlgorithm
{
public:
  static vtkRepresentationPatches* New();
  vtkTypeMacro(vtkRepresentationPatches, vtkPassInputTypeAlgorithm);

  ///@{
  /// As in vtkSurfacePatches.
  vtkSetMacro(Method, int);
  vtkSetMacro(ArrayName, std::string);
  vtkSetMacro(NumberOfPatches, int);
  vtkSetMacro(NormalWeight, double);
  vtkSetMacro(CreaseAngle, double);
  vtkSetMacro(JoinBlocks, bool);
  ///@}

  ///@{
  /// As in vtkPatchBlendWeights; 0 rings, or a distance of 0, for sharp borders.
  vtkSetMacro(WidthMode, int);
  vtkSetMacro(Rings, int);
  vtkSetMacro(Distance, double);
  vtkSetMacro(Initial, int);
  ///@}

protected:
  vtkRepresentationPatches() = default;
  ~vtkRepresentationPatches() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkRepresentationPatches(const vtkRepresentationPatches&) = delete;
  void operator=(const vtkRepresentationPatches&) = delete;

  int Method = 0;
  std::string ArrayName;
  int NumberOfPatches = 1;
  double NormalWeight = 0.0;
  double CreaseAngle = 0.0;
  bool JoinBlocks = true;
  int WidthMode = 0;
  int Rings = 0;
  double Distance = 0.0;
  int Initial = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkRepresentationPatches.h
