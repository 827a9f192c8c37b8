// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Measures in the drawn picture how visible every sample of one object is: one byte a sample, read
 * back a frame later. No other part of the picture leaves the graphics card.
 */
#ifndef vtkPatternVisibility_h
#define vtkPatternVisibility_h

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkPatternQuad.h"
#include "vtkTextureObject.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstdint>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkPatternSamples;
class vtkShaderProgram;
class vtkWindow;

class vtkPatternVisibility
{
public:
  vtkPatternVisibility();
  ~vtkPatternVisibility();

  /// Compares the samples with the object's own attribute images, right after it was drawn.
  /// `modelToClip` is the drawn projection, `viewport` x, y, width, height in the framebuffer.
  bool MeasureOwn(vtkOpenGLRenderWindow* window, const vtkPatternSamples& samples,
    const glm::dmat4& modelToClip, const std::array<int, 4>& viewport, vtkTextureObject* depth);

  /// Keeps what other objects do not hide, when the picture is finished.
  void MeasureScene(vtkOpenGLRenderWindow* window, vtkTextureObject* depth);

  /// Bytes of the last MeasureScene, empty where there was none since the last call.
  std::vector<std::uint8_t> Read(vtkOpenGLRenderWindow* window);
  /// The same where other processes draw parts of the scene: the byte is the last one, the others
  /// are the window depth that it belongs to, so that the smallest number of all is what a picture
  /// of everything would give.
  std::vector<std::uint32_t> ReadNearest(vtkOpenGLRenderWindow* window);
  /// Whether ReadNearest is used.
  void SetShared(bool shared);
  /// Samples of the last MeasureOwn.
  std::size_t GetCount() const { return this->Count; }

  bool IsOwnMeasured() const { return this->OwnMeasured; }
  void Forget();
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Prepare(vtkOpenGLRenderWindow* window, const vtkPatternSamples& samples);
  struct Stage
  {
    vtkPatternQuad& Quad;
    vtkShaderProgram* Program; // of it
    vtkOpenGLFramebufferObject* Target;
    vtkTextureObject* Depth;
    vtkTextureObject* PerSample; // one texel a sample
    const char* PerSampleName;
  };
  void Draw(vtkOpenGLRenderWindow* window, const Stage& stage);
  std::vector<std::uint8_t> ReadTexels(vtkOpenGLRenderWindow* window);

  vtkPatternQuad OwnQuad;
  vtkPatternQuad SceneQuad;
  vtkNew<vtkTextureObject> Positions;
  vtkNew<vtkTextureObject> Own;
  vtkNew<vtkTextureObject> Scene;
  vtkNew<vtkOpenGLFramebufferObject> OwnFramebuffer;
  vtkNew<vtkOpenGLFramebufferObject> SceneFramebuffer;
  std::array<int, 2> Size = { 0, 0 };
  std::size_t Count = 0;
  std::uint64_t PositionVersion = 0;
  const vtkPatternSamples* Source = nullptr;
  bool Shared = false;
  bool OwnMeasured = false;
  bool SceneMeasured = false;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternVisibility.h
