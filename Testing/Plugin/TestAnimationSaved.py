# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A saved animation of tracked patterns is the same again, whatever was looked at, as is one that is played again."""

import os
import subprocess
import sys

import animation_scene as time
import pattern_scene as scene
from paraview import simple

FRAMES = 3
HERE = "--again"  # an argument of the second process


def open_scene():
    """Three representations of an isosurface whose value changes while a camera goes around."""
    where = scene.view((180, 60))
    contour = time.disk_contour()
    animation = time.clock(FRAMES, 0, FRAMES - 1)
    time.track(contour, "ContourValues", 400, 404)
    few = {"NumberOfPoints": 3000, "Size": 3}
    displays = {}
    for column, (prefix, options) in enumerate((("Pattern", {}), ("Noise", {"Style": "phasor"}), ("Stipple", few))):
        moved = simple.Transform(Input=contour)
        moved.Transform.Translate = [(column - 1) * 12, 0, 0]
        displays[prefix] = display = time.show(moved, where, prefix, **options)
        time.track(display, prefix + "ToneGamma", 0.6, 1.2)
    time.orbit(where, 25, quarters=1)
    scene.look(where, (0, 0, 25))
    return where, displays


def read(name):
    """What is in the files of a saved animation."""
    frames = []
    for frame in range(FRAMES):
        with open(os.path.join(scene.output_folder, "%s.%04d.png" % (name, frame)), "rb") as file:
            frames.append(file.read())
    return frames


def save(where, displays, name):
    """Files of a saved animation, and what is in them."""
    for prefix, display in displays.items():
        display.InvokeCommand(prefix + "Reanchor")
    file_name = os.path.join(scene.output_folder, name + ".png")
    simple.SaveAnimation(file_name, where, ImageResolution=list(where.ViewSize))
    return read(name)


def equal(first, second):
    """Whether all frames are, byte by byte."""
    return len(first) == len(second) and all(a == b for a, b in zip(first, second))


def play(where):
    """Pictures while the animation is played in its order."""
    return [time.picture_at(where, moment) for moment in range(FRAMES)]


def check(where, displays, other):
    """The same twice, and in another process."""
    first = save(where, displays, "saved-first")
    assert len(set(first)) == FRAMES, "frames that are alike"

    # The user plays, scrubs and looks from elsewhere. After its last time an animation begins anew.
    time.picture_at(where, FRAMES - 1)
    played = [play(where) for _ in range(2)]
    for moment in 2, 1, 0:
        time.picture_at(where, moment)
    scene.look(where, (8, 9, 30))
    scene.picture(where)
    assert equal(first, save(where, displays, "saved-second"))
    assert [(a == b).all() for a, b in zip(*played)] == [True] * FRAMES
    assert other.wait(120) == 0
    assert equal(first, read("saved-process"))


if HERE in sys.argv:
    save(*open_scene(), "saved-process")
else:
    with subprocess.Popen(["pvbatch", *sys.argv, HERE, "1"]) as process:
        check(*open_scene(), process)
