# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stipples have the ink of the tone; what replaces parts of their style does what it says, and nothing unasked."""

import json
import os

import numpy
import pattern_scene as scene
from paraview import simple

PRESETS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Rendering/Presets")
STYLE_FILE = os.path.join(PRESETS, "stipple.json")
TONE = 0.4

plane = simple.Plane(Origin=[-1, -1, 0], Point1=[1, -1, 0], Point2=[-1, 1, 0])
across = simple.Elevation(Input=plane, LowPoint=[-1, 0, 0], HighPoint=[1, 0, 0])
ball = simple.Sphere(ThetaResolution=16, PhiResolution=16)


def draw(name=None, source=plane, prefix="Stipple", **properties):
    """A picture of even tone, of a plane that fills the view or of another source."""
    where = scene.view((120, 90))
    options = {"Tone": "Constant", "ToneConstant": TONE}
    options.update(properties)
    renamed = {prefix + name: value for name, value in options.items()}
    scene.show(source, where, Representation=prefix, **renamed)
    scene.look(where, (0, 0, 2.2))
    shown = scene.picture(where, name)
    simple.Delete(where)
    return shown


def few(name=None, points=5000, **properties):
    """The same with fewer points, which take less time and suffice."""
    return draw(name, NumberOfPoints=points, **properties)


def same(first, second):
    """Whether two pictures are equal."""
    return (first == second).all()


def ink(shown):
    """Mean coverage with black ink."""
    return 1 - scene.linear(shown).mean()


def changes(shown):
    """Mean difference of neighbouring pixels."""
    grey = shown.astype(float).mean(axis=2)
    return sum(numpy.abs(numpy.diff(grey, axis=axis)).mean() for axis in (0, 1))


def style_file(**field):
    """The style of stipples with these keys in place of its own."""
    with open(STYLE_FILE, encoding="ascii") as file:
        style = json.load(file)
    style["layers"][0]["field"].update(field)
    name = os.path.join(scene.output_folder, "stipple-style.json")
    with open(name, "w", encoding="ascii") as file:
        json.dump(style, file)
    return name


# The default style; neutral values, and what no choice asks for, change nothing.
usual = draw("stipple")
neutral = {"Style": "stipple", "Scale": 1, "Size": 0, "Growth": 0, "NumberOfPoints": 0, "MemoryBudget": 0}
neutral.update(InkColor=[1, 0, 0], PaperColor=[1, 0, 0], Outline="Off", ToneRange=[3, 4], Seed=0)
defaults = {"Size": 2.4, "Carrier": "Density", "Growth": 0.25, "Order": "Progressive", "NumberOfPoints": 100000}
defaults.update(Refinement="On", MemoryBudget=256)
for options in neutral, defaults:
    assert same(usual, draw(**options)), options
assert same(usual, draw(prefix="Pattern", StyleFile=STYLE_FILE))

# Ink is the tone: an even one, and one that an array brings, from paper to full ink.
for tone in 0, 0.05, 0.2, 0.4, 0.7, 1:
    drawn = ink(few("stipple-tone-%g" % tone, 15000, ToneConstant=tone))
    assert abs(drawn - tone) < 0.04, (tone, drawn)
array = {"source": across, "Tone": "Array", "ToneArray": ["POINTS", "Elevation"]}
by_carrier = [numpy.array_split(few("stipple-by-" + carrier, 30000, Carrier=carrier, **array), 6, axis=1)
              for carrier in ("Density", "Size")]
wide = 2 * 2.2 * numpy.tan(numpy.radians(15)) * 120 / 90
for stripes in by_carrier:
    for part, stripe in enumerate(stripes):
        tone = 0.5 + ((part + 0.5) / 6 - 0.5) * wide / 2
        assert abs(ink(stripe) - tone) < 0.06, (part, tone, ink(stripe))

# What is light has few dots, which are black, or many small ones.
many, small = ((stripes[0] < 30).mean() for stripes in by_carrier)
assert many > 3 * small, (many, small)

# Dots: numbers of a style file with the same ones; other places, and as much ink.
basic = few()
for options, field in (
    ({"Size": 4}, {"size": {"px": 4}}),
    ({"Size": 2, "Scale": 2}, {"size": {"px": 4}}),
    ({"Scale": 1.5}, {"size": {"px": 3.6}}),
    ({"Growth": 4}, {"growth": 4}),
    ({"Growth": 0.001}, {"growth": 0.01}),
    ({"Order": "Classic"}, {"order": "classic"}),
    ({"Refinement": "Off", "Scale": 1}, {"refinement": False}),
    ({"MemoryBudget": 1}, {"memoryBudget": 1}),
):
    changed = few(**options)
    assert same(changed, few(StyleFile=style_file(**field))), options
    assert abs(ink(changed) - TONE) < 0.06, (options, ink(changed))
    if not {"Refinement", "MemoryBudget"} & set(options):
        assert scene.difference(basic, changed) > 5, options
assert changes(few(Size=5)) < 0.7 * changes(basic)
assert same(few(Carrier="Size", **array), few(StyleFile=style_file(carrier="size"), **array))
assert scene.difference(basic, few(Seed=3)) > 20
assert same(few(Seed=3), draw(prefix="Pattern", StyleFile=style_file(numberOfPoints=5000), Seed=3))

# Too few points: dots are larger instead, if no more may be made.
coarse = few("stipple-few", points=300, Refinement="Off")
assert changes(coarse) < 0.7 * changes(basic), (changes(coarse), changes(basic))
assert abs(ink(coarse) - TONE) < 0.1, ink(coarse)

# Ink, paper, tone and lines are those of Pattern.
file_name = style_file(numberOfPoints=5000)
shared = [{"Ink": "Color", "InkColor": [1, 0, 0]}, {"InkOpacity": 0.5}, {"BlendMode": "Multiply", "Paper": "Lit surface"}]
shared += [{"Paper": "Color", "PaperColor": [1, 1, 0]}, {"Tone": "Light"}, {"ToneConstant": 0.6}]
shared += [{"ToneInvert": "On"}, {"ToneGamma": 2}, {"ToneRemap": "Steps"}, {"Scale": 0.8}]
for options in shared:
    changed = few(**options)
    assert scene.difference(basic, changed) > 4, options
    assert same(changed, few(StyleFile=file_name, **options)), options
    assert same(changed, draw(prefix="Pattern", StyleFile=file_name, **options)), options
assert ((few(source=ball, Outline="On") < 60).sum() - (few(source=ball) < 60).sum()) > 100

# The other styles: dots that lighten dark paper, and dots of both kinds on grey.
lit = {"Tone": "As in the style"}
white = few("stipple-white", source=ball, Style="stipple-white", **lit)
inside = (few(source=ball, ToneConstant=1) < 30).all(axis=2)
assert (white[inside] < 70).all(axis=1).mean() > 0.05 and (white[inside] > 220).all(axis=1).mean() > 0.05
both = few("stipple-two-inks", source=ball, Style="stipple-two-inks", **lit)[inside]
assert (both < 60).all(axis=1).sum() > 20 and (both > 230).all(axis=1).sum() > 20
assert (abs(both - [156, 150, 138]) < 3).all(axis=1).mean() > 0.1

# A file that is none, and a name that is none.
for options, text in (
    ({"StyleFile": "/nowhere/a.json"}, "cannot read the style file"),
    ({"Style": "dots"}, 'unknown style "dots"'),
):
    with scene.Messages() as messages:
        few(**options)
    assert messages.text.count(text) == 1, messages.text
