// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef NoiseInkSums_h
#define NoiseInkSums_h

#include <vector>

class vtkImageData;

namespace hachure
{

/** A picture that says the ink of every value of a noise (across) and every tone (up), summed up
 * along its rows, so that a pixel gets the mean over all values in it: row by row from the bottom,
 * columns + 1 sums each, from 0 to the mean ink of the row. */
struct NoiseInkSums
{
  int columns = 0; // of sums
  int rows = 0;
  std::vector<float> values;
};

/** Throws std::invalid_argument, saying why, where this is no image of one slice with scalars, is
 * too large, or is darker than black or brighter than white. */
NoiseInkSums noiseInkSums(vtkImageData* image);

} // namespace hachure

#endif
