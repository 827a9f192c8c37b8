# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stipples, several densities of strokes, paint and paper: ink equals tone, and what makes each of them."""

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.vtkFiltersCore import vtkElevationFilter

LAYER = hachure.vtkImagePatternLayer
TONES = (0.1, 0.3, 0.5, 0.7, 0.9)
TOLERANCE = 0.01
# Paper comes in through the distribution of two screens, not through a table of its own.
TOLERANCE_ON_PAPER = 0.016
CASES = {
    "stipple": (LAYER.STIPPLE, 8, {}),
    "hatch in 3 densities": (LAYER.HATCH, 8, {"Densities": 3}),
    "cross-hatch in 2 densities": (LAYER.CROSS_HATCH, 8, {"Densities": 2, "Irregularity": 0.35}),
    "hatch on paper": (LAYER.HATCH, 8, {"PaperContrast": 0.5}),
    "halftone on paper": (LAYER.HALFTONE, 8, {"PaperContrast": 0.3, "PaperSize": 3.0}),
    "paper alone": (LAYER.PAPER, 6, {}),
    "paint of one colour": (LAYER.PAINT, 10, {}),
}


def flat_view(style, data=None, size=(300, 300)):
    actor = scene.actor_of(data or scene.plane(), style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor, background=(1.0, 0.0, 0.0))
    window = scene.window_of(renderer, size=size)
    scene.look(renderer)
    return actor, renderer, window


def style_of(case, tone=0.5):
    pattern, size, options = CASES[case]
    style = scene.constant_style(pattern, size, tone)
    for name, value in options.items():
        getattr(style.GetLayer(0), "Set" + name)(value)
    return style


def test_ink_equals_tone():
    actor, renderer, window = flat_view(style_of("stipple"))
    worst = (0.0, "")
    for case in CASES:
        style = style_of(case)
        layer = style.GetLayer(0)
        actor.GetMapper().SetStyle(style)
        for tone in (0.0, 1.0):
            layer.GetTone().SetConstant(tone)
            assert (scene.draw(window) == (0 if tone else 255)).all(), (case, tone)
        for tone in TONES:
            layer.GetTone().SetConstant(tone)
            inks = []
            for angle in (45.0, 20.0, 80.0):
                layer.SetAngle(angle)
                inks.append(scene.ink(scene.draw(window)))
            error = abs(numpy.mean(inks) - tone)
            on_paper = "PaperContrast" in CASES[case][2]
            assert error < (TOLERANCE_ON_PAPER if on_paper else TOLERANCE), (case, tone, inks)
            worst = max(worst, (0.0 if on_paper else error, "%s, tone %g: %s" % (case, tone, inks)))
    print("largest error", worst)


def test_tone_holds_while_patterns_grow():
    actor, renderer, window = flat_view(style_of("stipple"))
    for case in ("stipple", "hatch in 3 densities", "hatch on paper", "paint of one colour"):
        actor.GetMapper().SetStyle(style_of(case, 0.4))
        actor.GetMapper().Reanchor(renderer)
        inks = []
        for scale in numpy.linspace(1.0, 2.1, 12):
            scene.look(renderer, (0.0, 0.0, 3.0 / scale))
            inks.append(scene.ink(scene.draw(window)))
        assert numpy.abs(numpy.array(inks) - 0.4).max() < 0.02, (case, inks)


def components(dark):
    """Number of connected regions, by repeated exchange of the lowest label."""
    label = numpy.where(dark, numpy.arange(dark.size).reshape(dark.shape) + 1, 0)
    while True:
        before = label.copy()
        for axis in (0, 1):
            for shift in (1, -1):
                other = numpy.roll(label, shift, axis)
                joined = (label > 0) & (other > 0)
                label = numpy.where(joined, numpy.maximum(label, other), label)
        if (label == before).all():
            return len(numpy.unique(label)) - 1


def test_stipples_are_added_not_grown():
    style = style_of("stipple")
    _, _, window = flat_view(style)
    found = {}
    for tone in (0.1, 0.3):
        style.GetLayer(0).GetTone().SetConstant(tone)
        found[tone] = components(scene.draw(window)[..., 0] < 96)
    assert 2.3 < found[0.3] / found[0.1] < 3.7, found


def test_densities_double_the_strokes():
    counts = []
    style = style_of("hatch in 3 densities")
    style.GetLayer(0).SetAngle(0.0)
    _, _, window = flat_view(style)
    for tone in (0.08, 0.2, 0.5):
        style.GetLayer(0).GetTone().SetConstant(tone)
        dark = scene.draw(window)[:, 150, 0] < 128
        counts.append(int((dark[1:] & ~dark[:-1]).sum()))
    assert abs(counts[1] / counts[0] - 2) < 0.35 and abs(counts[2] / counts[1] - 2) < 0.35, counts
    assert abs(300 / counts[2] - 8) < 1, "Size is the distance of the densest strokes"


def test_densities_spread_over_the_picture():
    """Strokes that come in one by one do not gather in bands that repeat with the tile."""
    style = scene.constant_style(LAYER.HATCH, 7, 0.3, 0.35, angle=0.0)
    style.GetLayer(0).SetDensities(3)
    _, _, window = flat_view(style, size=(448, 448))
    rows = 1.0 - scene.linear(scene.draw(window)).mean(axis=(1, 2))
    bands = rows.reshape(16, 28).mean(axis=1)  # one of the sparsest strokes in each
    print("ink of bands deviates by", bands.std())
    assert bands.std() < 0.04, bands


def colored_plane():
    source = scene.plane(1.7)
    colors = vtkElevationFilter()
    colors.SetInputData(source.GetOutput())
    colors.SetLowPoint(-0.85, 0.0, 0.0)
    colors.SetHighPoint(0.85, 0.0, 0.0)
    colors.Update()
    return colors.GetOutput()


def paint_style(**options):
    style = scene.constant_style(LAYER.PAINT, 16, 1.0)
    layer = style.GetLayer(0)
    layer.SetColorSource(layer.SURFACE)
    for name, value in options.items():
        getattr(layer, "Set" + name)(value)
    return style


def surface_colors(data, size=(300, 300)):
    style = hachure.vtkPatternStyle()
    style.SetPaperSource(style.SURFACE)
    return scene.draw(flat_view(style, data, size)[2]).astype(float)


def test_every_dab_has_one_colour():
    data = colored_plane()
    wanted = surface_colors(data)
    painted = scene.draw(flat_view(paint_style(Bristles=0.0), data)[2]).astype(float)
    change = numpy.abs(numpy.diff(painted, axis=1)).max(axis=2)
    ramp = numpy.abs(numpy.diff(wanted, axis=1)).max(axis=2)
    assert (ramp > 0.5).mean() > 0.5, "the surface's colour changes from pixel to pixel"
    assert (change < 0.5).mean() > 0.6, (change < 0.5).mean()
    # Averaged over many dabs the colours are the surface's.
    means = [picture.reshape(300, 6, 50, 3).mean(axis=(0, 2)) for picture in (painted, wanted)]
    assert numpy.abs(means[0] - means[1]).max() < 6.0, means


def test_paint_of_the_surface_ends_at_its_edge():
    """Dabs whose middle lies beyond the object take the colour of their pixel, never the background's."""
    data = scene.sphere()
    actor, _, window = flat_view(paint_style(), data)
    actor.GetProperty().SetColor(0.2, 0.4, 0.8)
    pixels = scene.draw(window)
    background = (pixels == (255, 0, 0)).all(axis=2)
    surface = pixels[~background].astype(int)
    assert 0.02 < 1.0 - background.mean() < 0.9
    assert numpy.abs(surface - surface[0]).max() <= 1, numpy.unique(surface, axis=0)[:5]


def test_relief_and_variation():
    data = colored_plane()
    flat = scene.draw(flat_view(paint_style(), data)[2]).astype(float)
    for options in ({"Bump": 0.6}, {"ColorVariation": 0.4}):
        other = scene.draw(flat_view(paint_style(**options), data)[2]).astype(float)
        assert numpy.abs(other - flat).mean() > 1.0, options
        assert abs(other.mean() - flat.mean()) < 6.0, options


def test_colour_of_the_surface_in_strokes():
    data = colored_plane()
    wanted = surface_colors(data)
    style = scene.constant_style(LAYER.HATCH, 8, 1.0)
    style.GetLayer(0).SetColorSource(style.GetLayer(0).SURFACE)
    assert numpy.abs(scene.draw(flat_view(style, data)[2]) - wanted).max() <= 1
    style.GetLayer(0).GetTone().SetConstant(0.0)
    assert (scene.draw(flat_view(style, data)[2]) == 255).all()


def test_translucent_paint():
    data = colored_plane()
    actor, _, window = flat_view(paint_style(), data)
    actor.ForceTranslucentOn()
    painted = scene.draw(window).astype(float)
    assert numpy.abs(painted - surface_colors(data)).mean() < 4.0, "every pixel has its own colour"


def test_presets_draw():
    for name in ("painterly", "paper"):
        _, _, window = flat_view(name, scene.sphere())
        assert scene.draw(window).std() > 10


scene.run(globals())
