# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sources and curves of tone that replace those of a style put as much ink where they say."""

import numpy
import pattern_scene as scene
from paraview import simple

plane = simple.Plane(Origin=[-2, -2, 0], Point1=[2, -2, 0], Point2=[-2, 2, 0])
flat = simple.Calculator(Input=plane, ResultArrayName="tone", Function="0.3")
ball = simple.Sphere(ThetaResolution=60, PhiResolution=60, Radius=0.7)
style = {"PatternStyle": "halftone", "PatternOutline": "Off"}
array = {"PatternTone": "Array", "PatternToneArray": ["POINTS", "tone"], "PatternToneRange": [0, 1]}


def draw(source=flat, name=None, right=False, **properties):
    """A picture of a plane that fills the view, or of a ball, with a light from the right as well."""
    where = scene.view((120, 90))
    if right:
        light = simple.AddLight(view=where)
        light.Coords = "Camera"
        light.Position = [1.0, 0.0, 0.0]
        light.FocalPoint = [0.0, 0.0, 0.0]
    scene.show(source, where, **dict(style, **properties))
    scene.look(where, (0, 0, 3))
    shown = scene.picture(where, name)
    simple.Delete(where)
    return shown


def ink(shown):
    """Mean coverage with black ink on white paper."""
    return 1 - scene.linear(shown).mean()


def check(wanted, **properties):
    """The ink of a plane with these properties."""
    found = ink(draw(**properties))
    assert abs(found - wanted) < 0.02, (wanted, found, properties)


# The tone of the array is 0.3: inverted, then raised to a power, then stepped.
check(0.3, **array)
check(0.3, PatternToneInvert="Off", PatternToneRemap="None", PatternToneSteps=2, **array)
check(0.7, PatternToneInvert="On", **array)
check(0.3**2, PatternToneGamma=2, **array)
check(0.7**0.5, PatternToneInvert="On", PatternToneGamma=0.5, **array)
for steps, wanted in (3, 0), (4, 1 / 3), (5, 0.25):
    check(wanted, PatternToneRemap="Steps", PatternToneSteps=steps, **array)
for limits, wanted in ([0.25, 0.75], 0.028), ([0.1, 0.5], 0.5), ([0.4, 0], 0.15625):
    check(wanted, PatternToneRemap="Smooth step", PatternToneRemapRange=limits, **array)

# Even tones, whatever the light.
for constant in 0.2, 0.8:
    check(constant, PatternTone="Constant", PatternToneConstant=constant)
bare = draw(ball, PatternTone="Constant", PatternToneConstant=0)

# Light from the viewer falls on the whole plane. A tone by color is that of the color.
grey = {"DiffuseColor": [0.6, 0.6, 0.6]}
check(0, PatternTone="Light", **grey)
check(0.4, PatternTone="Surface color", **grey)


def shares(shown):
    """Coverage of the ball with ink: its left, its middle and its right."""
    coverage = 1 - scene.linear(shown[35:55, :, 0])
    return [coverage[:, column : column + 14].mean() for column in (24, 53, 82)]


# Of two lights, from the viewer and from the right, each leaves other parts in the dark.
left, middle, right = shares(draw(ball, "tone-first-light", True, PatternTone="One light"))
assert abs(left - right) < 0.05 and middle < 0.05 < left, (left, middle, right)
second = draw(ball, "tone-second-light", True, PatternTone="One light", PatternToneLight=1)
left, middle, right = shares(second)
assert left > 0.95 and middle - right > 0.5, (left, middle, right)
with scene.Messages() as messages:
    draw(ball, PatternTone="One light", PatternToneLight=7)
assert messages.text.count("tone from light 7: the renderer has 1") == 1, messages.text

# Highlights mirror the light: that of the viewer in the middle, the other half-way to the right.
shine = {"PatternTone": "Highlight", "PatternHighlightPower": 10}
first = draw(ball, "tone-highlight", True, PatternHighlightLight=0, **shine)
second = draw(ball, None, True, PatternHighlightLight=1, **shine)
both = draw(ball, None, True, **shine)
left, middle, right = shares(first)
assert middle > 0.5 and abs(left - right) < 0.05 and left < 0.1, (left, middle, right)
left, middle, right = shares(second)
assert right > 0.3 and left < 0.01, (left, middle, right)
assert ink(both) > max(ink(first), ink(second)) + 0.01
small = draw(ball, PatternTone="Highlight", PatternHighlightPower=40)
assert 0 < ink(small) - ink(bare) < 0.5 * (ink(first) - ink(bare)), (ink(small), ink(first))
own = draw(ball, PatternTone="Highlight", SpecularPower=40)
assert (own == small).all(), "the power is not that of the surface"

# A print of a dark grey: with black ink alone, or with three inks that make it together.
printed = {"PatternStyle": "cmyk", "DiffuseColor": [0.5, 0.5, 0.5]}


def hues(shown):
    """Share of pixels with a colour."""
    return (shown.max(axis=2).astype(int) - shown.min(axis=2) > 40).mean()


black = draw(**printed)
inks = draw(name="tone-three-inks", PatternBlackGeneration=0, **printed)
assert hues(black) == 0 and hues(inks) > 0.3, (hues(black), hues(inks))
