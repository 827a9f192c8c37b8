# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Legends in windows of their own, and their swatches cut out of pictures."""

import hachure
import numpy
import pattern_scene as scene
import vtkmodules.vtkRenderingFreeType  # noqa: F401

SIZE = (320, 400)


def array_style(layer, name="depth", ends=(0.0, 1.0)):
    """A style of one layer in black on white, dark where an array is high."""
    style = hachure.vtkPatternStyle()
    tone = layer.GetTone()
    tone.SetSource(tone.ARRAY)
    tone.SetArrayName(name)
    tone.SetRange(*ends)
    style.AddLayer(layer)
    return style


def image_layer(pattern, size=8.0, angle=45.0):
    layer = hachure.vtkImagePatternLayer()
    layer.SetPattern(pattern)
    layer.SetSize(size)
    layer.SetAngle(angle)
    layer.SetIrregularity(0.0)
    return layer


class Stage:
    """A legend, alone in a window that it fills."""

    def __init__(self, style=None, size=SIZE, background=(1.0, 1.0, 1.0)):
        self.legend = hachure.vtkPatternLegendActor()
        self.legend.SetStyle(style)
        self.legend.SetPosition(0.03, 0.03)
        self.legend.SetPosition2(0.94, 0.94)
        self.legend.SetSwatchThickness(200)
        self.renderer = scene.renderer_of(background=background)
        self.renderer.AddViewProp(self.legend)
        self.window = scene.window_of(self.renderer, size=size)

    def draw(self):
        return scene.draw(self.window)

    def swatches(self, picture):
        """First and last value and the pixels of every swatch."""
        found = []
        for index in range(self.legend.GetNumberOfSwatches()):
            values, place = [0.0, 0.0], [0, 0, 0, 0]
            assert self.legend.GetSwatch(index, values, place)
            x, y, width, height = place
            found.append((*values, picture[y : y + height, x : x + width]))
        return found

    def labels(self):
        """Text and place of every label."""
        legend = self.legend
        return [(legend.GetShownLabel(i), legend.GetShownLabelPlace(i))
                for i in range(legend.GetNumberOfShownLabels())]


def period(pixels):
    """Mean distance in pixels of strokes that run about level: two edges for each."""
    inked = scene.linear(pixels).mean(axis=2) < 0.5
    return 2.0 * inked[1:].size / (inked[1:] != inked[:-1]).sum()
