// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPatternMotion
 * @brief   exact motion in the image of the surface seen at every pixel, between two states
 *
 * A state is a camera, a matrix for every surface and the positions of its points; the two states
 * are called before and after. At every pixel of the state before, the point of the surface at the
 * centre of the pixel is followed: it keeps its triangle and its barycentric coordinates, and is
 * projected again with the points, the matrix and the camera of the state after. This is what a
 * pattern that sticks to the surface would do, the measure for how patterns move.
 *
 * Compute() finds the triangle seen at every pixel of both states by drawing, in the OpenGL context
 * of a window and without touching its picture; all positions are computed in double precision.
 * Polygons are divided into the triangles that VTK's mappers draw. Surfaces are not cut by clipping
 * planes other than the near and far plane of the cameras, and all are drawn opaque.
 *
 * The output is an image of floats, one pixel per sample and row 0 at the bottom, with the
 * components of Component, all 0 where no surface is seen in the state before.
 *
 * @sa vtkSimilarityTracker
 */

#ifndef vtkPatternMotion_h
#define vtkPatternMotion_h

#include "HachureRenderingModule.h"
#include "vtkObject.h"

#include <memory>

class vtkCamera;
class vtkDataObject;
class vtkImageData;
class vtkMatrix4x4;
class vtkRenderWindow;

class HACHURERENDERING_EXPORT vtkPatternMotion : public vtkObject
{
public:
  static vtkPatternMotion* New();
  vtkTypeMacro(vtkPatternMotion, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Components of a pixel of the output; their names in the array are u, v, visible, facing,
   * distance and label. */
  enum Component
  {
    U = 0,        //!< motion to the right in pixels; 0 where the point goes behind the camera
    V = 1,        //!< motion up in pixels; 0 where the point goes behind the camera
    VISIBLE = 2,  //!< 1 where the point is seen in the state after as well, 0 elsewhere
    FACING = 3,   //!< |n.v| in the state before: 0 edge-on to 1 head-on, on both sides alike
    DISTANCE = 4, //!< from the camera before along its direction of projection, scene units
    LABEL = 5,    //!< the surface, as AddSurface() returned it; 0 where there is none
    NUMBER_OF_COMPONENTS = 6
  };

  ///@{
  /**
   * The cameras of the two states. They are copied, so one camera can be given, moved and given
   * again. Their clipping ranges cut surfaces. Both are needed; default none.
   */
  void SetCameraBefore(vtkCamera* camera);
  vtkCamera* GetCameraBefore();
  void SetCameraAfter(vtkCamera* camera);
  vtkCamera* GetCameraAfter();
  ///@}

  ///@{
  /**
   * Width and height of the image in pixels, from 1 to what textures of the window allow. Default
   * 640 x 480. It need not be the size of the window.
   */
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  /**
   * Adds a surface: polydata, or a composite of polydata, before and after. The after must have the
   * same blocks, numbers of points and polygons as the before; none means that the points stay
   * where they are. Likewise the matrices, which lead from the surface to the scene and are copied:
   * matrixBefore none is the identity, matrixAfter none is matrixBefore. Data are kept by reference
   * and read by Compute(). FACING uses the point normals of the data before where it has any, the
   * polygons' own planes otherwise. Returns the label of the surface, from 1 on.
   */
  int AddSurface(vtkDataObject* before, vtkDataObject* after = nullptr,
    vtkMatrix4x4* matrixBefore = nullptr, vtkMatrix4x4* matrixAfter = nullptr);

  /**
   * Adds something that hides surfaces in either state, but is not measured itself: its pixels are
   * 0 in all components. Arguments as for AddSurface().
   */
  void AddOccluder(vtkDataObject* before, vtkDataObject* after = nullptr,
    vtkMatrix4x4* matrixBefore = nullptr, vtkMatrix4x4* matrixAfter = nullptr);

  /** Forgets all surfaces and occluders; labels begin at 1 again. */
  void RemoveAllSurfaces();

  /** Number of surfaces, occluders not counted. */
  int GetNumberOfSurfaces();

  /**
   * Draws both states in the OpenGL context of this window, which is made when it has none yet, and
   * makes a new output. False with an error message, and no output, where something is wrong. No
   * OpenGL object outlives the call.
   */
  bool Compute(vtkRenderWindow* window);

  /** The image made by the last Compute(), null without one. It is never written again. */
  vtkImageData* GetOutput();

protected:
  vtkPatternMotion();
  ~vtkPatternMotion() override;

private:
  vtkPatternMotion(const vtkPatternMotion&) = delete;
  void operator=(const vtkPatternMotion&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
  int Size[2] = { 640, 480 };
};

#endif
