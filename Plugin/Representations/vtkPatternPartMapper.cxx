// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternPartMapper.h"

#include "vtkDataObject.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkPatternPartMapper);

namespace
{
constexpr double leastSurroundings = 0.005; // in diagonals
}

//------------------------------------------------------------------------------
void vtkPatternPartMapper::SetInputDataObject(int port, vtkDataObject* part)
{
  if (port != 0 || !part || !this->WholeOfNext)
  {
    this->SetWholeSurface(nullptr);
    this->Drawn = nullptr;
    this->Part = nullptr;
    this->Superclass::SetInputDataObject(port, part);
    return;
  }
  const bool known = this->Drawn && this->Part == part && this->PartTime == part->GetMTime() &&
    this->GetWholeSurface() == this->WholeOfNext;
  if (!known)
  {
    this->CutPart(part, this->WholeOfNext);
    this->Part = part;
    this->PartTime = part->GetMTime();
  }
  this->SetWholeSurface(this->WholeOfNext);
  this->Superclass::SetInputDataObject(port, this->Drawn);
}

//------------------------------------------------------------------------------
void vtkPatternPartMapper::CutPart(vtkDataObject* part, vtkDataObject* whole)
{
  this->Cut->SetInputDataObject(0, part);
  this->Cut->SetInputDataObject(1, whole);
  this->Cut->Update();
  this->Drawn =
    vtkSmartPointer<vtkDataObject>::Take(this->Cut->GetOutputDataObject(0)->NewInstance());
  this->Drawn->ShallowCopy(this->Cut->GetOutputDataObject(0));
  this->Cut->SetInputDataObject(0, nullptr);
  this->Cut->SetInputDataObject(1, nullptr);
}

//------------------------------------------------------------------------------
// They are as wide as what is drawn reaches in the picture, however far away the surface is.
void vtkPatternPartMapper::FitSurroundings(vtkRenderer* renderer, vtkActor* actor)
{
  const bool all = this->Drawn &&
    this->GetWholeSurface()->GetNumberOfElements(vtkDataObject::CELL) <=
      this->Cut->GetMaximumNumberOfCells();
  if (!this->Drawn || !this->Part || all || !this->GetController())
  {
    return;
  }
  constexpr double spare = 1.5; // so that they stay while the camera moves a little
  constexpr double excess = 4.0;
  const double wanted = this->GetReach(renderer, actor);
  const double current = this->Cut->GetSurroundings();
  if (wanted > current || (wanted * excess < current && current > leastSurroundings))
  {
    this->Cut->SetSurroundings(std::max(std::min(spare * wanted, 1.0), leastSurroundings));
    this->CutPart(this->Part, this->GetWholeSurface());
    this->Superclass::SetInputDataObject(0, this->Drawn);
  }
}

//------------------------------------------------------------------------------
void vtkPatternPartMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  this->FitSurroundings(renderer, actor);
  this->Superclass::Render(renderer, actor);
}
