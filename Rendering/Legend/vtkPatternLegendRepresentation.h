// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatternLegendRepresentation
 * @brief lets a vtkBorderWidget place and resize a legend with the mouse
 *
 * The legend takes the place of the border: Position is its lower left corner and Position2 its
 * size, normalised viewport coordinates; default as those of vtkPatternLegendActor. The border is
 * seen while the mouse is over it.
 *
 *     widget = vtkBorderWidget()
 *     widget.SetRepresentation(hachure.vtkPatternLegendRepresentation())
 *     widget.SetInteractor(interactor)
 *     widget.On()
 *
 * @sa vtkPatternLegendActor
 */
#ifndef vtkPatternLegendRepresentation_h
#define vtkPatternLegendRepresentation_h

#include "HachureRenderingModule.h"
#include "vtkBorderRepresentation.h"
#include "vtkSmartPointer.h" // For the owned legend

class vtkPatternLegendActor;

class HACHURERENDERING_EXPORT vtkPatternLegendRepresentation : public vtkBorderRepresentation
{
public:
  static vtkPatternLegendRepresentation* New();
  vtkTypeMacro(vtkPatternLegendRepresentation, vtkBorderRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The legend that is placed; there is always one. Null is refused with an error. */
  virtual void SetLegend(vtkPatternLegendActor* legend);
  virtual vtkPatternLegendActor* GetLegend();
  ///@}

  void BuildRepresentation() override;
  void GetSize(double size[2]) override;
  void GetActors2D(vtkPropCollection* props) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOverlay(vtkViewport* viewport) override;
  vtkMTimeType GetMTime() override;

protected:
  vtkPatternLegendRepresentation();
  ~vtkPatternLegendRepresentation() override;

private:
  vtkPatternLegendRepresentation(const vtkPatternLegendRepresentation&) = delete;
  void operator=(const vtkPatternLegendRepresentation&) = delete;

  vtkSmartPointer<vtkPatternLegendActor> Legend;
};

#endif
