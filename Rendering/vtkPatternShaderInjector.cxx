// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternShaderInjector.h"

#include "PatternSurface.h"
#include "SurfaceLight.h"
#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkPatternShaderText.h"
#include "vtkPatternTone.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"

#include <algorithm>

vtkStandardNewMacro(vtkPatternShaderInjector);

namespace
{
std::string Section(const std::string& name)
{
  return vtkPattern::ShaderSection(PatternSurface, name);
}

std::string ForChannel(const std::string& name, std::size_t channel)
{
  std::string text = Section(name);
  const std::string number = std::to_string(channel);
  vtkShaderProgram::Substitute(text, "ToneKMC", "Tone" + number + "MC");
  vtkShaderProgram::Substitute(text, "ToneKVS", "Tone" + number + "VS");
  vtkShaderProgram::Substitute(text, "ToneKGS", "Tone" + number + "GS");
  vtkShaderProgram::Substitute(text, "CellToneK", "CellTone" + number);
  vtkShaderProgram::Substitute(text, "ArrayK", "Array" + number);
  vtkShaderProgram::Substitute(text, "PowerK", "Power" + number);
  vtkShaderProgram::Substitute(text, "[K]", "[" + number + "]");
  return text;
}

const char* const beforeLight = "//Hachure::BeforeLight";
const char* const afterLight = "//Hachure::AfterLight";
const char* const output = "//Hachure::Output";
} // namespace

void vtkPatternShaderInjector::Configure(StageType stage, const vtkPatternToneChannels& channels,
  std::size_t lights, bool flatPaper, const vtkPatternAttributes& attributes,
  const std::string& composeText)
{
  const std::size_t used = channels.UseLights() ? lights : 0;
  if (this->ConfigureTime.GetMTime() > 0 && stage == this->Stage && channels == this->Channels &&
    used == this->Lights && flatPaper == this->FlatPaper && attributes == this->Needed &&
    composeText == this->ComposeText)
  {
    return;
  }
  this->Stage = stage;
  this->Channels = channels;
  this->Lights = used;
  this->FlatPaper = flatPaper;
  this->Needed = attributes;
  this->ComposeText = composeText;
  this->ConfigureTime.Modified();
}

bool vtkPatternShaderInjector::Place(
  std::string& shader, const std::string& tag, const std::string& text)
{
  if (!vtkShaderProgram::Substitute(shader, tag, text, false))
  {
    vtkErrorMacro("VTK's surface shader has no tag " << tag
                                                     << "; the pattern cannot be drawn with this "
                                                        "version of VTK");
    return false;
  }
  return true;
}

std::string vtkPatternShaderInjector::SurfaceText(const std::string& ending) const
{
  std::string text;
  const bool patches = this->Needed.Has(vtkPatternAttributes::PATCH);
  const bool runs = this->Needed.Has(vtkPatternAttributes::RUN);
  if (this->Needed.Has(vtkPatternAttributes::POINT) ||
    ((patches || runs) && this->Stage == FORWARD))
  {
    text += Section("Point" + ending);
  }
  if (this->Needed.Has(vtkPatternAttributes::TEXTURE))
  {
    text += Section("Texture" + ending);
  }
  if (runs)
  {
    text += Section("Run" + ending);
  }
  if (patches)
  {
    text += Section("Patch" + ending);
  }
  return text;
}

std::string vtkPatternShaderInjector::SurfaceValues() const
{
  std::string text;
  if (this->Needed.Has(vtkPatternAttributes::POINT))
  {
    text += Section("FacetFSImpl");
  }
  if (this->Needed.Has(vtkPatternAttributes::TEXTURE))
  {
    text += Section("TextureFSImpl");
  }
  return text;
}

std::string vtkPatternShaderInjector::SurfaceOutputs() const
{
  const bool forward = this->Stage == FORWARD;
  std::string text;
  const auto images = this->Needed.Images();
  for (std::size_t image = 0; image < images.size(); ++image)
  {
    std::string name;
    switch (images[image])
    {
      case vtkPatternAttributes::NORMAL:
        name = forward ? "" : "Normal"; // outlines are drawn from images
        break;
      case vtkPatternAttributes::RUN:
        name = "Run";
        break;
      case vtkPatternAttributes::PATCH:
        name = "Patch";
        break;
      case vtkPatternAttributes::POINT:
        name = "Point";
        break;
      case vtkPatternAttributes::TEXTURE:
        name = "Texture";
        break;
      case vtkPatternAttributes::TEXTURE_SLOPES:
        name = forward ? "" : "Slopes"; // goes with the coordinates
        break;
      default:;
    }
    if (!name.empty())
    {
      std::string section = Section(name + (forward ? "Forward" : "Attribute"));
      vtkShaderProgram::Substitute(section, "[IMAGE]", "[" + std::to_string(image) + "]");
      text += section;
    }
  }
  return text;
}

bool vtkPatternShaderInjector::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  std::string vertexDec = this->SurfaceText("VSDec");
  std::string vertexImpl = this->SurfaceText("VSImpl");
  std::string geometryDec = this->SurfaceText("GSDec");
  std::string geometryImpl = this->SurfaceText("GSImpl");
  std::string fragmentDec = this->DrawsIds() ? Section("IdsFSDec") : std::string();
  fragmentDec += this->Stage == PEEL ? Section("PeelFSDec") : std::string();
  fragmentDec += this->Needed.Surroundings ? Section("SurroundingsFSDec") : std::string();
  fragmentDec += Section("Dec") + this->ComposeText + this->SurfaceText("FSDec");
  fragmentDec += this->LightsDeclaration();
  const auto& channels = this->Channels.Get();
  for (std::size_t i = 0; i < channels.size(); ++i)
  {
    if (channels[i].Source != vtkPatternTone::ARRAY)
    {
      continue;
    }
    if (channels[i].OnCells)
    {
      fragmentDec += ForChannel("CellToneFSDec", i);
    }
    else
    {
      vertexDec += ForChannel("PointToneVSDec", i);
      vertexImpl += ForChannel("PointToneVSImpl", i);
      geometryDec += ForChannel("PointToneGSDec", i);
      geometryImpl += ForChannel("PointToneGSImpl", i);
      fragmentDec += ForChannel("PointToneFSDec", i);
    }
  }
  bool placed =
    this->Place(fragmentShader, "//VTK::TCoord::Dec", "//VTK::TCoord::Dec\n" + fragmentDec) &&
    this->Place(fragmentShader, "//VTK::Light::Impl",
      std::string(beforeLight) + "\n  //VTK::Light::Impl\n" + afterLight + "\n") &&
    this->Place(
      fragmentShader, "//VTK::TCoord::Impl", std::string("//VTK::TCoord::Impl\n") + output + "\n");
  if (placed && !vertexDec.empty())
  {
    placed = this->Place(vertexShader, "//VTK::TCoord::Dec", "//VTK::TCoord::Dec\n" + vertexDec) &&
      this->Place(vertexShader, "//VTK::TCoord::Impl", "//VTK::TCoord::Impl\n" + vertexImpl);
    if (placed && !geometryShader.empty())
    {
      placed =
        this->Place(geometryShader, "//VTK::TCoord::Dec", "//VTK::TCoord::Dec\n" + geometryDec) &&
        this->Place(geometryShader, "//VTK::TCoord::Impl", "//VTK::TCoord::Impl\n" + geometryImpl);
    }
  }
  return placed;
}

std::string vtkPatternShaderInjector::LightsDeclaration() const
{
  if (!this->Channels.UseLights())
  {
    return {};
  }
  std::string text = SurfaceLight + Section("LightsDec");
  // Arrays have at least one element.
  const std::size_t declared = std::max<std::size_t>(this->Lights, 1);
  vtkShaderProgram::Substitute(text, "LIGHTS", std::to_string(declared));
  const auto& channels = this->Channels.Get();
  for (std::size_t i = 0; i < channels.size(); ++i)
  {
    if (channels[i].Source == vtkPatternTone::HIGHLIGHT)
    {
      text += ForChannel("HighlightDec", i);
    }
  }
  return text;
}

std::string vtkPatternShaderInjector::LightText(
  const std::string& section, std::size_t channel) const
{
  const int index = this->Channels.Get()[channel].LightIndex;
  const auto count = static_cast<int>(this->Lights);
  const int first = index < 0 || index >= count ? 0 : index;
  const int last = index < 0 ? count : index >= count ? 0 : index + 1;
  std::string text = ForChannel(section, channel);
  vtkShaderProgram::Substitute(text, "FIRST", std::to_string(first));
  vtkShaderProgram::Substitute(text, "LAST", std::to_string(last));
  return text;
}

std::string vtkPatternShaderInjector::ToneText(bool lit, bool lighting) const
{
  std::string text;
  const auto& channels = this->Channels.Get();
  for (std::size_t i = 0; i < channels.size(); ++i)
  {
    switch (channels[i].Source)
    {
      case vtkPatternTone::ARRAY:
        text += ForChannel(channels[i].OnCells ? "CellToneFSImpl" : "PointToneFSImpl", i);
        text += ForChannel("ToneArray", i);
        break;
      case vtkPatternTone::LIT_COLOR:
        text += ForChannel("ToneLitColor", i);
        break;
      case vtkPatternTone::LIGHT:
        // A surface that takes no light is paper, also as the source LIT has it.
        text += lit ? this->LightText("ToneLight", i)
                    : ForChannel(lighting ? "ToneNoLight" : "ToneLit", i);
        break;
      case vtkPatternTone::HIGHLIGHT:
        text += lit ? this->LightText("ToneHighlight", i) : ForChannel("ToneNoHighlight", i);
        break;
      case vtkPatternTone::LUMINANCE:
        text += ForChannel("ToneLuminance", i);
        break;
      default:
        text += ForChannel("ToneLit", i);
    }
  }
  return text;
}

std::string vtkPatternShaderInjector::StageText(bool colors) const
{
  if (this->Stage == FORWARD)
  {
    const std::string ids = this->DrawsIds() ? Section("IdsForward") : std::string();
    const bool bare = this->ComposeText.find("hachurePaperHere;") != std::string::npos;
    return this->SurfaceOutputs() + ids + Section(bare ? "ForwardNoPaper" : "Forward");
  }
  const std::string peel = this->Stage == PEEL ? Section("PeelFSImpl") : std::string();
  const std::string surroundings =
    this->Needed.Surroundings ? Section("SurroundingsAttribute") : std::string();
  const std::string text = peel + Section("Attributes") + surroundings + this->SurfaceOutputs();
  return colors ? text : text + Section("NoColors");
}

bool vtkPatternShaderInjector::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool lighting = actor && actor->GetProperty()->GetLighting();
  // How VTK lit the surface shows in what it declared.
  const bool physical = fragmentShader.find("vec3 Lo ") != std::string::npos;
  const bool lit = physical || fragmentShader.find("vec3 diffuse ") != std::string::npos;
  const std::string shading = physical ? "Physical" : lit ? "BlinnPhong" : "Unlit";
  const bool hasEdges = fragmentShader.find("float emix") != std::string::npos;
  const bool blended = fragmentShader.find("float edgeOpacity") != std::string::npos;
  const std::string edges = !hasEdges ? "EdgesOff" : blended ? "EdgesBlended" : "EdgesOn";

  std::string text = Section(lit ? "NormalLit" : "NormalUnlit") + Section(edges) +
    Section("ToneStart") + Section("OwnColor") + this->ToneText(lit, lighting) +
    (this->FlatPaper ? Section("FlatPaper") : std::string()) + this->SurfaceValues() +
    this->StageText(hasEdges || this->Needed.Colors);
  return this->Place(fragmentShader, beforeLight, Section("BeforeLight" + shading)) &&
    this->Place(fragmentShader, afterLight, Section("AfterLight" + shading)) &&
    this->Place(fragmentShader, output, text);
}

bool vtkPatternShaderInjector::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  if (this->UniformSetter)
  {
    this->UniformSetter(program);
  }
  return true;
}
