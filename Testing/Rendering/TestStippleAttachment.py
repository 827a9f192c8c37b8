# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stipples on surfaces whose cells change from frame to frame: most of them stay."""

import numpy
import pattern_scene as scene
from stipple_scene import stipple_style
from sweep_scene import changes, inside, isosurface, stage, sweep

FRAMES = 6
STYLE = {"Size": 5.0, "NumberOfPoints": 4000}


def test_isosurface_sweep():
    """Little of the picture changes in a frame, and the ink stays."""
    mask = inside(stipple_style(1.0), FRAMES)
    attached = sweep(stipple_style(0.3, **STYLE), FRAMES)
    anew = sweep(stipple_style(0.3, Life=0, **STYLE), FRAMES)
    boil, without = changes(attached, mask), changes(anew, mask)
    print("changes by", numpy.median(boil), boil.max(), "without", numpy.median(without))
    assert without.min() > 0.8 and boil.max() < 0.2, (boil, without)
    inks = numpy.array([picture[mask].mean() for picture in attached])
    print("ink", inks)
    # Where a surface bends as fast as stipples follow each other, there are some too few of them.
    assert abs(inks - 0.3).max() < 0.05 and abs(inks - inks[0]).max() < 0.02, inks


def test_still_pictures_stay():
    contour = isosurface()
    _, _, window = stage(contour, stipple_style(**STYLE))
    for value in (150.0, 151.0, 153.0):
        contour.SetValue(0, value)
        first = scene.draw(window)
        assert (scene.draw(window) == first).all(), value


def test_what_starts_anew():
    """A surface of another origin, and one that is anchored again, have stipples of their own."""
    style = stipple_style(**STYLE)
    _, _, window = stage(isosurface(153.0), style)
    own = scene.draw(window)
    actor, renderer, window = stage(isosurface(150.0), style)
    window.Render()
    other = isosurface(153.0)
    actor.GetMapper().SetInputConnection(other.GetOutputPort())
    assert (scene.draw(window) == own).all()
    contour = isosurface(150.0)
    actor, renderer, window = stage(contour, style)
    window.Render()
    contour.SetValue(0, 153.0)
    assert (scene.draw(window) != own).any()
    actor.GetMapper().Reanchor(renderer)
    assert (scene.draw(window) == own).all()


if __name__ == "__main__":
    scene.run(globals())
