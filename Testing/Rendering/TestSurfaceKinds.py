# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What VTK draws besides plain opaque surfaces: pictures that were looked at, and no message."""

import math
import os
import sys

import hachure
import pattern_scene as scene
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkImageData, vtkMultiBlockDataSet, vtkPlane, vtkPolyData)
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkStripper
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCubeSource, vtkLineSource
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkCompositeDataDisplayAttributes

SIZE = 160
options = dict(zip(sys.argv[1::2], sys.argv[2::2]))
# Differences up to this many grey levels are rounding of the GL implementation.
IGNORED_LEVELS = 16
# A few pixels that rounding puts on the other side; strokes elsewhere make thousands.
ALLOWED_ERROR = 10.0
differences = []


def image_of(pixels):
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=True))
    return image


def compare(pixels, name):
    """Strict: every pixel with its own counterpart, see StrictImageComparison.h."""
    baseline = os.path.join(os.path.dirname(options["-V"]), "TestSurfaceKinds-%s.png" % name)
    image = image_of(pixels)
    error = math.inf  # no baseline
    if os.path.exists(baseline):
        reader = vtkPNGReader()
        reader.SetFileName(baseline)
        difference = vtkImageDifference()
        difference.SetInputData(image)
        difference.SetImageConnection(reader.GetOutputPort())
        difference.AllowShiftOff()
        difference.AveragingOff()
        difference.SetThreshold(IGNORED_LEVELS)
        difference.Update()
        error = difference.GetThresholdedError()
    if error > ALLOWED_ERROR:
        written = os.path.join(options["-T"], os.path.basename(baseline))
        writer = vtkPNGWriter()
        writer.SetFileName(written)
        writer.SetInputData(image)
        writer.Write()
        differences.append("%s differs from %s: %s" % (written, baseline, error))


def stage(*actors):
    renderer = scene.renderer_of(*actors)
    renderer.SetBackground(0.85, 0.9, 1.0)
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    scene.look(renderer, (2.0, 1.4, 3.0))
    return renderer, window


def cone(center=(0.0, 0.0, 0.0), height=1.2):
    source = vtkConeSource()
    source.SetResolution(24)
    source.SetHeight(height)
    source.SetRadius(0.6)
    source.SetCenter(*center)
    source.Update()
    return source


def test_translucent():
    front = scene.actor_of(scene.sphere(24, 0.6, (0.0, 0.0, 0.5)), "cross-hatch")
    front.GetProperty().SetOpacity(0.5)
    back = scene.actor_of(cone(), "hatch")
    renderer, window = stage(front, back)
    plain = scene.draw(window)
    compare(plain, "translucent")
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(8)
    window.AlphaBitPlanesOn()
    peeled = scene.draw(window)
    compare(peeled, "peeled")
    renderer.UseDepthPeelingOff()
    assert (scene.draw(window) == plain).all()


def test_clipped():
    actor = scene.actor_of(scene.sphere(24, 0.8), "cross-hatch")
    plane = vtkPlane()
    plane.SetNormal(-0.2, -1.0, -0.3)
    plane.SetOrigin(0.0, 0.2, 0.0)
    _, window = stage(actor)
    whole = scene.draw(window)
    actor.GetMapper().AddClippingPlane(plane)
    compare(scene.draw(window), "clipped")
    actor.GetMapper().RemoveAllClippingPlanes()
    assert (scene.draw(window) == whole).all()


def test_blocks():
    """Empty, null and hidden blocks, one of another opacity and one of another colour."""
    blocks = vtkMultiBlockDataSet()
    blocks.SetNumberOfBlocks(7)
    blocks.SetBlock(0, vtkPolyData())
    for i, center in ((2, (-0.7, 0.4, 0)), (3, (0.5, 0.5, 0)), (4, (-0.5, -0.5, 0)), (6, (0.6, -0.5, 0))):
        blocks.SetBlock(i, scene.sphere(24, 0.45, center).GetOutput())
    inner = vtkMultiBlockDataSet()
    inner.SetBlock(0, cone((0, 0, 0.6), 0.5).GetOutput())
    inner.SetBlock(1, vtkPolyData())
    blocks.SetBlock(5, inner)
    style = hachure.style("hatch")
    style.SetPaperSource(style.FLAT)
    actor = scene.actor_of(blocks, style)
    attributes = vtkCompositeDataDisplayAttributes()
    actor.GetMapper().SetCompositeDataDisplayAttributes(attributes)
    attributes.SetBlockVisibility(blocks.GetBlock(2), False)
    attributes.SetBlockColor(blocks.GetBlock(3), (1.0, 0.6, 0.2))
    _, window = stage(actor)
    compare(scene.draw(window), "blocks")
    attributes.SetBlockOpacity(blocks.GetBlock(4), 0.4)
    actor.GetMapper().Modified()
    compare(scene.draw(window), "block-opacity")


def test_edges():
    cube = vtkCubeSource()
    actor = scene.actor_of(cube, "cross-hatch")
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.8, 0.0, 0.0)
    actor.GetProperty().SetLineWidth(2)
    _, window = stage(actor)
    compare(scene.draw(window), "edges")


def mixed():
    """One polydata with vertices, lines, polygons and strips."""
    round_part = scene.sphere(16, 0.4, (0.4, -0.2, 0.0))
    stripper = vtkStripper()
    stripper.SetInputConnection(round_part.GetOutputPort())
    line = vtkLineSource()
    line.SetPoint1(-0.9, -0.7, 0.3)
    line.SetPoint2(0.9, 0.9, 0.3)
    append = vtkAppendPolyData()
    sources = (stripper, line, cone((-0.4, 0.3, 0.0), 0.6))
    for source in sources:
        append.AddInputConnection(source.GetOutputPort())
    append.Update()
    parts = append.GetOutput()
    points = vtkPoints()
    points.DeepCopy(parts.GetPoints())
    vertices = vtkCellArray()
    for i in range(8):
        vertices.InsertNextCell(1, [points.InsertNextPoint(-0.8 + 0.2 * i, -0.8, 0.4)])
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetVerts(vertices)
    data.SetLines(parts.GetLines())
    data.SetPolys(parts.GetPolys())
    data.SetStrips(parts.GetStrips())
    return data


def test_mixed_cells():
    data = mixed()
    assert min(data.GetNumberOfVerts(), data.GetNumberOfLines(), data.GetNumberOfPolys(),
               data.GetNumberOfStrips()) > 0
    actor = scene.actor_of(data, "hatch")
    actor.GetProperty().SetPointSize(5)
    actor.GetProperty().SetLineWidth(3)
    actor.GetProperty().SetColor(0.0, 0.3, 0.8)
    _, window = stage(actor)
    compare(scene.draw(window), "mixed")


def test_strips_are_drawn_as_polygons():
    """The same surface in another form: the same picture, but for the samples."""
    source = scene.sphere(24, 0.8)
    stripper = vtkStripper()
    stripper.SetInputConnection(source.GetOutputPort())
    styles = [scene.constant_style(0, 8, 0.5) for _ in range(2)]
    for style in styles:
        style.GetLayer(0).SetMotion(hachure.vtkImagePatternLayer.FIXED_IN_IMAGE)
    pictures = []
    for data, style in zip((source, stripper), styles):
        _, window = stage(scene.actor_of(data, style))
        pictures.append(scene.draw(window))
    assert ((pictures[0] != pictures[1]).any(axis=2)).mean() < 1e-3


def test_two_layers_and_colours():
    style = hachure.style("halftone")
    extra = hachure.vtkImagePatternLayer()
    extra.SetColor(0.8, 0.1, 0.0)
    extra.SetAngle(-30.0)
    extra.SetBlendMode(extra.MULTIPLY)
    extra.GetTone().SetSource(hachure.vtkPatternTone.CONSTANT)
    extra.GetTone().SetConstant(0.25)
    style.AddLayer(extra)
    style.SetPaperColor(1.0, 0.97, 0.85)
    _, window = stage(scene.actor_of(scene.sphere(32, 0.8), style))
    compare(scene.draw(window), "two-layers")


def test_surface_paper_with_scalars():
    source = scene.sphere(24, 0.8)
    data = source.GetOutput()
    z = vtk_to_numpy(data.GetPoints().GetData())[:, 2]
    data.GetPointData().SetScalars(scene.add_array(data.GetPointData(), "z", z))
    style = hachure.style("hatch")
    style.SetPaperSource(style.SURFACE)
    actor = scene.actor_of(data, style)
    actor.GetMapper().SetScalarRange(-0.8, 0.8)
    _, window = stage(actor)
    compare(scene.draw(window), "scalars")


scene.run(globals())
assert not differences, differences
