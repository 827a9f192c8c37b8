// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleCanvas_h
#define hachure_StippleCanvas_h

#include "Span.h"

#include <cstdint>
#include <vector>

namespace hachure
{

// Pixels, y up; the pixel in column i and row j is from (i, j) to (i + 1, j + 1).
struct StippleDisc
{
  float x = 0.0f, y = 0.0f;
  float radius = 0.0f;
};

// The share of every pixel that discs cover together: where discs overlap, it counts once. Found
// at 64 places in a pixel, no two of them in one column, so that the ink of discs adds up to their
// area whatever their size. Keeps its memory from picture to picture.
class StippleCanvas
{
public:
  static constexpr int samplesPerPixel = 64;

  // Sets the number of covered places of each pixel, row by row from the bottom. Discs that are not
  // finite or have no radius are left out. The order of discs does not matter. Throws
  // std::invalid_argument for a negative size.
  void draw(
    Span<const StippleDisc> discs, int width, int height, std::vector<std::uint8_t>& covered);

private:
  void sortByBands(Span<const StippleDisc> discs, int bands);
  void drawBand(Span<const StippleDisc> discs, std::size_t band, int height);
  void drawRow(std::size_t row, float center, float halfWidth, int columns);
  void count(std::size_t row, int width, std::uint8_t* covered) const;

  std::size_t stride = 0;              // bytes of a row of places, one for every pixel
  std::vector<std::uint8_t> places;    // a bit each, eight rows for every row of pixels
  std::vector<std::int32_t> firstDisc; // of every band of rows
  std::vector<std::int32_t> members;   // discs, by band
};

} // namespace hachure

#endif
