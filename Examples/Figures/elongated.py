# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The worst case, a long object that turns, with one pattern and with one per patch: elongated.py [FILE.png]

Red pins are stuck in the surface through dots of the first picture.
"""

import hachure
import numpy
import vtk
from sheet import Sheet, save
from slide import pin

ball = vtk.vtkSphereSource()
ball.SetThetaResolution(96)
ball.SetPhiResolution(96)
stretch = vtk.vtkTransform()
stretch.Scale(2.6, 1.3, 1.3)
long = vtk.vtkTransformPolyDataFilter()
long.SetTransform(stretch)
long.SetInputConnection(ball.GetOutputPort())
patches = hachure.vtkSurfacePatches()
patches.SetInputConnection(long.GetOutputPort())
patches.SetNumberOfPatches(24)
weights = hachure.vtkPatchBlendWeights()
weights.SetInputConnection(patches.GetOutputPort())
weights.SetRings(4)

rows = []
for name, surface in (("one pattern", long), ("patches", weights)):
    style = hachure.style("halftone")
    layer = style.GetLayer(0)
    layer.SetSize(10)
    layer.GetTone().SetGamma(0.6)
    mapper = hachure.vtkPatternMapper()
    mapper.SetStyle(style)
    mapper.SetInputConnection(surface.GetOutputPort())
    sheet = Sheet(225, 140)
    sheet.add(mapper)
    row, slides = [], []
    for angle in range(61):
        turn = numpy.radians(angle)
        sheet.look((8 * numpy.sin(turn), -8 * numpy.cos(turn), 1), (0, 0, 0), angle=12)
        sheet.draw()
        if angle == 0:
            pin(sheet, 30, 0.035)
            sheet.draw()
        else:
            slides.append(mapper.GetResidual(sheet.renderer))
        if angle % 20 == 0:
            row.append(sheet.picture())
    print("%s: %.2f pixels of slide per frame" % (name, numpy.mean(slides)))
    rows.append(row)
save(rows, "elongated.png")
