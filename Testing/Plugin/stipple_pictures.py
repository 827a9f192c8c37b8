# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the representation Stipple share: its pictures, of a plane as a rule, and what counts in them."""

import json
import os
import sys

import numpy
import pattern_scene as scene
from paraview import simple

STYLE_FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Rendering/Presets/stipple.json")
TONE = 0.4

plane = simple.Plane(Origin=[-1, -1, 0], Point1=[1, -1, 0], Point2=[-1, 1, 0])
across = simple.Elevation(Input=plane, LowPoint=[-1, 0, 0], HighPoint=[1, 0, 0])
BY_ARRAY = {"source": across, "Tone": "Array", "ToneArray": ["POINTS", "Elevation"]}


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
    test = os.path.splitext(os.path.basename(sys.argv[0]))[0]
    name = os.path.join(scene.output_folder, test + ".json")
    with open(name, "w", encoding="ascii") as file:
        json.dump(style, file)
    return name
