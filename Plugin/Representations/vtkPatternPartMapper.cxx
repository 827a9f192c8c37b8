// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternPartMapper.h"

#include "vtkDataObject.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPatternPartMapper);

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
    this->Cut->SetInputDataObject(0, part);
    this->Cut->SetInputDataObject(1, this->WholeOfNext);
    this->Cut->Update();
    this->Drawn = vtkSmartPointer<vtkDataObject>::Take(part->NewInstance());
    this->Drawn->ShallowCopy(this->Cut->GetOutputDataObject(0));
    this->Cut->SetInputDataObject(0, nullptr);
    this->Cut->SetInputDataObject(1, nullptr);
    this->Part = part;
    this->PartTime = part->GetMTime();
  }
  this->SetWholeSurface(this->WholeOfNext);
  this->Superclass::SetInputDataObject(port, this->Drawn);
}
