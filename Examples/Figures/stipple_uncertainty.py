# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""How warm the sea is in July, and how little is known of it: stipple_uncertainty.py [FILE.png]"""

import hachure
import numpy
import vtk
from legend import LINES, legend_bar, plain, with_values
from sea import globe, on_sphere
from sheet import Sheet, save

MONTH = 6  # from January, 0
DEGREES = ((-2, (0.42, 0.56, 0.80)), (8, (0.58, 0.78, 0.86)), (16, (0.80, 0.90, 0.76)),
           (23, (0.98, 0.91, 0.62)), (31, (0.92, 0.56, 0.42)))
OBSERVATIONS = 3.8, -0.8  # their logarithm at tone 0 and at tone 1
LAND = 0.8, 0.8, 0.8
SIZE, LEGEND = 250, 180
LEVELS = 15  # of brightness in the file

style = hachure.style("stipple")
style.SetPaperSource(style.FLAT)
style.GetLayer(0).SetSize(1.8)
tone = style.GetLayer(0).GetTone()
tone.SetSource(tone.ARRAY)
tone.SetArrayName("log10_nobs")
tone.SetRange(*OBSERVATIONS)
colors = vtk.vtkDiscretizableColorTransferFunction()
for value, color in DEGREES:
    colors.AddRGBPoint(value, *color)
colors.DiscretizeOn()
colors.SetNumberOfValues(11)
colors.SetNanColor(1, 1, 1)
colors.Build()


def printed(sheet, data):
    """In colours and stipples."""
    mapper = hachure.vtkPatternMapper()
    mapper.SetInputData(data)
    mapper.SetStyle(style)
    mapper.SetLookupTable(colors)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("SST_degC")
    sheet.add(mapper)


def flat_view(sheet, eye, up, height):
    sheet.camera.ParallelProjectionOn()
    sheet.camera.SetParallelScale(height / 2)
    sheet.look(10 * numpy.array(eye), (0, 0, 0), up)
    sheet.draw()
    return sheet.picture()


def seen_from(latitude, longitude):
    sheet = Sheet(SIZE, SIZE)
    printed(sheet, sea)
    plain(sheet, land, LAND)
    plain(sheet, coast, LINES)
    rim = vtk.vtkRegularPolygonSource()
    rim.SetNumberOfSides(360)
    rim.GeneratePolygonOff()
    rim.SetRadius(1)
    rim.SetNormal(*on_sphere(latitude, longitude))
    rim.Update()
    plain(sheet, rim.GetOutput(), LINES)
    return flat_view(sheet, on_sphere(latitude, longitude), (0, 0, 1), 2.1)


sea, land, coast = globe(MONTH)
legend = Sheet(LEGEND, SIZE)
bar = legend_bar(legend, -85, "sea, degrees C", [(str(d), (d + 2) / 33) for d in (1, 10, 19, 28)])
printed(legend, with_values(bar, SST_degC=(-2, 31), log10_nobs=(9, 9)))
bar = legend_bar(legend, 15, "observations", [(format(10 ** n, ","), n / 4) for n in range(5)])
printed(legend, with_values(bar, SST_degC=(numpy.nan, numpy.nan), log10_nobs=(0, 4)))
save([[seen_from(0, -40), seen_from(-5, -155), flat_view(legend, (0, 0, 1), (0, 1, 0), SIZE)]],
     "stipple_uncertainty.png", LEVELS)
