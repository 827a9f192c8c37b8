# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Classic stipples: their ink is the tone, and they grow from frame to frame in every view."""

import hachure
import numpy
import pattern_scene as scene
from stipple_scene import stage, stipple_style
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

TONES = (0.05, 0.2, 0.5, 0.75, 0.9)
TOLERANCE = 0.025
FRAMES = 8


def classic_style(tone=0.5, **parameters):
    return stipple_style(tone, **{"Order": 1, "NumberOfPoints": 40000, **parameters})


def set_tone(actor, tone):
    actor.GetMapper().GetStyle().GetLayer(0).GetTone().SetConstant(tone)


def settled(window, frames=FRAMES):
    """The picture after so many frames."""
    for _ in range(frames - 1):
        window.Render()
    return scene.draw(window)


def check_ink(data, position, tolerance, **parameters):
    actor, renderer, window = stage(data, stipple_style(1.0), position)
    mask = (scene.draw(window) == 0).all(axis=2)
    assert 0.3 < mask.mean(), mask.mean()
    style = classic_style(0.0, **parameters)
    actor.GetMapper().SetStyle(style)
    assert (scene.draw(window)[mask] == 255).all(), "tone 0 is bare paper"
    worst = (0.0, "")
    for tone in TONES:
        set_tone(actor, tone)
        found = scene.ink(settled(window), mask)
        worst = max(worst, (abs(found - tone), (tone, found)))
    print("largest error", worst, parameters)
    assert worst[0] < tolerance, (worst, parameters)


def test_ink_equals_tone_on_a_plane():
    for parameters in ({}, {"GrowthFrames": 0}, {"Size": 6.0}, {"GrowthFrames": 0, "Growth": 1.0}):
        check_ink(scene.plane(3.0), (0.0, 0.0, 3.0), 0.02, **parameters)


def test_ink_equals_tone_on_a_sphere():
    for frames in (0, FRAMES):
        check_ink(scene.sphere(), (0.0, 0.0, 2.2), TOLERANCE, GrowthFrames=frames)


def test_ink_equals_tone_where_stipples_run_out():
    check_ink(scene.sphere(16), (0.0, 0.0, 2.2), 0.03, NumberOfPoints=2000)


def test_the_size_carries_the_tone():
    check_ink(scene.plane(3.0), (0.0, 0.0, 3.0), 0.03, Carrier=1, Size=6.0)


def test_stipples_grow_and_shrink():
    """In GrowthFrames frames, all the way; then the picture is still."""
    actor, _, window = stage(scene.plane(3.0), classic_style(0.2))
    light = scene.draw(window)
    assert (scene.draw(window) == light).all(), "the first picture has grown"
    for tone, sign in ((0.5, 1.0), (0.2, -1.0)):
        set_tone(actor, tone)
        pictures = [scene.draw(window) for _ in range(FRAMES + 2)]
        inks = [scene.ink(pixels) for pixels in pictures]
        assert (sign * numpy.diff(inks[:FRAMES]) > 0.0).all(), inks
        assert abs(inks[0] - (0.7 - tone)) < 0.1, inks
        assert abs(inks[FRAMES - 1] - tone) < TOLERANCE, inks
        assert (pictures[FRAMES - 1] == pictures[FRAMES]).all()
        assert (pictures[FRAMES] == pictures[FRAMES + 1]).all()
        _, _, fresh = stage(scene.plane(3.0), classic_style(tone))
        assert (scene.draw(fresh) == pictures[FRAMES]).all(), "it ends where a first picture is"


def test_number_of_frames():
    for frames in (1, 3):
        actor, _, window = stage(scene.plane(3.0), classic_style(0.2, GrowthFrames=frames))
        window.Render()
        set_tone(actor, 0.5)
        pictures = [scene.draw(window) for _ in range(frames + 1)]
        assert (pictures[frames - 1] == pictures[frames]).all()
        assert frames == 1 or (pictures[frames - 2] != pictures[frames]).any()


def test_frames_do_not_depend_on_each_other():
    """With GrowthFrames 0, and in anchored styles."""
    def frames(order, anchored):
        style = classic_style(GrowthFrames=FRAMES if anchored else 0)
        style.SetTrackingMode(style.ANCHORED if anchored else style.TRACKED)
        actor, renderer, window = stage(scene.sphere(), style)
        pictures = {}
        for angle in order:
            scene.look(renderer, (3 * numpy.sin(angle), 0.0, 3 * numpy.cos(angle)))
            pictures[angle] = scene.draw(window)
        return pictures
    angles = [0.1 * i for i in range(4)]
    for anchored in (False, True):
        forwards, backwards = frames(angles, anchored), frames(angles[::-1], anchored)
        assert all((forwards[angle] == backwards[angle]).all() for angle in angles)
        assert (forwards[0.0] != forwards[0.1]).any()


def test_views_do_not_share_growth():
    style = classic_style(0.2)
    actor, _, first = stage(scene.plane(3.0), style)
    other = scene.renderer_of(actor)
    second = scene.window_of(other)
    scene.look(other)
    first.Render()
    second.Render()
    set_tone(actor, 0.5)
    end = settled(first)
    begun = scene.draw(second)
    assert scene.ink(begun) < scene.ink(end) - 0.1
    assert (settled(second, FRAMES - 1) == end).all()


def test_tiles_and_second_eyes_do_not_count():
    def tiles(window):
        grabber = vtkWindowToImageFilter()
        grabber.SetInput(window)
        grabber.SetScale(2)
        grabber.ReadFrontBufferOff()
        grabber.Update()

    def nothing(window):
        pass
    pictures = []
    for disturb in (nothing, tiles):
        actor, _, window = stage(scene.plane(3.0), classic_style(0.2))
        window.Render()
        set_tone(actor, 0.5)
        for _ in range(3):
            window.Render()
            disturb(window)
        pictures.append(scene.draw(window))
    assert (pictures[0] == pictures[1]).all()
    actor, renderer, window = stage(scene.plane(3.0), classic_style(0.2))
    renderer.GetActiveCamera().SetEyeAngle(0.0)
    window.Render()
    window.SetStereoTypeToRedBlue()
    window.StereoRenderOn()
    set_tone(actor, 0.5)
    for _ in range(3):
        window.Render()
    window.StereoRenderOff()
    assert (scene.draw(window) == pictures[0]).all()


def test_what_comes_into_view_has_grown():
    actor, renderer, window = stage(scene.plane(1.5), classic_style(0.4))
    window.Render()
    for position in ((2.0, 0.0, 0.0), (0.0, 0.0, 0.0)):
        scene.look(renderer, (position[0], 0.0, 3.0), position)
        pixels = scene.draw(window)
    assert abs(scene.ink(pixels[80:176, 80:176]) - 0.4) < TOLERANCE


def test_other_cells_start_anew():
    actor, _, window = stage(scene.sphere(24), classic_style())
    window.Render()
    other = scene.sphere(30)
    actor.GetMapper().SetInputConnection(other.GetOutputPort())
    after = scene.draw(window)
    _, _, fresh = stage(other, classic_style())
    assert (after == scene.draw(fresh)).all()


def test_points_that_move_carry_the_stipples():
    """And stipples go on growing on them."""
    data = scene.sphere().GetOutput()
    actor, _, window = stage(data, classic_style(0.2))
    window.Render()
    set_tone(actor, 0.5)
    first = scene.ink(scene.draw(window))
    actor.SetPosition(0.2, 0.1, 0.0)
    by_actor = settled(window)
    actor.SetPosition(0.0, 0.0, 0.0)
    points = vtk_to_numpy(data.GetPoints().GetData())
    points += numpy.array([0.2, 0.1, 0.0], dtype=points.dtype)
    data.GetPoints().Modified()
    by_points = settled(window)
    assert scene.ink(by_points) > first + 0.02
    difference = numpy.abs(by_actor.astype(int) - by_points)
    assert difference.mean() < 1.0, difference.mean()


def test_translucent_surfaces():
    """Peels of one frame count once."""
    actor, renderer, window = stage(scene.plane(3.0), classic_style(0.2))
    window.SetAlphaBitPlanes(1)
    renderer.SetUseDepthPeeling(True)
    actor.GetProperty().SetOpacity(0.999)
    window.Render()
    set_tone(actor, 0.5)
    inks = [scene.ink(scene.draw(window)) for _ in range(FRAMES + 1)]
    assert (numpy.diff(inks[:FRAMES]) > 0.0).all(), inks
    assert abs(inks[-1] - 0.5) < 0.03 and inks[-1] == inks[-2], inks


def test_range_of_frames():
    layer = hachure.vtkStippleLayer()
    assert layer.GetGrowthFrames() == 8
    for wanted, expected in ((-1, 0), (1001, 1000), (12, 12)):
        layer.SetGrowthFrames(wanted)
        assert layer.GetGrowthFrames() == expected


if __name__ == "__main__":
    scene.run(globals())
