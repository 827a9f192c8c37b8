# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a hatched surface: first_picture.py [FILE.png]"""

import sys

import hachure
import vtk

shape = vtk.vtkParametricFunctionSource()
shape.SetParametricFunction(vtk.vtkParametricBoy())
mapper = hachure.vtkPatternMapper()
mapper.SetInputConnection(shape.GetOutputPort())
mapper.SetStyle(hachure.style("hatch"))
actor = vtk.vtkActor()
actor.SetMapper(mapper)
renderer = vtk.vtkRenderer()
renderer.AddActor(actor)
window = vtk.vtkRenderWindow()
window.AddRenderer(renderer)

# White paper around it, and a picture file instead of a window.
renderer.SetBackground(1, 1, 1)
renderer.ResetCamera()
renderer.GetActiveCamera().Zoom(1.4)
window.SetSize(400, 400)
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.Render()
grab = vtk.vtkWindowToImageFilter()
grab.SetInput(window)
writer = vtk.vtkPNGWriter()
writer.SetInputConnection(grab.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "first_picture.png")
writer.Write()
