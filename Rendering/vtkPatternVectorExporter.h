// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatternVectorExporter
 * @brief Writes a picture of stipples and outlines as SVG or PDF, in millimetres.
 *
 * The exporter draws the window, then writes what vtkPatternMapper has drawn on visible actors as
 * shapes: stipples as discs, and the contours of the surfaces as strokes with round ends. Contours
 * that something hides, be it drawn with patterns or not, are left out; what is translucent hides
 * nothing. Everything else in the window, such as images of patterns, is not written.
 *
 * Contours have the colour, the width and the kinds of lines of the style's outline. Where that is
 * off, they are silhouettes and borders, black and 0.35 mm wide. Their silhouettes run smoothly
 * over the surface, unless the actor has flat shading.
 *
 * SVG files hold circle and path elements in groups by ink, with the millimetre as their unit, and
 * can be edited as they are. PDF files hold one page, with circles as four Bezier curves; they need
 * a build with Cairo.
 *
 * Errors, after which a file of that name is as it was before: no window or file name, a name that
 * ends with neither .svg nor .pdf, a file that cannot be written, and PDF without Cairo.
 *
 * @sa vtkPatternMapper vtkPatternStyle
 */
#ifndef vtkPatternVectorExporter_h
#define vtkPatternVectorExporter_h

#include "HachureRenderingModule.h"
#include "vtkExporter.h"

class HACHURERENDERING_EXPORT vtkPatternVectorExporter : public vtkExporter
{
public:
  static vtkPatternVectorExporter* New();
  vtkTypeMacro(vtkPatternVectorExporter, vtkExporter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to write; its extension, .svg or .pdf, tells the format. No default. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Size of a pixel of the window on the page, in millimetres. Range 0 to 1000; 0, the default:
   * what DotsPerInch and PixelScale of the first style in the window say, and where there is none,
   * 96 dots per inch.
   */
  vtkSetClampMacro(MillimetresPerPixel, double, 0.0, 1000.0);
  vtkGetMacro(MillimetresPerPixel, double);
  ///@}

  ///@{
  /** Whether contours are written; default on. */
  vtkSetMacro(Silhouettes, bool);
  vtkGetMacro(Silhouettes, bool);
  vtkBooleanMacro(Silhouettes, bool);
  ///@}

  ///@{
  /** Whether stipples are written; default on. */
  vtkSetMacro(Stipples, bool);
  vtkGetMacro(Stipples, bool);
  vtkBooleanMacro(Stipples, bool);
  ///@}

  ///@{
  /**
   * Whether the page is painted in the background colour of the first renderer; default on. Off:
   * the page is transparent.
   */
  vtkSetMacro(Background, bool);
  vtkGetMacro(Background, bool);
  vtkBooleanMacro(Background, bool);
  ///@}

protected:
  vtkPatternVectorExporter();
  ~vtkPatternVectorExporter() override;

  void WriteData() override;

private:
  vtkPatternVectorExporter(const vtkPatternVectorExporter&) = delete;
  void operator=(const vtkPatternVectorExporter&) = delete;

  char* FileName = nullptr;
  double MillimetresPerPixel = 0.0;
  bool Silhouettes = true;
  bool Stipples = true;
  bool Background = true;
};

#endif
