// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// The strict comparison sees what VTK's usual one does not: the direction and spacing of strokes.

#include "StrictImageComparison.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace
{

// Dark grey strokes on white, 4 px wide, anti-aliased over a pixel.
vtkSmartPointer<vtkImageData> hatch(double degrees, double period)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int size = 300;
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      const double across = (-x * std::sin(angle) + y * std::cos(angle)) / period;
      const double distance = std::abs(across - std::round(across)) * period;
      const double ink = std::clamp(2.0 - distance + 0.5, 0.0, 1.0);
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      std::fill(pixel, pixel + 3, static_cast<unsigned char>(std::lround(255.0 - 195.0 * ink)));
    }
  }
  return image;
}

double usualError(vtkImageData* image, vtkImageData* expected)
{
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(image);
  difference->SetImageData(expected);
  difference->Update();
  return difference->GetThresholdedError();
}

bool check(bool condition, const char* what, double value)
{
  if (!condition)
  {
    std::cerr << what << ": " << value << "\n";
  }
  return condition;
}

} // namespace

int TestStrictImageComparison(int, char*[])
{
  // vtkTesting accepts a picture whose error stays below this.
  const double usuallyAccepted = 10.0;
  const auto expected = hatch(0.0, 8.0);
  const auto turned = hatch(10.0, 8.0);
  const auto spaced = hatch(0.0, 9.0);
  const auto slightlyTurned = hatch(0.5, 8.0);
  bool good = true;
  good &= check(usualError(turned, expected) < usuallyAccepted,
    "usual metric, turned by 10 degrees", usualError(turned, expected));
  good &= check(usualError(spaced, expected) < usuallyAccepted, "usual metric, 9 px for 8 px",
    usualError(spaced, expected));
  const double same = strict::imageError(hatch(0.0, 8.0), expected);
  good &= check(same == 0.0, "strict metric, equal pictures", same);
  for (const auto& other : { turned, spaced, slightlyTurned })
  {
    const double error = strict::imageError(other, expected);
    good &= check(error > 10000.0, "strict metric, another picture", error);
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
