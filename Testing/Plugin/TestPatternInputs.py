# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every kind of data is drawn with patterns, by light and by arrays, and properties change what they say."""

import itertools
import os

import numpy
import pattern_scene as scene
from paraview import simple


def draw(source, name=None, **properties):
    """A picture of the source in a view of its own."""
    source.UpdatePipeline()
    low_high = numpy.array(source.GetDataInformation().GetBounds()).reshape(3, 2)
    center = low_high.mean(axis=1)
    size = (low_high[:, 1] - low_high[:, 0]).max()
    where = scene.view()
    display = scene.show(source, where, **properties)
    scene.look(where, center + size * numpy.array([1.5, 1.2, 2.0]), center)
    shown = scene.picture(where, name)
    kind = display.SMProxy.GetXMLName()
    simple.Delete(where)
    return shown, kind


def share(shown, color):
    """Share of the pixels of this colour."""
    return (numpy.abs(shown.astype(int) - color).max(axis=2) <= 2).mean()


# Of every kind of data the surface is drawn: paper and ink where the grey ground was.
wavelet = simple.Wavelet(WholeExtent=[-8, 8, -8, 8, -8, 8])
kinds = {
    "GeometryRepresentation": simple.Cylinder(Resolution=40),
    "UniformGridRepresentation": wavelet,
    "StructuredGridRepresentation": simple.Transform(Input=wavelet),
    "UnstructuredGridRepresentation": simple.Tetrahedralize(Input=wavelet),
}
for (wanted, source), representation in itertools.product(kinds.items(), ("Pattern", "Noise")):
    shown, kind = draw(source, "kind-%s-%s" % (wanted, representation), Representation=representation)
    assert kind == wanted, kind + " is not " + wanted
    ground = share(shown, 128)
    assert ground < 0.8, "%s: nothing is drawn" % kind
    ink = (shown.max(axis=2) < 100).mean() / (1.0 - ground)
    paper = (shown.min(axis=2) > 200).mean() / (1.0 - ground)
    assert ink > 0.05 and paper > 0.2, "%s: ink %.3f, paper %.3f" % (kind, ink, paper)

# An array alone decides the ink where it is the tone: none below the range, nothing else above.
tones = {"PatternTone": "Array", "PatternOutline": "Off"}
tones.update(PatternPaper="Color", PatternPaperColor=[1, 1, 0])
for array in ("POINTS", "RTData"), ("CELLS", "RTData"):
    data = wavelet if array[0] == "POINTS" else simple.PointDatatoCellData(Input=wavelet)
    bare, _ = draw(data, PatternToneArray=array, PatternToneRange=[1000, 2000], **tones)
    full, _ = draw(data, PatternToneArray=array, PatternToneRange=[-2000, -1000], **tones)
    part, _ = draw(data, "array-" + array[0], PatternToneArray=array, PatternToneRange=[50, 250], **tones)
    ground = share(bare, 128)
    drawn = 1.0 - ground
    assert share(bare, [255, 255, 0]) > 0.99 * drawn, array
    assert share(full, [26, 26, 26]) > 0.99 * drawn, array
    assert 0.1 < share(part, [26, 26, 26]) / drawn < 0.9, array

# The range of a new representation is the one of its array.
where = scene.view()
display = simple.Show(wavelet, where)
low, high = wavelet.PointData["RTData"].GetRange()
assert display.PatternToneArray.GetArrayName() == "RTData", display.PatternToneArray
assert numpy.allclose(display.PatternToneRange, [low, high]), display.PatternToneRange
simple.Delete(where)

# Every property shows; neutral values show the style.
sphere = simple.Sphere(ThetaResolution=60, PhiResolution=60)
style, _ = draw(sphere)
again, _ = draw(sphere, PatternScale=1, PatternInkColor=[1, 0, 0], PatternPaperColor=[0, 0, 1])
assert (style == again).all(), "colours count only where a choice asks for them"
red, _ = draw(sphere, PatternInk="Color", PatternInkColor=[1, 0, 0])
assert share(red, [26, 26, 26]) == 0 and share(red, [255, 0, 0]) > 0.02
lit, _ = draw(sphere, PatternPaper="Lit surface")
assert share(lit, 255) < 0.5 * share(style, 255)
for changed in {"PatternScale": 2}, {"PatternAngle": 30}, {"PatternOutline": "Off"}, {"PatternStyle": "hatch"}:
    other, _ = draw(sphere, **changed)
    assert scene.difference(style, other) > 0.2, "%s changes nothing" % changed

# A style file goes before the name of a style.
presets = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Rendering/Presets")
named, _ = draw(sphere, PatternStyle="halftone")
from_file, _ = draw(sphere, PatternStyle="hatch", PatternStyleFile=os.path.join(presets, "halftone.json"))
assert (named == from_file).all()
