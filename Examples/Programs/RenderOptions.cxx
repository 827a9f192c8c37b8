// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RenderOptions.h"

#include "UserError.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>

namespace hachure::program
{
namespace
{
/// Pixels along one side that every OpenGL of interest can draw into.
constexpr int LargestSide = 16384;
constexpr int SmallestSide = 16;
constexpr int LargestSupersample = 8;
constexpr int UsualSupersample = 2;
constexpr int FinalSupersample = 4;
constexpr int LargestOrbit = 100000;
constexpr double LargestZoom = 1000.0;

[[noreturn]] void refuse(
  const std::string& option, const std::string& value, const std::string& expected)
{
  throw UserError("bad value '" + value + "' for " + option + ": expected " + expected);
}

std::optional<double> toNumber(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value))
  {
    return std::nullopt;
  }
  return value;
}

/// The numbers of "A:B" or "W x H"; nothing when one is malformed.
std::optional<std::array<double, 2>> toPair(const std::string& text, char separator)
{
  const auto cut = text.find(separator);
  if (cut == std::string::npos)
  {
    return std::nullopt;
  }
  const auto first = toNumber(text.substr(0, cut));
  const auto second = toNumber(text.substr(cut + 1));
  if (!first || !second)
  {
    return std::nullopt;
  }
  return std::array<double, 2>{ *first, *second };
}

int toInteger(const std::string& option, const std::string& text, int low, int high)
{
  const auto value = toNumber(text);
  if (!value || *value != std::floor(*value) || *value < low || *value > high)
  {
    refuse(
      option, text, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return static_cast<int>(*value);
}

std::array<int, 2> toSize(const std::string& option, const std::string& text)
{
  const auto fits = [](double side)
  { return side == std::floor(side) && side >= SmallestSide && side <= LargestSide; };
  const auto pair = toPair(text, 'x');
  if (!pair || !fits((*pair)[0]) || !fits((*pair)[1]))
  {
    refuse(option, text,
      "WxH in whole pixels, each from " + std::to_string(SmallestSide) + " to " +
        std::to_string(LargestSide));
  }
  return { static_cast<int>((*pair)[0]), static_cast<int>((*pair)[1]) };
}

std::array<double, 2> toZoom(const std::string& option, const std::string& text)
{
  const auto fits = [](double zoom) { return zoom >= 1.0 / LargestZoom && zoom <= LargestZoom; };
  auto pair = toPair(text, ':');
  if (const auto constant = toNumber(text))
  {
    pair = std::array<double, 2>{ *constant, *constant };
  }
  if (!pair || !fits((*pair)[0]) || !fits((*pair)[1]))
  {
    refuse(option, text, "A:B, the magnification of the first and the last frame");
  }
  return *pair;
}

std::array<double, 2> toLight(const std::string& option, const std::string& text)
{
  const auto pair = toPair(text, ',');
  if (!pair || std::abs((*pair)[1]) > 90.0)
  {
    refuse(option, text, "AZ,EL in degrees, EL from -90 to 90");
  }
  return *pair;
}

double toIsovalue(const std::string& option, const std::string& text)
{
  const auto value = toNumber(text);
  if (!value)
  {
    refuse(option, text, "a number");
  }
  return *value;
}

std::string toAxis(const std::string& option, const std::string& text)
{
  std::string axis = !text.empty() && text[0] == '+' ? text.substr(1) : text;
  for (const char* known : { "x", "y", "z", "-x", "-y", "-z" })
  {
    if (axis == known)
    {
      return axis;
    }
  }
  refuse(option, text, "one of x y z -x -y -z");
}

/// Whether it is the final one.
bool toQuality(const std::string& option, const std::string& text)
{
  if (text != "interactive" && text != "final")
  {
    refuse(option, text, "interactive or final");
  }
  return text == "final";
}

using Setter = std::function<void(const std::string& option, const std::string& value)>;

std::map<std::string, Setter> valueOptions(RenderOptions& result)
{
  using Text = const std::string&;
  return {
    { "--isovalue", [&](Text o, Text v) { result.isovalue = toIsovalue(o, v); } },
    { "--style", [&](Text, Text v) { result.style = v; } },
    { "--array", [&](Text, Text v) { result.array = v; } },
    { "--orbit", [&](Text o, Text v) { result.orbit = toInteger(o, v, 1, LargestOrbit); } },
    { "--zoom", [&](Text o, Text v) { result.zoom = toZoom(o, v); } },
    { "--size", [&](Text o, Text v) { result.size = toSize(o, v); } },
    { "--light", [&](Text o, Text v) { result.light = toLight(o, v); } },
    { "--animation", [&](Text, Text v) { result.animation = v; } },
    { "--output", [&](Text, Text v) { result.output = v; } },
    { "--supersample",
      [&](Text o, Text v) { result.supersample = toInteger(o, v, 1, LargestSupersample); } },
    { "--quality", [&](Text o, Text v) { result.finalQuality = toQuality(o, v); } },
    { "--up", [&](Text o, Text v) { result.up = toAxis(o, v); } },
    { "--front", [&](Text o, Text v) { result.front = toAxis(o, v); } },
  };
}

/// Combinations that cannot be meant.
void checkTogether(const RenderOptions& options)
{
  if (options.input.empty())
  {
    throw UserError("no input file given; try hachure-render --help");
  }
  if (!options.animation.empty() && (options.orbit > 0 || options.zoom))
  {
    throw UserError("--animation sets the camera itself: leave out --orbit and --zoom");
  }
  if (options.zoom && options.orbit < 2 && (*options.zoom)[0] != (*options.zoom)[1])
  {
    throw UserError("--zoom A:B needs --orbit N with at least 2 frames");
  }
  const int longest = std::max(options.size[0], options.size[1]) * options.supersample;
  if (longest > LargestSide)
  {
    throw UserError("--size times --supersample is " + std::to_string(longest) +
      " pixels: at most " + std::to_string(LargestSide));
  }
  if (!options.up.empty() && !options.front.empty() && options.up.back() == options.front.back())
  {
    throw UserError("--up " + options.up + " and --front " + options.front + " are one axis");
  }
}

bool isPlainAction(const std::string& argument, RenderOptions& result)
{
  static const std::map<std::string, Action> Actions = { { "--help", Action::Help },
    { "-h", Action::Help }, { "--version", Action::Version },
    { "--list-styles", Action::ListStyles } };
  const auto found = Actions.find(argument);
  if (found == Actions.end())
  {
    return false;
  }
  result.action = found->second;
  return true;
}
} // namespace

//----------------------------------------------------------------------------
RenderOptions parseOptions(int argumentCount, char* const* arguments)
{
  RenderOptions result;
  const auto setters = valueOptions(result);
  for (int i = 1; i < argumentCount; ++i)
  {
    std::string argument = arguments[i];
    if (isPlainAction(argument, result))
    {
      return result;
    }
    if (argument == "--movie")
    {
      result.movie = true;
      continue;
    }
    if (argument.size() < 2 || argument[0] != '-')
    {
      if (!result.input.empty())
      {
        throw UserError("two input files given: '" + result.input + "' and '" + argument + "'");
      }
      result.input = argument;
      continue;
    }
    const auto equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    const auto setter = setters.find(name);
    if (setter == setters.end())
    {
      throw UserError("unknown option '" + name + "'; try hachure-render --help");
    }
    if (equals == std::string::npos && i + 1 >= argumentCount)
    {
      throw UserError("option " + name + " needs a value");
    }
    setter->second(
      name, equals == std::string::npos ? arguments[++i] : argument.substr(equals + 1));
  }
  if (result.supersample == 0)
  {
    result.supersample = result.finalQuality ? FinalSupersample : UsualSupersample;
  }
  checkTogether(result);
  return result;
}

//----------------------------------------------------------------------------
const char* helpText()
{
  return R"(usage: hachure-render INPUT [options]

Draws the surface of INPUT with a pattern style and writes frame_0000.png ..., contact.png
and, with --movie, movie.ogv.

INPUT is read by its extension: .vtp .vtu .vti .vtm .stl .obj .ply .ex2 .nii .nii.gz .slc
.nc .cdf. Volumes are drawn as an isosurface, other data sets as their outer surface.

  --isovalue V         scalar value of the isosurface; volumes need it
  --style NAME|FILE    a style of --list-styles, or a .json file (default cross-hatch)
  --array NAME         tone follows this array, its lowest value paper, its highest full ink
  --orbit N            N frames of one full turn
  --zoom A:B           magnification of the first and the last frame (default 1:1)
  --size WxH           pixels of the pictures (default 960x720)
  --light AZ,EL        key light, degrees right of and above the viewer (default -40,40)
  --animation FILE     key frames of camera, lights, actor and style (.json)
  --output DIR         where to write, made when it does not exist (default frames)
  --movie              write movie.ogv as well
  --supersample N      draw N times larger and average in linear light (default 2, final 4)
  --quality Q          interactive, or final: slower, noises hidden pixel by pixel
  --up AXIS            axis that points up, one of x y z -x -y -z (default by file type)
  --front AXIS         axis that points at the viewer (default by file type)
  --list-styles        print the names of the styles
  --version            print the version
  --help               print this text

Exit code: 0 done, 1 drawing or writing failed, 2 an argument or an input cannot be used.
)";
}
} // namespace hachure::program
