// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Shows the views of a representation in the view that it is in, lets them be edited there, and
 * adds the camera of that view.
 */
#ifndef ViewTextureEditor_h
#define ViewTextureEditor_h

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkDataObject;
class vtkMatrix4x4;
class vtkPVRenderView;
class vtkProp3D;
class vtkTextureViews;
class vtkTextureViewsRepresentation;
class vtkTextureViewsWidget;

class ViewTextureEditor
{
public:
  ViewTextureEditor();
  ~ViewTextureEditor();
  ViewTextureEditor(const ViewTextureEditor&) = delete;
  ViewTextureEditor& operator=(const ViewTextureEditor&) = delete;

  ///@{
  /// The view of the representation. There is none at first.
  void SetView(vtkPVRenderView* view);
  vtkPVRenderView* GetView() { return this->View; }
  ///@}

  /// Shows views around the surface that an actor draws. Where the view has an interactor and no
  /// other process draws them, they are edited by mouse and keys, and saved to this manifest.
  /// What they cover of `regions` is outlined; null: nothing is.
  void Show(vtkTextureViews* views, vtkProp3D* surface, vtkDataObject* regions,
    const std::string& manifest);

  /// Shows them no more.
  void Hide();

  /// Adds the camera of the view to views of that surface, as a dependent one with extreme points
  /// at an angle in degrees. Its picture is what is drawn, or transparent, which it always is where
  /// several processes draw. The index of the added view, or -1 after an error.
  int AddCamera(vtkTextureViews* views, vtkProp3D* surface, bool transparent, double angle);

  /// Whether this process is the only one, and has all of the picture.
  static bool IsAlone();

private:
  void Place(vtkTextureViews* views, vtkProp3D* surface);
  void Enable(bool enabled);

  vtkWeakPointer<vtkPVRenderView> View;
  vtkNew<vtkMatrix4x4> ModelToWorld;
  vtkNew<vtkTextureViewsRepresentation> Marks;
  vtkNew<vtkTextureViewsWidget> Widget;
};

#endif
