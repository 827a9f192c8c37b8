# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Inks and outlines that replace those of a style have the colours, mixtures and lines that they say."""

import numpy
import pattern_scene as scene
from paraview import simple

plane = simple.Plane(Origin=[-2, -2, 0], Point1=[2, -2, 0], Point2=[-2, 2, 0])
# Seen from the viewer: an open edge, a silhouette, three faces.
sheet = simple.Plane(Origin=[-0.4, -0.4, 0], Point1=[0.4, -0.4, 0], Point2=[-0.4, 0.4, 0])
ball = simple.Sphere(ThetaResolution=60, PhiResolution=60)
box = simple.Transform(Input=simple.Box(XLength=0.7, YLength=0.7, ZLength=0.7))
box.Transform.Rotate = [35, 45, 0]


def draw(source=plane, name=None, **properties):
    """A picture of the source, fully inked; the plane fills the view."""
    where = scene.view((120, 90))
    tone = {"PatternTone": "Constant", "PatternToneConstant": 1, "PatternOutline": "Off"}
    scene.show(source, where, **dict(tone, **properties))
    scene.look(where, (0, 0, 3))
    shown = scene.picture(where, name)
    simple.Delete(where)
    return shown


def color(shown):
    """The one colour of a picture."""
    assert (shown == shown[0, 0]).all()
    return [int(part) for part in shown[0, 0]]


# Green on red, mixed in the ways of printers and painters, in light, not in numbers.
mixed = {"PatternInk": "Color", "PatternInkColor": [0, 1, 0]}
mixed.update(PatternPaper="Color", PatternPaperColor=[1, 0, 0])
wanted = {"Over": [0, 255, 0], "Multiply": [0, 0, 0], "Overlay": [255, 0, 0], "Screen": [255, 255, 0]}
assert color(draw(**mixed)) == [0, 255, 0]
for mode in wanted:
    assert color(draw(PatternBlendMode=mode, **mixed)) == wanted[mode], mode
light = scene.linear(draw(PatternInkOpacity=0.5, **mixed))
assert abs(light - [0.5, 0.5, 0]).max() < 0.01, light[0, 0]

# Ink of the color of the surface is the surface where all is inked.
blue = {"DiffuseColor": [0.1, 0.3, 0.8], "PatternStyle": "hatch"}
surface = draw(ball, PatternToneConstant=0, PatternPaper="Lit surface", **blue)
assert scene.difference(surface, draw(ball, PatternInk="Surface colors", **blue)) < 0.5
# A color replaces it where a style has it.
painted = draw(PatternStyle="painterly", PatternInk="Color", PatternInkColor=[1, 0, 0])
assert painted[:, :, 0].min() > 100 and painted[:, :, 1:].max() == 0


bare = {source: draw(source, PatternToneConstant=0) for source in (ball, sheet, box)}


def lines(source, name=None, **properties):
    """Ink of lines on bare paper, in pixels: in the middle of what is drawn, and around it."""
    options = {"PatternOutline": "On", "PatternOutlineWidth": 3, "PatternToneConstant": 0}
    shown = draw(source, name, **dict(options, **properties))
    ink = (scene.linear(bare[source]) - scene.linear(shown))[:, :, 0]
    y, x = numpy.indices(ink.shape)
    inside = (x - 60) ** 2 + (y - 45) ** 2 < 14**2
    return ink[inside].sum(), ink[~inside].sum()


def kinds(*shown):
    """Properties that show these kinds of lines alone."""
    return {"PatternOutline" + kind: int(kind in shown) for kind in ("Silhouette", "Borders", "Creases")}


# A ball has a silhouette, an open sheet that faces the viewer has borders, a box has creases.
assert lines(box, PatternOutline="Off") == lines(box, **kinds()) == (0, 0)
everything = {source: lines(source) for source in (ball, sheet, box)}
assert lines(ball, **kinds("Silhouette")) == everything[ball]
assert lines(ball, **kinds("Borders"))[1] < 0.8 * everything[ball][1]
assert lines(ball, **kinds("Creases")) == (0, 0)
assert lines(sheet, **kinds("Borders")) == everything[sheet]
assert lines(sheet, **kinds("Creases")) == (0, 0)
creases, around = lines(box, "ink-creases", **kinds("Creases"))
assert creases == everything[box][0] and around < 0.5 * everything[box][1], (creases, around)
assert lines(box, **kinds("Silhouette", "Borders"))[0] < 0.6 * creases
assert lines(box, PatternOutlineCreaseAngle=100, **kinds("Creases"))[0] < 0.6 * creases
assert everything[ball][1] > 1.5 * lines(ball, PatternOutlineWidth=1.5)[1] > 100


def outline(**properties):
    """The colour of the outline of a ball of bare paper."""
    shown = draw(ball, PatternToneConstant=0, **properties)
    return [int(part) for part in shown[45, (shown[45] != 128).any(axis=1).argmax()]]


# The outline has the color of the style, that of the ink, or one of its own, which marks have not.
green = {"PatternInk": "Color", "PatternInkColor": [0, 1, 0]}
own = {"PatternOutlineInk": "Color", "PatternOutlineColor": [1, 0, 0]}
for choice in "On", "As in the style":
    assert outline(PatternOutline=choice) == [26, 26, 26]
    assert outline(PatternOutline=choice, **green) == [0, 255, 0]
    assert outline(PatternOutline=choice, **green, **own) == [255, 0, 0]
assert color(draw(**green, **own)) == [0, 255, 0]
