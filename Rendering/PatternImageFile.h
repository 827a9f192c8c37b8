// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PatternImageFile_h
#define PatternImageFile_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace hachure
{

/** Reads a picture of one slice; throws std::runtime_error naming the file and the reason. */
vtkSmartPointer<vtkImageData> readPatternImage(const std::string& fileName);

/**
 * Writes an image of 8 or 16 bits as PNG, whatever the file is called; throws std::runtime_error
 * naming the file.
 */
void writePatternImage(vtkImageData* image, const std::string& fileName);

/** The mean of the colour components of every pixel, row by row from the bottom. */
struct GreyImage
{
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/** Throws std::invalid_argument where this is null or no image of one slice with scalars; `purpose`
 * says what it is for. */
GreyImage greyImage(vtkImageData* image, const std::string& purpose);

} // namespace hachure

#endif
