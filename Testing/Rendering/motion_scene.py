# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Two states of a scene, the motion between them, and what it should be by separate mathematics."""

import math

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkCamera

SIZE = (640, 480)
EYE = (0.3, -0.2, 3.0)
RADIUS = 0.65


def camera_at(position=EYE, focal_point=(0.0, 0.0, 0.0), parallel=False):
    camera = vtkCamera()
    camera.SetPosition(*position)
    camera.SetFocalPoint(*focal_point)
    camera.SetClippingRange(0.5, 10.0)
    camera.SetParallelProjection(parallel)
    camera.SetParallelScale(1.1)
    return camera


class View:
    """The mathematics of a camera, from its defining parameters alone."""

    def __init__(self, camera):
        self.eye = numpy.array(camera.GetPosition())
        forward = numpy.array(camera.GetFocalPoint()) - self.eye
        self.forward = forward / numpy.linalg.norm(forward)
        right = numpy.cross(self.forward, camera.GetViewUp())
        self.right = right / numpy.linalg.norm(right)
        self.up = numpy.cross(self.right, self.forward)
        self.parallel = bool(camera.GetParallelProjection())
        self.half = math.tan(math.radians(camera.GetViewAngle()) / 2)
        if self.parallel:
            self.half = camera.GetParallelScale()

    def rays(self):
        """Origins and directions through all pixel centres, rows from the bottom up."""
        y, x = numpy.mgrid[0:SIZE[1], 0:SIZE[0]] + 0.5
        step = 2 * self.half / SIZE[1]
        x, y = (x - SIZE[0] / 2)[..., None] * step, (y - SIZE[1] / 2)[..., None] * step
        offsets = x * self.right + y * self.up
        if self.parallel:
            return self.eye + offsets, numpy.broadcast_to(self.forward, offsets.shape)
        return numpy.broadcast_to(self.eye, offsets.shape), offsets + self.forward

    def project(self, points):
        local = points - self.eye
        scale = 1.0 if self.parallel else (local @ self.forward)[..., None]
        flat = numpy.stack([local @ self.right, local @ self.up], axis=-1)
        return flat / scale / (2 * self.half / SIZE[1]) + numpy.array(SIZE) / 2


def on_sphere(view, centre=(0.0, 0.0, 0.0), radius=RADIUS):
    """Where the rays meet a sphere first, NaN where they do not."""
    origins, directions = view.rays()
    offset = origins - centre
    a, b = (directions**2).sum(-1), (offset * directions).sum(-1)
    root = b * b - a * ((offset**2).sum(-1) - radius**2)
    with numpy.errstate(invalid="ignore"):
        return origins + directions * ((-b - numpy.sqrt(root)) / a)[..., None]


def on_plane(view):
    """Where the rays meet the plane z = 0."""
    origins, directions = view.rays()
    return origins - directions * (origins[..., 2] / directions[..., 2])[..., None]


def facing_sphere(view, points, radius=RADIUS):
    to_eye = -view.forward if view.parallel else view.eye - points
    lengths = numpy.linalg.norm(numpy.broadcast_to(to_eye, points.shape), axis=-1) * radius
    return (points * to_eye).sum(-1) / lengths


window = scene.window_of(size=(300, 200))


def compute(before, after, surfaces, occluders=()):
    """u, v, visible, facing, distance and label as images."""
    image = hachure.screen_motion(window, SIZE, (before, after), surfaces, occluders)
    assert image.GetDimensions() == (*SIZE, 1)
    values = vtk_to_numpy(image.GetPointData().GetScalars()).astype(float)
    return numpy.moveaxis(values.reshape(SIZE[1], SIZE[0], 6), 2, 0)


def moved(camera, kind):
    """The camera after a translation, orbit, zoom or roll."""
    result = vtkCamera()
    result.DeepCopy(camera)
    if kind == "translate":
        for get, put in ((camera.GetPosition, result.SetPosition),
                         (camera.GetFocalPoint, result.SetFocalPoint)):
            put(*(numpy.array(get()) + (0.07, -0.04, 0.02)))
    elif kind == "rotate":
        result.Azimuth(7.0)
        result.Elevation(-4.0)
        result.OrthogonalizeViewUp()
    elif kind == "zoom":
        result.SetPosition(*(numpy.array(EYE) * 0.9))
        result.SetParallelScale(1.0)
        result.Zoom(1.05)
    elif kind == "roll":
        result.Roll(11.0)
    return result
