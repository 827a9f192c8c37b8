# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The pattern of half the size takes over within a time of the animation, whatever the zoom does."""

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

LAYER = hachure.vtkImagePatternLayer
SIZE = 160
FRAME = 0.1  # a quarter of a transition


class Stage:
    """A plane in parallel projection, unlit, drawn at scale 1 and time 0, then at first, if that is a scale."""

    def __init__(self, duration=4 * FRAME, lod=(1.3, 1.7), pattern=LAYER.HALFTONE, first=1.0):
        self.style = scene.constant_style(pattern, 14, 0.4, 0.0, 20.0)
        self.layer = self.style.GetLayer(0)
        self.layer.SetTransition(LAYER.CROSS_FADE if duration == 0.0 else LAYER.BLEND_SCREENS)
        self.layer.SetTransitionTime(duration)
        self.layer.SetLodStart(lod[0])
        self.layer.SetLodEnd(lod[1])
        self.actor = scene.actor_of(scene.plane(), self.style)
        self.actor.GetProperty().LightingOff()
        self.mapper = self.actor.GetMapper()
        self.renderer = scene.renderer_of(self.actor)
        self.window = scene.window_of(self.renderer, size=(SIZE, SIZE))
        scene.look(self.renderer).ParallelProjectionOn()
        if first is not None:
            self.draw(1.0, 0.0)
        if first not in (None, 1.0):
            self.draw(first, 0.0)

    def draw(self, scale, time):
        self.renderer.GetActiveCamera().SetParallelScale(1.0 / scale)
        self.mapper.SetAnimationTime(time)
        return scene.draw(self.window)


def alone(scale, second):
    """The picture at a scale of the pattern, or of its half-size copy, without the other."""
    return Stage(0.0, (1.0, 1.0) if second else (1.99, 2.0)).draw(scale, 0.0)


def same(one, other):
    return numpy.abs(one.astype(int) - other.astype(int)).max() <= 1


def inks(stage, scale, frames):
    return [stage.draw(scale, FRAME * frame) for frame in frames]


def test_takes_its_time():
    first, second = alone(1.75, False), alone(1.75, True)
    assert not same(first, second)
    shown = inks(Stage(), 1.75, range(1, 7))
    assert same(shown[0], first) and same(shown[4], second) and same(shown[5], second)
    part = [abs(scene.linear(one) - scene.linear(first)).mean() for one in shown]
    assert (numpy.diff(part[:5]) > 0.0).all(), part
    tones = [scene.ink(one) for one in shown]
    assert max(tones) - min(tones) < 0.01, tones


def test_the_way_back():
    stage = Stage()
    inks(stage, 1.75, range(1, 8))
    assert same(stage.draw(1.35, 0.8), alone(1.35, True)), "within the two scales nothing changes"
    assert same(stage.draw(1.25, 0.9), alone(1.25, True))
    assert not same(stage.draw(1.25, 1.1), alone(1.25, True))
    assert same(stage.draw(1.25, 1.3), alone(1.25, False))


def test_equal_times_give_equal_bytes():
    stage = Stage()
    stage.draw(1.75, 0.1)
    half = stage.draw(1.75, 0.3)
    assert (stage.draw(1.75, 0.3) == half).all()
    shot = vtkWindowToImageFilter()
    shot.SetInput(stage.window)
    shot.SetScale(2)
    shot.Update()
    assert (stage.draw(1.75, 0.3) == half).all(), "a screenshot moved the transition on"
    other = Stage()
    other.draw(1.75, 0.1)
    other.draw(1.75, 0.2)
    assert (other.draw(1.75, 0.3) == half).all()


def test_complete_at_once_without_a_time_that_goes_on():
    second = alone(1.75, True)
    assert same(Stage().draw(1.75, 0.0), second)
    stage = Stage()
    inks(stage, 1.75, (1, 2))
    assert same(stage.draw(1.75, 0.1), second), "time ran backwards"
    assert (stage.draw(1.75, 0.0) == Stage(first=None).draw(1.75, 0.0)).all(), "at the first time all begins anew"
    stage = Stage()
    inks(stage, 1.75, (1, 2))
    assert same(stage.draw(1.75, 100.0), second), "time jumped"
    stage = Stage()
    inks(stage, 1.75, (1, 2))
    assert same(stage.draw(2.2, 0.3), alone(2.2, False)), "too large to wait"


def test_time_of_the_data():
    stage = Stage()
    data = scene.plane().GetOutput()
    stage.mapper.SetInputDataObject(data)
    shown = []
    for frame, scale in enumerate((1.0, 1.75, 1.75, 1.75)):
        data.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), FRAME * frame)
        shown.append(stage.draw(scale, 0.0))
    assert same(shown[1], alone(1.75, False)) and not same(shown[3], shown[1])
    assert not same(shown[3], alone(1.75, True))


def test_by_scale_where_nothing_is_remembered():
    stage, plain = Stage(), Stage(0.0)
    for one in (stage, plain):
        one.style.SetTrackingMode(hachure.vtkPatternStyle.ANCHORED)
    for time, scale in enumerate((1.0, 1.5, 1.45, 1.8)):
        assert (stage.draw(scale, FRAME * time) == plain.draw(scale, FRAME * time)).all(), scale


def test_other_layers_go_by_scale():
    stage, plain = Stage(), Stage(0.0)
    for one in (stage, plain):
        layer = LAYER()
        layer.SetPattern(LAYER.HATCH)
        one.style.AddLayer(layer)
        one.layer.SetOpacity(0.0)
    for time, scale in enumerate((1.0, 1.5, 1.8)):
        assert same(stage.draw(scale, FRAME * time), plain.draw(scale, FRAME * time)), scale


scene.run(globals())
