# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the figures share: white paper, a light, pictures side by side, and the skull."""

import pathlib
import sys

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

DATA = pathlib.Path(__file__).resolve().parents[1] / "Data"
SCALE = 2  # of what is drawn to what is kept
GAMMA = 2.2
LEVELS = 31  # of brightness in a file: the eye does not tell more apart in strokes


class Sheet:
    """A window that draws, and the pictures taken of it."""

    def __init__(self, width, height, light=(-35, 40)):
        """light: the direction of the main light, degrees right of and above the viewer."""
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(SCALE * width, SCALE * height)
        self.window.AddRenderer(self.renderer)
        self.camera = self.renderer.GetActiveCamera()
        for azimuth, elevation, intensity in ((*light, 0.9), (50, 0, 0.35)):
            light = vtk.vtkLight()
            light.SetLightTypeToCameraLight()
            light.SetDirectionAngle(elevation, azimuth)
            light.SetIntensity(intensity)
            self.renderer.AddLight(light)

    def add(self, mapper):
        """Shows a surface; the marks of its pattern are as large in what is kept as its style says."""
        if hasattr(mapper, "GetStyle"):
            mapper.GetStyle().SetPixelScale(SCALE)
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        self.renderer.AddActor(actor)
        return actor

    def look(self, position, focal_point, up=(0, 0, 1), angle=30):
        self.camera.SetPosition(*position)
        self.camera.SetFocalPoint(*focal_point)
        self.camera.SetViewUp(*up)
        self.camera.SetViewAngle(angle)
        self.renderer.ResetCameraClippingRange()

    def draw(self):
        """The next frame: patterns move on from the one before."""
        self.renderer.ResetCameraClippingRange()
        self.window.Render()

    def picture(self):
        """The last frame as linear light[row from below, column, colour], averaged to its size."""
        width, height = self.window.GetSize()
        data = vtk.vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, width - 1, height - 1, 1, data, 0)
        light = (vtk_to_numpy(data).reshape(height, width, 3) / 255.0) ** GAMMA
        return light.reshape(height // SCALE, SCALE, width // SCALE, SCALE, 3).mean(axis=(1, 3))


def save(pictures, default, levels=LEVELS):
    """Writes rows of pictures, the first row on top, to the file named on the command line."""
    light = numpy.vstack([numpy.hstack(row) for row in reversed(pictures)])
    values = (255 * numpy.round(levels * light ** (1 / GAMMA)) / levels).astype(numpy.uint8)
    if (numpy.ptp(values, axis=2) == 0).all():
        values = values[..., :1]
    image = vtk.vtkImageData()
    image.SetDimensions(light.shape[1], light.shape[0], 1)
    flat = numpy.ascontiguousarray(values).reshape(-1, values.shape[2])
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    writer = vtk.vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetCompressionLevel(9)
    writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else default)
    writer.Write()


def placed_bone(file, isovalue):
    """A surface of a scan, about as large as a ball of radius 1 about the origin."""
    reader = vtk.vtkXMLImageDataReader()
    reader.SetFileName(str(file))
    bone = vtk.vtkFlyingEdges3D()
    bone.SetInputConnection(reader.GetOutputPort())
    bone.SetValue(0, isovalue)
    bone.Update()
    centre, size = bone.GetOutput().GetCenter(), bone.GetOutput().GetLength()
    place = vtk.vtkTransform()
    place.Scale(*[3 / size] * 3)
    place.Translate(*[-c for c in centre])
    placed = vtk.vtkTransformPolyDataFilter()
    placed.SetTransform(place)
    placed.SetInputConnection(bone.GetOutputPort())
    placed.Update()
    return placed.GetOutput()


def skull():
    """The bone of a scan; it looks along -y."""
    return placed_bone(DATA / "skull.vti", 2.9)
