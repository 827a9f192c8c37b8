# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Views are drawn where they are: pictures with their colours, ranges through extreme points."""

import hachure
import numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkActor, vtkPropCollection, vtkRenderer

from view_scene import image, new_views, number_of_errors
from widget_scene import EXTREMES, TRANSFORM, Scene, camera, matrix_of, two_views

YELLOW = (255, 217, 26)


def flat_image(color, width=30, height=20):
    """Of one colour, with a transparent pixel, so that it is no longer an opaque thing."""
    result = vtkImageData()
    result.SetDimensions(width, height, 1)
    result.AllocateScalars(3, 4)  # unsigned char
    for component in range(4):
        result.GetPointData().GetScalars().FillComponent(component, color[component])
    result.SetScalarComponentFromDouble(0, 0, 0, 3, 0.0)
    return result


def near(found, expected, tolerance=3):
    return (numpy.abs(found.astype(int) - expected) <= tolerance).all(-1)


def corners(scene, view, size):
    """Of the picture of a view with a camera, in the surface's coordinates."""
    seen = scene.views.GetViewCamera(view)
    position, focus, up = (numpy.array(get()) for get in (
        seen.GetPosition, seen.GetFocalPoint, seen.GetViewUp))
    sight = (focus - position) / numpy.linalg.norm(focus - position)
    width, height, _ = scene.views.GetViewImage(view).GetDimensions()
    half = 0.5 * size * numpy.array((width, height)) / max(width, height)
    depth = half[1] / numpy.tan(numpy.radians(0.5 * seen.GetViewAngle()))
    right = numpy.cross(sight, up)
    right /= numpy.linalg.norm(right)
    up = numpy.cross(right, sight)
    return [position + depth * sight + x * half[0] * right + y * half[1] * up
            for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def test_regions():
    """The border between what two views cover is a line on the surface."""
    scene = Scene(new_views(), TRANSFORM)
    for x in (-3.0, 3.0):
        scene.views.AddView("", camera((x, 0.0, 3.0)), flat_image((200, 200, 200, 255), 64, 64))
    scene.drawn.ShowPicturesOff()
    scene.drawn.ShowLabelsOff()
    scene.renderer.ResetCamera()
    without = scene.pixels()
    scene.drawn.SetSurface(scene.actor.GetMapper().GetInput())
    lines = (scene.pixels() < 30).all(-1) & ~(without < 30).all(-1)
    assert lines.sum() > 20, lines.sum()
    scene.drawn.SetSurface(None)
    assert (scene.pixels() == without).all()


def test_pictures():
    """They have the colours of the image, and are transparent where it or its mask is."""
    for transform, parallel in ((None, False), (TRANSFORM, True)):
        scene = Scene(new_views(), transform, parallel)
        scene.views.AddView("", camera((2.0, 1.0, 3.0)), flat_image((250, 20, 40, 255)))
        scene.drawn.SetPictureSize(0.5)
        scene.drawn.ShowLabelsOff()
        picture = numpy.array(corners(scene, 0, 0.5 * numpy.sqrt(3.0)))
        x, y = scene.display(picture.mean(0))[:2].astype(int)
        assert near(scene.pixels()[y, x], (250, 20, 40)), scene.pixels()[y, x]
        for corner in picture:
            for share, is_inside in ((0.85, True), (1.2, False)):
                u, v = scene.display(
                    picture.mean(0) + share * (corner - picture.mean(0)))[:2].astype(int)
                # The lines of the pyramid are in front of some pixels.
                around = scene.pixels()[v - 3:v + 4, u - 3:u + 4]
                assert near(around, (250, 20, 40)).any() == is_inside, (corner, share)
        scene.views.SetViewMask(0, flat_image((0, 0, 0, 0)))
        transparent = scene.pixels()
        scene.drawn.ShowPicturesOff()
        assert (scene.pixels() == transparent).all(), "nothing is seen of a hidden picture"
        scene.views.SetViewMask(0, None)
        scene.drawn.ShowPicturesOn()
        scene.views.GetViewImage(0).DeepCopy(flat_image((0, 90, 200, 255)))
        assert near(scene.pixels()[y, x], (0, 90, 200)), "painted in place"
        scene.renderer.SetUseDepthPeeling(True)
        assert near(scene.pixels()[y, x], (0, 90, 200))


def test_selection():
    scene = Scene(two_views(), TRANSFORM)
    scene.look_from((4.0, 3.5, 13.0))
    scene.drawn.ShowLabelsOff()

    def yellow():
        return near(scene.pixels(), YELLOW, 1).sum()

    assert yellow() == 0
    none = scene.pixels()
    scene.drawn.SelectView(1)
    assert yellow() > 50
    scene.drawn.SelectView(0)
    shown = scene.pixels()
    for extreme in EXTREMES:
        x, y = scene.display(extreme)[:2].round().astype(int)
        assert (shown[y, x] != none[y, x]).any(), extreme
    x, y = scene.display(numpy.add(EXTREMES[0], EXTREMES[1]) * 0.5 * 4.0311 / numpy.linalg.norm(
        numpy.add(EXTREMES[0], EXTREMES[1]) * 0.5))[:2].round().astype(int)
    assert (shown[y - 2:y + 3, x - 2:x + 3] != none[y - 2:y + 3, x - 2:x + 3]).any(), "the border"
    scene.drawn.SelectNothing()
    assert (scene.pixels() == none).all()


def test_labels():
    scene = Scene(two_views())
    shown = scene.pixels()
    scene.drawn.ShowLabelsOff()
    assert (scene.pixels() != shown).any()
    scene.drawn.ShowLabelsOn()
    scene.views.SetViewName(0, "$x^2$ \u00e9")
    assert (scene.pixels() != shown).any()


def test_at_the_camera():
    """A view that is where the renderer's camera is would hide all: it is not drawn, nor hit."""
    scene = Scene(new_views())
    none = scene.pixels()
    scene.widget.AddCurrentCamera("a", flat_image((250, 20, 40, 255), 400, 300))
    assert (scene.pixels() == none).all()
    assert scene.drawn.ComputeInteractionState(50, 50) == scene.drawn.NOTHING


def test_bounds():
    assert Scene(new_views()).drawn.GetBounds() is None
    scene = Scene(two_views(), TRANSFORM)
    scene.drawn.SelectView(0)
    bounds = numpy.array(scene.drawn.GetBounds()).reshape(3, 2)
    for point in (*EXTREMES, (2.5, 1.0, 1.5), (0.0, 0.0, 4.0), (-1.5, 1.0, 1.0)):
        world = scene.world(point)
        assert (bounds[:, 0] <= world + 1e-9).all() and (world <= bounds[:, 1] + 1e-9).all(), point
    actors = vtkPropCollection()
    scene.drawn.GetActors(actors)
    assert actors.GetNumberOfItems() > 10
    assert all(isinstance(actors.GetItemAsObject(i), vtkActor)
               for i in range(actors.GetNumberOfItems()))


def test_odd_views():
    """Matrices of either sign, without perspective, wide and narrow angles, and none of all that."""
    scene = Scene(new_views())
    matrix = vtkMatrix4x4()
    narrow, wide, parallel = (camera((0.0, 0.0, 4.0)) for _ in range(3))
    narrow.SetViewAngle(1e-3)
    wide.SetViewAngle(175.0)
    parallel.SetParallelProjection(True)
    for one in (narrow, wide, parallel):
        given = new_views()
        given.AddView("", one, image(5, 9))
        given.ComputeModelToClip(0, matrix)
        numbers = [matrix.GetElement(i // 4, i % 4) for i in range(16)]
        # The same picture, whichever way the camera is given.
        found = []
        for sign in (0.0, 1.0, -1.0):
            scene.views.RemoveAllViews()
            matrix.DeepCopy([sign * number for number in numbers])
            scene.views.AddView("", matrix if sign else one, image(5, 9))
            scene.drawn.SelectView(0)
            found.append(near(scene.pixels(), YELLOW, 1))
            bounds = scene.drawn.GetBounds()
            assert numpy.isfinite(bounds).all() and numpy.abs(bounds).max() < 10.0, bounds
        assert all(drawn.sum() > 10 for drawn in found)
        if one is not parallel:  # of which a matrix does not say where it is
            assert (found[0] != found[1]).sum() < 5
        assert (found[1] == found[2]).all()


def test_wrong_scenes():
    """Nothing is drawn, and nothing goes wrong."""
    scene = Scene(two_views())
    scene.drawn.SetModelToWorld(matrix_of(numpy.diag((1.0, 1.0, 0.0, 1.0))))
    assert scene.drawn.GetBounds() is None
    scene.pixels()
    scene.drag([(50, 50), (60, 60)])
    scene.drawn.SetModelToWorld(None)
    assert scene.drawn.GetBounds() is not None
    alone = hachure.vtkTextureViewsRepresentation()
    assert alone.GetBounds() is None and alone.ComputeInteractionState(1, 1) == alone.NOTHING
    alone.SetViews(two_views())
    alone.SelectView(0)
    assert alone.GetBounds() is not None, "without renderer and place"
    other = vtkRenderer()
    other.AddViewProp(alone)
    scene.window.AddRenderer(other)
    other.ResetCamera()
    scene.pixels()
    scene.views.GetViewImage(0).DeepCopy(vtkImageData())
    scene.pixels()


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        assert number_of_errors() == 0, name
