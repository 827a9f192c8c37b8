# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What replaces parts of a style of noise does what it says, and nothing until it is asked for."""

import os

import numpy
import pattern_scene as scene
from paraview import simple
from paraview.vtk.util.numpy_support import numpy_to_vtk
from paraview.vtk.vtkCommonDataModel import vtkImageData
from paraview.vtk.vtkIOImage import vtkPNGWriter

PRESETS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Rendering/Presets")
TONE = 0.4

plane = simple.Plane(Origin=[-2, -2, 0], Point1=[2, -2, 0], Point2=[-2, 2, 0])
ball = simple.Sphere(ThetaResolution=16, PhiResolution=16)
behind = simple.Sphere(Center=[0.4, 0.2, -1.0], ThetaResolution=16, PhiResolution=16)


def draw(name=None, source=plane, prefix="Noise", **properties):
    """A picture of even tone, of a plane that fills the view or of another source."""
    where = scene.view((120, 90))
    options = {"Tone": "Constant", "ToneConstant": TONE, "Outline": "Off"}
    options.update(properties)
    renamed = {prefix + name: value for name, value in options.items()}
    scene.show(source, where, Representation=prefix, **renamed)
    scene.look(where, (0, 0, 3))
    shown = scene.picture(where, name)
    simple.Delete(where)
    return shown


def same(first, second):
    """Whether two pictures are equal."""
    return (first == second).all()


def ink(shown):
    """Mean coverage with ink, but for its own brightness."""
    return 1 - scene.linear(shown).mean()


def strokes(shown):
    """Direction of strokes in degrees from +x, and how much they have one, 0 to 1."""
    grey = shown.astype(float).mean(axis=2)
    up, right = numpy.gradient(grey)
    across = numpy.arctan2(2 * (up * right).mean(), (right**2 - up**2).mean()) / 2
    strength = numpy.hypot(2 * (up * right).mean(), (right**2 - up**2).mean())
    return (numpy.degrees(across) + 90) % 180, strength / (right**2 + up**2).mean()


def changes(shown):
    """Mean difference of neighbouring pixels."""
    grey = shown.astype(float).mean(axis=2)
    return sum(numpy.abs(numpy.diff(grey, axis=axis)).mean() for axis in (0, 1))


def greys(shown):
    """Share of pixels that are neither ink nor paper."""
    return ((shown > 80) & (shown < 200)).all(axis=2).mean()


# The default style, and its tone.
phasor = draw("noise-phasor")
assert same(phasor, draw(Style="phasor"))
assert abs(ink(phasor) - TONE) < 0.04, ink(phasor)
direction, oneness = strokes(phasor)
assert abs(direction - 45) < 5 and oneness > 0.5, (direction, oneness)

# Neutral values, and what no choice asks for, change nothing.
neutral = {"Scale": 1, "Spread": 0, "Regularity": 1, "Smoothness": 0, "Overlap": 0, "Fade": 0, "Life": -1, "Control": "None"}
neutral.update(SizeFactors=[0.25, 4], RegularityFactors=[4, 0.25], InkColor=[1, 0, 0], Distribution="Even")
neutral.update(ObjectTest="On", TriangleTest="Off", DepthTest="On", PartialVisibility="On", Kind="Phasor")
neutral.update(DirectionArray="None")
assert same(phasor, draw(**neutral))

# A kind, and numbers that are added and multiplied, make one style out of another.
turned = {"Kind": "Gabor", "Regularity": 0.6, "Spread": 90}
gabor = draw("noise-gabor", Style="gabor")
assert same(gabor, draw(**turned))
assert strokes(gabor)[1] < 0.4, strokes(gabor)
spot = draw("noise-spot", Style="spot")
assert same(spot, draw(Kind="Spot", Scale=2, Regularity=0.35, Spread=25))
for first, second in (phasor, gabor), (gabor, spot), (spot, phasor):
    assert scene.difference(first, second) > 20

# Style files go before names, also for Pattern, where size, direction and seed are the same ones.
gabor_file = os.path.join(PRESETS, "gabor.json")
phasor_file = os.path.join(PRESETS, "phasor.json")
assert same(gabor, draw(StyleFile=gabor_file))
assert same(phasor, draw(prefix="Pattern", StyleFile=phasor_file))
for options in {"Scale": 1.7}, {"Angle": 30}, {"Seed": 3}:
    changed = draw(**options)
    assert scene.difference(phasor, changed) > 20, options
    assert same(changed, draw(prefix="Pattern", StyleFile=phasor_file, **options)), options
    assert abs(ink(changed) - TONE) < 0.06, (options, ink(changed))
assert abs(strokes(draw(Angle=30))[0] - 75) < 5
assert changes(draw(Scale=2)) < 0.6 * changes(phasor)
mixed = draw(prefix="Noise", StyleFile=os.path.join(PRESETS, "halftone.json"), Scale=1.5)
assert same(mixed, draw(prefix="Pattern", Style="halftone", Scale=1.5))

# Spread, regularity, smoothness.
assert strokes(draw(Spread=60))[1] < 0.7 * oneness
assert same(draw(Style="gabor", Spread=-90), draw(Kind="Gabor", Regularity=0.6))
assert strokes(draw(Regularity=3))[1] > oneness > strokes(draw(Regularity=0.3))[1]
assert greys(draw("noise-smooth", Smoothness=0.8)) > 2 * greys(phasor)
for options in {"Overlap": 8}, {"Fade": 4}, {"Overlap": 1}:
    assert scene.difference(phasor, draw(**options)) > 1, options
assert same(draw(Overlap=4), draw(Overlap=1))

# Ink, paper, tone and lines are those of Pattern.
shared = [{"Ink": "Color", "InkColor": [1, 0, 0]}, {"InkOpacity": 0.5}, {"BlendMode": "Screen"}]
shared += [{"Paper": "Color", "PaperColor": [1, 1, 0]}, {"Tone": "Light"}, {"ToneConstant": 0.6}]
shared += [{"ToneInvert": "On"}, {"ToneGamma": 2}, {"ToneRemap": "Steps"}]
for options in shared:
    changed = draw(**options)
    assert scene.difference(phasor, changed) > 5, options
    assert same(changed, draw(prefix="Pattern", StyleFile=phasor_file, **options)), options
assert ((draw(source=ball, Outline="On") < 60).sum() - (draw(source=ball) < 60).sum()) > 100


def write_picture(name):
    """A picture of a bright ring on black."""
    y, x = numpy.mgrid[-16:16, -16:16] + 0.5
    ring = numpy.where(numpy.abs(numpy.hypot(x, y) - 10) < 2.5, 255, 0).astype(numpy.uint8)
    image = vtkImageData()
    image.SetDimensions(32, 32, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(ring.ravel(), 1))
    writer = vtkPNGWriter()
    writer.SetFileName(name)
    writer.SetInputData(image)
    writer.Write()


# A picture replaces the fibre of spots, and leaves waves as they are.
file_name = os.path.join(scene.output_folder, "noise-ring.png")
write_picture(file_name)
rings = draw("noise-rings", Style="spot", SpotImage=file_name)
assert scene.difference(spot, rings) > 5
assert strokes(rings)[1] < 0.5 * strokes(spot)[1], (strokes(rings), strokes(spot))
assert same(phasor, draw(SpotImage=file_name))
with scene.Messages() as messages:
    assert same(spot, draw(Style="spot", SpotImage="/nowhere/a.png"))
assert messages.text.count('"/nowhere/a.png": no such file') == 1, messages.text

# Points on every triangle, and what trims a kernel: two balls, one before the other, as blocks or in one.
blocks = simple.GroupDatasets(Input=[ball, behind])
one = simple.AppendGeometry(Input=[ball, behind])
for source, options in (
    (one, {"Distribution": "Classic"}),
    (one, {"TriangleTest": "On"}),
    (one, {"DepthTest": "Off"}),
    (one, {"PartialVisibility": "Off"}),
    (blocks, {"ObjectTest": "Off"}),
):
    usual, changed = draw(source=source), draw(source=source, **options)
    assert scene.difference(usual, changed) > 0.02, (options, scene.difference(usual, changed))
