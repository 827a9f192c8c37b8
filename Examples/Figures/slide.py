# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What shows how patterns slide over a surface: pins stuck in it, and numbers."""

import hachure
import numpy
import vtk
from sheet import SCALE
from vtk.util.numpy_support import vtk_to_numpy


def pin(sheet, spacing, radius):
    """Sticks a red pin into the surface through some of the dots in the last frame.

    spacing: of the pins, in pixels; radius: of their heads, in scene units. Where the pattern slides,
    dots leave their pins.
    """
    ink = 1 - sheet.picture().mean(axis=2)
    picker = vtk.vtkCellPicker()
    picker.SetTolerance(0)
    heads = vtk.vtkPoints()
    height, width = ink.shape
    for row in range(spacing // 2, height, spacing):
        for column in range(spacing // 2, width, spacing):
            x, y = middle_of_dot(ink, column, row)
            if x and picker.Pick(SCALE * (x + 0.5), SCALE * (y + 0.5), 0, sheet.renderer):
                heads.InsertNextPoint(picker.GetPickPosition())
    places = vtk.vtkPolyData()
    places.SetPoints(heads)
    ball = vtk.vtkSphereSource()
    ball.SetRadius(radius)
    glyphs = vtk.vtkGlyph3D()
    glyphs.SetInputData(places)
    glyphs.SetSourceConnection(ball.GetOutputPort())
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(glyphs.GetOutputPort())
    actor = sheet.add(mapper)
    actor.GetProperty().SetColor(0.9, 0.1, 0.05)
    actor.GetProperty().SetLighting(False)


def middle_of_dot(ink, x, y, reach=6):
    """The centre of gravity of the ink around a place, found in some steps; None, None without any."""
    for _ in range(8):
        left, below = max(round(x) - reach, 0), max(round(y) - reach, 0)
        part = ink[below:below + 2 * reach + 1, left:left + 2 * reach + 1] ** 2
        if part.sum() < 5:
            return None, None
        y, x = (weights @ numpy.arange(len(weights)) / part.sum() + start
                for weights, start in ((part.sum(axis=1), below), (part.sum(axis=0), left)))
    return x, y


class Slide:
    """Measures the slide of a pattern that one similarity carries, over a still surface."""

    def __init__(self, sheet, mapper, parts):
        """parts: the surface in parts (polydata), for each of which there is a result."""
        self.sheet, self.mapper, self.parts = sheet, mapper, parts
        self.before = None
        self.sums = numpy.zeros((len(parts), 2))

    def step(self):
        """Call it after every frame."""
        frame = [0.0] * 6
        self.mapper.GetDrawnFrame(self.sheet.renderer, frame)
        camera = vtk.vtkCamera()
        camera.DeepCopy(self.sheet.camera)
        if self.before:
            self.add(*self.before, frame, camera)
        self.before = frame, camera

    def add(self, old, camera, new, camera_after):
        size = [length // SCALE for length in self.sheet.window.GetSize()]
        motion = hachure.screen_motion(self.sheet.window, size, (camera, camera_after), self.parts)
        values = vtk_to_numpy(motion.GetPointData().GetScalars()).reshape(size[1], size[0], -1)
        y, x = numpy.mgrid[0:size[1], 0:size[0]] + 0.5
        origin, axis, origin_after, axis_after = (
            complex(f[i], f[i + 1]) for f in (old, new) for i in (0, 2))
        carried = origin_after + axis_after / axis * (x + 1j * y - origin)
        went = x + values[..., 0] + 1j * (y + values[..., 1])
        for part, total in enumerate(self.sums):
            seen = (values[..., 2] > 0) & (values[..., 5] == part + 1)
            total += numpy.abs(carried - went)[seen].sum(), seen.sum()

    def means(self):
        """Pixels per frame, for every part."""
        return self.sums[:, 0] / self.sums[:, 1]
