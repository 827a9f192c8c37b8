# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the representation View-dependent Texture share: manifests of painted views, and its pictures."""

import json
import os
import sys

import numpy
import pattern_scene as scene
from paraview import simple
from paraview.vtk.util.numpy_support import numpy_to_vtk
from paraview.vtk.vtkCommonDataModel import vtkImageData
from paraview.vtk.vtkIOImage import vtkPNGWriter

LABEL = "View-dependent Texture"
STYLE_FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Rendering/Presets/view.json")
RED, BLUE, WHITE, GREY = (200, 30, 30), (30, 30, 200), (255, 255, 255), (128, 128, 128)

plane = simple.Plane(Origin=[-2, -2, 0], Point1=[2, -2, 0], Point2=[-2, 2, 0])


def folder():
    """One of this test's own."""
    test = os.path.splitext(os.path.basename(sys.argv[0]))[0]
    name = os.path.join(scene.output_folder, test)
    os.makedirs(name, exist_ok=True)
    return name


def paint(name, color, size=64):
    """A picture in the folder, of one colour or of an array of colours."""
    pixels = numpy.broadcast_to(numpy.array(color, dtype=numpy.uint8), (size, size, 3))
    image = vtkImageData()
    image.SetDimensions(size, size, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(os.path.join(folder(), name))
    writer.SetInputData(image)
    writer.Write()


def waves(size=256, period=24.0):
    """Colours that are told apart everywhere."""
    y, x = numpy.mgrid[0:size, 0:size] * (2.0 * numpy.pi / period)
    colors = [numpy.sin(x + 0.5 * y), numpy.cos(y), numpy.sin(x - y)]
    return 127.5 + 120.0 * numpy.stack(colors, axis=2)


def painted(name, color, position=(0, 0, 3), extremes=None, size=64):
    """A view in one colour, for a manifest; extremes: degrees from its camera, which makes it a dependent one."""
    paint(name + ".png", color, size)
    view = {"name": name, "image": name + ".png", "camera": {"position": position, "focalPoint": [0, 0, 0]}}
    if extremes:
        distance = numpy.linalg.norm(position)
        along, across = (distance * f(numpy.radians(extremes)) for f in (numpy.cos, numpy.sin))
        points = (across, 0, along), (0, across, along), (-across, 0, along), (0, -across, along)
        view.update(kind="dependent", extremes=points)
    return view


def manifest(name, *views, **cells):
    """Writes it to the folder, and returns its name."""
    file_name = os.path.join(folder(), name + ".json")
    with open(file_name, "w", encoding="ascii") as file:
        json.dump({"hachureViews": 1, "views": views, "cells": cells}, file)
    return file_name


def style_file(name="style", **field):
    """The style of views with these keys in place of its own."""
    with open(STYLE_FILE, encoding="ascii") as file:
        style = json.load(file)
    style["layers"][0]["field"].update(field)
    file_name = os.path.join(folder(), name + ".json")
    with open(file_name, "w", encoding="ascii") as file:
        json.dump(style, file)
    return file_name


def show(where, source=plane, prefix="ViewTexture", **properties):
    """Shows the source in a view."""
    label = LABEL if prefix == "ViewTexture" else prefix
    renamed = {prefix + name: value for name, value in properties.items()}
    return scene.show(source, where, Representation=label, **renamed)


def draw(name=None, position=(0, 0, 3), size=(100, 100), **properties):
    """A picture of a plane that fills the view, or of another source."""
    where = scene.view(size)
    show(where, **properties)
    scene.look(where, position)
    shown = scene.picture(where, name)
    simple.Delete(where)
    return shown


def aside(degrees, distance=3.0):
    """A camera's place beside that of (0, 0, distance)."""
    angle = numpy.radians(degrees)
    return distance * numpy.sin(angle), 0, distance * numpy.cos(angle)


def is_color(shown, color, tolerance=6):
    """Whether the middle of a picture has this colour."""
    height, width, _ = shown.shape
    middle = shown[height // 2 - 4 : height // 2 + 4, width // 2 - 4 : width // 2 + 4].reshape(-1, 3)
    return numpy.abs(middle.mean(axis=0) - color).max() <= tolerance


def same(first, second):
    """Whether two pictures are equal."""
    return (first == second).all()
