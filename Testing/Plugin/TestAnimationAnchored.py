# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Anchored, a time has one picture, in whatever order times are drawn."""

import animation_scene as time
import pattern_scene as scene
import view_pictures
from paraview import simple

FRAMES = 3
OPTIONS = {
    "Pattern": {"Style": "cross-hatch"},
    "Noise": {"Style": "phasor"},
    "Stipple": {"NumberOfPoints": 1000, "Size": 3},
    "ViewTexture": {},
}


def open_scene(source, size, animate):
    """All representations of the source, one above the other, as they are drawn at the first time; a camera goes around
    them later."""
    time.clock(FRAMES, 0, FRAMES - 1)
    animate()
    where = scene.view((90, 320))
    views = view_pictures.painted("front", view_pictures.waves(128), (0, 0, 8 * size), extremes=60, size=128)
    options = dict(OPTIONS, ViewTexture={"Manifest": view_pictures.manifest("views", views, finestLevel=2)})
    for row, (prefix, properties) in enumerate(options.items()):
        moved = simple.Transform(Input=source)
        moved.Transform.Translate = [0, (row - 1.5) * size, 0]
        display = time.show(moved, where, prefix, Tracking="Anchored", ToneGamma=0.5, **properties)
        time.track(display, prefix + "ToneGamma", 0.5, 1.5)
        if prefix in ("Pattern", "Noise"):
            time.track(display, prefix + "Scale", 1, 1.4)
    scene.look(where, (0, 0, 8.5 * size))
    simple.Render(where)
    time.fix_clipping(where, 6.0 * size)
    time.orbit(where, 8.5 * size)
    return where


def draw(where, order, name):
    """Pictures by their times."""
    return {moment: time.picture_at(where, moment, "%s-%d" % (name, moment)) for moment in order}


def different(first, second):
    """Times of different pictures."""
    return [moment for moment in first if (first[moment] != second[moment]).any()]


def check(source, size, name, animate=lambda: None):
    """Of a time series, or of a source that is animated."""
    where = open_scene(source, size, animate)
    forwards = draw(where, range(FRAMES), name)
    for moment in range(1, FRAMES):
        assert scene.difference(forwards[moment - 1], forwards[moment]) > 1, moment
    backwards = draw(where, (1, 0), name)
    assert not different(backwards, forwards), (name, different(backwards, forwards))
    simple.Delete(where)
    where = open_scene(source, size, animate)
    scrubbed = draw(where, (2, 0, 1), name)
    assert not different(scrubbed, forwards), (name, different(scrubbed, forwards))
    simple.Delete(where)


def sweep():
    """Animates the value of the isosurface."""
    disk.Isosurfaces = [400]
    time.track(disk, "ContourValues", 400, 420)


check(time.tube_series(FRAMES), 1.0, "anchored-tube")
disk = time.disk_contour()
check(disk, 11.0, "anchored-disk", sweep)
