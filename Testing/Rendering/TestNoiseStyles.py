# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Styles made of noise draw anything without complaint, and put as much ink as they should."""

import os
import sys

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkFiltersSources import vtkRegularPolygonSource
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

NOISE = hachure.vtkNoiseLayer
DATA = sys.argv[sys.argv.index("-D") + 1]
XTOON = os.path.join(DATA, "..", "Styles", "xtoon.json")
# Of one layer whose ink is the tone.
EXACT = ("gabor", "phasor", "spot", "noise-stipple", "noise-hatch", "engraving")
SIZE = 400


def names():
    style = hachure.vtkPatternStyle
    return [style.GetPresetName(i) for i in range(style.GetNumberOfPresets())]


def style_named(name):
    style = hachure.vtkPatternStyle()
    assert style.LoadFile(name) if name.endswith(".json") else style.LoadPreset(name), name
    return style


def layers_of(style):
    return [style.GetLayer(i) for i in range(style.GetNumberOfLayers())]


def inputs():
    reader = vtkXMLImageDataReader()
    reader.SetFileName(os.path.join(DATA, "skull.vti"))
    bone = vtkFlyingEdges3D()
    bone.SetInputConnection(reader.GetOutputPort())
    bone.SetValue(0, 2.9)
    bone.Update()
    triangle = vtkRegularPolygonSource()
    triangle.SetNumberOfSides(3)
    triangle.GeneratePolylineOff()
    triangle.Update()
    return {"skull": bone.GetOutput(), "triangle": triangle.GetOutput(), "empty": vtkPolyData()}


def test_every_style_reads_back_and_draws():
    for kind, data in inputs().items():
        for name in (*names(), XTOON):
            style, copy = style_named(name), hachure.vtkPatternStyle()
            if name != XTOON:
                assert copy.FromJson(style.ToJson()) and copy.ToJson() == style.ToJson(), name
            actor = scene.actor_of(data, style)
            actor.GetMapper().ScalarVisibilityOff()
            renderer = scene.renderer_of(actor)
            window = scene.window_of(renderer, size=(120, 120))
            scene.draw(window)
            renderer.ResetCamera()
            spread = scene.draw(window).astype(float).std()
            assert (spread == 0) if kind == "empty" else (spread > 2 or kind != "skull"), (
                kind, name, spread)
            scene.expect_messages()


def ink_of(style):
    """Mean ink on a flat surface that fills the picture."""
    actor = scene.actor_of(scene.plane(), style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor, background=(1.0, 0.0, 0.0))
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    scene.look(renderer)
    return scene.ink(scene.draw(window))


def make_plain(style, tones):
    """Black ink on white paper, in even tones."""
    style.OutlineOff()
    style.SetPaperColor(1, 1, 1)
    for layer, tone in zip(layers_of(style), tones):
        layer.SetColor(0, 0, 0)
        layer.SetOpacity(1)
        layer.GetTone().SetSource(hachure.vtkPatternTone.CONSTANT)
        layer.GetTone().SetRemap(hachure.vtkPatternTone.NONE)
        layer.GetTone().SetGamma(1)
        layer.GetTone().InvertOff()
        layer.GetTone().SetConstant(tone)
    return style


def test_ink_equals_tone():
    for name in EXACT:
        assert style_named(name).GetNumberOfLayers() == 1, name
        for tone in (0.0, 0.1, 0.5, 0.8, 1.0):
            inks = []
            for seed in (1, 2):
                style = make_plain(style_named(name), [tone])
                style.GetLayer(0).SetSeed(seed)
                inks.append(ink_of(style))
            allowed = 0.02 if 0.0 < tone < 1.0 else 0.0
            assert abs(numpy.mean(inks) - tone) <= allowed, (name, tone, inks)


def test_cross_hatching_is_a_product():
    """Two thresholded noises multiply: paper is left where both leave it."""
    for one, other in ((0.3, 0.0), (0.3, 0.4), (0.6, 0.5)):
        ink = ink_of(make_plain(style_named("noise-cross-hatch"), (one, other)))
        assert abs(ink - (1 - (1 - one) * (1 - other))) < 0.03, (one, other, ink)


def test_grain_takes_ink_away():
    """The last layer of graphite leaves the share of the hatching that its tone says."""
    for hatch, grain in ((0.5, 0.0), (0.5, 0.4), (0.8, 0.5)):
        style = make_plain(style_named("graphite"), (hatch, 0.0, grain))
        style.GetLayer(2).SetColor(1, 1, 1)
        ink = ink_of(style)
        assert abs(ink - hatch * (1 - grain)) < 0.03, (hatch, grain, ink)


def test_lines_of_an_array():
    """Strokes of every kind lie along the directions of an array as they do along an angle."""
    data = scene.plane().GetOutput()
    for kind in (NOISE.GABOR, NOISE.PHASOR, NOISE.SPOT):
        pictures = []
        for angle, array in ((30, ""), (120, "line"), (120, "")):
            style = hachure.vtkPatternStyle()
            layer = NOISE()
            layer.SetKind(kind)
            layer.SetSize(14)
            layer.SetAngle(angle)
            layer.SetDirectionArrayName(array)
            layer.GetTone().SetSource(hachure.vtkPatternTone.CONSTANT)
            style.AddLayer(layer)
            lines = numpy.tile([numpy.cos(numpy.pi / 6), 0.5, 0.0], (data.GetNumberOfPoints(), 1))
            scene.add_array(data.GetPointData(), "line", lines)
            renderer = scene.renderer_of(scene.actor_of(data, style))
            window = scene.window_of(renderer)
            scene.look(renderer)
            pictures.append(scene.draw(window).astype(float))
        same = numpy.abs(pictures[0] - pictures[1]).mean()
        other = numpy.abs(pictures[0] - pictures[2]).mean()
        assert same < 2 and other > 60, (kind, same, other)


scene.run(globals())
