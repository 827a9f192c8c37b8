// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Shader files that hold several pieces of text, each after a line "//Section name".
 */
#ifndef vtkPatternShaderText_h
#define vtkPatternShaderText_h

#include <stdexcept>
#include <string>

namespace vtkPattern
{
/// The text between "//Section name" and the next section or the end.
inline std::string ShaderSection(const std::string& all, const std::string& name)
{
  const std::string head = "//Section " + name + "\n";
  const std::size_t found = all.find(head);
  if (found == std::string::npos)
  {
    throw std::logic_error("no shader section " + name);
  }
  const std::size_t begin = found + head.size();
  const std::size_t end = all.find("//Section ", begin);
  return all.substr(begin, end == std::string::npos ? end : end - begin);
}
} // namespace vtkPattern

#endif
// VTK-HeaderTest-Exclude: vtkPatternShaderText.h
