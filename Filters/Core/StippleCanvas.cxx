// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleCanvas.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

constexpr int rowsPerPixel = 8;
constexpr int columnsPerPixel = 8;
constexpr int bandHeight = 16; // pixels
constexpr std::size_t wordBytes = sizeof(std::uint64_t);
constexpr std::uint64_t allPlaces = ~std::uint64_t{ 0 };

// Rows of places are shifted against each other, by eighths of the distance between two places:
// upright edges are as fine as level ones are on the whole.
constexpr float rowShift[rowsPerPixel] = { 0.0625f, 0.5625f, 0.3125f, 0.8125f, 0.1875f, 0.6875f,
  0.4375f, 0.9375f };

bool isDrawn(const StippleDisc& disc)
{
  return disc.radius > 0.0f && std::isfinite(disc.x) && std::isfinite(disc.y) &&
    std::isfinite(disc.radius);
}

// The bands that a disc meets, of those there are.
struct Bands
{
  Bands(const StippleDisc& disc, int count)
    : first(bandOf(disc.y - disc.radius, 0, count))
    , last(bandOf(disc.y + disc.radius, -1, count - 1))
  {
  }
  static int bandOf(float y, int least, int most)
  {
    return static_cast<int>(
      std::clamp(std::floor(y / bandHeight), static_cast<float>(least), static_cast<float>(most)));
  }
  int first, last; // none where last < first
};

std::uint64_t bytePopulations(std::uint64_t word)
{
  word -= word >> 1 & 0x5555555555555555ull;
  word = (word & 0x3333333333333333ull) + (word >> 2 & 0x3333333333333333ull);
  return (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0full;
}

} // namespace

void StippleCanvas::draw(
  Span<const StippleDisc> discs, int width, int height, std::vector<std::uint8_t>& covered)
{
  if (width < 0 || height < 0)
  {
    throw std::invalid_argument(
      "canvas is " + std::to_string(width) + " x " + std::to_string(height) + "; expected >= 0");
  }
  covered.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  // Whole words, and one more for what a row's last word sticks out.
  this->stride = (static_cast<std::size_t>(width) / wordBytes + 2) * wordBytes;
  this->places.resize(this->stride * static_cast<std::size_t>(height * rowsPerPixel));
  const int bands = (height + bandHeight - 1) / bandHeight;
  this->sortByBands(discs, bands);
  parallelForRanges(bands, 1,
    [&](std::int64_t band, std::int64_t)
    {
      this->drawBand(discs, static_cast<std::size_t>(band), height);
      const int end = std::min(height, (static_cast<int>(band) + 1) * bandHeight);
      for (int row = static_cast<int>(band) * bandHeight; row < end; ++row)
      {
        this->count(static_cast<std::size_t>(row), width,
          covered.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(width));
      }
    });
}

void StippleCanvas::sortByBands(Span<const StippleDisc> discs, int bands)
{
  this->firstDisc.assign(static_cast<std::size_t>(bands) + 1, 0);
  const auto forBands = [&](auto&& visit)
  {
    for (std::size_t i = 0; i < discs.size(); ++i)
    {
      if (isDrawn(discs[i]))
      {
        const Bands met(discs[i], bands);
        for (int band = met.first; band <= met.last; ++band)
        {
          visit(static_cast<std::size_t>(band), static_cast<std::int32_t>(i));
        }
      }
    }
  };
  forBands([this](std::size_t band, std::int32_t) { ++this->firstDisc[band]; });
  std::int32_t total = 0;
  for (std::int32_t& entry : this->firstDisc)
  {
    total += entry;
    entry = total;
  }
  this->members.resize(static_cast<std::size_t>(total));
  forBands([this](std::size_t band, std::int32_t disc)
    { this->members[static_cast<std::size_t>(--this->firstDisc[band])] = disc; });
}

void StippleCanvas::drawBand(Span<const StippleDisc> discs, std::size_t band, int height)
{
  const int begin = static_cast<int>(band) * bandHeight * rowsPerPixel;
  const int end = std::min(height * rowsPerPixel, begin + bandHeight * rowsPerPixel);
  std::memset(this->places.data() + static_cast<std::size_t>(begin) * this->stride, 0,
    static_cast<std::size_t>(end - begin) * this->stride);
  const int columns = static_cast<int>(this->stride - wordBytes) * columnsPerPixel;
  for (std::int32_t k = this->firstDisc[band]; k < this->firstDisc[band + 1]; ++k)
  {
    const StippleDisc& disc =
      discs[static_cast<std::size_t>(this->members[static_cast<std::size_t>(k)])];
    const float top =
      std::min(static_cast<float>(end), (disc.y + disc.radius) * rowsPerPixel - 0.5f);
    const float square = disc.radius * disc.radius;
    const float low =
      std::max(static_cast<float>(begin), (disc.y - disc.radius) * rowsPerPixel - 0.5f);
    for (int row = static_cast<int>(std::ceil(low)); row < end && static_cast<float>(row) <= top;
         ++row)
    {
      const float away = (static_cast<float>(row) + 0.5f) / rowsPerPixel - disc.y;
      const float halfWidth = std::sqrt(std::max(0.0f, square - away * away));
      this->drawRow(static_cast<std::size_t>(row), disc.x, halfWidth, columns);
    }
  }
}

void StippleCanvas::drawRow(std::size_t row, float center, float halfWidth, int columns)
{
  const float shift = rowShift[row % rowsPerPixel];
  const auto most = static_cast<float>(columns - 1);
  const float low = std::max(0.0f, (center - halfWidth) * columnsPerPixel - shift);
  const float high = std::min(most, (center + halfWidth) * columnsPerPixel - shift);
  if (!(high >= 0.0f && low <= high))
  {
    return;
  }
  auto place = static_cast<std::int32_t>(std::ceil(low));
  const auto last = static_cast<std::int32_t>(high);
  std::uint8_t* const bytes = this->places.data() + row * this->stride;
  // A word from the byte of its first place on holds at least 57 of them.
  constexpr std::int32_t atOnce = 57;
  for (; place <= last; place += atOnce)
  {
    const std::int32_t count = std::min(atOnce, last - place + 1);
    std::uint8_t* const target = bytes + place / columnsPerPixel;
    std::uint64_t word;
    std::memcpy(&word, target, wordBytes);
    word |= (allPlaces >> (static_cast<std::int32_t>(wordBytes) * columnsPerPixel - count))
      << (place % columnsPerPixel);
    std::memcpy(target, &word, wordBytes);
  }
}

void StippleCanvas::count(std::size_t row, int width, std::uint8_t* covered) const
{
  const std::uint8_t* const first = this->places.data() + row * rowsPerPixel * this->stride;
  const auto columns = static_cast<std::size_t>(width);
  for (std::size_t column = 0; column < columns; column += wordBytes)
  {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < rowsPerPixel; ++i)
    {
      std::uint64_t word;
      std::memcpy(&word, first + i * this->stride + column, wordBytes);
      sum += bytePopulations(word);
    }
    std::memcpy(covered + column, &sum, std::min(wordBytes, columns - column));
  }
}

} // namespace hachure
