// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the mapper has drawn, as shapes.

#include "vtkPatternMapper.h"

#include "VectorPage.h"

// No layer draws discs that could be told one by one.
void vtkPatternMapper::CollectStipples(vtkRenderer* vtkNotUsed(renderer),
  vtkActor* vtkNotUsed(actor), std::vector<hachure::VectorDisc>& vtkNotUsed(discs))
{
}
