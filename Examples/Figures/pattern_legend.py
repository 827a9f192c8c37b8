# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The relief of the earth in strokes and dots, with a legend, and a skull with one of its light: pattern_legend.py [FILE.png]"""

import hachure
import numpy
import vtk
import vtk.util.numpy_support as arrays
from sea import heights, named, on_sphere
from sheet import DATA, Sheet, save, skull


def globe():
    """The earth, of radius 1, with its height as ROSE."""
    latitude, longitude = numpy.mgrid[-89.5:90, 20.5:381]
    grid = vtk.vtkStructuredGrid()
    grid.SetDimensions(*latitude.shape[::-1], 1)
    grid.GetPointData().SetScalars(named(heights()[:, numpy.arange(361) % 360], "ROSE"))
    places = vtk.vtkPoints()
    places.SetData(arrays.numpy_to_vtk(on_sphere(latitude, longitude).reshape(-1, 3), deep=True))
    grid.SetPoints(places)
    surface = vtk.vtkStructuredGridGeometryFilter()
    surface.SetInputData(grid)
    surface.Update()
    return surface.GetOutput()


def panel(width, surface, style, position, angle, title):
    """A surface with its legend beside it."""
    mapper = hachure.vtkPatternMapper()
    mapper.SetInputData(surface)
    mapper.SetStyle(style)
    mapper.ScalarVisibilityOff()
    sheet = Sheet(width, 300)
    actor = sheet.add(mapper)
    legend = hachure.vtkPatternLegendActor()
    legend.SetSurface(actor)
    legend.SetTitle(title)
    legend.SetPosition(0.76, 0.1)
    legend.SetPosition2(0.23, 0.8)
    sheet.renderer.AddViewProp(legend)
    sheet.look(position, (0, 0, 0), angle=angle)
    sheet.camera.SetWindowCenter(0.28, 0)  # to the left
    sheet.draw()
    return sheet.picture()


relief = hachure.vtkPatternStyle()
relief.LoadFile(str(DATA.parent / "Styles" / "relief.json"))
relief.SetPaperColor(1, 1, 1)
pictures = [
    panel(420, globe(), relief, (0.6, 5.6, 2.2), 23, "Height (m)"),
    panel(400, skull(), hachure.style("cross-hatch"), (-1.6, -5.6, 0.9), 28, ""),
]
save([pictures], "pattern_legend.png")
