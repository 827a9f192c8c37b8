// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatternLayer
 * @brief one sheet of marks in a style: a field, a tone and an ink
 *
 * A layer puts ink where its field, a number in [0,1] with a uniform distribution, is below its
 * tone. Subclasses define the field; tone and ink are common to all. A layer holds parameters
 * alone: what it remembers between frames belongs to the view that draws it.
 *
 * Setters clamp to the range they state; constants are members of this class.
 *
 * @sa vtkPatternStyle vtkPatternTone vtkImagePatternLayer
 */

#ifndef vtkPatternLayer_h
#define vtkPatternLayer_h

#include "HachureRenderingModule.h"
#include "vtkObject.h"
#include "vtkPatternTone.h"  // For the owned tone
#include "vtkSmartPointer.h" // For the owned tone
#include "vtkType.h"         // For vtkTypeUInt32

#ifndef __VTK_WRAP__
namespace hachure
{
class StyleArchive;
}
#endif

class HACHURERENDERING_EXPORT vtkPatternLayer : public vtkObject
{
public:
  vtkTypeMacro(vtkPatternLayer, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** How ink mixes with what lies below; always in linear light. */
  enum BlendModeType
  {
    OVER = 0,
    MULTIPLY = 1,
    OVERLAY = 2,
    SCREEN = 3
  };

  /** Unit of a length: logical pixels, or millimetres at the style's DotsPerInch. */
  enum LengthUnit
  {
    PIXELS = 0,
    MILLIMETRES = 1
  };

  /** Name of the layer's type in style files: "image" for vtkImagePatternLayer. */
  virtual const char* GetTypeName() = 0;

  ///@{
  /** How dark the layer is. Every layer has a tone of its own; null is refused with an error. */
  virtual void SetTone(vtkPatternTone* tone);
  virtual vtkPatternTone* GetTone();
  ///@}

  ///@{
  /** Colour of the ink, sRGB components 0 to 1; default black. */
  virtual void SetColor(double red, double green, double blue);
  virtual void SetColor(const double color[3]);
  vtkGetVector3Macro(Color, double);
  ///@}

  /** Where an ink has its colour from: its own, or the surface below the mark as it is lit. */
  enum ColorSourceType
  {
    INK = 0,
    SURFACE = 1
  };

  ///@{
  /** Where the ink has its colour from, one of ColorSourceType; default INK, that is Color. */
  vtkSetClampMacro(ColorSource, int, INK, SURFACE);
  vtkGetMacro(ColorSource, int);
  ///@}

  ///@{
  /** Coverage of fully inked paper, 0 (invisible) to 1 (solid); default 1. */
  vtkSetClampMacro(Opacity, double, 0.0, 1.0);
  vtkGetMacro(Opacity, double);
  ///@}

  ///@{
  /** How the ink mixes with the paper and the layers below, one of BlendModeType; default OVER. */
  vtkSetClampMacro(BlendMode, int, OVER, SCREEN);
  vtkGetMacro(BlendMode, int);
  ///@}

  ///@{
  /** Seed of everything random in the layer, any 32-bit number, default 1. Equal seeds give equal
   * pictures. */
  vtkSetMacro(Seed, vtkTypeUInt32);
  vtkGetMacro(Seed, vtkTypeUInt32);
  ///@}

  ///@{
  /** Whether the layer is drawn; default on. */
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  vtkBooleanMacro(Enabled, bool);
  ///@}

  /** Latest change of the layer, its tone, or anything else that it refers to. */
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  /// How far from a pixel the surface must be known to draw the layer there, in logical pixels.
  virtual double GetReach(double vtkNotUsed(dotsPerInch))
  {
    return 0.0;
  }

  /** Lists the parameters of the field; style files are read and written through this. */
  virtual void DescribeField(hachure::StyleArchive& archive) = 0;
#endif

protected:
  vtkPatternLayer();
  ~vtkPatternLayer() override;

private:
  vtkPatternLayer(const vtkPatternLayer&) = delete;
  void operator=(const vtkPatternLayer&) = delete;

  vtkSmartPointer<vtkPatternTone> Tone;
  double Color[3] = { 0.0, 0.0, 0.0 };
  int ColorSource = INK;
  double Opacity = 1.0;
  int BlendMode = OVER;
  vtkTypeUInt32 Seed = 1;
  bool Enabled = true;
};

#endif
