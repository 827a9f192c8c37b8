# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stipples stay on their places of a surface whose points move, while its cells stay."""

import numpy
import pattern_scene as scene
from paraview import simple

WIDTH, HEIGHT = 200, 100
TONE = 0.15

plane = simple.Plane(Origin=[-1, -1, 0], Point1=[1, -1, 0], Point2=[-1, 1, 0], XResolution=8, YResolution=8)
moved = simple.Transform(Input=plane)


def open_view():
    """A view in which 50 pixels are as long as 1."""
    where = scene.view((WIDTH, HEIGHT))
    options = {"StippleTone": "Constant", "StippleToneConstant": TONE, "StippleNumberOfPoints": 4000}
    scene.show(moved, where, Representation="Stipple", StippleSize=3, **options)
    scene.look(where, (0, 0, 5))
    where.CameraParallelProjection = 1
    where.CameraParallelScale = 1
    return where


def deform(shift, stretch):
    """Moves the points of the surface in x, by pixels, after it has been stretched."""
    moved.Transform.Translate = [shift / 50, 0, 0]
    moved.Transform.Scale = [stretch, 1, 1]


def dots(where, name=None):
    """Where the centres of dots are."""
    return scene.picture(where, name)[:, :, 0] < 40


def kept(before, after, shift, stretch):
    """Share of the dots before that are there after the surface has moved."""
    y, x = numpy.nonzero(before[:, 60:140])
    x = numpy.round((x + 60 + 0.5 - WIDTH / 2) * stretch + WIDTH / 2 + shift - 0.5).astype(int)
    inside = (x >= 1) & (x < WIDTH - 1)
    near = after | numpy.roll(after, 1, axis=1) | numpy.roll(after, -1, axis=1)
    return near[y[inside], x[inside]].mean()


deform(0, 1)
where = open_view()
first = dots(where, "stipple-motion-0")
by_chance = kept(first, dots(where), 7, 1)
for step, (shift, stretch) in enumerate(((20, 1), (0, 1.4), (10, 1.8), (-10, 1.2))):
    deform(shift, stretch)
    share = kept(first, dots(where, "stipple-motion-%d" % (step + 1)), shift, stretch)
    print("kept %.3f, by chance %.3f" % (share, by_chance))
    assert share > 0.95 > 2 * by_chance, (shift, stretch, share, by_chance)
deform(0, 1)
assert (dots(where) == first).all(), "the same surface, the same dots"

# One that comes stretched, and has not been another before, has dots of its own.
deform(0, 1.8)
simple.Delete(where)
share = kept(first, dots(open_view(), "stipple-motion-new"), 0, 1.8)
assert share < 2 * by_chance, (share, by_chance)
