// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTextureViewsRepresentation
 * @brief   draws the views of a view-dependent texture: cameras, pictures, ranges and blend points
 *
 * Every view is a wire pyramid from its camera to its picture, which is drawn small and lets
 * through what its alpha and mask hide. It has the colour that the view has where coverage is
 * shown, and its name. The selected view also shows from where it is seen: its extreme points as
 * balls, and the border through them. Blend points are balls with an arrow along their direction of
 * view and their percentage. What is selected is yellow.
 *
 * Views are in the coordinates of their surface; SetModelToWorld() says where that is. A view whose
 * camera is where the renderer's is, so that its picture would hide everything, is not drawn.
 *
 * Names and percentages need VTK's module RenderingFreeType.
 *
 * @sa vtkTextureViewsWidget vtkTextureViews
 */

#ifndef vtkTextureViewsRepresentation_h
#define vtkTextureViewsRepresentation_h

#include "HachureRenderingModule.h" // for the export macro
#include "vtkWidgetRepresentation.h"

#include <memory> // for the marks

class vtkDataObject;
class vtkMatrix4x4;
class vtkPropCollection;
class vtkTextureViews;

class HACHURERENDERING_EXPORT vtkTextureViewsRepresentation : public vtkWidgetRepresentation
{
public:
  static vtkTextureViewsRepresentation* New();
  vtkTypeMacro(vtkTextureViewsRepresentation, vtkWidgetRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What can be selected; also the interaction states. */
  enum Items
  {
    NOTHING = 0,
    VIEW = 1,
    EXTREME_POINT = 2,
    BLEND_POINT = 3
  };

  ///@{
  /** The views that are drawn and moved. Null is none, the default. */
  virtual void SetViews(vtkTextureViews* views);
  virtual vtkTextureViews* GetViews();
  ///@}

  ///@{
  /**
   * From the coordinates of the surface to those of the renderer: the matrix of its actor, kept by
   * reference. Null, the default, where they are the same. With a singular matrix nothing is drawn.
   */
  virtual void SetModelToWorld(vtkMatrix4x4* matrix);
  virtual vtkMatrix4x4* GetModelToWorld();
  ///@}

  /**
   * The surface, a vtkPolyData or a composite of such, in the coordinates of the views, on which
   * the regions that views cover are outlined (figure 6 of the paper); see vtkViewDependentTexture,
   * which does it anew after every change of the views. Null, the default: none.
   */
  virtual void SetSurface(vtkDataObject* surface);

  ///@{
  /**
   * The longer side of a picture, as a share of the diagonal of the surface's box. Range 0.001 to
   * 10, default 0.2. A picture is at most half as far from its camera as what that looks at.
   */
  vtkSetClampMacro(PictureSize, double, 0.001, 10.0);
  vtkGetMacro(PictureSize, double);
  ///@}

  ///@{
  /** Whether pictures are drawn, or their borders alone. Default on. */
  vtkSetMacro(ShowPictures, bool);
  vtkGetMacro(ShowPictures, bool);
  vtkBooleanMacro(ShowPictures, bool);
  ///@}

  ///@{
  /** Whether names and percentages are drawn. Default on. */
  vtkSetMacro(ShowLabels, bool);
  vtkGetMacro(ShowLabels, bool);
  vtkBooleanMacro(ShowLabels, bool);
  ///@}

  ///@{
  /**
   * Selects a view, an extreme point (and its view), a blend point (the selected view stays) or
   * nothing. An index out of range is an error and changes nothing. False after an error.
   */
  bool SelectView(int view);
  bool SelectExtremePoint(int view, int point);
  bool SelectBlendPoint(int point);
  void SelectNothing();
  ///@}

  ///@{
  /**
   * What is selected, one of Items; the view whose range is shown, -1: none; the extreme or blend
   * point, -1: none. What is no longer there is not selected.
   */
  int GetSelectedItem();
  int GetSelectedView();
  int GetSelectedPoint();
  ///@}

  /** Selects what ComputeInteractionState() has found last, if anything. */
  void SelectFound();

  ///@{
  /**
   * Whether dragging changes a distance: of a camera to what it looks at, of a blend point to the
   * renderer's camera. Otherwise cameras and extreme points stay on a sphere around that, and blend
   * points in a plane parallel to the screen. Default off.
   */
  vtkSetMacro(MovesDistance, bool);
  vtkGetMacro(MovesDistance, bool);
  vtkBooleanMacro(MovesDistance, bool);
  ///@}

  /** The box of the surface, in the coordinates of the renderer. Needed for sizes. */
  void PlaceWidget(double bounds[6]) override;

  /**
   * What is at a place of the window: one of Items. Extreme and blend points come before views;
   * what is hidden by a surface does not count.
   */
  int ComputeInteractionState(int x, int y, int modify = 0) override;

  ///@{
  /** Dragging of what is selected, from one place of the window to others. */
  void StartWidgetInteraction(double display[2]) override;
  void WidgetInteraction(double display[2]) override;
  ///@}

  /**
   * The place on the sphere on which a view's camera is that is seen at a place of the window, in
   * the coordinates of the surface. False where there is no renderer or no such view.
   */
  bool ComputePlaceOnSphere(int view, const double display[2], double place[3]);

  /** Where the selected item is drawn, in the coordinates of the renderer; false: nowhere. */
  bool GetSelectedPosition(double world[3]);

  void BuildRepresentation() override;
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetActors(vtkPropCollection* actors) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override;
  vtkMTimeType GetMTime() override;

protected:
  vtkTextureViewsRepresentation();
  ~vtkTextureViewsRepresentation() override;

private:
  vtkTextureViewsRepresentation(const vtkTextureViewsRepresentation&) = delete;
  void operator=(const vtkTextureViewsRepresentation&) = delete;

  struct Internals;
  bool Takes(int index, int count, const char* what);
  void ForgetLost();
  bool MakeScene();
  bool IsBuilt();
  void BuildViews();
  void BuildRange();
  void BuildBlendPoints();
  void UsePicture(int view);
  double HandleRadius(const double world[3]);
  bool IsAtCamera(const double world[3], double length);
  bool IsDrawnIn(vtkViewport* viewport);
  void FindHandles(int x, int y);
  void FindViews(int x, int y);
  bool IsHidden(int x, int y, double depth, double radius);
  void MoveExtremePoint(const double display[2]);
  void MoveView(const double display[2]);
  void MoveBlendPoint(const double display[2]);

  std::unique_ptr<Internals> Internal;
  double PictureSize = 0.2;
  bool ShowPictures = true;
  bool ShowLabels = true;
  bool MovesDistance = false;
};

#endif
