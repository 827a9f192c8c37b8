// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfacePatches
 * @brief   divides a surface into patches, each of which carries a pattern of its own
 *
 * Patterns slide less over a surface when every part of it moves its own (Breslav et al. 2007,
 * section 3.6). Input and output are a vtkPolyData or a composite of vtkPolyData. The output has,
 * besides all of the input, the cell array PatchId: an integer from 0 on, without gaps over all
 * blocks together; -1 for vertices, lines and cells that are in no patch.
 *
 * The patches come from an array, a selection, connected regions, blocks, creases, or from an
 * automatic division into compact patches. That one is the iteration of Cohen-Steiner, Alliez and
 * Desbrun (Variational shape approximation, 2004): patches grow from seed faces, always by the
 * face of least cost, then proxies and seeds are fitted anew. The cost is not their L2,1, which
 * lets flat and cylindrical regions take any shape, but the squared distance to the patch's
 * centroid plus NormalWeight times that of the normals (Lloyd's method): a similarity transform
 * fits compact patches best. First seeds are spread by farthest points.
 *
 * Points in the same place are one, so that seams of normals or texture coordinates divide nothing.
 * The result is a function of the input and the properties, whatever the number of threads.
 *
 * With a path of cameras the field data array PatchSlide tells for every patch how far, at most,
 * its pattern will slide over it from one camera to the next: the residual of vtkSimilarityTracker
 * in pixels. Automatic patches may be split until it is under a limit.
 *
 * A corner of a polygon or strip that is not finite is an error.
 */

#ifndef vtkSurfacePatches_h
#define vtkSurfacePatches_h

#include "HachureFiltersModule.h" // for the export macro
#include "vtkPassInputTypeAlgorithm.h"

#include <vtkSmartPointer.h> // for the cameras

#include <limits> // for the ranges of the setters
#include <string> // for ArrayName
#include <vector> // for the cameras

class vtkCamera;

class HACHUREFILTERS_EXPORT vtkSurfacePatches : public vtkPassInputTypeAlgorithm
{
public:
  static vtkSurfacePatches* New();
  vtkTypeMacro(vtkSurfacePatches, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Where patches come from.
   */
  enum Methods
  {
    ARRAY = 0,     //!< cells of equal values of an array
    SELECTION = 1, //!< the selection on port 1: a patch per node; the first, 0, is all the rest
    CONNECTED = 2, //!< regions that hang together by points
    BLOCK = 3,     //!< every block with polygons or strips
    CREASE = 4,    //!< regions bounded by edges sharper than CreaseAngle
    AUTOMATIC = 5  //!< NumberOfPatches compact patches
  };

  ///@{
  /**
   * One of Methods. Default AUTOMATIC.
   */
  vtkSetClampMacro(Method, int, ARRAY, AUTOMATIC);
  vtkGetMacro(Method, int);
  void SetMethodToArray() { this->SetMethod(ARRAY); }
  void SetMethodToSelection() { this->SetMethod(SELECTION); }
  void SetMethodToConnected() { this->SetMethod(CONNECTED); }
  void SetMethodToBlock() { this->SetMethod(BLOCK); }
  void SetMethodToCrease() { this->SetMethod(CREASE); }
  void SetMethodToAutomatic() { this->SetMethod(AUTOMATIC); }
  ///@}

  ///@{
  /**
   * ARRAY: name of a cell array or, where none has this name, of a point array, with one component:
   * integers, floating-point numbers without fractions, or strings. Patches are in ascending order
   * of the values; a negative value is no patch. A cell takes the most frequent value of its
   * points, the lowest of several. Default empty, which is an error with ARRAY.
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  /**
   * SELECTION: the selection, on port 1. Cells in several of its nodes go to the first of them;
   * selected points select all cells around them. Anything that vtkExtractSelection understands.
   */
  void SetSelectionConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

  ///@{
  /**
   * CREASE: the largest angle in degrees between the normals of two cells that stay together. Range
   * 0 to 180, default 30 as for the feature angle of vtkPolyDataNormals.
   */
  vtkSetClampMacro(CreaseAngle, double, 0.0, 180.0);
  vtkGetMacro(CreaseAngle, double);
  ///@}

  ///@{
  /**
   * AUTOMATIC: the number of patches wanted. At least 1, default 16. A surface of more separate
   * pieces has patches of several pieces; one of fewer cells, a patch per cell.
   */
  vtkSetClampMacro(NumberOfPatches, int, 1, std::numeric_limits<int>::max());
  vtkGetMacro(NumberOfPatches, int);
  ///@}

  ///@{
  /**
   * AUTOMATIC: how much a turn of the normal by one radian counts against a distance of the radius
   * of a round patch. 0 makes patches of distance alone; more keeps the two sides of a thin sheet
   * apart. Patterns slide least with little of it. Range 0 to 1e6, default 0.1.
   */
  vtkSetClampMacro(NormalWeight, double, 0.0, 1e6);
  vtkGetMacro(NormalWeight, double);
  ///@}

  ///@{
  /**
   * Whether points in the same place are one also when they belong to different blocks. Default on.
   */
  vtkSetMacro(JoinBlocks, bool);
  vtkGetMacro(JoinBlocks, bool);
  vtkBooleanMacro(JoinBlocks, bool);
  ///@}

  ///@{
  /**
   * The camera path, on which successive cameras are one frame apart. A copy of the camera is kept,
   * so that one camera may be moved and added again. Two or more make a path; default none.
   */
  void AddCamera(vtkCamera* camera);
  void RemoveAllCameras();
  int GetNumberOfCameras();
  vtkCamera* GetCamera(int index);
  ///@}

  ///@{
  /**
   * Width and height of the viewport of the path in logical pixels, each at least 1. Default 800 x
   * 600.
   */
  void SetViewportSize(double width, double height);
  void SetViewportSize(const double size[2]) { this->SetViewportSize(size[0], size[1]); }
  vtkGetVector2Macro(ViewportSize, double);
  ///@}

  ///@{
  /**
   * AUTOMATIC: patches that slide more than this on any step of the path, in pixels per frame, are
   * divided in two, worst first. 0, the default, divides none; more needs a camera path. A warning
   * tells when MaximumNumberOfPatches was reached before.
   */
  vtkSetClampMacro(MaximumSlide, double, 0.0, 1e6);
  vtkGetMacro(MaximumSlide, double);
  ///@}

  ///@{
  /**
   * AUTOMATIC: no patch is divided for its slide once there are so many. At least 1, default 256.
   */
  vtkSetClampMacro(MaximumNumberOfPatches, int, 1, 1 << 24);
  vtkGetMacro(MaximumNumberOfPatches, int);
  ///@}

protected:
  vtkSurfacePatches();
  ~vtkSurfacePatches() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Method = AUTOMATIC;
  std::string ArrayName;
  double CreaseAngle = 30.0;
  int NumberOfPatches = 16;
  double NormalWeight = 0.1;
  bool JoinBlocks = true;
  std::vector<vtkSmartPointer<vtkCamera>> Cameras;
  double ViewportSize[2] = { 800.0, 600.0 };
  double MaximumSlide = 0.0;
  int MaximumNumberOfPatches = 256;

private:
  vtkSurfacePatches(const vtkSurfacePatches&) = delete;
  void operator=(const vtkSurfacePatches&) = delete;
};

#endif
