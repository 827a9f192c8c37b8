# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A globe whose sea has waves like scales where it faces the viewer: view_scales.py [FILE.png [ROW]]

Row 0: four places of a walk around it; row 1: the three ways in which the waves of a view fade."""

import sys

import hachure
import numpy
import vtk
from sea import heights, on_sphere
from sheet import save
from views import Studio, add_dependent, around, camera_at, image, shown
from vtk.util.numpy_support import numpy_to_vtk

WAVE = 0.26  # its width, of the radius of the globe
RINGS = (0.93, 0.62, 0.32), 0.075  # lines of a wave and their half width, of its radius
HILLS = 1100  # metres, from where land has hills
INK, BROWN = (22, 58, 96), (96, 58, 30)
COLORS = ((-6000, (0.66, 0.80, 0.85)), (-1, (0.80, 0.90, 0.90)), (1, (0.95, 0.89, 0.72)), (3000, (0.82, 0.68, 0.46)))
DISTANCE, ANGLE = 9, 14
FIRST, BETWEEN, REACH = 20, 60, 30  # degrees: the view in the middle, its neighbours, where it is gone
WALK = 0, 19, 34, 60
HALF_WAY = 20


def globe():
    latitude, longitude = numpy.mgrid[-89.5:90, 20.5:381]
    grid = vtk.vtkStructuredGrid()
    grid.SetDimensions(*latitude.shape[::-1], 1)
    grid.SetPoints(vtk.vtkPoints())
    grid.GetPoints().SetData(numpy_to_vtk(on_sphere(latitude, longitude).reshape(-1, 3), deep=True))
    height = heights()[:, numpy.arange(361) % 360].ravel()
    grid.GetPointData().SetScalars(numpy_to_vtk(numpy.ascontiguousarray(height), deep=True))
    surface = vtk.vtkStructuredGridGeometryFilter()
    surface.SetInputData(grid)
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(surface.GetOutputPort())
    joined = vtk.vtkCleanPolyData()  # where east meets west
    joined.SetInputConnection(triangles.GetOutputPort())
    joined.Update()
    return joined.GetOutput()


def printed(surface):
    """Land and sea in colours."""
    colors = vtk.vtkColorTransferFunction()
    for height, color in COLORS:
        colors.AddRGBPoint(height, *color)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetLookupTable(colors)
    mapper.InterpolateScalarsBeforeMappingOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.55)
    actor.GetProperty().SetDiffuse(0.5)
    return actor


def height_at(places):
    latitude = numpy.degrees(numpy.arcsin(numpy.clip(places[..., 2], -1, 1)))
    longitude = numpy.degrees(numpy.arctan2(places[..., 1], places[..., 0]))
    row = numpy.clip(numpy.round(latitude + 89.5), 0, 179).astype(int)
    return heights()[row, numpy.round(longitude - 20.5).astype(int) % 360]


def waves(x, y):
    """How much ink there is: rows of disks of rings, each before the row above it."""
    ink, open_ = numpy.zeros(x.shape), numpy.ones(x.shape, bool)
    rows, step = numpy.floor(y / (WAVE / 4)), WAVE / 4
    for below in (2, 1, 0, -1):
        row = rows - below + 1
        across = x / WAVE - 0.5 * (row % 2)
        radius = numpy.hypot((across - numpy.round(across)) * WAVE, y - (row - 1) * step) / (WAVE / 2)
        inside = open_ & (radius < 1)
        line = numpy.min([numpy.abs(radius - ring) for ring in RINGS[0]], axis=0)
        ink[inside] = numpy.clip(1.5 - line / RINGS[1], 0, 1)[inside]
        open_ &= ~inside
    return ink


def hills(x, y):
    """Hooks with a dark side in every second place."""
    row = numpy.floor(y / WAVE)
    across = x / WAVE - 0.5 * (row % 2)
    u, v = 2 * (across - numpy.round(across)), y / WAVE - row
    top = 0.75 - 1.1 * numpy.abs(u)
    line = numpy.clip(1.5 - numpy.abs(v - top) / 0.12, 0, 1)
    return numpy.where((v > 0.05) & (numpy.abs(u) < 0.62), numpy.maximum(line, 0.7 * ((u > 0) & (v < top))), 0)


def painted(studio, camera):
    """What a camera sees, with marks that end before the rim."""
    colors, covered = studio.take(camera)
    places = studio.places()
    forward = numpy.array(camera.GetDirectionOfProjection())
    x, y = places @ numpy.cross(forward, (0, 0, 1)), places[..., 2]
    height = height_at(places)
    sea = height < 0
    alpha = numpy.where(sea, waves(x, y), numpy.where(height > HILLS, hills(x, y), 0))
    colors[:] = numpy.where(sea[..., None], INK, BROWN)
    rim = numpy.clip(5 * (0.92 - numpy.hypot(x, y)), 0, 1)
    return image(colors, alpha * rim * covered)


def add_views(views, surface):
    views.SetFinestLevel(5)
    views.SetHemisphere(16)  # else fading waves would be uneven: it takes 15 degrees
    studio = Studio(360, 360, printed(surface))
    for azimuth, elevation in (*((FIRST + 60 * i, 0) for i in range(6)), (0, 70), (0, -70)):
        camera = camera_at(around(azimuth, elevation, DISTANCE), angle=ANGLE)
        views.AddView("globe", camera, image(*studio.take(camera)))
    studio = Studio(640, 640, printed(surface))
    for azimuth in (FIRST, FIRST + BETWEEN):
        camera = camera_at(around(azimuth, 0, DISTANCE), angle=ANGLE)
        add_dependent(views, "waves", camera, painted(studio, camera), (REACH, REACH))


def seen_from(sheet, azimuth):
    sheet.look(around(FIRST + azimuth, 0, DISTANCE), (0, 0, 0), angle=ANGLE)
    sheet.draw()
    return sheet.picture()


surface = globe()
style = hachure.style("view")
views = style.GetLayer(0).GetViews()
add_views(views, surface)
if sys.argv[2:] == ["1"]:
    sheet, row = shown(surface, style, 190, 190), []
    for mode in (views.CURVE, views.MIDDLE, views.EVEN):
        for view in range(views.GetNumberOfViews()):
            views.SetFadeMode(view, mode)
        row.append(seen_from(sheet, HALF_WAY))
else:
    sheet = shown(surface, style, 190, 190)
    row = [seen_from(sheet, azimuth) for azimuth in WALK]
save([row], "view_scales.png")
