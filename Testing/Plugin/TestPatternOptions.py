# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Options that replace parts of a style in all layers do what they say."""

import pattern_scene as scene
from paraview import simple

plane = simple.Plane(Origin=[-2, -2, 0], Point1=[2, -2, 0], Point2=[-2, 2, 0])
flat = simple.Calculator(Input=plane, ResultArrayName="tone", Function="0.3")
tone = {"PatternTone": "Array", "PatternToneArray": ["POINTS", "tone"], "PatternOutline": "Off"}


def draw(positions=((0, 0, 3),), name=None, **properties):
    """Pictures of a plane of even tone from positions, one after the other; it fills the view."""
    where = scene.view((120, 90))
    scene.show(flat, where, PatternToneRange=[0, 1], **tone, **properties)
    shown = []
    for x, y, z in positions:
        scene.look(where, (x, y, z), (x, y, 0))
        shown.append(scene.picture(where, name))
    simple.Delete(where)
    return shown


def same(first, second):
    """Whether the last pictures are equal."""
    return (first[-1] == second[-1]).all()


for style in "hatch", "halftone":
    assert same(draw(PatternStyle=style), draw(PatternStyle=style, PatternToneCorrection="Full"))
    assert not same(draw(PatternStyle=style), draw(PatternStyle=style, PatternToneCorrection="None")), style

# More strokes of less width for the same tone.
thick = draw(name="options-thick", PatternStyle="hatch")[0]
thin = draw(name="options-thin", PatternStyle="hatch", PatternDensities=3)[0]
assert (thick == draw(PatternStyle="hatch", PatternDensities=1)[0]).all()
assert abs(thick.astype(float).mean() - thin.astype(float).mean()) < 12, (thick.mean(), thin.mean())
assert scene.difference(thick, thin) > 10

# Grain: only where it is asked for, more of it with more contrast, and none where it is switched off.
assert same([thick], draw(PatternStyle="hatch", PatternPaperContrast=1))
assert same([thick], draw(PatternStyle="hatch", PatternPaperGrain="Off"))
grain = [
    draw(PatternStyle="hatch", PatternPaperGrain="On", PatternPaperContrast=contrast)[0]
    for contrast in (0.3, 0.8)
]
assert 1 < scene.difference(thick, grain[0]) < scene.difference(thick, grain[1])
rough = draw(PatternStyle="paper")
assert scene.difference(rough[0], draw(PatternStyle="paper", PatternPaperGrain="Off")[0]) > 1

# Half-way between two sizes strokes fade and dots change their shape, unless told otherwise.
zoom = [(0, 0, 3 / scale) for scale in (1.0, 1.25, 1.5)]
for style, natural, other in (
    ("hatch", "Cross-fade", "Blend screens"),
    ("halftone", "Blend screens", "Cross-fade"),
):
    usual = draw(zoom, PatternStyle=style)
    assert same(usual, draw(zoom, PatternStyle=style, PatternTransition=natural)), style
    assert scene.difference(usual[-1], draw(zoom, PatternStyle=style, PatternTransition=other)[-1]) > 1, style

# The pace: even unless told otherwise. A transition that takes a time has not begun at one and a half,
# and in a view that changes while the time stands still it is never half way.
usual = draw(zoom, PatternStyle="hatch")
assert same(usual, draw(zoom, PatternStyle="hatch", PatternPace="Even"))
assert scene.difference(usual[-1], draw(zoom, PatternStyle="hatch", PatternPace="Classic")[-1]) > 0
assert scene.difference(usual[-1], draw(zoom, PatternStyle="hatch", PatternTransitionTime=1.0)[-1]) > 1
