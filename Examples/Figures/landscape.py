# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""India and the Himalaya, seen low over the sea, and kinds of weights: landscape.py [FILE.png]"""

import hachure
import numpy
import vtk
from sheet import DATA, Sheet, save
from slide import Slide
from vtk.util.numpy_support import vtk_to_numpy

WEST, EAST, SOUTH, NORTH = 36, 116, 0, 46  # degrees, which are the unit of all lengths here
METRES = 0.0006  # heights are exaggerated some seventy times
FOOT = 0.6  # of the hills

reader = vtk.vtkNetCDFCFReader()
reader.SetFileName(str(DATA / "etopo60.cdf"))
reader.SphericalCoordinatesOff()
reader.Update()
reader.GetOutput().GetPointData().SetActiveScalars("ROSE")
region = vtk.vtkExtractVOI()
region.SetInputData(reader.GetOutput())
region.SetVOI(WEST - 20, EAST - 20, SOUTH + 90, NORTH + 90, 0, 0)
smooth = vtk.vtkImageResample()
smooth.SetInputConnection(region.GetOutputPort())
smooth.SetInterpolationModeToCubic()
smooth.SetMagnificationFactors(5, 5, 1)
smooth.SetDimensionality(2)
ground = vtk.vtkImageDataGeometryFilter()
ground.SetInputConnection(smooth.GetOutputPort())
ground.Update()
flat = ground.GetOutput()
places = vtk_to_numpy(flat.GetPoints().GetData())
heights = flat.GetPointData().GetScalars()
heights.SetName("ROSE")  # for the style
places[:, 2] = METRES * numpy.maximum(vtk_to_numpy(heights), 0)
normals = vtk.vtkPolyDataNormals()
normals.SetInputData(flat)
normals.SplittingOff()
normals.Update()
surface = normals.GetOutput()


def part(above):
    """The hills or the plain with the sea."""
    plane = vtk.vtkPlane()
    plane.SetOrigin(0, 0, FOOT)
    plane.SetNormal(0, 0, 1 if above else -1)
    clip = vtk.vtkClipPolyData()
    clip.SetInputData(surface)
    clip.SetClipFunction(plane)
    clip.Update()
    return clip.GetOutput()


def walk(scheme, width, height, steps):
    """Walks to the right; returns the last picture and the slide on hills and plain."""
    style = hachure.vtkPatternStyle()
    style.LoadFile(str(DATA.parent / "Styles" / "relief.json"))
    style.SetWeightScheme(getattr(style, scheme))
    mapper = hachure.vtkPatternMapper()
    mapper.SetStyle(style)
    mapper.SetInputData(surface)
    mapper.ScalarVisibilityOff()
    sheet = Sheet(width, height)
    sheet.add(mapper)
    slide = Slide(sheet, mapper, [part(True), part(False)])
    for right in 0.1 * numpy.arange(steps + 1):
        sheet.look((75 + right, -12, 5.5), (78 + right, 26, -0.4), angle=17)
        sheet.draw()
        slide.step()
    return sheet.picture(), slide.means()


save([[walk("SYMMETRIC", 700, 265, 1)[0]]], "landscape.png")
for scheme in ("SYMMETRIC", "UNWEIGHTED", "PERCEPTUAL"):
    slides = walk(scheme, 350, 132, 12)[1]
    print("%s: %.2f pixels per frame on the hills, %.2f on the plain" % (scheme, *slides))
