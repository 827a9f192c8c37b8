// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseInkSums.h"

#include "PatternImageFile.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <stdexcept>
#include <string>

namespace
{
constexpr int mostTexels = 4096; // across and up: what every OpenGL has room for

[[noreturn]] void refuse(const std::string& expected, const std::string& found)
{
  throw std::invalid_argument(
    std::string("image: expected ").append(expected).append(", found ").append(found));
}

// What counts as white.
double White(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const int type = scalars->GetDataType();
  return type == VTK_FLOAT || type == VTK_DOUBLE ? 1.0 : scalars->GetDataTypeMax();
}
} // namespace

namespace hachure
{

NoiseInkSums noiseInkSums(vtkImageData* image)
{
  const GreyImage grey = greyImage(image, "thresholds");
  if (grey.width > mostTexels || grey.height > mostTexels)
  {
    refuse("at most " + std::to_string(mostTexels) + " columns and rows",
      std::to_string(grey.width) + " x " + std::to_string(grey.height));
  }
  const double white = White(image);
  NoiseInkSums sums{ grey.width + 1, grey.height, {} };
  sums.values.reserve(static_cast<std::size_t>(sums.columns) * static_cast<std::size_t>(sums.rows));
  for (std::size_t i = 0; i < grey.values.size(); ++i)
  {
    const double brightness = grey.values[i] / white;
    if (!(brightness >= 0.0 && brightness <= 1.0))
    {
      refuse("brightness from 0 to 1", std::to_string(brightness));
    }
    if (i % static_cast<std::size_t>(grey.width) == 0)
    {
      sums.values.push_back(0.0f);
    }
    sums.values.push_back(sums.values.back() + static_cast<float>((1.0 - brightness) / grey.width));
  }
  return sums;
}

} // namespace hachure
