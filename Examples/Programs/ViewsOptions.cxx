// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewsOptions.h"

#include "OptionParsing.h"
#include "UserError.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>

namespace hachure::program
{
namespace
{
/// More views than anyone paints; each stays in memory until all are written.
constexpr int MostViews = 1000;
constexpr double UsualExtremeAngle = 30.0;
/// Degrees; VTK's cameras end there.
constexpr double GreatestViewAngle = 179.0;

std::array<double, 3> toPoint(
  const std::string& option, const std::string& all, const std::string& text)
{
  const auto numbers = toNumbers(text, ',');
  if (numbers.size() != 3)
  {
    refuse(option, all, "X,Y,Z/X,Y,Z/X,Y,Z: position, focal point and, if need be, view up");
  }
  return { numbers[0], numbers[1], numbers[2] };
}

/// Whether a camera can see so: neither on its focal point nor upright along its view.
bool isCamera(const GivenCamera& camera)
{
  const auto vector = [](const std::array<double, 3>& p) { return glm::dvec3(p[0], p[1], p[2]); };
  const glm::dvec3 direction = vector(camera.focalPoint) - vector(camera.position);
  const glm::dvec3 up = camera.viewUp ? vector(*camera.viewUp) : glm::dvec3(0.0);
  return glm::length(direction) > 0.0 &&
    (!camera.viewUp ||
      glm::length(glm::cross(direction, up)) > 1e-9 * glm::length(direction) * glm::length(up));
}

GivenCamera toCamera(const std::string& option, const std::string& text)
{
  const auto first = text.find('/');
  const auto second = first == std::string::npos ? first : text.find('/', first + 1);
  GivenCamera camera;
  camera.position = toPoint(option, text, text.substr(0, first));
  camera.focalPoint = toPoint(
    option, text, first == std::string::npos ? "" : text.substr(first + 1, second - first - 1));
  if (second != std::string::npos)
  {
    camera.viewUp = toPoint(option, text, text.substr(second + 1));
  }
  if (!isCamera(camera))
  {
    refuse(option, text, "a position beside the focal point and a view up across their line");
  }
  return camera;
}

double toAngle(const std::string& option, const std::string& text, double most)
{
  const auto angle = toNumber(text);
  if (!angle || !(*angle >= 0.01 && *angle <= most))
  {
    refuse(option, text, "degrees from 0.01 to " + std::to_string(static_cast<int>(most)));
  }
  return *angle;
}

/// Whether it is the dependent one.
bool toKind(const std::string& option, const std::string& text)
{
  if (text != "dependent" && text != "independent")
  {
    refuse(option, text, "dependent or independent");
  }
  return text == "dependent";
}

ValueOptions valueOptions(ViewsOptions& result)
{
  using Text = const std::string&;
  return {
    { "--isovalue", [&](Text o, Text v) { result.isovalue = toIsovalue(o, v); } },
    { "--camera", [&](Text o, Text v) { result.cameras.push_back(toCamera(o, v)); } },
    { "--view-angle",
      [&](Text o, Text v) { result.viewAngle = toAngle(o, v, GreatestViewAngle); } },
    { "--orbit", [&](Text o, Text v) { result.orbit = toInteger(o, v, 1, MostViews); } },
    { "--hemisphere", [&](Text o, Text v) { result.hemisphere = toInteger(o, v, 1, MostViews); } },
    { "--cameras", [&](Text, Text v) { result.manifest = v; } },
    { "--size", [&](Text o, Text v) { result.size = toSize(o, v); } },
    { "--kind", [&](Text o, Text v) { result.dependent = toKind(o, v); } },
    { "--extreme-angle", [&](Text o, Text v) { result.extremeAngle = toAngle(o, v, 90.0); } },
    { "--light", [&](Text o, Text v) { result.light = toLight(o, v); } },
    { "--output", [&](Text, Text v) { result.output = v; } },
    { "--up", [&](Text o, Text v) { result.up = toAxis(o, v); } },
    { "--front", [&](Text o, Text v) { result.front = toAxis(o, v); } },
  };
}

/// Combinations that cannot be meant.
void checkTogether(const ViewsOptions& options)
{
  if (options.cameras.empty() && options.orbit == 0 && options.hemisphere == 0 &&
    options.manifest.empty())
  {
    throw UserError("no camera given: --camera, --orbit, --hemisphere or --cameras");
  }
  if (options.extremeAngle && !options.dependent.value_or(false))
  {
    throw UserError("--extreme-angle needs --kind dependent");
  }
  if (!options.up.empty() && !options.front.empty() && options.up.back() == options.front.back())
  {
    throw UserError("--up " + options.up + " and --front " + options.front + " are one axis");
  }
}
} // namespace

//----------------------------------------------------------------------------
ViewsOptions parseViewsOptions(int argumentCount, char* const* arguments)
{
  ViewsOptions result;
  const auto act = [&](ViewsAction action)
  { return [&result, action] { result.action = action; }; };
  OptionTable table;
  table.program = "hachure-views";
  table.input = &result.input;
  table.values = valueOptions(result);
  table.flags = { { "--overwrite", [&] { result.overwrite = true; } } };
  table.actions = { { "--help", act(ViewsAction::Help) }, { "-h", act(ViewsAction::Help) },
    { "--version", act(ViewsAction::Version) } };
  if (!readArguments(argumentCount, arguments, table))
  {
    return result;
  }
  checkTogether(result);
  if (result.dependent.value_or(false) && !result.extremeAngle)
  {
    result.extremeAngle = UsualExtremeAngle;
  }
  return result;
}

//----------------------------------------------------------------------------
const char* viewsHelpText()
{
  return R"(usage: hachure-views INPUT --camera C|--orbit N|--hemisphere N|--cameras FILE [options]

Draws the surface of INPUT from some cameras, to be painted over, and writes for every view
NAME.png (shaded, transparent beside the surface), NAME-mask.png (white where the surface is),
NAME-depth.png (16 bits: how far it is) and, for all, views.json with the cameras.

INPUT is read by its extension: .vtp .vtu .vti .vtm .stl .obj .ply .ex2 .nii .nii.gz .slc
.nc .cdf. Volumes are drawn as an isosurface, other data sets as their outer surface.

  --isovalue V         scalar value of the isosurface; volumes need it
  --camera P/F/U       a view from P at F, upright along U, each X,Y,Z; without U along --up;
                       may be given several times
  --view-angle A       vertical angle of view of --camera, degrees (default 30)
  --orbit N            N views around the axis that points up
  --hemisphere N       N views spread over the directions above the surface
  --cameras FILE       views from the cameras of a views.json
  --size WxH           pixels of the images (default 960x720; of --cameras as they are there)
  --kind KIND          dependent: seen from near its camera alone, or independent (default; of
                       --cameras as they are there)
  --extreme-angle A    dependent views: degrees from the camera to where it is no more seen
                       (default 30)
  --light AZ,EL        key light, degrees right of and above the viewer (default -40,40)
  --output DIR         where to write, made when it does not exist (default views)
  --overwrite          replace files that are there, painted ones too
  --up AXIS            axis that points up, one of x y z -x -y -z (default by file type)
  --front AXIS         axis that points at the first camera of an orbit (default by file type)
  --version            print the version
  --help               print this text

Exit code: 0 done, 1 drawing or writing failed, 2 an argument or an input cannot be used.
)";
}
} // namespace hachure::program
