// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternDrawnSurface.h"

#include "vtkActor.h"
#include "vtkClipPolyData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPatternBlocks.h"
#include "vtkPatternMapper.h"
#include "vtkPatternViewport.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace
{
// Clipping planes are in world coordinates; what is on their positive side is drawn.
std::vector<vtkSmartPointer<vtkPlane>> ModelPlanes(vtkPatternMapper* mapper, vtkActor* actor)
{
  std::vector<vtkSmartPointer<vtkPlane>> planes;
  vtkPlaneCollection* worldPlanes = mapper->GetClippingPlanes();
  if (!worldPlanes)
  {
    return planes;
  }
  const glm::dmat4 modelToWorld = vtkPattern::ToGlm(actor->GetMatrix());
  const glm::dmat4 worldToModel = glm::inverse(modelToWorld);
  planes.reserve(static_cast<std::size_t>(worldPlanes->GetNumberOfItems()));
  for (int i = 0; i < worldPlanes->GetNumberOfItems(); ++i)
  {
    vtkPlane* plane = worldPlanes->GetItem(i);
    const double* origin = plane->GetOrigin();
    const double* normal = plane->GetNormal();
    const glm::dvec4 place = worldToModel * glm::dvec4(origin[0], origin[1], origin[2], 1.0);
    const glm::dvec3 direction =
      glm::transpose(glm::dmat3(modelToWorld)) * glm::dvec3(normal[0], normal[1], normal[2]);
    auto modelPlane = vtkSmartPointer<vtkPlane>::New();
    modelPlane->SetOrigin(place.x, place.y, place.z);
    modelPlane->SetNormal(direction.x, direction.y, direction.z);
    planes.push_back(modelPlane);
  }
  return planes;
}

vtkSmartPointer<vtkPolyData> Clip(
  vtkPolyData* block, const std::vector<vtkSmartPointer<vtkPlane>>& planes)
{
  vtkSmartPointer<vtkPolyData> kept = block;
  for (vtkPlane* plane : planes)
  {
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(kept);
    clip->SetClipFunction(plane);
    clip->Update();
    kept = clip->GetOutput();
  }
  return kept;
}

// Blocks have the visibility of the nearest block around them that states one.
void AddVisible(vtkDataObject* data, bool visible, vtkCompositeDataDisplayAttributes* attributes,
  std::vector<vtkPolyData*>& blocks)
{
  if (attributes && attributes->HasBlockVisibility(data))
  {
    visible = attributes->GetBlockVisibility(data);
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    vtkSmartPointer<vtkDataObjectTreeIterator> child;
    child.TakeReference(tree->NewTreeIterator());
    child->VisitOnlyLeavesOff();
    child->TraverseSubTreeOff();
    for (child->InitTraversal(); !child->IsDoneWithTraversal(); child->GoToNextItem())
    {
      AddVisible(child->GetCurrentDataObject(), visible, attributes, blocks);
    }
  }
  else if (visible)
  {
    for (const vtkPattern::Block& block : vtkPattern::Blocks(data))
    {
      blocks.push_back(block.Data);
    }
  }
}
} // namespace

namespace vtkPattern
{
vtkSmartPointer<vtkDataObject> DrawnSurface(vtkPatternMapper* mapper, vtkActor* actor)
{
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  if (!input)
  {
    return nullptr;
  }
  std::vector<vtkPolyData*> blocks;
  AddVisible(input, true, mapper->GetCompositeDataDisplayAttributes(), blocks);
  const std::vector<vtkSmartPointer<vtkPlane>> planes = ModelPlanes(mapper, actor);
  auto surface = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  unsigned int count = 0;
  for (vtkPolyData* block : blocks)
  {
    surface->SetBlock(count++, Clip(block, planes));
  }
  return surface;
}
} // namespace vtkPattern
