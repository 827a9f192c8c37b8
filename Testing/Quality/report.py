#!/usr/bin/env python3
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the standard scenes with every field and measures how the patterns move.

Writes DIR/quality.json, a list of {scene, motion, field, ink, lighting, metric, value} with null for
values that are not defined, and DIR/quality.html. Metrics are those of vtkPatternMetrics. The package
hachure must be on PYTHONPATH. --reduced draws few clips, for tests; --scene, --motion, --field, --ink
and --lighting, which may be repeated, choose from the lists in scenes.py, with --reduced from the few.
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
FRAMES, FRAMES_REDUCED = 16, 7
AXES = ("scene", "motion", "field", "ink", "lighting")
FLAT_NOISE = {"ink": ["noise"], "lighting": ["unlit"]}
STIPPLES = {"field": ["stipple", "stipple size"], "ink": ["stipple"], "lighting": ["unlit"]}
REDUCED = (
    {"scene": ["sphere"], "motion": ["translate", "rotate", "zoom"],
     "field": ["screen", "texture", "solid", "similarity"], **FLAT_NOISE},
    {"scene": ["sphere"], "motion": ["roll"], "field": ["screen", "texture", "similarity"], **FLAT_NOISE},
    {"scene": ["sphere"], "motion": ["octave"], "field": ["similarity", "spread"], **FLAT_NOISE},
    {"scene": ["sphere"], "motion": ["slow octave"], "field": ["similarity"], **FLAT_NOISE},
    {"scene": ["plane"], "motion": ["approach"], "field": ["similarity"], **FLAT_NOISE},
    {"scene": ["ellipsoid"], "motion": ["rotate"], "field": ["similarity", "patches"], **FLAT_NOISE},
    {"scene": ["sphere"], "motion": ["translate", "rotate", "zoom", "roll"],
     "field": ["gabor", "calm", "phasor", "spot"], **FLAT_NOISE},
    {"scene": ["ellipsoid"], "motion": ["translate", "rotate", "zoom"], "field": ["calm"], **FLAT_NOISE},
    {"scene": ["plane"], "motion": ["translate", "rotate", "zoom", "roll"], "field": ["gabor"], **FLAT_NOISE},
    {"scene": ["protein"], "motion": ["deform"], "field": ["gabor", "phasor", "spot"], **FLAT_NOISE},
    {"scene": ["sphere"], "motion": ["translate", "rotate", "zoom", "roll"], **STIPPLES},
    {"scene": ["sphere"], "motion": ["light"], **STIPPLES, "lighting": ["lit"]},
    {"scene": ["plane"], "motion": ["rotate", "zoom", "approach"], **STIPPLES, "field": ["stipple"]},
    {"scene": ["sphere"], "motion": ["octave"], **STIPPLES, "field": ["stipple"]},
    {"scene": ["protein"], "motion": ["deform"], **STIPPLES, "field": ["stipple"]},
    {"scene": ["sphere"], "motion": ["rotate", "zoom"], "field": ["view fade"], **FLAT_NOISE},
)
# Strokes tell little more than noise: scenes that show them all the same.
STROKE_SCENES = ("sphere", "skull")


def find_vtk():
    """Starts again with the system's Python when this one has no VTK, or below a virtual display."""
    os.environ.setdefault("OMP_WAIT_POLICY", "passive")  # threads that wait do not take a core
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


def style_of(studio, filmed, key):
    import scenes
    import views
    if key["field"] not in scenes.PAINTED:
        return scenes.new_style(key["field"], key["ink"], key["lighting"])
    return views.style_of(studio, filmed["states"][0], scenes.PAINTED[key["field"]])


def draw_clip(studio, filmed, key):
    """One clip: its names, values, steps and pictures for the page."""
    import clips
    import pictures
    import scenes
    style = style_of(studio, filmed, key)
    states = scenes.prepared(key["field"], filmed["states"])
    frames = studio.inks(states, filmed["cameras"], style, filmed["lights"])
    motions = filmed["motions"]
    tone = scenes.TONE if key["lighting"] == "unlit" else None
    metrics = clips.new_metrics(frames, motions, filmed["cells"], studio.reference(key["field"], key["ink"]), tone)
    fast = key["motion"] in scenes.FAST
    values, steps = clips.measure(metrics, motions, key["ink"] in scenes.STROKES, fast)
    differences = clips.differences(frames, motions)
    return {**key, "values": values, "frames": pictures.strip(frames, "ink", fast),
            "differences": pictures.strip(differences, "difference", fast),
            "steps": steps}


def film(studio, scene, surfaces, motion, frames):
    """What all clips of a scene and a motion share; None where the scene does not move like this."""
    import scenes
    path = scenes.path(scene, motion, surfaces, frames)
    if path is None:
        return None
    states, cameras = path
    return {"states": states, "cameras": cameras, "lights": scenes.lights(motion, len(cameras)),
            "motions": studio.motions(states, cameras), "cells": studio.cells(surfaces, states, cameras)}


def surfaces_of(scene, needed):
    """The surfaces of a scene; None, and a message, where its data are not there and not needed."""
    import objects
    import scenes
    try:
        return scenes.SCENES[scene]()
    except objects.Missing as problem:
        message = "report.py: scene %s: %s" % (scene, problem)
        if needed:
            raise SystemExit(message) from None
        print(message + "; left out", file=sys.stderr)
        return None


def names_of(scene, motion, chosen):
    """The fields, inks and lightings that there are clips of, for a scene and a motion."""
    import scenes
    lightings = [name for name in chosen["lighting"] if motion not in scenes.LIGHTS or name == "lit"]
    for field in chosen["field"]:
        painted = field in scenes.PAINTED
        if painted and scene not in scenes.PAINTED_SCENES:
            continue
        inks = [ink for ink in chosen["ink"] if ink in scenes.inks_of(field)]
        if scene not in STROKE_SCENES:
            inks = [ink for ink in inks if ink not in scenes.STROKES]
        # Painted ones have the light of their pictures.
        shown = [lighting for lighting in lightings if lighting == "unlit" or not painted]
        yield from itertools.product((field,), inks, shown)


def draw(studio, chosen, frames, needed=()):
    """The clips of the chosen scenes, motions, fields, inks and lightings, a list for each scene."""
    import scenes
    for scene in chosen["scene"]:
        surfaces = surfaces_of(scene, scene in needed)
        if surfaces is None:
            continue
        result = []
        for motion in chosen["motion"]:
            names = list(names_of(scene, motion, chosen))
            filmed = film(studio, scene, surfaces, motion, frames) if names else None
            for name in names if filmed else ():
                key = dict(zip(AXES, (scene, motion, *name)))
                result.append(draw_clip(studio, filmed, key))
                print(*key.values(), "%s %.4f" % next(iter(result[-1]["values"].items())), sep=", ",
                      flush=True)
        yield result


def rows(clips):
    """The clips as the rows of quality.json."""
    return [{**{axis: clip[axis] for axis in AXES}, "metric": metric,
             "value": value if math.isfinite(value) else None}
            for clip in clips for metric, value in clip["values"].items()]


def choices():
    import scenes
    fields = [*scenes.FIELDS, *scenes.MAKERS, *scenes.PAINTED]
    lists = (scenes.SCENES, scenes.MOTIONS, fields, scenes.INKS, scenes.LIGHTINGS)
    return {axis: list(names) for axis, names in zip(AXES, lists)}


def arguments(known):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", required=True, metavar="DIR", help="folder to write to")
    parser.add_argument("--reduced", action="store_true", help="few clips, for tests")
    for axis in AXES:
        parser.add_argument("--" + axis, action="append", choices=known[axis])
    return parser.parse_args()


# Paragraphs, and terms with what they mean.
EXPLANATION = (
    "Every clip is a scene, a motion, and a field, which says how the pattern moves:",
    ("screen", "fixed in the image, the shower door"),
    ("texture", "on the surface, by places of the model"),
    ("solid", "the same, but the size of its marks follows the distance (dynamic solid texture)"),
    ("similarity", "carried by the similarity of the plane that fits the motion of the surface best "
     "(dynamic 2D pattern)"),
    ("spread", "the same, with marks that give way to those of half the size over a whole octave of growth"),
    ("patches", "similarity for every part of the surface, divided automatically, blended across borders"),
    ("gabor", "kernels at points of the surface, of one size in the image (NPR Gabor noise)"),
    ("calm", "the same, with wider and softer marks that come and go more slowly"),
    ("phasor", "the phase of such kernels: lines of even contrast"),
    ("spot", "a picture of a fibre in place of the kernel"),
    ("stipple", "dots at points of the surface, the more the darker (frame-coherent stippling)"),
    ("stipple size", "larger dots, which grow with the tone"),
    ("view", "pictures of the field texture from twelve sides, put together on the surface (view-dependent "
     "texture), for all cameras and, before them, for those nearby"),
    ("view fade", "the same, with another noise from every side for the cameras nearby"),
    "People ranked such methods by how well patterns move with the surface: texture mapping and solid "
    "textures first, then dynamic 2D patterns and bidirectional advection, then the shower door (Benard "
    "et al. 2010, section 5). The slide ratio should rank them likewise; bidirectional advection is not "
    "implemented. What moves well may look like a surface instead of paper: see the two slopes.",
    "Green marks the best of a row. Frames are played at half the size. Differences are between a frame "
    "and the next one, moved back along the exact motion of the surface: white where the pattern sticks "
    "to the surface, black where ink comes or goes. Curves of a motion have one scale. Unlit clips ask "
    "for an even tone of one half; in lit ones contrast, co-occurrence and the slopes also hold the shading, "
    "so that only a comparison with the screen tells something.",
    "Where the model itself deforms, texture and solid slide, for want of texture coordinates. A zoom "
    "covers less than an octave, within which all marks but those of the screen grow with the surface; "
    "the motions octave and slow octave cover one, with the change from marks to those of half the size, "
    "and approach, too fast to tell slides, three.",
)


def write(clips, folder):
    import page
    with open(os.path.join(folder, "quality.json"), "w", encoding="utf-8") as file:
        json.dump(rows(clips), file, indent=1, allow_nan=False)
    with open(os.path.join(folder, "quality.html"), "w", encoding="utf-8") as file:
        file.write(page.page(clips, EXPLANATION))


def main():
    find_vtk()
    sys.path[:0] = [FOLDER, os.path.dirname(FOLDER)]
    from studio import Studio
    known = choices()
    options = arguments(known)
    os.makedirs(options.out, exist_ok=True)
    studio = Studio(SIZE)
    clips = []
    for part in REDUCED if options.reduced else ({},):
        chosen = {axis: [name for name in part.get(axis, known[axis])
                         if name in (getattr(options, axis) or known[axis])] for axis in AXES}
        for of_scene in draw(studio, chosen, FRAMES_REDUCED if options.reduced else FRAMES,
                             options.scene or ()):
            clips += of_scene
            if of_scene:
                write(clips, options.out)
    if not clips:
        raise SystemExit("report.py: none of these scenes has one of these motions and inks")


if __name__ == "__main__":
    main()
