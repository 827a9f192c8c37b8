// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoiseKernelBuffers.h"

#include "vtkHachureCompatibility.h"

#include "Ink.h"
#include "Lod.h"
#include "NoiseFieldTiles.h"
#include "NoiseKernel.h"
#include "NoiseSums.h"
#include "NoiseTileLists.h"
#include "PatternField.h"
#include "Screens.h"
#include "vtkPatternShaderText.h"
#include "vtkShaderProgram.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
using hachure::NoiseKind;
using Stage = vtkNoiseKernelBuffers::Stage;

// Whole numbers are exact in floating point up to here.
constexpr std::size_t mostExact = std::size_t{ 1 } << 24;
constexpr std::size_t texelsPerKernel = 4;

bool Fits(std::size_t texels)
{
  int most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  return texels <= std::min(static_cast<std::size_t>(std::max(most, 0)), mostExact);
}

// Whether the ids of a kernel are told apart from all others.
bool IsExact(const hachure::NoiseKernel& kernel)
{
  constexpr auto most = static_cast<std::int32_t>(mostExact);
  return kernel.object < most && kernel.triangle < most;
}

std::vector<glm::vec4> Packed(hachure::Span<const hachure::NoiseKernel> kernels)
{
  std::vector<glm::vec4> texels;
  texels.reserve(texelsPerKernel * kernels.size() + 1);
  for (const hachure::NoiseKernel& kernel : kernels)
  {
    texels.emplace_back(kernel.center, kernel.bandwidth, kernel.weight);
    texels.emplace_back(
      std::cos(kernel.orientation), std::sin(kernel.orientation), kernel.frequency, kernel.phase);
    texels.emplace_back(kernel.depth, kernel.depthSlope, hachure::noiseRadius(kernel.bandwidth));
    texels.emplace_back(
      static_cast<float>(kernel.object), static_cast<float>(kernel.triangle), 0.0f, 0.0f);
  }
  if (texels.empty())
  {
    texels.emplace_back(0.0f); // samplers must always have a texture
  }
  return texels;
}

std::vector<hachure::NoiseKernel> Drawable(hachure::Span<const hachure::NoiseKernel> kernels)
{
  std::vector<hachure::NoiseKernel> result;
  result.reserve(kernels.size());
  std::copy_if(
    kernels.begin(), kernels.end(), std::back_inserter(result), hachure::noise::isDrawable);
  return result;
}

// Where each tile's list begins and ends, counted in this buffer, and the lists.
std::vector<float> ListNumbers(const hachure::NoiseTileLists& lists)
{
  std::vector<float> numbers;
  const std::size_t first = lists.starts.size();
  numbers.reserve(first + lists.kernels.size());
  for (const std::uint32_t start : lists.starts)
  {
    numbers.push_back(static_cast<float>(first + start));
  }
  for (const std::uint32_t kernel : lists.kernels)
  {
    numbers.push_back(static_cast<float>(kernel));
  }
  return numbers;
}

std::string Section(const char* name)
{
  return vtkPattern::ShaderSection(NoiseSums, name);
}

std::string TermText(NoiseKind kind)
{
  const char* const name = kind == NoiseKind::gabor ? "Gabor"
    : kind == NoiseKind::phasor                     ? "Phasor"
                                                    : "Spot";
  return Section(name) + Section("Adding");
}

std::string FieldText(NoiseKind kind)
{
  return Section(kind == NoiseKind::phasor ? "Phase" : "Table");
}

std::string StageText(Stage stage, NoiseKind kind)
{
  const std::string start =
    Section("Kernels") + (kind == NoiseKind::phasor ? std::string() : Section("Numbers"));
  switch (stage)
  {
    case Stage::Share:
      return start + Section("Seen");
    case Stage::Gather:
      return start + Section("Shares") + TermText(kind) + Section("Lists") + Section("Sum") +
        Section("Seen");
    case Stage::Compute:
      return start + Section("Shares") + TermText(kind) + Section("Lists") + Section("Seen");
    case Stage::SplatVertices:
      return start + Section("Shares");
    case Stage::Splat:
      return start + Section("Shares") + TermText(kind) + Section("Seen");
    case Stage::Finish:
      return start + FieldText(kind) + Section("Seen");
    default:
      return start + Section("NoShares") + TermText(kind) + Section("Lists") + Section("Sum") +
        FieldText(kind);
  }
}
} // namespace

std::string vtkNoiseKernelBuffers::Text(const char* shader, Stage stage, NoiseKind kind)
{
  std::string sums = StageText(stage, kind);
  if (stage != Stage::Forward)
  {
    sums = std::string(Screens) + Ink + Lod + NoiseKernel + PatternField + sums;
  }
  std::string text = shader;
  vtkShaderProgram::Substitute(text, "//Hachure::NoiseSums::Dec", sums);
  vtkShaderProgram::Substitute(text, "NOISEROW", std::to_string(SharesPerRow));
  if (stage != Stage::Forward)
  {
    vtkShaderProgram::Substitute(text, "@", "");
  }
  return text;
}

bool vtkNoiseKernelBuffers::Upload(vtkOpenGLRenderWindow* window, const Content& content)
{
  const std::vector<hachure::NoiseKernel> kernels = Drawable(content.Kernels);
  const hachure::NoiseTileLists lists = hachure::noiseTileLists(kernels, content.Rectangle);
  const bool ids = content.ObjectTest || content.TriangleTest;
  if (!Fits(texelsPerKernel * kernels.size()) ||
    !Fits(lists.starts.size() + lists.kernels.size()) ||
    (ids && !std::all_of(kernels.begin(), kernels.end(), IsExact)))
  {
    return false;
  }
  this->Count = static_cast<int>(kernels.size());
  this->Kernels.Upload(window, Packed(kernels), 4);
  this->Lists.Upload(window, ListNumbers(lists), 1);
  this->UploadNumbers(window, content.Field);
  this->SetValues(content,
    { static_cast<float>(lists.tileSize), static_cast<float>(lists.columns),
      static_cast<float>(lists.rows), 0.0f });
  return this->Kernels.IsUsable() && this->Lists.IsUsable() && this->Numbers.IsUsable();
}

void vtkNoiseKernelBuffers::UploadNumbers(
  vtkOpenGLRenderWindow* window, const hachure::NoiseFieldOptions& field)
{
  std::vector<float> numbers(1, 0.0f);
  const auto least = static_cast<float>(field.smoothness);
  this->Table = { 1.0f, 0.0f, 1.0f, least };
  if (field.kind != NoiseKind::phasor)
  {
    const auto distribution = hachure::noiseDistribution(field.overlap);
    numbers = distribution->share;
    this->Table = { static_cast<float>(distribution->range), static_cast<float>(numbers.size() - 1),
      hachure::noise::lowestVariance(field), least };
    numbers.push_back(numbers.back()); // beside the last one
  }
  if (field.kind == NoiseKind::spot)
  {
    const hachure::noise::SpotTexels spot(*field.spot);
    this->Spot = { static_cast<float>(spot.width), static_cast<float>(spot.height),
      static_cast<float>(numbers.size()), 0.0f };
    numbers.insert(numbers.end(), spot.values.begin(), spot.values.end());
  }
  if (numbers != this->NumbersHeld || !this->Numbers.IsUsable())
  {
    this->Numbers.Upload(window, numbers, 1);
    this->NumbersHeld = std::move(numbers);
  }
}

void vtkNoiseKernelBuffers::SetValues(const Content& content, const std::array<float, 4>& tiles)
{
  const auto flag = [](bool value) { return value ? 1.0f : 0.0f; };
  std::array<float, 4> rectangle{};
  std::copy(content.Rectangle.begin(), content.Rectangle.end(), rectangle.begin());
  this->Values = { { "hachureNoiseRectangle", rectangle }, { "hachureNoiseTiles", tiles },
    { "hachureNoiseTests",
      { flag(content.DepthTest), flag(content.PartialVisibility), flag(content.ObjectTest),
        flag(content.TriangleTest) } },
    { "hachureNoiseShape",
      { content.DepthTolerance, static_cast<float>(this->Count), 0.0f, 0.0f } },
    { "hachureNoiseTable", this->Table }, { "hachureNoiseSpot", this->Spot } };
}

std::vector<std::pair<std::string, vtkTextureObject*>> vtkNoiseKernelBuffers::Textures() const
{
  return { { "hachureNoiseKernels", this->Kernels.Texture },
    { "hachureNoiseLists", this->Lists.Texture },
    { "hachureNoiseNumbers", this->Numbers.Texture } };
}

void vtkNoiseKernelBuffers::SetUniforms(vtkShaderProgram* program, const std::string& number) const
{
  for (const auto& uniform : this->Values)
  {
    const std::string name = uniform.first + number;
    if (program->IsUniformUsed(name.c_str()))
    {
      program->SetUniform4f(name.c_str(), uniform.second.data());
    }
  }
  for (const auto& texture : this->Textures())
  {
    const std::string name = texture.first + number;
    if (texture.second && program->IsUniformUsed(name.c_str()))
    {
      program->SetUniformi(name.c_str(), texture.second->GetTextureUnit());
    }
  }
}

void vtkNoiseKernelBuffers::Activate()
{
  for (const auto& texture : this->Textures())
  {
    texture.second->Activate();
  }
}

void vtkNoiseKernelBuffers::Deactivate()
{
  for (const auto& texture : this->Textures())
  {
    texture.second->Deactivate();
  }
}

void vtkNoiseKernelBuffers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Kernels.Release(window);
  this->Lists.Release(window);
  this->Numbers.Release(window);
}
