// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkManifestViewTexture
 * @brief   a view-dependent texture of the views in a file
 *
 * vtkViewDependentTexture, whose views are those that a manifest names: where it can be given a
 * file, but no object. Outputs are the same.
 *
 * @sa vtkTextureViewsManifest
 */

#ifndef vtkManifestViewTexture_h
#define vtkManifestViewTexture_h

#include "HachureRenderingModule.h" // for the export macro
#include "vtkViewDependentTexture.h"

#include <string> // for the name

class HACHURERENDERING_EXPORT vtkManifestViewTexture : public vtkViewDependentTexture
{
public:
  static vtkManifestViewTexture* New();
  vtkTypeMacro(vtkManifestViewTexture, vtkViewDependentTexture);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The manifest, see vtkTextureViewsManifest. It is read into the views whenever the filter runs,
   * so that after Modified() it has what has been painted since. One that cannot be read is an
   * error with its reason. Default empty: the views are used as they are.
   */
  void SetManifest(const char* fileName);
  const char* GetManifest() { return this->Manifest.c_str(); }
  ///@}

protected:
  vtkManifestViewTexture() = default;
  ~vtkManifestViewTexture() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkManifestViewTexture(const vtkManifestViewTexture&) = delete;
  void operator=(const vtkManifestViewTexture&) = delete;

  std::string Manifest;
};

#endif
