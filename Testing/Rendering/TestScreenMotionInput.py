# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Input that gives no motion gives a message that names it, and no output."""

import hachure
import motion_scene as motion
import numpy
import pattern_scene as scene
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPolyData

BALL = scene.sphere(8).GetOutput()
SQUARE = scene.plane(1.0).GetOutput()


def calculator():
    result = hachure.vtkPatternMotion()
    result.SetSize(32, 24)
    result.SetCameraBefore(motion.camera_at())
    result.SetCameraAfter(motion.camera_at())
    return result


def refused(result, *messages, window=motion.window):
    assert not result.Compute(window)
    assert result.GetOutput() is None
    scene.expect_messages(*messages)


def copy(data):
    result = vtkPolyData()
    result.DeepCopy(data)
    return result


def test_cameras():
    for name in ("CameraBefore", "CameraAfter"):
        result = calculator()
        assert result.Compute(motion.window) and result.GetOutput()
        getattr(result, "Set" + name)(None)
        refused(result, name + " is not set")


def test_cameras_are_copies():
    camera = motion.camera_at()
    result = calculator()
    result.SetCameraBefore(camera)
    camera.SetPosition(7.0, 7.0, 7.0)
    assert result.GetCameraBefore().GetPosition() == motion.EYE


def test_size_and_window():
    result = calculator()
    result.SetSize(0, 24)
    refused(result, "Size is 0 x 24, expected at least 1 x 1")
    result.SetSize(32, -3)
    refused(result, "Size is 32 x -3")
    result.SetSize(10000000, 1)
    refused(result, "Size is 10000000 x 1, expected at most ")
    refused(calculator(), "window is nothing, expected a vtkOpenGLRenderWindow", window=None)


def test_other_mesh_after():
    for data, message in (
            (SQUARE, "surface 1: the state after has 4 points, expected 50 as before"),
            (fewer_polygons(), "surface 1: the state after has 1 polygons, expected 96 as before"),
            (other_corners(), "surface 1: the state after joins its points in another way")):
        result = calculator()
        result.AddSurface(BALL, data)
        refused(result, message)
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, BALL)
    blocks.SetBlock(1, BALL)
    result = calculator()
    result.AddSurface(BALL)
    result.AddSurface(blocks, BALL)
    refused(result, "surface 2: the state after has 1 blocks of polydata, expected 2 as before")
    other = vtkMultiBlockDataSet()
    other.SetBlock(0, BALL)
    other.SetBlock(1, SQUARE)
    result = calculator()
    result.AddOccluder(blocks, other)
    refused(result, "occluder 1, block 2: the state after has 4 points")


def fewer_polygons():
    result = copy(BALL)
    result.SetPolys(SQUARE.GetPolys())
    return result


def other_corners():
    result = copy(BALL)
    replace_polygon(result, (1, 2, 3))
    return result


def replace_polygon(data, points):
    ids = vtkIdList()
    for point in points:
        ids.InsertNextId(point)
    data.GetPolys().ReplaceCellAtId(3, ids)


def test_bad_data():
    for data, name in ((None, "nothing"), (vtkImageData(), "vtkImageData")):
        result = calculator()
        result.AddSurface(data)
        refused(result, "surface 1 before is %s, expected vtkPolyData or a composite" % name)
    bad = copy(BALL)
    bad.GetPoints().SetPoint(7, numpy.nan, 0.0, 0.0)
    result = calculator()
    result.AddSurface(BALL, bad)
    refused(result, "surface 1: point 7 of the state after is not finite")
    bad = copy(BALL)
    replace_polygon(bad, (1, 2, 50))
    result = calculator()
    result.AddSurface(bad)
    refused(result, "surface 1: a polygon names point 50 of 50")


def test_function():
    cameras = motion.camera_at(), motion.camera_at()
    image = hachure.screen_motion(motion.window, (32, 24), cameras, [BALL], [(SQUARE, None)])
    assert image.GetDimensions() == (32, 24, 1)
    array = image.GetPointData().GetScalars()
    names = [array.GetComponentName(i) for i in range(array.GetNumberOfComponents())]
    assert names == ["u", "v", "visible", "facing", "distance", "label"]
    try:
        hachure.screen_motion(motion.window, (0, 24), cameras, [BALL])
    except RuntimeError:
        scene.expect_messages("Size is 0 x 24")
    else:
        raise AssertionError("no error")


def test_labels_and_reuse():
    result = calculator()
    assert [result.AddSurface(BALL), result.AddSurface(SQUARE)] == [1, 2]
    result.AddOccluder(BALL)
    assert result.GetNumberOfSurfaces() == 2
    assert result.Compute(motion.window)
    first = result.GetOutput()
    assert result.Compute(motion.window)
    assert first is not result.GetOutput(), "an earlier output was written again"
    result.RemoveAllSurfaces()
    assert result.GetNumberOfSurfaces() == 0 and result.AddSurface(BALL) == 1


scene.run(globals())
