# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of noise on translucent surfaces share."""

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

SIZE = (160, 160)


def noise_style(kind, tone, **values):
    """Black ink of one tone on white paper."""
    style = hachure.vtkPatternStyle()
    layer = hachure.vtkNoiseLayer()
    layer.SetKind(kind)
    layer.SetSize(6.0)
    for name, value in values.items():
        getattr(layer, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
    layer.GetTone().SetSource(hachure.vtkPatternTone.CONSTANT)
    layer.GetTone().SetConstant(tone)
    style.AddLayer(layer)
    return style


def sphere_actor(radius, style, opacity):
    return translucent(scene.sphere(radius=radius), style, opacity)


def translucent(data, style, opacity, culled="none"):
    actor = scene.actor_of(data, style)
    actor.GetProperty().SetOpacity(opacity)
    actor.GetProperty().SetBackfaceCulling(culled == "back")
    actor.GetProperty().SetFrontfaceCulling(culled == "front")
    return actor


def blocks_of(*sources):
    blocks = vtkMultiBlockDataSet()
    for i, source in enumerate(sources):
        blocks.SetBlock(i, source.GetOutput())
    return blocks


def drawn(actors, peeling, size=SIZE, viewport=(0.0, 0.0, 1.0, 1.0), light=None):
    """Display-referred grey, 0 to 1."""
    renderer = scene.renderer_of(*actors)
    renderer.SetViewport(*viewport)
    if light:
        renderer.AddLight(light)
    window = scene.window_of(renderer, size=size)
    window.SetAlphaBitPlanes(1)
    if peeling:
        renderer.SetUseDepthPeeling(True)
        renderer.SetMaximumNumberOfPeels(8)
        renderer.SetOcclusionRatio(0.0)
    scene.look(renderer, position=(0.0, 0.0, 2.2))
    window.Render()
    return scene.picture(window)[:, :, 0] / 255.0


def disc(share):
    """Pixels within a share of the half picture around its middle."""
    y, x = numpy.mgrid[0 : SIZE[1], 0 : SIZE[0]]
    return numpy.hypot(x - SIZE[0] / 2 + 0.5, y - SIZE[1] / 2 + 0.5) < share * SIZE[0] / 2


def tone_of(picture, opacity):
    """Of one surface alone in front of white, whose display-referred colour VTK blends."""
    own = numpy.clip((picture - (1.0 - opacity)) / opacity, 0.0, 1.0)
    return 1.0 - scene.linear(255.0 * own)


def in_front(front, behind, opacity):
    """The picture of a surface, which alone is `front`, in front of others that alone are `behind`."""
    return front - (1.0 - opacity) * (1.0 - behind)


def front_actor(radius, style, opacity):
    return translucent(scene.sphere(radius=radius), style, opacity, "back")


def correlation(one, other):
    return numpy.corrcoef(one, other)[0, 1]
