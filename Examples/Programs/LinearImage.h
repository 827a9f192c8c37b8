// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// 8 bit RGB pictures, rows from the bottom up, made smaller by averaging in linear light.

#ifndef LinearImage_h
#define LinearImage_h

#include <cstdint>
#include <vector>

namespace hachure::program
{
struct Picture
{
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels; ///< width * height * 3
};

/// Every result pixel is the area-weighted mean of what it covers, taken in linear light
/// (gamma 2.2). The result must not be larger than the source on either side.
Picture averagedDown(const Picture& source, int width, int height);

/// About a dozen of the given thumbnails (all of one size) in rows on white.
Picture contactSheet(const std::vector<Picture>& thumbnails);

/// Which of count frames the contact sheet shows, evenly spread, at most ContactPictures.
std::vector<int> contactFrames(int count);

constexpr int ContactPictures = 12;
} // namespace hachure::program

#endif
