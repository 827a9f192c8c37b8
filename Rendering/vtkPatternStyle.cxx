// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternStyle.h"

#include "PatternColor.h"
#include "PatternPresets.h"
#include "PatternStyleJson.h"
#include "vtkObjectFactory.h"

#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <sstream>
#include <stdexcept>

vtkStandardNewMacro(vtkPatternStyle);

namespace
{

constexpr double millimetresPerInch = 25.4;

/** Folder of a file, as an absolute path. */
std::string folderOf(const std::string& fileName)
{
  using vtksys::SystemTools;
  return SystemTools::GetFilenamePath(SystemTools::CollapseFullPath(fileName));
}

} // namespace

//------------------------------------------------------------------------------
vtkPatternStyle::vtkPatternStyle() = default;

//------------------------------------------------------------------------------
vtkPatternStyle::~vtkPatternStyle() = default;

//------------------------------------------------------------------------------
void vtkPatternStyle::AddLayer(vtkPatternLayer* layer)
{
  this->InsertLayer(this->GetNumberOfLayers(), layer);
}

//------------------------------------------------------------------------------
void vtkPatternStyle::InsertLayer(int index, vtkPatternLayer* layer)
{
  if (!layer)
  {
    vtkErrorMacro("InsertLayer: expected a layer, got null.");
    return;
  }
  if (index < 0 || index > this->GetNumberOfLayers())
  {
    vtkErrorMacro("InsertLayer: index " << index << " is out of range; expected 0 to "
                                        << this->GetNumberOfLayers() << ".");
    return;
  }
  if (std::find(this->Layers.begin(), this->Layers.end(), layer) != this->Layers.end())
  {
    vtkErrorMacro("InsertLayer: the layer is in this style already.");
    return;
  }
  this->Layers.insert(this->Layers.begin() + index, layer);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPatternStyle::RemoveLayer(vtkPatternLayer* layer)
{
  const auto found = std::find(this->Layers.begin(), this->Layers.end(), layer);
  if (found == this->Layers.end())
  {
    vtkErrorMacro("RemoveLayer: the layer is not in this style.");
    return;
  }
  this->Layers.erase(found);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPatternStyle::RemoveAllLayers()
{
  if (!this->Layers.empty())
  {
    this->Layers.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPatternLayer* vtkPatternStyle::GetLayer(int index)
{
  if (index < 0 || index >= this->GetNumberOfLayers())
  {
    vtkErrorMacro("GetLayer: index " << index << " is out of range; the style has "
                                     << this->GetNumberOfLayers() << " layers.");
    return nullptr;
  }
  return this->Layers[index];
}

//------------------------------------------------------------------------------
int vtkPatternStyle::GetNumberOfLayers()
{
  return static_cast<int>(this->Layers.size());
}

//------------------------------------------------------------------------------
void vtkPatternStyle::SetPaperColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  this->SetPaperColor(color);
}

//------------------------------------------------------------------------------
void vtkPatternStyle::SetPaperColor(const double color[3])
{
  if (hachure::assignColor(this->PaperColor, color))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPatternStyle::SetOutlineColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  this->SetOutlineColor(color);
}

//------------------------------------------------------------------------------
void vtkPatternStyle::SetOutlineColor(const double color[3])
{
  if (hachure::assignColor(this->OutlineColor, color))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPatternStyle::SetFeatureArrayName(const std::string& name)
{
  if (this->FeatureArrayName != name)
  {
    this->FeatureArrayName = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkPatternStyle::GetFeatureArrayName()
{
  return this->FeatureArrayName;
}

//------------------------------------------------------------------------------
double vtkPatternStyle::GetLengthInPixels(double length, int unit)
{
  return unit == vtkPatternLayer::MILLIMETRES ? length / millimetresPerInch * this->DotsPerInch
                                              : length;
}

//------------------------------------------------------------------------------
int vtkPatternStyle::GetNumberOfPresets()
{
  return static_cast<int>(hachure::presets().size());
}

//------------------------------------------------------------------------------
const char* vtkPatternStyle::GetPresetName(int index)
{
  const bool exists = index >= 0 && index < vtkPatternStyle::GetNumberOfPresets();
  return exists ? hachure::presets()[index].name : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkPatternStyle::GetDefaultPresetName()
{
  return "cross-hatch";
}

//------------------------------------------------------------------------------
bool vtkPatternStyle::LoadPreset(const std::string& name)
{
  std::string names;
  for (const hachure::Preset& preset : hachure::presets())
  {
    if (preset.name == name)
    {
      return this->FromJson(preset.json);
    }
    names += (names.empty() ? "" : ", ") + std::string(preset.name);
  }
  vtkErrorMacro("LoadPreset: unknown style \"" << name << "\"; expected one of " << names << ".");
  return false;
}

//------------------------------------------------------------------------------
bool vtkPatternStyle::FromJson(const std::string& json)
{
  try
  {
    hachure::readStyle(json, "", this);
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
}

//------------------------------------------------------------------------------
bool vtkPatternStyle::LoadFile(const std::string& fileName)
{
  vtksys::ifstream file(fileName.c_str(), std::ios::in | std::ios::binary);
  std::ostringstream text;
  if (!vtksys::SystemTools::FileExists(fileName, true) || !file || !(text << file.rdbuf()))
  {
    vtkErrorMacro("LoadFile: cannot read the style file \"" << fileName << "\".");
    return false;
  }
  try
  {
    hachure::readStyle(text.str(), folderOf(fileName), this);
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("LoadFile: " << fileName << ": " << error.what());
    return false;
  }
}

//------------------------------------------------------------------------------
void vtkPatternStyle::CopyFrom(vtkPatternStyle* other)
{
  if (!other)
  {
    vtkErrorMacro("CopyFrom: expected a style, got null.");
  }
  else if (other != this)
  {
    hachure::copyStyle(other, this);
  }
}

//------------------------------------------------------------------------------
std::string vtkPatternStyle::ToJson()
{
  try
  {
    return hachure::writeStyle(this, "");
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("ToJson: " << error.what());
    return "";
  }
}

//------------------------------------------------------------------------------
bool vtkPatternStyle::SaveFile(const std::string& fileName)
{
  try
  {
    const std::string text = hachure::writeStyle(this, folderOf(fileName));
    vtksys::ofstream file(fileName.c_str(), std::ios::out | std::ios::binary);
    if (!(file << text) || !file.flush())
    {
      throw std::runtime_error("cannot write the style file \"" + fileName + "\"");
    }
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("SaveFile: " << error.what());
    return false;
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPatternStyle::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const auto& layer : this->Layers)
  {
    time = std::max(time, layer->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkPatternStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PixelScale: " << this->PixelScale << "\n";
  os << indent << "FinalQuality: " << this->FinalQuality << "\n";
  os << indent << "DotsPerInch: " << this->DotsPerInch << "\n";
  os << indent << "PaperSource: " << this->PaperSource << "\n";
  os << indent << "PaperColor: " << this->PaperColor[0] << ", " << this->PaperColor[1] << ", "
     << this->PaperColor[2] << "\n";
  os << indent << "Outline: " << this->Outline << "\n";
  os << indent << "OutlineColor: " << this->OutlineColor[0] << ", " << this->OutlineColor[1] << ", "
     << this->OutlineColor[2] << "\n";
  os << indent << "OutlineWidth: " << this->OutlineWidth << "\n";
  os << indent << "OutlineWidthUnit: " << this->OutlineWidthUnit << "\n";
  os << indent << "OutlineSilhouette: " << this->OutlineSilhouette << "\n";
  os << indent << "OutlineCreases: " << this->OutlineCreases << "\n";
  os << indent << "OutlineBorders: " << this->OutlineBorders << "\n";
  os << indent << "OutlineCreaseAngle: " << this->OutlineCreaseAngle << "\n";
  os << indent << "TrackingMode: " << this->TrackingMode << "\n";
  os << indent << "WeightScheme: " << this->WeightScheme << "\n";
  os << indent << "FeatureSource: " << this->FeatureSource << "\n";
  os << indent << "FeatureArrayName: " << this->FeatureArrayName << "\n";
  os << indent << "LockRotation: " << this->LockRotation << "\n";
  os << indent << "LockScale: " << this->LockScale << "\n";
  os << indent << "SamplesPerPatch: " << this->SamplesPerPatch << "\n";
  os << indent << "Layers: " << this->Layers.size() << "\n";
  for (const auto& layer : this->Layers)
  {
    layer->PrintSelf(os, indent.GetNextIndent());
  }
}
