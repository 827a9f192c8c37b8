# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A mesh, its stipples, 16 times as large, and the particles of the classic order: stipple_refined.py [FILE.png]"""

import hachure
import vtk
from sheet import Sheet, save

PARTICLES = 2500
PLACE = 0.62, 0.235  # of the close-up, in parts of the picture from the left and from below
LARGER = 16
WIDTH, HEIGHT = 225, 190


def coarse():
    """A ring of 12 x 6 quads, cut in two, with the normals of a round one."""
    ring = vtk.vtkParametricTorus()
    ring.SetCrossSectionRadius(0.45)
    source = vtk.vtkParametricFunctionSource()
    source.SetParametricFunction(ring)
    source.SetUResolution(12)
    source.SetVResolution(6)
    source.Update()
    return source.GetOutput()


def stipples(mesh):
    mapper = hachure.vtkPatternMapper()
    mapper.SetInputData(mesh)
    mapper.SetStyle(hachure.style("stipple"))
    mapper.GetStyle().GetLayer(0).SetSize(2)
    return mapper


def lines(mesh):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    return mapper


def particles(mesh):
    hierarchy = hachure.vtkStippleHierarchy()
    hierarchy.SetInputData(mesh)
    hierarchy.SetOrderToClassic()
    hierarchy.SetNumberOfPoints(PARTICLES)
    hierarchy.GenerateParticleMeshOn()
    hierarchy.Update()
    return hierarchy.GetOutput(1)


def drawn(mapper, larger=1):
    sheet = Sheet(WIDTH, HEIGHT)
    look = sheet.add(mapper).GetProperty()
    if not hasattr(mapper, "GetStyle"):
        look.EdgeVisibilityOn()
        look.LightingOff()
    sheet.look((0, -5, 5), (0, 0, 0), angle=23)
    if larger > 1:
        sheet.camera.SetWindowCenter(*(larger * (2 * part - 1) for part in PLACE))
        sheet.camera.Zoom(larger)
    sheet.draw()
    return sheet.picture()


def framed(picture, middle=(0.5, 0.5), size=1):
    """With a thin frame around a part of it."""
    height, width = picture.shape[:2]
    left, bottom = (int(length * (part - size / 2)) for part, length in zip(middle, (width, height)))
    right, top = left + int(width * size) - 1, bottom + int(height * size) - 1
    picture[[bottom, top], left:right + 1] = picture[bottom:top + 1, [left, right]] = 0
    return picture


mesh = coarse()
save([[drawn(lines(mesh)), framed(drawn(stipples(mesh)), PLACE, 1 / LARGER),
       framed(drawn(stipples(mesh), LARGER)), drawn(lines(particles(mesh)))]], "stipple_refined.png")
