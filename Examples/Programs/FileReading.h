// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Opens any supported file with VTK's reader for its extension.

#ifndef FileReading_h
#define FileReading_h

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <string>

namespace hachure::program
{
/// Throws UserError when the file is missing, of an unknown type, or refused by its reader.
vtkSmartPointer<vtkDataObject> readFile(const std::string& path);

std::string lowerCase(std::string text);
} // namespace hachure::program

#endif
