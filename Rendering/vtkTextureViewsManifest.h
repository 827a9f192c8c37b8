// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTextureViewsManifest
 * @brief   reads and writes the views of a view-dependent texture as a JSON file beside their
 * images
 *
 * A manifest names, for every view of a vtkTextureViews, its image, its camera and the range it is
 * seen from:
 *
 * @code
 * {"hachureViews": 1,
 *  "cells": {"baseCells": 144, "finestLevel": 4, "hemisphere": 8, "map": "octahedral"},
 *  "views": [{"name": "front", "image": "front.png", "mask": "front-mask.png",
 *    "depth": "front-depth.png", "depthRange": [8.5, 12], "kind": "dependent",
 *    "camera": {"position": [0, 0, 10], "focalPoint": [0, 0, 0], "viewUp": [0, 1, 0],
 *      "viewAngle": 30},
 *    "extremes": [[5, 0, 8], [0, 5, 8], [-5, 0, 8], [0, -5, 8]],
 *    "fade": {"mode": "curve", "curve": [[0, 1], [0.5, 1], [1, 0]]}}],
 *  "blendPoints": [{"position": [0, 0, 50], "direction": [0, 0, -1], "percentage": 50}]}
 * @endcode
 *
 * A view needs "image" and "camera", a camera "position" and "focalPoint", or "matrix": 16 numbers,
 * row by row. "parallelScale" in the place of "viewAngle" makes a camera without perspective.
 * "kind" is "independent" or "dependent", "mode" "curve", "middle" or "even", "map" "octahedral" or
 * "disk"; what is not given has the default of vtkTextureViews. An unknown key is an error. Images
 * are in the folder of the manifest or below it; a name that leads elsewhere is an error, by a link
 * too.
 */

#ifndef vtkTextureViewsManifest_h
#define vtkTextureViewsManifest_h

#include "HachureRenderingModule.h" // for the export macro
#include "vtkObject.h"

#include <string> // for the error

class vtkTextureViews;

class HACHURERENDERING_EXPORT vtkTextureViewsManifest : public vtkObject
{
public:
  static vtkTextureViewsManifest* New();
  vtkTypeMacro(vtkTextureViewsManifest, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Gives views what a manifest and its images say. Views that are equal to those of the same index
   * before keep their counters, so that reading again after painting in one image changes one view.
   * False after an error, which names the path in the manifest and the value; the views then stay
   * as they were.
   */
  bool Read(const char* fileName, vtkTextureViews* views);

  /**
   * Writes a manifest. Images that are in no file, or in one that is not in the manifest's folder,
   * are written as PNG to new files there, and the views told. No other file but the manifest is
   * touched, and that is replaced at once when all the rest is done. False after an error; what was
   * there before is still there.
   */
  bool Write(const char* fileName, vtkTextureViews* views);

  /** The message of the last Read() or Write(); empty: it succeeded. */
  std::string GetError() { return this->Error; }

protected:
  vtkTextureViewsManifest();
  ~vtkTextureViewsManifest() override;

private:
  vtkTextureViewsManifest(const vtkTextureViewsManifest&) = delete;
  void operator=(const vtkTextureViewsManifest&) = delete;

  template <class Work>
  bool Try(const char* caller, const char* fileName, vtkTextureViews* views, Work&& work);

  std::string Error;
};

#endif
