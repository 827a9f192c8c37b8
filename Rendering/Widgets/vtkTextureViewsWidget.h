// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTextureViewsWidget
 * @brief   edits the views of a view-dependent texture in a 3D view
 *
 * A click selects a view, one of the extreme points of the selected view, or a blend point. The
 * left button drags: the camera of a view on a sphere about what it looks at (with Shift: its
 * distance), an extreme point on its sphere about that, a blend point parallel to the screen (with
 * Shift: along the line of sight). The camera of a view with a matrix stays. Elsewhere the mouse is
 * left to others.
 *
 * Keys, as long as neither Control nor Alt is held:
 * - a: adds the renderer's camera as a view, which is then selected
 * - e: adds the place under the cursor as an extreme point of the selected view, which becomes a
 *   dependent view
 * - b: adds the renderer's camera as a blend point, of 50 percent
 * - + and -: change the percentage of the selected blend point by 5, or else how far from its own
 *   camera the selected view is seen unfaded, by 0.05 of the way to the border
 * - m: the next way of fading for the selected view
 * - Delete, Backspace: removes what is selected
 * - s: saves to the manifest
 * - Control+z: undoes
 * - i: turns the widget off and on, as all of VTK
 *
 * A key that has nothing to act on is left to others, but a, b, e and s are always taken, since
 * VTK's interactor styles would leave the program with e.
 *
 * Every action is a method, too. Those that change views invoke vtkCommand::StartInteractionEvent,
 * InteractionEvent and EndInteractionEvent, and are undone by Undo().
 *
 * @sa vtkTextureViewsRepresentation vtkTextureViewsManifest
 */

#ifndef vtkTextureViewsWidget_h
#define vtkTextureViewsWidget_h

#include "HachureRenderingModule.h" // for the export macro
#include "vtkAbstractWidget.h"
#include "vtkSmartPointer.h" // for the history
#include "vtkWeakPointer.h"  // for the history

#include <string> // for names
#include <vector> // for the history

class vtkImageData;
class vtkTextureViews;
class vtkTextureViewsRepresentation;

class HACHURERENDERING_EXPORT vtkTextureViewsWidget : public vtkAbstractWidget
{
public:
  static vtkTextureViewsWidget* New();
  vtkTypeMacro(vtkTextureViewsWidget, vtkAbstractWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What the picture of an added view is. */
  enum Pictures
  {
    RENDERED = 0,   //!< what the renderer shows without this widget, transparent where nothing is
    TRANSPARENT = 1 //!< nothing, to be painted on
  };

  ///@{
  /** What draws and moves the views; one of its own at first. */
  void SetRepresentation(vtkTextureViewsRepresentation* representation);
  vtkTextureViewsRepresentation* GetTextureViewsRepresentation();
  void CreateDefaultRepresentation() override;
  ///@}

  ///@{
  /** The views, those of the representation. Setting others forgets what could be undone. */
  void SetViews(vtkTextureViews* views);
  vtkTextureViews* GetViews();
  ///@}

  ///@{
  /** Where Save() writes, see vtkTextureViewsManifest. Default empty: nowhere. */
  vtkSetMacro(ManifestFileName, std::string);
  vtkGetMacro(ManifestFileName, std::string);
  ///@}

  ///@{
  /** The picture of added views, one of Pictures. Default RENDERED. */
  vtkSetClampMacro(Picture, int, RENDERED, TRANSPARENT);
  vtkGetMacro(Picture, int);
  ///@}

  void SetEnabled(int enabling) override;

  ///@{
  /**
   * Adds the renderer's camera as a view and selects it. Without an image its picture is as
   * SetPicture() says, of the size of the renderer. An empty name becomes "view 1" or so. Returns
   * the index of the view, or -1 after an error: there must be views and a renderer.
   */
  int AddCurrentCamera(const std::string& name);
  int AddCurrentCamera(const std::string& name, vtkImageData* image);
  ///@}

  /**
   * Adds the place on the sphere of the selected view's camera that is under a place of the window
   * to the extreme points of that view, makes it a dependent one, and selects the point. Returns
   * its index, or -1 where no view is selected.
   */
  int AddExtremePoint(double x, double y);

  /**
   * Adds the renderer's camera as a blend point of a percentage, 0 to 100, and selects it. Returns
   * its index, or -1 after an error.
   */
  int AddBlendPoint(double percentage);

  /** Removes the selected view, extreme point or blend point. False: nothing is selected. */
  bool RemoveSelected();

  /**
   * Adds to the percentage of the selected blend point, within 0 to 100. False: none is selected.
   */
  bool ChangePercentage(double difference);

  /**
   * Adds to the angle, relative to that of the border, up to which the fade curve of the selected
   * view keeps its first share. It stays between 0 and the next point of the curve. False: no view
   * is selected.
   */
  bool ChangePlateau(double difference);

  /** The next of vtkTextureViews::FadeModes for the selected view. False: none is selected. */
  bool SwitchFadeMode();

  /** Writes the manifest. False after an error: no file name, no views, or what that says. */
  bool Save();

  ///@{
  /**
   * Takes back the last action, up to the 32 last ones: views become what they were before it, also
   * in what others have changed since. Files that were saved stay as they are. False: there is
   * none.
   */
  bool Undo();
  bool CanUndo();
  ///@}

protected:
  vtkTextureViewsWidget();
  ~vtkTextureViewsWidget() override;

  void SetCursor(int state) override;

private:
  vtkTextureViewsWidget(const vtkTextureViewsWidget&) = delete;
  void operator=(const vtkTextureViewsWidget&) = delete;

  static void SelectAction(vtkAbstractWidget* widget);
  static void MoveAction(vtkAbstractWidget* widget);
  static void EndSelectAction(vtkAbstractWidget* widget);
  static void KeyAction(vtkAbstractWidget* widget);
  static void CharAction(vtkAbstractWidget* widget);

  bool IsHere(int x, int y);
  bool ActOnKey();
  bool ActOnLetter(char letter);
  bool HasViews(const char* caller);
  bool HasRenderer(const char* caller);
  std::string FreeName();
  int AddView(const std::string& name, vtkImageData* image);
  void Remember();
  void ForgetLast();
  void Changed();
  void EndDrag();

  std::vector<vtkSmartPointer<vtkTextureViews>> History;
  vtkWeakPointer<vtkTextureViews> HistoryOf;
  std::string ManifestFileName;
  int Picture = RENDERED;
  bool Dragging = false;
  bool Dragged = false; // since the button was pressed
  bool KeyTaken = false;
};

#endif
