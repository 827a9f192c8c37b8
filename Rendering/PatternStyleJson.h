// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PatternStyleJson_h
#define PatternStyleJson_h

#include <string>

class vtkPatternStyle;

namespace hachure
{

/**
 * Gives a style the parameters and layers of a JSON text. Names of files in it are relative to
 * folder, or to the working directory when that is empty. Throws StyleError, whose text starts
 * with the path in the JSON, and then leaves the style as it was.
 */
void readStyle(const std::string& text, const std::string& folder, vtkPatternStyle* style);

/**
 * JSON text with every parameter of a style. Names of files are written relative to folder unless
 * that is empty. Throws StyleError when a layer has an image without a file.
 */
std::string writeStyle(vtkPatternStyle* style, const std::string& folder);

/**
 * Makes a style equal to another one. Layers of the same type in the same place stay the objects
 * that they are, and nothing is modified that is equal already; images and views are shared.
 */
void copyStyle(vtkPatternStyle* source, vtkPatternStyle* target);

} // namespace hachure

#endif
