// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// The folder that a program writes into.

#ifndef OutputFolder_h
#define OutputFolder_h

#include <filesystem>

namespace hachure::program
{
/// Throws UserError when the folder can neither be written nor made. Makes nothing.
void checkWritableFolder(const std::filesystem::path& folder);

/// Makes the folder and tries to write there; whether it was not there before. Throws UserError.
bool makeWritableFolder(const std::filesystem::path& folder);
} // namespace hachure::program

#endif
