# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws clips: linear ink, the exact motion between the frames, and the cells of objects."""

import hachure
import numpy
import objects
import scenes
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkCellCenters, vtkPolyDataNormals
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)

GAMMA = 2.2
CELL_WAVELENGTHS = 3.0  # side of the cells


def image_of(values):
    """A vtkImageData of values[row, column] or [row, column, component], row 0 at the bottom."""
    height, width = values.shape[:2]
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    flat = numpy.ascontiguousarray(values).reshape(height * width, -1)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=1))
    return image


def array_of(image):
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)


def cell_colors(surface, label, width):
    """A colour for every polygon: equal in boxes of the surface at rest and on one side of them.

    The number of a cell is the colour read as a number to the base 256; other labels, other cells.
    """
    centres, normals = vtkCellCenters(), vtkPolyDataNormals()
    for apply in (centres, normals):
        apply.SetInputData(surface)
    normals.SplittingOff()
    normals.ConsistencyOff()
    normals.ComputeCellNormalsOn()
    normals.Update()
    centres.Update()
    boxes = numpy.floor(vtk_to_numpy(centres.GetOutput().GetPoints().GetData()) / width)
    facing = vtk_to_numpy(normals.GetOutput().GetCellData().GetNormals())
    axis = numpy.abs(facing).argmax(axis=1)
    side = 2 * axis + (numpy.take_along_axis(facing, axis[:, None], 1)[:, 0] > 0)
    cells = numpy.unique(numpy.column_stack([boxes, side]), axis=0, return_inverse=True)[1].ravel()
    number = 1 + cells
    return numpy.column_stack([number % 256, number // 256, numpy.full_like(number, label)]).astype(
        numpy.uint8)


class Studio:
    """One window, in which everything is drawn."""

    def __init__(self, size):
        self.size = size
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(size, size)
        self.references = {}

    def motions(self, states, cameras):
        """Motion from every frame to the next; the last one, to itself, tells where surface is."""
        result = []
        for i, camera in enumerate(cameras):
            after = min(i + 1, len(cameras) - 1)
            result.append(hachure.screen_motion(self.window, (self.size, self.size),
                                                (camera, cameras[after]),
                                                list(zip(states[i], states[after]))))
        return result

    def draw(self, mappers, states, cameras, background, lighting=True, lights=None):
        """The colours of every frame; there is a mapper for each surface of a state.

        lights: the direction to the light at every frame; None: it shines from the camera.
        """
        renderer = vtkRenderer()
        renderer.SetBackground(*background)
        lamp = vtkLight()
        if lights:
            renderer.AddLight(lamp)
        for mapper in mappers:
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.GetProperty().SetLighting(lighting)
            renderer.AddActor(actor)
        self.window.AddRenderer(renderer)
        frames = []
        for frame, (surfaces, camera) in enumerate(zip(states, cameras)):
            for mapper, surface in zip(mappers, surfaces):
                mapper.SetInputData(surface)
            if lights:
                lamp.SetPosition(*lights[frame])
            renderer.GetActiveCamera().DeepCopy(camera)
            # A copy alone leaves VTK's matrices as they were where the clipping range stays.
            renderer.GetActiveCamera().Modified()
            self.window.Render()
            frames.append(self.pixels())
        self.window.RemoveRenderer(renderer)
        return frames

    def pixels(self):
        data = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, self.size - 1, self.size - 1, 0, data, 0)
        return vtk_to_numpy(data).reshape(self.size, self.size, 3).copy()

    def inks(self, states, cameras, style, lights=None):
        """Linear ink of every frame, 1 = full; patterns begin anew."""
        mappers = [hachure.vtkPatternMapper() for _ in states[0]]
        for mapper in mappers:
            mapper.SetStyle(style)
        frames = self.draw(mappers, states, cameras, (1, 1, 1), lights=lights)
        return [(1.0 - (frame[..., 0] / 255.0) ** GAMMA).astype(numpy.float32) for frame in frames]

    def reference(self, field, ink):
        """The ink as drawn flat on paper: in the whole picture and with an even tone."""
        key = (field if field in scenes.MAKERS else "screen", ink)
        if key not in self.references:
            style = scenes.new_style(*key, "unlit")
            self.references[key] = self.inks([[objects.square()]], scenes.still(1), style)[0]
        return self.references[key]

    def cells(self, rest, states, cameras):
        """For every frame the cell of the objects seen at each pixel, 0 where there is none.

        Cells are some wavelengths wide where the camera begins, and stay on the objects.
        """
        width = CELL_WAVELENGTHS * scenes.WAVELENGTH * scenes.pixel_width(self.size)
        mappers = []
        colored = [[] for _ in states]
        for label, surface in enumerate(rest):
            mappers.append(vtkPolyDataMapper())
            colors = numpy_to_vtk(cell_colors(surface, label + 1, width), deep=1)
            for result, surfaces in zip(colored, states):
                copy = surface.NewInstance()
                copy.ShallowCopy(surfaces[label])
                copy.GetPointData().SetScalars(None)
                copy.GetCellData().SetScalars(colors)
                result.append(copy)
        frames = self.draw(mappers, colored, cameras, (0, 0, 0), lighting=False)
        return [frame.astype(numpy.int32) @ numpy.array([1, 256, 65536], dtype=numpy.int32)
                for frame in frames]
