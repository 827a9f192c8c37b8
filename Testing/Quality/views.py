# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""View-dependent textures for the report: an object is painted as cameras all around see it."""

import hachure
import numpy
import scenes
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

FINEST = 5  # whose cells are about as large as the pixels of the report
RANGE = 60.0  # degrees from its own camera at which a dependent view has faded
GOLDEN = (1.0 + 5.0 ** 0.5) / 2.0


def directions():
    """The corners of an icosahedron: the report's cameras are between those at the front."""
    corners = [(0.0, a, b * GOLDEN) for a in (1, -1) for b in (1, -1)]
    corners = numpy.array([numpy.roll(corner, turn) for corner in corners for turn in range(3)])
    return corners / numpy.linalg.norm(corners[0])


def up_of(direction):
    return (0.0, 1.0, 0.0) if abs(direction[1]) < 0.9 else (0.0, 0.0, 1.0)


def extremes_of(direction):
    """Four cameras at the end of the range."""
    side = numpy.cross(direction, up_of(direction))
    side /= numpy.linalg.norm(side)
    angle = numpy.radians(RANGE)
    for arm in (side, -side, numpy.cross(direction, side), -numpy.cross(direction, side)):
        yield scenes.DISTANCE * (numpy.cos(angle) * direction + numpy.sin(angle) * arm)


def picture_of(studio, surfaces, camera, style):
    """What a camera sees of the surfaces; beside them nothing is known."""
    shots = []
    for background in ((1, 1, 1), (0, 0, 0)):
        mappers = [hachure.vtkPatternMapper() for _ in surfaces]
        for mapper in mappers:
            mapper.SetStyle(style)
        shots.append(studio.draw(mappers, [surfaces], [camera], background)[0])
    alpha = 255 * (shots[0] == shots[1]).all(axis=2)
    pixels = numpy.dstack([shots[0], alpha]).astype(numpy.uint8)
    image = vtkImageData()
    image.SetDimensions(studio.size, studio.size, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 4), deep=1))
    return image


def views_of(studio, surfaces, differ):
    """From every direction a picture for all cameras and one for those nearby.

    differ: whether those nearby have another noise from each direction, which then fade over into each
    other where the camera turns; otherwise all show one texture.
    """
    views = hachure.vtkTextureViews()
    views.SetFinestLevel(FINEST)
    base = scenes.texture_style()
    for number, direction in enumerate(directions()):
        camera = scenes.camera_at(scenes.DISTANCE * direction, (0, 0, 0), up_of(direction))
        shared = picture_of(studio, surfaces, camera, base)
        own = picture_of(studio, surfaces, camera, scenes.texture_style(2 + number)) if differ else shared
        views.AddView("all", camera, shared)
        nearby = views.AddView("near", camera, own)
        views.SetViewKind(nearby, views.DEPENDENT)
        for position in extremes_of(direction):
            views.AddExtremePoint(nearby, position)
    return views


painted = {}  # views by surface, which they hold, and whether they differ; of the last surface alone


def style_of(studio, surfaces, differ):
    key = (surfaces[0], differ)
    if key not in painted:
        for other in [other for other in painted if other[0] is not surfaces[0]]:
            del painted[other]
        painted[key] = views_of(studio, surfaces, differ)
    layer = hachure.vtkViewTextureLayer()
    layer.SetViews(painted[key])
    style = hachure.vtkPatternStyle()
    style.AddLayer(layer)
    return style
