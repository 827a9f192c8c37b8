# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The swatches of a legend have the ink, the marks and the colours that their values have on the surface."""

import hachure
import numpy
import pattern_scene as scene
from legend_scene import Stage, array_style, image_layer, period
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonCore import vtkVariant

Image = hachure.vtkImagePatternLayer
Style = hachure.vtkPatternStyle
Tone = hachure.vtkPatternTone
INK_BOUND = 0.02  # swatches are small; a stroke more or less counts


def noise_layer():
    layer = hachure.vtkNoiseLayer()
    layer.SetKind(layer.PHASOR)
    layer.SetSize(6.0)
    return layer


def stipple_layer():
    layer = hachure.vtkStippleLayer()
    layer.SetNumberOfPoints(20000)
    return layer


def check_ink(stage, bound=INK_BOUND):
    inks = []
    for first, last, pixels in stage.swatches(stage.draw()):
        assert first == last
        wanted = stage.legend.GetToneAt(first)
        inks.append((first, wanted, round(scene.ink(pixels[2:-2, 2:-2]), 4)))
        assert abs(inks[-1][2] - wanted) < bound, inks
    return inks


def test_ink_is_the_tone_of_the_label():
    layers = {
        "hatch": image_layer(Image.HATCH, 6.0, 30.0),
        "halftone": image_layer(Image.HALFTONE, 6.0, 30.0),
        "noise": noise_layer(),
        "stipple": stipple_layer(),
    }
    for name, layer in layers.items():
        stage = Stage(array_style(layer, ends=(-2.0, 6.0)))
        stage.legend.SetMode(stage.legend.STEPS)
        inks = check_ink(stage)
        assert [value for value, _, _ in inks] == [-2.0, 0.0, 2.0, 4.0, 6.0], inks
        assert [tone for _, tone, _ in inks] == [0.0, 0.25, 0.5, 0.75, 1.0], inks
        assert [text for text, _ in stage.labels()] == ["-2", "0", "2", "4", "6"]
        print(name, inks)


def test_curves_of_the_tone():
    layer = image_layer(Image.HALFTONE, 6.0, 30.0)
    stage = Stage(array_style(layer, ends=(10.0, 0.0)))
    stage.legend.SetMode(stage.legend.STEPS)
    tone = layer.GetTone()
    for gamma, invert, remap in (2.0, False, Tone.NONE), (0.5, True, Tone.NONE), (1.0, False, Tone.SMOOTHSTEP):
        tone.SetGamma(gamma)
        tone.SetInvert(invert)
        tone.SetRemap(remap)
        inks = check_ink(stage)
        middle = (0.5 ** gamma) if remap == Tone.NONE else 0.5
        assert abs(inks[2][1] - middle) < 1e-6, inks
        assert (inks[0][1] < inks[4][1]) == invert, "a range that runs downwards"


def test_ramp():
    """A continuous swatch has at every label the tone of the label's value."""
    stage = Stage(array_style(image_layer(Image.HALFTONE, 4.0, 20.0), ends=(0.0, 50.0)))
    stage.legend.SetNumberOfLabels(6)
    (first, last, pixels), = stage.swatches(stage.draw())
    assert (first, last) == (0.0, 50.0)
    labels = stage.labels()
    assert [text for text, _ in labels] == ["0", "10", "20", "30", "40", "50"], labels
    for text, place in labels[1:-1]:
        row = place * len(pixels)
        band = pixels[int(row) - 20 : int(row) + 20]
        assert abs(scene.ink(band) - float(text) / 50.0) < INK_BOUND, (text, scene.ink(band))


def test_flat_steps_of_the_tone():
    layer = image_layer(Image.HALFTONE, 5.0, 30.0)
    layer.GetTone().SetRemap(Tone.STEPS)
    layer.GetTone().SetSteps(4)
    layer.GetTone().SetGamma(2.0)
    stage = Stage(array_style(layer, ends=(0.0, 4.0)))
    inks = check_ink(stage)
    assert [tone for _, tone, _ in inks] == [numpy.float32(i / 3.0) for i in range(4)], inks
    assert [text for text, _ in stage.labels()] == ["0", "2", "2.828", "3.464", "4"]
    places = [place for _, place in stage.labels()]
    assert numpy.allclose(places, [0.0, 0.25, 0.5, 0.75, 1.0], atol=0.01), places


def test_spacing_is_that_of_the_surface():
    for layer in image_layer(Image.HATCH, 9.0, 0.0), noise_layer():
        if layer.IsA("vtkNoiseLayer"):
            layer.SetSize(9.0)
            layer.SetAngle(0.0)
        style = array_style(layer)
        stage = Stage(style)
        stage.legend.SetValueRange(0.49, 0.51)
        plane = scene.plane().GetOutput()
        scene.add_array(plane.GetPointData(), "depth", numpy.full(plane.GetNumberOfPoints(), 0.5))
        surface = scene.window_of(scene.renderer_of(scene.actor_of(plane, style)), size=(320, 320))
        shown = scene.draw(surface)[60:260, 60:260]  # of 226 pixels
        (_, _, swatch), = stage.swatches(stage.draw())
        periods = period(swatch), period(shown)
        print("periods", periods)
        assert abs(periods[0] / periods[1] - 1.0) < 0.05, periods


def test_several_layers_of_one_array():
    """The range is that of both, and each has its own tone; light is full."""
    style = array_style(image_layer(Image.HALFTONE, 5.0, 30.0), ends=(0.0, 100.0))
    below = image_layer(Image.HATCH, 5.0)
    below.GetTone().SetSource(Tone.ARRAY)
    below.GetTone().SetArrayName("depth")
    below.GetTone().SetRange(0.0, -60.0)
    style.AddLayer(below)
    style.AddLayer(image_layer(Image.CROSS_HATCH))  # by light
    stage = Stage(style)
    stage.legend.SetMode(stage.legend.STEPS)
    stage.legend.SetValueRange(-30.0, 30.0)
    stage.legend.SetNumberOfSteps(3)
    inks = [scene.ink(pixels) for _, _, pixels in stage.swatches(stage.draw())]
    for ink, wanted in zip(inks, (0.5, 0.0, 0.3)):
        assert abs(ink - wanted) < INK_BOUND, inks
    stage.legend.SetValueRange(0.0, 0.0)
    values = [first for first, _, _ in stage.swatches(stage.draw())]
    assert values == [-60.0, 20.0, 100.0], values


def test_light():
    stage = Stage(hachure.style("halftone"))
    stage.legend.SetMode(stage.legend.STEPS)
    check_ink_of_light(stage)
    assert [text for text, _ in stage.labels()] == ["light", "dark"]
    stage.legend.SetLowLabel("day")
    stage.legend.SetHighLabel("night")
    stage.draw()
    assert [text for text, _ in stage.labels()] == ["day", "night"]


def check_ink_of_light(stage):
    stage.legend.GetStyle().GetLayer(0).SetColor(0.0, 0.0, 0.0)
    stage.legend.GetStyle().SetPaperColor(1.0, 1.0, 1.0)
    stage.legend.GetStyle().GetLayer(0).SetSize(5.0)
    inks = [scene.ink(pixels[2:-2]) for _, _, pixels in stage.swatches(stage.draw())]
    for ink, wanted in zip(inks, (0.0, 0.25, 0.5, 0.75, 1.0)):
        assert abs(ink - wanted) < INK_BOUND, inks


def category_table():
    table = vtkLookupTable()
    table.SetNumberOfTableValues(3)
    table.IndexedLookupOn()
    colors = (0.9, 0.1, 0.1), (0.1, 0.7, 0.2), (0.2, 0.3, 0.9)
    for index, (value, name) in enumerate(((1, "sand"), (2, "clay"), (5, "rock"))):
        table.SetAnnotation(vtkVariant(value), name)
        table.SetTableValue(index, *colors[index], 1.0)
    return table, colors


def test_categories_of_a_lookup_table():
    style = array_style(image_layer(Image.HALFTONE, 5.0, 30.0), ends=(0.0, 10.0))
    style.SetPaperSource(Style.FLAT)
    stage = Stage(style)
    table, colors = category_table()
    stage.legend.SetLookupTable(table)
    stage.legend.SetSwatchThickness(100)
    swatches = stage.swatches(stage.draw())
    assert [first for first, _, _ in swatches] == [1.0, 2.0, 5.0]
    assert [text for text, _ in stage.labels()] == ["sand", "clay", "rock"]
    places = [place for _, place in stage.labels()]
    assert places == sorted(places, reverse=True), "from above"
    for (value, _, pixels), color in zip(swatches, colors):
        found, counts = numpy.unique(pixels[pixels.sum(axis=2) > 60], axis=0, return_counts=True)
        paper = found[counts.argmax()]
        assert abs(paper / 255.0 - color).max() < 0.02, (value, paper)
        light = scene.linear(pixels).mean(axis=(0, 1)) / scene.linear(255.0 * numpy.array(color))
        brightest = light[numpy.argmax(color)]  # of which bytes tell most
        assert abs(1.0 - brightest - value / 10.0) < INK_BOUND, (value, light)


def test_categories_of_the_user():
    stage = Stage(array_style(image_layer(Image.HALFTONE, 5.0, 30.0), ends=(0.0, 4.0)))
    for value, name in (3.0, "three"), (1.0, "one"):
        stage.legend.AddCategory(value, name)
    assert [tone for _, tone, _ in check_ink(stage)] == [0.75, 0.25]
    assert [text for text, _ in stage.labels()] == ["three", "one"]
    stage.legend.RemoveAllCategories()
    stage.draw()
    assert stage.legend.GetNumberOfSwatches() == 1


def test_no_number():
    """In the colour of the mapper, of the lookup table, and with its label."""
    stage = Stage(array_style(image_layer(Image.HATCH)))
    stage.legend.DrawNanSwatchOn()
    stage.legend.SetSwatchThickness(40)
    color = numpy.median(stage.swatches(stage.draw())[1][2].reshape(-1, 3), axis=0)
    assert abs(color - 0.75 * 255).max() <= 1, color
    table = vtkLookupTable()
    table.SetNanColor(0.2, 0.4, 0.6, 1.0)
    stage.legend.SetLookupTable(table)
    color = numpy.median(stage.swatches(stage.draw())[1][2].reshape(-1, 3), axis=0)
    assert abs(color / 255.0 - (0.2, 0.4, 0.6)).max() < 0.01, color


scene.run(globals())
