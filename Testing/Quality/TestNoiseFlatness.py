# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Noise looks flat: its frequency follows neither the tilt nor the distance of the surface.

One picture shows few marks of every tilt, so that its slope scatters by 0.06 on a ball and by 0.12 on
an ellipsoid; what is held to a bound is the mean over seeds.
"""

import os
import sys

import numpy

FOLDER = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [FOLDER, os.path.dirname(FOLDER)]

import clips  # noqa: E402
import scenes  # noqa: E402
from studio import Studio  # noqa: E402

FIELD, INK = "calm", "noise"
SLOPE = 0.05  # largest growth of frequency with 1 / n.v, and with distance


def slopes(size, scene, motion, metric, seeds, frames):
    """The slope of a clip for every seed."""
    studio = Studio(size)
    surfaces = scenes.SCENES[scene]()
    states, cameras = scenes.path(scene, motion, surfaces, frames)
    motions = studio.motions(states, cameras)
    cells = studio.cells(surfaces, states, cameras)
    result = []
    for seed in seeds:
        style = scenes.new_style(FIELD, INK, "unlit")
        style.GetLayer(0).SetSeed(seed)
        pictures = studio.inks(states, cameras, style)
        metrics = clips.new_metrics(pictures, motions, cells, studio.reference(FIELD, INK), scenes.TONE)
        found = clips.measure(metrics, motions, False, motion in scenes.FAST)[0]
        result.append(found[metric])
    return numpy.array(result)


for size, scene, motion, metric, count, frames in (
        (640, "sphere", "translate", "FacingSlope", 16, 2),
        (640, "ellipsoid", "translate", "FacingSlope", 16, 2),
        (320, "plane", "approach", "DistanceSlope", 2, 13)):
    found = slopes(size, scene, motion, metric, range(1, count + 1), frames)
    print(scene, metric, "mean", found.mean(), "deviation", found.std())
    assert abs(found.mean()) <= SLOPE, (scene, metric, found)
