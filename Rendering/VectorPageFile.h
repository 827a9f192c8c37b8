// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VectorPageFile_h
#define VectorPageFile_h

#include "HachureRenderingModule.h" // for the export macro
#include "VectorPage.h"

#include <string>

namespace hachure
{

/** Writes a page in millimetres to a file, .svg or .pdf by its name (upper case, too). The file is
 * complete or not there: what cannot be finished leaves a file of that name as it was. Throws
 * std::invalid_argument for another extension and as checkVectorPage does, std::runtime_error with
 * the name and the reason where writing fails, and for PDF in a build without Cairo. */
HACHURERENDERING_EXPORT void writeVectorPage(const VectorPage& page, const std::string& fileName);

/** The page as the text of an SVG file. The user unit is the millimetre; discs are circle elements
 * in one group for every run of the same ink, strokes are paths. */
std::string vectorPageAsSvg(const VectorPage& page);

/** The page as the bytes of a PDF file of one sheet. Discs are four Bezier curves each. */
std::string vectorPageAsPdf(const VectorPage& page);

} // namespace hachure

#endif
// VTK-HeaderTest-Exclude: VectorPageFile.h
