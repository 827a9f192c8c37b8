# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Strips that explain colours and marks, with words beside them, on a sheet where a unit is a pixel."""

import numpy
import vtk
from sheet import SCALE
from vtk.util.numpy_support import numpy_to_vtk

WIDTH, HEIGHT, BOTTOM = 26, 200, -110  # pixels, from the middle of the sheet
STEPS = 100
LINES = 0.25, 0.25, 0.25  # their colour
GAP, BASELINE, ABOVE = 6, -5, 14  # of words beside the strip and above it, pixels


def plain(sheet, data, color):
    """A surface or lines of one colour."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    look = sheet.add(mapper).GetProperty()
    look.SetColor(*color)
    look.SetLineWidth(SCALE)
    look.LightingOff()


def with_values(plane, **ends):
    """The strip with arrays that go from a first value, below, to a last one."""
    for name, (first, last) in ends.items():
        values = numpy.linspace(first, last, STEPS + 1).repeat(2).astype(numpy.float32)
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        plane.GetPointData().AddArray(array)
    return plane


def write(sheet, text, x, y):
    words = vtk.vtkTextActor()
    words.SetInput(text)
    words.GetTextProperty().SetFontSize(12 * SCALE)
    words.GetTextProperty().SetColor(0, 0, 0)
    width, height = sheet.window.GetSize()
    words.SetPosition(SCALE * x + width / 2, SCALE * y + height / 2)
    sheet.renderer.AddActor2D(words)


def legend_bar(sheet, left, title, labels):
    """A strip, still without colours, its title and its labels (text, place from 0 below to 1 above)."""
    write(sheet, title, left - 2, BOTTOM + HEIGHT + ABOVE)
    for text, place in labels:
        write(sheet, text, left + WIDTH + GAP, BOTTOM + place * HEIGHT + BASELINE)
    plane = vtk.vtkPlaneSource()
    plane.SetOrigin(left, BOTTOM, 0)
    plane.SetPoint1(left + WIDTH, BOTTOM, 0)
    plane.SetPoint2(left, BOTTOM + HEIGHT, 0)
    plane.SetYResolution(STEPS)
    plane.Update()
    rim = vtk.vtkFeatureEdges()
    rim.SetInputData(plane.GetOutput())
    rim.ColoringOff()
    rim.Update()
    plain(sheet, rim.GetOutput(), LINES)
    return plane.GetOutput()
