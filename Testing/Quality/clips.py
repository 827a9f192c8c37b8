# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws clips as linear ink, with the exact motion between their frames, and measures them."""

import hachure
import numpy
import scenes
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow

GAMMA = 2.2
EVERY_WAY = ("SlideRatio", "MeanSlide")  # slides in every direction
VALUES = ("SlideRatio", "NormalSlideRatio", "Coherence", "MeanSlide", "MeanMotion", "LargestMotion",
          "BoilMedian", "BoilLargest", "Pop", "Contrast", "FacingSlope", "DistanceSlope", "ToneError")


def image_of(values):
    """A vtkImageData of values[row, column] or [row, column, component], row 0 at the bottom."""
    height, width = values.shape[:2]
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    flat = numpy.ascontiguousarray(values, dtype=numpy.float32).reshape(height * width, -1)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=1))
    return image


def array_of(image):
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)


class Studio:
    """One window, in which everything is drawn."""

    def __init__(self, size):
        self.size = size
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(size, size)

    def motions(self, surfaces, cameras):
        """Motion from every frame to the next; the last one, to itself, tells where surface is."""
        pairs = zip(cameras, cameras[1:] + cameras[-1:])
        return [hachure.screen_motion(self.window, (self.size, self.size), pair, surfaces)
                for pair in pairs]

    def inks(self, surfaces, cameras, style):
        """Linear ink of every frame, 1 = full; patterns begin anew."""
        renderer = vtkRenderer()
        renderer.SetBackground(1.0, 1.0, 1.0)
        for surface in surfaces:
            mapper = hachure.vtkPatternMapper()
            mapper.SetInputData(surface)
            mapper.SetStyle(style)
            actor = vtkActor()
            actor.SetMapper(mapper)
            renderer.AddActor(actor)
        self.window.AddRenderer(renderer)
        frames = []
        for camera in cameras:
            renderer.GetActiveCamera().DeepCopy(camera)
            self.window.Render()
            frames.append(self.ink())
        self.window.RemoveRenderer(renderer)
        return frames

    def ink(self):
        data = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, self.size - 1, self.size - 1, 0, data, 0)
        pixels = vtk_to_numpy(data).reshape(self.size, self.size, 3)[..., 0]
        return (1.0 - (pixels / 255.0) ** GAMMA).astype(numpy.float32)


def measure(frames, motions, tone=None, strokes=False):
    """The values of a clip by name, NaN where not defined, and slide and boil of every step.

    tone: the even tone that was asked for; strokes: whether slides show across the marks alone.
    """
    metrics = hachure.vtkPatternMetrics()
    metrics.SetWavelength(scenes.WAVELENGTH)
    for frame, motion in zip(frames, motions):
        metrics.AddFrame(image_of(frame))
        metrics.AddMotion(motion)
        if tone is not None:
            seen = array_of(motion)[..., 5] > 0
            metrics.AddTone(image_of(numpy.where(seen, tone, -1.0)))
    metrics.Update()
    table = metrics.GetOutput()
    found = {table.GetValueByName(row, "Metric").ToString():
             table.GetValueByName(row, "Value").ToDouble() for row in range(table.GetNumberOfRows())}
    if "NormalSlideRatio" not in found:
        raise RuntimeError("the motion of this clip cannot be measured; see VTK's message")
    steps = metrics.GetOutput(1)
    slide = "NormalSlide" if strokes else "Slide"
    columns = {name: vtk_to_numpy(steps.GetColumnByName(name))[:len(frames) - 1]
               for name in (slide, "Boil")}
    names = [name for name in VALUES if name in found and not (strokes and name in EVERY_WAY)]
    return {name: found[name] for name in names}, columns


def followed(frame, motion):
    """frame, taken at where the surface seen at each pixel has moved to; NaN where it is not seen."""
    values = array_of(motion)
    y, x = numpy.mgrid[0:frame.shape[0], 0:frame.shape[1]]
    x = numpy.clip(x + values[..., 0], 0, frame.shape[1] - 1.001)
    y = numpy.clip(y + values[..., 1], 0, frame.shape[0] - 1.001)
    column, row = x.astype(int), y.astype(int)
    x, y = x - column, y - row
    lower = frame[row, column] * (1 - x) + frame[row, column + 1] * x
    upper = frame[row + 1, column] * (1 - x) + frame[row + 1, column + 1] * x
    return numpy.where(values[..., 2] > 0, lower * (1 - y) + upper * y, numpy.nan)


def differences(frames, motions):
    """|next frame, moved back, - frame| of every step; 0 where a point is not seen in both."""
    return [numpy.nan_to_num(numpy.abs(followed(after, motion) - before))
            for before, after, motion in zip(frames, frames[1:], motions)]
