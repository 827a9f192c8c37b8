# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Weighted and unweighted samples on a table: table.py [FILE.png]

The same dots at the start and, red pins in the cloth, after a walk around a quarter of the table.
"""

import hachure
import numpy
import vtk
from sheet import Sheet, save
from slide import Slide, pin


def turned(profile, waves=0.0):
    """A surface of revolution about z through points (radius, z), with waves below z = 0."""
    points = vtk.vtkPoints()
    for radius, z in profile:
        for angle in numpy.linspace(0, 2 * numpy.pi, 145):
            r = radius * (1 - waves * min(z, 0) * numpy.sin(15 * angle))
            points.InsertNextPoint(r * numpy.cos(angle), r * numpy.sin(angle), z)
    grid = vtk.vtkStructuredGrid()
    grid.SetDimensions(145, len(profile), 1)
    grid.SetPoints(points)
    surface = vtk.vtkStructuredGridGeometryFilter()  # keeps the order of cells
    surface.SetInputData(grid)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(surface.GetOutputPort())
    normals.SetFeatureAngle(50)
    normals.Update()
    return normals.GetOutput()


top = turned([(r, 0.0) for r in numpy.linspace(1e-3, 1, 30)])
cloth = turned([(1 - 0.12 * z, z) for z in numpy.linspace(0, -0.75, 30)], 0.11)
foot = turned([(0.13, -0.7), (0.13, -1.25), (0.5, -1.3), (0.55, -1.35)])
whole = vtk.vtkAppendPolyData()
for part in (top, cloth, foot):
    whole.AddInputData(part)

row = []
for scheme in ("SYMMETRIC", "UNWEIGHTED"):
    style = hachure.style("halftone")
    style.GetLayer(0).SetSize(9)
    style.SetWeightScheme(getattr(style, scheme))
    mapper = hachure.vtkPatternMapper()
    mapper.SetStyle(style)
    mapper.SetInputConnection(whole.GetOutputPort())
    sheet = Sheet(300, 230)
    sheet.add(mapper)
    slide = Slide(sheet, mapper, [top, cloth, foot])
    for angle in range(41):
        turn = numpy.radians(angle)
        sheet.look((8 * numpy.sin(turn), -8 * numpy.cos(turn), 1.4), (0, 0, -0.65), angle=15)
        sheet.draw()
        slide.step()
        if angle == 0:
            pin(sheet, 45, 0.035)
            sheet.draw()
            first = sheet.picture()
    row += [sheet.picture()] if row else [first, sheet.picture()]
    print("%s: %.2f, %.2f, %.2f pixels per frame on top, cloth and foot" % (scheme, *slide.means()))
save([row], "table.png")
