// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// A window to draw in that is never shown, with an X display or without.

#ifndef DrawingWindow_h
#define DrawingWindow_h

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

namespace hachure::program
{
/// VTK's own window where DISPLAY is set. Elsewhere one on a surfaceless EGL context, where the
/// build has EGL. Throws UserError when neither can be had.
vtkSmartPointer<vtkRenderWindow> makeDrawingWindow();
} // namespace hachure::program

#endif
