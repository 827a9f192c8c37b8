# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Marks stay while an isosurface of measured data sweeps through them, and do not where every surface has its own."""

import animation_scene as time
import numpy
import pattern_scene as scene
from paraview import simple

FRAMES = 6
OPTIONS = {"Tone": "Constant", "ToneConstant": 0.3, "Outline": "Off"}


def flicker(contour, prefix, **properties):
    """How far the pictures of a sweep differ from those before, of pictures that have nothing in common."""
    where = scene.view((160, 120))
    time.show(contour, where, prefix, **OPTIONS, **properties)
    scene.look(where, (0, 0, 25))
    time.clock(FRAMES, 0, FRAMES - 1)
    time.track(contour, "ContourValues", 400, 402)
    pictures = []
    for moment in (FRAMES - 1, *range(FRAMES)):
        name = "series-%s-%s-%d" % (prefix, properties.get("Life", "usual"), moment)
        pictures.append(time.picture_at(where, moment, name).astype(float)[30:90, 50:110].mean(axis=2) / 255)
    time.clock()
    simple.Delete(where)
    steps = [((a - b) ** 2).mean() for a, b in zip(pictures[1:], pictures[2:])]
    return numpy.mean(steps) / (2 * numpy.var(pictures[1]))


few = {"NumberOfPoints": 5000, "Size": 4}
for prefix, options in ("Noise", {"Style": "gabor"}), ("Stipple", few):
    disk = time.disk_contour()
    staying, jumping = flicker(disk, prefix, **options), flicker(disk, prefix, Life=0, **options)
    print(prefix, "flicker %.3f, with marks of their own %.3f" % (staying, jumping))
    assert staying < 0.1 < 0.3 < jumping, (prefix, staying, jumping)
