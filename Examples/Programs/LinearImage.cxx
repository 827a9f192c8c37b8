// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LinearImage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hachure::program
{
namespace
{
constexpr double Gamma = 2.2;
constexpr int Channels = 3;
constexpr int ContactColumns = 4;
constexpr int ContactGap = 4;

/// Display values to linear light.
const std::array<float, 256>& decodeTable()
{
  static const auto Table = []
  {
    std::array<float, 256> table{};
    for (int i = 0; i < 256; ++i)
    {
      table[i] = static_cast<float>(std::pow(i / 255.0, Gamma));
    }
    return table;
  }();
  return Table;
}

/// Linear light to display values, indexed by the square root, which resolves the darkest steps.
constexpr int EncodeSteps = 1 << 16;
const std::vector<std::uint8_t>& encodeTable()
{
  static const auto Table = []
  {
    std::vector<std::uint8_t> table(EncodeSteps);
    for (int i = 0; i < EncodeSteps; ++i)
    {
      const double root = i / (EncodeSteps - 1.0);
      table[i] = static_cast<std::uint8_t>(std::lround(255.0 * std::pow(root, 2.0 / Gamma)));
    }
    return table;
  }();
  return Table;
}

/// The source pixels that one result pixel covers along one axis, and how much of each.
struct Coverage
{
  int first = 0;
  std::vector<float> weights;
};

std::vector<Coverage> coverages(int source, int result)
{
  std::vector<Coverage> all(result);
  const double step = static_cast<double>(source) / result;
  for (int i = 0; i < result; ++i)
  {
    const double begin = i * step;
    const double end = std::min<double>((i + 1) * step, source);
    all[i].first = static_cast<int>(begin);
    for (int k = all[i].first; k < source && k < end; ++k)
    {
      const double part = std::min(end, k + 1.0) - std::max<double>(begin, k);
      if (part > 1e-9 * step)
      {
        all[i].weights.push_back(static_cast<float>(part / step));
      }
    }
  }
  return all;
}

void addRow(const std::uint8_t* row, const std::vector<Coverage>& columns, float rowWeight,
  std::vector<float>& sums)
{
  const auto& decode = decodeTable();
  for (std::size_t x = 0; x < columns.size(); ++x)
  {
    const std::uint8_t* pixel = row + Channels * columns[x].first;
    for (const float weight : columns[x].weights)
    {
      for (int c = 0; c < Channels; ++c)
      {
        sums[Channels * x + c] += rowWeight * weight * decode[pixel[c]];
      }
      pixel += Channels;
    }
  }
}

std::uint8_t encode(float linear)
{
  const float root = std::sqrt(std::clamp(linear, 0.0f, 1.0f));
  return encodeTable()[static_cast<int>(root * (EncodeSteps - 1) + 0.5f)];
}
} // namespace

//----------------------------------------------------------------------------
Picture averagedDown(const Picture& source, int width, int height)
{
  if (width < 1 || height < 1 || width > source.width || height > source.height)
  {
    throw std::invalid_argument("averagedDown: size " + std::to_string(width) + "x" +
      std::to_string(height) + " must be from 1x1 to the source's");
  }
  Picture result{ width, height,
    std::vector<std::uint8_t>(std::size_t(width) * height * Channels) };
  const auto columns = coverages(source.width, width);
  const auto rows = coverages(source.height, height);
  std::vector<float> sums(std::size_t(width) * Channels);
  for (int y = 0; y < height; ++y)
  {
    std::fill(sums.begin(), sums.end(), 0.0f);
    int from = rows[y].first;
    for (const float weight : rows[y].weights)
    {
      addRow(&source.pixels[std::size_t(from++) * source.width * Channels], columns, weight, sums);
    }
    std::transform(
      sums.begin(), sums.end(), result.pixels.begin() + std::size_t(y) * width * Channels, encode);
  }
  return result;
}

//----------------------------------------------------------------------------
std::vector<int> contactFrames(int count)
{
  const int shown = std::min(count, ContactPictures);
  std::vector<int> frames(shown);
  for (int i = 0; i < shown; ++i)
  {
    frames[i] = static_cast<int>(static_cast<long long>(i) * count / shown);
  }
  return frames;
}

//----------------------------------------------------------------------------
Picture contactSheet(const std::vector<Picture>& thumbnails)
{
  if (thumbnails.empty())
  {
    throw std::invalid_argument("contactSheet: no pictures");
  }
  const int count = static_cast<int>(thumbnails.size());
  const int columns = std::min(count, ContactColumns);
  const int rows = (count + columns - 1) / columns;
  const int cellWidth = thumbnails[0].width;
  const int cellHeight = thumbnails[0].height;
  Picture sheet;
  sheet.width = columns * (cellWidth + ContactGap) + ContactGap;
  sheet.height = rows * (cellHeight + ContactGap) + ContactGap;
  sheet.pixels.assign(std::size_t(sheet.width) * sheet.height * Channels, 255);
  for (int i = 0; i < count; ++i)
  {
    const int left = ContactGap + (i % columns) * (cellWidth + ContactGap);
    const int bottom = ContactGap + (rows - 1 - i / columns) * (cellHeight + ContactGap);
    for (int y = 0; y < cellHeight; ++y)
    {
      const auto* row = &thumbnails[i].pixels[std::size_t(y) * cellWidth * Channels];
      std::copy(row, row + cellWidth * Channels,
        &sheet.pixels[(std::size_t(bottom + y) * sheet.width + left) * Channels]);
    }
  }
  return sheet;
}
} // namespace hachure::program
