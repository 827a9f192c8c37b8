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
mapper.ScalarVisibilityOff()
actor = vtk.vtkActor()
actor.SetMapper(mapper)

renderer = vtk.vtkRenderer()
renderer.SetBackground(1, 1, 1)
renderer.AddActor(actor)
window = vtk.vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(600, 600)
window.AddRenderer(renderer)
window.Render()

grab = vtk.vtkWindowToImageFilter()
grab.SetInput(window)
writer = vtk.vtkPNGWriter()
writer.SetInputConnection(grab.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "first_picture.png")
writer.Write()
