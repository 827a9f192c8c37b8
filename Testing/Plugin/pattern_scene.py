# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the representation share: arguments, views without decoration, pictures as arrays."""

import os
import sys

import numpy
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from paraview.vtk.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from paraview.vtk.vtkIOImage import vtkPNGWriter

SIZE = (400, 300)

plugin = sys.argv[1]
options = dict(zip(sys.argv[2::2], sys.argv[3::2]))
data_folder = options["-D"]
output_folder = options["-T"]
simple.LoadPlugin(plugin, remote=False, ns=globals())
simple._DisableFirstRenderCameraReset()


def view(size=SIZE, full_detail=True):
    """A new view with a headlight alone, on a grey ground."""
    new = simple.CreateView("RenderView")
    new.ViewSize = list(size)
    new.OrientationAxesVisibility = 0
    new.CenterAxesVisibility = 0
    new.UseColorPaletteForBackground = 0
    new.BackgroundColorMode = "Single Color"
    new.Background = [0.5, 0.5, 0.5]
    new.UseFXAA = 0  # it would soften the strokes
    new.UseLight = 0
    light = simple.AddLight(view=new)
    light.Coords = "Camera"
    light.Position = [0.0, 0.0, 1.0]
    light.FocalPoint = [0.0, 0.0, 0.0]
    if not full_detail:
        new.LODThreshold = 0.0
    return new


def show(source, where, **properties):
    """Shows the source in the view as Pattern, or as the properties say."""
    display = simple.Show(source, where)
    display.Representation = "Pattern"
    display.ColorArrayName = ["POINTS", ""]
    for name, value in properties.items():
        setattr(display, name, value)
    return display


def look(where, position, focal=(0.0, 0.0, 0.0), up=(0.0, 1.0, 0.0), angle=30.0):
    """Puts the camera of a view."""
    where.CameraPosition = list(position)
    where.CameraFocalPoint = list(focal)
    where.CameraViewUp = list(up)
    where.CameraViewAngle = angle


def picture(where, name=None):
    """The view as an array of bytes, see array(); written to name.png if there is a name."""
    simple.Render(where)
    image = where.CaptureWindow(1)
    if name:
        writer = vtkPNGWriter()
        writer.SetFileName(os.path.join(output_folder, name + ".png"))
        writer.SetInputData(image)
        writer.Write()
    return array(image)


def array(image):
    """The image as an array height x width x 3 of bytes, rows upwards."""
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].copy()


def linear(shown):
    """Light of a picture, from 0 to 1, in which inks mix."""
    return (shown / 255.0) ** 2.2


def difference(first, second):
    """Mean absolute difference of two pictures in levels."""
    return numpy.abs(first.astype(int) - second.astype(int)).mean()


class Messages:
    """Collects what would be written to the error output while it is in use."""

    def __enter__(self):
        self.previous = vtkOutputWindow.GetInstance()
        self.verbosity = vtkLogger.GetCurrentVerbosityCutoff()
        self.window = vtkStringOutputWindow()
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        vtkOutputWindow.SetInstance(self.window)
        return self

    def __exit__(self, *_):
        self.text = self.window.GetOutput()
        vtkOutputWindow.SetInstance(self.previous)
        vtkLogger.SetStderrVerbosity(self.verbosity)
