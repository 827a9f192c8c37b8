// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PatternImageFile_h
#define PatternImageFile_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace hachure
{

/** Reads a picture of one slice; throws std::runtime_error naming the file and the reason. */
vtkSmartPointer<vtkImageData> readPatternImage(const std::string& fileName);

} // namespace hachure

#endif
