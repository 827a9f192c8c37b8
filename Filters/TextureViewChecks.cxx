// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureViewChecks.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace hachure
{
namespace
{
// Sine of the angle below which two directions count as one: the picture's upright is lost in
// rounding.
constexpr double leastSine = 1e-9;

// Degrees; VTK's cameras go a little further down.
constexpr double leastViewAngle = 1e-6;
constexpr double greatestViewAngle = 179.0;

std::string text(const double vector[3])
{
  std::ostringstream out;
  out << "(" << vector[0] << ", " << vector[1] << ", " << vector[2] << ")";
  return out.str();
}

std::string size(vtkImageData* image)
{
  const int* dimensions = image->GetDimensions();
  return std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]);
}

// What is wrong with an image of one slice of a type, with at most so many components.
std::string pictureFault(vtkImageData* image, int type, const char* typeName, int most)
{
  std::ostringstream out;
  if (!image)
  {
    return "expected an image, got null";
  }
  const int* dimensions = image->GetDimensions();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (dimensions[0] < 1 || dimensions[1] < 1 || dimensions[2] != 1)
  {
    out << "expected an image of one slice, got " << size(image) << " x " << dimensions[2];
  }
  else if (!scalars || scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    out << "expected an image with point scalars, got none";
  }
  else if (scalars->GetDataType() != type)
  {
    out << "expected " << typeName << " scalars, got " << scalars->GetDataTypeAsString();
  }
  else if (scalars->GetNumberOfComponents() < 1 || scalars->GetNumberOfComponents() > most)
  {
    out << "expected 1" << (most > 1 ? " to " + std::to_string(most) : "") << " components, got "
        << scalars->GetNumberOfComponents();
  }
  return out.str();
}

// The determinant and the sum of the sizes of its terms, against which it is rounded.
std::array<double, 2> determinant(vtkMatrix4x4* matrix)
{
  std::array<int, 4> columns{ 0, 1, 2, 3 };
  std::array<double, 2> sums{ 0.0, 0.0 };
  do
  {
    double term = 1.0;
    for (int row = 0; row < 4; ++row)
    {
      term *= matrix->GetElement(row, columns[row]);
      for (int before = 0; before < row; ++before)
      {
        term = columns[before] > columns[row] ? -term : term;
      }
    }
    sums[0] += term;
    sums[1] += std::abs(term);
  } while (std::next_permutation(columns.begin(), columns.end()));
  return sums;
}
} // namespace

//------------------------------------------------------------------------------
std::string vectorFault(const double vector[3])
{
  const bool finite =
    std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
  return finite ? "" : "expected three finite numbers, got " + text(vector);
}

//------------------------------------------------------------------------------
std::string directionFault(const double direction[3])
{
  const double length = vtkMath::Norm(direction);
  if (length > 0.0 && std::isfinite(length))
  {
    return "";
  }
  return "expected a direction, three finite numbers, got " + text(direction);
}

//------------------------------------------------------------------------------
std::string cameraFault(const ViewCamera& camera)
{
  for (const double* vector : { camera.position, camera.focalPoint, camera.viewUp })
  {
    std::string fault = vectorFault(vector);
    if (!fault.empty())
    {
      return fault;
    }
  }
  double direction[3];
  vtkMath::Subtract(camera.focalPoint, camera.position, direction);
  const double distance = vtkMath::Norm(direction);
  if (!std::isfinite(distance))
  {
    return "the focal point is too far from the position " + text(camera.position);
  }
  if (distance < 1e-18) // VTK moves the focal point then
  {
    return "the position is the focal point " + text(camera.focalPoint);
  }
  double side[3];
  vtkMath::Cross(direction, camera.viewUp, side);
  const double length = distance * vtkMath::Norm(camera.viewUp);
  if (!(vtkMath::Norm(side) > leastSine * length) || !std::isfinite(length))
  {
    return "the view up " + text(camera.viewUp) + " does not point across the direction of view";
  }
  std::ostringstream out;
  if (camera.parallel
      ? !(camera.parallelScale > 0.0 && std::isfinite(camera.parallelScale))
      : !(camera.viewAngle >= leastViewAngle && camera.viewAngle <= greatestViewAngle))
  {
    out << (camera.parallel ? "expected a parallel scale above 0, got "
                            : "expected a view angle of 1e-6 to 179 degrees, got ")
        << (camera.parallel ? camera.parallelScale : camera.viewAngle);
  }
  return out.str();
}

//------------------------------------------------------------------------------
std::string matrixFault(vtkMatrix4x4* matrix)
{
  if (!matrix)
  {
    return "expected a matrix, got null";
  }
  const double* numbers = matrix->GetData();
  if (!std::all_of(numbers, numbers + 16, [](double number) { return std::isfinite(number); }))
  {
    return "expected 16 finite numbers";
  }
  // Each of the 24 terms has 4 factors: a determinant below this is rounding alone.
  constexpr double rounding = 32.0 * std::numeric_limits<double>::epsilon();
  const auto sums = determinant(matrix);
  if (!(std::abs(sums[0]) > rounding * sums[1]) || !std::isfinite(sums[1]))
  {
    std::ostringstream out;
    out << "the matrix is singular, its determinant is " << sums[0];
    return out.str();
  }
  return "";
}

//------------------------------------------------------------------------------
std::string imageFault(vtkImageData* image)
{
  return pictureFault(image, VTK_UNSIGNED_CHAR, "8-bit", 4);
}

//------------------------------------------------------------------------------
std::string depthFault(vtkImageData* depth)
{
  return pictureFault(depth, VTK_UNSIGNED_SHORT, "16-bit", 1);
}

//------------------------------------------------------------------------------
std::string sizeFault(const std::string& name, vtkImageData* first, vtkImageData* other)
{
  if (!first || !other || size(first) == size(other))
  {
    return "";
  }
  return "expected the size of the " + name + ", " + size(first) + ", got " + size(other);
}

//------------------------------------------------------------------------------
double aspect(vtkImageData* image)
{
  return static_cast<double>(image->GetDimensions()[0]) / image->GetDimensions()[1];
}

} // namespace hachure
