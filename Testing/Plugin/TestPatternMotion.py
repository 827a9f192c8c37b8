# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Options of motion, which replace those of a style, do what they say."""

import math

import numpy
import pattern_scene as scene
from paraview import simple

plane = simple.Plane(Origin=[-2, -2, 0], Point1=[2, -2, 0], Point2=[-2, 2, 0])
flat = simple.Calculator(Input=plane, ResultArrayName="tone", Function="0.3")
tone = {"PatternTone": "Array", "PatternToneArray": ["POINTS", "tone"], "PatternOutline": "Off"}
tone.update(PatternToneRange=[0, 1], PatternStyle="hatch")


def draw(cameras, source=flat, name=None, **properties):
    """Pictures from cameras (x, y, distance, roll in degrees), one after the other."""
    where = scene.view((120, 90))
    scene.show(source, where, **dict(tone, **properties))
    shown = []
    for x, y, distance, roll in cameras:
        up = (math.sin(math.radians(roll)), math.cos(math.radians(roll)), 0)
        scene.look(where, (x, y, distance), (x, y, 0), up)
        shown.append(scene.picture(where, name))
    simple.Delete(where)
    return shown


# A pattern that is fixed in the image stays where it is while the camera moves; others do not.
aside = [(0, 0, 3, 0), (0.05, 0, 3, 0)]
fixed = draw(aside, PatternMotion="Fixed in image")
assert (fixed[0] == fixed[1]).all()
for motion in "Similarity", "Texture", "Dynamic solid":
    moving = draw(aside, PatternMotion=motion)
    assert scene.difference(moving[0], moving[1]) > 5, motion
usual, again = draw(aside), draw(aside, PatternMotion="Similarity", PatternSurfacePeriod=0.2)
assert (usual[1] == again[1]).all()

# A period on the surface counts in its texture coordinates, 1 over the whole plane.
seen = 2 * 3 * math.tan(math.radians(15)) / 4
for period in 0.05, 0.1:
    lines = draw(aside[:1], PatternAngle=-45, PatternMotion="Texture", PatternSurfacePeriod=period)
    column = lines[0][:, 60, 0] < 128
    strokes = (column[1:] & ~column[:-1]).sum()
    assert abs(strokes - seen / period) <= 1, (period, strokes)


def direction(shown):
    """Angle across the strokes in degrees, modulo 180."""
    soft = shown[:, :, 0].astype(float)
    for axis in (0, 1) * 3:  # edges of pixels have directions of their own
        soft = sum(numpy.roll(soft, step, axis) for step in range(-2, 3))
    y, x = numpy.gradient(soft[8:-8, 8:-8])
    return math.degrees(0.5 * math.atan2(2 * (x * y).sum(), (x * x - y * y).sum()))


def strokes_per_column(shown):
    """Mean number of strokes in a column of pixels."""
    ink = shown[:, :, 0] < 128
    return (ink[1:] & ~ink[:-1]).sum() / shown.shape[1]


# While the camera rolls strokes turn, and while it comes nearer they part, unless they are locked.
roll = [(0, 0, 3, angle) for angle in (0, 8, 16)]
for locked, turn in ("Off", 16), ("On", 0):
    first, _, last = draw(roll, PatternLockRotation=locked)
    assert abs(direction(last) - direction(first) - turn) < 2.5, (locked, direction(first), direction(last))
zoom = [(0, 0, 3 / scale, 0) for scale in (1.0, 1.1, 1.2)]
for locked, parted in ("Off", 1.2), ("On", 1):
    first, _, last = draw(zoom, PatternLockScale=locked)
    ratio = strokes_per_column(first) / strokes_per_column(last)
    assert abs(ratio - parted) < 0.06, (locked, ratio)

# Strokes of half the size come in where they are told to: here before the camera is near enough otherwise.
doubled = {"PatternTransitionScales": "Custom", "PatternTransitionRange": [1, 1.1]}
for options, parted in ({"PatternTransitionRange": [1, 1.1]}, 1.2), (doubled, 0.6):
    first, _, last = draw(zoom, **options)
    ratio = strokes_per_column(first) / strokes_per_column(last)
    assert abs(ratio - parted) < 0.06, (options, ratio)

# Weights: those of the style are symmetric; features of one half of the surface pull the pattern there.
nearer = [(0, 0.4, 3, 0), (0, 0.2, 2.5, 0), (0, 0, 2, 0)]
ball = simple.Calculator(
    Input=simple.Sphere(ThetaResolution=40, PhiResolution=40, Radius=0.6),
    ResultArrayName="upper",
    Function="if(coordsY > 0, 1, 0)",
)
features = {"PatternTone": "As in the style", "PatternWeights": "Perceptual", "PatternFeatures": "Array"}
weights = {"PatternTone": "As in the style"}
usual = draw(nearer, ball, **weights)[-1]
assert (usual == draw(nearer, ball, PatternWeights="Symmetric", **weights)[-1]).all()
for other in "Classic", "None", "Perceptual":
    assert (usual != draw(nearer, ball, PatternWeights=other, **weights)[-1]).any(), other
assert (usual == draw(nearer, ball, PatternSamplesPerPatch=500, **weights)[-1]).all()
assert (usual != draw(nearer, ball, PatternSamplesPerPatch=20, **weights)[-1]).any()
pulled = draw(nearer, ball, PatternFeatureArray=["POINTS", "upper"], **features)[-1]
assert scene.difference(usual, pulled) > 0.5
with scene.Messages() as messages:
    draw(nearer, ball, PatternFeatureArray=["POINTS", "Normals"], **features)
assert messages.text.count("'Normals'") == 1, messages.text

# No velocity is used unasked; one that cannot be used is named.
where = scene.view((120, 90))
display = scene.show(ball, where)
assert display.PatternVelocityArray == "None", display.PatternVelocityArray
simple.Delete(where)
with scene.Messages() as messages:
    draw(nearer, ball, PatternVelocityArray="upper", **weights)
assert messages.text.count("'upper'") == 1, messages.text
