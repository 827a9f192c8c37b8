# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Blending weights of surfaces with seams, strips and blocks."""

import hachure
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkStripper
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource


def made(source, **properties):
    for name, value in properties.items():
        getattr(source, "Set" + name)(value)
    source.Update()
    return source.GetOutput()


def blend(data, **properties):
    filter_ = hachure.vtkPatchBlendWeights()
    filter_.SetInputDataObject(data)
    return made(filter_, **properties)


def read(data):
    """Dense weights per point and patch, after a check of what holds everywhere."""
    patches = vtk_to_numpy(data.GetPointData().GetArray("BlendPatches"))
    weights = vtk_to_numpy(data.GetPointData().GetArray("BlendWeights"))
    assert patches.shape == weights.shape == (data.GetNumberOfPoints(), 4)
    assert numpy.abs(weights.astype(float).sum(axis=1) - 1).max() <= 1e-6
    assert (numpy.diff(weights, axis=1) <= 0).all()
    assert ((patches < 0) == (weights == 0)).all()
    dense = numpy.zeros((len(patches), patches.max() + 1))
    for i in range(4):
        valid = patches[:, i] >= 0
        dense[valid, patches[valid, i]] = weights[valid, i]
    return dense


def with_patches(data, where):
    result = vtkPolyData()
    result.ShallowCopy(data)
    array = numpy_to_vtk(numpy.asarray(where, dtype=numpy.int32), deep=True)
    array.SetName("PatchId")
    result.GetCellData().AddArray(array)
    return result


# A box whose sides share no points: three sides meet in a corner, two along an edge.
box = with_patches(made(vtkCubeSource()), range(6))
weights = read(blend(box))
assert numpy.allclose(weights.max(axis=1), 1 / 3) and ((weights > 0).sum(axis=1) == 3).all()

# Points in one place have one blend, whatever splits them; quads and strips blend alike.
sphere = made(vtkSphereSource(), ThetaResolution=32, PhiResolution=24)
patches = hachure.vtkSurfacePatches()
patches.SetInputData(sphere)
patches.SetNumberOfPatches(9)
smooth = made(patches)
plain = read(blend(smooth, Rings=3))
split = vtkPolyDataNormals()
split.SetInputData(smooth)
split.SplittingOn()
split.SetFeatureAngle(1)
flat = made(split)
assert flat.GetNumberOfPoints() > 3 * sphere.GetNumberOfPoints()
flat_weights = read(blend(flat, Rings=3))
place = {tuple(p): w for p, w in zip(vtk_to_numpy(sphere.GetPoints().GetData()).tolist(), plain)}
for p, w in zip(vtk_to_numpy(flat.GetPoints().GetData()).tolist(), flat_weights):
    assert numpy.array_equal(place[tuple(p)], w)
stripper = vtkStripper()
stripper.SetInputData(sphere)
strips = with_patches(made(stripper), numpy.arange(made(stripper).GetNumberOfCells()) % 2)
assert strips.GetNumberOfStrips() > 3 and (read(blend(strips))[:, :2].sum(axis=1) > 0.99).all()

# Two blocks that touch, one half each: joined or apart.
quads = [made(vtkPlaneSource(), XResolution=10, YResolution=10, Origin=(x, 0, 0), Point1=(x + 1, 0, 0),
              Point2=(x, 1, 0)) for x in (0.0, 1.0)]
copies = []
for i in range(2):  # one source each would share its output
    copy = vtkPolyData()
    copy.DeepCopy(quads[i])
    copies.append(with_patches(copy, numpy.full(100, i)))
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, copies[0])
blocks.SetBlock(1, vtkPolyData())
blocks.SetBlock(2, copies[1])
for joined in (True, False):
    out = blend(blocks, Rings=3, JoinBlocks=joined)
    half = read(out.GetBlock(0))
    x = numpy.round(vtk_to_numpy(copies[0].GetPoints().GetData())[:, 0] * 10)
    if joined:
        inner = half[(x == 10)][3:-3]
        assert numpy.abs(inner[:, 1] - 0.5).max() <= 0.02, inner
        assert (half[x <= 7, 0] == 1).all() and (half[x == 8, 1] > 0).all()
    else:
        assert half.shape[1] == 1
assert not blocks.GetBlock(0).GetPointData().HasArray("BlendWeights")
assert out.GetBlock(1).GetNumberOfPoints() == 0

# The same width on two triangulations: patch 1 is the half above z = 0, blended over 0.1 on each side.
for rows in (21, 61):
    ball = made(vtkSphereSource(), ThetaResolution=80, PhiResolution=rows)
    height = vtk_to_numpy(ball.GetPoints().GetData())[:, 2]
    corners = vtk_to_numpy(ball.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    halves = with_patches(ball, height[corners].sum(axis=1) > 1e-5)
    weights = read(blend(halves, WidthMode=1, Distance=0.1))
    x = numpy.clip(0.5 + 0.5 * numpy.arcsin(numpy.clip(height / 0.5, -1, 1)) * 0.5 / 0.1, 0, 1)
    assert numpy.abs(weights[:, 1] - x * x * (3 - 2 * x)).max() < 0.02
assert blend(vtkPolyData()).GetNumberOfPoints() == 0
