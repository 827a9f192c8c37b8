// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternMetricsInput.h"

#include "Core/Parallel.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hachure
{

namespace
{

// The scalars of an image of width x height x 1 pixels.
vtkDataArray* flatScalars(
  vtkImageData* image, const std::string& name, int dimensions[3], const char* expected)
{
  if (image == nullptr)
  {
    throw std::invalid_argument(name + ": no image");
  }
  image->GetDimensions(dimensions);
  if (dimensions[0] < 1 || dimensions[1] < 1 || dimensions[2] != 1)
  {
    throw std::invalid_argument(name + ": " + std::to_string(dimensions[0]) + " x " +
      std::to_string(dimensions[1]) + " x " + std::to_string(dimensions[2]) +
      " pixels, expected width x height x 1");
  }
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (scalars == nullptr)
  {
    throw std::invalid_argument(name + ": no point scalars, expected " + expected);
  }
  return scalars;
}

} // namespace

MetricPlanes readPlanes(
  vtkImageData* image, const std::string& name, int fewest, int most, const char* expected)
{
  int dimensions[3];
  vtkDataArray* scalars = flatScalars(image, name, dimensions, expected);
  const int components = scalars->GetNumberOfComponents();
  if (components < fewest || (most == 1 && components > 1))
  {
    throw std::invalid_argument(name + ": scalars '" +
      (scalars->GetName() != nullptr ? scalars->GetName() : "") + "' have " +
      std::to_string(components) + " components, expected " + expected);
  }
  MetricPlanes planes{ dimensions[0], dimensions[1], {} };
  const vtkIdType pixels = scalars->GetNumberOfTuples();
  for (int k = 0; k < std::min(components, most); ++k)
  {
    std::vector<float> plane(static_cast<std::size_t>(pixels));
    parallelFor(pixels,
      [&](std::int64_t i)
      { plane[static_cast<std::size_t>(i)] = static_cast<float>(scalars->GetComponent(i, k)); });
    planes.planes.push_back(std::move(plane));
  }
  return planes;
}

MotionView motionOf(const MetricPlanes& planes)
{
  MotionView motion;
  motion.width = planes.width;
  motion.height = planes.height;
  motion.u = planes.planes[0];
  motion.v = planes.planes[1];
  motion.visible = planes.planes[2];
  if (planes.planes.size() > 3)
  {
    motion.facing = planes.planes[3];
  }
  if (planes.planes.size() > 4)
  {
    motion.distance = planes.planes[4];
  }
  return motion;
}

MetricLabels readLabels(vtkImageData* image, const std::string& name)
{
  int dimensions[3];
  vtkDataArray* scalars = flatScalars(image, name, dimensions, "one number of a cell");
  if (scalars->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument(name + ": " + std::to_string(scalars->GetNumberOfComponents()) +
      " components, expected one number of a cell");
  }
  MetricLabels labels{ dimensions[0], dimensions[1], {} };
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const double value = scalars->GetComponent(i, 0);
    if (!(std::abs(value) <= 2147483647.0) || value != std::floor(value))
    {
      throw std::invalid_argument(name + ": " + std::to_string(value) + " at point " +
        std::to_string(i) + ", expected a whole number of 32 bits");
    }
    labels.values.push_back(static_cast<std::int32_t>(value));
  }
  return labels;
}

std::vector<glm::dvec2> readPlanePoints(vtkPolyData* polyData)
{
  std::vector<glm::dvec2> points;
  for (vtkIdType i = 0; i < polyData->GetNumberOfPoints(); ++i)
  {
    double point[3];
    polyData->GetPoint(i, point);
    points.emplace_back(point[0], point[1]);
  }
  return points;
}

} // namespace hachure
