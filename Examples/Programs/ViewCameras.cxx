// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewCameras.h"

#include "ErrorCollector.h"
#include "UserError.h"
#include "ViewFit.h"

#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkTextureViewsManifest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace hachure::program
{
namespace
{
constexpr std::array<int, 2> UsualSize = { 960, 720 };
/// Turn from one view of a hemisphere to the next, in degrees, that spreads any number of them.
constexpr double GoldenAngle = 137.50776405003785;

/// "orbit-07" of 12.
std::string numbered(const std::string& stem, int index, int count)
{
  const std::string digits = std::to_string(index + 1);
  std::string name = stem + "-";
  name.append(std::to_string(count).size() - digits.size(), '0');
  return name.append(digits);
}

/// A name that files can have, other than all before.
std::string fileName(const std::string& wanted, std::set<std::string>& taken)
{
  std::string stem = wanted.empty() ? "view" : wanted;
  std::replace_if(
    stem.begin(), stem.end(),
    [](unsigned char letter) { return !std::isalnum(letter) && letter != '-'; }, '_');
  std::string name = stem;
  for (int i = 2; !taken.insert(name).second; ++i)
  {
    name = stem;
    name.append("-").append(std::to_string(i));
  }
  return name;
}

vtkSmartPointer<vtkCamera> givenCamera(
  const GivenCamera& given, double viewAngle, const glm::dvec3& upright)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(given.position.data());
  camera->SetFocalPoint(given.focalPoint.data());
  const std::array<double, 3> up =
    given.viewUp.value_or(std::array<double, 3>{ upright.x, upright.y, upright.z });
  double across[3];
  vtkMath::Cross(camera->GetDirectionOfProjection(), up.data(), across);
  if (vtkMath::Norm(across) < 1e-9)
  {
    throw UserError("a --camera looks along the axis that points up: give its view up too");
  }
  camera->SetViewUp(up.data());
  camera->SetViewAngle(viewAngle);
  return camera;
}

/// Cameras around a surface that show all of it.
class FittedCameras
{
public:
  FittedCameras(const ViewsOptions& options, const Surface& surface)
    : turntable(makeTurntable(options.up.empty() ? surface.up : options.up,
        options.front.empty() ? surface.front : options.front))
    , points(fitPoints(surface.data, options.input))
    , size(options.size.value_or(UsualSize))
  {
  }

  const glm::dvec3& up() const { return this->turntable.up; }

  /// Around the axis that points up, all as far away.
  void addOrbit(int count, std::vector<ViewCamera>& cameras)
  {
    std::vector<double> azimuths;
    azimuths.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
    {
      azimuths.push_back(360.0 * i / count);
    }
    this->fit(azimuths, 0.0);
    for (int i = 0; i < count; ++i)
    {
      this->add(numbered("orbit", i, count), azimuths[i], 0.0, cameras);
    }
  }

  /// Evenly over the hemisphere of directions above, every one as near as it can be.
  void addHemisphere(int count, std::vector<ViewCamera>& cameras)
  {
    for (int i = 0; i < count; ++i)
    {
      const double azimuth = std::fmod(GoldenAngle * i, 360.0);
      const double elevation = vtkMath::DegreesFromRadians(std::asin((i + 0.5) / count));
      this->fit({ azimuth }, elevation);
      this->add(numbered("hemisphere", i, count), azimuth, elevation, cameras);
    }
  }

private:
  void fit(const std::vector<double>& azimuths, double elevation)
  {
    const double aspect = static_cast<double>(this->size[0]) / this->size[1];
    fitTurntable(this->turntable, this->points, azimuths, elevation, aspect);
  }

  void add(const std::string& name, double azimuth, double elevation,
    std::vector<ViewCamera>& cameras) const
  {
    TurntableView view;
    view.azimuth = azimuth;
    view.elevation = elevation;
    auto camera = vtkSmartPointer<vtkCamera>::New();
    placeCamera(camera, this->turntable, view);
    cameras.push_back({ name, camera, this->size });
  }

  Turntable turntable;
  std::vector<glm::dvec3> points;
  std::array<int, 2> size;
};

void addSource(
  const ViewsOptions& options, vtkTextureViews* source, std::vector<ViewCamera>& cameras)
{
  for (int i = 0; i < source->GetNumberOfViews(); ++i)
  {
    vtkCamera* camera = source->GetViewCamera(i);
    if (!camera)
    {
      throw UserError("the view '" + source->GetViewName(i) + "' of '" + options.manifest +
        "' has a matrix, not a camera");
    }
    const int* size = source->GetViewImage(i)->GetDimensions();
    cameras.push_back({ source->GetViewName(i), camera,
      options.size.value_or(std::array<int, 2>{ size[0], size[1] }), i });
  }
}
} // namespace

//----------------------------------------------------------------------------
vtkSmartPointer<vtkTextureViews> readSource(const ViewsOptions& options)
{
  if (options.manifest.empty())
  {
    return nullptr;
  }
  const ErrorCollector errors;
  auto views = vtkSmartPointer<vtkTextureViews>::New();
  vtkNew<vtkTextureViewsManifest> manifest;
  if (!manifest->Read(options.manifest.c_str(), views))
  {
    throw UserError("cannot use '" + options.manifest + "': " + manifest->GetError());
  }
  return views;
}

//----------------------------------------------------------------------------
std::vector<ViewCamera> viewCameras(
  const ViewsOptions& options, const Surface& surface, vtkTextureViews* source)
{
  std::vector<ViewCamera> cameras;
  FittedCameras fitted(options, surface);
  const int given = static_cast<int>(options.cameras.size());
  cameras.reserve(options.cameras.size());
  for (int i = 0; i < given; ++i)
  {
    cameras.push_back({ numbered("camera", i, given),
      givenCamera(options.cameras[i], options.viewAngle, fitted.up()),
      options.size.value_or(UsualSize) });
  }
  if (options.orbit > 0)
  {
    fitted.addOrbit(options.orbit, cameras);
  }
  fitted.addHemisphere(options.hemisphere, cameras);
  if (source)
  {
    addSource(options, source, cameras);
  }
  std::set<std::string> taken;
  for (ViewCamera& camera : cameras)
  {
    camera.name = fileName(camera.name, taken);
  }
  return cameras;
}

//----------------------------------------------------------------------------
std::array<std::array<double, 3>, 4> extremePoints(vtkCamera* camera, double angle)
{
  const auto vector = [](const double* p) { return glm::dvec3(p[0], p[1], p[2]); };
  const glm::dvec3 centre = vector(camera->GetFocalPoint());
  const glm::dvec3 back = vector(camera->GetPosition()) - centre;
  const glm::dvec3 right = glm::normalize(glm::cross(vector(camera->GetViewUp()), back));
  const glm::dvec3 above = glm::normalize(glm::cross(back, right));
  const double radians = vtkMath::RadiansFromDegrees(angle);
  std::array<std::array<double, 3>, 4> points;
  std::size_t next = 0;
  for (const glm::dvec3& aside : { above, right, -above, -right })
  {
    const glm::dvec3 point =
      centre + std::cos(radians) * back + std::sin(radians) * glm::length(back) * aside;
    points[next++] = { point.x, point.y, point.z };
  }
  return points;
}
} // namespace hachure::program
