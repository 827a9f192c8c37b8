# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The styles of Benard et al. 2010, section 4, on our data: noise_styles.py [FILE.png [ROW]]"""

import sys

import hachure
import vtk
from sheet import DATA, Sheet, save, skull

WIDTH, HEIGHT = 270, 290
HEAT = ((0, (0.10, 0.25, 0.55)), (0.35, (0.25, 0.62, 0.62)), (0.6, (0.95, 0.80, 0.40)),
        (0.8, (0.90, 0.45, 0.25)), (1, (0.60, 0.12, 0.20)))
EARTH = ((-7000, (0.09, 0.22, 0.45)), (-2500, (0.20, 0.45, 0.66)), (-1, (0.60, 0.82, 0.86)),
         (1, (0.45, 0.62, 0.30)), (500, (0.80, 0.78, 0.45)), (1500, (0.78, 0.55, 0.30)),
         (3500, (0.55, 0.32, 0.20)), (5500, (0.95, 0.93, 0.90)))


def colors_of(data, table, relative):
    """The table over the range of the data's scalars, or by their values."""
    low, high = data.GetPointData().GetScalars().GetRange() if relative else (0, 1)
    colors = vtk.vtkColorTransferFunction()
    for value, color in table:
        colors.AddRGBPoint(low + value * (high - low), *color)
    return colors


def with_normals(data, scalars):
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SetFeatureAngle(40)
    normals.Update()
    normals.GetOutput().GetPointData().SetActiveScalars(scalars)
    return normals.GetOutput()


def reactor():
    """Half of a heated disk in a flow, with its temperature."""
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(str(DATA / "disk_out_ref.ex2"))
    reader.UpdateInformation()
    reader.SetPointResultArrayStatus("Temp", 1)
    reader.Update()
    plane = vtk.vtkPlane()
    plane.SetNormal(0.3, 1, 0)
    half = vtk.vtkTableBasedClipDataSet()
    half.SetInputData(reader.GetOutput().GetBlock(0).GetBlock(0))
    half.SetClipFunction(plane)
    skin = vtk.vtkDataSetSurfaceFilter()
    skin.SetInputConnection(half.GetOutputPort())
    skin.Update()
    data = with_normals(skin.GetOutput(), "Temp")
    return data, colors_of(data, HEAT, True), ((16, -40, 26), (0, 0, 0.3)), 26


def globe():
    """The relief of the earth."""
    reader = vtk.vtkNetCDFCFReader()
    reader.SetFileName(str(DATA / "etopo60.cdf"))
    skin = vtk.vtkDataSetSurfaceFilter()
    skin.SetInputConnection(reader.GetOutputPort())
    points = vtk.vtkCellDataToPointData()
    points.SetInputConnection(skin.GetOutputPort())
    points.Update()
    data = with_normals(points.GetOutput(), points.GetOutput().GetPointData().GetArray(0).GetName())
    return data, colors_of(data, EARTH, False), ((3.3, 3.3, 2.0), (0, 0, 0)), 26.5


def bone():
    return skull(), None, ((-1.6, -5.2, 0.9), (0.03, 0, -0.1)), 24.5


def drawn(name, subject):
    data, colors, (position, focal_point), angle = subject()
    style = hachure.vtkPatternStyle()
    if name.endswith(".json"):
        style.LoadFile(str(DATA.parent / "Styles" / name))
    else:
        style.LoadPreset(name)
    style.SetPaperColor(1, 1, 1)
    mapper = hachure.vtkPatternMapper()
    mapper.SetInputData(data)
    mapper.SetStyle(style)
    mapper.SetScalarVisibility(colors is not None)
    mapper.SetLookupTable(colors)
    sheet = Sheet(WIDTH, HEIGHT)
    sheet.add(mapper)
    sheet.look(position, focal_point, angle=angle)
    sheet.draw()
    return sheet.picture()


ROWS = (
    (("noise-stipple", bone), ("noise-hatch", bone), ("noise-cross-hatch", bone)),
    (("graphite", bone), ("ink", bone), ("xtoon.json", bone)),
    (("watercolour", globe), ("felt-tip", reactor), ("brush", bone)),
)
row = int(sys.argv[2]) if len(sys.argv) > 2 else 0
save([[drawn(*cell) for cell in ROWS[row]]], "noise_styles.png")
