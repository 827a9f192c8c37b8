#!/usr/bin/env python3
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the standard scenes with every field and measures how the patterns move.

Writes DIR/quality.json, a list of {scene, motion, field, ink, lighting, metric, value} with null for
values that are not defined, and DIR/quality.html. Metrics are those of vtkPatternMetrics. The package
hachure must be on PYTHONPATH. --reduced draws few clips, for tests; --scene, --motion, --field, --ink
and --lighting, which may be repeated, choose from the lists in scenes.py.
"""

import argparse
import itertools
import json
import math
import os
import sys

SYSTEM_PYTHON = "/usr/bin/python3"
FOLDER = os.path.dirname(os.path.abspath(__file__))
SIZE = 320
FRAMES, FRAMES_REDUCED = 16, 12
AXES = ("scene", "motion", "field", "ink", "lighting")
REDUCED = {"scene": ["sphere"], "motion": ["translate", "zoom", "roll"], "ink": ["noise"],
           "lighting": ["unlit"]}
# Strokes tell little more than noise: scenes that show them all the same.
STROKE_SCENES = ("sphere", "skull")


def find_vtk():
    """Starts again with the system's Python when this one has no VTK, or below a virtual display."""
    try:
        import vtkmodules.vtkCommonCore  # noqa: F401
    except ImportError:
        if os.path.realpath(sys.executable) == os.path.realpath(SYSTEM_PYTHON):
            raise SystemExit("report.py: this Python has no VTK; install python3-vtk9")
        os.execv(SYSTEM_PYTHON, [SYSTEM_PYTHON, *sys.argv])
    if not os.environ.get("DISPLAY"):
        script = os.path.join(FOLDER, "..", "with_display.sh")
        os.execv(script, [script, sys.executable, *sys.argv])
    try:
        import hachure  # noqa: F401
    except ImportError as error:
        raise SystemExit("report.py: %s; put the package of the build on PYTHONPATH" % error)


def draw_clip(studio, filmed, key):
    """One clip: its names, values, steps and pictures for the page."""
    import clips
    import page
    import scenes
    style = scenes.new_style(key["field"], key["ink"], key["lighting"])
    frames = studio.inks(filmed["states"], filmed["cameras"], style)
    motions = filmed["motions"]
    tone = scenes.TONE if key["lighting"] == "unlit" else None
    values, steps = clips.measure(frames, motions, filmed["cells"], studio.reference(key["ink"]), tone,
                                  key["ink"] in scenes.STROKES)
    return {**key, "values": values, "steps": steps,
            "frames": page.strip(frames, "ink"),
            "differences": page.strip(clips.differences(frames, motions), "difference")}


def slide_ratio(values):
    """In every direction, or across the strokes."""
    return values.get("SlideRatio", values["NormalSlideRatio"])


def film(studio, scene, surfaces, motion, frames):
    """What all clips of a scene and a motion share; None where the scene does not move like this."""
    import scenes
    path = scenes.path(scene, motion, surfaces, frames)
    if path is None:
        return None
    states, cameras = path
    return {"states": states, "cameras": cameras, "motions": studio.motions(states, cameras),
            "cells": studio.cells(surfaces, states, cameras)}


def draw(chosen, frames):
    """All clips of the chosen scenes, motions, fields, inks and lightings."""
    import scenes
    from studio import Studio
    studio = Studio(SIZE)
    result = []
    for scene in chosen["scene"]:
        surfaces = scenes.SCENES[scene]()
        inks = [ink for ink in chosen["ink"] if ink not in scenes.STROKES or scene in STROKE_SCENES]
        for motion in chosen["motion"]:
            filmed = film(studio, scene, surfaces, motion, frames)
            names = itertools.product(chosen["field"], inks, chosen["lighting"]) if filmed else ()
            for name in names:
                key = dict(zip(AXES, (scene, motion, *name)))
                result.append(draw_clip(studio, filmed, key))
                print(*key.values(), "slide ratio %.4f" % slide_ratio(result[-1]["values"]),
                      sep=", ", flush=True)
    return result


def rows(clips):
    """The clips as the rows of quality.json."""
    return [{**{axis: clip[axis] for axis in AXES}, "metric": metric,
             "value": value if math.isfinite(value) else None}
            for clip in clips for metric, value in clip["values"].items()]


def choices():
    import scenes
    lists = (scenes.SCENES, scenes.MOTIONS, scenes.FIELDS, scenes.INKS, scenes.LIGHTINGS)
    return {axis: list(names) for axis, names in zip(AXES, lists)}


def arguments(known):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", required=True, metavar="DIR", help="folder to write to")
    parser.add_argument("--reduced", action="store_true", help="few clips, for tests")
    for axis in AXES:
        parser.add_argument("--" + axis, action="append", choices=known[axis])
    return parser.parse_args()


EXPLANATION = (
    "Slide ratio: how far the pattern slides over the surface / how far the surface moves; 0 is fixed on "
    "the surface, 1 fixed in the image. For noise it holds all directions, for strokes only the one "
    "across them. Boil: what is left of the change from frame to frame after the best slide.",
    "Strips show some pictures at half the size. Differences: a frame and the next one, moved back along "
    "the exact motion of the surface; white where a pattern sticks to it.",
)


def main():
    find_vtk()
    sys.path[:0] = [FOLDER, os.path.dirname(FOLDER)]
    import page
    known = choices()
    options = arguments(known)
    default = {**known, **REDUCED} if options.reduced else known
    chosen = {axis: getattr(options, axis) or default[axis] for axis in AXES}
    os.makedirs(options.out, exist_ok=True)
    clips = draw(chosen, FRAMES_REDUCED if options.reduced else FRAMES)
    if not clips:
        raise SystemExit("report.py: none of these scenes has one of these motions and inks")
    with open(os.path.join(options.out, "quality.json"), "w", encoding="utf-8") as file:
        json.dump(rows(clips), file, indent=1, allow_nan=False)
    with open(os.path.join(options.out, "quality.html"), "w", encoding="utf-8") as file:
        file.write(page.page(clips, EXPLANATION))


if __name__ == "__main__":
    main()
