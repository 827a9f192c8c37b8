# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A picture says how much ink a noise makes of a tone; a picture that cannot says why."""

import os
import sys

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

OUT = sys.argv[sys.argv.index("-T") + 1]
NOISE = hachure.vtkNoiseLayer


def image_of(ink):
    """ink[tone from below, value of the noise], as brightness from 0 to 1 or as bytes."""
    ink = numpy.asarray(ink)
    image = vtkImageData()
    image.SetDimensions(ink.shape[1], ink.shape[0], 1)
    bright = 255 - ink if ink.dtype == numpy.uint8 else 1 - ink
    image.GetPointData().SetScalars(numpy_to_vtk(numpy.ascontiguousarray(bright).ravel(), deep=1))
    return image


def style_of(image, tone=0.5, kind=NOISE.GABOR, size=9.0):
    style = hachure.vtkPatternStyle()
    layer = NOISE()
    layer.SetKind(kind)
    layer.SetSize(size)
    layer.SetThresholdImage(image)
    layer.GetTone().SetSource(hachure.vtkPatternTone.CONSTANT)
    layer.GetTone().SetConstant(tone)
    style.AddLayer(layer)
    return style


def ink_of(style):
    """Ink at every pixel of a flat surface that fills the picture."""
    actor = scene.actor_of(scene.plane(), style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor, background=(1.0, 0.0, 0.0))
    window = scene.window_of(renderer, size=(300, 300))
    scene.look(renderer)
    return 1.0 - scene.linear(scene.draw(window)).mean(axis=2)


def steps(rows=256, columns=256):
    """Ink below the tone: what a threshold does."""
    value = (numpy.arange(columns) + 0.5) / columns
    return (value[None, :] < numpy.linspace(0, 1, rows)[:, None]).astype(numpy.float32)


def test_steps_are_thresholds():
    for kind in (NOISE.GABOR, NOISE.PHASOR):
        for tone in (0.25, 0.5, 0.75):
            mine = ink_of(style_of(image_of(steps()), tone, kind))
            other = ink_of(style_of(None, tone, kind))
            assert abs(mine.mean() - tone) < 0.02, (kind, tone, mine.mean())
            assert numpy.abs(mine - other).mean() < 0.02, (kind, tone)
        for tone in (0.0, 1.0):
            mine = ink_of(style_of(image_of(steps()), tone, kind))
            assert numpy.abs(mine - tone).max() < 1e-3, (kind, tone)


def test_rows_are_tones():
    """Ink that no value of the noise changes: the first row is tone 0, the last one tone 1."""
    inks = numpy.array([0.2, 0.9, 0.4], dtype=numpy.float32)
    image = image_of(numpy.tile(inks[:, None], (1, 8)))
    for tone, wanted in ((0, 0.2), (0.25, 0.55), (0.5, 0.9), (0.75, 0.65), (1, 0.4)):
        found = ink_of(style_of(image, tone))
        assert numpy.abs(found - wanted).max() < 0.01, (tone, wanted, found.mean())


def test_columns_are_values():
    """Ink for values from 0.4 to 0.6 alone lies where thresholds of 0.4 and 0.6 differ."""
    band = numpy.zeros((2, 200), dtype=numpy.float32)
    band[:, 80:120] = 1
    found = ink_of(style_of(image_of(band), 0.9, size=30.0))
    between = ink_of(style_of(image_of(steps()), 0.6, size=30.0)) - ink_of(
        style_of(image_of(steps()), 0.4, size=30.0))
    assert abs(found.mean() - 0.2) < 0.03, found.mean()
    assert numpy.abs(found - between).mean() < 0.01, numpy.abs(found - between).mean()


def test_bytes_are_brightness():
    grey = numpy.random.default_rng(3).integers(0, 256, (16, 32)).astype(numpy.uint8)
    for tone in (0.1, 0.6):
        one = ink_of(style_of(image_of(grey), tone))
        other = ink_of(style_of(image_of(grey.astype(numpy.float32) / 255), tone))
        assert one.std() > 0.05 and numpy.abs(one - other).max() < 0.01


def test_fine_noise_is_its_mean():
    row = numpy.linspace(0.1, 0.7, 64, dtype=numpy.float32)
    found = ink_of(style_of(image_of(numpy.tile(row, (2, 1))), 0.5, size=1.0))
    assert numpy.abs(found - 0.4).max() < 0.01, (found.min(), found.max())


def test_changes_show():
    style = style_of(image_of(numpy.zeros((1, 1), dtype=numpy.float32)))
    assert (ink_of(style) == 0).all()
    actor = scene.actor_of(scene.plane(), style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer)
    scene.look(renderer)
    assert (scene.draw(window) == 255).all()
    image = style.GetLayer(0).GetThresholdImage()
    image.GetPointData().SetScalars(numpy_to_vtk(numpy.zeros(1, dtype=numpy.float32), deep=1))
    image.Modified()
    assert (scene.draw(window) == 0).all(), "a picture that was changed"
    style.GetLayer(0).SetThresholdImage(None)
    assert abs(scene.ink(scene.draw(window)) - 0.5) < 0.05, "thresholds again"


def test_wrong_images():
    volume = vtkImageData()
    volume.SetDimensions(2, 2, 2)
    volume.GetPointData().SetScalars(numpy_to_vtk(numpy.zeros(8, dtype=numpy.float32), deep=1))
    bare = vtkImageData()
    bare.SetDimensions(4, 4, 1)
    cases = [
        (volume, "threshold image: expected a 2D image with scalars"),
        (bare, "threshold image: expected a 2D image with scalars"),
        (image_of(numpy.full((2, 2), -2.5)), "threshold image: expected brightness from 0 to 1, found 3.5"),
        (image_of(numpy.full((2, 2), numpy.nan)), "expected brightness from 0 to 1, found nan"),
        (image_of(numpy.zeros((1, 5000))), "expected at most 4096 columns and rows, found 5000 x 1"),
    ]
    for image, message in cases:
        assert (ink_of(style_of(image)) == 0).all(), message
        scene.expect_messages("layer 0: " + message if message.startswith("threshold") else message)


def test_files():
    folder = os.path.join(OUT, "NoiseThresholdImage")
    os.makedirs(folder, exist_ok=True)
    picture = os.path.join(folder, "steps.png")
    writer = vtkPNGWriter()
    writer.SetInputData(image_of((255 * steps(8, 8)).astype(numpy.uint8)))
    writer.SetFileName(picture)
    writer.Write()
    layer = NOISE()
    assert layer.ReadThresholdImage(picture) and layer.GetThresholdImageFileName() == picture
    style, copy = hachure.vtkPatternStyle(), hachure.vtkPatternStyle()
    style.AddLayer(layer)
    name = os.path.join(folder, "style.json")
    assert style.SaveFile(name) and copy.LoadFile(name)
    assert copy.GetLayer(0).GetThresholdImage().GetDimensions() == (8, 8, 1)
    assert os.path.samefile(copy.GetLayer(0).GetThresholdImageFileName(), picture)
    assert not layer.ReadThresholdImage("no.png") and layer.GetThresholdImageFileName() == picture
    scene.expect_messages('ReadThresholdImage: cannot read the image "no.png": no such file')
    layer.SetThresholdImage(image_of(steps(4, 4)))
    assert layer.GetThresholdImageFileName() == "" and style.ToJson() == ""
    scene.expect_messages("layers[0].field.thresholdImage: the image has no file")


scene.run(globals())
