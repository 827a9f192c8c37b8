// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewTextureScene_h
#define hachure_ViewTextureScene_h

// Surfaces and cameras for the tests of view-dependent textures.

#include "TestSurfaces.h"

#include "Core/CellLayers.h"
#include "Core/TextureView.h"
#include "Core/ViewTexture.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace hachure
{

// Of radius 1, from an octahedron whose edges were halved so many times.
inline Surface sphereOf(int subdivisions)
{
  Surface sphere;
  sphere.points = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
    { 0, 0, -1 } };
  sphere.triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
    { 3, 1, 5 }, { 0, 3, 5 } };
  for (int step = 0; step < subdivisions; ++step)
  {
    std::map<std::pair<int, int>, int> middles;
    const auto middleOf = [&](int a, int b)
    {
      const auto found = middles.emplace(std::minmax(a, b), static_cast<int>(sphere.points.size()));
      if (found.second)
      {
        sphere.points.push_back(glm::normalize(
          sphere.points[static_cast<std::size_t>(a)] + sphere.points[static_cast<std::size_t>(b)]));
      }
      return found.first->second;
    };
    std::vector<glm::ivec3> finer;
    finer.reserve(4 * sphere.triangles.size());
    for (const glm::ivec3& t : sphere.triangles)
    {
      const glm::ivec3 m(middleOf(t.y, t.z), middleOf(t.z, t.x), middleOf(t.x, t.y));
      finer.insert(finer.end(), { { t.x, m.z, m.y }, { m.z, t.y, m.x }, { m.y, m.x, t.z }, m });
    }
    sphere.triangles = finer;
  }
  return sphere;
}

inline Surface squareOf(int n)
{
  Surface square;
  addGrid(square, { -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, n);
  return square;
}

// A view of square pixels, with an opening of 40 degrees.
inline TextureView viewFrom(const glm::dvec3& eye, const glm::dvec3& focus, int width, int height)
{
  constexpr double opening = 0.7;
  TextureView view;
  const double distance = glm::distance(eye, focus);
  const glm::dvec3 up =
    std::abs(eye.y - focus.y) > 0.9 * distance ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  view.modelToClip = glm::perspective(opening, static_cast<double>(width) / height, 0.05 * distance,
                       10.0 * distance) *
    glm::lookAt(eye, focus, up);
  view.eye = eye;
  view.focus = focus;
  view.width = width;
  view.height = height;
  return view;
}

// Extreme places of the camera: `count` around its own, this angle (radians) away about the focus.
inline std::vector<glm::dvec3> extremesAround(const TextureView& view, int count, double angle)
{
  const glm::dvec3 centre = view.eye - view.focus;
  const glm::dvec3 axis = glm::normalize(glm::cross(
    centre, std::abs(centre.x) < std::abs(centre.y) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 other = glm::normalize(glm::cross(centre, axis));
  std::vector<glm::dvec3> extremes;
  extremes.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    const double around = 2.0 * 3.14159265358979 * i / count;
    const glm::dvec3 side = std::cos(around) * axis + std::sin(around) * other;
    extremes.push_back(
      view.focus + std::cos(angle) * centre + std::sin(angle) * glm::length(centre) * side);
  }
  return extremes;
}

inline std::vector<CellLayer> layersOf(const SurfaceCells& cells)
{
  std::vector<CellLayer> layers;
  layers.reserve(static_cast<std::size_t>(cells.finestLevel) + 1);
  for (int level = 0; level <= cells.finestLevel; ++level)
  {
    layers.emplace_back(cells, level);
  }
  return layers;
}

using Paint = std::function<glm::u8vec4(int column, int row)>;

inline std::vector<glm::u8vec4> paint(const TextureView& view, const Paint& color)
{
  std::vector<glm::u8vec4> pixels;
  pixels.reserve(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  for (int row = 0; row < view.height; ++row)
  {
    for (int column = 0; column < view.width; ++column)
    {
      pixels.push_back(color(column, row));
    }
  }
  return pixels;
}

struct Textured
{
  Surface surface;
  SurfaceCells cells;
  ViewTexture texture;

  Textured(
    const Surface& ofSurface, const SurfaceCells& ofCells, const ViewTextureOptions& options = {})
    : surface(ofSurface)
    , cells(ofCells)
    , texture(surface.mesh(), cells, surfaceFrames(surface.mesh(), cells), options)
  {
  }
  explicit Textured(const Surface& ofSurface, const ViewTextureOptions& options = {})
    : Textured(ofSurface, trianglesAsCells(ofSurface.mesh()), options)
  {
  }
  void setImage(std::size_t index, const TextureView& view, const Paint& color)
  {
    const std::vector<glm::u8vec4> pixels = paint(view, color);
    this->texture.setImage(index, { view.width, view.height, pixels });
  }
  std::int64_t nodes() const { return this->cells.firstNode.back(); }
};

const glm::u8vec4 redPixel(255, 0, 0, 255);
const glm::u8vec4 bluePixel(0, 0, 255, 255);
const glm::u8vec4 clearPixel(0, 0, 0, 0);

inline Paint plain(const glm::u8vec4& color)
{
  return [color](int, int) { return color; };
}

// Cameras all around.
inline std::vector<TextureView> viewsAround(int count, int size)
{
  std::vector<TextureView> views;
  views.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    const double height = 1.0 - (2.0 * i + 1.0) / count;
    const double around = 2.39996323 * i;
    const double side = std::sqrt(1.0 - height * height);
    views.push_back(viewFrom(
      (3.2 + 0.1 * (i % 3)) * glm::dvec3(side * std::cos(around), height, side * std::sin(around)),
      glm::dvec3(0.0), size, size));
  }
  return views;
}

} // namespace hachure

#endif
