# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stipples as circles of SVG and PDF: those of the drawn frame, in millimetres; hidden ones are missing."""

import os
import subprocess
import sys
import xml.etree.ElementTree

import hachure
import numpy
import pattern_scene as scene
from stipple_scene import stage, stipple_layer, stipple_style
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

OUT = sys.argv[sys.argv.index("-T") + 1]
SIZE = (240, 180)
MILLIMETRES = 25.4 / 96  # per pixel
SVG = "{http://www.w3.org/2000/svg}"


def export(window, name):
    path = os.path.join(OUT, "TestStippleVector-" + name)
    exporter = hachure.vtkPatternVectorExporter()
    exporter.SetRenderWindow(window)
    exporter.SilhouettesOff()
    exporter.SetFileName(path)
    exporter.Write()
    return path


def circles(path):
    """Centres and radii in pixels, y up, of every colour."""
    root = xml.etree.ElementTree.parse(path).getroot()
    height = float(root.get("height")[:-2])
    found = {}
    for group in root.iter(SVG + "g"):
        places = [(float(c.get("cx")), height - float(c.get("cy")), float(c.get("r")))
                  for c in group.findall(SVG + "circle")]
        if places:
            found[group.get("fill")] = numpy.array(places) / MILLIMETRES
    return found


FINE = 4  # pixels of a rasterised page for each of the frame


def rasterised(path):
    """Linear ink of the page with a pixel for each pixel of the frame."""
    width, height = FINE * SIZE[0], FINE * SIZE[1]
    image = os.path.splitext(path)[0] + "-page"
    if path.endswith(".svg"):
        command = ["rsvg-convert", "-w", str(width), "-h", str(height), path, "-o", image + ".png"]
    else:
        command = ["pdftoppm", "-png", "-singlefile", "-scale-to-x", str(width),
                   "-scale-to-y", str(height), path, image]
    subprocess.run(command, check=True)
    reader = vtkPNGReader()
    reader.SetFileName(image + ".png")
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    # Rasterisers mix display-referred colours: their grey is the coverage.
    ink = 1.0 - pixels.reshape(height, width, -1)[:, :, :3].mean(axis=2) / 255.0
    return ink.reshape(SIZE[1], FINE, SIZE[0], FINE).mean(axis=(1, 3))


def test_pages_are_the_drawn_frame():
    _, _, window = stage(scene.sphere(), stipple_style(0.3, Size=4.0), (0.0, 0.0, 2.2), SIZE)
    drawn = 1.0 - scene.linear(scene.draw(window)).mean(axis=2)
    for kind in ("svg", "pdf"):
        page = rasterised(export(window, "frame." + kind))
        difference = numpy.abs(page - drawn).mean()
        print(kind, "differs by", difference, "ink", page.mean(), drawn.mean())
        # Discs of the page reach over the outline by a radius.
        assert difference < 0.01 and abs(page.mean() - drawn.mean()) < 0.005, kind
        shifted = numpy.abs(numpy.roll(page, 2, axis=1) - drawn).mean()
        assert shifted > 5 * difference, "a page that is shifted would be noticed"


def test_inks_and_sizes():
    style = hachure.vtkPatternStyle()
    for seed, color, size in ((1, (1.0, 0.0, 0.0), 4.0), (2, (0.0, 0.0, 1.0), 7.0)):
        layer = stipple_layer(0.15, Seed=seed, Size=size)
        layer.SetColor(*color)
        style.AddLayer(layer)
    _, _, window = stage(scene.sphere(), style, (0.0, 0.0, 2.2), SIZE)
    found = circles(export(window, "inks.svg"))
    assert set(found) == {"#ff0000", "#0000ff"}, set(found)
    assert abs(found["#ff0000"][:, 2].max() - 2.0) < 0.01
    assert abs(found["#0000ff"][:, 2].max() - 3.5) < 0.01


def test_hidden_stipples_are_left_out():
    """Those behind another object, and on the back of their own."""
    actor, renderer, window = stage(scene.sphere(), stipple_style(0.3), (0.0, 0.0, 2.2), SIZE)
    alone = len(circles(export(window, "alone.svg"))["#000000"])
    wall = scene.actor_of(scene.plane(4.0), hachure.vtkPatternStyle())
    wall.SetPosition(2.0, 0.0, 1.0)  # before the right half
    renderer.AddActor(wall)
    window.Render()
    places = circles(export(window, "wall.svg"))["#000000"]
    assert places[:, 0].max() < SIZE[0] / 2 + 1.0, places[:, 0].max()
    assert abs(len(places) / alone - 0.5) < 0.05, (len(places), alone)


def test_renderers_side_by_side():
    style = stipple_style(0.3)
    actor, renderer, window = stage(scene.sphere(), style, (0.0, 0.0, 2.2), SIZE)
    other = scene.renderer_of(actor)
    scene.look(other, (2.2, 0.0, 0.0))
    renderer.SetViewport(0.0, 0.0, 0.5, 1.0)
    other.SetViewport(0.5, 0.0, 1.0, 1.0)
    window.AddRenderer(other)
    places = circles(export(window, "two.svg"))["#000000"]
    left, right = (places[:, 0] < SIZE[0] / 2).sum(), (places[:, 0] > SIZE[0] / 2).sum()
    assert left > 200 and abs(left / right - 1.0) < 0.1, (left, right)


if __name__ == "__main__":
    scene.run(globals())
