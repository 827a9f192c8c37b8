// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The mapper of a representation: takes the part of a surface that ParaView delivers to a process,
 * and draws it as a part of the whole surface.
 */
#ifndef vtkPatternPartMapper_h
#define vtkPatternPartMapper_h

#include "vtkNew.h"
#include "vtkPatternMapper.h"
#include "vtkSmartPointer.h"
#include "vtkSurfacePart.h"
#include "vtkWeakPointer.h"

class vtkPatternPartMapper : public vtkPatternMapper
{
public:
  static vtkPatternPartMapper* New();
  vtkTypeMacro(vtkPatternPartMapper, vtkPatternMapper);

  /// The whole surface of the part that is set next; null where it is not known: then the part is
  /// drawn as a surface of its own.
  void SetWholeOfNext(vtkDataObject* whole) { this->WholeOfNext = whole; }

  using Superclass::SetInputDataObject;
  void SetInputDataObject(int port, vtkDataObject* part) override;

  void Render(vtkRenderer* renderer, vtkActor* actor) override;

protected:
  vtkPatternPartMapper() = default;
  ~vtkPatternPartMapper() override = default;

private:
  vtkPatternPartMapper(const vtkPatternPartMapper&) = delete;
  void operator=(const vtkPatternPartMapper&) = delete;

  void CutPart(vtkDataObject* part, vtkDataObject* whole);
  void FitSurroundings(vtkRenderer* renderer, vtkActor* actor);

  vtkSmartPointer<vtkDataObject> WholeOfNext;
  vtkNew<vtkSurfacePart> Cut;
  vtkSmartPointer<vtkDataObject> Drawn;
  vtkWeakPointer<vtkDataObject> Part; // that it was made of
  vtkMTimeType PartTime = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternPartMapper.h
