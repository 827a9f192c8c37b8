# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Directions on polygons, strips, seams and blocks, and on a scan."""

import os

import hachure
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkPolyDataNormals, vtkStripper
from vtkmodules.vtkFiltersSources import vtkCylinderSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLImageDataReader


def made(source, **properties):
    for name, value in properties.items():
        getattr(source, "Set" + name)(value)
    source.Update()
    return source.GetOutput()


def field(data, **properties):
    filter_ = hachure.vtkSurfaceDirectionField()
    filter_.SetInputDataObject(data)
    return made(filter_, **properties)


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name)).astype(float)


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def with_array(data, name, values, cells=False):
    result = vtkPolyData()
    result.ShallowCopy(data)
    added = numpy_to_vtk(numpy.asarray(values), deep=True)
    added.SetName(name)
    (result.GetCellData() if cells else result.GetPointData()).AddArray(added)
    return result


def degrees(a, b):
    """Angles between lines."""
    return numpy.degrees(numpy.arctan2(
        numpy.linalg.norm(numpy.cross(a, b), axis=1), numpy.abs((a * b).sum(axis=1))))


# A cylinder of quads about y without caps: lines around it or along it, k = 2 and 0.
tube = made(vtkCylinderSource(), Resolution=64, Capping=False)
for which, along in ((0, 0), (1, 1), (2, 0), (3, 1)):
    out = field(tube, PrincipalDirection=which)
    direction = array(out, "Direction")
    assert numpy.allclose(numpy.abs(direction[:, 1]), along, atol=1e-5)
    assert numpy.allclose(numpy.linalg.norm(direction, axis=1), 1, atol=1e-6)
    assert numpy.abs((direction * array(out, "Normals")).sum(axis=1)).max() < 1e-6
    curvatures = array(out, "PrincipalCurvatures")
    assert curvatures.shape[1] == 2 and numpy.abs(curvatures - [2, 0]).max() < 0.02
    assert array(out, "Reliability").min() > 0.9
turned = field(tube, PrincipalDirection=1, Perpendicular=True)
assert numpy.abs(array(turned, "Direction")[:, 1]).max() < 1e-5
assert not out.GetPointData().GetTangents()
assert not tube.GetPointData().HasArray("Direction")
tangents = field(tube, ActiveTangents=True).GetPointData().GetTangents()
assert tangents.GetName() == "Direction" and tangents.GetNumberOfComponents() == 3

# The gradient of height on a sphere whose points are split at every edge, and as strips.
sphere = made(vtkSphereSource(), ThetaResolution=48, PhiResolution=40)
split = made(vtkPolyDataNormals(), InputData=sphere, Splitting=True, FeatureAngle=1.0)
assert split.GetNumberOfPoints() > 3 * sphere.GetNumberOfPoints()
strips = made(vtkStripper(), InputData=sphere)
for data in (sphere, split, strips):
    height = points_of(data)[:, 2]
    out = field(with_array(data, "height", height), Method=1, ArrayName="height")
    assert not out.GetPointData().HasArray("PrincipalCurvatures")
    normal = points_of(data) * 2
    truth = [0, 0, 1] - normal * normal[:, 2:]
    inner = numpy.abs(height) < 0.45
    assert degrees(array(out, "Direction"), truth)[inner].max() < (1.5 if data is not split else 6)
    if data is split:
        own = array(out, "Normals")
        assert numpy.abs((array(out, "Direction") * own).sum(axis=1)).max() < 1e-6
    level = field(with_array(data, "height", height), Method=1, ArrayName="height", Perpendicular=True)
    assert degrees(array(level, "Direction"), array(out, "Direction"))[inner].min() > 89.9

# Vectors of points and of cells; signs do not matter.
points = points_of(sphere)
swirl = numpy.cross([0, 0, 1.0], points)
random = numpy.random.default_rng(1)
flips = random.choice([-1.0, 1.0], len(points))[:, None]
kept = field(with_array(sphere, "v", swirl), Method=2, ArrayName="v")
flipped = field(with_array(sphere, "v", swirl * flips), Method=2, ArrayName="v")
assert degrees(array(kept, "Direction"), array(flipped, "Direction")).max() < 1e-3
ring = numpy.abs(points[:, 2]) < 0.45
assert degrees(array(kept, "Direction"), swirl)[ring].max() < 1
corners = vtk_to_numpy(sphere.GetPolys().GetConnectivityArray()).reshape(-1, 3)
middles = numpy.cross([0, 0, 1.0], points[corners].sum(axis=1))
of_cells = field(with_array(sphere, "v", middles, cells=True), Method=2, ArrayName="v")
assert degrees(array(of_cells, "Direction"), swirl)[ring].max() < 1

# A sphere has no direction of its own, and a plane neither: the axis, or the longest side.
bare = field(sphere, ReferenceAxis=(0, 0, 5))
assert array(bare, "Reliability")[ring].max() < 0.05
assert degrees(array(bare, "Direction"), [0, 0, 1] - 4 * points * points[:, 2:])[ring].max() < 2
plane = made(vtkPlaneSource(), Origin=(0, 0, 0), Point1=(0, 3, 0), Point2=(-1, 0, 0), XResolution=6, YResolution=4)
assert numpy.allclose(numpy.abs(array(field(plane), "Direction")), [0, 1, 0], atol=1e-6)

# A concave polygon with a line, a lone point, and a point that is not a number.
odd = vtkPolyData()
place = vtkPoints()
for p in ((0, 0, 0), (4, 0, 0), (4, 4, 0), (2, 1, 0), (0, 4, 0), (9, 9, 9), (numpy.nan, 0, 0), (5, 1, 0)):
    place.InsertNextPoint(p)
odd.SetPoints(place)
polygons, lines = vtkCellArray(), vtkCellArray()
for cells, ids in ((polygons, (0, 1, 2, 3, 4)), (polygons, (1, 6, 7)), (lines, (5, 7))):
    cells.InsertNextCell(len(ids))
    for i in ids:
        cells.InsertCellPoint(i)
odd.SetPolys(polygons)
odd.SetLines(lines)
out = field(odd, ReferenceAxis=(1, 1, 0))
direction = array(out, "Direction")
assert numpy.allclose(direction[:5], numpy.sqrt([0.5, 0.5, 0]), atol=1e-6), direction
assert (direction[5:] == 0).all() and (array(out, "Reliability") == 0).all()
assert field(vtkPolyData()).GetNumberOfPoints() == 0

# Every block by itself, also empty ones, and none of the input is touched.
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, tube)
blocks.SetBlock(1, vtkPolyData())
blocks.SetBlock(3, plane)
out = field(blocks)
assert numpy.array_equal(array(out.GetBlock(0), "Direction"), array(field(tube), "Direction"))
assert numpy.array_equal(array(out.GetBlock(3), "Direction"), array(field(plane), "Direction"))
assert out.GetBlock(1).GetPointData().HasArray("Direction") and out.GetBlock(2) is None
assert not blocks.GetBlock(0).GetPointData().HasArray("Direction")

# Ghosts of other processes continue the surface, hidden cells do not.
for kind, shares in ((1, (1.0, 1.0)), (32, (0.4, 0.6))):
    ghosts = numpy.where(numpy.arange(tube.GetNumberOfCells()) < 32, kind, 0).astype(numpy.uint8)
    out = field(with_array(tube, "vtkGhostType", ghosts, cells=True))
    known = numpy.linalg.norm(array(out, "Direction"), axis=1) > 0.5
    assert shares[0] <= known.mean() <= shares[1], (kind, known.mean())

# An abort leaves no output.
stopped = hachure.vtkSurfaceDirectionField()
stopped.SetInputData(sphere)
stopped.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(caller.GetProgress() > 0.3))
stopped.Update()
assert stopped.GetOutput().GetNumberOfPoints() == 0


def skull_angles(data, iterations):
    """Angles between the lines at both ends of edges."""
    out = field(data, SmoothingIterations=iterations)
    direction = array(out, "Direction")
    ends = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    assert numpy.allclose(numpy.linalg.norm(direction, axis=1), 1, atol=1e-6)
    return degrees(direction[ends[:, 0]], direction[ends[:, 1]])


reader = vtkXMLImageDataReader()
reader.SetFileName(os.environ["HACHURE_DATA"] + "/skull.vti")
contour = vtkFlyingEdges3D()
contour.SetInputConnection(reader.GetOutputPort())
contour.SetValue(0, 2.9)
skull = made(contour)
rough, smooth = skull_angles(skull, 0), skull_angles(skull, 20)
# Chance would be 57 degrees between lines in space. Most of what is left are bends of the surface:
# edges of thin bones.
assert smooth.mean() < 12.5 and smooth.mean() < 0.8 * rough.mean(), (smooth.mean(), rough.mean())
assert numpy.median(smooth) < 8, numpy.median(smooth)
