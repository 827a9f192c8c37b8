# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Key frames move camera, lights, actor and style; wrong files name what is wrong."""

import json

import numpy

from rendering_program import draw, fresh_folder, ink, picture, refused, write_sphere

SIZE = ("--size", "120x120", "--supersample", "1")


def write(name, **content):
    with open(name, "w", encoding="ascii") as out:
        json.dump({"hachureAnimation": 1, **content}, out)


def frames(name, *options):
    """Draws an animation and returns its pictures."""
    done = draw("sphere.vtp", "--animation", name, "--output", name + ".d", *SIZE, *options)
    count = int(done.stderr.split("frames in")[0].split()[-1])
    return [picture(f"{name}.d/frame_{i:04d}.png") for i in range(count)]


def middle(pixels):
    """Column and row of the drawing's centre."""
    rows, columns = numpy.nonzero((pixels < 0.9).any(axis=2))
    return 0.5 * (columns.min() + columns.max()), 0.5 * (rows.min() + rows.max())


def refuse(message, text=None, **content):
    with open("wrong.json", "w", encoding="ascii") as out:
        out.write(text or json.dumps({"hachureAnimation": 1, **content}))
    refused("cannot ", "sphere.vtp", "--animation", "wrong.json", "--output", "no", *SIZE)
    refused(message, "sphere.vtp", "--animation", "wrong.json", "--output", "no", *SIZE)


fresh_folder()
write_sphere("sphere.vtp")
STILL = [{"time": 0, "azimuth": 0, "elevation": 0, "zoom": 0.5}]

# 3 keys over 1 s at 4 frames per second, straight lines between: 5 frames, and the sphere moves
# right by equal steps. Camera, look and light stay.
write("move.json", frameRate=4, interpolation="linear", camera=STILL,
      actor=[{"time": 0, "position": [-0.5, 0, 0]}, {"time": 0.5}, {"time": 1,
             "position": [0.5, 0, 0]}])
places = [middle(one) for one in frames("move.json", "--movie")]
assert len(places) == 5
steps = numpy.diff([place[0] for place in places])
assert (abs(steps - steps.mean()) < 1.01).all() and steps.mean() > 5, steps
assert abs(places[2][0] - 59.5) < 1.01 and abs(places[2][1] - 59.5) < 1.01, places

# The light turns from left to right; the turntable camera zooms by equal factors.
write("light.json", frameRate=2, interpolation="linear",
      camera=[{"time": 0, "zoom": 0.25}, {"time": 1, "zoom": 1}],
      lights=[[{"time": 0, "azimuth": -80, "elevation": 0}, {"time": 1, "azimuth": 80,
                                                             "elevation": 0}]])
lit = frames("light.json")
assert ink(lit[0][:, 60:]) > ink(lit[0][:, :60]) and ink(lit[2][:, 60:]) < ink(lit[2][:, :60])
widths = [numpy.ptp(numpy.nonzero((one < 0.9).any(axis=2))[1]) + 1 for one in lit]
assert abs(widths[1] / widths[0] - 2) < 0.15 and abs(widths[2] / widths[1] - 2) < 0.15, widths

# An absolute camera from behind, held by a single key; the duration is stated.
write("camera.json", frameRate=1, duration=1,
      camera=[{"time": 0, "position": [0, 0, -20], "focalPoint": [0.5, 0, 0]}])
held = frames("camera.json")
assert len(held) == 2 and (held[0] == held[1]).all()
assert middle(held[0])[0] > 62

# Style parameters by the names of the style file.
write("style.json", frameRate=1, interpolation="linear", camera=STILL,
      style=[{"time": 0, "layers[0].ink.color": "#000000", "layers[0].tone.gamma": 0.2,
              "paper.color": "#ffffff"}, {"time": 1, "layers[0].tone.gamma": 5}])
styled = frames("style.json", "--style", "hatch")
assert ink(styled[0]) > 1.3 * ink(styled[1]), (ink(styled[0]), ink(styled[1]))

refused("cannot read 'none.json'", "sphere.vtp", "--animation", "none.json", "--output", "no")
refuse("cannot read 'wrong.json': * Line 1", text="{")
refuse("hachureAnimation: expected 1", hachureAnimation=2)
refuse("cameras: unknown key", cameras=[])
refuse("frameRate: 0 is outside", frameRate=0)
refuse("frameRate: expected a whole number", frameRate=23.97)
refuse("interpolation: expected", interpolation="smooth")
refuse("camera: expected a list", camera={})
refuse("camera[0].time: expected a number", camera=[{"zoom": 2}])
refuse("camera[1].time: times must grow", camera=[{"time": 1}, {"time": 1}])
refuse("camera[0].tilt: unknown key", camera=[{"time": 0, "tilt": 2}])
refuse("camera[0].focalPoint: missing", camera=[{"time": 0, "position": [0, 0, 1]}])
refuse("camera[1].position: missing", camera=[{"time": 0, "position": [0, 0, 1],
                                               "focalPoint": [0, 0, 0]},
                                              {"time": 1, "focalPoint": [0, 0, 0]}])
refuse("lights[0][0].azimuth: expected a number", lights=[[{"time": 0}]])
refuse("lights[0][0].color: expected a colour", lights=[[{"time": 0, "azimuth": 0, "elevation": 0,
                                                          "color": "red"}]])
refuse("actor[0].position: expected three numbers", actor=[{"time": 0, "position": [1, 2]}])
refuse("style[0].layers[9].field.size: unknown key; this style can animate: ",
       style=[{"time": 0, "layers[9].field.size": 8}])
refuse("style[0].layers[0].ink.opacity: 2 is outside 0 to 1",
       style=[{"time": 0, "layers[0].ink.opacity": 2}])
