# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells of view-dependent textures: they cover the surface, show what views say and end where these do."""

import hachure
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCommand, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkImageData, vtkMultiBlockDataSet, vtkPolyData)
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFeatureEdges, vtkStripper
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkCamera

RED, BLUE = (250, 10, 10), (10, 10, 250)
SIZE = 200


def array(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def places(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def corners(data):
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def middles(data):
    return places(data)[corners(data)].mean(axis=1)


def sphere(resolution=40):
    source = vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.SetRadius(1.0)
    source.Update()
    return source.GetOutput()


def plane(resolution=1):
    source = vtkPlaneSource()
    source.SetOrigin(-1, -1, 0)
    source.SetPoint1(1, -1, 0)
    source.SetPoint2(-1, 1, 0)
    source.SetResolution(resolution, resolution)
    source.Update()
    return source.GetOutput()


def image(pixels):
    result = vtkImageData()
    result.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    result.GetPointData().SetScalars(
        numpy_to_vtk(pixels.reshape(-1, pixels.shape[2]).astype(numpy.uint8), deep=True))
    return result


def even(color):
    return image(numpy.tile(numpy.array(color, dtype=numpy.uint8), (SIZE, SIZE, 1)))


def camera_at(*position):
    camera = vtkCamera()
    camera.SetPosition(*position)
    camera.SetViewUp(*((0, 1, 0) if abs(position[1]) < 2 else (0, 0, 1)))
    return camera


def views_of(*views, finest=3):
    """views: position, picture, whether it is dependent."""
    result = hachure.vtkTextureViews()
    result.SetFinestLevel(finest)
    for number, (position, picture, dependent) in enumerate(views):
        assert result.AddView("view %d" % number, camera_at(*position), picture) == number
        result.SetViewKind(number, int(dependent))
    return result


def red_and_blue(finest=3):
    """From the front and from behind, and a dependent one that says nothing on one side."""
    return views_of(((0, 0, 4), even(RED), False), ((0, 0, -4), even(BLUE), False), finest=finest)


def filtered(data, views, **properties):
    result = hachure.vtkViewDependentTexture()
    result.SetInputDataObject(data)
    result.SetViews(views)
    for name, value in properties.items():
        getattr(result, "Set" + name)(value)
    result.Update()
    return result


def areas(data):
    points = places(data)[corners(data)]
    return 0.5 * numpy.linalg.norm(
        numpy.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]), axis=1)


def test_cells_cover_the_surface():
    surface = sphere()
    counts = []
    for level in (0, 1, 3, -1):
        output = filtered(surface, red_and_blue(), Level=level).GetOutput()
        found = array(output, "Area")
        assert numpy.allclose(found, areas(output))
        assert 0.93 * 4 * numpy.pi < found.sum() < 4 * numpy.pi, found.sum()
        counts.append(output.GetNumberOfCells())
        levels, charts = array(output, "Level"), array(output, "Chart")
        assert levels.min() >= (3 if level == -1 else level) and charts.min() == 0
        # Outward, as the surface is.
        points = places(output)[corners(output)]
        normals = numpy.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0])
        assert ((normals * middles(output)).sum(axis=1) > 0).mean() > 0.99
    assert 72 < counts[0] < 288 and counts[2] == counts[3]
    assert 3 * counts[0] < counts[1] <= 4 * counts[0]


def test_corners_are_shared():
    """No edge is open where all charts have cells of one size."""
    output = filtered(sphere(), red_and_blue(), Level=3).GetOutput()
    edges = vtkFeatureEdges()
    edges.SetInputData(output)
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.Update()
    points = places(edges.GetOutput()) if edges.GetOutput().GetNumberOfPoints() else []
    clean = vtkCleanPolyData()
    clean.SetInputData(output)
    clean.Update()
    levels = array(output, "Level")
    if levels.min() == levels.max():
        assert len(points) == 0, len(points)
    # Nothing is there twice but for what lies between large and small cells.
    assert clean.GetOutput().GetNumberOfPoints() >= 0.98 * output.GetNumberOfPoints()


def test_shares_and_colours():
    output = filtered(sphere(), red_and_blue()).GetOutput()
    z = middles(output)[:, 2]
    shares, view = array(output, "ViewShares"), array(output, "View")
    assert shares.shape == (len(z), 2)
    assert output.GetCellData().GetArray("ViewShares").GetComponentName(1) == "view 1"
    sums = shares.sum(axis=1)
    assert numpy.isin(view, (0, 1)).all() and numpy.abs(sums - 1).max() < 1e-5
    assert (view == shares.argmax(axis=1)).all()
    assert (view[z > 0.35] == 0).all() and (view[z < -0.35] == 1).all()
    independent, coverage = array(output, "Independent"), array(output, "Coverage")
    for side, number, color in ((z > 0.35, 0, RED), (z < -0.35, 1, BLUE)):
        assert (shares[side, number] == 1).all()
        assert numpy.abs(independent[side].astype(int) - (*color, 255)).max() <= 1
        assert len(numpy.unique(coverage[side], axis=0)) == 1 and (coverage[side, 3] == 255).all()
    assert (coverage[z > 0.35][0] != coverage[z < -0.35][0]).any()
    assert (array(output, "DependentShare") == 0).all()


def test_dependent_views():
    views = views_of(((0, 0, 4), even(RED), True), ((0, 0, -4), even(BLUE), False))
    output = filtered(sphere(), views).GetOutput()
    z, share = middles(output)[:, 2], array(output, "DependentShare")
    assert (share[z > 0.4] > 0.99).all() and (share[z < -0.8] < 0.05).all() and share[z < -0.6].mean() < 0.02
    assert (array(output, "View")[z > 0.4] == 0).all()
    # Nobody says what is seen from everywhere there, nor what is seen where masks hide all.
    hidden = views_of(((0, 0, 4), even((9, 9, 9, 0)), False), ((0, 0, -4), even(BLUE), False))
    output = filtered(sphere(), hidden).GetOutput()
    front = middles(output)[:, 2] > 0.5
    assert (array(output, "Independent")[front, 3] == 0).all()
    assert (array(output, "View")[front] == -1).all()
    assert (array(output, "ViewShares")[front] == 0).all()
    assert (array(output, "Coverage")[front] == 0).all()


def test_outlines():
    """Half of the picture is another view's: their border is a line across the square."""
    left = numpy.zeros((SIZE, SIZE, 4))
    left[:, :SIZE // 2] = (*RED, 255)
    right = numpy.zeros((SIZE, SIZE, 4))
    right[:, SIZE // 2:] = (*BLUE, 255)
    views = views_of(((0, 0, 4), image(left), False), ((0, 0, 4), image(right), False), finest=4)
    found = filtered(plane(), views)
    lines = found.GetOutput(1)
    assert lines.GetNumberOfLines() == lines.GetNumberOfCells() > 0
    assert (array(lines, "Views") == (0, 1)).all()
    points = places(lines)
    assert len(points) <= lines.GetNumberOfCells() + 1, "points are shared, and only those needed"
    width = 2 / 48  # of a cell
    assert numpy.abs(points[:, 0]).max() < 2 * width
    assert points[:, 1].min() < -0.99 and points[:, 1].max() > 0.99
    # Each line has a cell of either view beside it.
    view, cells = array(found.GetOutput(), "View"), places(found.GetOutput())[corners(found.GetOutput())]
    sides = {}
    for number, triangle in zip(view, cells):
        for i in range(3):
            key = tuple(sorted((tuple(triangle[i].round(6)), tuple(triangle[(i + 1) % 3].round(6)))))
            sides.setdefault(key, []).append(number)
    between = {key for key, pair in sides.items() if len(set(pair)) == 2}
    ends = vtk_to_numpy(lines.GetLines().GetConnectivityArray()).reshape(-1, 2)
    assert {tuple(sorted((tuple(points[a].round(6)), tuple(points[b].round(6))))) for a, b in ends} == between


def test_colours_for_a_camera():
    surface = sphere()
    number = numpy_to_vtk(numpy.arange(float(surface.GetNumberOfPoints())), deep=True)
    number.SetName("number")
    surface.GetPointData().AddArray(number)
    before = surface.GetMTime()
    views = views_of(((0, 0, 4), even(RED), True), ((0, 0, 4), even(BLUE), False),
                     ((0, 0, -4), even(BLUE), False))
    for point in ((3.3, 0, 2.3), (-3.3, 0, 2.3), (0, 3.3, 2.3), (0, -3.3, 2.3)):
        views.AddExtremePoint(0, point)
    assert filtered(surface, views).GetOutput(2).GetNumberOfPoints() == 0, "no camera"
    found = {}
    for name, position in (("front", (0, 0, 4)), ("side", (4, 0, 0.05))):
        output = filtered(surface, views, Camera=camera_at(*position)).GetOutput(2)
        colors = output.GetPointData().GetArray("Colors")
        assert output.GetPointData().GetScalars() is colors
        assert output.GetPointData().HasArray("number") and output.GetNumberOfPolys() == surface.GetNumberOfPolys()
        found[name] = vtk_to_numpy(colors).astype(int)
    # Also along y = 0, where charts of both kinds of frames meet.
    points = places(surface)
    assert numpy.abs(found["front"][points[:, 2] > 0.3] - (*RED, 255)).max() <= 20
    turned = points[:, 0] > 0.7
    assert numpy.abs(found["side"][turned] - (*BLUE, 255)).max() <= 8
    assert surface.GetMTime() == before and not surface.GetPointData().HasArray("Colors")

    filter_ = filtered(surface, views, Camera=camera_at(0, 0, 4))
    filter_.GetCamera().SetPosition(4, 0, 0.05)
    filter_.Update()
    assert (vtk_to_numpy(filter_.GetOutput(2).GetPointData().GetScalars()) == found["side"]).all()
    views.AddBlendPoint((0, 0, 4), (0, 0, -1), 100.0)
    filter_.GetCamera().SetPosition(0, 0, 4)
    filter_.Update()
    colors = vtk_to_numpy(filter_.GetOutput(2).GetPointData().GetScalars()).astype(int)
    assert numpy.abs(colors - (*BLUE, 255)).max() <= 3


def test_changes_of_views_are_seen():
    views = views_of(((0, 0, 4), even(RED), False))
    filter_ = filtered(plane(), views)
    color = array(filter_.GetOutput(), "Independent")
    assert numpy.abs(color[:, 0].astype(int) - RED[0]).max() <= 1
    views.SetViewImage(0, even((30, 200, 30)))
    filter_.Update()
    assert numpy.abs(array(filter_.GetOutput(), "Independent")[:, 1].astype(int) - 200).max() <= 1
    views.SetFinestLevel(0)
    cells = filter_.GetOutput().GetNumberOfCells()
    filter_.Update()
    assert filter_.GetOutput().GetNumberOfCells() < cells / 16


def test_blocks():
    blocks = vtkMultiBlockDataSet()
    for i in range(2):
        surface = vtkPolyData()
        surface.DeepCopy(plane(2 + i))
        points = surface.GetPoints()
        for k in range(points.GetNumberOfPoints()):
            x, y, z = points.GetPoint(k)
            points.SetPoint(k, x, y, z + i)
        blocks.SetBlock(2 * i, surface)
    blocks.SetBlock(1, None)
    blocks.SetBlock(3, vtkPolyData())
    found = filtered(blocks, red_and_blue(), Camera=camera_at(0, 0, 9))
    assert abs(array(found.GetOutput(), "Area").sum() - 8) < 1e-4
    colored = found.GetOutputDataObject(2)
    assert isinstance(colored, vtkMultiBlockDataSet)
    for i in (0, 2):
        colors = vtk_to_numpy(colored.GetBlock(i).GetPointData().GetArray("Colors"))
        assert len(colors) == blocks.GetBlock(i).GetNumberOfPoints() and (colors[:, 3] == 255).all()
        assert not blocks.GetBlock(i).GetPointData().HasArray("Colors")
    found.SetInputDataObject(plane())
    found.Update()
    assert isinstance(found.GetOutputDataObject(2), vtkPolyData)


def messages_of(data, views=None, **properties):
    """The errors and warnings that come with a surface, and the filter."""
    texts = []

    def note(_caller, _event, text):
        texts.append(text)

    note.CallDataType = "string0"
    filter_ = hachure.vtkViewDependentTexture()
    for event in (vtkCommand.ErrorEvent, vtkCommand.WarningEvent):
        filter_.AddObserver(event, note)
        filter_.GetExecutive().AddObserver(vtkCommand.ErrorEvent, lambda *_: None)
    filter_.SetInputDataObject(data)
    filter_.SetViews(red_and_blue() if views is None else views)
    filter_.SetCamera(camera_at(0, 0, 4))
    for name, value in properties.items():
        getattr(filter_, "Set" + name)(value)
    filter_.Update()
    return texts, filter_


def test_odd_input():
    for data in (vtkPolyData(), vtkMultiBlockDataSet()):
        texts, found = messages_of(data)
        assert not texts and [found.GetOutputDataObject(i).GetNumberOfCells() for i in range(3)] == [0, 0, 0]
    line = vtkLineSource()
    line.Update()
    texts, found = messages_of(line.GetOutput())
    assert not texts and found.GetOutput().GetNumberOfCells() == 0
    assert (vtk_to_numpy(found.GetOutput(2).GetPointData().GetScalars()) == 0).all()

    one = vtkPolyData()
    points = vtkPoints()
    cells = vtkCellArray()
    for point in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (5, 5, 5)):
        points.InsertNextPoint(point)
    for corners_ in ((0, 1, 2), (0, 1, 1)):
        cells.InsertNextCell(3, corners_)
    one.SetPoints(points)
    one.SetPolys(cells)
    texts, found = messages_of(one)
    assert not texts and abs(array(found.GetOutput(), "Area").sum() - 0.5) < 1e-6
    colors = vtk_to_numpy(found.GetOutput(2).GetPointData().GetScalars())
    assert (colors[:3, 3] == 255).all() and (colors[3] == 0).all()

    points.SetPoint(3, numpy.nan, 0, 0)
    cells.InsertNextCell(3, (0, 1, 3))
    points.Modified(), one.Modified()
    texts, found = messages_of(one)
    assert len(texts) == 1 and "1 input point(s)" in texts[0], texts
    assert abs(array(found.GetOutput(), "Area").sum() - 0.5) < 1e-6


def test_strips_and_polygons():
    strips = vtkStripper()
    strips.SetInputData(sphere(20))
    strips.Update()
    assert strips.GetOutput().GetNumberOfStrips() > 0
    area = array(filtered(strips.GetOutput(), red_and_blue()).GetOutput(), "Area").sum()
    assert abs(area / array(filtered(sphere(20), red_and_blue()).GetOutput(), "Area").sum() - 1) < 0.02
    assert abs(array(filtered(plane(3), red_and_blue()).GetOutput(), "Area").sum() - 4) < 1e-4


def test_no_views():
    output = filtered(sphere(), hachure.vtkTextureViews()).GetOutput()
    assert output.GetNumberOfCells() > 100
    assert (array(output, "Independent")[:, 3] == 0).all() and (array(output, "View") == -1).all()
    assert not output.GetCellData().HasArray("ViewShares")
    assert hachure.vtkViewDependentTexture().GetViews().GetNumberOfViews() == 0


def test_wrong_input():
    broken = vtkPolyData()
    broken.DeepCopy(plane())
    cells = vtkCellArray()
    cells.InsertNextCell(3, (0, 1, 9))
    broken.SetPolys(cells)
    texts, found = messages_of(broken)
    assert len(texts) == 1 and "refers to point 9" in texts[0], texts
    assert found.GetOutput().GetNumberOfCells() == 0
    filter_ = hachure.vtkViewDependentTexture()
    texts = []

    def note(_caller, _event, text):
        texts.append(text)

    note.CallDataType = "string0"
    filter_.AddObserver(vtkCommand.ErrorEvent, note)
    own = filter_.GetViews()
    filter_.SetViews(None)
    assert len(texts) == 1 and "the views are null" in texts[0] and filter_.GetViews() is own


def test_abort():
    whole = []
    for most in (2, 6, 10, 1000):
        filter_ = hachure.vtkViewDependentTexture()
        filter_.SetInputData(sphere())
        filter_.SetViews(red_and_blue())
        progress = []

        def stop(*_):
            progress.append(filter_.GetProgress())
            if len(progress) == most:
                filter_.SetAbortExecute(1)

        filter_.AddObserver(vtkCommand.ProgressEvent, stop)
        filter_.Update()
        assert progress == sorted(progress), progress
        whole.append(filter_.GetOutput().GetNumberOfCells())
        assert filter_.GetOutput(1).GetNumberOfCells() == 0 or whole[-1] > 0
    print("reports of progress", len(progress))
    assert whole[:3] == [0, 0, 0] and whole[3] > 0, whole


for name, function in list(globals().items()):
    if name.startswith("test_"):
        function()
