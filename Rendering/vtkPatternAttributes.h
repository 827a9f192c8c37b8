// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The images that the attribute stage writes, in the order of its outputs: some always, others
 * where a style needs them.
 */
#ifndef vtkPatternAttributes_h
#define vtkPatternAttributes_h

#include "vtkPatternLayerPainter.h"

#include <vector>

struct vtkPatternAttributes
{
  enum Image
  {
    COLOR,   ///< display-referred colour; alpha: 1 - half drawn edge, a quarter of it without data,
             ///< 0.03 where another process draws it
    TONE,    ///< tones of four channels
    NORMAL,  ///< normal in view coordinates in one float
    RUN,     ///< first record of the triangles that end at the last vertex
    PATCH,   ///< patch of the triangle, or -1 - the first record that may be its own
    POINT,   ///< model coordinates; w: packed normal of the triangle
    TEXTURE, ///< texture coordinates; z: 1 where there are some
    TEXTURE_SLOPES, ///< their change along x (xy) and y (zw)
    IMAGE_COUNT
  };

  vtkPatternLayerPainter::SurfaceNeed Surface = vtkPatternLayerPainter::NOTHING;
  bool Colors = false;       ///< the surface's own colours are part of the picture
  bool Outline = false;      ///< contours are found in the images
  bool Patches = false;      ///< patches are told apart
  bool Runs = false;         ///< triangles are told apart; see TriangleRuns.h
  bool PrimitiveIds = false; ///< blocks and triangles are, where a translucent surface is drawn
  bool Surroundings = false; ///< some blocks are drawn by other processes; see vtkSurfacePart

  bool Has(Image image) const
  {
    switch (image)
    {
      case NORMAL:
        return this->Outline;
      case RUN:
        return this->Runs;
      case PATCH:
        return this->Patches;
      case POINT:
        return this->Surface >= vtkPatternLayerPainter::POINT;
      case TEXTURE:
      case TEXTURE_SLOPES:
        return this->Surface >= vtkPatternLayerPainter::POINT_AND_TEXTURE;
      default:
        return true;
    }
  }

  /// Outputs of the stage, in order.
  std::vector<Image> Images() const
  {
    std::vector<Image> images;
    for (int image = COLOR; image < IMAGE_COUNT; ++image)
    {
      if (this->Has(static_cast<Image>(image)))
      {
        images.push_back(static_cast<Image>(image));
      }
    }
    return images;
  }

  bool operator==(const vtkPatternAttributes& other) const
  {
    return this->Surface == other.Surface && this->Colors == other.Colors &&
      this->Outline == other.Outline && this->Patches == other.Patches &&
      this->Runs == other.Runs && this->PrimitiveIds == other.PrimitiveIds &&
      this->Surroundings == other.Surroundings;
  }
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternAttributes.h
