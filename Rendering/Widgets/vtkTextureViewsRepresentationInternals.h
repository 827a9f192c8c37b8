// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTextureViewsRepresentationInternals_h
#define vtkTextureViewsRepresentationInternals_h

#include "DisplayRay.h"
#include "TextureViewActors.h"
#include "TextureViewShapes.h"
#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"
#include "vtkTextureViews.h"
#include "vtkTextureViewsRepresentation.h"

#include <glm/vec2.hpp>

#include <array>
#include <memory>
#include <vector>

struct vtkTextureViewsRepresentation::Internals
{
  // One of Items with its place in the lists.
  struct Item
  {
    int kind = NOTHING;
    int view = -1;
    int point = -1;
  };

  vtkSmartPointer<vtkTextureViews> views;
  vtkSmartPointer<vtkMatrix4x4> modelToWorld;
  hachure::ViewScene scene;
  Item selected;
  Item found; // under the cursor

  std::vector<std::unique_ptr<hachure::ViewMark>> viewMarks;
  std::vector<std::unique_ptr<hachure::BlendMark>> blendMarks;
  std::vector<std::unique_ptr<hachure::HandleMark>> extremeMarks;
  hachure::RegionsMark regions;
  hachure::LinesMark border;
  std::vector<vtkProp*> props; // of all marks that are drawn
  std::vector<vtkProp*> allProps() const;
  std::array<double, 6> bounds{};

  // Of a drag: from the cursor to what is dragged, in pixels; where the cursor was last.
  glm::dvec2 grabbed{ 0.0 };
  glm::dvec2 last{ 0.0 };
};

#endif
