// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The legend of a representation in a view: over everything else, as scalar bars are, and moved
 * with the mouse where there is one. Only the process that shows pictures to the user has it.
 */
#ifndef PatternLegendPlace_h
#define PatternLegendPlace_h

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <functional>

class vtkActor;
class vtkBorderWidget;
class vtkObjectBase;
class vtkPVRenderView;
class vtkPatternLegendActor;
class vtkPatternLegendRepresentation;

class PatternLegendPlace
{
public:
  /// moved: is called when the user has put the legend elsewhere.
  PatternLegendPlace(vtkActor* surface, std::function<void()> moved);
  ~PatternLegendPlace();
  PatternLegendPlace(const PatternLegendPlace&) = delete;
  PatternLegendPlace& operator=(const PatternLegendPlace&) = delete;

  vtkPatternLegendActor* GetLegend() const;
  vtkPatternLegendRepresentation* GetRepresentation() const { return this->Representation.Get(); }

  void SetView(vtkPVRenderView* view);
  /// Both must be on for the legend to be seen.
  void SetShown(bool shown);
  bool GetShown() const { return this->Shown; }
  void SetSurfaceVisible(bool visible);
  /// Takes notice of a mouse that has come since.
  void Update();

private:
  static bool IsSeenHere();
  void Tell();

  std::function<void()> Moved;
  bool Shown = false;
  bool SurfaceVisible = true;
  vtkWeakPointer<vtkPVRenderView> View;
  vtkNew<vtkPatternLegendRepresentation> Representation;
  vtkNew<vtkBorderWidget> Widget;
};

/// Writes a legend's place, as the mouse has left it, into the properties of the proxy that a
/// representation belongs to, where this process has that: states and panels then know it.
void writeLegendPlace(vtkObjectBase* representation, const double corner[2], const double size[2]);

#endif
