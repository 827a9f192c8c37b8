# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Keys and methods add, change, remove and save views and their points, and take that back."""

import os
import tempfile

import hachure
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonMath import vtkMatrix4x4

from view_scene import expect_error, image, new_views, number_of_errors, pixels
from widget_scene import SIZE, TRANSFORM, Scene, place_of, two_views

Drawn = hachure.vtkTextureViewsRepresentation
Views = hachure.vtkTextureViews


def seen_by(scene, view):
    """Where a view sees points of the surface, in pixels from the lower left corner."""
    matrix = vtkMatrix4x4()
    assert scene.views.ComputeModelToClip(view, matrix)
    result = []
    for point in ((0.3, 0.2, 0.1), (-0.4, 0.1, 0.2), (0.0, -0.3, 0.3)):
        clip = numpy.array(matrix.MultiplyPoint((*point, 1.0)))
        result.append((0.5 + 0.5 * clip[:2] / clip[3]) * SIZE)
    return numpy.array(result)


def seen_by_renderer(scene):
    return numpy.array([scene.display(point)[:2] for point in (
        (0.3, 0.2, 0.1), (-0.4, 0.1, 0.2), (0.0, -0.3, 0.3))])


def curve(views, view):
    points = []
    for i in range(views.GetNumberOfFadePoints(view)):
        point = [0.0] * 2
        views.GetFadePoint(view, i, point)
        points.append(tuple(round(number, 9) for number in point))
    return points


def test_add_camera():
    """The view sees what the renderer sees, also where only a matrix can say that."""
    sheared = TRANSFORM + numpy.array([[0, 0, 1.0, 0], [0] * 4, [0] * 4, [0] * 4])
    for transform, is_camera in ((None, True), (TRANSFORM, True), (sheared, False)):
        for parallel in (False, True):
            scene = Scene(new_views(), transform, parallel)
            scene.press("a", "a")
            assert scene.views.GetNumberOfViews() == 1
            assert scene.views.GetViewName(0) == "view 1" and scene.drawn.GetSelectedView() == 0
            assert (scene.views.GetViewCamera(0) is not None) == is_camera
            assert numpy.abs(seen_by(scene, 0) - seen_by_renderer(scene)).max() < 1.0
            picture = scene.views.GetViewImage(0)
            assert picture.GetDimensions()[:2] == SIZE
            alpha = vtk_to_numpy(picture.GetPointData().GetScalars())[:, 3].reshape(SIZE[::-1])
            x, y = scene.display((0.0, 0.0, 0.0))[:2].astype(int)
            assert alpha[y, x] == 255 and alpha[2, 2] == 0 and set(numpy.unique(alpha)) == {0, 255}
    scene.widget.SetPicture(scene.widget.TRANSPARENT)
    assert scene.widget.AddCurrentCamera("mine") == 1 and scene.views.GetViewName(1) == "mine"
    assert not vtk_to_numpy(scene.views.GetViewImage(1).GetPointData().GetScalars()).any()
    given = image(8, 6)
    assert scene.widget.AddCurrentCamera("", given) == 2 and scene.views.GetViewImage(2) is given
    assert scene.views.GetViewName(2) == "view 2"


def test_picture_is_without_the_widget():
    scene = Scene(two_views())
    scene.drawn.SelectView(0)
    with_widget = scene.pixels()
    scene.widget.AddCurrentCamera("a")
    found = vtk_to_numpy(scene.views.GetViewImage(2).GetPointData().GetScalars())
    scene.widget.Off()
    alone = scene.pixels()
    assert (alone != with_widget).any()
    shown = found[:, 3].reshape(SIZE[::-1]) > 0
    difference = found[:, :3].reshape(*SIZE[::-1], 3)[shown] - alone[shown].astype(int)
    assert numpy.abs(difference).max() <= 2 and shown.any()


def test_add_points():
    scene = Scene(two_views(), TRANSFORM)
    scene.press("e", "e", place=(180, 130))
    assert scene.views.GetNumberOfExtremePoints(1) == 0, "no view is selected"
    scene.drawn.SelectView(1)
    scene.press("e", "e", place=(180, 130))
    added = place_of(scene.views.GetExtremePoint, 1, 0)
    assert scene.views.GetViewKind(1) == Views.DEPENDENT
    assert abs(numpy.linalg.norm(added) - numpy.linalg.norm((2.5, 1.0, 1.5))) < 1e-9
    assert numpy.abs(scene.display(added)[:2] - (180, 130)).max() < 1.0
    assert scene.drawn.GetSelectedItem() == Drawn.EXTREME_POINT
    scene.press("b", "b")
    position, direction = (place_of(get, 1) for get in (
        scene.views.GetBlendPointPosition, scene.views.GetBlendPointDirection))
    assert numpy.allclose(position, (3.0, 2.5, 9.0)) and scene.views.GetBlendPointPercentage(1) == 50
    assert numpy.allclose(direction / numpy.linalg.norm(direction),
                          -position / numpy.linalg.norm(position))


def test_numbers():
    scene = Scene(two_views())
    scene.drawn.SelectBlendPoint(0)
    scene.press("plus", "+")
    assert scene.views.GetBlendPointPercentage(0) == 45.0
    for _ in range(12):
        scene.press("minus", "-")
    assert scene.views.GetBlendPointPercentage(0) == 0.0
    scene.drawn.SelectView(0)
    scene.press("plus", "+")
    assert curve(scene.views, 0) == [(0, 1), (0.55, 1), (1, 0)]
    for _ in range(20):
        scene.press("minus", "-")
    assert curve(scene.views, 0) == [(0, 1), (1, 0)]
    scene.widget.ChangePlateau(2.0)
    assert curve(scene.views, 0) == [(0, 1), (0.99, 1), (1, 0)]
    scene.views.RemoveAllFadePoints(0)
    scene.press("minus", "-")
    assert curve(scene.views, 0) == [(0, 1), (0.95, 1), (1, 0)]
    modes = []
    for _ in range(3):
        scene.press("m", "m")
        modes.append(scene.views.GetFadeMode(0))
    assert modes == [Views.MIDDLE, Views.EVEN, Views.CURVE]


def test_remove_and_undo():
    scene = Scene(two_views())
    assert not scene.widget.RemoveSelected() and not scene.widget.Undo()
    scene.drawn.SelectExtremePoint(0, 2)
    scene.press("Delete", "\x7f")
    assert scene.views.GetNumberOfExtremePoints(0) == 3
    assert scene.drawn.GetSelectedItem() == Drawn.VIEW
    scene.press("Delete", "\x7f")
    assert scene.views.GetNumberOfViews() == 1 and scene.views.GetViewName(0) == "side"
    scene.drawn.SelectBlendPoint(0)
    scene.press("BackSpace", "\x08")
    assert scene.views.GetNumberOfBlendPoints() == 0
    scene.press("z", "\x1a", control=True)
    assert scene.views.GetBlendPointPercentage(0) == 40.0
    assert scene.widget.Undo() and scene.views.GetViewName(0) == "front"
    assert scene.widget.Undo() and scene.views.GetNumberOfExtremePoints(0) == 4
    assert not scene.widget.CanUndo()
    start = scene.display((0.0, 0.0, 4.0))[:2]
    scene.drag([start, start + 5, start + 30])
    assert scene.widget.Undo() and not scene.widget.CanUndo(), "a drag is one action"
    assert scene.views.GetViewCamera(0).GetPosition() == (0.0, 0.0, 4.0)


def test_save():
    scene = Scene(two_views())
    expect_error(lambda: scene.press("s", "s"), "file name")
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "views.json")
        scene.widget.SetManifestFileName(name)
        scene.widget.AddBlendPoint(10.0)
        scene.press("s", "s")
        read = new_views()
        assert hachure.vtkTextureViewsManifest().Read(name, read)
        assert read.GetNumberOfBlendPoints() == 2 and read.GetNumberOfExtremePoints(0) == 4
        assert pixels(read.GetViewImage(1)) == pixels(scene.views.GetViewImage(1))
        files = sorted(os.listdir(folder))
        scene.widget.Undo()
        assert scene.views.GetNumberOfBlendPoints() == 1
        assert scene.widget.Save() and sorted(os.listdir(folder)) == files, "images have files"
        scene.widget.SetManifestFileName(os.path.join(folder, "none", "views.json"))
        assert not expect_error(scene.widget.Save, "Save", "no folder")


def test_keys_of_others():
    """What has nothing to act on is left to others, but never the key that ends programs."""
    scene, others = Scene(new_views()), []
    for name in ("KeyPressEvent", "CharEvent"):
        scene.interactor.AddObserver(
            name, lambda caller, event: others.append((caller.GetKeySym(), event)))
    for symbol, key in (("q", "q"), ("Delete", "\x7f"), ("plus", "+"), ("m", "m"), ("z", "z")):
        scene.press(symbol, key)
    assert [event[0] for event in others[::2]] == ["q", "Delete", "plus", "m", "z"]
    assert len(others) == 10, "both events"
    others.clear()
    scene.press("e", "e")
    assert not others
    scene.widget.ProcessEventsOff()
    scene.press("e", "e")
    assert len(others) == 2


def test_wrong_input():
    scene = Scene(two_views())
    for call in (lambda: scene.drawn.SelectView(2), lambda: scene.drawn.SelectView(-1),
                 lambda: scene.drawn.SelectExtremePoint(1, 0),
                 lambda: scene.drawn.SelectBlendPoint(1)):
        assert not expect_error(call, "cannot be selected")
    assert expect_error(lambda: scene.widget.AddBlendPoint(101.0), "101") == -1
    assert not scene.widget.CanUndo() and scene.views.GetNumberOfBlendPoints() == 1
    scene.drawn.SelectExtremePoint(0, 3)
    scene.views.RemoveExtremePoint(0, 3)
    assert scene.drawn.GetSelectedItem() == Drawn.NOTHING and scene.drawn.GetSelectedView() == 0
    scene.views.RemoveAllViews()
    assert scene.drawn.GetSelectedView() == -1 and not scene.widget.SwitchFadeMode()
    assert scene.widget.AddBlendPoint(5.0) == 1 and scene.widget.CanUndo()
    for others in (two_views(), None):
        scene.drawn.SetViews(others)
        assert not scene.widget.Undo(), "what was done to others"
    scene.widget.SetViews(None)
    scene.window.Render()
    scene.press("a", "a")
    for call in (lambda: scene.widget.AddCurrentCamera("a"), lambda: scene.widget.AddBlendPoint(1)):
        assert expect_error(call, "no views") == -1
    assert not expect_error(scene.widget.Save, "no views")
    scene.widget.SetViews(new_views())
    scene.widget.Off()
    assert expect_error(lambda: scene.widget.AddCurrentCamera("a"), "no renderer") == -1


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        assert number_of_errors() == 0, name
