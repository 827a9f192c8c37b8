// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImagePatternLayerPainter.h"

#include "vtkHachureCompatibility.h"

#include "ImagePatternLayer.h"
#include "ImagePatternTiles.h"
#include "Kernels.h"
#include "Random.h"
#include "SurfacePatternLayer.h"
#include "ToneTableCache.h"
#include "vtkImagePatternLayer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternShaderText.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>

namespace
{
// Tone tables of patterns on the surface. Those of a single octave reach over footprints of 1/2 to
// 2, so that the next one starts at four times the footprint: a texture spans six octaves, up to
// where it turns into grey; a solid texture two, and two more where it is seen obliquely. Tables of
// blended screens are for obliquity 1, 2 and 4, as SurfacePatternLayer.glsl has it.
constexpr int textureBlocks = 3;
constexpr int fadedBlocks = 2;
constexpr int blendedBlocks = 3;
constexpr double singleStep = 4.0;
constexpr double blendedStep = 2.0;
// Pixels of Size that the whole object counts as, where no period on the surface is given.
constexpr double wholeInPixels = 512.0;
constexpr double radiansPerDegree = 3.14159265358979323846 / 180.0;

// How OpenGL names texels of two 16-bit fractions and of four numbers.
struct TexelFormat
{
  int Components;
  int Type;
  int Internal;
  GLenum Layout;
  GLenum Value;
};
constexpr TexelFormat ScreenTexels = { 2, VTK_UNSIGNED_SHORT, GL_RG16, GL_RG, GL_UNSIGNED_SHORT };
constexpr TexelFormat DabTexels = { 4, VTK_FLOAT, GL_RGBA32F, GL_RGBA, GL_FLOAT };

// Every level is made by the caller, so the driver must not compute it.
template <class Number>
void UploadLevels(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  const TexelFormat& format, std::vector<std::vector<Number>>& levels, int width, int height)
{
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->SetWrapS(vtkTextureObject::Repeat);
  texture->SetWrapT(vtkTextureObject::Repeat);
  texture->SetMaxLevel(static_cast<int>(levels.size()) - 1);
  for (std::size_t level = 0; level < levels.size(); ++level)
  {
    const int columns = std::max(1, width >> level);
    const int rows = std::max(1, height >> level);
    if (level == 0)
    {
      texture->Create2DFromRaw(static_cast<unsigned int>(columns), static_cast<unsigned int>(rows),
        format.Components, format.Type, levels[0].data());
      texture->Bind();
    }
    else
    {
      glTexImage2D(GL_TEXTURE_2D, static_cast<int>(level), format.Internal, columns, rows, 0,
        format.Layout, format.Value, levels[level].data());
    }
  }
  texture->SendParameters();
}

std::uint16_t Fraction(float value)
{
  constexpr float largest = 65535.0f;
  return static_cast<std::uint16_t>(std::lround(largest * std::clamp(value, 0.0f, 1.0f)));
}

// Fractions of 16 bits are as exact as a screen needs, and software OpenGL filters them twice as
// fast as floating point numbers.
void UploadScreens(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  const std::vector<hachure::PatternTile>& tiles, bool betweenLevels)
{
  texture->SetMinificationFilter(
    betweenLevels ? vtkTextureObject::LinearMipmapLinear : vtkTextureObject::LinearMipmapNearest);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  std::vector<std::vector<std::uint16_t>> levels;
  for (const hachure::PatternTile& tile : tiles)
  {
    std::vector<std::uint16_t> texels;
    texels.reserve(2 * tile.screen.size());
    for (std::size_t i = 0; i < tile.screen.size(); ++i)
    {
      texels.push_back(Fraction(tile.screen[i]));
      texels.push_back(Fraction(tile.gradient[i] / hachure::glsl::tileGradientRange));
    }
    levels.push_back(std::move(texels));
  }
  UploadLevels(window, texture, ScreenTexels, levels, tiles.front().width, tiles.front().height);
}

// Offset and opacity of the dabs on top, with the height of the paint, or of those below them, with
// a number of its own for every dab on top.
void UploadDabs(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  const std::vector<hachure::PaintTile>& tiles, bool top)
{
  texture->SetMinificationFilter(vtkTextureObject::NearestMipmapNearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  constexpr std::uint32_t brightness = 11; // seed of it
  std::vector<std::vector<float>> levels;
  for (const hachure::PaintTile& tile : tiles)
  {
    const hachure::DabLayer& layer = top ? tile.top : tile.below;
    std::vector<float> texels;
    for (std::size_t i = 0; i < layer.alpha.size(); ++i)
    {
      texels.push_back(layer.offset[2 * i]);
      texels.push_back(layer.offset[2 * i + 1]);
      texels.push_back(layer.alpha[i]);
      const auto dab = static_cast<std::uint64_t>(tile.top.dab[i]);
      texels.push_back(
        top ? tile.height[i] : static_cast<float>(hachure::unitRandom(brightness, dab, 0)));
    }
    levels.push_back(std::move(texels));
  }
  const hachure::PatternTile& first = tiles.front().pattern;
  UploadLevels(window, texture, DabTexels, levels, first.width, first.height);
}
} // namespace

vtkImagePatternLayerPainter::vtkImagePatternLayerPainter(vtkImagePatternLayer* layer)
  : Layer(layer)
{
}

std::string vtkImagePatternLayerPainter::GetDeclarations(bool patches) const
{
  if (this->OnSurface())
  {
    return SurfacePatternLayer;
  }
  const bool several = patches && this->FollowsPatches();
  const double power = this->Layer->GetPatchPower();
  const bool mixes = this->BlendsScreens() && power == 1.0;
  const char* coverage = !several ? "One" : mixes ? "MixedPatches" : "Patches";
  const auto section = [](const std::string& name)
  { return vtkPattern::ShaderSection(ImagePatternLayer, name); };
  std::string text = section("Ink") + section(coverage);
  const std::pair<const char*, bool> parts[] = { { "Paper", this->Paper != nullptr },
    { "Paint", this->Dabs != nullptr } };
  for (const auto& part : parts)
  {
    const std::string name = part.first;
    for (const std::string place : { "Dec", "Impl" })
    {
      std::string tag = "//Hachure::";
      tag.append(name).append("::").append(place);
      vtkShaderProgram::Substitute(text, tag, part.second ? section(name + place) : std::string());
    }
  }
  const hachure::PatternTile& tile = this->Tile->front();
  const std::pair<const char*, double> constants[] = { { "LEVEL",
                                                         this->Tables.front()->options.fixedLevel },
    { "ASPECT", static_cast<double>(tile.width) / tile.height },
    { "PERIOD", static_cast<double>(tile.width) / tile.periods }, { "POWER", power } };
  for (const auto& constant : constants)
  {
    vtkShaderProgram::Substitute(text, constant.first, std::to_string(constant.second));
  }
  return text;
}

std::string vtkImagePatternLayerPainter::GetInkColor() const
{
  return this->Dabs ? "hachurePainted@ / max(coverage, 1.0e-6)" : std::string();
}

bool vtkImagePatternLayerPainter::FollowsPatches() const
{
  return this->Layer && this->Layer->GetMotion() == vtkImagePatternLayer::SIMILARITY;
}

bool vtkImagePatternLayerPainter::OnSurface() const
{
  return this->Layer && this->Layer->GetMotion() >= vtkImagePatternLayer::TEXTURE;
}

vtkPatternLayerPainter::SurfaceNeed vtkImagePatternLayerPainter::GetSurfaceNeed() const
{
  if (!this->OnSurface())
  {
    return NOTHING;
  }
  return this->Layer->GetMotion() == vtkImagePatternLayer::TEXTURE ? POINT_AND_TEXTURE : POINT;
}

std::string vtkImagePatternLayerPainter::GetNote() const
{
  // Fewer grey values than this are seen as steps in what should be a smooth tone.
  constexpr int enoughLevels = 16;
  const int levels = this->Tile ? this->Tile->front().levels : enoughLevels;
  const bool few = this->Layer && this->Layer->GetPattern() == vtkImagePatternLayer::IMAGE &&
    levels < enoughLevels;
  return few ? "the pattern image has only " + std::to_string(levels) +
      " grey levels; tones between them print as flat grey. Expected at least " +
      std::to_string(enoughLevels)
             : std::string();
}

bool vtkImagePatternLayerPainter::Update(
  vtkOpenGLRenderWindow* window, const Scene& scene, std::string& error)
{
  if (!this->Layer || !this->UpdateTile(error))
  {
    return false;
  }
  this->UpdateTable(scene);
  this->Upload(window);
  return true;
}

bool vtkImagePatternLayerPainter::UpdateTile(std::string& error)
{
  if (this->Tile && this->TileTime == this->Layer->GetMTime())
  {
    return true;
  }
  try
  {
    this->Tile = hachure::layerTile(this->Layer);
    this->Dabs = this->OnSurface() ? nullptr : hachure::layerDabs(this->Layer);
    this->Paper = this->OnSurface() ? nullptr : hachure::layerPaper(this->Layer);
  }
  catch (const std::exception& problem)
  {
    error = problem.what();
    return false;
  }
  this->TileTime = this->Layer->GetMTime();
  return true;
}

hachure::LodTransition vtkImagePatternLayerPainter::Transition() const
{
  const int motion = this->Layer->GetMotion();
  if (motion != vtkImagePatternLayer::SIMILARITY && motion != vtkImagePatternLayer::DYNAMIC_SOLID)
  {
    return hachure::LodTransition::none;
  }
  const int set = this->Layer->GetTransition();
  const int pattern = this->Layer->GetPattern();
  const bool screen = pattern == vtkImagePatternLayer::HALFTONE ||
    pattern == vtkImagePatternLayer::STIPPLE || pattern == vtkImagePatternLayer::PAPER;
  const bool lasts =
    motion == vtkImagePatternLayer::SIMILARITY && this->Layer->GetTransitionTime() > 0.0;
  const bool fades = lasts || set == vtkImagePatternLayer::CROSS_FADE ||
    (set == vtkImagePatternLayer::AUTOMATIC_TRANSITION && !screen);
  return fades ? hachure::LodTransition::crossFade : hachure::LodTransition::blendScreens;
}

hachure::ToneCorrection vtkImagePatternLayerPainter::Correction() const
{
  const int set = this->Layer->GetToneCorrection();
  if (set == vtkImagePatternLayer::FULL_CORRECTION)
  {
    return hachure::ToneCorrection::full;
  }
  const bool changes = this->Transition() != hachure::LodTransition::none;
  return set == vtkImagePatternLayer::TRANSITION_ONLY && changes
    ? hachure::ToneCorrection::transitionOnly
    : hachure::ToneCorrection::off;
}

hachure::ToneTableOptions vtkImagePatternLayerPainter::TableOptions() const
{
  const hachure::PatternTile& tile = this->Tile->front();
  hachure::ToneTableOptions options;
  options.texelsPerPixelAtScale1 = tile.width / (tile.periods * this->Period);
  if (this->Layer->GetMotion() == vtkImagePatternLayer::TEXTURE)
  {
    // The size in the picture is known per pixel alone; the last table ends where it turns into
    // grey.
    const double coarsest = tile.width / (tile.periods * double(hachure::glsl::flatPeriod));
    options.texelsPerPixelAtScale1 = 2.0 * coarsest / std::pow(singleStep, textureBlocks);
  }
  if (!this->OnSurface())
  {
    options.fixedLevel =
      hachure::glsl::fixedTileLevel(static_cast<float>(options.texelsPerPixelAtScale1));
  }
  options.lodStart = std::min(this->Layer->GetLodStart(), 1.98);
  options.lodEnd = std::max(this->Layer->GetLodEnd(), options.lodStart + 0.01);
  options.transition = this->Transition();
  options.pace = this->Layer->GetPace() == vtkImagePatternLayer::EVEN ? hachure::LodPace::even
                                                                      : hachure::LodPace::classic;
  options.correction = this->Correction();
  options.referenceTexelsPerPixel = options.texelsPerPixelAtScale1;
  options.seenTexelsPerPixel = options.texelsPerPixelAtScale1 * this->CurrentScene.PixelsPerLogical;
  return options;
}

double vtkImagePatternLayerPainter::InPixels(double length, int unit) const
{
  constexpr double millimetresPerInch = 25.4;
  const double scale = unit == vtkPatternLayer::MILLIMETRES
    ? this->CurrentScene.DotsPerInch / millimetresPerInch
    : 1.0;
  return length * scale * this->CurrentScene.PixelsPerLogical;
}

void vtkImagePatternLayerPainter::SetPaperUniforms(
  vtkShaderProgram* program, const std::string& number)
{
  const hachure::PatternTile& tile = this->Tile->front();
  const hachure::PatternTile& paper = this->Paper->front();
  const double grain = this->InPixels(this->Layer->GetPaperSize(), this->Layer->GetPaperSizeUnit());
  const double tiles = tile.periods * this->Period / (paper.periods * grain);
  program->SetUniformi(("hachurePaper" + number).c_str(), this->PaperTexture->GetTextureUnit());
  const float values[3] = { static_cast<float>(this->Layer->GetPaperContrast()),
    static_cast<float>(tiles), static_cast<float>(tiles * paper.width / tile.width) };
  program->SetUniform3f(("hachureGrain" + number).c_str(), values);
}

void vtkImagePatternLayerPainter::SetPaintUniforms(
  vtkShaderProgram* program, const std::string& number)
{
  program->SetUniformi(("hachureDabs" + number).c_str(), this->DabsOnTop->GetTextureUnit());
  program->SetUniformi(("hachureDabsBelow" + number).c_str(), this->DabsBelow->GetTextureUnit());
  const float values[3] = { static_cast<float>(this->Layer->GetBump()),
    static_cast<float>(this->Layer->GetColorVariation()),
    this->Layer->GetColorSource() == vtkPatternLayer::SURFACE ? 1.0f : 0.0f };
  program->SetUniform3f(("hachurePaint" + number).c_str(), values);
  const double* own = this->Layer->GetColor();
  const glm::vec3 color = hachure::glsl::toLinear(
    glm::vec3(static_cast<float>(own[0]), static_cast<float>(own[1]), static_cast<float>(own[2])));
  program->SetUniform3f(("hachurePaintColor" + number).c_str(), &color.x);
}

void vtkImagePatternLayerPainter::UpdateTable(const Scene& scene)
{
  this->CurrentScene = scene;
  // A tile counts its sparsest strokes; Size is the distance of the densest ones.
  const int pattern = this->Layer->GetPattern();
  const bool strokes =
    pattern == vtkImagePatternLayer::HATCH || pattern == vtkImagePatternLayer::CROSS_HATCH;
  const double sparsest = strokes ? std::exp2(this->Layer->GetDensities() - 1) : 1.0;
  this->Period = sparsest * this->InPixels(this->Layer->GetSize(), this->Layer->GetSizeUnit());

  const hachure::ToneTableOptions options = this->TableOptions();
  int blocks = 1;
  if (this->OnSurface())
  {
    const bool texture = this->Layer->GetMotion() == vtkImagePatternLayer::TEXTURE;
    blocks = texture ? textureBlocks : this->BlendsScreens() ? blendedBlocks : fadedBlocks;
  }
  const bool current = this->TableTile == this->Tile && this->TableBlocks == blocks &&
    this->Tables.front()->options == options;
  if (!current)
  {
    this->BuildTables(options, blocks);
  }
}

void vtkImagePatternLayerPainter::BuildTables(hachure::ToneTableOptions options, int blocks)
{
  // Equal tables are measured once for all windows and mappers that use them.
  static hachure::ToneTableCache shared;
  const double step =
    options.transition == hachure::LodTransition::blendScreens ? blendedStep : singleStep;
  std::vector<std::shared_ptr<const hachure::ToneTable>> tables;
  this->TableRows.clear();
  for (int block = 0; block < blocks; ++block)
  {
    tables.push_back(shared.get(this->Tile, options));
    const std::vector<float>& rows = tables.back()->threshold;
    this->TableRows.insert(this->TableRows.end(), rows.begin(), rows.end());
    options.texelsPerPixelAtScale1 *= step;
  }
  this->Tables = std::move(tables);
  this->TableTile = this->Tile;
  this->TableBlocks = blocks;
  ++this->TableVersion;
}

bool vtkImagePatternLayerPainter::BlendsScreens() const
{
  return this->Transition() == hachure::LodTransition::blendScreens;
}

void vtkImagePatternLayerPainter::Upload(vtkOpenGLRenderWindow* window)
{
  const bool betweenLevels = this->OnSurface();
  if (!this->Texture->GetHandle() || this->UploadedTile != this->Tile ||
    this->UploadedBetweenLevels != betweenLevels)
  {
    UploadScreens(window, this->Texture, *this->Tile, betweenLevels);
    this->UploadedBetweenLevels = betweenLevels;
    this->UploadedTile = this->Tile;
  }
  if (this->Paper && (!this->PaperTexture->GetHandle() || this->UploadedPaper != this->Paper))
  {
    UploadScreens(window, this->PaperTexture, *this->Paper, true);
    this->UploadedPaper = this->Paper;
  }
  if (this->Dabs && (!this->DabsOnTop->GetHandle() || this->UploadedDabs != this->Dabs))
  {
    UploadDabs(window, this->DabsOnTop, *this->Dabs, true);
    UploadDabs(window, this->DabsBelow, *this->Dabs, false);
    this->UploadedDabs = this->Dabs;
  }
}

void vtkImagePatternLayerPainter::SetUniforms(vtkShaderProgram* program, const std::string& number,
  const hachure::PatternFrame& frame, const hachure::TimedOctave* octave, const TablePart& rows)
{
  program->SetUniformi(("hachureTile" + number).c_str(), this->Texture->GetTextureUnit());
  if (this->OnSurface())
  {
    this->SetSurfaceUniforms(program, number, static_cast<double>(rows.First));
    return;
  }
  if (this->Paper)
  {
    this->SetPaperUniforms(program, number);
  }
  if (this->Dabs)
  {
    this->SetPaintUniforms(program, number);
  }
  const float fade[2] = { this->BlendsScreens() ? 0.0f : 1.0f, 0.0f };
  program->SetUniform2f(("hachureFade" + number).c_str(), fade);
  const std::array<glm::vec4, 2> placement = this->GetPlacement(frame, octave, rows);
  const char* const names[] = { "hachureAxis", "hachureOctaves" };
  for (std::size_t i = 0; i < placement.size(); ++i)
  {
    const std::string name = names[i] + number;
    if (program->IsUniformUsed(name.c_str()))
    {
      program->SetUniform4f(name.c_str(), &placement[i].x);
    }
  }
}

std::array<glm::vec4, 2> vtkImagePatternLayerPainter::GetPlacement(
  const hachure::PatternFrame& frame, const hachure::TimedOctave* octave,
  const TablePart& rows) const
{
  const hachure::PatternPlacement placement = this->Place(frame, octave);
  const glm::vec2 row =
    (placement.row + static_cast<float>(rows.First)) / static_cast<float>(rows.RowsOfAll);
  return { glm::vec4(placement.right, placement.up.z),
    glm::vec4(placement.texelsPerPixel, placement.blend, row) };
}

hachure::PatternPlacement vtkImagePatternLayerPainter::Place(
  const hachure::PatternFrame& frame, const hachure::TimedOctave* octave) const
{
  const hachure::PatternTile& tile = this->Tile->front();
  const double width = tile.periods * this->Period / this->CurrentScene.PixelsPerLogical;
  hachure::PlacementOptions options;
  options.tileSize = { width, width * tile.height / tile.width };
  options.angle = this->Layer->GetAngle() * radiansPerDegree;
  options.table = this->Tables.front()->options;
  options.contrast = this->Tables.front()->contrast;
  return hachure::placePattern(frame, options, octave);
}

double vtkImagePatternLayerPainter::ReferencePeriod(double whole) const
{
  const double set = this->Layer->GetSurfacePeriod();
  const double logical = this->Period / this->CurrentScene.PixelsPerLogical;
  return set > 0.0 ? set : logical / wholeInPixels * (whole > 0.0 ? whole : 1.0);
}

void vtkImagePatternLayerPainter::SetSurfaceUniforms(
  vtkShaderProgram* program, const std::string& number, double firstTableRow)
{
  const bool solid = this->Layer->GetMotion() == vtkImagePatternLayer::DYNAMIC_SOLID;
  const hachure::PatternTile& tile = this->Tile->front();
  const double period = this->ReferencePeriod(this->CurrentScene.ModelDiagonal);
  const double width = tile.periods * period;
  const double height = width * tile.height / tile.width;
  const double angle = this->Layer->GetAngle() * radiansPerDegree;
  const float turn[4] = { static_cast<float>(std::cos(angle) / width),
    static_cast<float>(std::sin(angle) / width), static_cast<float>(-std::sin(angle) / height),
    static_cast<float>(std::cos(angle) / height) };
  program->SetUniform4f(("hachureTurn" + number).c_str(), turn);

  // Scale: period * pixels / w, over Size.
  const glm::dmat4& clip = this->CurrentScene.ModelToClip;
  float growth[4] = { 0.0f, 0.0f, 0.0f, 1.0f };
  if (solid)
  {
    const double pixels = this->CurrentScene.PixelsPerModelUnit;
    for (int i = 0; i < 4; ++i)
    {
      growth[i] = static_cast<float>(clip[i].w * this->Period / (period * pixels));
    }
  }
  program->SetUniform4f(("hachureGrowth" + number).c_str(), growth);

  const double ratio = solid ? 0.0 : period / this->ReferencePeriod(1.0);
  const float shape[4] = { static_cast<float>(tile.width), static_cast<float>(tile.height),
    static_cast<float>(tile.width) / static_cast<float>(tile.periods), static_cast<float>(ratio) };
  program->SetUniform4f(("hachureShape" + number).c_str(), shape);
  const hachure::ToneTableOptions& options = this->Tables.front()->options;
  const float octave[4] = { static_cast<float>(options.lodStart),
    static_cast<float>(options.lodEnd), static_cast<float>(firstTableRow),
    static_cast<float>(options.texelsPerPixelAtScale1) };
  program->SetUniform4f(("hachureOctave" + number).c_str(), octave);
  const float kind[3] = { solid ? 1.0f : 0.0f,
    this->BlendsScreens() ? 0.0f : static_cast<float>(this->TableBlocks),
    this->Tables.front()->contrast };
  program->SetUniform3f(("hachureKind" + number).c_str(), kind);
}

std::vector<vtkTextureObject*> vtkImagePatternLayerPainter::UsedTextures()
{
  std::vector<vtkTextureObject*> textures = { this->Texture };
  if (this->Paper)
  {
    textures.push_back(this->PaperTexture);
  }
  if (this->Dabs)
  {
    textures.push_back(this->DabsOnTop);
    textures.push_back(this->DabsBelow);
  }
  return textures;
}

void vtkImagePatternLayerPainter::Activate()
{
  for (vtkTextureObject* texture : this->UsedTextures())
  {
    texture->Activate();
  }
}

void vtkImagePatternLayerPainter::Deactivate()
{
  for (vtkTextureObject* texture : this->UsedTextures())
  {
    texture->Deactivate();
  }
}

void vtkImagePatternLayerPainter::ReleaseGraphicsResources(vtkWindow* window)
{
  vtkTextureObject* const textures[] = { this->Texture, this->PaperTexture, this->DabsOnTop,
    this->DabsBelow };
  for (vtkTextureObject* texture : textures)
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->UploadedTile = nullptr;
  this->UploadedPaper = nullptr;
  this->UploadedDabs = nullptr;
}
