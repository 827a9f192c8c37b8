# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Any image serves as a pattern: its ink equals the tone, and coarse images come with a note."""

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData


def image_of(grey):
    height, width = grey.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    scalars = numpy_to_vtk(numpy.ascontiguousarray(grey).ravel(), deep=1)
    image.GetPointData().SetScalars(scalars)
    return image


def style_of(image, tone=0.5):
    style = scene.constant_style(hachure.vtkImagePatternLayer.IMAGE, 64, tone, 0.0, 0.0)
    style.GetLayer(0).SetImage(image)
    return style


def ink_of(style):
    actor = scene.actor_of(scene.plane(), style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=(256, 256))
    scene.look(renderer)
    return 1.0 - scene.linear(scene.draw(window)).mean()


def paper_fibres():
    """A paper-like image: smooth noise that repeats, far from uniformly distributed."""
    random = numpy.random.default_rng(3)
    spectrum = numpy.fft.fft2(random.standard_normal((128, 128)))
    frequency = numpy.hypot(*numpy.meshgrid(numpy.fft.fftfreq(128), numpy.fft.fftfreq(128)))
    grey = numpy.fft.ifft2(spectrum * numpy.exp(-(frequency / 0.06) ** 2)).real
    return numpy.exp(grey / grey.std()).astype(numpy.float32)


def test_ink_equals_tone():
    for tone in (0.0, 0.1, 0.35, 0.5, 0.8, 1.0):
        ink = ink_of(style_of(image_of(paper_fibres()), tone))
        assert abs(ink - tone) <= (0.0 if tone in (0.0, 1.0) else 0.02), (tone, ink)


def test_automatic_transition_is_a_cross_fade():
    # Half black, half white: cross-fading with the copy of half the size adds greys in between.
    layer = hachure.vtkImagePatternLayer
    grey = numpy.linspace(0.0, 1.0, 64)[:, None] * numpy.ones(64)
    shown = []
    for transition in (layer.AUTOMATIC_TRANSITION, layer.CROSS_FADE, layer.BLEND_SCREENS):
        style = style_of(image_of(grey))
        style.GetLayer(0).SetTransition(transition)
        actor = scene.actor_of(scene.plane(), style)
        renderer = scene.renderer_of(actor)
        window = scene.window_of(renderer, size=(128, 128))
        camera = scene.look(renderer)
        camera.ParallelProjectionOn()
        camera.SetParallelScale(1.0)
        window.Render()
        camera.SetParallelScale(1.0 / 1.5)
        shown.append(scene.draw(window))
    assert (shown[0] == shown[1]).all()
    assert (shown[0] != shown[2]).any()


def test_few_levels_are_noted_once():
    levels = numpy.floor(4.0 * numpy.arange(64) / 64.0)[:, None] * numpy.ones(64)
    ink = ink_of(style_of(image_of(levels.astype(numpy.uint8))))
    scene.expect_messages("layer 0: the pattern image has only 4 grey levels")
    assert abs(ink - 0.5) < 0.02, ink


def test_missing_image():
    ink_of(style_of(None))
    scene.expect_messages("layer 0: image: expected an image for the pattern IMAGE, found none")


def test_bad_values():
    grey = paper_fibres()
    grey[5, 7] = numpy.nan
    ink_of(style_of(image_of(grey)))
    scene.expect_messages("layer 0: ")


scene.run(globals())
