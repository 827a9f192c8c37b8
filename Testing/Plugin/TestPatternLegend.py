# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The legend of a representation is shown, placed with properties and with the mouse, and part of screenshots and states."""

import os

import numpy
import pattern_scene as scene
from paraview import simple
from paraview.vtk.vtkRenderingUI import vtkGenericRenderWindowInteractor
from state_scene import clear, two_views_come_back

SIZE = (300, 200)
TONE = {"PatternTone": "Array", "PatternToneArray": ["POINTS", "Elevation"], "PatternToneRange": [0, 0.9]}


def new_source():
    ball = simple.Sphere(ThetaResolution=24, PhiResolution=24)
    return simple.Elevation(Input=ball, LowPoint=[0, -0.5, 0], HighPoint=[0, 0.5, 0])


def open_view(source, choice):
    where = scene.view(SIZE)
    scene.show(source, where, PatternStyle="halftone", **TONE, **choice)
    scene.look(where, (0, 0, 4))
    return where


def changed(first, second):
    """The box (left, right, bottom, top) in which two pictures differ, as parts of the picture; None: nowhere."""
    rows, columns = numpy.nonzero((first != second).any(axis=2))
    if not len(rows):
        return None
    return columns.min() / SIZE[0], columns.max() / SIZE[0], rows.min() / SIZE[1], rows.max() / SIZE[1]


def inside(box, corner, size):
    """Whether a legend is in its place; labels at the ends of a level row reach beyond it."""
    return (box and corner[0] - 0.04 <= box[0] and box[1] <= corner[0] + size[0] + 0.04
            and corner[1] - 0.01 <= box[2] and box[3] <= corner[1] + size[1] + 0.01)


two_views_come_back("pattern-legend-state", (
    {"PatternLegend": 1, "PatternLegendTitle": "a", "PatternLegendPosition": [0.7, 0.1]},
    {"PatternLegend": 1, "PatternLegendMode": "Steps", "PatternLegendOrientation": "Horizontal",
     "PatternLegendSize": [0.15, 0.5]},
), open_view, 0.5)
clear()

where = open_view(new_source(), {})
display = simple.GetDisplayProperties(simple.GetActiveSource(), where)
plain = scene.picture(where)
display.PatternLegend = 1
shown = scene.picture(where, "pattern-legend")
assert inside(changed(plain, shown), (0.82, 0.2), (0.18, 0.6)), changed(plain, shown)
inked = shown[60:140, 248:280] / 255.0
assert inked[:20].mean() > inked[-20:].mean() + 0.3, "dark above"
assert len(numpy.unique(inked)) > 10, "halftone dots, not a grey ramp"

# It goes with its representation, and every property changes it.
display.Visibility = 0
assert (scene.picture(where) == 128).all() or changed(plain, scene.picture(where))[0] < 0.8, "a legend of nothing"
display.Visibility = 1
display.Representation = "Surface"
assert changed(scene.picture(where), shown)[1] > 0.8
display.Representation = "Pattern"
assert (scene.picture(where) == shown).all()
for name, value in (
    ("Title", "Height"), ("Mode", "Steps"), ("Steps", 3), ("Labels", 2), ("LabelFormat", "%.2e"), ("Nan", 1),
    ("Orientation", "Horizontal"), ("Position", [0.1, 0.3]), ("Size", [0.3, 0.4]), ("Thickness", 20),
    ("TitleFontSize", 20), ("LabelFontSize", 8),
):
    setattr(display, "PatternLegend" + name, value)
    before, shown = shown, scene.picture(where)
    if name not in ("Labels", "LabelFormat") or display.PatternLegendMode != "Steps":
        assert (before != shown).any(), name
assert inside(changed(plain, shown), (0.1, 0.3), (0.3, 0.4)), changed(plain, shown)

# The mouse moves it, and the properties know.
interactor = vtkGenericRenderWindowInteractor()
where.SMProxy.SetupInteractor(interactor)
interactor.SetRenderWindow(where.GetRenderWindow())
interactor.Initialize()
simple.Render(where)


def drag(start, end):
    """With the left button."""
    for event, place in (("Move", start), ("Press", start), ("Move", end), ("Release", end), ("Move", (1, 1))):
        interactor.SetEventInformation(*[round(place[i] * SIZE[i]) for i in range(2)], 0, 0, "\0", 0, "")
        getattr(interactor, "MouseMoveEvent" if event == "Move" else "LeftButton%sEvent" % event)()


camera = list(where.CameraPosition)
drag((0.2, 0.5), (0.4, 0.4))
assert numpy.allclose(display.PatternLegendPosition, [0.3, 0.2], atol=0.01), display.PatternLegendPosition
assert numpy.allclose(display.PatternLegendSize, [0.3, 0.4], atol=0.01), display.PatternLegendSize
assert camera == list(where.CameraPosition), "the mouse has moved the view"
assert inside(changed(plain, scene.picture(where)), (0.3, 0.2), (0.3, 0.4))

# A larger screenshot has the same, larger.
small = scene.picture(where, "pattern-legend-moved")
file_name = os.path.join(scene.output_folder, "pattern-legend-large.png")
simple.SaveScreenshot(file_name, where, ImageResolution=[2 * SIZE[0], 2 * SIZE[1]])
reader = simple.PNGSeriesReader(FileNames=[file_name])
reader.UpdatePipeline()
large = scene.array(simple.servermanager.Fetch(reader))
legend = slice(40, 120), slice(90, 180)  # rows and columns of its box
halved = scene.linear(large).reshape(SIZE[1], 2, SIZE[0], 2, 3).mean(axis=(1, 3))[legend]
assert abs(halved - scene.linear(small)[legend]).mean() < 0.05, abs(halved - scene.linear(small)[legend]).mean()
simple.Delete(reader)
