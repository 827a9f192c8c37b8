# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Patches by every method, on the kinds of data that VTK has."""

import hachure
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkMultiBlockDataSet, vtkPolyData, vtkSelection, vtkSelectionNode)
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals, vtkStripper
from vtkmodules.vtkFiltersSources import (
    vtkCubeSource, vtkCylinderSource, vtkLineSource, vtkSphereSource)
from vtkmodules.vtkRenderingCore import vtkCamera


def ids(data):
    return vtk_to_numpy(data.GetCellData().GetArray("PatchId"))


def patches(data, method, **properties):
    filter_ = hachure.vtkSurfacePatches()
    filter_.SetInputDataObject(data)
    getattr(filter_, "SetMethodTo" + method)()
    for name, value in properties.items():
        getattr(filter_, "Set" + name)(value)
    filter_.Update()
    return filter_.GetOutput()


def made(source, **properties):
    for name, value in properties.items():
        getattr(source, "Set" + name)(value)
    source.Update()
    return source.GetOutput()


def named(array, name):
    array = numpy_to_vtk(numpy.array(array), deep=True)
    array.SetName(name)
    return array


cube = made(vtkCubeSource())
sphere = made(vtkSphereSource(), ThetaResolution=40, PhiResolution=30)

# Creases: sides and caps; normals that were split make no seam.
cylinder = made(vtkCylinderSource(), Resolution=48)
assert ids(patches(cube, "Crease")).tolist() == [0, 1, 2, 3, 4, 5]
split = vtkPolyDataNormals()
split.SetInputData(cylinder)
split.SplittingOn()
assert len(set(ids(patches(made(split), "Crease")))) == 3
assert len(set(ids(patches(cylinder, "Crease", CreaseAngle=5)))) == 50
assert set(ids(patches(cylinder, "Connected"))) == {0}

# Lines and vertices are in no patch; strips are.
both = vtkAppendPolyData()
both.AddInputData(made(vtkLineSource(), Resolution=5))
both.AddInputData(sphere)
both.AddInputData(cube)
mixed = made(both)
first = mixed.GetNumberOfVerts() + mixed.GetNumberOfLines()
found = ids(patches(mixed, "Connected"))
assert (found[:first] == -1).all() and first == 1
assert (found[first:-6] == 0).all() and (found[-6:] == 1).all()
strips = vtkStripper()
strips.SetInputData(sphere)
stripped = made(strips)
assert stripped.GetNumberOfStrips() > 3 and stripped.GetNumberOfPolys() < 10
assert len(set(ids(patches(stripped, "Automatic", NumberOfPatches=3)))) == 3

# Arrays: of cells or points, of integers, whole floating-point numbers or strings.
cube.GetCellData().AddArray(named([9, 9, -3, 4, 4, 70], "part"))
assert ids(patches(cube, "Array", ArrayName="part")).tolist() == [1, 1, -1, 0, 0, 2]
cube.GetPointData().AddArray(named(numpy.arange(24) // 8 * 1.0, "third"))
assert ids(patches(cube, "Array", ArrayName="third")).tolist() == [0, 0, 1, 1, 2, 2]
materials = vtkStringArray()
materials.SetName("material")
for material in ("steel", "brass", "steel", "copper", "brass", "steel"):
    materials.InsertNextValue(material)
cube.GetCellData().AddArray(materials)
assert ids(patches(cube, "Array", ArrayName="material")).tolist() == [2, 0, 2, 1, 0, 2]

# Blocks, one of them empty and one missing, numbered over all.
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, cube)
blocks.SetBlock(1, vtkPolyData())
blocks.SetBlock(3, sphere)
out = patches(blocks, "Block")
assert set(ids(out.GetBlock(0))) == {0} and set(ids(out.GetBlock(3))) == {1}
assert len(ids(out.GetBlock(1))) == 0 and out.GetBlock(2) is None
assert not blocks.GetBlock(0).GetCellData().HasArray("PatchId")
out = patches(blocks, "Crease")
assert set(ids(out.GetBlock(0))) == set(range(6)) and set(ids(out.GetBlock(3))) == {6}
assert set(ids(patches(blocks, "Automatic", NumberOfPatches=8).GetBlock(3))).isdisjoint(
    ids(patches(blocks, "Automatic", NumberOfPatches=8).GetBlock(0)))

# Two halves of one surface as blocks are one surface, unless they are kept apart.
halves = vtkMultiBlockDataSet()
halves.SetBlock(0, made(vtkSphereSource(), StartTheta=0, EndTheta=180))
halves.SetBlock(1, made(vtkSphereSource(), StartTheta=180, EndTheta=360))
assert set(ids(patches(halves, "Connected").GetBlock(1))) == {0}
assert set(ids(patches(halves, "Connected", JoinBlocks=False).GetBlock(1))) == {1}


def node(values, field, block=None):
    result = vtkSelectionNode()
    result.SetContentType(vtkSelectionNode.INDICES)
    result.SetFieldType(field)
    result.SetSelectionList(named(numpy.array(values, dtype=numpy.int64), "indices"))
    if block is not None:
        result.GetProperties().Set(vtkSelectionNode.COMPOSITE_INDEX(), block)
    return result


def selected(data, *nodes):
    selection = vtkSelection()
    for item in nodes:
        selection.AddNode(item)
    filter_ = hachure.vtkSurfacePatches()
    filter_.SetInputDataObject(0, data)
    filter_.SetInputDataObject(1, selection)
    filter_.SetMethodToSelection()
    filter_.Update()
    return filter_.GetOutput()


cell, point = vtkSelectionNode.CELL, vtkSelectionNode.POINT
assert ids(selected(cube, node([1, 4], cell))).tolist() == [0, 1, 0, 0, 1, 0]
assert ids(selected(cube, node([1, 4], cell), node([4, 5], cell))).tolist() == [0, 1, 0, 0, 1, 2]
assert ids(selected(cube, node([9], point))).tolist() == [0, 0, 1, 0, 0, 0]
assert ids(selected(cube, node([], cell))).tolist() == [0] * 6
out = selected(blocks, node([2], cell, 1), node([0, 7], cell, 4))
assert ids(out.GetBlock(0)).tolist() == [0, 0, 1, 0, 0, 0]
assert numpy.flatnonzero(ids(out.GetBlock(3))).tolist() == [0, 7] and ids(out.GetBlock(3))[7] == 2

# Odd but valid: nothing, one triangle, a triangle without area.
assert patches(vtkPolyData(), "Automatic").GetNumberOfCells() == 0
points = vtkPoints()
for i in range(4):
    points.InsertNextPoint(i % 3, i // 3, 0)
triangle = vtkPolyData()
triangle.SetPoints(points)
cells = vtkCellArray()
for corners in ((0, 1, 3), (0, 1, 2)):
    cells.InsertNextCell(3, corners)
triangle.SetPolys(cells)
for method in ("Automatic", "Crease", "Connected", "Block"):
    assert set(ids(patches(triangle, method, **({"NumberOfPatches": 1})))) == {0}, method

# The slide that is predicted along a camera path, and patches split until it is under a limit.
ellipsoid = made(vtkSphereSource(), ThetaResolution=60, PhiResolution=60, Radius=1)
stretched = vtk_to_numpy(ellipsoid.GetPoints().GetData())
stretched[:, 0] *= 3
camera = vtkCamera()
camera.SetPosition(0, 0, 12)
filter_ = hachure.vtkSurfacePatches()
filter_.SetInputData(ellipsoid)
filter_.SetNumberOfPatches(1)
filter_.SetViewportSize(640, 480)
for _ in range(10):
    filter_.AddCamera(camera)
    camera.Azimuth(3)
assert filter_.GetNumberOfCameras() == 10
filter_.Update()
slide = vtk_to_numpy(filter_.GetOutput().GetFieldData().GetArray("PatchSlide"))
assert slide.shape == (1,) and slide[0] > 0.5, slide
filter_.SetMaximumSlide(slide[0] / 2)
filter_.Update()
slides = vtk_to_numpy(filter_.GetOutput().GetFieldData().GetArray("PatchSlide"))
assert 2 <= len(slides) < 40 and slides.max() <= slide[0] / 2, slides
assert len(set(ids(filter_.GetOutput()))) == len(slides)
sampler = hachure.vtkStratifiedSurfaceSampler()
sampler.SetInputConnection(filter_.GetOutputPort())
sampler.SetPatchArrayName("PatchId")
tracker = hachure.vtkSimilarityTracker()
tracker.SetInputConnection(sampler.GetOutputPort())
tracker.SetViewportSize(640, 480)
for i in range(9):  # the filters that draw say the same, with other samples
    tracker.SetCameraBefore(filter_.GetCamera(i))
    tracker.SetCameraAfter(filter_.GetCamera(i + 1))
    tracker.Update()
    residuals = vtk_to_numpy(tracker.GetOutput().GetColumnByName("Residual"))
    assert (residuals <= slides * 1.15 + 0.02).all(), (i, residuals, slides)
print("slide %.3f, with %d patches %.3f" % (slide[0], len(slides), slides.max()))
