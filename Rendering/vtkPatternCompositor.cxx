// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternCompositor.h"

#include "Ink.h"
#include "Kernels.h"
#include "Lod.h"
#include "Mix.h"
#include "NoiseKernel.h"
#include "PatchBlend.h"
#include "PatternColorAt.h"
#include "PatternCompose.h"
#include "PatternField.h"
#include "PatternLayer.h"
#include "PatternPatchRecords.h"
#include "PatternPatches.h"
#include "PatternRuns.h"
#include "PatternSeen.h"
#include "ProcessInks.h"
#include "Screens.h"
#include "SurfacePattern.h"
#include "ToneCurve.h"
#include "ViewCells.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternLayer.h"
#include "vtkPatternPatches.h"
#include "vtkPatternShaderText.h"
#include "vtkPatternStyle.h"
#include "vtkPatternTone.h"
#include "vtkPatternToneCurve.h"
#include "vtkPatternViewport.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace
{
constexpr std::size_t tableTones = 256;

glm::vec3 Linear(const double* color)
{
  return hachure::glsl::toLinear(glm::vec3(
    static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2])));
}

// The tone whose threshold is `value` in a row of thresholds.
float ToneOf(float value, const float* row)
{
  const float* end = row + tableTones;
  const float* above = std::upper_bound(row, end, value);
  if (above == row || above == end)
  {
    return above == row ? 0.0f : 1.0f;
  }
  const float below = *(above - 1);
  return (static_cast<float>(above - row - 1) + (value - below) / (*above - below)) /
    static_cast<float>(tableTones - 1);
}

// For every row of thresholds: the tones whose thresholds are the values that stand at the columns
// of a table, each followed by the growth of the tone with the value there.
std::vector<float> InverseTable(const std::vector<float>& thresholds)
{
  constexpr auto last = static_cast<float>(tableTones - 1);
  std::vector<float> all;
  all.reserve(2 * thresholds.size());
  for (std::size_t row = 0; row < thresholds.size(); row += tableTones)
  {
    for (std::size_t i = 0; i < tableTones; ++i)
    {
      const float value = static_cast<float>(i) / last;
      const float* const first = &thresholds[row];
      all.push_back(ToneOf(value, first));
      all.push_back(
        last * (ToneOf(value + 0.5f / last, first) - ToneOf(value - 0.5f / last, first)));
    }
  }
  return all;
}

void UploadTable(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, int components,
  std::vector<float>& values)
{
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  const std::size_t rows = values.size() / (tableTones * static_cast<std::size_t>(components));
  texture->Create2DFromRaw(static_cast<unsigned int>(tableTones), static_cast<unsigned int>(rows),
    components, VTK_FLOAT, values.data());
}

const char* BlendFunction(int mode)
{
  switch (mode)
  {
    case vtkPatternLayer::MULTIPLY:
      return "blendMultiply";
    case vtkPatternLayer::OVERLAY:
      return "blendOverlay";
    case vtkPatternLayer::SCREEN:
      return "blendScreen";
    default:
      return "blendOver";
  }
}

// A colour of the shader.
const char* PaperColor(int source)
{
  switch (source)
  {
    case vtkPatternStyle::CONSTANT:
      return "hachurePaper";
    case vtkPatternStyle::NO_PAPER:
      return "hachurePaperHere";
    default:
      return "hachureSurfaceHere";
  }
}

// What a layer's shader text takes its tone from.
std::string ToneExpression(vtkPatternTone* tone, int channel)
{
  if (tone->IsSeparation())
  {
    const char* const inks = "xyzw";
    return std::string("processInks(hachureSurfaceHere, hachureCurve@.w).") +
      inks[tone->GetSource() - vtkPatternTone::CYAN];
  }
  return channel < 0 ? "hachureCurve@.z" : "tones[" + std::to_string(channel) + "]";
}

// The tone with its curve.
std::string CurvedTone(vtkPatternTone* tone, int channel)
{
  const std::string power = ToneExpression(tone, channel) + ", hachureCurve@.x, hachureCurve@.y";
  return tone->GetRemap() == vtkPatternTone::NONE ? "tonePower(" + power + ")"
                                                  : "toneCurve(" + power + ", hachureRemap@)";
}

} // namespace

void vtkPatternCompositor::Update(vtkPatternStyle* style, const vtkPatternToneChannels& channels,
  const vtkPatternPatches& patches, vtkOpenGLRenderWindow* window,
  const vtkPatternLayerPainter::Scene& scene, std::string& error)
{
  this->Window = window;
  this->PatchCount = patches.GetCount();
  this->CurrentScene = scene;
  this->Outline = style->GetOutline() && style->GetOutlineWidth() > 0.0;
  this->Layers.clear();
  std::map<vtkSmartPointer<vtkPatternLayer>, std::unique_ptr<vtkPatternLayerPainter>> kept;
  for (int i = 0; i < style->GetNumberOfLayers(); ++i)
  {
    Drawn drawn;
    drawn.Layer = style->GetLayer(i);
    drawn.Channel = channels.Find(drawn.Layer->GetTone());
    auto& painter = kept[drawn.Layer];
    painter = std::move(this->Painters[drawn.Layer]);
    if (!painter)
    {
      painter = vtkPatternLayerPainter::New(drawn.Layer);
    }
    std::string problem;
    const bool known = painter != nullptr;
    if (!known)
    {
      problem = "unknown type of layer";
    }
    if (drawn.Layer->GetEnabled() && known && painter->Update(window, scene, problem))
    {
      drawn.Painter = painter.get();
      this->Layers.push_back(drawn);
    }
    else if (drawn.Layer->GetEnabled() && error.empty())
    {
      error = "layer " + std::to_string(i) + ": " + problem;
    }
  }
  for (auto& old : this->Painters)
  {
    if (old.second)
    {
      old.second->ReleaseGraphicsResources(window);
    }
  }
  this->Painters = std::move(kept);
  this->UpdateText(style->GetPaperSource());
  this->UpdateTables(window);
}

std::string vtkPatternCompositor::GetNote() const
{
  for (std::size_t i = 0; i < this->Layers.size(); ++i)
  {
    const std::string note = this->Layers[i].Painter->GetNote();
    if (!note.empty())
    {
      return "layer " + std::to_string(i) + ": " + note;
    }
  }
  return {};
}

vtkPatternAttributes vtkPatternCompositor::GetAttributes() const
{
  vtkPatternAttributes needed;
  needed.Outline = this->Outline;
  needed.Colors = this->Colors;
  for (const Drawn& layer : this->Layers)
  {
    needed.Surface = std::max(needed.Surface, layer.Painter->GetSurfaceNeed());
    needed.PrimitiveIds = needed.PrimitiveIds || layer.Painter->NeedsPrimitiveIds();
    needed.Runs = needed.Runs || layer.Painter->NeedsRuns();
    needed.Patches = needed.Patches || (this->PatchCount > 1 && layer.Painter->FollowsPatches());
  }
  return needed;
}

bool vtkPatternCompositor::NeedsFields() const
{
  return std::any_of(this->Layers.begin(), this->Layers.end(),
    [](const Drawn& layer) { return layer.Painter->NeedsField(); });
}

std::string vtkPatternCompositor::DrawFields(const vtkPatternLayerPainter::FieldScene& scene)
{
  return this->ForFields(&vtkPatternLayerPainter::DrawField, scene);
}

std::string vtkPatternCompositor::DrawForwardFields(const vtkPatternLayerPainter::FieldScene& scene)
{
  return this->ForFields(&vtkPatternLayerPainter::DrawForwardField, scene);
}

void vtkPatternCompositor::CollectDiscs(std::vector<vtkPatternLayerPainter::Disc>& discs) const
{
  for (const Drawn& layer : this->Layers)
  {
    layer.Painter->CollectDiscs(discs);
  }
}

std::string vtkPatternCompositor::ForFields(
  FieldFunction draw, const vtkPatternLayerPainter::FieldScene& scene)
{
  std::string problem;
  for (std::size_t i = 0; i < this->Layers.size(); ++i)
  {
    const Drawn& layer = this->Layers[i];
    if (layer.Painter->NeedsField())
    {
      const std::string own = (layer.Painter->*draw)(scene, layer.Channel);
      if (problem.empty() && !own.empty())
      {
        problem.append("layer ").append(std::to_string(i)).append(": ").append(own);
      }
    }
  }
  return problem;
}

std::string vtkPatternCompositor::Declarations(bool forward) const
{
  std::string declarations;
  for (std::size_t i = 0; i < this->Layers.size(); ++i)
  {
    const Drawn& layer = this->Layers[i];
    const bool patches = this->PatchCount > 1;
    std::string declaration = (forward ? layer.Painter->GetForwardDeclarations(patches)
                                       : layer.Painter->GetDeclarations(patches)) +
      PatternLayer;
    vtkShaderProgram::Substitute(
      declaration, "CURVE", CurvedTone(layer.Layer->GetTone(), layer.Channel));
    vtkShaderProgram::Substitute(declaration, "BLEND", BlendFunction(layer.Layer->GetBlendMode()));
    const bool surface = layer.Layer->GetColorSource() == vtkPatternLayer::SURFACE;
    const std::string color = layer.Painter->GetInkColor();
    vtkShaderProgram::Substitute(declaration, "INKCOLOR",
      !color.empty() ? color
        : surface    ? "hachureSurfaceHere"
                     : "hachureInk@.rgb");
    vtkShaderProgram::Substitute(declaration, "@", std::to_string(i));
    declarations += declaration;
  }
  return declarations;
}

std::string vtkPatternCompositor::StackText(bool forward) const
{
  std::string calls;
  for (std::size_t i = 0; i < this->Layers.size(); ++i)
  {
    calls += "  color = hachureLayer" + std::to_string(i) + "(color, position, tones);\n";
  }
  const std::string declarations = this->Declarations(forward);
  const bool elsewhere = declarations.find("hachureColorAt") != std::string::npos;
  const vtkPatternAttributes needed = this->GetAttributes();
  std::string text = std::string(Ink) + Mix + Lod + PatternField + SurfacePattern + PatchBlend +
    ToneCurve + ProcessInks + (needed.Runs ? ViewCells : "") + PatternCompose;
  if (forward && this->NeedsFields())
  {
    text.insert(0, std::string(Screens) + NoiseKernel); // fields that are made in the shader
  }
  vtkShaderProgram::Substitute(text, "//Hachure::Patches::Dec",
    needed.Patches ? std::string(PatternPatches) + PatternPatchRecords : std::string());
  vtkShaderProgram::Substitute(text, "//Hachure::Seen::Dec",
    (needed.Has(vtkPatternAttributes::POINT) ? std::string(PatternSeen) : std::string()) +
      (needed.Runs ? PatternRuns : ""));
  vtkShaderProgram::Substitute(text, "//Hachure::ColorAt::Dec",
    elsewhere ? vtkPattern::ShaderSection(PatternColorAt, forward ? "Forward" : "Images")
              : std::string());
  vtkShaderProgram::Substitute(text, "LAYERS", std::to_string(this->Layers.size()));
  vtkShaderProgram::Substitute(text, "PAPER", PaperColor(this->PaperSource));
  vtkShaderProgram::Substitute(text, "//Hachure::Layers::Dec", declarations);
  vtkShaderProgram::Substitute(text, "  //Hachure::Layers::Impl", calls);
  return text;
}

void vtkPatternCompositor::UpdateText(int paperSource)
{
  this->PaperSource = paperSource;
  const std::string declarations = this->Declarations(false);
  const bool colored =
    paperSource == vtkPatternStyle::SURFACE || paperSource == vtkPatternStyle::FLAT;
  this->Colors = colored || declarations.find("hachureColorAt") != std::string::npos ||
    declarations.find("hachureSurfaceHere") != std::string::npos;
  this->ShaderText = this->StackText(false);
}

std::string vtkPatternCompositor::GetShaderText(bool forward) const
{
  return forward ? this->StackText(true) : this->ShaderText;
}

void vtkPatternCompositor::UpdateTables(vtkOpenGLRenderWindow* window)
{
  std::vector<std::pair<vtkPatternLayerPainter*, unsigned long>> state;
  std::vector<float> rows;
  const bool responses = this->GetAttributes().Patches ||
    std::any_of(this->Layers.begin(), this->Layers.end(),
      [](const Drawn& layer) { return layer.Painter->UsesResponses(); });
  for (const Drawn& layer : this->Layers)
  {
    state.emplace_back(layer.Painter, layer.Painter->GetTableVersion());
    const std::vector<float>& own = layer.Painter->GetTableRows();
    rows.insert(rows.end(), own.begin(), own.end());
  }
  if (rows.empty())
  {
    rows.assign(tableTones, 0.0f); // samplers must always have a texture
  }
  this->TableRows = rows.size() / tableTones;
  if (state == this->TableState && responses == this->TableResponses && this->Tables->GetHandle())
  {
    return;
  }
  this->TableResponses = responses;
  this->TableState = state;
  UploadTable(window, this->Tables, 1, rows);
  this->Responses->ReleaseGraphicsResources(window);
  if (responses)
  {
    std::vector<float> inverse = InverseTable(rows);
    UploadTable(window, this->Responses, 2, inverse);
  }
}

void vtkPatternCompositor::SetUniforms(vtkShaderProgram* program, vtkPatternStyle* style,
  const vtkPatternViewport& viewport, const double nanColor[3], const hachure::PatternFrame& frame)
{
  const float map[4] = { static_cast<float>(viewport.FragmentToLogical.x),
    static_cast<float>(viewport.FragmentToLogical.y),
    static_cast<float>(viewport.FragmentToLogical.z),
    static_cast<float>(viewport.FragmentToLogical.w) };
  program->SetUniform4f("hachurePixelMap", map);
  const glm::vec3 paperColor = Linear(style->GetPaperColor());
  if (program->IsUniformUsed("hachurePaper"))
  {
    program->SetUniform3f("hachurePaper", &paperColor.x);
  }
  const glm::vec3 nan = Linear(nanColor);
  program->SetUniform3f("hachureNanColor", &nan.x);
  program->SetUniformi("hachureToneTables", this->Tables->GetTextureUnit());
  if (program->IsUniformUsed("hachureResponses"))
  {
    program->SetUniformi("hachureResponses", this->Responses->GetTextureUnit());
  }
  if (program->IsUniformUsed("hachureTableRows"))
  {
    program->SetUniformf("hachureTableRows", static_cast<float>(this->TableRows));
  }

  this->SetSurfaceUniforms(program, viewport);
  std::size_t row = 0;
  for (std::size_t i = 0; i < this->Layers.size(); ++i)
  {
    const Drawn& drawn = this->Layers[i];
    const std::string number = std::to_string(i);
    const glm::vec3 linear = Linear(drawn.Layer->GetColor());
    const float ink[4] = { linear.x, linear.y, linear.z,
      static_cast<float>(drawn.Layer->GetOpacity()) };
    program->SetUniform4f(("hachureInk" + number).c_str(), ink);
    vtkPatternTone* tone = drawn.Layer->GetTone();
    const float curve[4] = { static_cast<float>(tone->GetGamma()), tone->GetInvert() ? 1.0f : 0.0f,
      static_cast<float>(tone->GetConstant()), static_cast<float>(tone->GetBlackGeneration()) };
    if (program->IsUniformUsed(("hachureCurve" + number).c_str()))
    {
      program->SetUniform4f(("hachureCurve" + number).c_str(), curve);
    }
    const glm::vec3 remap = vtkPattern::ToneRemap(tone);
    if (program->IsUniformUsed(("hachureRemap" + number).c_str()))
    {
      program->SetUniform3f(("hachureRemap" + number).c_str(), &remap.x);
    }
    drawn.Painter->SetUniforms(
      program, number, frame, this->OctaveOf(drawn.Layer, 0), { row, this->TableRows });
    row += drawn.Painter->GetTableRows().size() / tableTones;
  }
  if (this->GetAttributes().Patches)
  {
    program->SetUniformi("hachurePlacements", this->Placements.Texture->GetTextureUnit());
  }
  this->SetPlaceUniforms(program, viewport);
}

void vtkPatternCompositor::SetPlaceUniforms(
  vtkShaderProgram* program, const vtkPatternViewport& viewport)
{
  const glm::dvec3& origin = this->CurrentScene.PatchOrigin;
  if (program->IsUniformUsed("hachurePatchOrigin"))
  {
    const glm::vec3 about(origin);
    program->SetUniform3f("hachurePatchOrigin", &about.x);
  }
  if (program->IsUniformUsed("hachureFragmentToPatches"))
  {
    const std::array<int, 4>& area = viewport.Drawn;
    const glm::dvec3 size(area[2], area[3], 1.0);
    glm::dmat4 toClip = glm::translate(glm::dmat4(1.0), glm::dvec3(-1.0));
    toClip = glm::scale(toClip, 2.0 / size);
    toClip = glm::translate(toClip, glm::dvec3(-area[0], -area[1], 0.0));
    const glm::dmat4 toPatches =
      glm::inverse(glm::translate(this->CurrentScene.ModelToClip, origin));
    const glm::mat4 matrix(toPatches * toClip);
    float values[16];
    std::copy(&matrix[0][0], &matrix[0][0] + 16, values);
    program->SetUniformMatrix4x4("hachureFragmentToPatches", values);
  }
}

const hachure::TimedOctave* vtkPatternCompositor::OctaveOf(
  vtkPatternLayer* layer, std::size_t patch) const
{
  const auto found = this->TimedOctaves.find(layer);
  return found != this->TimedOctaves.end() && patch < found->second.size() ? &found->second[patch]
                                                                           : nullptr;
}

void vtkPatternCompositor::UploadPlacements(const std::vector<hachure::PatternFrame>& frames)
{
  const hachure::PatternFrame still;
  std::vector<glm::vec4> texels;
  for (int patch = 0; patch < this->PatchCount; ++patch)
  {
    const auto index = static_cast<std::size_t>(patch);
    std::size_t row = 0;
    for (const Drawn& drawn : this->Layers)
    {
      const auto placement =
        drawn.Painter->GetPlacement(index < frames.size() ? frames[index] : still,
          this->OctaveOf(drawn.Layer, index), { row, this->TableRows });
      texels.insert(texels.end(), placement.begin(), placement.end());
      row += drawn.Painter->GetTableRows().size() / tableTones;
    }
  }
  if (texels != this->PlacementTexels || !this->Placements.IsUsable())
  {
    this->PlacementTexels = texels;
    this->Placements.Upload(this->Window, texels, 4);
  }
}

void vtkPatternCompositor::SetSurfaceUniforms(
  vtkShaderProgram* program, const vtkPatternViewport& viewport)
{
  if (!this->GetAttributes().Has(vtkPatternAttributes::POINT))
  {
    return;
  }
  const std::pair<const char*, int> rows[] = { { "hachureClipX", 0 }, { "hachureClipY", 1 },
    { "hachureClipW", 3 } };
  for (const auto& row : rows)
  {
    const glm::vec4 values(glm::row(this->CurrentScene.ModelToClip, row.second));
    program->SetUniform4f(row.first, &values.x);
  }
  const float size[2] = { 2.0f / static_cast<float>(viewport.Drawn[2]),
    2.0f / static_cast<float>(viewport.Drawn[3]) };
  program->SetUniform2f("hachureFragmentSize", size);
}

void vtkPatternCompositor::Activate(const std::vector<hachure::PatternFrame>& frames)
{
  this->Tables->Activate();
  if (this->TableResponses)
  {
    this->Responses->Activate();
  }
  if (this->GetAttributes().Patches)
  {
    this->UploadPlacements(frames);
    this->Placements.Texture->Activate();
  }
  for (const Drawn& layer : this->Layers)
  {
    layer.Painter->Activate();
  }
}

void vtkPatternCompositor::Deactivate()
{
  this->Tables->Deactivate();
  if (this->TableResponses)
  {
    this->Responses->Deactivate();
  }
  if (this->GetAttributes().Patches)
  {
    this->Placements.Texture->Deactivate();
  }
  for (const Drawn& layer : this->Layers)
  {
    layer.Painter->Deactivate();
  }
}

void vtkPatternCompositor::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Tables->ReleaseGraphicsResources(window);
  this->Responses->ReleaseGraphicsResources(window);
  this->Placements.Release(window);
  for (auto& painter : this->Painters)
  {
    if (painter.second)
    {
      painter.second->ReleaseGraphicsResources(window);
    }
  }
}
