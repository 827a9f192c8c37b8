// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkViewTextureLayer
 * @brief a layer of pictures of the surface, each of which is seen from where it was made
 *
 * View-dependent textures (Grimm and Kowalski 2002, Creating View-dependent Texture Maps): pictures
 * of the surface, painted or taken, each with its camera, are put together on the surface. A
 * dependent view is seen from the cameras near its own, an independent one from everywhere. A view
 * counts for the level of detail at which its pixels are as large as the cells of the surface: a
 * picture from afar takes the place of those from nearby where the camera is far away.
 *
 * The surface is divided into cells without texture coordinates. Colours are evaluated for every
 * pixel and frame, and go with the surface where it deforms: marks stay at the same angle to its
 * normal. Where no view tells the colour, cells next to it and other levels of detail do; what
 * nobody knows is grey.
 *
 * The ink has the colours of the views; its tone says how much of it there is, 1 unless another
 * tone is set. The base may also be what lies below: another layer, the paper, or with
 * vtkPatternStyle's SURFACE the colours of the surface.
 *
 * @sa vtkTextureViews vtkTextureViewsManifest vtkPatternStyle
 */

#ifndef vtkViewTextureLayer_h
#define vtkViewTextureLayer_h

#include "vtkPatternLayer.h"
#include "vtkTextureViews.h" // For the owned views

#include <string>

class HACHURERENDERING_EXPORT vtkViewTextureLayer : public vtkPatternLayer
{
public:
  static vtkViewTextureLayer* New();
  vtkTypeMacro(vtkViewTextureLayer, vtkPatternLayer);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What is shown: all; dependent or independent views alone; a colour for every view. */
  enum DisplayType
  {
    COMBINED = 0,
    DEPENDENT_ONLY = 1,
    INDEPENDENT_ONLY = 2,
    COVERAGE = 3
  };

  /** What is seen where no dependent view is: independent views, or what lies below the layer. */
  enum BaseType
  {
    VIEWS = 0,
    BELOW = 1
  };

  /** The level of detail: that of every pixel, or one for all of the surface, as in the paper. */
  enum LevelType
  {
    PIXELS_OWN = 0,
    ONE = 1
  };

  const char* GetTypeName() override { return "view"; }

  ///@{
  /** The views. Every layer has some of its own at first; null is refused with an error. */
  virtual void SetViews(vtkTextureViews* views);
  virtual vtkTextureViews* GetViews();
  ///@}

  /**
   * Reads a manifest of views (see vtkTextureViewsManifest) into views of this layer's own. False,
   * with an error, where it cannot be read: then the views stay.
   */
  virtual bool ReadManifest(const std::string& fileName);

  ///@{
  /** The manifest that holds the views, for style files; ReadManifest sets it. Default: none. */
  virtual void SetManifestFileName(const char* fileName);
  virtual const char* GetManifestFileName();
  ///@}

  ///@{
  /** What is shown, one of DisplayType; default COMBINED. */
  vtkSetClampMacro(Display, int, COMBINED, COVERAGE);
  vtkGetMacro(Display, int);
  ///@}

  ///@{
  /** What is seen where no dependent view is, one of BaseType; default VIEWS. */
  vtkSetClampMacro(Base, int, VIEWS, BELOW);
  vtkGetMacro(Base, int);
  ///@}

  ///@{
  /** The level of detail, one of LevelType; default PIXELS_OWN. */
  vtkSetClampMacro(Level, int, PIXELS_OWN, ONE);
  vtkGetMacro(Level, int);
  ///@}

  ///@{
  /** Whether levels finer than all views have the colours of the finest one that has some (section
   * 6.2 mentions it); otherwise they are grey. Default on. */
  vtkSetMacro(PropagateUp, bool);
  vtkGetMacro(PropagateUp, bool);
  vtkBooleanMacro(PropagateUp, bool);
  ///@}

  ///@{
  /** Whether views that count little for a level of detail give way to the base there, as in the
   * paper; otherwise they only give way to other views. Default off. */
  vtkSetMacro(ClassicShares, bool);
  vtkGetMacro(ClassicShares, bool);
  vtkBooleanMacro(ClassicShares, bool);
  ///@}

  ///@{
  /** Memory that the colours of a surface may take, MiB; there are fewer levels where they would
   * take more. Range 1 to 16384, default 512. */
  vtkSetClampMacro(MemoryBudget, int, 1, 16384);
  vtkGetMacro(MemoryBudget, int);
  ///@}

  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  void DescribeField(hachure::StyleArchive& archive) override;
#endif

protected:
  vtkViewTextureLayer();
  ~vtkViewTextureLayer() override;

private:
  vtkViewTextureLayer(const vtkViewTextureLayer&) = delete;
  void operator=(const vtkViewTextureLayer&) = delete;

#ifndef __VTK_WRAP__
  void DescribeManifest(hachure::StyleArchive& archive);
#endif

  vtkSmartPointer<vtkTextureViews> Views;
  std::string ManifestFileName;
  int Display = COMBINED;
  int Base = VIEWS;
  int Level = PIXELS_OWN;
  bool PropagateUp = true;
  bool ClassicShares = false;
  int MemoryBudget = 512;
};

#endif
