# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A surface with other triangles in every frame is followed by its velocity."""

import numpy
import pattern_scene as scene
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData

SIZE = 200
VELOCITY = numpy.array([0.3, -0.12, 0.0])  # model units per second
STEP = 0.1  # seconds
FRAMES = 8
PIXELS = SIZE / 2.0  # per model unit: the parallel projection shows 2 units
NAME = "speed"


def sphere_at(time, frame, velocity=VELOCITY, clock=False):
    """A sphere that has moved since time 0, in triangles of its own."""
    data = vtkPolyData()
    data.DeepCopy(scene.sphere(20 + 3 * frame, 0.4, tuple(time * VELOCITY)).GetOutput())
    if velocity is not None:
        values = numpy.tile(velocity, (data.GetNumberOfPoints(), 1)).astype(float)
        scene.add_array(data.GetPointData(), NAME, values)
    if clock:
        data.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
    return data


def followed(name=NAME, pan=0.0, clock=False, same_triangles=False, step=STEP):
    """How the origin of the pattern moved in every frame, in pixels."""
    actor = scene.actor_of(sphere_at(0.0, 0, clock=clock), scene.constant_style(0, 10, 0.5))
    mapper = actor.GetMapper()
    mapper.SetVelocityArrayName(name)
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    camera = scene.look(renderer)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(1.0)
    window.Render()
    origins = [scene.drawn_frame(mapper, renderer)]
    for frame in range(1, FRAMES + 1):
        time = frame * step
        data = sphere_at(time, 0 if same_triangles else frame, clock=clock)
        mapper.SetInputDataObject(data)
        if not clock:
            mapper.SetAnimationTime(time)
        camera.SetPosition(pan * frame, 0.0, 3.0)
        camera.SetFocalPoint(pan * frame, 0.0, 0.0)
        window.Render()
        origins.append(scene.drawn_frame(mapper, renderer))
    frames = numpy.array(origins)
    assert abs(frames[:, 2:] - frames[0, 2:]).max() < 1e-3, "the pattern turned or grew"
    return numpy.diff(frames[:, :2], axis=0)


def error_of(moved, expected):
    return float(numpy.hypot(*(moved - expected).T).max())


def test_pattern_follows_the_velocity():
    expected = PIXELS * STEP * VELOCITY[:2]
    assert numpy.hypot(*expected) > 3.0
    for clock in (False, True):
        error = error_of(followed(clock=clock), expected)
        print("follows", "the data's time" if clock else "animation time", "within", error, "px")
        assert error < 0.05, (clock, error)
    # Backwards too.
    assert error_of(followed(step=-STEP), -expected) < 0.05


def test_camera_and_velocity_add_up():
    pan = 0.02
    expected = PIXELS * (STEP * VELOCITY[:2] - [pan, 0.0])
    assert error_of(followed(pan=pan), expected) < 0.05


def test_without_the_array_it_stays_with_the_camera():
    assert abs(followed(name="")).max() < 1e-9
    assert error_of(followed(name="", pan=0.02), [-0.02 * PIXELS, 0.0]) < 0.05


def test_points_that_move_need_no_velocity():
    expected = PIXELS * STEP * VELOCITY[:2]
    for name in ("", NAME):
        assert error_of(followed(name=name, same_triangles=True), expected) < 0.05, name


def test_wrong_arrays():
    for values, message in ((None, "velocity: no array 'speed', expected 3 components"),
                            (VELOCITY[:2], "velocity: array 'speed' has 2 components, expected 3")):
        actor = scene.actor_of(sphere_at(0.0, 0, values), scene.constant_style(0, 10, 0.5))
        actor.GetMapper().SetVelocityArrayName(NAME)
        window = scene.window_of(scene.renderer_of(actor), size=(64, 64))
        window.Render()
        window.Render()
        scene.expect_messages(message)
        assert scene.ink(scene.picture(window)) > 0.05, "the surface is drawn all the same"


scene.run(globals())
