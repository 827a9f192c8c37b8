// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RenderOptions.h"

#include "OptionParsing.h"
#include "UserError.h"

#include <algorithm>

namespace hachure::program
{
namespace
{
constexpr int LargestSupersample = 8;
constexpr int UsualSupersample = 2;
constexpr int FinalSupersample = 4;
constexpr int LargestOrbit = 100000;
constexpr double LargestZoom = 1000.0;

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

/// Whether it is the final one.
bool toQuality(const std::string& option, const std::string& text)
{
  if (text != "interactive" && text != "final")
  {
    refuse(option, text, "interactive or final");
  }
  return text == "final";
}

ValueOptions valueOptions(RenderOptions& result)
{
  using Text = const std::string&;
  return {
    { "--isovalue", [&](Text o, Text v) { result.isovalue = toIsovalue(o, v); } },
    { "--style", [&](Text, Text v) { result.style = v; } },
    { "--views", [&](Text, Text v) { result.views = v; } },
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
} // namespace

//----------------------------------------------------------------------------
RenderOptions parseOptions(int argumentCount, char* const* arguments)
{
  RenderOptions result;
  const auto act = [&](Action action) { return [&result, action] { result.action = action; }; };
  OptionTable table;
  table.program = "hachure-render";
  table.input = &result.input;
  table.values = valueOptions(result);
  table.flags = { { "--movie", [&] { result.movie = true; } } };
  table.actions = { { "--help", act(Action::Help) }, { "-h", act(Action::Help) },
    { "--version", act(Action::Version) }, { "--list-styles", act(Action::ListStyles) } };
  if (!readArguments(argumentCount, arguments, table))
  {
    return result;
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
  --views FILE         manifest of views for the style's layers of view-dependent texture
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
