// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BenchmarkOptions.h"

#include "UserError.h"

#include <cstdlib>
#include <sstream>

namespace hachure::benchmark
{
using hachure::program::UserError;

namespace
{
constexpr int LargestSide = 16384;
constexpr int SmallestSide = 16;
constexpr int LargestTriangles = 20000000;
constexpr int SmallestTriangles = 100;
constexpr int LargestFrames = 100000;
constexpr int LargestPatches = 8192;

/// All layers that can be measured, with their default configuration.
const std::vector<LayerConfiguration>& knownLayers()
{
  static const std::vector<LayerConfiguration> Layers = { { "image", "cross-hatch" },
    { "noise", "gabor" }, { "stipple", "stipple" } };
  return Layers;
}

[[noreturn]] void refuse(
  const std::string& option, const std::string& value, const std::string& expected)
{
  throw UserError("bad value '" + value + "' for " + option + ": expected " + expected);
}

std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(part);
  }
  return parts;
}

bool toWhole(const std::string& text, int low, int high, int& value)
{
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(number >= low && number <= high))
  {
    return false;
  }
  value = static_cast<int>(number);
  return value == number;
}

int toCount(const std::string& option, const std::string& text, int low, int high)
{
  int value = 0;
  if (!toWhole(text, low, high, value))
  {
    refuse(
      option, text, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

std::vector<int> toTriangles(const std::string& option, const std::string& text)
{
  std::vector<int> counts;
  for (const std::string& part : split(text, ','))
  {
    counts.push_back(toCount(option, part, SmallestTriangles, LargestTriangles));
  }
  if (counts.empty())
  {
    refuse(option, text, "numbers of triangles");
  }
  return counts;
}

std::array<int, 2> toSize(const std::string& option, const std::string& text)
{
  const std::vector<std::string> parts = split(text, 'x');
  std::array<int, 2> size = { 0, 0 };
  if (parts.size() != 2 || !toWhole(parts[0], SmallestSide, LargestSide, size[0]) ||
    !toWhole(parts[1], SmallestSide, LargestSide, size[1]))
  {
    refuse(option, text,
      "WxH in whole pixels, each from " + std::to_string(SmallestSide) + " to " +
        std::to_string(LargestSide));
  }
  return size;
}

std::vector<LayerConfiguration> toLayers(const std::string& text)
{
  std::vector<LayerConfiguration> layers;
  std::string known;
  for (const LayerConfiguration& layer : knownLayers())
  {
    known += known.empty() ? "" : ", ";
    known += layer.layer;
  }
  for (const std::string& part : split(text, ','))
  {
    const std::size_t before = layers.size();
    for (const LayerConfiguration& layer : knownLayers())
    {
      if (layer.layer == part)
      {
        layers.push_back(layer);
      }
    }
    if (layers.size() == before)
    {
      std::string problem = "unknown layer '";
      problem.append(part).append("'; known: ").append(known);
      throw UserError(problem);
    }
  }
  if (layers.empty())
  {
    throw UserError("no layer given; known: " + known);
  }
  return layers;
}

void setOption(
  BenchmarkOptions& result, std::string& style, const std::string& name, const std::string& value)
{
  if (name == "--layer")
  {
    result.layers = toLayers(value);
  }
  else if (name == "--style")
  {
    style = value;
  }
  else if (name == "--triangles")
  {
    result.triangles = toTriangles(name, value);
  }
  else if (name == "--size")
  {
    result.size = toSize(name, value);
  }
  else if (name == "--patches")
  {
    result.patches = toCount(name, value, 1, LargestPatches);
  }
  else if (name == "--frames")
  {
    result.frames = toCount(name, value, 1, LargestFrames);
  }
  else
  {
    result.json = value;
  }
}
} // namespace

//----------------------------------------------------------------------------
BenchmarkOptions parseOptions(int argumentCount, char* const* arguments)
{
  BenchmarkOptions result;
  result.layers = knownLayers();
  std::string style;
  for (int i = 1; i < argumentCount; ++i)
  {
    const std::string argument = arguments[i];
    if (argument == "--help" || argument == "-h")
    {
      result.help = true;
      return result;
    }
    const auto equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    if (name != "--layer" && name != "--style" && name != "--triangles" && name != "--size" &&
      name != "--patches" && name != "--frames" && name != "--json")
    {
      throw UserError("unknown option '" + name + "'; try hachure-benchmark --help");
    }
    if (equals == std::string::npos && i + 1 >= argumentCount)
    {
      throw UserError("option " + name + " needs a value");
    }
    setOption(result, style, name,
      equals == std::string::npos ? std::string(arguments[++i]) : argument.substr(equals + 1));
  }
  for (LayerConfiguration& layer : result.layers)
  {
    layer.style = style.empty() ? layer.style : style;
  }
  return result;
}

//----------------------------------------------------------------------------
const char* helpText()
{
  return R"(usage: hachure-benchmark [options]

Draws an isosurface of VTK's wavelet, with point normals, by turns with VTK's own mapper and with a
pattern on it, and prints the cost of both as JSON: a list with one row per layer and number of
triangles. The camera turns half a degree every frame; the surface covers about 28 % of the
picture; neither side is multisampled.

  --layer NAME[,...]   layers to measure: image (default: all)
  --style NAME|FILE    a style, or a .json file, instead of the layer's default configuration
                       (image: cross-hatch, which has an outline)
  --triangles N[,...]  triangles of the surface, about (default 500000)
  --patches N          cut the surface into N patches that blend near their borders (default 1)
  --size WxH           pixels of the picture (default 1280x720)
  --frames N           measured frames of each kind in each of the 5 runs (default 10)
  --json FILE          write the JSON to this file too
  --help               this text

Keys of a row:
  layer, config        what was drawn: the style and how the numbers were obtained
  triangles            how many the surface really has
  patches              of the surface
  width, height        of the picture, in pixels
  plain_cpu_ms         processor time of a frame drawn by VTK, all threads, to the end of drawing
  pattern_cpu_ms       the same with the pattern
  cpu_ratio            pattern over plain in processor time
  wall_ratio           pattern over plain in elapsed time
  gpu_ms               time of a pattern frame on the graphics processor; null where there is none
  memory_bytes         of textures and buffers that the pattern adds to the mapper's
Times and ratios are medians over the runs, which are taken by turns.
)";
}
} // namespace hachure::benchmark
