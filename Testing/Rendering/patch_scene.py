# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces in patches for the tests of the mapper."""

import numpy
import pattern_scene as scene
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.util.numpy_support import vtk_to_numpy


def grid(resolution=40, width=4.0):
    """A square in the plane z = 0 of many triangles."""
    source = vtkPlaneSource()
    source.SetOrigin(-width / 2, -width / 2, 0)
    source.SetPoint1(width / 2, -width / 2, 0)
    source.SetPoint2(-width / 2, width / 2, 0)
    source.SetResolution(resolution, resolution)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    triangles.Update()
    data = triangles.GetOutput()
    data.GetPointData().SetTCoords(None)
    return data


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def centers_of(data):
    cells = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return points_of(data)[cells].mean(axis=1)


def number_cells(data, patches, name="PatchId"):
    scene.add_array(data.GetCellData(), name, numpy.asarray(patches, dtype=numpy.int32))


def split(data, places=(0.0,), width=0.0):
    """Strips of patches between the places along x; they blend over the width about each place."""
    x = centers_of(data)[:, 0]
    number_cells(data, numpy.searchsorted(places, x))
    if width > 0.0:
        blend(data, places, width)


def keep_patch(data, patch):
    """Only the cells of one patch."""
    numbers = vtk_to_numpy(data.GetCellData().GetArray("PatchId"))
    cells = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    kept = vtkCellArray()
    for cell in cells[numbers == patch]:
        kept.InsertNextCell(3, [int(point) for point in cell])
    data.SetPolys(kept)
    number_cells(data, numbers[numbers == patch])


def twist(data, place, degrees, growth):
    """Turns and enlarges all beyond the place along x about a point there, within the plane."""
    points = points_of(data)
    moving = points[:, 0] > place
    angle = numpy.radians(degrees)
    turn = growth * numpy.array([[numpy.cos(angle), -numpy.sin(angle)],
                                 [numpy.sin(angle), numpy.cos(angle)]])
    points[moving, :2] = (points[moving, :2] - (place, 0.0)) @ turn.T + (place, 0.0)
    for i in numpy.flatnonzero(moving):
        data.GetPoints().SetPoint(int(i), *points[i])
    data.GetPoints().Modified()


def blend(data, places, width):
    x = points_of(data)[:, 0]
    weights = numpy.zeros((len(x), len(places) + 1))
    above = numpy.ones(len(x))
    for number, place in enumerate(places):
        over = numpy.clip((x - place) / width + 0.5, 0.0, 1.0)
        weights[:, number] = above * (1.0 - over)
        above = above * over
    weights[:, -1] = above
    weigh_points(data, weights)


def weigh_points(data, weights):
    """weights[point, patch]; the four heaviest are kept."""
    weights = numpy.pad(weights, ((0, 0), (0, max(0, 4 - weights.shape[1]))))
    order = numpy.argsort(-weights, axis=1, kind="stable")[:, :4]
    kept = numpy.take_along_axis(weights, order, axis=1)
    ids = numpy.where(kept > 0.0, order, -1).astype(numpy.int32)
    scene.add_array(data.GetPointData(), "BlendPatches", ids)
    scene.add_array(data.GetPointData(), "BlendWeights", kept.astype(numpy.float32))
