# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stipples on surfaces whose cells change from frame to frame: most of them stay."""

import numpy
import pattern_scene as scene
from stipple_scene import stage, stipple_style
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

EXTENT = 14
STYLE = {"Size": 5.0, "NumberOfPoints": 4000}


def isosurface(value=150.0):
    """Of a function with waves; its triangles are others for every value."""
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(*(-EXTENT, EXTENT) * 3)
    contour = vtkContourFilter()
    contour.SetInputConnection(source.GetOutputPort())
    contour.SetValue(0, value)
    return contour


def sweep(style, step=0.5, frames=6):
    """Pictures, linear ink, of the isosurface while its value grows."""
    contour = isosurface()
    _, _, window = stage(contour, style, (0.0, 0.0, 4.0 * EXTENT))
    pictures = []
    for frame in range(frames):
        contour.SetValue(0, 150.0 + step * frame)
        pictures.append(1.0 - scene.linear(scene.draw(window)).mean(axis=2))
    return pictures


def changes(pictures, mask):
    """Change of the ink of every step, as part of that of pictures that have nothing in common."""
    return numpy.array([
        1.0 - numpy.corrcoef(a[mask], b[mask])[0, 1] for a, b in zip(pictures, pictures[1:])])


def inside():
    """Pixels of the surface in all pictures, away from its outline."""
    mask = numpy.logical_and.reduce([picture > 0.99 for picture in sweep(stipple_style(1.0))])
    for axis in (0, 1):
        for shift in (-6, 6):
            mask &= numpy.roll(mask, shift, axis)
    assert mask.mean() > 0.1, mask.mean()
    return mask


def test_isosurface_sweep():
    """Little of the picture changes in a frame, and the ink stays."""
    mask = inside()
    attached = sweep(stipple_style(0.3, **STYLE))
    anew = sweep(stipple_style(0.3, Life=0, **STYLE))
    boil, without = changes(attached, mask), changes(anew, mask)
    print("changes by", numpy.median(boil), boil.max(), "without", numpy.median(without))
    assert without.min() > 0.8 and boil.max() < 0.2, (boil, without)
    inks = numpy.array([picture[mask].mean() for picture in attached])
    print("ink", inks)
    # Where a surface bends as fast as stipples follow each other, there are some too few of them.
    assert abs(inks - 0.3).max() < 0.05 and abs(inks - inks[0]).max() < 0.02, inks


def test_still_pictures_stay():
    contour = isosurface()
    _, _, window = stage(contour, stipple_style(**STYLE), (0.0, 0.0, 4.0 * EXTENT))
    for value in (150.0, 151.0, 153.0):
        contour.SetValue(0, value)
        first = scene.draw(window)
        assert (scene.draw(window) == first).all(), value


def test_what_starts_anew():
    """A surface of another origin, and one that is anchored again, have stipples of their own."""
    style = stipple_style(**STYLE)
    _, _, window = stage(isosurface(153.0), style, (0.0, 0.0, 4.0 * EXTENT))
    own = scene.draw(window)
    actor, renderer, window = stage(isosurface(150.0), style, (0.0, 0.0, 4.0 * EXTENT))
    window.Render()
    other = isosurface(153.0)
    actor.GetMapper().SetInputConnection(other.GetOutputPort())
    assert (scene.draw(window) == own).all()
    contour = isosurface(150.0)
    actor, renderer, window = stage(contour, style, (0.0, 0.0, 4.0 * EXTENT))
    window.Render()
    contour.SetValue(0, 153.0)
    assert (scene.draw(window) != own).any()
    actor.GetMapper().Reanchor(renderer)
    assert (scene.draw(window) == own).all()


if __name__ == "__main__":
    scene.run(globals())
