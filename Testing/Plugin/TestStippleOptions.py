# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What replaces parts of a style of stipples does what it says, and nothing unasked."""

import pattern_scene as scene
from stipple_pictures import BY_ARRAY, STYLE_FILE, TONE, changes, draw, few, ink, same, style_file

# The default style; neutral values, and what no choice asks for, change nothing.
usual = draw("stipple")
neutral = {"Style": "stipple", "Scale": 1, "Size": 0, "Growth": 0, "NumberOfPoints": 0, "MemoryBudget": 0}
neutral.update(InkColor=[1, 0, 0], PaperColor=[1, 0, 0], Outline="Off", ToneRange=[3, 4], Seed=0)
defaults = {"Size": 2.4, "Carrier": "Density", "Growth": 0.25, "Order": "Progressive", "NumberOfPoints": 100000}
defaults.update(Refinement="On", MemoryBudget=256)
for options in neutral, defaults:
    assert same(usual, draw(**options)), options
assert same(usual, draw(prefix="Pattern", StyleFile=STYLE_FILE))

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
assert same(few(Carrier="Size", **BY_ARRAY), few(StyleFile=style_file(carrier="size"), **BY_ARRAY))
assert scene.difference(basic, few(Seed=3)) > 20
assert same(few(Seed=3), draw(prefix="Pattern", StyleFile=style_file(numberOfPoints=5000), Seed=3))

# Too few points: more are made; or dots are larger instead, if no more may be made.
coarse, fine = (few("stipple-few-" + choice, 300, Refinement=choice) for choice in ("Off", "On"))
assert changes(coarse) < 0.7 * changes(basic), (changes(coarse), changes(basic))
assert abs(changes(fine) / changes(basic) - 1) < 0.1, (changes(fine), changes(basic))
assert abs(ink(coarse) - TONE) < 0.1 and abs(ink(fine) - TONE) < 0.04, (ink(coarse), ink(fine))

# A file that is none, and a name that is none.
for options, text in (
    ({"StyleFile": "/nowhere/a.json"}, "cannot read the style file"),
    ({"Style": "dots"}, 'unknown style "dots"'),
):
    with scene.Messages() as messages:
        few(**options)
    assert messages.text.count(text) == 1, messages.text
