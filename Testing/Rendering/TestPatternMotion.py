# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Patterns move with the surface, and come back where they were when the camera does."""

import math

import numpy
import pattern_scene as scene
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

SIZE = 256
TURN = 60.0
STEPS = 20
CYCLES = 10


def two_spheres():
    return scene.sphere(32, 0.5, (-0.35, 0.0, 0.4)), scene.sphere(32, 0.4, (0.35, 0.1, -0.4))


def turned_camera(camera, part):
    """From head-on (0) to a turn about the vertical axis together with a pan (1)."""
    angle = math.radians(TURN * part)
    pan = 0.5 * part
    camera.SetPosition(4.0 * math.sin(angle) + pan, 0.2 * part, 4.0 * math.cos(angle))
    camera.SetFocalPoint(pan, 0.2 * part, 0.0)
    camera.SetViewUp(0.0, 1.0, 0.0)


def there_and_back(actors, scheme):
    """Largest change of scale and origin (pixels) after the cycles, and the visited frames."""
    renderer = scene.renderer_of(*actors)
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    camera = renderer.GetActiveCamera()
    mappers = [actor.GetMapper() for actor in actors]
    for mapper in mappers:
        mapper.GetStyle().SetWeightScheme(scheme)

    def visit(part):
        turned_camera(camera, part)
        renderer.ResetCameraClippingRange()
        window.Render()

    def committed():
        window.Render()  # reads what the last picture showed
        return [scene.committed_frame(mapper, renderer) for mapper in mappers]

    visit(0.0)
    start = committed()
    for cycle in range(CYCLES):
        for step in list(range(1, STEPS + 1)) + list(range(STEPS - 1, -1, -1)):
            visit(step / STEPS)
            if cycle == 0 and step == STEPS:
                turned = committed()
    end = committed()
    moved = min(numpy.hypot(*(b - a)[:2]) for a, b in zip(start, turned))
    assert moved > 5.0, "the patterns hardly moved: %g px" % moved
    scale = max(abs(scene.frame_scale(b) / scene.frame_scale(a) - 1) for a, b in zip(start, end))
    origin = max(float(numpy.hypot(*(b - a)[:2])) for a, b in zip(start, end))
    return scale, origin


def new_style():
    return scene.constant_style(0, 8, 0.5)


def scenes():
    spheres = two_spheres()
    yield "two actors", lambda: [scene.actor_of(data, new_style()) for data in spheres]
    append = vtkAppendPolyData()
    for data in spheres:
        append.AddInputConnection(data.GetOutputPort())
    yield "one mesh", lambda: [scene.actor_of(append, new_style())]
    blocks = vtkMultiBlockDataSet()
    for i, data in enumerate(spheres):
        blocks.SetBlock(i, data.GetOutput())
    yield "two blocks", lambda: [scene.actor_of(blocks, new_style())]


def test_there_and_back():
    style = new_style()
    for name, actors in scenes():
        scale, origin = there_and_back(actors(), style.SYMMETRIC)
        print(name, "symmetric", scale, origin)
        assert scale < 1e-6 and origin < 0.01, (name, scale, origin)
        scale, origin = there_and_back(actors(), style.CLASSIC)
        print(name, "classic", scale, origin)
        assert scale > 0.01 and origin > 1.0, (name, scale, origin)


def rolled(frame, degrees):
    """A frame turned about the centre of the picture."""
    z = complex(math.cos(math.radians(degrees)), math.sin(math.radians(degrees)))
    origin, u, v = (complex(*frame[i:i + 2]) for i in (0, 2, 4))
    centre = complex(SIZE / 2, SIZE / 2)
    moved = [z * (origin - centre) + centre, z * u, z * v]
    return numpy.array([part for c in moved for part in (c.real, c.imag)])


def test_roll_is_the_motion_of_the_surface():
    actor = scene.actor_of(scene.sphere(32, 0.5, (0.2, 0.1, 0.0)), new_style())
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    camera = scene.look(renderer)
    window.Render()
    start = scene.drawn_frame(actor.GetMapper(), renderer)
    surface = projected(numpy.array([[0.2, 0.1, 0.0]]), renderer)[0]
    step = 7.0
    for i in range(1, 53):
        camera.Roll(step)
        window.Render()
        drawn = scene.drawn_frame(actor.GetMapper(), renderer)
        expected = rolled(start, step * i)
        assert abs(drawn[:2] - expected[:2]).max() < 0.01, (i, drawn, expected)
        seen = projected(numpy.array([[0.2, 0.1, 0.0]]), renderer)[0]
        assert abs(seen - rolled([*surface, 0, 0, 0, 0], step * i)[:2]).max() < 1e-6
        # The farthest point of the pattern from its origin, in units of its axes.
        assert abs(drawn[2:] - expected[2:]).max() * SIZE < 0.01, (i, drawn, expected)


def slide(move):
    """Mean slide of the pattern over the surface as a part of the surface's own motion."""
    actor = scene.actor_of(scene.sphere(48), new_style())
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    camera = scene.look(renderer, (-0.2, 0.0, 3.0), (-0.2, 0.0, 0.0))
    window.Render()
    mapper = actor.GetMapper()
    samples = visible_points(actor)
    ratios = []
    for i in range(12):
        before = projected(samples, renderer)
        old = scene.drawn_frame(mapper, renderer)
        move(camera, i)
        renderer.ResetCameraClippingRange()
        window.Render()
        after = projected(samples, renderer)
        seen = facing(samples, camera)
        carried = follow(before, old, scene.drawn_frame(mapper, renderer))
        motion = numpy.hypot(*(after - before)[seen].T).mean()
        residual = numpy.hypot(*(after - carried)[seen].T).mean()
        assert motion > 0.5, motion
        ratios.append(residual / motion)
        own = mapper.GetResidual(renderer)
        assert 0.0 <= own < motion, (own, motion)
    return float(numpy.mean(ratios))


def visible_points(actor):
    data = actor.GetMapper().GetInput()
    return numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])


def facing(points, camera):
    """Points of a sphere about the origin that are seen at more than 17 degrees."""
    normals = points / numpy.linalg.norm(points, axis=1)[:, None]
    to_eye = numpy.array(camera.GetPosition()) - points
    to_eye /= numpy.linalg.norm(to_eye, axis=1)[:, None]
    return (normals * to_eye).sum(axis=1) > 0.3


def projected(points, renderer):
    matrix = renderer.GetActiveCamera().GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0)
    values = numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    clip = numpy.c_[points, numpy.ones(len(points))] @ values.T
    return (clip[:, :2] / clip[:, 3:] + 1.0) * SIZE / 2


def follow(points, old, new):
    """Where the pattern carries points of the picture."""
    z = complex(new[2], new[3]) / complex(old[2], old[3])
    moved = z * (points @ [1, 1j] - complex(*old[:2])) + complex(*new[:2])
    return numpy.c_[moved.real, moved.imag]


def test_pan_and_zoom_hardly_slide():
    def pan(camera, i):
        for get, put in ((camera.GetPosition, camera.SetPosition),
                         (camera.GetFocalPoint, camera.SetFocalPoint)):
            x, y, z = get()
            put(x + 0.03, y + 0.01, z)

    def zoom(camera, i):
        camera.Dolly(1.04)

    for name, move in (("pan", pan), ("zoom", zoom)):
        part = slide(move)
        print(name, "slides", part)
        assert part < 0.08, (name, part)


def test_fixed_in_the_image():
    style = new_style()
    actor = scene.actor_of(scene.plane(), style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    camera = scene.look(renderer)
    pictures = {}
    for motion in (style.GetLayer(0).FIXED_IN_IMAGE, style.GetLayer(0).SIMILARITY):
        style.GetLayer(0).SetMotion(motion)
        scene.look(renderer)
        pictures[motion] = [scene.draw(window)]
        for _ in range(3):
            camera.Dolly(1.05)
            camera.Roll(5.0)
            camera.SetFocalPoint(0.1, 0.0, 0.0)
            renderer.ResetCameraClippingRange()
            pictures[motion].append(scene.draw(window))
    still, moving = pictures[style.GetLayer(0).FIXED_IN_IMAGE], pictures[style.GetLayer(0).SIMILARITY]
    assert all((a == still[0]).all() for a in still)
    assert all((a != b).any() for a, b in zip(moving, moving[1:]))


scene.run(globals())
