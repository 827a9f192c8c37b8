// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VectorPageFile.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace hachure
{
namespace
{

[[noreturn]] void fail(const std::string& fileName, const std::error_code& reason)
{
  std::string message = "cannot write '";
  message += fileName;
  message += "': ";
  message += reason.message();
  throw std::runtime_error(message);
}

// Written beside the file and moved there, so that no half of it is ever found under its name.
void writeWhole(const std::string& fileName, const std::string& bytes)
{
  const std::filesystem::path path = std::filesystem::u8path(fileName);
  std::filesystem::path draft = path;
  draft += ".part";
  std::error_code error;
  errno = 0;
  std::ofstream stream(draft, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (stream.fail())
  {
    error.assign(errno != 0 ? errno : EIO, std::generic_category());
  }
  else
  {
    std::filesystem::rename(draft, path, error);
  }
  if (error)
  {
    std::error_code ignored;
    std::filesystem::remove(draft, ignored);
    fail(fileName, error);
  }
}

std::string extensionOf(const std::string& fileName)
{
  std::string extension = std::filesystem::u8path(fileName).extension().u8string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

} // namespace

void writeVectorPage(const VectorPage& page, const std::string& fileName)
{
  const std::string extension = extensionOf(fileName);
  if (extension != ".svg" && extension != ".pdf")
  {
    std::string message = "cannot write '";
    message += fileName;
    message += "': expected a name that ends with .svg or .pdf";
    throw std::invalid_argument(message);
  }
  checkVectorPage(page);
  writeWhole(fileName, extension == ".svg" ? vectorPageAsSvg(page) : vectorPageAsPdf(page));
}

} // namespace hachure
