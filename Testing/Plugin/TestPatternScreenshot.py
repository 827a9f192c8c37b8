# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A screenshot of three times the size shows the same strokes, and leaves the view as it was."""

import numpy
import pattern_scene as scene
from paraview import simple

SCALE = 3

where = scene.view()
scene.show(simple.Sphere(ThetaResolution=100, PhiResolution=100), where, PatternScale=1.1)
scene.look(where, (0.6, 0.5, 2.5))
small = scene.picture(where, "screenshot-1")
width, height = small.shape[1], small.shape[0]
large = scene.array(where.CaptureWindow(SCALE))
assert large.shape[:2] == (SCALE * height, SCALE * width), large.shape
assert (scene.picture(where) == small).all(), "the screenshot changed the view"


def linear(shown):
    """Light of a picture, in levels."""
    return 255.0 * (shown / 255.0) ** 2.2


boxes = linear(large).reshape(height, SCALE, width, SCALE, 3).mean(axis=(1, 3))
difference = numpy.abs(boxes - linear(small))
print("mean difference %.2f of 255" % difference.mean())
assert difference.mean() < 2.5, difference.mean()
