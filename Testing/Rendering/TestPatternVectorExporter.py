# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures as SVG and PDF: contours lie where the drawn frame has them, in millimetres; hidden ones are missing."""

import os
import re
import subprocess
import sys
import xml.etree.ElementTree

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPlane
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkCompositeDataDisplayAttributes

OUT = sys.argv[sys.argv.index("-T") + 1]
SIZE = (240, 180)
POINT = "{http://www.w3.org/2000/svg}"
FINE = 4  # pixels of a finely drawn frame per pixel


def file_of(name):
    path = os.path.join(OUT, "TestPatternVectorExporter-" + name)
    if os.path.isfile(path):
        os.remove(path)
    return path


def export(window, name, **options):
    exporter = hachure.vtkPatternVectorExporter()
    exporter.SetRenderWindow(window)
    exporter.SetFileName(file_of(name))
    for option, value in options.items():
        getattr(exporter, "Set" + option)(value)
    exporter.Write()
    return exporter.GetFileName()


class Svg:
    """What an SVG file of the exporter says: its size in mm, its groups, its lines in pixels, y up."""

    def __init__(self, path, millimetres_per_pixel=25.4 / 96):
        root = xml.etree.ElementTree.parse(path).getroot()
        assert root.get("width").endswith("mm") and root.get("height").endswith("mm")
        self.size = (float(root.get("width")[:-2]), float(root.get("height")[:-2]))
        assert root.get("viewBox") == "0 0 %s %s" % (root.get("width")[:-2], root.get("height")[:-2])
        self.background = [rectangle.get("fill") for rectangle in root.iter(POINT + "rect")]
        self.pens = {(group.get("stroke"), group.get("stroke-width"))
                     for group in root.iter(POINT + "g") if group.get("stroke")}
        self.lines = []
        self.closed = []
        for line in root.iter(POINT + "path"):
            numbers = numpy.array(re.findall(r"-?[\d.]+", line.get("d")), dtype=float).reshape(-1, 2)
            numbers[:, 1] = self.size[1] - numbers[:, 1]
            self.closed.append(line.get("d").endswith("Z"))
            self.lines.append(numbers / millimetres_per_pixel)

    def segments(self):
        starts, ends = [], []
        for line, closed in zip(self.lines, self.closed):
            line = numpy.vstack([line, line[:1]]) if closed else line
            starts.append(line[:-1])
            ends.append(line[1:])
        return numpy.vstack(starts), numpy.vstack(ends)

    def distances(self, places):
        """From places to the nearest line."""
        starts, ends = self.segments()
        nearest = numpy.full(len(places), numpy.inf)
        for start, end in zip(starts, ends):
            along = end - start
            share = ((places - start) @ along / max(along @ along, 1e-12)).clip(0, 1)
            nearest = numpy.minimum(nearest, numpy.hypot(*(places - start - share[:, None] * along).T))
        return nearest


def pixel_centres(width, height, pixels=1.0):
    y, x = numpy.mgrid[0:height, 0:width]
    return (numpy.stack([x.ravel(), y.ravel()], axis=1) + 0.5) / pixels


def read_png(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)


def rasterise(path, dots_per_inch=96):
    """A file of the exporter as ink, drawn by the programs that read it."""
    picture = path + ".png"
    resolution = str(dots_per_inch)
    if path.endswith(".svg"):
        command = ["rsvg-convert", "-d", resolution, "-p", resolution, path, "-o", picture]
    else:
        command = ["pdftoppm", "-r", resolution, "-png", "-singlefile", path, path]
    subprocess.run(command, check=True)
    return 1.0 - read_png(picture)[:, :, 0] / 255.0


def unlit(data, style=None, color=(0.0, 0.0, 0.0)):
    """An actor that is one flat colour in the frame."""
    actor = scene.actor_of(data, style or hachure.vtkPatternStyle())
    actor.GetMapper().GetStyle().SetPaperColor(*color)
    actor.GetProperty().LightingOff()
    return actor


def frame_of(renderer, window):
    """The frame drawn finely, as brightness."""
    window.SetSize(FINE * SIZE[0], FINE * SIZE[1])
    window.Render()
    frame = scene.picture(window)[:, :, 0].astype(float)
    window.SetSize(*SIZE)
    return frame


def steps_in(frame):
    """Where brightness changes from a pixel to the next, in pixels of the window."""
    across = numpy.argwhere(frame[:, 1:] != frame[:, :-1])[:, ::-1] + (1.0, 0.5)
    along = numpy.argwhere(frame[1:] != frame[:-1])[:, ::-1] + (0.5, 1.0)
    return numpy.vstack([across, along]) / FINE


def two_spheres():
    """A grey sphere before a black one, whose arc behind it is hidden."""
    near = unlit(scene.sphere(96, 0.5, (-0.3, 0.0, 0.8)), color=(0.5, 0.5, 0.5))
    far = unlit(scene.sphere(96, 0.6, (0.3, 0.1, -0.4)))
    renderer = scene.renderer_of(near, far)
    window = scene.window_of(renderer, size=SIZE)
    scene.look(renderer, (0.0, 0.0, 5.0))
    return near, far, renderer, window


def test_contours_are_those_of_the_frame():
    _, _, renderer, window = two_spheres()
    svg = Svg(export(window, "spheres.svg"))
    places = steps_in(frame_of(renderer, window))
    distances = svg.distances(places)
    # All steps of the frame are on a line,
    assert distances.max() < 0.5 and distances.mean() < 0.15, (distances.max(), distances.mean())
    # and all of the lines are on a step: nothing that is hidden is there.
    starts, ends = svg.segments()
    shares = numpy.linspace(0.0, 1.0, 5)[:, None, None]
    on_lines = (starts + shares * (ends - starts)).reshape(-1, 2)
    off = [numpy.hypot(*(places - place).T).min() for place in on_lines]
    assert max(off) < 2.0 and numpy.mean(off) < 0.3, (max(off), numpy.mean(off))
    assert sorted(svg.closed) == [False, True]
    print("steps to lines: mean %.3f, largest %.3f pixels; lines to steps: mean %.3f, largest %.3f" % (
        distances.mean(), distances.max(), numpy.mean(off), max(off)))


def test_svg_and_pdf_show_the_lines():
    _, _, _, window = two_spheres()
    window.Render()
    for option, pixels in ((0.0, 25.4 / 96), (0.1, 0.1)):
        svg_file = export(window, "page.svg", MillimetresPerPixel=option)
        pdf_file = export(window, "page.pdf", MillimetresPerPixel=option)
        svg = Svg(svg_file, pixels)
        expected = (SIZE[0] * pixels, SIZE[1] * pixels)
        assert numpy.abs(numpy.subtract(svg.size, expected)).max() < 1e-4, svg.size
        report = subprocess.run(["pdfinfo", pdf_file], capture_output=True, text=True, check=True).stdout
        points = [float(number) for number in
                  re.search(r"Page size: *([\d.]+) x ([\d.]+) pts", report).groups()]
        assert numpy.abs(numpy.array(points) / 72 * 25.4 - expected).max() < 0.01, report
        # At this resolution a pixel of the window is one of the picture.
        half_width = 0.5 * 0.35 / pixels
        ink = (half_width + 0.5 - svg.distances(pixel_centres(*SIZE))).clip(0.0, 1.0)
        for path in (svg_file, pdf_file):
            drawn = rasterise(path, round(25.4 / pixels))
            assert drawn.shape == SIZE[::-1], drawn.shape
            difference = numpy.abs(drawn.ravel() - ink)
            assert difference.mean() < 0.005 and drawn.mean() > 0.01, (path, difference.mean())
            print(os.path.basename(path), "mean difference", difference.mean())


def test_pen_and_lines_of_the_style():
    near, _, _, window = two_spheres()
    assert Svg(export(window, "pen.svg")).pens == {("#000000", "0.35")}
    style = near.GetMapper().GetStyle()
    style.OutlineOn()
    style.SetOutlineColor(1.0, 0.0, 0.2)
    style.SetOutlineWidth(2.0)
    svg = Svg(export(window, "pen.svg"))
    assert svg.pens == {("#000000", "0.35"), ("#ff0033", "0.5292")}, svg.pens
    style.SetOutlineWidthUnit(hachure.vtkPatternLayer.MILLIMETRES)
    style.OutlineSilhouetteOff()
    svg = Svg(export(window, "pen.svg"))
    assert svg.pens == {("#000000", "0.35")}, svg.pens
    style.OutlineSilhouetteOn()
    assert ("#ff0033", "2") in Svg(export(window, "pen.svg")).pens
    style.SetDotsPerInch(300.0)
    assert abs(Svg(export(window, "pen.svg")).size[0] - SIZE[0] * 25.4 / 300) < 1e-4


def test_flat_shading_has_contours_along_edges():
    actor = unlit(scene.sphere(9))
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=SIZE)
    scene.look(renderer, (0.3, 0.4, 3.0))
    places = steps_in(frame_of(renderer, window))
    distances = {}
    for shading in ("Gouraud", "Flat"):
        getattr(actor.GetProperty(), "SetInterpolationTo" + shading)()
        distances[shading] = Svg(export(window, "flat.svg")).distances(places)
    largest = {shading: values.max() for shading, values in distances.items()}
    assert largest["Flat"] < 0.3 and largest["Gouraud"] > 2.0 * largest["Flat"], largest


def test_depth_of_every_renderer():
    """Two viewports, and a renderer on top that clears the depth of those below."""
    near, far, renderer, window = two_spheres()
    alone = Svg(export(window, "alone.svg"))
    renderer.SetViewport(0.5, 0.0, 1.0, 1.0)
    left = scene.renderer_of(unlit(scene.plane(1.0)))
    left.SetViewport(0.0, 0.0, 0.5, 1.0)
    scene.look(left, (0.0, 0.0, 5.0))
    window.AddRenderer(left)
    window.SetNumberOfLayers(2)
    top = scene.renderer_of()
    top.SetLayer(1)
    window.AddRenderer(top)
    window.SetSize(2 * SIZE[0], SIZE[1])
    svg = Svg(export(window, "viewports.svg"))
    right = [line for line in svg.lines if line[:, 0].min() > SIZE[0]]
    assert len(svg.lines) == 3 and len(right) == 2
    for line, same in zip(right, alone.lines):
        assert numpy.abs(line.min(axis=0) - same.min(axis=0) - (SIZE[0], 0)).max() < 0.5
        assert numpy.abs(line.max(axis=0) - same.max(axis=0) - (SIZE[0], 0)).max() < 0.5
    # What one renderer alone has.
    exporter = hachure.vtkPatternVectorExporter()
    exporter.SetRenderWindow(window)
    exporter.SetActiveRenderer(left)
    exporter.SetFileName(file_of("left.svg"))
    exporter.Write()
    assert len(Svg(exporter.GetFileName()).lines) == 1


def test_clipped_surfaces_and_hidden_blocks():
    near, far, renderer, window = two_spheres()
    far.VisibilityOff()
    near.SetScale(1.0, 1.3, 1.0)
    near.RotateZ(20.0)
    plane = vtkPlane()
    plane.SetOrigin(-0.2, 0.0, 0.0)
    plane.SetNormal(-1.0, 0.3, 0.2)
    near.GetMapper().AddClippingPlane(plane)
    svg = Svg(export(window, "clipped.svg"))
    distances = svg.distances(steps_in(frame_of(renderer, window)))
    assert distances.max() < 0.5, distances.max()

    blocks = vtkMultiBlockDataSet()
    inner = vtkMultiBlockDataSet()
    inner.SetBlock(0, scene.sphere(48, 0.3, (0.5, 0.0, 0.0)).GetOutput())
    blocks.SetBlock(0, scene.sphere(48, 0.3, (-0.5, 0.0, 0.0)).GetOutput())
    blocks.SetBlock(1, inner)
    actor = unlit(blocks)
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=SIZE)
    scene.look(renderer)
    assert Svg(export(window, "blocks.svg")).closed == [True, True]
    actor.GetMapper().SetCompositeDataDisplayAttributes(vtkCompositeDataDisplayAttributes())
    actor.GetMapper().GetCompositeDataDisplayAttributes().SetBlockVisibility(inner, False)
    svg = Svg(export(window, "blocks.svg"))
    assert svg.closed == [True] and svg.lines[0][:, 0].max() < SIZE[0] / 2


def test_what_is_off_is_not_there():
    near, far, renderer, window = two_spheres()
    renderer.SetBackground(0.2, 0.4, 0.6)
    svg = Svg(export(window, "off.svg"))
    assert svg.background == ["#336699"] and len(svg.lines) == 2
    svg = Svg(export(window, "off.svg", Silhouettes=False, Background=False))
    assert svg.background == [] and svg.lines == []
    near.VisibilityOff()
    svg = Svg(export(window, "off.svg"))
    assert svg.closed == [True]
    far.VisibilityOff()
    assert Svg(export(window, "off.svg")).lines == []


def test_errors():
    _, _, _, window = two_spheres()
    exporter = hachure.vtkPatternVectorExporter()
    exporter.SetFileName(file_of("errors.svg"))
    exporter.Write()
    scene.expect_messages("No render window provided")
    exporter.SetRenderWindow(window)
    exporter.SetFileName(None)
    exporter.Write()
    scene.expect_messages("FileName: none is set")
    export(window, "errors.eps")
    scene.expect_messages("expected a name that ends with .svg or .pdf")
    path = export(window, os.path.join("no", "folder.pdf"))
    scene.expect_messages("No such file or directory")
    assert not os.path.exists(path)
    assert not [name for name in os.listdir(OUT) if name.endswith(".part")]


scene.run(globals())
