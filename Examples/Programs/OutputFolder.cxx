// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OutputFolder.h"

#include "UserError.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

namespace hachure::program
{
namespace
{
[[noreturn]] void refuseFolder(const std::filesystem::path& folder, const std::string& reason)
{
  throw UserError("cannot write into '" + folder.string() + "': " + reason);
}
} // namespace

//----------------------------------------------------------------------------
void checkWritableFolder(const std::filesystem::path& folder)
{
  if (folder.empty())
  {
    throw UserError("--output names no folder");
  }
  std::error_code error;
  std::filesystem::path nearest = std::filesystem::absolute(folder);
  while (!std::filesystem::exists(nearest, error) && nearest.has_relative_path())
  {
    nearest = nearest.parent_path();
  }
  if (!std::filesystem::is_directory(nearest, error))
  {
    refuseFolder(folder, "'" + nearest.string() + "' is not a folder");
  }
  if (access(nearest.c_str(), W_OK | X_OK) != 0)
  {
    refuseFolder(folder, std::strerror(errno));
  }
}

//----------------------------------------------------------------------------
bool makeWritableFolder(const std::filesystem::path& folder)
{
  checkWritableFolder(folder);
  std::error_code error;
  const bool made = std::filesystem::create_directories(folder, error);
  if (error)
  {
    refuseFolder(folder, error.message());
  }
  const auto probe = folder / ".probe.part";
  if (!std::ofstream(probe))
  {
    refuseFolder(folder, std::strerror(errno));
  }
  std::filesystem::remove(probe, error);
  return made;
}
} // namespace hachure::program
