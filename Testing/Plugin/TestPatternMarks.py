# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Marks that replace those of a style: kinds, pictures, brushes, grain and seeds."""

import os

import numpy
import pattern_scene as scene
from paraview import simple
from paraview.vtk.util.numpy_support import numpy_to_vtk
from paraview.vtk.vtkCommonDataModel import vtkImageData
from paraview.vtk.vtkIOImage import vtkPNGWriter

plane = simple.Plane(Origin=[-2, -2, 0], Point1=[2, -2, 0], Point2=[-2, 2, 0])


def draw(name=None, **properties):
    """A picture of a plane of even tone that fills the view."""
    where = scene.view((120, 90))
    tone = {"PatternTone": "Constant", "PatternToneConstant": 0.3, "PatternOutline": "Off"}
    scene.show(plane, where, **dict(tone, **properties))
    scene.look(where, (0, 0, 3))
    shown = scene.picture(where, name)
    simple.Delete(where)
    return shown


def same(first, second):
    """Whether two pictures are equal."""
    return (first == second).all()


def edges(shown, axis=None):
    """Mean difference of neighbouring pixels, to the right (axis 1), upwards (axis 0), or both."""
    grey = shown.astype(float).mean(axis=2)
    both = [numpy.abs(numpy.diff(grey, axis=a)).mean() for a in (0, 1)]
    return sum(both) if axis is None else both[axis]


# Every kind differs, with the same ink; the one of the style does not.
dark = draw(PatternStyle="hatch", PatternToneConstant=0.6)
pictures = {}
for kind in "Hatch", "Cross-hatch", "Halftone", "Stipple", "Paint", "Paper":
    pictures[kind] = draw("marks-" + kind, PatternStyle="hatch", PatternToneConstant=0.6, PatternKind=kind)
    ink = scene.linear(pictures[kind]).mean() - scene.linear(dark).mean()
    assert abs(ink) < 0.03, (kind, ink)
    others = [scene.difference(pictures[kind], pictures[other]) for other in pictures if other != kind]
    assert min(others, default=99) > 10, (kind, others)
assert same(dark, pictures["Hatch"])

# Hatching in another kind, size, ink and hand is the style of halftone.
as_halftone = {"PatternKind": "Halftone", "PatternScale": 6 / 7, "PatternIrregularity": -1}
as_halftone["PatternInk"] = "Color"
assert same(draw(PatternStyle="halftone"), draw(PatternStyle="hatch", **as_halftone))
sketched = draw("marks-sketched", PatternStyle="halftone", PatternIrregularity=0.35)
assert same(sketched, draw(PatternStyle="hatch", **dict(as_halftone, PatternIrregularity=0)))
assert scene.difference(sketched, draw(PatternStyle="halftone")) > 5

hatch = draw(PatternStyle="hatch")

# Other numbers place strokes of a loose hand otherwise, and leave ruled dots where they are.
assert scene.difference(hatch, draw(PatternStyle="hatch", PatternSeed=1)) > 5
assert same(draw(PatternStyle="halftone"), draw(PatternStyle="halftone", PatternSeed=1))


def write_picture(name):
    """A picture of 16 x 16 pixels, darker to the right."""
    image = vtkImageData()
    image.SetDimensions(16, 16, 1)
    ramp = numpy.tile(numpy.arange(240, 0, -15, dtype=numpy.uint8), 16)
    image.GetPointData().SetScalars(numpy_to_vtk(ramp, 1))
    writer = vtkPNGWriter()
    writer.SetFileName(name)
    writer.SetInputData(image)
    writer.Write()


# A picture is drawn upright and at its own size, its dark parts first; until there is one, the style.
file_name = os.path.join(scene.output_folder, "marks-ramp.png")
write_picture(file_name)
own = {"PatternStyle": "hatch", "PatternKind": "Image", "PatternImageFile": file_name, "PatternInk": "Color"}
for scale in 1, 2:
    shown = draw("marks-image-%d" % scale, PatternScale=scale, **own)[:, :, 0]
    assert (shown == shown[0]).all(), "strokes are not upright"
    period = 16 * scale
    assert (shown[:, period:] == shown[:, :-period]).all(), scale
    inked = (shown[0, :period] < 128).mean()
    assert abs(inked - 0.3) <= 1 / period, (scale, inked)
    turns = numpy.diff((shown[0, : 2 * period] < 128).astype(int))
    assert abs(turns).sum() in (3, 4), (scale, turns)
assert same(hatch, draw(PatternStyle="hatch", PatternKind="Image")), "no file yet"
assert same(hatch, draw(PatternStyle="hatch", PatternImageFile=file_name)), "a file unasked"
with scene.Messages() as messages:
    assert same(hatch, draw(PatternStyle="hatch", PatternKind="Image", PatternImageFile="/nowhere/a.png"))
assert messages.text.count('"/nowhere/a.png": no such file') == 1, messages.text

# The brush of a new representation is that of the painted style.
painted = {"PatternStyle": "painterly", "PatternToneConstant": 1, "DiffuseColor": [0.2, 0.4, 0.8]}
assert same(draw(**painted), draw(PatternBrush="Custom", **painted))


def paint(name=None, **brush):
    """The same along x, with dabs told apart by their brightness alone."""
    options = {"PatternBump": 0, "PatternColorVariation": 1, "PatternAngle": -20, "PatternScale": 0.6}
    return draw(name, PatternBrush="Custom", **painted, **dict(options, **brush))


def along(shown):
    """Changes along the dabs over those across them."""
    return edges(shown, 1) / edges(shown, 0)


assert edges(paint(PatternColorVariation=0)) < 0.5 < edges(paint(PatternColorVariation=0.3)) < edges(paint())
assert edges(paint(PatternColorVariation=0, PatternBump=1)) > 2
assert along(paint("marks-long-dabs", PatternDabLength=8)) < 0.6 * along(paint(PatternDabLength=1))
assert along(paint(PatternDabJitter=0)) < 0.7 * along(paint(PatternDabJitter=180))
few, many = (edges(paint(PatternDabDensity=density)) for density in (0.5, 8))
assert few < 0.8 * many, (few, many)
soft, stiff = (edges(paint(PatternColorVariation=0, PatternBump=1, PatternBristles=b)) for b in (0, 1))
assert 1.4 * soft < stiff, (soft, stiff)

# Larger grains change less from pixel to pixel.
grain = {"PatternStyle": "hatch", "PatternPaperGrain": "On", "PatternPaperContrast": 1}
fine, coarse = draw(**grain), draw("marks-grain", PatternPaperScale=3, **grain)
assert edges(coarse) < 0.6 * edges(fine), (edges(coarse), edges(fine))
assert same(hatch, draw(PatternStyle="hatch", PatternPaperScale=3)), "grain unasked"
