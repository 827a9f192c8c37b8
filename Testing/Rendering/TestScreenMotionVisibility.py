# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A point is visible where it is seen in both states: behind a sphere, beyond the picture."""

import hachure
import motion_scene as motion
import numpy
import pattern_scene as scene
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData

SQUARE = scene.plane(2.0).GetOutput()


def occlusion(occluder_is_surface):
    """A plane behind a sphere, and a camera that passes by: seen, and at the edges of it."""
    centre, radius = numpy.array((0.1, 0.0, 1.0)), 0.3
    ball = scene.sphere(256, radius, centre).GetOutput()
    before = motion.camera_at()
    after = motion.moved(before, "translate")
    first = [(SQUARE,), (ball,)] if occluder_is_surface else [(SQUARE,)]
    found = motion.compute(before, after, first, [] if occluder_is_surface else [(ball,)])
    view, next_view = motion.View(before), motion.View(after)
    points = motion.on_plane(view)

    def hidden(eye, size):
        along = points - eye
        closest = numpy.clip(((centre - eye) * along).sum(-1) / (along**2).sum(-1), 0, 1)
        return numpy.linalg.norm(eye + along * closest[..., None] - centre, axis=-1) < size

    pixel = 2 * view.half / motion.SIZE[1] * 2.3  # beside the sphere, generously
    inside = abs(points[..., :2]).max(-1) < 0.95
    goal = next_view.project(points)
    inside &= (goal > 1).all(-1) & (goal < numpy.array(motion.SIZE) - 1).all(-1)
    plane = inside & ~hidden(view.eye, radius + pixel)
    seen = plane & ~hidden(next_view.eye, radius + pixel)
    lost = plane & hidden(next_view.eye, radius - pixel)
    return found, plane, seen, lost, inside & hidden(view.eye, radius - pixel)


def test_visibility_behind_a_sphere():
    for occluder_is_surface in (True, False):
        found, plane, seen, lost, ball = occlusion(occluder_is_surface)
        assert (found[5][plane] == 1).all()
        assert (found[2][seen] == 1).all(), "seen pixels marked as hidden"
        assert lost.sum() > 1000 and (found[2][lost] == 0).all(), "hidden pixels marked as seen"
        assert ball.sum() > 1000 and (found[5][ball] == (2 if occluder_is_surface else 0)).all()
        if not occluder_is_surface:
            assert (found[:, ball] == 0).all()


def test_leaving_the_picture_is_not_visible():
    before = motion.camera_at((0, 0, 3))
    after = motion.camera_at((0.9, 0, 3), (0.9, 0, 0))
    found = motion.compute(before, after, [(SQUARE,)])
    goal = numpy.arange(motion.SIZE[0]) + 0.5 + found[0]
    surface = found[5] == 1
    outside = surface & (goal < 0)
    assert outside.sum() > 1000
    assert (found[2] == (surface & ~outside)).all()
    behind = motion.camera_at((0, 0, -1), (0, 0, -3))
    found = motion.compute(before, behind, [(SQUARE,)])
    assert (found[:3] == 0).all() and (found[5] == 1).any()


def test_no_motion_and_blocks():
    """Equal states: 0 everywhere, all visible; blocks are one surface; nothing is nothing."""
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, scene.sphere(32, 0.4, (-0.5, 0, 0)).GetOutput())
    blocks.SetBlock(2, scene.sphere(32, 0.4, (0.5, 0, 0)).GetOutput())
    camera = motion.camera_at()
    found = motion.compute(camera, camera, [blocks])
    surface = found[5] == 1
    assert surface[:, :320].any() and surface[:, 320:].any()
    assert abs(found[:2]).max() < 1e-6 and (found[2] == surface).all()
    assert (motion.compute(camera, camera, [(vtkPolyData(),)]) == 0).all()
    assert (motion.compute(camera, camera, []) == 0).all()


def test_the_picture_of_the_window_stays():
    """Motion is computed between two frames of the same window, which show the same."""
    actor = scene.actor_of(SQUARE, scene.constant_style(0, 8, 0.5))
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=(200, 150))
    camera = scene.look(renderer)
    first = scene.draw(window)
    cameras = camera, motion.moved(camera, "roll")
    image = hachure.screen_motion(window, (320, 240), cameras, [SQUARE])
    assert image.GetPointData().GetScalars().GetRange(hachure.vtkPatternMotion.LABEL) == (0.0, 1.0)
    assert (scene.picture(window) == first).all(), "the picture was overwritten"
    assert (scene.draw(window) == first).all(), "the next picture is another"


scene.run(globals())
