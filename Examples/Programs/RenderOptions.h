// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// The command line of hachure-render: names, defaults, ranges, help text.

#ifndef RenderOptions_h
#define RenderOptions_h

#include <array>
#include <optional>
#include <string>

namespace hachure::program
{
enum class Action
{
  Render,
  Help,
  Version,
  ListStyles
};

struct RenderOptions
{
  Action action = Action::Render;
  std::string input;
  std::optional<double> isovalue;                ///< in the units of the volume's scalars
  std::string views;                             ///< a manifest of views; empty: none
  std::string style = "cross-hatch";             ///< a preset's name, or a file ending in .json
  std::string array;                             ///< tone follows this array; empty: the light
  int orbit = 0;                                 ///< frames of one full turn; 0: one still picture
  std::optional<std::array<double, 2>> zoom;     ///< magnification of the first and last frame
  std::array<int, 2> size = { 960, 720 };        ///< pixels of the written pictures
  std::array<double, 2> light = { -40.0, 40.0 }; ///< degrees right of and above the viewer
  std::string animation;                         ///< key frame file, see animation.schema.md
  std::string output = "frames";                 ///< folder, made when it does not exist
  bool movie = false;
  bool finalQuality = false;
  int supersample = 0; ///< pictures are drawn this many times larger and averaged; 0: as usual
  std::string up;      ///< axis, "z" or "-y"; empty: by file type
  std::string front;   ///< axis that points at the viewer; empty: by file type
};

/// Reads the arguments. Throws UserError, one line that names the option and the value.
RenderOptions parseOptions(int argumentCount, char* const* arguments);

/// The text of --help.
const char* helpText();
} // namespace hachure::program

#endif
