# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Halftones of four process inks print the colour of the surface."""

import hachure
import numpy
import pattern_scene as scene

SIZE = 256
BOUND = 0.02
# In steps of 1/15, which 8 bits hold exactly.
COLORS = numpy.array((
    (0, 0, 0), (15, 15, 15), (8, 8, 8), (2, 2, 2), (14, 14, 14),
    (15, 0, 0), (0, 15, 0), (0, 0, 15), (15, 14, 0), (3, 4, 4),
    (12, 8, 4), (4, 9, 14), (14, 9, 10), (5, 2, 8), (9, 10, 6),
)) / 15.0


def stage(style):
    actor = scene.actor_of(scene.plane(), style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor, background=(1.0, 0.0, 0.0))
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    scene.look(renderer)
    return actor.GetProperty(), window


def printing(black=1.0):
    style = hachure.style("cmyk")
    style.OutlineOff()
    for index in range(4):
        style.GetLayer(index).GetTone().SetBlackGeneration(black)
    return style


def test_printed_colours():
    worst = 0.0
    for black in (1.0, 0.5, 0.0):
        surface, window = stage(printing(black))
        for color in COLORS:
            surface.SetColor(*color)
            pixels = scene.draw(window)
            found = scene.linear(pixels).mean(axis=(0, 1))
            wanted = scene.linear(255.0 * color)
            worst = max(worst, abs(found - wanted).max())
            assert worst < BOUND, (color, black, found, wanted)
            if max(color) == 0.0 or min(color) == 1.0:
                assert (pixels == 255 * color[0]).all(), (color, black)
    print("largest error", worst)


def test_black_generation_sets_the_share_of_black():
    style = printing(0.5)
    for index in range(3):
        style.GetLayer(index).EnabledOff()
    surface, window = stage(style)
    surface.SetColor(0.5, 0.5, 0.5)
    wanted = 1.0 - 0.5 * (1.0 - scene.linear(128.0))
    assert abs(scene.linear(scene.draw(window)).mean() - wanted) < BOUND


def test_translucent_surface_prints_the_same():
    for color in COLORS[::4]:
        pictures = []
        for opacity in (1.0, 0.9999):
            surface, window = stage(printing())
            surface.SetColor(*color)
            surface.SetOpacity(opacity)
            pictures.append(scene.draw(window).astype(int))
        assert abs(pictures[0] - pictures[1]).max() <= 2, color


def test_lit_surface():
    """Light and shade go into the print, too: it is that of the surface as VTK shows it."""
    data = scene.sphere()
    pictures = []
    for style, opacity in ((None, 1.0), (printing(), 1.0), (printing(), 0.9999)):
        if style:
            for index in range(4):
                style.GetLayer(index).SetSize(0.5)
        actor = scene.actor_of(data, style or hachure.vtkPatternStyle())
        if not style:
            actor.GetMapper().SetStyle(None)
        actor.GetProperty().SetOpacity(opacity)
        actor.GetProperty().BackfaceCullingOn()
        actor.GetProperty().SetColor(0.9, 0.5, 0.2)
        actor.GetProperty().SetInterpolationToPhong()
        renderer = scene.renderer_of(actor)
        window = scene.window_of(renderer, size=(SIZE, SIZE))
        scene.look(renderer, (0.5, 0.6, 2.0))
        pictures.append(scene.draw(window).astype(int))
    for printed in pictures[1:]:
        assert abs(pictures[0] - printed).max() <= 1, abs(pictures[0] - printed).max()


def test_remaps_as_drawn():
    style = scene.constant_style(0, 0.5, 0.0)
    tone = style.GetLayer(0).GetTone()
    _, window = stage(style)
    window.SetSize(32, 32)

    def ink(value):
        tone.SetConstant(value)
        return scene.ink(scene.draw(window))
    tone.SetRemap(tone.STEPS)
    tone.SetSteps(3)
    for value, expected in ((0.3, 0.0), (0.35, 0.5), (0.65, 0.5), (0.7, 1.0)):
        assert abs(ink(value) - expected) < 0.005, value
    tone.SetSteps(5)
    assert abs(ink(0.3) - 0.25) < 0.005
    tone.SetRemap(tone.SMOOTHSTEP)
    tone.SetRemapRange(0.2, 0.6)
    for value, expected in ((0.2, 0.0), (0.3, 0.15625), (0.4, 0.5), (0.6, 1.0)):
        assert abs(ink(value) - expected) < 0.005, value
    tone.SetRemapRange(0.6, 0.2)
    assert abs(ink(0.3) - 0.84375) < 0.005
    tone.SetRemap(tone.NONE)
    assert abs(ink(0.3) - 0.3) < 0.005


scene.run(globals())
