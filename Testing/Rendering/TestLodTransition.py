# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The pattern of half the size takes over without a jump, by ink or by screen, and the tone stays."""

import hachure
import numpy
import pattern_scene as scene

LAYER = hachure.vtkImagePatternLayer
PATTERNS = (LAYER.HATCH, LAYER.CROSS_HATCH, LAYER.HALFTONE)
TRANSITIONS = (LAYER.CROSS_FADE, LAYER.BLEND_SCREENS)
SIZE = 192


class Stage:
    """A plane in parallel projection, unlit."""

    def __init__(self, pattern, transition, tone=0.4, irregularity=0.0, size=8):
        self.style = scene.constant_style(pattern, size, tone, irregularity, 20.0)
        self.layer = self.style.GetLayer(0)
        self.layer.SetTransition(transition)
        self.actor = scene.actor_of(scene.plane(), self.style)
        self.actor.GetProperty().LightingOff()
        self.renderer = scene.renderer_of(self.actor)
        self.window = scene.window_of(self.renderer, size=(SIZE, SIZE))
        scene.look(self.renderer).ParallelProjectionOn()
        self.draw(1.0)

    def draw(self, scale):
        """The picture with the plane `scale` times as large as in the first one."""
        self.renderer.GetActiveCamera().SetParallelScale(1.0 / scale)
        return scene.draw(self.window)

    def scale(self):
        return scene.frame_scale(scene.drawn_frame(self.actor.GetMapper(), self.renderer))


def difference(one, other):
    return numpy.abs(one.astype(int) - other.astype(int)).max()


def jump(one, other):
    """Largest change of ink. A byte can not tell less than its last step; in the dark, where its
    steps are small, several of them are still less than 1/255 of ink."""
    steps = numpy.abs(one.astype(int) - other.astype(int))
    ink = numpy.abs(scene.linear(one) - scene.linear(other))
    return numpy.where(steps <= 1, 0.0, ink).max()


def each():
    for pattern in PATTERNS:
        for transition in TRANSITIONS:
            for irregularity in (0.0, 0.5):
                yield pattern, transition, irregularity


def test_no_jump_where_the_scale_wraps():
    e = 2.5e-6  # more than by which cameras must differ for a pattern to move
    for case in each():
        # So pale that thresholds depend on the width of edges, and with it on the octave.
        stage = Stage(*case[:2], 0.06, case[2])
        first = stage.draw(1.0)
        before, small = stage.draw(2.0 - e), stage.scale()
        after, large = stage.draw(2.0 + 2.0 * e), stage.scale()
        assert 2.0 - 1.1 * e < small < 2.0 < large < 2.0 + 2.1 * e, (small, large)
        assert jump(before, after) <= 1.0 / 255.0, (case, jump(before, after))
        assert difference(stage.draw(1.5), first) > 40, case


def test_no_jump_of_solid_textures():
    e = 1e-6
    for case in each():
        stage = Stage(*case[:2], irregularity=case[2])
        stage.layer.SetMotion(LAYER.DYNAMIC_SOLID)
        # Of Size at scale 1, where the picture is two units high.
        stage.layer.SetSurfacePeriod(8 * 2.0 / SIZE)
        before = stage.draw(2.0 - e)
        after = stage.draw(2.0 + e)
        assert jump(before, after) <= 1.0 / 255.0, (case, jump(before, after))


def test_tone_holds_through_the_transition():
    for pattern, transition, irregularity in each():
        stage = Stage(pattern, transition, irregularity=irregularity)
        inks = []
        for scale in (1.0, 1.2, 1.37, 1.5, 1.63, 1.8):
            pixels = []
            for angle in (20.0, 45.0, 80.0):
                stage.layer.SetAngle(angle)
                pixels.append(scene.ink(stage.draw(scale)))
            inks.append(numpy.mean(pixels))
        # The picture shows few periods, and cuts the last ones.
        assert numpy.abs(numpy.array(inks) - 0.4).max() < 0.01, (pattern, transition, inks)


def test_automatic():
    for pattern in PATTERNS:
        strokes = pattern != LAYER.HALFTONE
        stage = Stage(pattern, LAYER.AUTOMATIC_TRANSITION)
        automatic = stage.draw(1.5)
        stage.layer.SetTransition(LAYER.CROSS_FADE)
        assert (difference(stage.draw(1.5), automatic) == 0) == strokes, pattern
        stage.layer.SetTransition(LAYER.BLEND_SCREENS)
        assert (difference(stage.draw(1.5), automatic) == 0) != strokes, pattern


def test_strokes_fade_and_dots_morph():
    """Half way the new strokes are half grey with the one, black or white with the other."""
    grey = []
    for transition in TRANSITIONS:
        stage = Stage(LAYER.HALFTONE, transition, size=20)
        stage.layer.SetPace(LAYER.CLASSIC)  # which is half way at 1.5
        coverage = 1.0 - scene.linear(stage.draw(1.5))[..., 0]
        grey.append((abs(coverage - 0.5) < 0.02).mean())
    assert grey[0] > 0.2 and grey[1] < 0.05, grey


def swing(stage):
    inks = [scene.ink(stage.draw(scale)) for scale in (1.0, 1.2, 1.4, 1.5, 1.6, 1.8)]
    return max(inks) - min(inks), inks[0]


def test_tone_correction():
    tone = 0.03
    stage = Stage(LAYER.HATCH, LAYER.BLEND_SCREENS, tone)
    full, ink = swing(stage)
    assert full < 0.01 and abs(ink - tone) < 0.005, (full, ink)
    stage.layer.SetToneCorrection(LAYER.TRANSITION_ONLY)
    only, ink = swing(stage)
    assert only < 0.01 and ink - tone > 0.01, (only, ink)
    stage.layer.SetToneCorrection(LAYER.NO_CORRECTION)
    off, uncorrected = swing(stage)
    assert off > 0.01 and abs(uncorrected - ink) < 0.003, (off, uncorrected, ink)


scene.run(globals())
