// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureViewThumbnail.h"

#include "ViewTexture.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

namespace hachure
{
namespace
{
// Bytes of an image of 8 bits, row by row.
struct Bytes
{
  const unsigned char* values = nullptr;
  int components = 0;
  int width = 0;

  explicit Bytes(vtkImageData* image)
  {
    if (image)
    {
      vtkDataArray* scalars = image->GetPointData()->GetScalars();
      this->values = static_cast<const unsigned char*>(scalars->GetVoidPointer(0));
      this->components = scalars->GetNumberOfComponents();
      this->width = image->GetDimensions()[0];
    }
  }

  const unsigned char* at(int x, int y) const
  {
    return this->values + (static_cast<std::ptrdiff_t>(y) * this->width + x) * this->components;
  }
};

// Colour times alpha, and alpha, each 0 to 255.
std::array<double, 4> pixelAt(const Bytes& picture, const Bytes& mask, int x, int y)
{
  const unsigned char* value = picture.at(x, y);
  const bool hasAlpha = picture.components % 2 == 0;
  const int colors = picture.components - (hasAlpha ? 1 : 0);
  double alpha = hasAlpha ? value[colors] / 255.0 : 1.0;
  alpha *= mask.values ? *mask.at(x, y) / 255.0 : 1.0;
  return { alpha * value[0], alpha * value[colors == 3 ? 1 : 0], alpha * value[colors == 3 ? 2 : 0],
    alpha * 255.0 };
}

struct Box
{
  int x[2];
  int y[2];
};

void writeMean(const Bytes& picture, const Bytes& mask, const Box& box, unsigned char* result)
{
  std::array<double, 4> sum{};
  for (int y = box.y[0]; y < box.y[1]; ++y)
  {
    for (int x = box.x[0]; x < box.x[1]; ++x)
    {
      const std::array<double, 4> pixel = pixelAt(picture, mask, x, y);
      std::transform(sum.begin(), sum.end(), pixel.begin(), sum.begin(), std::plus<>());
    }
  }
  const double count = static_cast<double>(box.x[1] - box.x[0]) * (box.y[1] - box.y[0]);
  const double alpha = std::max(sum[3] / 255.0, 1e-6);
  for (int i = 0; i < 4; ++i)
  {
    const double value = sum[i] / (i < 3 ? alpha : count);
    result[i] = static_cast<unsigned char>(std::lround(std::min(value, 255.0)));
  }
}
} // namespace

vtkSmartPointer<vtkImageData> viewThumbnail(vtkImageData* picture, vtkImageData* mask, int most)
{
  const int* size = picture->GetDimensions();
  const double scale = std::max({ 1.0, double(size[0]) / most, double(size[1]) / most });
  const int width = std::max(1, static_cast<int>(size[0] / scale));
  const int height = std::max(1, static_cast<int>(size[1] / scale));
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetDimensions(width, height, 1);
  result->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<unsigned char*>(result->GetScalarPointer());
  const Bytes from(picture);
  const Bytes masked(mask);
  const auto edge = [](int index, int count, int pixels)
  { return static_cast<int>(static_cast<std::int64_t>(index) * pixels / count); };
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x, pixel += 4)
    {
      const Box box{ { edge(x, width, size[0]), edge(x + 1, width, size[0]) },
        { edge(y, height, size[1]), edge(y + 1, height, size[1]) } };
      writeMean(from, masked, box, pixel);
    }
  }
  return result;
}

std::array<double, 3> viewColor(int view)
{
  const glm::u8vec4 color = coverageColor(static_cast<std::size_t>(view));
  return { color.r / 255.0, color.g / 255.0, color.b / 255.0 };
}

} // namespace hachure
