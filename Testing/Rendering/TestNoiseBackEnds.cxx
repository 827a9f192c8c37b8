// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// Sums of a noise on a graphics card: those of every back end are the definition's.

#include "Core/Kernels.h"
#include "Core/NoiseField.h"
#include "Core/NoiseVisibility.h"
#include "Core/Random.h"

#include <vtkNew.h>
#include <vtkNoiseGpuBackEnd.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPatternMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{
using namespace hachure;

constexpr int framebufferWidth = 150;
constexpr int framebufferHeight = 130;
constexpr std::array<int, 4> rectangle = { 21, 9, 110, 100 };
constexpr float kernelRadius = 9.0f;
constexpr double overlap = 32.0;
constexpr double sphereRadius = 44.0;
constexpr double pi = 3.14159265358979323846;

// A sphere, half of it behind a nearer wall of another object, in a parallel view. Its kernels lie
// on both of its sides.
struct Scene
{
  std::vector<float> image; // of the framebuffer
  std::vector<float> depth; // of the rectangle
  std::vector<std::int32_t> objects, triangles;
  std::vector<NoiseKernel> kernels;

  Scene()
  {
    this->image.reserve(static_cast<std::size_t>(framebufferWidth) * framebufferHeight);
    for (int row = 0; row < framebufferHeight; ++row)
    {
      for (int column = 0; column < framebufferWidth; ++column)
      {
        this->image.push_back(DepthAt(column, row));
      }
    }
    for (int row = rectangle[1]; row < rectangle[1] + rectangle[3]; ++row)
    {
      for (int column = rectangle[0]; column < rectangle[0] + rectangle[2]; ++column)
      {
        this->depth.push_back(DepthAt(column, row));
        this->objects.push_back(this->depth.back() >= 1.0f ? -1 : IsWall(column) ? 1 : 0);
        this->triangles.push_back((column + row) / 24);
      }
    }
    const auto count = static_cast<std::uint64_t>(
      2.0 * overlap * framebufferWidth * framebufferHeight / (pi * kernelRadius * kernelRadius));
    this->kernels.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i)
    {
      this->AddKernel(i);
    }
  }

private:
  static constexpr double middleX = 80.0;
  static constexpr double middleY = 60.0;
  static double HeightSquare(double x, double y)
  {
    const double a = x - middleX;
    const double b = y - middleY;
    return sphereRadius * sphereRadius - a * a - b * b;
  }
  static float DepthOf(double z) { return static_cast<float>(0.5 - 0.25 * z / sphereRadius); }
  static bool IsWall(int column) { return column > 88; }
  static float DepthAt(int column, int row)
  {
    const double square = HeightSquare(column + 0.5, row + 0.5);
    if (IsWall(column) && row > 40)
    {
      return 0.1f;
    }
    return square > 0.0 ? DepthOf(std::sqrt(square)) : 1.0f;
  }
  void AddKernel(std::uint64_t id)
  {
    const auto random = [id](std::uint32_t dimension) { return unitRandom(5, id, dimension); };
    NoiseKernel kernel;
    const double x = framebufferWidth * random(0);
    const double y = framebufferHeight * random(1);
    const double square = HeightSquare(x, y);
    kernel.center = { x, y };
    if (square > 1.0)
    {
      const double z = std::sqrt(square) * (random(2) < 0.5 ? -1.0 : 1.0);
      const double slope = 0.25 / (sphereRadius * z);
      kernel.depth = DepthOf(z);
      kernel.depthSlope = { slope * (x - middleX), slope * (y - middleY) };
    }
    else
    {
      kernel.depth = 0.1f;
      kernel.object = 1;
    }
    kernel.weight = static_cast<float>(random(3));
    kernel.bandwidth = glsl::kernelBandwidth(kernelRadius * static_cast<float>(0.6 + random(4)));
    kernel.phase = static_cast<float>(2.0 * pi * random(5));
    kernel.orientation = static_cast<float>(pi * random(6));
    kernel.triangle = static_cast<int>(x + y) / 24;
    this->kernels.push_back(kernel);
  }
};

struct Tests
{
  const char* Name;
  bool Depth, Partial, Objects, Triangles;
};

// Pixels in which something is seen and that no kernel's rim crosses.
std::vector<std::size_t> SafePixels(const Scene& scene)
{
  std::vector<std::size_t> safe;
  for (std::size_t i = 0; i < scene.depth.size(); ++i)
  {
    const int column = static_cast<int>(i) % rectangle[2];
    const int row = static_cast<int>(i) / rectangle[2];
    const glm::vec2 pixel(static_cast<float>(rectangle[0] + column) + 0.5f,
      static_cast<float>(rectangle[1] + row) + 0.5f);
    const bool clear = std::none_of(scene.kernels.begin(), scene.kernels.end(),
      [&](const NoiseKernel& kernel)
      {
        return std::abs(glm::length(pixel - kernel.center) - glsl::kernelRadius(kernel.bandwidth)) <
          1e-3f;
      });
    if (scene.depth[i] < 1.0f && clear)
    {
      safe.push_back(i);
    }
  }
  return safe;
}

class Comparison
{
public:
  explicit Comparison(vtkOpenGLRenderWindow* window)
    : Window(window)
    , Safe(SafePixels(this->Shown))
  {
    this->DepthImage->SetContext(window);
    this->DepthImage->SetMinificationFilter(vtkTextureObject::Nearest);
    this->DepthImage->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->DepthImage->Create2DFromRaw(
      framebufferWidth, framebufferHeight, 1, VTK_FLOAT, this->Shown.image.data());
  }
  ~Comparison()
  {
    this->DepthImage->ReleaseGraphicsResources(this->Window);
    this->Field->ReleaseGraphicsResources(this->Window);
  }
  Comparison(const Comparison&) = delete;
  void operator=(const Comparison&) = delete;

  bool Agrees(int type, const NoiseFieldOptions& field, const Tests& tests)
  {
    NoiseSurroundings around;
    around.rectangle = rectangle;
    around.depth = this->Shown.depth;
    around.depthTolerance =
      noiseDepthToleranceFor(kernelRadius, static_cast<float>(0.25 / sphereRadius));
    around.depthTest = tests.Depth;
    around.partialVisibility = tests.Partial;
    around.objects = tests.Objects ? Span<const std::int32_t>(this->Shown.objects) : around.objects;
    around.triangles =
      tests.Triangles ? Span<const std::int32_t>(this->Shown.triangles) : around.triangles;
    const auto backEnd = vtkNoiseBackEnd::New(type);
    auto* card = dynamic_cast<vtkNoiseGpuBackEnd*>(backEnd.get());
    const vtkNoiseBackEnd::Task task = { this->Shown.kernels, rectangle, this->DepthImage,
      [this]() -> const std::vector<float>& { return this->Shown.depth; }, around.objects,
      around.triangles, around.depthTolerance, tests.Depth, tests.Partial, false, field };
    const bool drawn = card && card->Draw(this->Window, task, this->Field);
    const std::vector<float> sums = drawn ? card->ReadSums(this->Window) : std::vector<float>();
    backEnd->ReleaseGraphicsResources(this->Window);
    return drawn && this->Compare(sums, noiseReference(this->Shown.kernels, around, field), tests);
  }

private:
  bool Compare(const std::vector<float>& sums, const NoiseReference& expected, const Tests& tests)
  {
    const std::vector<double>& second = expected.y.empty() ? expected.z : expected.y;
    // Of the first and of the second sum.
    double squares[2] = { 0.0, 0.0 };
    double most[2] = { 0.0, 0.0 };
    for (const std::size_t i : this->Safe)
    {
      const double wanted[] = { expected.x[i], second[i] };
      for (std::size_t k = 0; k < 2; ++k)
      {
        squares[k] += wanted[k] * wanted[k] / static_cast<double>(this->Safe.size());
        most[k] = std::max(most[k], std::abs(static_cast<double>(sums[2 * i + k]) - wanted[k]));
      }
    }
    const double differences[] = { most[0] / std::sqrt(squares[0]),
      most[1] / std::sqrt(squares[1]) };
    std::cout << "  " << tests.Name << ": largest differences " << differences[0] << ", "
              << differences[1] << " of deviations " << std::sqrt(squares[0]) << ", "
              << std::sqrt(squares[1]) << "\n";
    constexpr double tolerance = 1e-5;
    return squares[0] > 0.01 && differences[0] < tolerance && differences[1] < tolerance;
  }

  vtkOpenGLRenderWindow* Window;
  Scene Shown;
  std::vector<std::size_t> Safe;
  vtkNew<vtkTextureObject> DepthImage;
  vtkNew<vtkTextureObject> Field;
};
} // namespace

int TestNoiseBackEnds(int, char*[])
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->SetOffScreenRendering(true);
  window->AddRenderer(renderer);
  window->Render();
  auto* drawing = vtkOpenGLRenderWindow::SafeDownCast(window);
  drawing->MakeCurrent();
  Comparison comparison(drawing);
  NoiseSpot image{ 7, 5, {} };
  for (int i = 0; i < 35; ++i)
  {
    image.values.push_back(static_cast<float>(i * i % 11));
  }
  const std::pair<const char*, NoiseFieldOptions> kinds[] = {
    { "gabor", { NoiseKind::gabor, overlap, nullptr, 0.0 } },
    { "phasor", { NoiseKind::phasor, overlap, nullptr, 0.0 } },
    { "spot", { NoiseKind::spot, overlap, &image, 0.0 } },
  };
  const Tests tests[] = {
    { "no test", false, false, false, false },
    { "objects", false, false, true, false },
    { "objects, partial", false, true, true, false },
    { "triangles", false, false, false, true },
    { "depth", true, false, false, false },
    { "depth, partial", true, true, false, false },
    { "all", true, true, true, true },
  };
  bool good = true;
  for (const int type :
    { vtkPatternMapper::GATHER, vtkPatternMapper::COMPUTE, vtkPatternMapper::SPLAT })
  {
    if (!vtkNoiseBackEnd::IsAvailable(drawing, type))
    {
      std::cout << "back end " << type << " is not available\n";
      good = good && type == vtkPatternMapper::COMPUTE; // needs OpenGL 4.3
      continue;
    }
    for (const auto& kind : kinds)
    {
      std::cout << "back end " << type << ", " << kind.first << "\n";
      for (const Tests& test : tests)
      {
        const bool agrees = comparison.Agrees(type, kind.second, test);
        std::cout << (agrees ? "" : "    which is too much\n");
        good = good && agrees;
      }
    }
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
