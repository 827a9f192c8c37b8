# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A large screenshot is the picture of the window with more pixels, and shows no tiles."""

import hachure
import pattern_scene as scene
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

SIZE = 200
SCALE = 3
# Mean difference of linear values, in levels of 255.
BOUND = 2.5


class Stage:
    def __init__(self, name, size, opacity=1.0, pixel_scale=1.0):
        style = hachure.style(name)
        style.GetLayer(0).SetSize(8.0)
        style.SetPixelScale(pixel_scale)
        self.actor = scene.actor_of(scene.sphere(), style)
        self.actor.GetProperty().SetOpacity(opacity)
        self.renderer = scene.renderer_of(self.actor)
        self.window = scene.window_of(self.renderer, size=(size, size))
        # Off the axis, so that no tile looks like another.
        scene.look(self.renderer, (0.4, 0.3, 2.0), (0.05, -0.1, 0.0))
        self.window.Render()
        # After a step: neither anchored nor upright.
        camera = self.renderer.GetActiveCamera()
        camera.Azimuth(12.0)
        camera.Roll(5.0)
        self.renderer.ResetCameraClippingRange()
        self.window.Render()


def screenshot(window, scale=SCALE):
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.SetScale(scale)
    grabber.ReadFrontBufferOff()
    grabber.Update()
    image = grabber.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)


def reduced(pixels, scale=SCALE):
    """Linear values, averaged over boxes."""
    height, width, channels = pixels.shape
    boxes = scene.linear(pixels).reshape(height // scale, scale, width // scale, scale, channels)
    return boxes.mean(axis=(1, 3))


STYLES = ("hatch", "cross-hatch", "halftone")


def check_agreement(name, opacity, bound):
    stage = Stage(name, SIZE, opacity)
    stage.actor.GetMapper().GetStyle().OutlineOff()
    small = scene.draw(stage.window)
    large = screenshot(stage.window)
    covered = (small < 250).any(axis=2).mean()
    assert covered > 0.1, covered
    mean = 255.0 * abs(reduced(large) - scene.linear(small)).mean()
    print(name, opacity, "mean difference", mean, "of", bound, "levels")
    assert mean < bound, (name, opacity, mean)
    assert (scene.draw(stage.window) == small).all(), "the screenshot left a trace"


def test_hatch_screenshot():
    check_agreement("hatch", 1.0, BOUND)


def test_cross_hatch_screenshot():
    check_agreement("cross-hatch", 1.0, BOUND)


def test_halftone_screenshot():
    check_agreement("halftone", 1.0, BOUND)


def test_translucent_screenshot():
    """VTK blends translucent surfaces by display values, so that averages differ more."""
    for name in STYLES:
        check_agreement(name, 0.5, 2.0 * BOUND)


# A picture full of ruled pattern. Where the second direction of a cross-hatch sets in, its lines are
# thinner than a pixel, and the threshold that keeps the tone there moves the other edges, too.
PLANE_BOUNDS = {"hatch": BOUND, "cross-hatch": 2.0 * BOUND, "halftone": BOUND}


def test_ruled_patterns_on_a_plane():
    actor = scene.actor_of(scene.plane(), "hatch")
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    scene.look(renderer)
    for name, bound in PLANE_BOUNDS.items():
        pattern = hachure.style(name).GetLayer(0).GetPattern()
        for angle in (45.0, 20.0):
            means = []
            for tone in (0.1, 0.3, 0.5, 0.7, 0.9):
                actor.GetMapper().SetStyle(scene.constant_style(pattern, 8, tone, 0.0, angle))
                small = scene.draw(window)
                means.append(255.0 * abs(reduced(screenshot(window)) - scene.linear(small)).mean())
            mean = sum(means) / len(means)
            print("ruled", name, angle, "differs by", mean, "on the mean of tones", means)
            assert mean < bound, (name, angle, means)


def check_seams(stage, whole, name):
    """The screenshot in tiles is the picture of a window of that size at as many pixels a unit."""
    large = screenshot(stage.window)
    expected = scene.draw(whole.window)
    difference = 255.0 * abs(scene.linear(large) - scene.linear(expected)).max(axis=2)
    print(name, "tiles differ by", difference.mean(), "levels")
    # Seams would show in the rows and columns beside them.
    for border in (SIZE, 2 * SIZE):
        near = slice(border - 2, border + 2)
        for band in (difference[near], difference[:, near]):
            assert band.mean() < 1.0, (name, border, band.mean())
    assert difference.mean() < 0.3, (name, difference.mean())


def anchored_pair(name, outline):
    stages = [Stage(name, SIZE), Stage(name, SCALE * SIZE, 1.0, SCALE)]
    for stage in stages:
        style = stage.actor.GetMapper().GetStyle()
        style.SetTrackingMode(style.ANCHORED)
        style.SetOutline(outline)
    return stages


def test_tiles_are_seamless():
    for name in STYLES:
        check_seams(*anchored_pair(name, False), name)


def test_outlines_are_seamless():
    check_seams(*anchored_pair("hatch", True), "outlined hatch")


def test_other_scales():
    stage = Stage("hatch", SIZE)
    stage.actor.GetMapper().GetStyle().OutlineOff()
    small = scene.draw(stage.window)
    two = screenshot(stage.window, 2)
    mean = 255.0 * abs(reduced(two, 2) - scene.linear(small)).mean()
    assert mean < BOUND, mean
    assert (screenshot(stage.window, 1) == small).all()


def test_pixel_scale_is_resolution():
    """A window with three pixels for one shows the same picture, finer."""
    for name in STYLES:
        # Tracked patterns lie a little apart: what is visible is measured in either resolution.
        frames = [scene.drawn_frame(stage.actor.GetMapper(), stage.renderer)
                  for stage in (Stage(name, SIZE), Stage(name, SCALE * SIZE, 1.0, SCALE))]
        assert abs(frames[0] - frames[1]).max() < 0.1, frames
        small, large = anchored_pair(name, False)
        for stage in (small, large):
            layer = stage.actor.GetMapper().GetStyle().GetLayer(0)
            layer.SetMotion(layer.FIXED_IN_IMAGE)
        pictures = reduced(scene.draw(large.window)), scene.linear(scene.draw(small.window))
        mean = 255.0 * abs(pictures[0] - pictures[1]).mean()
        assert mean < BOUND, (name, mean)


scene.run(globals())
