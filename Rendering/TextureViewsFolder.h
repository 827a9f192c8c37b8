// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TextureViewsFolder_h
#define TextureViewsFolder_h

#include <filesystem>
#include <string>
#include <vector>

class vtkImageData;

namespace hachure
{

/**
 * The folder of a manifest and the files in it. A manifest is data that may come from others: it
 * reaches no file outside its folder. What was written and not kept is removed with this object.
 */
class TextureViewsFolder
{
public:
  /** Of the manifest of this name, whose folder must be there. Throws std::runtime_error. */
  explicit TextureViewsFolder(const std::string& manifest);
  ~TextureViewsFolder();
  TextureViewsFolder(const TextureViewsFolder&) = delete;
  TextureViewsFolder& operator=(const TextureViewsFolder&) = delete;

  /** The text of the manifest. Throws std::runtime_error where it cannot be read. */
  std::string readText() const;

  /**
   * The absolute name of a file, links resolved, whose name in the manifest this is. Throws
   * std::runtime_error where it is not in the folder or in one below it.
   */
  std::string find(const std::string& name) const;

  /** The name in the manifest of a file in the folder or below it; empty: there is none. */
  std::string nameOf(const std::string& fileName) const;

  /**
   * Writes an image to a new file, named after a view and what the image is ("-mask"). Returns its
   * absolute name. Throws std::runtime_error where that is not possible.
   */
  std::string write(vtkImageData* image, const std::string& view, const std::string& what);

  /** Puts a text in the place of the manifest at once, and keeps all that was written. */
  void finish(const std::string& text);

private:
  std::filesystem::path manifest;
  std::filesystem::path folder;
  std::vector<std::filesystem::path> written;
};

} // namespace hachure

#endif
