// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A rectangle over all of what is drawn to, with a shader of its own.
 */
#ifndef vtkPatternQuad_h
#define vtkPatternQuad_h

#include <memory>
#include <string>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

class vtkPatternQuad
{
public:
  vtkPatternQuad();
  ~vtkPatternQuad();

  /// Its shader, made the current one; null where that does not compile. All is made anew where a
  /// text is another one. vertices: empty for VTK's own.
  vtkShaderProgram* Ready(
    vtkOpenGLRenderWindow* window, const std::string& vertices, const std::string& fragments);
  /// With the shader that Ready() returned last.
  void Render();
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool IsCompiled() const;

  std::unique_ptr<vtkOpenGLQuadHelper> Helper;
  std::string Vertices;
  std::string Fragments;
  bool Compiles = false;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternQuad.h
