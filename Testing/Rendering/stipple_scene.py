# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of stipple layers share."""

import hachure
import pattern_scene as scene


def stipple_layer(tone=0.5, **parameters):
    """A layer of even tone."""
    layer = hachure.vtkStippleLayer()
    layer.SetNumberOfPoints(4000)
    layer.GetTone().SetSource(hachure.vtkPatternTone.CONSTANT)
    layer.GetTone().SetConstant(tone)
    for name, value in parameters.items():
        getattr(layer, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
    return layer


def stipple_style(tone=0.5, **parameters):
    """Black stipples of even tone on white paper."""
    style = hachure.vtkPatternStyle()
    style.AddLayer(stipple_layer(tone, **parameters))
    return style


def stage(data, style, position=(0.0, 0.0, 3.0), size=(256, 256), background=(1.0, 1.0, 1.0)):
    actor = scene.actor_of(data, style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor, background=background)
    window = scene.window_of(renderer, size=size)
    scene.look(renderer, position)
    return actor, renderer, window
