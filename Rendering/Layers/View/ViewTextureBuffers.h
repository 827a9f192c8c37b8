// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What ViewTextureLayer.glsl reads, in the memory of one window.
 */
#ifndef ViewTextureBuffers_h
#define ViewTextureBuffers_h

#include "SurfaceCells.h"
#include "SurfaceFrames.h"
#include "TriangleRuns.h"
#include "ViewTextureColors.h"
#include "vtkNew.h"
#include "vtkPatternNumberBuffer.h"
#include "vtkTextureObject.h"

#include <glm/vec3.hpp>

#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

class ViewTextureBuffers
{
public:
  void UploadCells(vtkOpenGLRenderWindow* window, const hachure::TriangleRuns& runs,
    const hachure::SurfaceCells& cells, const hachure::SurfaceFrames& frames);
  void UploadFrames(vtkOpenGLRenderWindow* window, const hachure::SurfaceFrames& frames,
    hachure::Span<const glm::dvec3> positions, const glm::dvec3& origin);
  /// Throws std::runtime_error where the window cannot hold as many colours.
  void UploadColors(vtkOpenGLRenderWindow* window, const hachure::ViewTextureColors& colors);

  /// What samplers need where there is nothing to read.
  void UploadNothing(vtkOpenGLRenderWindow* window);

  bool IsUsable() const;
  void SetUniforms(vtkShaderProgram* program, const std::string& number) const;
  void Activate();
  void Deactivate();
  void Release(vtkWindow* window);

private:
  vtkPatternNumberBuffer Triangles;
  vtkPatternNumberBuffer Frames;
  vtkPatternNumberBuffer Charts;
  vtkNew<vtkTextureObject> Dependent;
  vtkNew<vtkTextureObject> Independent;
  glm::vec3 Images{ 1.0f }; // as hachureNodeImages
};

#endif
