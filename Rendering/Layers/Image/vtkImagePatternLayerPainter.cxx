// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImagePatternLayerPainter.h"

#include "vtkHachureCompatibility.h"

#include "ImagePatternLayer.h"
#include "Kernels.h"
#include "SurfacePatternLayer.h"
#include "ToneTableCache.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImagePatternLayer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternShaderText.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <mutex>
#include <stdexcept>
#include <tuple>

namespace
{
using TileKey = std::tuple<int, double, unsigned int>; // pattern, irregularity, seed
using Mips = std::shared_ptr<const std::vector<hachure::PatternTile>>;

// Texels and periods of the built-in tiles: enough periods that a loose hand does not repeat
// itself visibly, 32 texels a period.
constexpr int tileSize = 512;
constexpr int tilePeriods = 16;
constexpr int ruledSize = 256;
constexpr int ruledPeriods = 8;

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

Mips MakeTile(const TileKey& key)
{
  hachure::CrossHatchOptions options;
  options.irregularity = std::get<1>(key);
  options.seed = std::get<2>(key);
  const bool ruled = options.irregularity <= 0.0;
  options.size = ruled ? ruledSize : tileSize;
  options.periods = ruled ? ruledPeriods : tilePeriods;
  hachure::PatternTile tile;
  switch (std::get<0>(key))
  {
    case vtkImagePatternLayer::CROSS_HATCH:
      tile = hachure::crossHatchTile(options);
      break;
    case vtkImagePatternLayer::HALFTONE:
      tile = hachure::halftoneTile(options);
      break;
    default:
      tile = hachure::hatchTile(options);
  }
  return std::make_shared<const std::vector<hachure::PatternTile>>(hachure::mipChain(tile));
}

// Equal tiles are made once and shared by all windows and mappers that use them.
Mips SharedTile(const TileKey& key)
{
  static std::mutex mutex;
  static std::map<TileKey, std::weak_ptr<const std::vector<hachure::PatternTile>>> tiles;
  const std::lock_guard<std::mutex> lock(mutex);
  Mips tile = tiles[key].lock();
  if (!tile)
  {
    tile = MakeTile(key);
    tiles[key] = tile;
  }
  return tile;
}

// Mean of the colour components of the user's image, dark = inked first.
Mips ImageTile(vtkImageData* image)
{
  int size[3];
  image->GetDimensions(size);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || size[0] < 1 || size[1] < 1 || size[2] != 1)
  {
    throw std::invalid_argument("image: expected a 2D image with scalars");
  }
  const int components = scalars->GetNumberOfComponents();
  const int colors = components == 2 || components == 4 ? components - 1 : components;
  std::vector<float> grey(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]));
  for (std::size_t i = 0; i < grey.size(); ++i)
  {
    double sum = 0.0;
    for (int c = 0; c < colors; ++c)
    {
      sum += scalars->GetComponent(static_cast<vtkIdType>(i), c);
    }
    grey[i] = static_cast<float>(sum / colors);
  }
  return std::make_shared<const std::vector<hachure::PatternTile>>(
    hachure::mipChain(hachure::imageTile(grey, size[0], size[1])));
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
  const char* coverage = !several ? "One" : this->BlendsScreens() ? "MixedPatches" : "Patches";
  return vtkPattern::ShaderSection(ImagePatternLayer, "Ink") +
    vtkPattern::ShaderSection(ImagePatternLayer, coverage);
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
    if (this->Layer->GetPattern() == vtkImagePatternLayer::IMAGE)
    {
      if (!this->Layer->GetImage())
      {
        throw std::invalid_argument("image: expected an image for the pattern IMAGE, found none");
      }
      this->Tile = ImageTile(this->Layer->GetImage());
    }
    else
    {
      this->Tile = SharedTile(
        TileKey(this->Layer->GetPattern(), this->Layer->GetIrregularity(), this->Layer->GetSeed()));
    }
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
  const bool strokes =
    pattern == vtkImagePatternLayer::HATCH || pattern == vtkImagePatternLayer::CROSS_HATCH;
  const bool fades = set == vtkImagePatternLayer::CROSS_FADE ||
    (set == vtkImagePatternLayer::AUTOMATIC_TRANSITION && strokes);
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
  options.lodStart = std::min(this->Layer->GetLodStart(), 1.98);
  options.lodEnd = std::max(this->Layer->GetLodEnd(), options.lodStart + 0.01);
  options.transition = this->Transition();
  options.correction = this->Correction();
  options.referenceTexelsPerPixel = options.texelsPerPixelAtScale1;
  return options;
}

void vtkImagePatternLayerPainter::UpdateTable(const Scene& scene)
{
  this->CurrentScene = scene;
  constexpr double millimetresPerInch = 25.4;
  double size = this->Layer->GetSize();
  if (this->Layer->GetSizeUnit() == vtkPatternLayer::MILLIMETRES)
  {
    size *= scene.DotsPerInch / millimetresPerInch;
  }
  this->Period = size * scene.PixelsPerLogical;

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
  if (this->Texture->GetHandle() && this->UploadedTile == this->Tile)
  {
    return;
  }
  this->Texture->ReleaseGraphicsResources(window);
  this->Texture->SetContext(window);
  this->Texture->SetWrapS(vtkTextureObject::Repeat);
  this->Texture->SetWrapT(vtkTextureObject::Repeat);
  this->Texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMaxLevel(static_cast<int>(this->Tile->size()) - 1);
  std::vector<float> texels;
  int level = 0;
  for (const hachure::PatternTile& tile : *this->Tile)
  {
    texels.resize(2 * tile.screen.size());
    for (std::size_t i = 0; i < tile.screen.size(); ++i)
    {
      texels[2 * i] = tile.screen[i];
      texels[2 * i + 1] = tile.gradient[i];
    }
    if (level == 0)
    {
      this->Texture->Create2DFromRaw(static_cast<unsigned int>(tile.width),
        static_cast<unsigned int>(tile.height), 2, VTK_FLOAT, texels.data());
      this->Texture->Bind();
    }
    else
    {
      // Every level is made uniform by itself, so the driver must not compute it.
      glTexImage2D(
        GL_TEXTURE_2D, level, GL_RG32F, tile.width, tile.height, 0, GL_RG, GL_FLOAT, texels.data());
    }
    ++level;
  }
  this->Texture->SendParameters();
  this->UploadedTile = this->Tile;
}

void vtkImagePatternLayerPainter::SetUniforms(vtkShaderProgram* program, const std::string& number,
  const hachure::PatternFrame& frame, double firstTableRow)
{
  program->SetUniformi(("hachureTile" + number).c_str(), this->Texture->GetTextureUnit());
  if (this->OnSurface())
  {
    this->SetSurfaceUniforms(program, number, firstTableRow);
    return;
  }
  program->SetUniformf(("hachureFade" + number).c_str(), this->BlendsScreens() ? 0.0f : 1.0f);
  const std::array<glm::vec4, 3> placement = this->GetPlacement(frame, firstTableRow);
  const char* const names[] = { "hachureRight", "hachureUp", "hachureOctaves" };
  for (std::size_t i = 0; i < placement.size(); ++i)
  {
    const std::string name = names[i] + number;
    if (program->IsUniformUsed(name.c_str()))
    {
      program->SetUniform4f(name.c_str(), &placement[i].x);
    }
  }
}

std::array<glm::vec4, 3> vtkImagePatternLayerPainter::GetPlacement(
  const hachure::PatternFrame& frame, double firstTableRow) const
{
  const hachure::PatternPlacement placement = this->Place(frame);
  const auto firstRow = static_cast<float>(firstTableRow);
  return { glm::vec4(placement.right, placement.texelsPerPixel),
    glm::vec4(placement.up, placement.blend), glm::vec4(placement.flat, placement.row + firstRow) };
}

hachure::PatternPlacement vtkImagePatternLayerPainter::Place(
  const hachure::PatternFrame& frame) const
{
  const hachure::PatternTile& tile = this->Tile->front();
  const double width = tile.periods * this->Period / this->CurrentScene.PixelsPerLogical;
  hachure::PlacementOptions options;
  options.tileSize = { width, width * tile.height / tile.width };
  options.angle = this->Layer->GetAngle() * radiansPerDegree;
  options.pixelsPerPeriod = this->Period;
  options.table = this->Tables.front()->options;
  return hachure::placePattern(frame, options);
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
  const float kind[2] = { solid ? 1.0f : 0.0f,
    this->BlendsScreens() ? 0.0f : static_cast<float>(this->TableBlocks) };
  program->SetUniform2f(("hachureKind" + number).c_str(), kind);
}

void vtkImagePatternLayerPainter::Activate()
{
  this->Texture->Activate();
}

void vtkImagePatternLayerPainter::Deactivate()
{
  this->Texture->Deactivate();
}

void vtkImagePatternLayerPainter::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->UploadedTile = nullptr;
}
