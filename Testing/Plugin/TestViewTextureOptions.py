# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What replaces parts of a view-dependent texture does what it says, and nothing unasked."""

import os

import numpy
import pattern_scene as scene
from paraview import simple
from view_pictures import (
    BLUE, GREY, RED, WHITE, aside, draw, folder, is_color, manifest, painted, same, show, style_file, waves
)

both = manifest("both", painted("all", RED), painted("front", BLUE, extremes=40))
side = aside(60)

# A dependent view is seen from near its camera, an independent one from everywhere; without views all is grey.
front, beside = draw("view-front", Manifest=both), draw("view-beside", side, Manifest=both)
assert is_color(front, BLUE) and is_color(beside, RED)
assert is_color(draw(), GREY)

# Neutral values, what no choice asks for, and defaults change nothing.
neutral = {"Style": "view", "MemoryBudget": 0, "PaperColor": [1, 0, 0], "Outline": "Off", "ToneRange": [3, 4]}
neutral.update(InkOpacity=1, Picture="Transparent", ExtremeAngle=50, SaveName="/nowhere/a.json")
defaults = {"Display": "Combined", "Base": "Views", "Level": "Own of every pixel", "PropagateUp": "On"}
defaults.update(ClassicShares="Off", MemoryBudget=512)
for options in neutral, defaults:
    for position, wanted in ((0, 0, 3), front), (side, beside):
        assert same(draw(position=position, Manifest=both, **options), wanted), options

# What is seen of the views, and what below them.
for options, colors in (
    ({"Display": "Dependent only"}, (BLUE, WHITE)),
    ({"Display": "Independent only"}, (RED, RED)),
    ({"Base": "What lies below"}, (BLUE, WHITE)),
    ({"Base": "What lies below", "Paper": "Color", "PaperColor": [0, 1, 0]}, (BLUE, (0, 255, 0))),
):
    for position, color in zip(((0, 0, 3), side), colors):
        assert is_color(draw(position=position, Manifest=both, **options), color), (options, position)
coverage = draw("view-coverage", Manifest=both, Display="Coverage")
assert not is_color(coverage, BLUE, 40) and not is_color(coverage, RED, 40)

# Detail: as in a style file with the same numbers, and not as before.
manifest("near-and-far", painted("near", waves(), size=256), painted("far", RED, (0, 0, 40)), finestLevel=4)
manifest("coarse", painted("around", RED), painted("ahead", waves(), (0, 0, 8), 60, size=256), finestLevel=5)
for name, position, options, field in (
    ("near-and-far", (0, -3, 0.6), {"Level": "One for all"}, {"level": "one"}),
    ("near-and-far", (0, 0, 3), {"MemoryBudget": 1}, {"memoryBudget": 1}),
    ("coarse", (0, 0, 3), {"ClassicShares": "On"}, {"classicShares": True}),
):
    usual = draw(position=position, Manifest=os.path.join(folder(), name + ".json"))
    changed = draw("view-" + name, position, Manifest=os.path.join(folder(), name + ".json"), **options)
    assert scene.difference(usual, changed) > 1, (options, scene.difference(usual, changed))
    assert same(changed, draw(position=position, StyleFile=style_file(manifest=name + ".json", **field))), options
afar = manifest("afar", painted("far", RED, (0, 0, 40)), finestLevel=4)
assert is_color(draw(Manifest=afar), RED)
assert is_color(draw(Manifest=afar, PropagateUp="Off"), GREY)

# Ink, paper, tone and lines are those of Pattern.
half = style_file("half", manifest="both.json")
for options in (
    {"InkOpacity": 0.5},
    {"BlendMode": "Multiply", "Paper": "Color", "PaperColor": [1, 1, 0]},
    {"Tone": "Light"},
    {"Tone": "Constant", "ToneConstant": 0.3, "ToneGamma": 2},
    {"Tone": "Constant", "ToneRemap": "Steps"},
):
    changed = draw(Manifest=both, **options)
    assert scene.difference(front, changed) > 3, options
    assert same(changed, draw(prefix="Pattern", StyleFile=half, **options)), options
ball = simple.Sphere(ThetaResolution=32, PhiResolution=32)
assert ((draw(source=ball, Manifest=both, Outline="On") < 40).all(axis=2).sum()
        - (draw(source=ball, Manifest=both) < 40).all(axis=2).sum()) > 50

# Blocks: one texture over all of them.
halves = numpy.zeros((64, 64, 3))
halves[:, :32], halves[:, 32:] = RED, BLUE
split = manifest("split", painted("split", halves))
left, right = (simple.Sphere(Center=[x, 0, 0], Radius=0.4, ThetaResolution=32, PhiResolution=32) for x in (-0.5, 0.5))
shown = draw("view-blocks", source=simple.GroupDatasets(Input=[left, right]), Manifest=split, size=(120, 120))
for x, color in (44, RED), (76, BLUE):
    assert numpy.abs(shown[60, x].astype(int) - color).max() <= 6, (x, shown[60, x])

# A manifest that is none tells why, once, and changes nothing; without one the views of the style are seen.
with open(os.path.join(folder(), "broken.json"), "w", encoding="ascii") as file:
    file.write('{"hachureViews": 1, "views": [{"name": "a"}]}')
where = scene.view((100, 100))
display = show(where, Manifest=both)
scene.look(where, (0, 0, 3))
assert same(scene.picture(where), front)
for name, text in ("/nowhere/views.json", "/nowhere/views.json"), (os.path.join(folder(), "broken.json"), "views[0]"):
    with scene.Messages() as messages:
        display.ViewTextureManifest = name
        assert same(scene.picture(where), front), name
        display.ViewTextureInkOpacity = 1.0
        assert same(scene.picture(where), front), name
    assert messages.text.count(text) == 1, messages.text
display.ViewTextureManifest = ""
assert is_color(scene.picture(where), GREY)
display.ViewTextureStyleFile = half
assert same(scene.picture(where), front)
