# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The mean ink of a picture is the tone that was asked for, for every screen and size."""

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.vtkCommonDataModel import vtkImageData

TONES = numpy.linspace(0.05, 0.95, 7)
SIZES = (6, 8, 12)
TOLERANCE = 0.01
# The picture shows few periods, and where they lie against its border is chance: it is averaged
# over directions.
ANGLES = (45.0, 20.0, 80.0)


def patterns():
    for name in ("hatch", "cross-hatch", "halftone"):
        layer = hachure.style(name).GetLayer(0)
        for irregularity in sorted({0.0, layer.GetIrregularity(), 0.35}):
            yield name, layer.GetPattern(), irregularity


def check_ink(actor, mask=None, draw=None):
    worst = (0.0, "")
    for name, pattern, irregularity in patterns():
        for size in SIZES:
            style = scene.constant_style(pattern, size, 0.0, irregularity)
            layer = style.GetLayer(0)
            actor.GetMapper().SetStyle(style)
            for tone in (0.0, 1.0):
                layer.GetTone().SetConstant(tone)
                pixels = draw() if mask is None else draw()[mask]
                assert (pixels == (0 if tone else 255)).all(), (name, size, tone)
            for tone in TONES:
                layer.GetTone().SetConstant(tone)
                inks = []
                for angle in ANGLES:
                    layer.SetAngle(angle)
                    inks.append(scene.ink(draw(), mask))
                error = numpy.mean(inks) - tone
                case = "%s %g, %d px, tone %g: ink %s" % (name, irregularity, size, tone, inks)
                worst = max(worst, (abs(error), case))
    print("largest error", worst)
    assert worst[0] < TOLERANCE, worst


def test_plane():
    actor = scene.actor_of(scene.plane(), scene.constant_style(0, 8, 0.5))
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor, background=(1.0, 0.0, 0.0))
    window = scene.window_of(renderer)
    scene.look(renderer)
    check_ink(actor, None, lambda: scene.draw(window))


def test_sphere():
    actor = scene.actor_of(scene.sphere(), scene.constant_style(0, 8, 1.0))
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer)
    scene.look(renderer, (0.0, 0.0, 2.2))
    mask = (scene.draw(window) == 0).all(axis=2)
    assert 0.3 < mask.mean() < 0.9, mask.mean()
    check_ink(actor, mask, lambda: scene.draw(window))


def test_growing_pattern():
    """The tone holds while the pattern grows with the surface and its copy of half the size comes in."""
    actor = scene.actor_of(scene.plane(), scene.constant_style(0, 8, 0.5))
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor, background=(1.0, 0.0, 0.0))
    window = scene.window_of(renderer)
    for name, pattern, irregularity in patterns():
        style = scene.constant_style(pattern, 8, 0.0, irregularity)
        actor.GetMapper().SetStyle(style)
        actor.GetMapper().Reanchor(renderer)
        for scale in (1.0, 1.15, 1.3, 1.4, 1.5, 1.6, 1.7, 1.9, 2.1):
            scene.look(renderer, (0.0, 0.0, 3.0 / scale))
            window.Render()
            frame = scene.drawn_frame(actor.GetMapper(), renderer)
            assert abs(scene.frame_scale(frame) - scale) < 1e-3, (scale, frame)
            for tone in (0.2, 0.5, 0.8):
                style.GetLayer(0).GetTone().SetConstant(tone)
                inks = []
                for angle in ANGLES:
                    style.GetLayer(0).SetAngle(angle)
                    inks.append(scene.ink(scene.draw(window)))
                error = abs(numpy.mean(inks) - tone)
                assert error < TOLERANCE, (name, irregularity, scale, tone, inks)


def clouds(size=128):
    """A user's image: smooth and dark, far from equally distributed, without a seam."""
    waves = numpy.random.default_rng(5).normal(size=(12, 4))
    x, y = numpy.meshgrid(*(numpy.arange(size) * 2.0 * numpy.pi / size,) * 2)
    height = sum(numpy.sin(round(2 * a) * x + round(2 * b) * y + c) for a, b, c, _ in waves)
    image = vtkImageData()
    image.SetDimensions(size, size, 1)
    grey = 255.0 * ((height - height.min()) / numpy.ptp(height)) ** 3
    values = scene.add_array(image.GetPointData(), "grey", grey.ravel())
    image.GetPointData().SetScalars(values)
    return image


def test_image_of_a_user():
    style = scene.constant_style(hachure.vtkImagePatternLayer.IMAGE, 128, 0.5, 0.0, 0.0)
    style.GetLayer(0).SetImage(clouds())
    actor = scene.actor_of(scene.plane(), style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor, background=(1.0, 0.0, 0.0))
    window = scene.window_of(renderer)
    scene.look(renderer)
    for tone in (0.0, *TONES, 1.0):
        style.GetLayer(0).GetTone().SetConstant(tone)
        found = scene.ink(scene.draw(window))
        assert abs(found - tone) < (TOLERANCE if 0.0 < tone < 1.0 else 1e-12), (tone, found)


scene.run(globals())
