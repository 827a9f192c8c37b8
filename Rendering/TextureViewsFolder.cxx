// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureViewsFolder.h"

#include "PatternImageFile.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace fs = std::filesystem;

namespace
{

std::string quoted(const fs::path& path)
{
  return "\"" + path.string() + "\"";
}

/** A view's name as the beginning of a file's: what shells and other systems mind becomes "_". */
std::string fileStem(const std::string& view)
{
  std::string stem = view.empty() ? "view" : view;
  std::replace_if(
    stem.begin(), stem.end(),
    [](unsigned char letter) { return !std::isalnum(letter) && letter != '-'; }, '_');
  return stem;
}

fs::path partOf(const fs::path& file)
{
  return file.parent_path() / ("." + file.filename().string() + ".part");
}

/** Not a folder that is in the way. */
void removeFile(const fs::path& path)
{
  std::error_code ignored;
  if (fs::is_regular_file(fs::symlink_status(path, ignored)))
  {
    fs::remove(path, ignored);
  }
}

bool isBelow(const fs::path& file, const fs::path& folder)
{
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
    folder.end();
}

} // namespace

namespace hachure
{

//------------------------------------------------------------------------------
TextureViewsFolder::TextureViewsFolder(const std::string& name)
{
  std::error_code error;
  const fs::path file = fs::absolute(name, error);
  this->folder = fs::canonical(file.parent_path(), error);
  if (error || name.empty() || !file.has_filename())
  {
    throw std::runtime_error("no folder for the manifest \"" + name + "\"");
  }
  this->manifest = this->folder / file.filename();
}

//------------------------------------------------------------------------------
TextureViewsFolder::~TextureViewsFolder()
{
  for (const fs::path& file : this->written)
  {
    removeFile(partOf(file));
    removeFile(file);
  }
}

//------------------------------------------------------------------------------
std::string TextureViewsFolder::readText() const
{
  std::error_code error;
  std::ifstream file(this->manifest, std::ios::binary);
  std::ostringstream text;
  if (!fs::is_regular_file(this->manifest, error) || !file)
  {
    throw std::runtime_error("cannot read the manifest " + quoted(this->manifest));
  }
  text << file.rdbuf(); // of an empty file nothing, which is no failure
  return text.str();
}

//------------------------------------------------------------------------------
std::string TextureViewsFolder::find(const std::string& name) const
{
  const fs::path path(name);
  if (name.empty())
  {
    throw std::runtime_error("expected the name of a file, got \"\"");
  }
  if (path.is_absolute() || path.has_root_path() ||
    std::find(path.begin(), path.end(), "..") != path.end())
  {
    throw std::runtime_error(
      quoted(path) + " must be relative to the manifest's folder and stay in it");
  }
  std::error_code error;
  const fs::path found = fs::canonical(this->folder / path, error);
  if (error)
  {
    throw std::runtime_error(quoted(path) + ": no such file in " + quoted(this->folder));
  }
  if (!isBelow(found, this->folder))
  {
    throw std::runtime_error(quoted(path) + " is a link out of the manifest's folder");
  }
  return found.string();
}

//------------------------------------------------------------------------------
std::string TextureViewsFolder::nameOf(const std::string& fileName) const
{
  std::error_code error;
  const fs::path found = fileName.empty() ? fs::path() : fs::canonical(fileName, error);
  if (error || found.empty() || !isBelow(found, this->folder))
  {
    return "";
  }
  return found.lexically_relative(this->folder).generic_string();
}

//------------------------------------------------------------------------------
std::string TextureViewsFolder::write(
  vtkImageData* image, const std::string& view, const std::string& what)
{
  const std::string stem = fileStem(view);
  std::string number;
  fs::path file;
  for (int i = 2; file.empty() || fs::exists(fs::symlink_status(file)); ++i)
  {
    std::string name = stem;
    name.append(number).append(what).append(".png");
    file = this->folder / name;
    number = "-" + std::to_string(i);
  }
  this->written.push_back(file);
  writePatternImage(image, partOf(file).string());
  fs::rename(partOf(file), file);
  return file.string();
}

//------------------------------------------------------------------------------
void TextureViewsFolder::finish(const std::string& text)
{
  const fs::path part = partOf(this->manifest);
  std::error_code error;
  std::ofstream file(part, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (file)
  {
    fs::rename(part, this->manifest, error);
  }
  if (!file || error)
  {
    removeFile(part);
    throw std::runtime_error("cannot write the manifest " + quoted(this->manifest));
  }
  this->written.clear();
}

} // namespace hachure
