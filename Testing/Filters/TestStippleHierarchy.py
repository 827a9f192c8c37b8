# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stipples of a scan, of polygons and strips, of blocks and of bare points; wrong input."""

import os

import hachure
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCommand, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkStripper
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLImageDataReader


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def places(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def stipples(data, count, **properties):
    result = hachure.vtkStippleHierarchy()
    result.SetInputDataObject(data)
    result.SetNumberOfPoints(count)
    for name, value in properties.items():
        getattr(result, "Set" + name)(value)
    result.Update()
    return result


def skull():
    reader = vtkXMLImageDataReader()
    reader.SetFileName(os.environ["HACHURE_DATA"] + "/skull.vti")
    surface = vtkFlyingEdges3D()
    surface.SetInputConnection(reader.GetOutputPort())
    surface.SetValue(0, 2.9)
    surface.Update()
    return surface.GetOutput()


def nearest(points, normals):
    """Distance of each point to the nearest other that faces alike."""
    best = numpy.full(len(points), numpy.inf)
    for begin in range(0, len(points), 500):
        part = slice(begin, begin + 500)
        distance = numpy.linalg.norm(points[part, None] - points[None], axis=2)
        distance[normals[part] @ normals.T <= 0] = numpy.inf
        rows = numpy.arange(len(distance))
        distance[rows, rows + begin] = numpy.inf
        best[part] = distance.min(axis=1)
    return best


def test_scan():
    surface = skull()
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = places(surface)
    output = stipples(surface, 20000, GeneratePointIds=True).GetOutput()
    assert output.GetNumberOfPoints() == 20000 == output.GetNumberOfVerts()
    cells, ids = array(output, "StippleCell"), array(output, "StipplePointIds")
    assert (corners[cells] == ids).all()
    weights = array(output, "StippleWeights").astype(float)
    weights = numpy.column_stack([1 - weights.sum(axis=1), weights])
    assert weights.min() > -1e-6
    where = (weights[:, :, None] * points[ids]).sum(axis=1)
    assert numpy.abs(where - places(output)).max() < 1e-4

    # Spread evenly, whatever the number: compare with a triangular lattice of that density.
    area = output.GetFieldData().GetArray("StippleArea").GetValue(0)
    normals, spacing = array(output, "Normals"), array(output, "StippleSpacing")
    assert numpy.abs(numpy.linalg.norm(normals, axis=1) - 1).max() < 1e-5
    assert (numpy.diff(spacing) <= 0).all()
    for count in (500, 2000, 7000):
        lattice = (2 * area / 3**0.5 / count) ** 0.5
        distance = nearest(places(output)[:count], normals[:count])
        assert distance.min() >= 0.999 * spacing[count - 1]
        assert 0.75 < distance.mean() / lattice < 1.0, distance.mean() / lattice
        assert distance.std() < 0.12 * distance.mean(), distance.std() / distance.mean()


def test_memory():
    """Bytes per stipple, in both outputs."""
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(100)
    sphere.SetPhiResolution(50)
    sphere.Update()
    for order, count, most in ((0, 100000, 52), (1, 1000000, 72)):
        filter_ = stipples(sphere.GetOutput(), count, Order=order)
        size = 1024 * sum(filter_.GetOutput(i).GetActualMemorySize() for i in range(2))
        print("order", order, "bytes per stipple", size / count)
        assert filter_.GetOutput().GetNumberOfPoints() == count
        assert size <= most * count, size / count
        assert not filter_.GetOutput().GetPointData().HasArray("StipplePointIds")
        assert filter_.GetOutput(1).GetNumberOfPoints() == 0


def test_classic():
    surface = skull()
    filter_ = stipples(surface, 30000, Order=1, GenerateParticleMesh=True)
    output, mesh = filter_.GetOutput(0), filter_.GetOutput(1)
    assert output.GetNumberOfPoints() == 30000 == mesh.GetNumberOfPoints()
    offsets = vtk_to_numpy(output.GetFieldData().GetArray("StippleNeighbourOffsets"))
    neighbours = vtk_to_numpy(output.GetFieldData().GetArray("StippleNeighbours"))
    ranks = numpy.repeat(numpy.arange(30000), numpy.diff(offsets.astype(int)))
    assert (neighbours < ranks).all()
    lengths = numpy.linalg.norm(places(output)[ranks] - places(output)[neighbours], axis=1)
    shortest = numpy.full(30000, numpy.inf)
    numpy.minimum.at(shortest, ranks, lengths)
    known = numpy.isfinite(shortest)
    assert known.mean() > 0.99
    assert numpy.abs(shortest - array(output, "StippleSpacing"))[known].max() < 1e-3
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    assert len(corners) > 55000 and corners.max() == 29999

    plain = stipples(surface, 100, GenerateParticleMesh=True)
    assert plain.GetOutput(1).GetNumberOfPoints() == 0


def test_cells():
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(40)
    sphere.SetPhiResolution(30)
    strips = vtkStripper()
    strips.SetInputConnection(sphere.GetOutputPort())
    strips.Update()
    assert strips.GetOutput().GetNumberOfStrips() > 0
    output = stipples(strips.GetOutput(), 500).GetOutput()
    outward = (array(output, "Normals") * places(output)).sum(axis=1)
    assert output.GetNumberOfPoints() == 500 and outward.min() > 0.45

    plane = vtkPlaneSource()
    plane.SetResolution(7, 3)
    plane.Update()
    quads = plane.GetOutput()
    values = numpy_to_vtk(places(quads)[:, 0].copy(), deep=True)
    values.SetName("x")
    quads.GetPointData().AddArray(values)
    cells = numpy_to_vtk(numpy.arange(21.0), deep=True)
    cells.SetName("number")
    quads.GetCellData().AddArray(cells)
    output = stipples(quads, 300, InterpolateData=True).GetOutput()
    assert numpy.abs(array(output, "x") - places(output)[:, 0]).max() < 1e-6
    assert (array(output, "number") == array(output, "StippleCell")).all()
    assert not stipples(quads, 300).GetOutput().GetPointData().HasArray("x")


def test_blocks():
    blocks = vtkMultiBlockDataSet()
    for i in range(2):
        plane = vtkPlaneSource()
        plane.SetCenter(0, 0, 3 * i)
        plane.SetResolution(1 + i, 1)
        plane.Update()
        blocks.SetBlock(i, plane.GetOutput())
    blocks.SetBlock(2, vtkPolyData())
    output = stipples(blocks, 400, GeneratePointIds=True).GetOutput()
    block = array(output, "BlockIndex")
    assert set(block) == {1, 2} and 180 < (block == 1).sum() < 220
    assert ((places(output)[:, 2] > 1) == (block == 2)).all()
    assert array(output, "StipplePointIds")[block == 2].max() == 5


def messages_of(data, **properties):
    """The errors and warnings that come with stipples of the data, and the number of points."""
    texts = []

    def note(_caller, _event, text):
        texts.append(text)

    note.CallDataType = "string0"
    filter_ = hachure.vtkStippleHierarchy()
    for event in (vtkCommand.ErrorEvent, vtkCommand.WarningEvent):
        filter_.AddObserver(event, note)
        filter_.GetExecutive().AddObserver(vtkCommand.ErrorEvent, lambda *_: None)
    filter_.SetInputDataObject(data)
    filter_.SetNumberOfPoints(200)
    for name, value in properties.items():
        getattr(filter_, "Set" + name)(value)
    filter_.Update()
    return texts, filter_.GetOutput().GetNumberOfPoints()


def cloud(places_, normals=None):
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places_, deep=True))
    data.SetPoints(points)
    if normals is not None:
        data.GetPointData().SetNormals(numpy_to_vtk(normals, deep=True))
    return data


def test_points():
    places_ = numpy.random.default_rng(1).random((1000, 3))
    normals = numpy.tile([0.0, 0.0, 2.0], (1000, 1))
    assert messages_of(cloud(places_, normals)) == ([], 200)
    output = stipples(cloud(places_, normals), 5000).GetOutput()
    assert output.GetNumberOfPoints() == 1000
    ids = array(output, "StipplePointIds")[:, 0]
    assert sorted(ids) == list(range(1000)) and (array(output, "StippleCell") == -1).all()
    assert numpy.abs(places(output) - places_[ids]).max() < 1e-6
    assert (array(output, "Normals") == [0, 0, 1]).all()

    texts, count = messages_of(cloud(places_))
    assert len(texts) == 1 and "neither polygons nor point normals" in texts[0] and count == 200
    places_[3, 1] = numpy.nan
    texts, count = messages_of(cloud(places_, normals))
    assert len(texts) == 1 and "1 input point(s)" in texts[0] and count == 200
    texts, count = messages_of(cloud(places_, normals), Order=1)
    assert "order: Classic, expected Progressive" in texts[-1] and count == 0


def test_wrong_input():
    assert messages_of(vtkPolyData()) == ([], 0)
    plane = vtkPlaneSource()
    plane.Update()
    texts, count = messages_of(plane.GetOutput(), LeastMove=0.3)
    assert len(texts) == 1 and "mostMove: 0.25" in texts[0] and count == 0
    broken = vtkPolyData()
    broken.DeepCopy(plane.GetOutput())
    cells = vtkCellArray()
    cells.InsertNextCell(3)
    for corner in (0, 1, 9):
        cells.InsertCellPoint(corner)
    broken.SetPolys(cells)
    texts, count = messages_of(broken)
    assert len(texts) == 1 and "refers to point 9" in texts[0] and count == 0


def test_abort():
    plane = vtkPlaneSource()
    plane.Update()
    for order in (0, 1):
        filter_ = hachure.vtkStippleHierarchy()
        filter_.SetInputData(plane.GetOutput())
        filter_.SetOrder(order)
        progress = []

        def stop(*_):
            progress.append(filter_.GetProgress())
            if len(progress) == 3:
                filter_.SetAbortExecute(1)

        filter_.AddObserver(vtkCommand.ProgressEvent, stop)
        filter_.Update()
        assert progress == sorted(progress) and filter_.GetOutput().GetNumberOfPoints() == 0


test_scan()
test_memory()
test_classic()
test_cells()
test_blocks()
test_points()
test_wrong_input()
test_abort()
