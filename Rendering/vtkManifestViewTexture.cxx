// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkManifestViewTexture.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTextureViews.h"
#include "vtkTextureViewsManifest.h"

vtkStandardNewMacro(vtkManifestViewTexture);

//------------------------------------------------------------------------------
void vtkManifestViewTexture::SetManifest(const char* fileName)
{
  const std::string name = fileName ? fileName : "";
  if (name != this->Manifest)
  {
    this->Manifest = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkManifestViewTexture::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->Manifest.empty())
  {
    // Reading changes the views, which is older than the output that is made now.
    vtkNew<vtkTextureViewsManifest> manifest;
    if (!manifest->Read(this->Manifest.c_str(), this->GetViews()))
    {
      return 0; // it has said why
    }
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkManifestViewTexture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Manifest: " << this->Manifest << "\n";
}
