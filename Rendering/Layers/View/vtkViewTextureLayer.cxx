// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkViewTextureLayer.h"

#include "PatternStyleArchive.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTextureViewsManifest.h"

#include <algorithm>

vtkStandardNewMacro(vtkViewTextureLayer);

vtkViewTextureLayer::vtkViewTextureLayer()
  : Views(vtkSmartPointer<vtkTextureViews>::New())
{
  this->GetTone()->SetSource(vtkPatternTone::CONSTANT);
  this->GetTone()->SetConstant(1.0);
}

vtkViewTextureLayer::~vtkViewTextureLayer() = default;

void vtkViewTextureLayer::SetViews(vtkTextureViews* views)
{
  if (!views)
  {
    vtkErrorMacro("SetViews: the views are null; expected a vtkTextureViews");
    return;
  }
  if (this->Views != views)
  {
    this->Views = views;
    this->ManifestFileName.clear();
    this->Modified();
  }
}

vtkTextureViews* vtkViewTextureLayer::GetViews()
{
  return this->Views;
}

bool vtkViewTextureLayer::ReadManifest(const std::string& fileName)
{
  vtkNew<vtkTextureViews> views;
  vtkNew<vtkTextureViewsManifest> manifest;
  if (!manifest->Read(fileName.c_str(), views))
  {
    return false;
  }
  this->SetViews(views);
  this->ManifestFileName = fileName;
  return true;
}

void vtkViewTextureLayer::SetManifestFileName(const char* fileName)
{
  const std::string text = fileName ? fileName : "";
  if (text != this->ManifestFileName)
  {
    this->ManifestFileName = text;
    this->Modified();
  }
}

const char* vtkViewTextureLayer::GetManifestFileName()
{
  return this->ManifestFileName.c_str();
}

vtkMTimeType vtkViewTextureLayer::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Views->GetMTime());
}

void vtkViewTextureLayer::DescribeManifest(hachure::StyleArchive& archive)
{
  const char* const key = "manifest";
  if (archive.getSession().copying)
  {
    if (archive.handOver(key, this->Views, this->ManifestFileName))
    {
      this->Modified();
    }
  }
  else if (!archive.isReading())
  {
    if (!this->ManifestFileName.empty())
    {
      archive.writeFileName(key, this->ManifestFileName);
    }
    else if (this->Views->GetNumberOfViews() > 0)
    {
      archive.fail(key, "the views have no manifest; write one and call SetManifestFileName");
    }
  }
  else if (archive.has(key))
  {
    const std::string fileName = archive.readFileName(key);
    vtkNew<vtkTextureViews> views;
    vtkNew<vtkTextureViewsManifest> manifest;
    vtkNew<vtkCallbackCommand> quiet; // the archive tells of it
    manifest->AddObserver(vtkCommand::ErrorEvent, quiet);
    if (!manifest->Read(fileName.c_str(), views))
    {
      archive.fail(key, manifest->GetError());
    }
    this->SetViews(views);
    this->ManifestFileName = fileName;
  }
}

void vtkViewTextureLayer::DescribeField(hachure::StyleArchive& archive)
{
  using Self = vtkViewTextureLayer;
  this->DescribeManifest(archive);
  archive.choice("display", this, &Self::GetDisplay, &Self::SetDisplay,
    { "combined", "dependentOnly", "independentOnly", "coverage" });
  archive.choice("base", this, &Self::GetBase, &Self::SetBase, { "views", "below" });
  archive.choice("level", this, &Self::GetLevel, &Self::SetLevel, { "pixelsOwn", "one" });
  archive.boolean("propagateUp", this, &Self::GetPropagateUp, &Self::SetPropagateUp);
  archive.boolean("classicShares", this, &Self::GetClassicShares, &Self::SetClassicShares);
  archive.integer("memoryBudget", this, &Self::GetMemoryBudget, &Self::SetMemoryBudget,
    { double(this->GetMemoryBudgetMinValue()), double(this->GetMemoryBudgetMaxValue()) });
}

void vtkViewTextureLayer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Views: " << this->Views.Get() << "\n";
  os << indent << "ManifestFileName: " << this->ManifestFileName << "\n";
  os << indent << "Display: " << this->Display << "\n";
  os << indent << "Base: " << this->Base << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "PropagateUp: " << this->PropagateUp << "\n";
  os << indent << "ClassicShares: " << this->ClassicShares << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
}
