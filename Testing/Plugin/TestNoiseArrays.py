# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Directions and sizes of noise follow arrays of points and cells; names that are wrong are reported."""

import os

import numpy
import pattern_scene as scene
from paraview import simple

plane = simple.Plane(Origin=[-2, -2, 0], Point1=[2, -2, 0], Point2=[-2, 2, 0], XResolution=20, YResolution=20)
flow = simple.Calculator(Input=plane, ResultArrayName="flow", Function="cos(0.5)*iHat+sin(0.5)*jHat")
both = simple.Calculator(Input=flow, ResultArrayName="place", Function="coordsX")
of_cells = simple.PointDatatoCellData(Input=both)
EVEN = {"NoiseTone": "Constant", "NoiseToneConstant": 0.4, "NoiseOutline": "Off"}


def draw(source=both, name=None, position=(0, 0, 3), focal=(0, 0, 0), **properties):
    """A picture of the source, as a rule of a plane that fills the view."""
    where = scene.view((160, 120))
    scene.show(source, where, Representation="Noise", **dict(EVEN, **properties))
    scene.look(where, position, focal)
    shown = scene.picture(where, name)
    simple.Delete(where)
    return shown


def strokes(shown):
    """Direction of strokes in degrees from +x."""
    up, right = numpy.gradient(shown.astype(float).mean(axis=2))
    across = numpy.arctan2(2 * (up * right).mean(), (right**2 - up**2).mean()) / 2
    return (numpy.degrees(across) + 90) % 180


def changes(shown):
    """Mean difference of neighbouring pixels."""
    grey = shown.astype(float).mean(axis=2)
    return sum(numpy.abs(numpy.diff(grey, axis=axis)).mean() for axis in (0, 1))


def messages_of(**properties):
    """What is reported while this is drawn."""
    with scene.Messages() as messages:
        draw(**properties)
    return messages.text


def offered(display, what):
    """Names of the arrays among which one can choose."""
    domain = display.SMProxy.GetProperty("Noise%sArray" % what).GetDomain("array_list")
    return {domain.GetString(i) for i in range(domain.GetNumberOfStrings())}


# Vectors of points and of cells are offered, and strokes follow them; numbers are for the control.
for source in both, of_cells:
    where = scene.view()
    display = simple.Show(source, where)
    assert offered(display, "Direction") == {"None", "Normals", "flow"}, offered(display, "Direction")
    assert offered(display, "Control") == {"place"}, offered(display, "Control")
    assert display.NoiseDirectionArray == "None", display.NoiseDirectionArray
    assert display.NoiseControlArray.GetArrayName() == "place", display.NoiseControlArray
    simple.Delete(where)
    direction = strokes(draw(source, NoiseDirectionArray="flow"))
    assert abs(direction - numpy.degrees(0.5)) < 4, direction
assert abs(strokes(draw()) - 45) < 4

# Marks are smaller where the array is low, and the other way round.
control = {"NoiseControl": "Array", "NoiseControlArray": ["POINTS", "place"], "NoiseControlRange": [-0.8, 0.8]}
for source, association in (both, "POINTS"), (of_cells, "CELLS"):
    control["NoiseControlArray"] = [association, "place"]
    shown = draw(source, "noise-sizes-" + association, **control)
    left, right = changes(shown[:, :60]), changes(shown[:, -60:])
    assert left > 1.5 * right, (left, right)
    for turned in {"NoiseSizeFactors": [2, 0.5]}, {"NoiseControlRange": [0.8, -0.8]}:
        shown = draw(source, **dict(control, **turned))
        left, right = changes(shown[:, :60]), changes(shown[:, -60:])
        assert right > 1.5 * left, (turned, left, right)
control["NoiseControlArray"] = ["POINTS", "place"]
regular = draw(NoiseSizeFactors=[1, 1], NoiseRegularityFactors=[4, 0.25], **control)
assert scene.difference(regular, draw(NoiseSizeFactors=[1, 1], **control)) > 5
assert (draw() == draw(NoiseSizeFactors=[1, 1], **control)).all()

# The tone: half of it between the factors.
tone = {"NoiseControl": "Tone", "NoiseToneConstant": 0.5}
assert changes(draw(NoiseSizeFactors=[1.5, 2], **tone)) < 0.8 * changes(draw(NoiseToneConstant=0.5))
assert changes(draw(NoiseSizeFactors=[0.5, 0.5], **tone)) > 1.3 * changes(draw(NoiseToneConstant=0.5))

# Names that are wrong.
assert messages_of() == ""
for wrong, text in (
    ({"NoiseDirectionArray": "absent"}, "direction array 'absent' is missing"),
    ({"NoiseDirectionArray": "place"}, "direction array 'place' has 441 tuples of 1 components"),
    (dict(control, NoiseControlArray=["POINTS", "absent"]), "control array 'absent' is missing"),
    (dict(control, NoiseControlArray=["POINTS", "flow"]), "control array 'flow' has 441 tuples of 3 components"),
):
    assert messages_of(**wrong).count(text) == 1, messages_of(**wrong)

# Real data: the flow in a reactor, and bends of a skull.
disk = simple.OpenDataFile(os.path.join(scene.data_folder, "disk_out_ref.ex2"))
disk.UpdatePipeline()
skull = simple.Contour(
    Input=simple.XMLImageDataReader(FileName=[os.path.join(scene.data_folder, "skull.vti")]),
    ContourBy=["POINTS", "value"],
    Isosurfaces=[2.9],
)
bends = scene.HachureDirectionField(Input=skull)
bends.UpdatePipeline()
for source, array in (disk, "V"), (bends, "Direction"):
    low_high = numpy.array(source.GetDataInformation().GetBounds()).reshape(3, 2)
    center, size = low_high.mean(axis=1), (low_high[:, 1] - low_high[:, 0]).max()
    near = {"position": center + size * numpy.array([0.7, -2.4, 0.8]), "focal": center}
    with scene.Messages() as messages:
        following = draw(source, "noise-along-" + array, NoiseDirectionArray=array, **near)
        usual = draw(source, **near)
    assert not messages.text, messages.text
    assert scene.difference(following, usual) > 2, array
