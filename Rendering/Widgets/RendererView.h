// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_RendererView_h
#define hachure_RendererView_h

#include "vtkSmartPointer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <string>

class vtkImageData;
class vtkProp;
class vtkRenderer;
class vtkTextureViews;

// What a renderer shows, as a view of a view-dependent texture.
namespace hachure
{

// Renders without a prop and returns the picture; where nothing is it is transparent. Null where
// the renderer has no window or no size.
vtkSmartPointer<vtkImageData> rendererPicture(vtkRenderer* renderer, vtkProp* without);

// A picture of the renderer's size that says nothing. Null where it has no size.
vtkSmartPointer<vtkImageData> emptyPicture(vtkRenderer* renderer);

// Adds a view with the renderer's camera, in the coordinates that `modelToWorld` leads from. It
// becomes a matrix where no camera of such a view sees the same. The index of the view, or -1.
int addRendererView(vtkTextureViews* views, const std::string& name, vtkRenderer* renderer,
  const glm::dmat4& modelToWorld, vtkImageData* image);

} // namespace hachure

#endif
