// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkViewTextureRepresentation
 * @brief ParaView's surface representation, drawn with a view-dependent texture
 *
 * It draws as vtkPatternRepresentation does and has its properties; the style that it starts with
 * is a vtkViewTextureLayer, and further properties replace what such layers have, in all of them.
 * They start neutral as well, so that a new representation shows its style exactly. No setter
 * executes the pipeline of the surface.
 *
 * Its views are those of a manifest, or else those of the style, to which cameras of the
 * view that it is shown in are added. They stay when other properties change.
 *
 * @sa vtkViewTextureLayer vtkTextureViews vtkTextureViewsManifest
 */
#ifndef vtkViewTextureRepresentation_h
#define vtkViewTextureRepresentation_h

#include "vtkPatternRepresentation.h"
#include "vtkViewTextureLayer.h" // For the ranges of the setters

#include <memory> // For the editor

class ViewTextureEditor;
class vtkStringArray;

class HACHUREREPRESENTATIONS_EXPORT vtkViewTextureRepresentation : public vtkPatternRepresentation
{
public:
  static vtkViewTextureRepresentation* New();
  vtkTypeMacro(vtkViewTextureRepresentation, vtkPatternRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Values of ViewTexturePicture. */
  enum PictureType
  {
    AS_DRAWN = 0,   //!< what the view shows, transparent where nothing is
    TRANSPARENT = 1 //!< nothing, to be painted on
  };

  ///@{
  /** Manifest of the views, see vtkTextureViewsManifest; every process reads it before the next
   * picture. One that cannot be read is an error with its reason, and the views stay. Default
   * empty: the views of the style. */
  void SetViewTextureManifest(const char* fileName);
  const char* GetViewTextureManifest();
  ///@}

  /** Reads the manifest of the views again. Only views that have changed in it, or whose pictures
   * have, are made anew. An error without a manifest or where it cannot be read; the views then
   * stay. */
  void ReadViewTextureManifest();

  ///@{
  /** What is shown: AS_IN_STYLE, or vtkViewTextureLayer's COMBINED (0), DEPENDENT_ONLY (1),
   * INDEPENDENT_ONLY (2) or COVERAGE (3). Default AS_IN_STYLE. */
  void SetViewTextureDisplay(int choice)
  {
    this->Choose(this->ViewTextureDisplay, choice, vtkViewTextureLayer::COVERAGE);
  }
  vtkGetMacro(ViewTextureDisplay, int);
  ///@}

  ///@{
  /** What is seen where no dependent view is: AS_IN_STYLE, or vtkViewTextureLayer's VIEWS (0) or
   * BELOW (1). Default AS_IN_STYLE. */
  void SetViewTextureBase(int choice)
  {
    this->Choose(this->ViewTextureBase, choice, vtkViewTextureLayer::BELOW);
  }
  vtkGetMacro(ViewTextureBase, int);
  ///@}

  ///@{
  /** The level of detail: AS_IN_STYLE, or vtkViewTextureLayer's PIXELS_OWN (0) or ONE (1). Default
   * AS_IN_STYLE. */
  void SetViewTextureLevel(int choice)
  {
    this->Choose(this->ViewTextureLevel, choice, vtkViewTextureLayer::ONE);
  }
  vtkGetMacro(ViewTextureLevel, int);
  ///@}

  ///@{
  /** See vtkViewTextureLayer::SetPropagateUp() and SetClassicShares(): AS_IN_STYLE, 0 (no) or 1
   * (yes) each. Default AS_IN_STYLE. */
  void SetViewTexturePropagateUp(int choice)
  {
    this->Choose(this->ViewTexturePropagateUp, choice, 1);
  }
  vtkGetMacro(ViewTexturePropagateUp, int);
  void SetViewTextureClassicShares(int choice)
  {
    this->Choose(this->ViewTextureClassicShares, choice, 1);
  }
  vtkGetMacro(ViewTextureClassicShares, int);
  ///@}

  ///@{
  /** Memory that the colours of a surface may take, MiB: 0 as in the style, else up to 16384.
   * Default 0. */
  void SetViewTextureMemoryBudget(int mebibytes)
  {
    this->Change(this->ViewTextureMemoryBudget, std::clamp(mebibytes, 0, 16384));
  }
  vtkGetMacro(ViewTextureMemoryBudget, int);
  ///@}

  ///@{
  /** Whether the cameras, pictures and ranges of the views are shown, see
   * vtkTextureViewsRepresentation. In a window, and without a server, they are edited by mouse and
   * keys, see vtkTextureViewsWidget. Default 0: no. */
  vtkSetClampMacro(ViewTextureShowViews, int, 0, 1);
  vtkGetMacro(ViewTextureShowViews, int);
  ///@}

  ///@{
  /** The picture of views that are added, one of PictureType. Where several processes draw it is
   * TRANSPARENT, with a warning. Default AS_DRAWN. */
  vtkSetClampMacro(ViewTexturePicture, int, AS_DRAWN, TRANSPARENT);
  vtkGetMacro(ViewTexturePicture, int);
  ///@}

  ///@{
  /** From the camera of a view that is added to its four extreme points, in degrees around what it
   * looks at. Range 1 to 90, default 30. */
  vtkSetClampMacro(ViewTextureExtremeAngle, double, 1.0, 90.0);
  vtkGetMacro(ViewTextureExtremeAngle, double);
  ///@}

  /** Adds the camera of the view that this is shown in as a dependent view, in the coordinates of
   * the surface. An error where it is in no view, or in a style without such a layer. */
  void AddViewTextureCamera();

  ///@{
  /** The manifest that SaveViewTextureManifest() writes. Default empty: the one that was read. */
  void SetViewTextureSaveName(const char* fileName);
  const char* GetViewTextureSaveName();
  ///@}

  /** Writes the views; of several processes the first one of the server does. An error without a
   * file name or where it cannot be written. */
  void SaveViewTextureManifest();

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;
  void SetVisibility(bool visible) override;

  /** The names of the views of the last picture and of those added since, in their order. Valid
   * until the next call. */
  vtkStringArray* GetViewTextureNames();

protected:
  vtkViewTextureRepresentation();
  ~vtkViewTextureRepresentation() override;

  void AdjustStyle(vtkPatternStyle* style) override;
  std::string GetUnsaved() override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkViewTextureRepresentation(const vtkViewTextureRepresentation&) = delete;
  void operator=(const vtkViewTextureRepresentation&) = delete;

  void AdjustLayer(vtkViewTextureLayer* layer);
  void UpdateViews();
  void ReadViews(const std::string& fileName);
  vtkViewTextureLayer* FirstLayer();
  bool TakeViews();
  std::string FileToSave();
  void ShowViews();

  std::string ViewTextureManifest;
  int ViewTextureDisplay = AS_IN_STYLE;
  int ViewTextureBase = AS_IN_STYLE;
  int ViewTextureLevel = AS_IN_STYLE;
  int ViewTexturePropagateUp = AS_IN_STYLE;
  int ViewTextureClassicShares = AS_IN_STYLE;
  int ViewTextureMemoryBudget = 0;
  int ViewTextureShowViews = 0;
  int ViewTexturePicture = AS_DRAWN;
  double ViewTextureExtremeAngle = 30.0;
  std::string ViewTextureSaveName;

  std::unique_ptr<ViewTextureEditor> Editor;
  vtkSmartPointer<vtkTextureViews> Views; // null: those of the style
  std::string ViewsFile;                  // the manifest that they were read from or written to
  vtkMTimeType SavedViews = 0;            // their time then
  bool ManifestChanged = false;
  vtkSmartPointer<vtkStringArray> Names;
};

#endif
