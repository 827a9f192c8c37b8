// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoiseBackEnd.h"

#include "vtkHachureCompatibility.h"

#include "Kernels.h"
#include "Random.h"
#include "vtkNew.h"
#include "vtkNoiseComputeBackEnd.h"
#include "vtkNoiseGatherBackEnd.h"
#include "vtkNoiseSplatBackEnd.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternMapper.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

namespace
{
std::uint16_t Fraction(float value)
{
  constexpr float largest = 65535.0f;
  constexpr float half = 0.5f; // rounds
  return static_cast<std::uint16_t>(largest * std::clamp(value, 0.0f, 1.0f) + half);
}

// Sums on the processors, and uploads the field.
class CpuBackEnd : public vtkNoiseBackEnd
{
public:
  bool Draw(vtkOpenGLRenderWindow* window, const Task& task, vtkTextureObject* field) override
  {
    hachure::NoiseSurroundings around;
    around.rectangle = task.Rectangle;
    around.depth = task.LookAtDepth();
    around.objects = task.Objects;
    around.triangles = task.Triangles;
    around.depthTolerance = task.DepthTolerance;
    around.depthTest = task.DepthTest;
    around.partialVisibility = task.PartialVisibility;
    around.everyPixel = task.EveryPixel;
    hachure::noiseField(task.Kernels, around, task.Field, this->Field, this->Memory);
    this->Upload(window, task.Rectangle, field);
    return true;
  }

private:
  // As the tiles of image patterns are stored: 32 bits a texel are fast in software OpenGL.
  void Upload(
    vtkOpenGLRenderWindow* window, const std::array<int, 4>& rectangle, vtkTextureObject* texture)
  {
    const std::vector<float>& values = this->Field.value;
    const std::vector<float>& widths = this->Field.width;
    std::vector<std::uint16_t>& texels = this->Texels;
    texels.resize(2 * values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      texels[2 * i] = Fraction(values[i]);
      texels[2 * i + 1] = Fraction(widths[i] * (1.0f / hachure::glsl::tileGradientRange));
    }
    texture->SetContext(window);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->Create2DFromRaw(static_cast<unsigned int>(rectangle[2]),
      static_cast<unsigned int>(rectangle[3]), 2, VTK_UNSIGNED_SHORT, texels.data());
  }

  hachure::NoiseFieldMemory Memory;
  hachure::NoiseField Field;
  std::vector<std::uint16_t> Texels;
};

constexpr double notDrawn = 1e30; // seconds

// A plane that faces the viewer and fills a small picture, with 32 kernels over every pixel.
struct Trial
{
  static constexpr int Side = 128;
  static constexpr float Radius = 8.0f;
  static constexpr double Overlap = 32.0;
  std::vector<float> Depth = std::vector<float>(static_cast<std::size_t>(Side) * Side, 0.5f);
  std::vector<hachure::NoiseKernel> Kernels;
  vtkNew<vtkTextureObject> DepthImage;
  vtkNew<vtkTextureObject> Field;

  explicit Trial(vtkOpenGLRenderWindow* window)
  {
    this->DepthImage->SetContext(window);
    this->DepthImage->SetMinificationFilter(vtkTextureObject::Nearest);
    this->DepthImage->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->DepthImage->Create2DFromRaw(Side, Side, 1, VTK_FLOAT, this->Depth.data());
    constexpr double circle = 3.14159265358979323846;
    constexpr auto count =
      static_cast<std::uint64_t>(Overlap * Side * Side / (circle * Radius * Radius));
    this->Kernels.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i)
    {
      const auto random = [i](std::uint32_t dimension)
      { return hachure::unitRandom(1, i, dimension); };
      hachure::NoiseKernel kernel;
      kernel.center = { Side * random(0), Side * random(1) };
      kernel.phase = static_cast<float>(2.0 * circle * random(2));
      kernel.bandwidth = hachure::glsl::kernelBandwidth(Radius);
      kernel.depth = 0.5f;
      this->Kernels.push_back(kernel);
    }
  }

  // Seconds; a first drawing makes shaders.
  double Time(vtkOpenGLRenderWindow* window, int type)
  {
    const std::unique_ptr<vtkNoiseBackEnd> backEnd = vtkNoiseBackEnd::New(type);
    const vtkNoiseBackEnd::Task task = { this->Kernels, { 0, 0, Side, Side }, this->DepthImage,
      [this]() -> const std::vector<float>& { return this->Depth; }, {}, {}, 1e-4f, true, true,
      false, {} };
    bool drawn = backEnd->Draw(window, task, this->Field);
    glFinish();
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    constexpr int repeats = 5;
    constexpr double enough = 0.02; // seconds: what is slow is not drawn often
    double least = notDrawn;
    double sum = 0.0;
    for (int repeat = 0; repeat < repeats && drawn && sum < enough; ++repeat)
    {
      const Clock::time_point start = Clock::now();
      drawn = backEnd->Draw(window, task, this->Field);
      glFinish();
      const double passed = Seconds(Clock::now() - start).count();
      sum += passed;
      least = std::min(least, passed);
    }
    least = drawn ? least : notDrawn;
    backEnd->ReleaseGraphicsResources(window);
    return least;
  }
};

// Other programs slow threads down, sometimes by many times, in a way that says nothing of the
// frames to come: a graphics card must be clearly faster.
int Fastest(vtkOpenGLRenderWindow* window)
{
  constexpr double clearly = 2.0;
  constexpr double hopeless = 8.0; // compute shaders do not make up for that
  Trial trial(window);
  const double processors = trial.Time(window, vtkPatternMapper::CPU);
  const auto timeOf = [&](int type)
  { return vtkNoiseBackEnd::IsAvailable(window, type) ? trial.Time(window, type) : notDrawn; };
  const double gather = timeOf(vtkPatternMapper::GATHER);
  const double compute =
    gather < hopeless * processors ? timeOf(vtkPatternMapper::COMPUTE) : notDrawn;
  trial.DepthImage->ReleaseGraphicsResources(window);
  trial.Field->ReleaseGraphicsResources(window);
  if (clearly * std::min(gather, compute) >= processors)
  {
    return vtkPatternMapper::CPU;
  }
  return compute < gather ? vtkPatternMapper::COMPUTE : vtkPatternMapper::GATHER;
}

std::string DeviceName()
{
  std::string name;
  for (const unsigned int part : { GL_VENDOR, GL_RENDERER, GL_VERSION })
  {
    const unsigned char* text = glGetString(part);
    name.append(text ? reinterpret_cast<const char*>(text) : "").append("\n");
  }
  return name;
}
} // namespace

std::unique_ptr<vtkNoiseBackEnd> vtkNoiseBackEnd::New(int type)
{
  switch (type)
  {
    case vtkPatternMapper::GATHER:
      return std::make_unique<vtkNoiseGatherBackEnd>();
    case vtkPatternMapper::COMPUTE:
      return std::make_unique<vtkNoiseComputeBackEnd>();
    case vtkPatternMapper::SPLAT:
      return std::make_unique<vtkNoiseSplatBackEnd>();
    default:
      return std::make_unique<CpuBackEnd>();
  }
}

bool vtkNoiseBackEnd::IsAvailable(vtkOpenGLRenderWindow* window, int type)
{
  switch (type)
  {
    case vtkPatternMapper::GATHER:
    case vtkPatternMapper::SPLAT:
      return vtkNoiseGpuBackEnd::CanDrawFloats(window);
    case vtkPatternMapper::COMPUTE:
      return vtkNoiseGpuBackEnd::CanDrawFloats(window) && vtkHachureHasComputeShaders();
    default:
      return type == vtkPatternMapper::CPU;
  }
}

int vtkNoiseBackEnd::Choose(vtkOpenGLRenderWindow* window, int wanted, std::string& note)
{
  if (wanted != vtkPatternMapper::AUTOMATIC && IsAvailable(window, wanted))
  {
    return wanted;
  }
  static std::map<std::string, int> measured;
  const std::string device = DeviceName();
  auto found = measured.find(device);
  if (found == measured.end())
  {
    found = measured.emplace(device, Fastest(window)).first;
  }
  if (wanted != vtkPatternMapper::AUTOMATIC)
  {
    const char* const names[] = { "automatic", "CPU", "GATHER", "COMPUTE", "SPLAT" };
    note = "the window's OpenGL cannot sum noises with the back end ";
    note.append(names[wanted]).append("; it takes ").append(names[found->second]);
  }
  return found->second;
}
