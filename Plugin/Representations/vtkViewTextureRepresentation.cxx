// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkViewTextureRepresentation.h"

#include "RepresentationFile.h"
#include "ViewTextureEditor.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkStringArray.h"
#include "vtkTextureViewsManifest.h"

vtkStandardNewMacro(vtkViewTextureRepresentation);

namespace
{
std::string Text(const char* text)
{
  return text ? text : "";
}
} // namespace

//------------------------------------------------------------------------------
vtkViewTextureRepresentation::vtkViewTextureRepresentation()
  : Editor(std::make_unique<ViewTextureEditor>())
  , Names(vtkSmartPointer<vtkStringArray>::New())
{
  this->SetPatternStyle("view");
}

//------------------------------------------------------------------------------
vtkViewTextureRepresentation::~vtkViewTextureRepresentation() = default;

//------------------------------------------------------------------------------
void vtkViewTextureRepresentation::SetViewTextureManifest(const char* fileName)
{
  const std::string name = Text(fileName);
  this->ManifestChanged = this->ManifestChanged || name != this->ViewTextureManifest;
  this->Change(this->ViewTextureManifest, name);
}

//------------------------------------------------------------------------------
const char* vtkViewTextureRepresentation::GetViewTextureManifest()
{
  return this->ViewTextureManifest.c_str();
}

//------------------------------------------------------------------------------
void vtkViewTextureRepresentation::SetViewTextureSaveName(const char* fileName)
{
  this->ViewTextureSaveName = Text(fileName);
}

//------------------------------------------------------------------------------
const char* vtkViewTextureRepresentation::GetViewTextureSaveName()
{
  return this->ViewTextureSaveName.c_str();
}

//------------------------------------------------------------------------------
void vtkViewTextureRepresentation::AdjustStyle(vtkPatternStyle* style)
{
  this->Superclass::AdjustStyle(style);
  this->UpdateViews();
  ForEachLayer<vtkViewTextureLayer>(
    style, [this](vtkViewTextureLayer* layer) { this->AdjustLayer(layer); });
}

//------------------------------------------------------------------------------
void vtkViewTextureRepresentation::AdjustLayer(vtkViewTextureLayer* layer)
{
  if (this->Views)
  {
    layer->SetViews(this->Views);
    layer->SetManifestFileName(this->ViewsFile.c_str());
  }
  if (this->ViewTextureDisplay != AS_IN_STYLE)
  {
    layer->SetDisplay(this->ViewTextureDisplay);
  }
  if (this->ViewTextureBase != AS_IN_STYLE)
  {
    layer->SetBase(this->ViewTextureBase);
  }
  if (this->ViewTextureLevel != AS_IN_STYLE)
  {
    layer->SetLevel(this->ViewTextureLevel);
  }
  if (this->ViewTexturePropagateUp != AS_IN_STYLE)
  {
    layer->SetPropagateUp(this->ViewTexturePropagateUp != 0);
  }
  if (this->ViewTextureClassicShares != AS_IN_STYLE)
  {
    layer->SetClassicShares(this->ViewTextureClassicShares != 0);
  }
  if (this->ViewTextureMemoryBudget > 0)
  {
    layer->SetMemoryBudget(this->ViewTextureMemoryBudget);
  }
}

//------------------------------------------------------------------------------
void vtkViewTextureRepresentation::UpdateViews()
{
  if (!this->ManifestChanged)
  {
    return;
  }
  this->ManifestChanged = false; // also when it cannot be read: one error, not one per picture
  if (this->ViewTextureManifest.empty())
  {
    this->Views = nullptr;
    this->ViewsFile.clear();
  }
  else
  {
    this->ReadViews(this->ViewTextureManifest);
  }
}

//------------------------------------------------------------------------------
void vtkViewTextureRepresentation::ReadViews(const std::string& fileName)
{
  // Reading into views that are there keeps what has not changed in them.
  const auto views = this->Views ? this->Views : vtkSmartPointer<vtkTextureViews>::New();
  vtkNew<vtkTextureViewsManifest> manifest;
  if (manifest->Read(fileName.c_str(), views))
  {
    this->Views = views;
    this->ViewsFile = fileName;
    this->SavedViews = views->GetMTime();
  }
}

//------------------------------------------------------------------------------
std::string vtkViewTextureRepresentation::GetUnsaved()
{
  const bool saved = !this->Views || this->Views->GetMTime() == this->SavedViews;
  return saved ? std::string() : "The views have changed: save the manifest first.";
}

//------------------------------------------------------------------------------
vtkViewTextureLayer* vtkViewTextureRepresentation::FirstLayer()
{
  vtkViewTextureLayer* first = nullptr;
  ForEachLayer<vtkViewTextureLayer>(
    this->GetStyle(), [&first](vtkViewTextureLayer* layer) { first = first ? first : layer; });
  return first;
}

//------------------------------------------------------------------------------
bool vtkViewTextureRepresentation::TakeViews()
{
  this->UpdateStyle();
  vtkViewTextureLayer* const first = this->FirstLayer();
  if (first && !this->Views)
  {
    this->ViewsFile = first->GetManifestFileName();
    this->Views = first->GetViews();
    this->SavedViews = this->Views->GetMTime();
    ForEachLayer<vtkViewTextureLayer>(
      this->GetStyle(), [this](vtkViewTextureLayer* layer) { this->AdjustLayer(layer); });
  }
  return first != nullptr;
}

//------------------------------------------------------------------------------
void vtkViewTextureRepresentation::ReadViewTextureManifest()
{
  if (!this->TakeViews() || this->ViewsFile.empty())
  {
    vtkErrorMacro("The views were not read from a manifest.");
    return;
  }
  this->ReadViews(std::string(this->ViewsFile));
}

//------------------------------------------------------------------------------
void vtkViewTextureRepresentation::AddViewTextureCamera()
{
  const bool transparent = this->ViewTexturePicture == TRANSPARENT;
  if (!this->Editor->GetView())
  {
    vtkErrorMacro("There is no view whose camera could be added.");
  }
  else if (!this->TakeViews())
  {
    vtkErrorMacro("The style \"" << this->GetPatternStyleFile()
                                 << "\" has no layer of views that a camera could be added to.");
  }
  else
  {
    if (!transparent && !ViewTextureEditor::IsAlone())
    {
      vtkWarningMacro("The picture of the view is transparent, since several processes draw.");
    }
    this->Editor->AddCamera(this->Views, this->Actor, transparent, this->ViewTextureExtremeAngle);
  }
}

//------------------------------------------------------------------------------
std::string vtkViewTextureRepresentation::FileToSave()
{
  return this->ViewTextureSaveName.empty() ? this->ViewsFile : this->ViewTextureSaveName;
}

//------------------------------------------------------------------------------
void vtkViewTextureRepresentation::SaveViewTextureManifest()
{
  const bool any = this->TakeViews();
  const std::string fileName = this->FileToSave();
  if (!any || fileName.empty())
  {
    vtkErrorMacro("There is no name of a manifest that the views could be saved to.");
  }
  else
  {
    vtkNew<vtkTextureViewsManifest> manifest;
    if (!RepresentationFile::IsWriter() || manifest->Write(fileName.c_str(), this->Views))
    {
      this->Change(this->ViewsFile, fileName);
      this->SavedViews = this->Views->GetMTime();
    }
  }
}

//------------------------------------------------------------------------------
void vtkViewTextureRepresentation::ShowViews()
{
  if (this->ViewTextureShowViews && this->TakeViews())
  {
    vtkViewTextureLayer* const layer = this->FirstLayer();
    const bool outlined = layer && layer->GetDisplay() == vtkViewTextureLayer::COVERAGE;
    this->Editor->Show(this->Views, this->Actor,
      outlined ? this->Mapper->GetInputDataObject(0, 0) : nullptr, this->FileToSave());
  }
  else
  {
    this->Editor->Hide();
  }
}

//------------------------------------------------------------------------------
int vtkViewTextureRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  const int processed = this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
  // The view asks for bounds between the two; where the surface is may be known only afterwards.
  if (processed &&
    (request == vtkPVView::REQUEST_UPDATE() || request == vtkPVView::REQUEST_RENDER()))
  {
    this->ShowViews();
  }
  return processed;
}

//------------------------------------------------------------------------------
void vtkViewTextureRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  if (!visible)
  {
    this->Editor->Hide();
  }
}

//------------------------------------------------------------------------------
bool vtkViewTextureRepresentation::AddToView(vtkView* view)
{
  this->Editor->SetView(vtkPVRenderView::SafeDownCast(view));
  return this->Superclass::AddToView(view);
}

//------------------------------------------------------------------------------
bool vtkViewTextureRepresentation::RemoveFromView(vtkView* view)
{
  this->Editor->SetView(nullptr);
  return this->Superclass::RemoveFromView(view);
}

//------------------------------------------------------------------------------
vtkStringArray* vtkViewTextureRepresentation::GetViewTextureNames()
{
  this->Names->Reset();
  vtkViewTextureLayer* const first = this->FirstLayer();
  vtkTextureViews* const views = this->Views || !first ? this->Views.Get() : first->GetViews();
  for (int i = 0; views && i < views->GetNumberOfViews(); ++i)
  {
    this->Names->InsertNextValue(views->GetViewName(i));
  }
  return this->Names;
}

//------------------------------------------------------------------------------
void vtkViewTextureRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ViewTextureManifest: " << this->ViewTextureManifest << "\n";
  os << indent << "ViewTextureDisplay: " << this->ViewTextureDisplay << "\n";
  os << indent << "ViewTextureBase: " << this->ViewTextureBase << "\n";
  os << indent << "ViewTextureLevel: " << this->ViewTextureLevel << "\n";
  os << indent << "ViewTexturePropagateUp: " << this->ViewTexturePropagateUp << "\n";
  os << indent << "ViewTextureClassicShares: " << this->ViewTextureClassicShares << "\n";
  os << indent << "ViewTextureMemoryBudget: " << this->ViewTextureMemoryBudget << "\n";
  os << indent << "ViewTextureShowViews: " << this->ViewTextureShowViews << "\n";
  os << indent << "ViewTexturePicture: " << this->ViewTexturePicture << "\n";
  os << indent << "ViewTextureExtremeAngle: " << this->ViewTextureExtremeAngle << "\n";
  os << indent << "ViewTextureSaveName: " << this->ViewTextureSaveName << "\n";
}
