# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stipples have the ink of the tone; ink, paper, tone and lines are those of Pattern; the other styles."""

import numpy
import pattern_scene as scene
from paraview import simple
from stipple_pictures import BY_ARRAY, draw, few, ink, same, style_file

ball = simple.Sphere(ThetaResolution=16, PhiResolution=16)

# Ink is the tone: an even one, and one that an array brings, from paper to full ink.
for tone in 0, 0.05, 0.2, 0.4, 0.7, 1:
    drawn = ink(few("stipple-tone-%g" % tone, 15000, ToneConstant=tone))
    assert abs(drawn - tone) < 0.04, (tone, drawn)
by_carrier = [numpy.array_split(few("stipple-by-" + carrier, 30000, Carrier=carrier, **BY_ARRAY), 6, axis=1)
              for carrier in ("Density", "Size")]
wide = 2 * 2.2 * numpy.tan(numpy.radians(15)) * 120 / 90
for stripes in by_carrier:
    for part, stripe in enumerate(stripes):
        tone = 0.5 + ((part + 0.5) / 6 - 0.5) * wide / 2
        assert abs(ink(stripe) - tone) < 0.06, (part, tone, ink(stripe))

# What is light has few dots, which are black, or many small ones.
many, small = ((stripes[0] < 30).mean() for stripes in by_carrier)
assert many > 3 * small, (many, small)

# Ink, paper, tone and lines are those of Pattern.
basic = few()
file_name = style_file(numberOfPoints=5000)
shared = [{"Ink": "Color", "InkColor": [1, 0, 0]}, {"InkOpacity": 0.5}, {"BlendMode": "Screen"}]
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
