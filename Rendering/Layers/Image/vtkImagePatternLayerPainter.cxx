// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImagePatternLayerPainter.h"

#include "vtkHachureCompatibility.h"

#include "ImagePatternLayer.h"
#include "Kernels.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImagePatternLayer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"

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
  return ImagePatternLayer;
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
  options.lodBlending = this->Layer->GetMotion() == vtkImagePatternLayer::SIMILARITY;
  const hachure::ToneTableOptions& old = this->Table.options;
  if (this->TableTile == this->Tile && old.lodStart == options.lodStart &&
    old.lodEnd == options.lodEnd && old.lodBlending == options.lodBlending &&
    old.texelsPerPixelAtScale1 == options.texelsPerPixelAtScale1)
  {
    return;
  }
  this->Table = hachure::buildToneTable(*this->Tile, options);
  this->TableTile = this->Tile;
  ++this->TableVersion;
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
  const bool tracked = this->Layer->GetMotion() == vtkImagePatternLayer::SIMILARITY;
  const glm::dvec2 u = tracked ? frame.u : glm::dvec2(1.0, 0.0);
  const glm::dvec2 origin = tracked ? frame.origin : glm::dvec2(0.0);
  const double growth = std::hypot(u.x, u.y);
  const float scale = tracked ? hachure::glsl::wrapScale(static_cast<float>(growth)) : 1.0f;
  const auto lodStart = static_cast<float>(this->Table.options.lodStart);
  const auto lodEnd = static_cast<float>(this->Table.options.lodEnd);
  const float blend = tracked ? hachure::glsl::lodBlend(scale, lodStart, lodEnd) : 0.0f;

  // uv = R(-angle) (position - origin) / size of the tile in logical pixels.
  constexpr double radiansPerDegree = 3.14159265358979323846 / 180.0;
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
  program->SetUniformi(("hachureTile" + number).c_str(), this->Texture->GetTextureUnit());
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
