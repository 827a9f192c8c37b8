# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Locked patterns keep their direction or size in the picture, and still follow the surface."""

import math

import numpy
import pattern_scene as scene

SIZE = 160
ROLL = 6.0
ZOOM = 1.04
STEPS = 5
CENTRE = (0.2, 0.1, 0.0)


def angle(frame):
    return math.degrees(math.atan2(frame[3], frame[2]))


def centre_in(renderer):
    renderer.SetWorldPoint(*CENTRE, 1.0)
    renderer.WorldToDisplay()
    return numpy.array(renderer.GetDisplayPoint()[:2])


def rolled_and_zoomed(rotation, scale, mode="TRACKED"):
    """The first and the last frame of the pattern, the last picture, and the way of the sphere."""
    style = scene.constant_style(0, 10, 0.5)
    style.SetLockRotation(rotation)
    style.SetLockScale(scale)
    style.SetTrackingMode(getattr(style, mode))
    actor = scene.actor_of(scene.sphere(24, 0.4, CENTRE), style)
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    camera = scene.look(renderer)
    window.Render()
    start = centre_in(renderer)
    first = scene.drawn_frame(actor.GetMapper(), renderer)
    for _ in range(STEPS):
        camera.Roll(ROLL)
        camera.Dolly(ZOOM)
        renderer.ResetCameraClippingRange()
        picture = scene.draw(window)
    last = scene.drawn_frame(actor.GetMapper(), renderer)
    return first, last, picture, centre_in(renderer) - start


def test_locks():
    free, moved, free_picture, surface = rolled_and_zoomed(False, False)
    assert numpy.hypot(*surface) > 5.0, surface
    turn = angle(moved) - angle(free)
    growth = scene.frame_scale(moved) / scene.frame_scale(free)
    assert abs(abs(turn) - STEPS * ROLL) < 0.5, turn
    assert growth > 1.15, growth
    for rotation, scale in ((True, False), (False, True), (True, True)):
        first, last, picture, _ = rolled_and_zoomed(rotation, scale)
        kept_turn = angle(last) - angle(first)
        kept_growth = scene.frame_scale(last) / scene.frame_scale(first)
        assert abs(kept_turn - (0.0 if rotation else turn)) < 1e-9, (rotation, scale, kept_turn)
        assert abs(kept_growth - (1.0 if scale else growth)) < 1e-9, (rotation, scale, kept_growth)
        # The frame's axes stay perpendicular and equal.
        assert abs(complex(*last[4:]) - 1j * complex(*last[2:4])) < 1e-9
        assert (picture != free_picture).any()
    # Neither turned nor scaled, every point of the pattern goes where the middle of the surface goes.
    assert abs((last - first)[:2] - surface).max() < 1.0, (last - first, surface)


def test_locks_of_anchored_patterns():
    _, free, *_ = rolled_and_zoomed(False, False, "ANCHORED")
    assert abs(angle(free)) > 5.0 and abs(scene.frame_scale(free) - 1.0) > 0.05, free
    for rotation, scale in ((True, False), (False, True)):
        _, last, *_ = rolled_and_zoomed(rotation, scale, "ANCHORED")
        assert abs(angle(last) - (0.0 if rotation else angle(free))) < 1e-9, last
        expected = 1.0 if scale else scene.frame_scale(free)
        assert abs(scene.frame_scale(last) - expected) < 1e-9, last


scene.run(globals())
