// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewTextureBuffers.h"

#include "Kernels.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <stdexcept>

namespace
{
constexpr int texelsOfRecord = 2;
constexpr int texelsOfFrame = 3;
constexpr int components = 4;

std::vector<glm::vec4> RecordTexels(const hachure::TriangleRuns& runs,
  const hachure::SurfaceCells& cells, const hachure::SurfaceFrames& frames)
{
  std::vector<glm::vec4> texels;
  texels.reserve(texelsOfRecord * runs.triangles.size());
  for (std::size_t record = 0; record < runs.triangles.size(); ++record)
  {
    const auto triangle = static_cast<std::size_t>(runs.triangles[record]);
    const glm::vec3 corners = glm::max(frames.corners[triangle], glm::ivec3(0));
    const auto& places = cells.places[triangle];
    texels.emplace_back(corners, static_cast<float>(runs.goesOn[record]));
    texels.emplace_back(hachure::glsl::packedPlace(places[0]),
      hachure::glsl::packedPlace(places[1]), hachure::glsl::packedPlace(places[2]),
      static_cast<float>(cells.chartOfTriangle[triangle]));
  }
  return texels;
}

std::vector<glm::vec4> ChartTexels(
  const hachure::SurfaceCells& cells, const hachure::SurfaceFrames& frames)
{
  std::vector<glm::vec4> texels;
  texels.reserve(texelsOfRecord * cells.charts.size());
  for (std::size_t i = 0; i < cells.charts.size(); ++i)
  {
    const hachure::CellChart& chart = cells.charts[i];
    texels.emplace_back(static_cast<float>(chart.neighbours[0]),
      static_cast<float>(chart.neighbours[1]), static_cast<float>(chart.neighbours[2]),
      static_cast<float>(chart.level));
    const int above = std::max(chart.level, -1) + 1; // a level that is divided
    const std::int64_t divided = hachure::firstNodeOf(cells, i, above) -
      hachure::glsl::chartNodesBelow(hachure::subdivisionsOf(chart, above));
    texels.emplace_back(static_cast<float>(cells.firstNode[i]), static_cast<float>(divided),
      static_cast<float>(frames.chartsDown[i]), 0.0f);
  }
  return texels;
}

// Creates a texture of columns * size texels a row from colours in squares of size * size.
void UploadSquares(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  const std::vector<glm::u8vec4>& colors, int size, int columns)
{
  const auto side = static_cast<std::size_t>(size);
  const auto width = side * static_cast<std::size_t>(columns);
  const std::size_t squares = colors.size() / (side * side);
  const std::size_t rows = (squares + static_cast<std::size_t>(columns) - 1) / columns;
  std::vector<glm::u8vec4> texels(width * side * rows, glm::u8vec4(0));
  for (std::size_t square = 0; square < squares; ++square)
  {
    const std::size_t column = square % static_cast<std::size_t>(columns);
    const std::size_t row = square / static_cast<std::size_t>(columns);
    for (std::size_t y = 0; y < side; ++y)
    {
      std::copy_n(colors.begin() + static_cast<std::ptrdiff_t>(side * (side * square + y)), side,
        texels.begin() + static_cast<std::ptrdiff_t>(width * (side * row + y) + side * column));
    }
  }
  texture->SetContext(window);
  texture->SetUseSRGBColorSpace(true);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  const int filter = size > 1 ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  texture->SetMinificationFilter(filter);
  texture->SetMagnificationFilter(filter);
  if (!texture->Create2DFromRaw(static_cast<unsigned int>(width),
        static_cast<unsigned int>(side * rows), components, VTK_UNSIGNED_CHAR, texels.data()))
  {
    throw std::runtime_error("the window cannot hold the colours of the surface's cells");
  }
}

// Squares of one row: as many as make the image about square, in steps so that it seldom changes.
int ColumnsOf(std::size_t squares)
{
  int columns = 1;
  while (static_cast<std::size_t>(columns) * static_cast<std::size_t>(columns) < squares)
  {
    columns *= 2;
  }
  return columns;
}
} // namespace

void ViewTextureBuffers::UploadCells(vtkOpenGLRenderWindow* window,
  const hachure::TriangleRuns& runs, const hachure::SurfaceCells& cells,
  const hachure::SurfaceFrames& frames)
{
  constexpr std::size_t mostWholeNumbers = std::size_t{ 1 } << 24; // of a float
  if (runs.triangles.size() > mostWholeNumbers ||
    static_cast<std::size_t>(cells.firstNode.back()) > mostWholeNumbers)
  {
    throw std::runtime_error("the surface has " + std::to_string(runs.triangles.size()) +
      " triangles and " + std::to_string(cells.firstNode.back()) +
      " nodes of cells; expected at most " + std::to_string(mostWholeNumbers));
  }
  this->Triangles.Upload(window, RecordTexels(runs, cells, frames), components);
  this->Charts.Upload(window, ChartTexels(cells, frames), components);
}

void ViewTextureBuffers::UploadFrames(vtkOpenGLRenderWindow* window,
  const hachure::SurfaceFrames& frames, hachure::Span<const glm::dvec3> positions,
  const glm::dvec3& origin)
{
  std::vector<glm::vec4> texels;
  texels.reserve(texelsOfFrame * frames.turns.size());
  for (std::size_t i = 0; i < frames.turns.size(); ++i)
  {
    const glm::dvec3 place = positions[static_cast<std::size_t>(frames.points[i])] - origin;
    texels.emplace_back(glm::vec3(place), 0.0f);
    for (const glm::quat& turn : { frames.turns[i], frames.otherTurns[i] })
    {
      texels.emplace_back(turn.x, turn.y, turn.z, turn.w);
    }
  }
  this->Frames.Upload(window, texels, components);
}

void ViewTextureBuffers::UploadColors(
  vtkOpenGLRenderWindow* window, const hachure::ViewTextureColors& colors)
{
  const std::vector<glm::u8vec4> nothing(1, glm::u8vec4(0));
  const std::vector<glm::u8vec4>& independent =
    colors.independent.empty() ? nothing : colors.independent;
  const int columns = ColumnsOf(independent.size());
  UploadSquares(window, this->Independent, independent, 1, columns);
  const auto side = static_cast<std::size_t>(colors.hemisphere);
  const std::vector<glm::u8vec4> noSquare(side * side, glm::u8vec4(0));
  const std::vector<glm::u8vec4>& dependent =
    colors.dependent.empty() ? noSquare : colors.dependent;
  const std::size_t squares = dependent.size() / (side * side);
  const int squareColumns = ColumnsOf(squares);
  UploadSquares(window, this->Dependent, dependent, colors.hemisphere, squareColumns);
  const std::size_t rows = (squares + static_cast<std::size_t>(squareColumns) - 1) / squareColumns;
  this->Images = { static_cast<float>(squareColumns), static_cast<float>(columns),
    1.0f / static_cast<float>(rows) };
}

void ViewTextureBuffers::UploadNothing(vtkOpenGLRenderWindow* window)
{
  // One triangle of no chart.
  const std::vector<glm::vec4> record = { glm::vec4(0.0f), { 0.0f, 0.0f, 0.0f, -1.0f } };
  this->Triangles.Upload(window, record, components);
  this->Frames.Upload(window, std::vector<glm::vec4>(texelsOfFrame, glm::vec4(0.0f)), components);
  this->Charts.Upload(window, std::vector<glm::vec4>(2, glm::vec4(0.0f)), components);
  this->UploadColors(window, {});
}

bool ViewTextureBuffers::IsUsable() const
{
  return this->Triangles.IsUsable() && this->Frames.IsUsable() && this->Charts.IsUsable() &&
    this->Dependent->GetHandle() && this->Independent->GetHandle();
}

void ViewTextureBuffers::SetUniforms(vtkShaderProgram* program, const std::string& number) const
{
  const std::pair<const char*, vtkTextureObject*> textures[] = { { "hachureCellTriangles",
                                                                   this->Triangles.Texture },
    { "hachureCellFrames", this->Frames.Texture }, { "hachureCellCharts", this->Charts.Texture },
    { "hachureDependent", this->Dependent }, { "hachureIndependent", this->Independent } };
  for (const auto& texture : textures)
  {
    const std::string name = texture.first + number;
    if (program->IsUniformUsed(name.c_str()))
    {
      program->SetUniformi(name.c_str(), texture.second->GetTextureUnit());
    }
  }
  program->SetUniform3f(("hachureNodeImages" + number).c_str(), &this->Images.x);
}

void ViewTextureBuffers::Activate()
{
  this->Triangles.Texture->Activate();
  this->Frames.Texture->Activate();
  this->Charts.Texture->Activate();
  this->Dependent->Activate();
  this->Independent->Activate();
}

void ViewTextureBuffers::Deactivate()
{
  this->Triangles.Texture->Deactivate();
  this->Frames.Texture->Deactivate();
  this->Charts.Texture->Deactivate();
  this->Dependent->Deactivate();
  this->Independent->Deactivate();
}

void ViewTextureBuffers::Release(vtkWindow* window)
{
  this->Triangles.Release(window);
  this->Frames.Release(window);
  this->Charts.Release(window);
  this->Dependent->ReleaseGraphicsResources(window);
  this->Independent->ReleaseGraphicsResources(window);
}
