# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The mouse selects views and their points and drags them; where nothing is it does nothing."""

import hachure
import numpy

from view_scene import number_of_errors
from widget_scene import EXTREMES, TRANSFORM, Scene, place_of, two_views

Drawn = hachure.vtkTextureViewsRepresentation
SCENES = ((None, False), (TRANSFORM, False), (TRANSFORM, True))


def extreme(scene, index):
    return place_of(scene.views.GetExtremePoint, 0, index)


def test_extreme_point():
    """It stays on its sphere and under the cursor."""
    for transform, parallel in SCENES:
        scene = Scene(two_views(), transform, parallel)
        scene.drawn.SelectView(0)
        radius = numpy.linalg.norm(EXTREMES[1])
        before = scene.views.GetViewRangeMTime(0)
        start = scene.display(EXTREMES[1])[:2]
        ends = [start + step for step in ((10, 4), (22, -15), (-14, -25))]
        scene.drag([start, *ends])
        assert scene.drawn.GetSelectedItem() == Drawn.EXTREME_POINT
        assert scene.drawn.GetSelectedPoint() == 1
        moved = extreme(scene, 1)
        assert abs(numpy.linalg.norm(moved) - radius) < 1e-9 * radius, moved
        assert numpy.abs(scene.display(moved)[:2] - ends[-1]).max() < 1.0
        assert scene.views.GetViewRangeMTime(0) > before
        assert numpy.array_equal(extreme(scene, 0), EXTREMES[0])
        scene.event("MouseMoveEvent", start)
        assert numpy.array_equal(extreme(scene, 1), moved), "the button is up"


def test_beside_the_sphere():
    """Beside the sphere the point is where it is nearest to the line of sight."""
    scene = Scene(two_views())
    scene.look_from((6.0, 5.0, 18.0))
    scene.drawn.SelectView(0)
    start = scene.display(EXTREMES[1])[:2]
    scene.event("LeftButtonPressEvent", start)
    scene.event("MouseMoveEvent", (0, 299))
    moved = extreme(scene, 1)
    place = numpy.array((0, 299)) + start - numpy.round(start)
    scene.renderer.SetDisplayPoint(*place, 0.5)
    scene.renderer.DisplayToWorld()
    world = numpy.array(scene.renderer.GetWorldPoint())
    eye = numpy.array(scene.renderer.GetActiveCamera().GetPosition())
    sight = world[:3] / world[3] - eye
    nearest = eye - sight * (eye @ sight) / (sight @ sight)
    radius = numpy.linalg.norm(EXTREMES[1])
    assert numpy.linalg.norm(nearest) > radius, "the test is about a line beside the sphere"
    assert numpy.allclose(moved, radius * nearest / numpy.linalg.norm(nearest))
    scene.event("MouseMoveEvent", start)
    assert numpy.abs(scene.display(extreme(scene, 1))[:2] - start).max() < 1.0


def test_camera():
    for transform, parallel in SCENES:
        scene = Scene(two_views(), transform, parallel)
        start = scene.display((0.0, 0.0, 4.0))[:2]
        scene.drag([start, start + (8, 3), start + (25, 11)])
        assert scene.drawn.GetSelectedItem() == Drawn.VIEW and scene.drawn.GetSelectedView() == 0
        moved = scene.views.GetViewCamera(0)
        position, up = numpy.array(moved.GetPosition()), numpy.array(moved.GetViewUp())
        assert moved.GetFocalPoint() == (0.0, 0.0, 0.0)
        assert abs(numpy.linalg.norm(position) - 4.0) < 1e-9 and abs(position @ up) < 1e-9
        assert numpy.abs(scene.display(position)[:2] - start - (25, 11)).max() < 1.0
        start = scene.display(position)[:2]
        end = start + 0.3 * (scene.display((0.0, 0.0, 0.0))[:2] - start)
        scene.drag([start, end], shift=True)
        nearer = numpy.array(scene.views.GetViewCamera(0).GetPosition())
        assert numpy.linalg.norm(nearer) < 3.8
        assert numpy.allclose(nearer / numpy.linalg.norm(nearer), position / 4.0)
        assert numpy.abs(scene.display(nearer)[:2] - end).max() < 1.5


def test_blend_point():
    for transform, parallel in SCENES:
        scene = Scene(two_views(), transform, parallel)
        start = scene.display((-1.5, 1.0, 1.0))
        scene.drag([start, start[:2] + (30, -20)])
        assert scene.drawn.GetSelectedItem() == Drawn.BLEND_POINT
        moved = scene.display(place_of(scene.views.GetBlendPointPosition, 0))
        assert numpy.abs(moved[:2] - start[:2] - (30, -20)).max() < 1.0
        assert abs(moved[2] - start[2]) < 1e-9, "parallel to the screen"
        assert tuple(place_of(scene.views.GetBlendPointDirection, 0)) == (1.0, 0.0, 0.0)
        assert scene.views.GetBlendPointPercentage(0) == 40.0
        scene.drag([moved, moved[:2] + (0, 20)], shift=True)
        further = scene.display(place_of(scene.views.GetBlendPointPosition, 0))
        assert numpy.abs(further[:2] - moved[:2]).max() < 1e-6, "along the line of sight"
        assert further[2] > moved[2] + 1e-4


def test_what_is_hit():
    """Elsewhere others get all events; what is behind the surface is elsewhere."""
    scene = Scene(two_views())
    scene.interactor.SetInteractorStyle(None)  # which would keep what follows for itself
    scene.drawn.SelectView(0)
    others = []
    for name in ("LeftButtonPressEvent", "MouseMoveEvent", "LeftButtonReleaseEvent"):
        scene.interactor.AddObserver(name, lambda _caller, event: others.append(event))
    all_events = ["LeftButtonPressEvent", "MouseMoveEvent", "LeftButtonReleaseEvent"]
    surface = scene.display((0.0, 0.0, 0.0))[:2]
    for place in ((2, 2), surface):
        scene.drag([place, place])
        assert others == all_events, (place, others)
        others.clear()
    assert scene.drawn.GetSelectedView() == 0
    scene.drag([scene.display(EXTREMES[0])] * 2)
    assert not others
    scene.look_from((0.0, 0.1, -9.0))
    behind = scene.display((0.0, 0.0, 4.0))[:2]
    assert scene.drawn.ComputeInteractionState(*behind.astype(int)) == Drawn.NOTHING
    scene.actor.VisibilityOff()
    scene.window.Render()
    assert scene.drawn.ComputeInteractionState(*behind.astype(int)) == Drawn.VIEW


def test_events():
    scene, found = Scene(two_views()), []
    scene.widget.AddObserver("AnyEvent", lambda _caller, event: found.append(event))
    start = scene.display((0.0, 0.0, 4.0))[:2]
    scene.drag([start, start + 5, start + 9])
    wanted = [event for event in found if "Interaction" in event]
    assert wanted == ["StartInteractionEvent", "InteractionEvent", "InteractionEvent",
                      "EndInteractionEvent"], wanted
    scene.event("LeftButtonPressEvent", scene.display(
        scene.views.GetViewCamera(0).GetPosition())[:2])
    scene.views.RemoveAllViews()
    scene.event("MouseMoveEvent", (50, 50))
    scene.widget.Off()
    assert found.count("EndInteractionEvent") == 2
    scene.event("MouseMoveEvent", (60, 50))


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        assert number_of_errors() == 0, name
