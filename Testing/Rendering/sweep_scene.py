# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""An isosurface whose value grows, so that its cells change from frame to frame, and how its pictures do."""

import numpy
import pattern_scene as scene
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

EXTENT = 14
DISTANCE = 4.0 * EXTENT  # of the viewer, who sees all of it


def isosurface(value=150.0):
    """Of a function with waves; its triangles are others for every value."""
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(*(-EXTENT, EXTENT) * 3)
    contour = vtkContourFilter()
    contour.SetInputConnection(source.GetOutputPort())
    contour.SetValue(0, value)
    return contour


def stage(data, style, distance=DISTANCE, size=(256, 256)):
    actor = scene.actor_of(data, style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=size)
    scene.look(renderer, (0.0, 0.0, distance))
    return actor, renderer, window


def sweep(style, frames, step=0.5):
    """Pictures, linear ink, of the isosurface while its value grows."""
    contour = isosurface()
    _, _, window = stage(contour, style)
    pictures = []
    for frame in range(frames):
        contour.SetValue(0, 150.0 + step * frame)
        pictures.append(1.0 - scene.linear(scene.draw(window)).mean(axis=2))
    return pictures


def changes(pictures, mask):
    """Change of the ink of every step, as part of that of pictures that have nothing in common."""
    return numpy.array([
        1.0 - numpy.corrcoef(a[mask], b[mask])[0, 1] for a, b in zip(pictures, pictures[1:])])


def inside(full, frames):
    """Pixels of the surface in all pictures, away from its outline; full: a style of tone 1."""
    mask = numpy.logical_and.reduce([picture > 0.99 for picture in sweep(full, frames)])
    for axis in (0, 1):
        for shift in (-6, 6):
            mask &= numpy.roll(mask, shift, axis)
    assert mask.mean() > 0.1, mask.mean()
    return mask
