# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A skull in colours of data, with lines of depth that are painted for one camera, and hatching:
view_layers.py [FILE.png]"""

import hachure
import numpy
import vtk
from sheet import Sheet, save, skull
from views import Studio, add_dependent, camera_at, image
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

EYE, MIDDLE = numpy.array((-1.9, -5.1, 0.9)), (0.03, 0, -0.12)
ANGLE = 24
ASIDE = 0, 12, 24  # degrees that the viewer goes to the right
STEP, WIDTH = 0.16, 0.022  # between lines of depth, and theirs
RED = 176, 30, 40
REACH = 30

bone = skull()
height = numpy.ascontiguousarray(vtk_to_numpy(bone.GetPoints().GetData())[:, 2])
bone.GetPointData().SetScalars(numpy_to_vtk(height, deep=True))
colors = vtk.vtkColorTransferFunction()
for value, color in ((-0.9, (0.62, 0.78, 0.80)), (0, (0.93, 0.93, 0.78)), (0.9, (0.96, 0.78, 0.58))):
    colors.AddRGBPoint(value, *color)


def lines_of_depth(camera):
    """What is as far away as every so many steps is red."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(bone)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    studio = Studio(680, 840, actor)
    picture, covered = studio.take(camera)
    depth = (studio.places() - EYE) @ numpy.array(camera.GetDirectionOfProjection())
    steep = numpy.hypot(*numpy.gradient(numpy.where(covered, depth, numpy.nan)))
    away = numpy.abs(depth - STEP * numpy.round(depth / STEP))
    pixel = 2 * numpy.tan(numpy.radians(ANGLE / 2)) * numpy.linalg.norm(EYE) / picture.shape[0]
    # As wide everywhere in the picture, but where the surface is steep.
    width = numpy.clip(WIDTH / 2 / pixel, 1, None) * numpy.nan_to_num(steep)
    picture[:] = RED
    return image(picture, covered * (steep < 0.03) * (away < numpy.minimum(width, STEP / 4)))


style = hachure.style("cross-hatch")
style.SetPaperSource(style.FLAT)
layer = hachure.vtkViewTextureLayer()
layer.SetBase(layer.BELOW)
views = layer.GetViews()
views.SetFinestLevel(5)
views.SetHemisphere(16)  # so that all of the lines fade alike
camera = camera_at(EYE, MIDDLE, ANGLE)
add_dependent(views, "depth", camera, lines_of_depth(camera), (REACH, REACH))
style.GetLayer(0).SetSize(5)
style.InsertLayer(0, layer)  # below the strokes
mapper = hachure.vtkPatternMapper()
mapper.SetInputData(bone)
mapper.SetLookupTable(colors)
mapper.SetStyle(style)
sheet, row = Sheet(205, 250), []
sheet.add(mapper)
for angle in ASIDE:
    sheet.look(EYE, MIDDLE, angle=ANGLE)
    sheet.camera.Azimuth(angle)
    sheet.draw()
    row.append(sheet.picture())
save([row], "view_layers.png", 15)
