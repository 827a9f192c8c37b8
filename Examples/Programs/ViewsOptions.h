// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// The command line of hachure-views: names, defaults, ranges, help text.

#ifndef ViewsOptions_h
#define ViewsOptions_h

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace hachure::program
{
enum class ViewsAction
{
  Export,
  Help,
  Version
};

/// A camera as it was given, in the coordinates of the surface.
struct GivenCamera
{
  std::array<double, 3> position;
  std::array<double, 3> focalPoint;
  std::optional<std::array<double, 3>> viewUp; ///< none: the axis that points up
};

struct ViewsOptions
{
  ViewsAction action = ViewsAction::Export;
  std::string input;
  std::optional<double> isovalue;         ///< in the units of the volume's scalars
  std::vector<GivenCamera> cameras;       ///< views of their own
  double viewAngle = 30.0;                ///< vertical, degrees, of the given cameras
  int orbit = 0;                          ///< views around the axis that points up
  int hemisphere = 0;                     ///< views spread over the directions above the surface
  std::string manifest;                   ///< views of the cameras of this manifest
  std::optional<std::array<int, 2>> size; ///< pixels; none: 960 x 720, or as in the manifest
  std::optional<bool> dependent;          ///< none: independent, or as in the manifest
  std::optional<double> extremeAngle;     ///< degrees from a camera to its four extreme points
  std::array<double, 2> light = { -40.0, 40.0 }; ///< degrees right of and above the viewer
  std::string output = "views";                  ///< folder, made when it does not exist
  bool overwrite = false;
  std::string up;    ///< axis, "z" or "-y"; empty: by file type
  std::string front; ///< axis that points at the first camera; empty: by file type
};

/// Reads the arguments. Throws UserError, one line that names the option and the value.
ViewsOptions parseViewsOptions(int argumentCount, char* const* arguments);

/// The text of --help.
const char* viewsHelpText();
} // namespace hachure::program

#endif
