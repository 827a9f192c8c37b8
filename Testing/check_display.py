# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ends with 0 where VTK gets an OpenGL context that is new enough to draw patterns."""

import sys

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  brings the window's implementation
from vtkmodules.vtkRenderingCore import vtkRenderWindow

window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(16, 16)
window.Render()
if not window.SupportsOpenGL():
    sys.exit("no OpenGL 3.2 context: " + (window.GetOpenGLSupportMessage() or "no reason given"))
