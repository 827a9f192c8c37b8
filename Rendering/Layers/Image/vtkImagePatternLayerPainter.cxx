// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImagePatternLayerPainter.h"

#include "vtkHachureCompatibility.h"

#include "ImagePatternLayer.h"
#include "Kernels.h"
#include "SurfacePatternLayer.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImagePatternLayer.h"
#include "vtkOpenGLRenderWindow.h"
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

// Tone tables of patterns on the surface, one per octave: as SurfacePatternLayer.glsl has it.
constexpr int textureBlocks = 5;
constexpr int solidBlocks = 3;
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

const char* vtkImagePatternLayerPainter::GetDeclarations() const
{
  return this->OnSurface() ? SurfacePatternLayer : ImagePatternLayer;
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

  const hachure::PatternTile& tile = this->Tile->front();
  hachure::ToneTableOptions options;
  options.texelsPerPixelAtScale1 = tile.width / (tile.periods * this->Period);
  options.lodStart = std::min(this->Layer->GetLodStart(), 1.98);
  options.lodEnd = std::max(this->Layer->GetLodEnd(), options.lodStart + 0.01);
  const int motion = this->Layer->GetMotion();
  options.lodBlending =
    motion == vtkImagePatternLayer::SIMILARITY || motion == vtkImagePatternLayer::DYNAMIC_SOLID;
  int blocks = 1;
  if (motion == vtkImagePatternLayer::TEXTURE)
  {
    // From where it turns into grey: the size in the picture is known per pixel alone.
    options.texelsPerPixelAtScale1 =
      tile.width / (tile.periods * double(hachure::glsl::flatPeriod));
    blocks = textureBlocks;
  }
  else if (motion == vtkImagePatternLayer::DYNAMIC_SOLID)
  {
    blocks = solidBlocks;
  }
  const hachure::ToneTableOptions& old = this->Table.options;
  if (this->TableTile == this->Tile && this->TableBlocks == blocks &&
    old.lodStart == options.lodStart && old.lodEnd == options.lodEnd &&
    old.lodBlending == options.lodBlending &&
    old.texelsPerPixelAtScale1 == options.texelsPerPixelAtScale1)
  {
    return;
  }
  this->Table = hachure::buildToneTable(*this->Tile, options);
  this->BuildTables(blocks);
  this->TableTile = this->Tile;
  ++this->TableVersion;
}

void vtkImagePatternLayerPainter::BuildTables(int blocks)
{
  this->TableBlocks = blocks;
  this->TableRows = this->Table.threshold;
  hachure::ToneTableOptions options = this->Table.options;
  // A texture comes nearer from block to block, a solid texture is seen more obliquely.
  const double step = options.lodBlending ? 2.0 : 0.5;
  for (int block = 1; block < blocks; ++block)
  {
    options.texelsPerPixelAtScale1 *= step;
    const hachure::ToneTable next = hachure::buildToneTable(*this->Tile, options);
    this->TableRows.insert(this->TableRows.end(), next.threshold.begin(), next.threshold.end());
  }
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
  const bool tracked = this->Layer->GetMotion() == vtkImagePatternLayer::SIMILARITY;
  const glm::dvec2 u = tracked ? frame.u : glm::dvec2(1.0, 0.0);
  const glm::dvec2 origin = tracked ? frame.origin : glm::dvec2(0.0);
  const double growth = std::hypot(u.x, u.y);
  const float scale = tracked ? hachure::glsl::wrapScale(static_cast<float>(growth)) : 1.0f;
  const auto lodStart = static_cast<float>(this->Table.options.lodStart);
  const auto lodEnd = static_cast<float>(this->Table.options.lodEnd);
  const float blend = tracked ? hachure::glsl::lodBlend(scale, lodStart, lodEnd) : 0.0f;

  // uv = R(-angle) (position - origin) / size of the tile in logical pixels.
  const double angle = std::atan2(u.y, u.x) + this->Layer->GetAngle() * radiansPerDegree;
  const hachure::PatternTile& tile = this->Tile->front();
  const double width = scale * tile.periods * this->Period / this->CurrentScene.PixelsPerLogical;
  const double height = width * tile.height / tile.width;
  const glm::dvec2 right = glm::dvec2(std::cos(angle), std::sin(angle)) / width;
  const glm::dvec2 up = glm::dvec2(-std::sin(angle), std::cos(angle)) / height;
  double offset[2] = { -(right.x * origin.x + right.y * origin.y),
    -(up.x * origin.x + up.y * origin.y) };
  for (double& component : offset)
  {
    component -= std::floor(component); // whole tiles change nothing but cost digits
  }
  float uv[3][3] = { { static_cast<float>(right.x), static_cast<float>(up.x), 0.0f },
    { static_cast<float>(right.y), static_cast<float>(up.y), 0.0f },
    { static_cast<float>(offset[0]), static_cast<float>(offset[1]), 1.0f } };
  program->SetUniformMatrix3x3(("hachureUv" + number).c_str(), &uv[0][0]);

  const float texels = static_cast<float>(this->Table.options.texelsPerPixelAtScale1) / scale;
  const float row = hachure::glsl::tableRow(scale, lodStart, lodEnd) * hachure::glsl::tableSteps;
  const float octave[4] = { texels, blend,
    hachure::glsl::flatShare(scale, blend, static_cast<float>(this->Period)),
    static_cast<float>(firstTableRow) + row };
  program->SetUniform4f(("hachureOctave" + number).c_str(), octave);
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
  const hachure::ToneTableOptions& options = this->Table.options;
  const float octave[4] = { static_cast<float>(options.lodStart),
    static_cast<float>(options.lodEnd), static_cast<float>(firstTableRow),
    static_cast<float>(options.texelsPerPixelAtScale1) };
  program->SetUniform4f(("hachureOctave" + number).c_str(), octave);
  program->SetUniformf(("hachureSolid" + number).c_str(), solid ? 1.0f : 0.0f);
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
