// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What back ends on a graphics card have in common. Three steps, none of which reads back: how much
 * of each kernel is seen, one fragment a kernel; the sums; and the field from them.
 */
#ifndef vtkNoiseGpuBackEnd_h
#define vtkNoiseGpuBackEnd_h

#include "vtkNew.h"
#include "vtkNoiseBackEnd.h"
#include "vtkNoiseKernelBuffers.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkPatternQuad.h"
#include "vtkTextureObject.h"

#include <string>
#include <utility>
#include <vector>

class vtkShaderProgram;

class HACHURERENDERING_EXPORT vtkNoiseGpuBackEnd : public vtkNoiseBackEnd
{
public:
  vtkNoiseGpuBackEnd();
  ~vtkNoiseGpuBackEnd() override;

  bool Draw(vtkOpenGLRenderWindow* window, const Task& task, vtkTextureObject* field) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /// The two sums of each pixel of the last task's rectangle, row by row; for tests.
  std::vector<float> ReadSums(vtkOpenGLRenderWindow* window);

  /// Whether a window draws into images of floating point numbers and reads buffers.
  static bool CanDrawFloats(vtkOpenGLRenderWindow* window);

protected:
  using Stage = vtkNoiseKernelBuffers::Stage;
  using Textures = std::vector<std::pair<std::string, vtkTextureObject*>>;

  /// Fills Sums, into which is drawn now, in the rectangle's size from its first texel on. The
  /// textures of Inputs() are active. False where a shader does not compile.
  virtual bool Sum(vtkOpenGLRenderWindow* window, const Task& task) = 0;

  /// Depth, ids, shares, and those of the kernels.
  Textures Inputs(const Task& task) const;
  void SetInputs(vtkShaderProgram* program, const Textures& textures) const;

  vtkNoiseKernelBuffers Buffers;
  vtkNew<vtkTextureObject> Sums;
  vtkNew<vtkOpenGLFramebufferObject> SumsFramebuffer;

  /// Draws it with a shader that needs these textures. False where that does not compile.
  bool DrawQuad(vtkOpenGLRenderWindow* window, vtkPatternQuad& quad, const std::string& shader,
    const Textures& textures) const;

private:
  bool Upload(vtkOpenGLRenderWindow* window, const Task& task);
  bool MeasureShares(vtkOpenGLRenderWindow* window, const Task& task);
  bool MakeSums(vtkOpenGLRenderWindow* window, const Task& task);
  bool Finish(vtkOpenGLRenderWindow* window, const Task& task, vtkTextureObject* field);

  vtkNew<vtkTextureObject> Ids;
  vtkNew<vtkTextureObject> Shares;
  vtkNew<vtkOpenGLFramebufferObject> SharesFramebuffer;
  vtkNew<vtkOpenGLFramebufferObject> FieldFramebuffer;
  vtkPatternQuad ShareQuad;
  vtkPatternQuad FinishQuad;
  bool HasIds = false;
  std::array<int, 2> Size = { 0, 0 }; // of the last sums
};

#endif
// VTK-HeaderTest-Exclude: vtkNoiseGpuBackEnd.h
