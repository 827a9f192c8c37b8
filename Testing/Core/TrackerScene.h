// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TrackerScene_h
#define hachure_TrackerScene_h

// Spheres with exact motion and exact visibility, to test the tracker with.

#include "Core/PatternTracker.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace hachure::testing
{

constexpr double degree = 0.017453292519943295;

struct Spheres
{
  std::vector<glm::dvec3> centres; // radius 1
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
  std::vector<std::int32_t> patches;
  std::vector<double> spacing;

  // `count` samples on each sphere, on a golden spiral.
  Spheres(std::vector<glm::dvec3> sphereCentres, int count, bool patchPerSphere)
    : centres(std::move(sphereCentres))
  {
    for (std::size_t sphere = 0; sphere < this->centres.size(); ++sphere)
    {
      for (int i = 0; i < count; ++i)
      {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double turn = 137.50776405003785 * degree * i;
        const double radius = std::sqrt(1.0 - z * z);
        const glm::dvec3 normal(radius * std::cos(turn), radius * std::sin(turn), z);
        this->normals.push_back(normal);
        this->positions.push_back(this->centres[sphere] + normal);
        this->patches.push_back(patchPerSphere ? static_cast<std::int32_t>(sphere) : 0);
      }
    }
    this->spacing.assign(patchPerSphere ? this->centres.size() : 1, std::sqrt(12.5 / count));
  }

  TrackedSamples samples() const
  {
    return { this->positions, this->normals, this->patches, this->spacing };
  }

  // What an eye sees, by intersecting the lines of sight with all spheres.
  std::vector<std::uint8_t> visibility(const ViewProjection& view) const
  {
    const glm::dvec3 eye(glm::inverse(view.modelToView)[3]);
    std::vector<std::uint8_t> result;
    for (std::size_t i = 0; i < this->positions.size(); ++i)
    {
      const glm::dvec3 ray = this->positions[i] - eye;
      bool hidden = glm::dot(ray, this->normals[i]) >= 0.0;
      for (const glm::dvec3& centre : this->centres)
      {
        const glm::dvec3 arm = eye - centre;
        const double a = glm::dot(ray, ray);
        const double b = glm::dot(ray, arm);
        const double discriminant = b * b - a * (glm::dot(arm, arm) - 1.0);
        const double nearest = discriminant > 0.0 ? (-b - std::sqrt(discriminant)) / a : 2.0;
        hidden = hidden || (nearest > 0.0 && nearest < 1.0 - 1e-9);
      }
      result.push_back(hidden ? 0 : 255);
    }
    return result;
  }
};

// A camera with a view angle of 30 degrees in an image of 800 x 600 pixels.
struct Camera
{
  double azimuth = 0.0; // degrees
  double roll = 0.0;    // degrees
  double distance = 10.0;
  double pan = 0.0; // model units
  glm::dvec2 size{ 800.0, 600.0 };

  ViewProjection view() const
  {
    glm::dmat4 m(1.0);
    m = glm::rotate(m, this->roll * degree, glm::dvec3(0.0, 0.0, 1.0));
    m = glm::translate(m, glm::dvec3(this->pan, 0.0, -this->distance));
    m = glm::rotate(m, this->azimuth * degree, glm::dvec3(0.0, 1.0, 0.0));
    const double aspect = this->size.x / this->size.y;
    return { m, glm::perspective(30.0 * degree, aspect, 0.1, 100.0), this->size };
  }
};

} // namespace hachure::testing

#endif
