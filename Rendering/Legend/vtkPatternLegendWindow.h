// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws into framebuffers of its own in the OpenGL context of another window, which it leaves as it
 * was. Internal.
 */
#ifndef vtkPatternLegendWindow_h
#define vtkPatternLegendWindow_h

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

class vtkPatternLegendWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkPatternLegendWindow* New();
  vtkTypeMacro(vtkPatternLegendWindow, vtkGenericOpenGLRenderWindow);

  /// The window with the context, which must be made already.
  void SetOwner(vtkOpenGLRenderWindow* owner) { this->Owner = owner; }

  void MakeCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }
  void OpenGLInitContext() override;

protected:
  vtkPatternLegendWindow();
  ~vtkPatternLegendWindow() override;

private:
  vtkPatternLegendWindow(const vtkPatternLegendWindow&) = delete;
  void operator=(const vtkPatternLegendWindow&) = delete;

  vtkWeakPointer<vtkOpenGLRenderWindow> Owner;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternLegendWindow.h
