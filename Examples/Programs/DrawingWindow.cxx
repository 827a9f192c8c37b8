// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DrawingWindow.h"

#include "UserError.h"

#include <cstdlib>

#ifdef HACHURE_HAS_EGL
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>
#include <vtk_glew.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#endif

namespace hachure::program
{
namespace
{
#ifdef HACHURE_HAS_EGL
/// Draws into VTK's own framebuffers in an OpenGL context that has no surface.
class SurfacelessWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static SurfacelessWindow* New();
  vtkTypeMacro(SurfacelessWindow, vtkGenericOpenGLRenderWindow);

  /// False where the machine has no such context.
  bool Create();

  void MakeCurrent() override
  {
    if (this->Context != EGL_NO_CONTEXT)
    {
      eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, this->Context);
    }
  }
  bool IsCurrent() override
  {
    return this->Context != EGL_NO_CONTEXT && eglGetCurrentContext() == this->Context;
  }
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }
  void OpenGLInitContext() override;
  void Finalize() override;

protected:
  SurfacelessWindow() { this->FrameBlitMode = NoBlit; }
  ~SurfacelessWindow() override { this->Finalize(); }

private:
  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLContext Context = EGL_NO_CONTEXT;
};
vtkStandardNewMacro(SurfacelessWindow);

//----------------------------------------------------------------------------
bool SurfacelessWindow::Create()
{
  this->Display =
    eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (!eglInitialize(this->Display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
  {
    return false;
  }
  const EGLint version[] = { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
  this->Context = eglCreateContext(this->Display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
  if (this->Context == EGL_NO_CONTEXT)
  {
    return false;
  }
  // Before VTK first asks for state. GLEW loads all functions, then regrets that there is no X
  // display.
  this->MakeCurrent();
  const GLenum result = glewInit();
  return result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
}

//----------------------------------------------------------------------------
void SurfacelessWindow::OpenGLInitContext()
{
  this->GlewInitValid = true;
  this->Initialized = true;
  this->MaximumHardwareLineWidth = 1.0;
  this->Superclass::OpenGLInitContext();
}

//----------------------------------------------------------------------------
void SurfacelessWindow::Finalize()
{
  this->Superclass::Finalize();
  if (this->Context != EGL_NO_CONTEXT)
  {
    eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(this->Display, this->Context);
    this->Context = EGL_NO_CONTEXT;
  }
}

vtkSmartPointer<vtkRenderWindow> makeSurfacelessWindow()
{
  auto window = vtkSmartPointer<SurfacelessWindow>::New();
  return window->Create() ? window : nullptr;
}
#else
vtkSmartPointer<vtkRenderWindow> makeSurfacelessWindow()
{
  return nullptr;
}
#endif
} // namespace

//----------------------------------------------------------------------------
vtkSmartPointer<vtkRenderWindow> makeDrawingWindow()
{
  const char* display = std::getenv("DISPLAY");
  const vtkSmartPointer<vtkRenderWindow> window =
    display && *display ? vtkSmartPointer<vtkRenderWindow>::New() : makeSurfacelessWindow();
  if (!window)
  {
    throw UserError("no display to draw with: set DISPLAY, or start under xvfb-run");
  }
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetMultiSamples(0);
  return window;
}
} // namespace hachure::program
