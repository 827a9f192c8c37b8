// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTextureViews
 * @brief   pictures of a surface, each with its camera, that a view-dependent texture is made of
 *
 * A view (Grimm and Kowalski 2002, section 5) is a picture that was painted over, or taken of, a
 * surface, together with the camera that sees the surface so. An independent view colours the
 * surface for all cameras; a dependent one is seen from the cameras near its own alone: its extreme
 * points say how near, its fade how it comes and goes. Blend points say from where the independent
 * colours are seen instead of the dependent ones.
 *
 * All positions, directions and matrices are in the coordinates of the surface itself (model
 * coordinates), whatever transform its actor has.
 *
 * Views, extreme points, points of the fade curve and blend points are numbered from 0 on; those
 * after a removed one move up. An index out of range, a wrong image, camera or number is an error
 * that names the value and changes nothing.
 *
 * Every view counts its changes three times, for its images, its camera and its range, so that
 * whoever uses views can do again what depends on one of them alone.
 *
 * @sa vtkTextureViewsManifest
 */

#ifndef vtkTextureViews_h
#define vtkTextureViews_h

#include "HachureFiltersModule.h" // for the export macro
#include "vtkObject.h"

#include <array>  // for points
#include <memory> // for the views
#include <string> // for names

class vtkCamera;
class vtkImageData;
class vtkMatrix4x4;

class HACHUREFILTERS_EXPORT vtkTextureViews : public vtkObject
{
public:
  static vtkTextureViews* New();
  vtkTypeMacro(vtkTextureViews, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** From where a view is seen. */
  enum Kinds
  {
    INDEPENDENT = 0, //!< from everywhere
    DEPENDENT = 1    //!< from the cameras that its extreme points enclose
  };

  /** How a dependent view goes from its own camera to the border of its range. */
  enum FadeModes
  {
    CURVE = 0,  //!< every point of the surface by the fade curve
    MIDDLE = 1, //!< it grows from the middle of the picture outwards
    EVEN = 2    //!< the whole picture alike
  };

  /** How directions over the surface go to a square. */
  enum HemisphereMaps
  {
    OCTAHEDRAL = 0, //!< to all of the square
    DISK = 1        //!< to the disk in it, as in the paper
  };

  ///@{
  /**
   * Appends an independent view and returns its index, or -1 after an error.
   *
   * Of the camera count position, focal point, view up, and the vertical view angle (1e-6 to 179
   * degrees) or the parallel scale (above 0). These are copied; the camera sees a picture of
   * the width and height of the image. The focal point must differ from the position, and the view
   * up must point across the direction of view.
   *
   * A matrix leads from the coordinates of the surface to clip coordinates, columns being
   * multiplied from the left; it must not be singular. Depth, the third row, only tells on which
   * side a camera without perspective is: there it is least.
   *
   * The image is kept by reference: one slice of 8 bits and 1 to 4 components. One is grey, two are
   * grey and alpha, three or four red, green, blue (and alpha), in sRGB. Where alpha is 0 the view
   * says nothing.
   */
  int AddView(const std::string& name, vtkCamera* camera, vtkImageData* image);
  int AddView(const std::string& name, vtkMatrix4x4* modelToClip, vtkImageData* image);
  ///@}

  void RemoveView(int view);
  void RemoveAllViews();
  int GetNumberOfViews();

  /** Puts a view at another place in the list; those between move by one. */
  void MoveView(int from, int to);

  /** The first view of a name; -1: there is none. */
  int FindView(const std::string& name);

  ///@{
  /** Any text. Several views may have the same. Default as given to AddView(). */
  void SetViewName(int view, const std::string& name);
  std::string GetViewName(int view);
  ///@}

  ///@{
  /**
   * The picture, as for AddView(). With a mask or a depth image it must keep its size. It is
   * forgotten of which file the former one was.
   */
  void SetViewImage(int view, vtkImageData* image);
  vtkImageData* GetViewImage(int view);
  ///@}

  ///@{
  /**
   * A mask besides the alpha of the picture, which is multiplied by it: an image of its size and of
   * 8 bits, of which the first component counts; 0 hides. Null is none, the default.
   */
  void SetViewMask(int view, vtkImageData* mask);
  vtkImageData* GetViewMask(int view);
  ///@}

  ///@{
  /**
   * How far the surface was where the picture was made, for programs to paint with; nothing else
   * reads it. An image of the size of the picture, of 16 bits and one component: 0 is `nearest` and
   * 65534 `farthest`, distances from the camera along its direction of view; 65535 is no surface.
   * Null is none, the default.
   */
  void SetViewDepth(int view, vtkImageData* depth, double nearest, double farthest);
  vtkImageData* GetViewDepth(int view);
  void GetViewDepthRange(int view, double range[2]);
  ///@}

  ///@{
  /**
   * The files that hold these images as they are, by absolute names. Default empty: none. Setting
   * an image forgets its file; whoever paints in it must set an empty name.
   */
  void SetViewImageFileName(int view, const std::string& fileName);
  std::string GetViewImageFileName(int view);
  void SetViewMaskFileName(int view, const std::string& fileName);
  std::string GetViewMaskFileName(int view);
  void SetViewDepthFileName(int view, const std::string& fileName);
  std::string GetViewDepthFileName(int view);
  ///@}

  ///@{
  /**
   * The camera, as for AddView(). It takes the place of a matrix, and a matrix its. What is
   * returned is a copy, null where the view has a matrix; changing it changes no view.
   */
  void SetViewCamera(int view, vtkCamera* camera);
  vtkCamera* GetViewCamera(int view);
  void SetViewMatrix(int view, vtkMatrix4x4* modelToClip);
  vtkMatrix4x4* GetViewMatrix(int view);
  ///@}

  ///@{
  /**
   * The view up of a view's camera, of any length: VTK's cameras give it the length 1.
   */
  void SetViewUp(int view, const double viewUp[3]);
  void GetViewUp(int view, double viewUp[3]);
  ///@}

  /**
   * From the coordinates of the surface to clip coordinates, of a camera or a matrix. The clipping
   * range of a camera is from a hundredth of to a hundred times the distance of its focal point.
   * False after an error.
   */
  bool ComputeModelToClip(int view, vtkMatrix4x4* result);

  /**
   * Where the view is seen from, in homogeneous coordinates of the surface: the last number is 1,
   * or 0 where the first three are the direction towards a camera without perspective. False after
   * an error.
   */
  bool ComputeEye(int view, double eye[4]);

  ///@{
  /** One of Kinds. Default INDEPENDENT. */
  void SetViewKind(int view, int kind);
  int GetViewKind(int view);
  ///@}

  ///@{
  /**
   * Positions of cameras on the border of the range from where a dependent view is seen, usually
   * four around its own camera. Default none: it is seen from everywhere. Adding one returns its
   * index, or -1 after an error.
   */
  int AddExtremePoint(int view, const double position[3]);
  void SetExtremePoint(int view, int point, const double position[3]);
  void GetExtremePoint(int view, int point, double position[3]);
  void RemoveExtremePoint(int view, int point);
  void RemoveAllExtremePoints(int view);
  int GetNumberOfExtremePoints(int view);
  ///@}

  ///@{
  /** One of FadeModes. Default CURVE. */
  void SetFadeMode(int view, int mode);
  int GetFadeMode(int view);
  ///@}

  ///@{
  /**
   * Points of the fade curve, joined by straight lines: how much of the view is seen (0 to 1) at an
   * angle from its own camera (0) to the border of its range (1). Default (0,1), (0.5,1), (1,0).
   * Without points all of it is seen up to the border. Adding puts a point after those of lesser or
   * the same angle, and returns its index, or -1 after an error.
   */
  int AddFadePoint(int view, double angle, double share);
  void GetFadePoint(int view, int point, double angleAndShare[2]);
  void RemoveAllFadePoints(int view);
  int GetNumberOfFadePoints(int view);
  ///@}

  ///@{
  /**
   * Cameras, by position and direction of view, from which a percentage (0 to 100) of the colour is
   * that of the independent views (appendix A). Default none: dependent views are not held back.
   * Adding one returns its index, or -1 after an error.
   */
  int AddBlendPoint(const double position[3], const double direction[3], double percentage);
  void SetBlendPoint(
    int point, const double position[3], const double direction[3], double percentage);
  void GetBlendPointPosition(int point, double position[3]);
  void GetBlendPointDirection(int point, double direction[3]);
  double GetBlendPointPercentage(int point);
  void RemoveBlendPoint(int point);
  void RemoveAllBlendPoints();
  int GetNumberOfBlendPoints();
  ///@}

  ///@{
  /**
   * Cells of the coarsest level wanted on the surface: their area is that of the surface over this
   * number. Range 1 to 1000000, default 144.
   */
  vtkSetClampMacro(BaseCells, int, 1, 1000000);
  vtkGetMacro(BaseCells, int);
  ///@}

  ///@{
  /**
   * The level of the smallest cells; they are divided in four from level to level. Range 0 to 8,
   * default 4.
   */
  vtkSetClampMacro(FinestLevel, int, 0, 8);
  vtkGetMacro(FinestLevel, int);
  ///@}

  ///@{
  /**
   * Directions a side of the square of directions of every cell: 4, 8 or 16, all else is an error.
   * Default 8.
   */
  void SetHemisphere(int hemisphere);
  vtkGetMacro(Hemisphere, int);
  ///@}

  ///@{
  /** One of HemisphereMaps. Default OCTAHEDRAL. */
  vtkSetClampMacro(HemisphereMap, int, OCTAHEDRAL, DISK);
  vtkGetMacro(HemisphereMap, int);
  ///@}

  ///@{
  /**
   * When a view changed: its picture and mask, also where they were changed in place; its camera,
   * to which the ratio of width and height of the picture belongs; its kind, extreme points and
   * fade. 0 after an error. Names, depth images and the order of views are in GetMTime() alone.
   */
  vtkMTimeType GetViewImageMTime(int view);
  vtkMTimeType GetViewCameraMTime(int view);
  vtkMTimeType GetViewRangeMTime(int view);
  ///@}

  /** When any of this changed, images changed in place included. */
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * Takes all of another object; deep copies have images of their own. What is equal in the view of
   * the same index, also pixel by pixel, stays as it is and keeps its counter.
   */
  void DeepCopy(vtkTextureViews* source);
  void ShallowCopy(vtkTextureViews* source);
  ///@}

protected:
  vtkTextureViews();
  ~vtkTextureViews() override;

private:
  vtkTextureViews(const vtkTextureViews&) = delete;
  void operator=(const vtkTextureViews&) = delete;

  struct Image;
  struct View;
  struct BlendPoint;
  struct Internals;
  View* ViewAt(int view, const char* caller);
  std::array<double, 3>* ExtremePointAt(int view, int point, const char* caller);
  BlendPoint* BlendPointAt(int point, const char* caller);
  bool IsIn(int index, std::size_t count, const char* what, const char* caller);
  bool Refuses(const char* caller, const std::string& fault);
  int Append(View view, vtkImageData* image);
  bool TakeCamera(View& view, vtkCamera* camera, const char* caller);
  bool TakeMatrix(View& view, vtkMatrix4x4* matrix, const char* caller);
  void Copy(vtkTextureViews* source, bool deep);
  void RangeModified(View& view);

  std::unique_ptr<Internals> Internal;
  int BaseCells = 144;
  int FinestLevel = 4;
  int Hemisphere = 8;
  int HemisphereMap = OCTAHEDRAL;
};

#endif
