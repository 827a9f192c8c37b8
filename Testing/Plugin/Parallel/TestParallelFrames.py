# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames that several processes draw look as if one drew them: motion, time, translucency, screenshots, interaction."""

import os

import numpy
import parallel_scene as parallel
import pattern_scene as scene
from paraview import simple
from paraview.vtk.vtkIOImage import vtkPNGReader

SEEN_FROM = parallel.BLOBS_SEEN_FROM
blobs, rods = parallel.blobs(), parallel.rods()


def view(full_detail=True):
    """A view that all processes draw."""
    where = scene.view(parallel.SIZE, full_detail)
    where.RemoteRenderThreshold = 0
    return where


def same(first, second):
    """Whether pictures are equal; only the first process has them."""
    return parallel.RANK > 0 or (first == second).all()


# A camera that moves; the last frame has what all frames before it have left.
places = [numpy.array(SEEN_FROM) + 2.0 * step * numpy.array([-1.5, 0.5, 1.0]) for step in range(5)]
for representation in "Pattern", "Noise":
    window = view()
    scene.show(blobs, window, Representation=representation)
    for place in places:
        scene.look(window, place)
        shown = scene.picture(window)
    parallel.check("moved-" + representation, shown)
    simple.Delete(window)

# A surface that moves in time, in patches.
window = view()
scene.show(rods, window, PatternStyle="hatch", PatternPatches="Automatic", PatternNumberOfPatches=6)
scene.look(window, (1, 2, 7))
for step in range(4):
    window.ViewTime = 0.25 * step
    shown = scene.picture(window)
parallel.check("times", shown)
simple.Delete(window)

# Translucent surfaces move from process to process, to be drawn in order.
for representation in "Pattern", "Noise":
    window = view()
    scene.show(blobs, window, Representation=representation, Opacity=0.6)
    scene.look(window, SEEN_FROM)
    parallel.check("translucent-" + representation, scene.picture(window))
    simple.Delete(window)

# Two views at once: each has a motion of its own.
first, second = view(), view()
for window in first, second:
    scene.show(blobs, window, Representation="Noise")
for turn in range(3):
    scene.look(first, places[turn])
    scene.look(second, places[4 - turn])
    shown = scene.picture(first), scene.picture(second)
parallel.check("first-view", shown[0])
parallel.check("second-view", shown[1])

# A screenshot larger than the view, and one that is drawn in tiles.
image_file = os.path.join(parallel.folder, "large-%d.png" % parallel.RANKS)
simple.SaveScreenshot(image_file, first, ImageResolution=[2 * side for side in parallel.SIZE])
if parallel.RANK == 0:
    png = vtkPNGReader()
    png.SetFileName(image_file)
    png.Update()
    parallel.check("large", scene.array(png.GetOutput()))
parallel.check("tiles", scene.array(second.CaptureWindow(2)))
again = scene.picture(first)
assert same(again, shown[0]), "a screenshot changed the view"
for window in first, second:
    simple.Delete(window)

# Interaction in low detail and few pixels leaves no trace.
for representation in "Pattern", "Noise":
    pictures = []
    for full_detail in True, False:
        window = view(full_detail)
        scene.show(blobs, window, Representation=representation)
        scene.look(window, places[0])
        simple.Render(window)
        if not full_detail:
            window.ImageReductionFactor = 3
            for place in places[1:4]:
                scene.look(window, place)
                window.SMProxy.InteractiveRender()
        scene.look(window, places[4])
        pictures.append(scene.picture(window))
        simple.Delete(window)
    assert same(*pictures), representation + ": interaction left a trace"
    parallel.check("interaction-" + representation, pictures[1])

# A selection finds the same cells as in Surface, and does not change the picture.
counts = []
for representation in "Surface", "Pattern":
    window = view()
    scene.show(rods, window, Representation=representation)
    scene.look(window, (1, 2, 7))
    before = scene.picture(window)
    simple.SelectSurfaceCells(Rectangle=[0, 0, parallel.SIZE[0], parallel.SIZE[1] // 2], View=window)
    selected = simple.ExtractSelection(Input=rods)
    selected.UpdatePipeline()
    counts.append(selected.GetDataInformation().GetNumberOfCells())
    simple.ClearSelection(rods)
    assert same(scene.picture(window), before), "selecting changed the picture"
    simple.Delete(window)
assert counts[0] == counts[1] > 20, counts

parallel.finish()
