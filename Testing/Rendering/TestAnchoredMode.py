# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Anchored patterns are a function of camera and path alone, whatever was drawn before."""

import math
import random

import hachure
import pattern_scene as scene
from vtkmodules.vtkRenderingCore import vtkCamera, vtkCameraInterpolator

FRAMES = 16


def set_camera(camera, i):
    angle = 2.0 * math.pi * i / FRAMES
    camera.SetPosition(3.0 * math.sin(angle), 0.5 * math.sin(2.0 * angle), 3.0 * math.cos(angle))
    camera.SetFocalPoint(0.1, 0.0, 0.0)
    camera.SetViewUp(0.0, 1.0, 0.0)
    camera.SetClippingRange(1.0, 6.0)


class Stage:
    def __init__(self, mode):
        self.style = hachure.style("cross-hatch")
        self.style.SetTrackingMode(mode)
        actors = [scene.actor_of(scene.sphere(24, 0.6, (-0.3, 0.0, 0.2)), self.style),
                  scene.actor_of(scene.sphere(24, 0.4, (0.5, 0.1, -0.3)), self.style)]
        self.mappers = [actor.GetMapper() for actor in actors]
        self.renderer = scene.renderer_of(*actors)
        self.window = scene.window_of(self.renderer, size=(160, 160))

    def frame(self, i):
        set_camera(self.renderer.GetActiveCamera(), i)
        for mapper in self.mappers:
            mapper.SetAnimationTime(float(i))
        return scene.draw(self.window)


def with_path(stage, keys=(0.0, 6.5, 11.0), step=0.5):
    path = vtkCameraInterpolator()
    path.SetInterpolationTypeToSpline()
    for i in range(FRAMES + 1):
        camera = vtkCamera()
        set_camera(camera, i)
        path.AddCamera(float(i), camera)
    for mapper in stage.mappers:
        mapper.SetCameraPath(path)
        mapper.SetReplayStep(step)
        for key in keys:
            mapper.AddKeyTime(key)
    return stage


def different_frames(ordered, prepare=lambda stage: stage, mode=hachure.vtkPatternStyle.ANCHORED):
    """How many frames of the orbit change when they are drawn in another order."""
    order = list(range(FRAMES))
    random.Random(3).shuffle(order)
    stage = prepare(Stage(mode))
    shuffled = {i: stage.frame(i) for i in order}
    return sum((ordered[i] != shuffled[i]).any() for i in range(FRAMES))


def drawn_in_order(stage):
    return [stage.frame(i) for i in range(FRAMES)]


def test_shuffled_orbit():
    ordered = drawn_in_order(Stage(hachure.vtkPatternStyle.ANCHORED))
    assert all((a != b).any() for a, b in zip(ordered, ordered[1:]))
    assert different_frames(ordered) == 0


def test_tracked_orbit_depends_on_the_order():
    """The same comparison sees the difference where there is one."""
    ordered = drawn_in_order(Stage(hachure.vtkPatternStyle.TRACKED))
    assert different_frames(ordered, mode=hachure.vtkPatternStyle.TRACKED) > FRAMES // 2


def test_shuffled_orbit_along_a_path():
    ordered = drawn_in_order(with_path(Stage(hachure.vtkPatternStyle.ANCHORED)))
    assert different_frames(ordered, with_path) == 0
    closed = drawn_in_order(Stage(hachure.vtkPatternStyle.ANCHORED))
    assert sum((a != b).any() for a, b in zip(ordered, closed)) > FRAMES // 2, "the path has no effect"


def test_keys_anchor_anew():
    """At a key time the replay is at its start: the picture without any path before it."""
    late = with_path(Stage(hachure.vtkPatternStyle.ANCHORED), (7.0,)).frame(7)
    both = with_path(Stage(hachure.vtkPatternStyle.ANCHORED), (0.0, 7.0)).frame(7)
    early = with_path(Stage(hachure.vtkPatternStyle.ANCHORED), (0.0,)).frame(7)
    assert (late == both).all() and (late != early).any()


def test_other_pictures_leave_no_trace():
    stage = Stage(hachure.vtkPatternStyle.ANCHORED)
    first = stage.frame(3)
    stage.style.SetTrackingMode(stage.style.TRACKED)
    for i in range(8):
        stage.frame(i)
    stage.style.SetTrackingMode(stage.style.ANCHORED)
    stage.window.SetSize(120, 200)
    stage.window.Render()
    stage.window.SetSize(160, 160)
    assert (stage.frame(3) == first).all()


def test_replay_follows_the_surface():
    """Along the path the pattern moves on continuously, as the tracked one does."""
    stage = with_path(Stage(hachure.vtkPatternStyle.ANCHORED), (0.0,), 0.125)
    tracked = Stage(hachure.vtkPatternStyle.TRACKED)
    tracked.style.SetTrackingMode(tracked.style.TRACKED)
    for i in range(5):
        stage.frame(i)
    for i in range(0, 33):
        set_camera(tracked.renderer.GetActiveCamera(), i / 8.0)
        tracked.window.Render()
    for ours, other in zip(stage.mappers, tracked.mappers):
        a = scene.drawn_frame(ours, stage.renderer)
        b = scene.drawn_frame(other, tracked.renderer)
        # Replay does not see what hides what; both turn with the surface.
        assert abs(scene.frame_scale(a) / scene.frame_scale(b) - 1.0) < 0.25, (a, b)


scene.run(globals())
