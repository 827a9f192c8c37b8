# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Changes of the style show in the next picture, and none of them is left over."""

import hachure
import pattern_scene as scene


class Stage:
    def __init__(self, style="cross-hatch"):
        self.actor = scene.actor_of(scene.sphere(24, 0.6), style)
        self.renderer = scene.renderer_of(self.actor)
        self.window = scene.window_of(self.renderer, size=(160, 160))
        scene.look(self.renderer)

    @property
    def style(self):
        return self.actor.GetMapper().GetStyle()

    def draw(self):
        return scene.draw(self.window)


def check_change(change):
    """A change shows at once, as in a window that never knew the style before it."""
    stage = Stage()
    before = stage.draw()
    change(stage.style)
    changed = stage.draw()
    assert (changed != before).any(), "the change does not show"
    fresh = Stage()
    change(fresh.style)
    assert (fresh.draw() == changed).all(), "something of the old style is left"
    stage.style.LoadPreset("cross-hatch")
    assert (stage.draw() == before).all(), "something of the change is left"


def second_layer():
    layer = hachure.vtkImagePatternLayer()
    layer.SetPattern(layer.HALFTONE)
    layer.SetColor(0.0, 0.2, 0.9)
    layer.SetAngle(10.0)
    return layer


CHANGES = {
    "pattern": lambda style: style.GetLayer(0).SetPattern(0),
    "size": lambda style: style.GetLayer(0).SetSize(12.0),
    "angle": lambda style: style.GetLayer(0).SetAngle(10.0),
    "irregularity": lambda style: style.GetLayer(0).SetIrregularity(0.9),
    "seed": lambda style: style.GetLayer(0).SetSeed(7),
    "colour": lambda style: style.GetLayer(0).SetColor(0.7, 0.0, 0.0),
    "opacity": lambda style: style.GetLayer(0).SetOpacity(0.5),
    "gamma": lambda style: style.GetLayer(0).GetTone().SetGamma(2.0),
    "inverted": lambda style: style.GetLayer(0).GetTone().InvertOn(),
    "source": lambda style: style.GetLayer(0).GetTone().SetSource(3),
    "other tone": lambda style: style.GetLayer(0).SetTone(constant_tone()),
    "paper": lambda style: style.SetPaperColor(1.0, 0.9, 0.7),
    "paper source": lambda style: style.SetPaperSource(style.SURFACE),
    "no outline": lambda style: style.OutlineOff(),
    "outline width": lambda style: style.SetOutlineWidth(4.0),
    "outline colour": lambda style: style.SetOutlineColor(1.0, 0.0, 0.0),
    "one layer more": lambda style: style.AddLayer(second_layer()),
    "layer below": lambda style: style.InsertLayer(0, second_layer()),
    "no layer": lambda style: style.RemoveAllLayers(),
    "layer off": lambda style: style.GetLayer(0).EnabledOff(),
    "preset": lambda style: style.LoadPreset("halftone"),
}


def constant_tone():
    tone = hachure.vtkPatternTone()
    tone.SetSource(tone.CONSTANT)
    tone.SetConstant(0.3)
    return tone


def test_changes_show_at_once():
    for name, change in CHANGES.items():
        try:
            check_change(change)
        except AssertionError as problem:
            raise AssertionError("%s: %s" % (name, problem)) from None


def test_blend_modes():
    stage = Stage()
    layer = second_layer()
    layer.GetTone().SetSource(hachure.vtkPatternTone.CONSTANT)
    layer.SetOpacity(0.7)
    stage.style.AddLayer(layer)
    stage.style.SetPaperColor(0.6, 0.7, 0.5)
    pictures = []
    for mode in (layer.OVER, layer.MULTIPLY, layer.OVERLAY, layer.SCREEN):
        layer.SetBlendMode(mode)
        pictures.append(stage.draw())
    for i, a in enumerate(pictures):
        assert all((a != b).any() for b in pictures[i + 1:]), i


def test_millimetres_and_resolution():
    """3 mm at 96 and at 192 dots per inch, and as pixels."""
    stage = Stage()
    layer = stage.style.GetLayer(0)
    pictures = []
    for size, unit, dots in ((25.4 / 12, layer.MILLIMETRES, 96.0), (8.0, layer.PIXELS, 96.0),
                             (25.4 / 24, layer.MILLIMETRES, 192.0), (8.0, layer.PIXELS, 192.0)):
        layer.SetSize(size)
        layer.SetSizeUnit(unit)
        stage.style.SetDotsPerInch(dots)
        pictures.append(stage.draw())
    assert all((a == pictures[0]).all() for a in pictures)


def test_shared_style_changes_all_mappers():
    style = hachure.style("hatch")
    first, second = Stage(style), Stage(style)
    before = [first.draw(), second.draw()]
    assert (before[0] == before[1]).all()
    style.GetLayer(0).SetAngle(80.0)
    after = [first.draw(), second.draw()]
    assert (after[0] == after[1]).all() and (after[0] != before[0]).any()


scene.run(globals())
