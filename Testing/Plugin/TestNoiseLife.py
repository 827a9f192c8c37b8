# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Marks of noise stay and fade while the value of an isosurface changes, and with Life 0 they do not."""

import numpy
import pattern_scene as scene
from paraview import simple

FRAMES = 8

wavelet = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
surface = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], ComputeScalars=0)


def flicker(life):
    """How far the pictures of a sweep differ from those before, of pictures that have nothing in common."""
    where = scene.view((160, 120))
    options = {"NoiseTone": "Constant", "NoiseToneConstant": 0.5, "NoiseOutline": "Off", "NoiseStyle": "gabor"}
    surface.Isosurfaces = [150.0]
    scene.show(surface, where, Representation="Noise", NoiseLife=life, **options)
    scene.look(where, (0, 0, 60))
    pictures = []
    for frame in range(FRAMES):
        surface.Isosurfaces = [150.0 + 0.2 * frame]
        pictures.append(scene.picture(where, f"noise-life-{life}-{frame}").astype(float).mean(axis=2) / 255)
    inside = numpy.abs(pictures[0] - 1) > 0
    simple.Delete(where)
    steps = [((a - b)[inside] ** 2).mean() for a, b in zip(pictures, pictures[1:])]
    return numpy.mean(steps) / (2 * numpy.var(pictures[0][inside]))


staying, jumping = flicker(-1), flicker(0)
print("flicker", staying, jumping)
assert staying < 0.25, staying
assert jumping > 0.6, jumping
