# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A style that is copied into another one changes what differs there, and leaves the rest as it is."""

import math
import time

import hachure
import pattern_scene as scene
from vtkmodules.vtkImagingSources import vtkImageCanvasSource2D
from vtkmodules.vtkRenderingCore import vtkCamera


def layers_of(style):
    return [style.GetLayer(index) for index in range(style.GetNumberOfLayers())]


def seconds(function):
    """Computing time that a call takes."""
    start = time.process_time()
    function()
    return time.process_time() - start


def picture(size=16):
    canvas = vtkImageCanvasSource2D()
    canvas.SetScalarTypeToUnsignedChar()
    canvas.SetExtent(0, size - 1, 0, size - 1, 0, 0)
    for grey in range(size):
        canvas.SetDrawColor(255 * grey // size)
        canvas.FillBox(grey, grey, 0, size - 1)
    canvas.Update()
    return canvas.GetOutput()


def test_every_preset_into_every_next_one():
    style = hachure.vtkPatternStyle()
    for index in range(style.GetNumberOfPresets()):
        before = layers_of(style)
        other = hachure.style(style.GetPresetName(index))
        other.SetDotsPerInch(150)
        style.CopyFrom(other)
        assert style.ToJson() == other.ToJson(), style.GetPresetName(index)
        for old, new, wanted in zip(before, layers_of(style), layers_of(other)):
            assert new is not wanted, "the layer is shared"
            assert (new is old) == (old.GetTypeName() == wanted.GetTypeName()), style.GetPresetName(index)


def test_nothing_equal_is_modified():
    for index in range(hachure.vtkPatternStyle.GetNumberOfPresets()):
        name = hachure.vtkPatternStyle.GetPresetName(index)
        style, other = hachure.style(name), hachure.style(name)
        style.CopyFrom(other)  # views are objects, which it now has
        known = style.GetMTime()
        style.CopyFrom(other)
        assert style.GetMTime() == known, name
        other.SetPaperColor(0.1, 0.2, 0.3)
        other.GetLayer(0).SetOpacity(0.25)
        others = [layer.GetMTime() for layer in layers_of(style)[1:]]
        style.CopyFrom(other)
        assert style.GetLayer(0).GetOpacity() == 0.25 and style.GetMTime() > known, name
        assert [layer.GetMTime() for layer in layers_of(style)[1:]] == others, name


def test_objects_without_a_file_are_shared():
    marks, noise, views = hachure.vtkImagePatternLayer(), hachure.vtkNoiseLayer(), hachure.vtkViewTextureLayer()
    marks.SetImage(picture())
    noise.SetThresholdImage(picture())
    views.GetViews().AddView("a", vtkCamera(), picture())
    marks.GetTone().SetRange(-math.inf, math.inf)
    style, other = hachure.vtkPatternStyle(), hachure.vtkPatternStyle()
    for layer in (marks, noise, views):
        other.AddLayer(layer)
    style.CopyFrom(other)
    copies = layers_of(style)
    assert copies[0].GetImage() is marks.GetImage() and copies[0].GetTone().GetRange() == (-math.inf, math.inf)
    assert copies[1].GetThresholdImage() is noise.GetThresholdImage() and copies[1].GetImage() is None
    assert copies[2].GetViews() is views.GetViews()
    known = style.GetMTime()
    style.CopyFrom(other)
    assert style.GetMTime() == known
    marks.SetImage(None)
    style.CopyFrom(other)
    assert copies[0].GetImage() is None and copies[0].GetMTime() > known


def test_output_stays_and_null_is_refused():
    style = hachure.style("hatch")
    style.SetPixelScale(2)
    style.FinalQualityOn()
    style.CopyFrom(hachure.style("stipple"))
    assert style.GetPixelScale() == 2 and style.GetFinalQuality()
    before = style.ToJson()
    style.CopyFrom(style)
    style.CopyFrom(None)
    assert style.ToJson() == before
    scene.expect_messages("CopyFrom")


def test_a_picture_of_the_user_is_made_into_a_pattern_once():
    """Colours change it in no more time than another colour of a built-in pattern takes."""
    style = hachure.style("hatch")
    style.GetLayer(0).SetPattern(hachure.vtkImagePatternLayer.IMAGE)
    style.GetLayer(0).SetImage(picture(256))
    actor = scene.actor_of(scene.sphere(24, 0.6), style)
    window = scene.window_of(scene.renderer_of(actor), size=(120, 120))
    first = seconds(lambda: scene.draw(window))
    before = scene.draw(window)
    other = hachure.vtkPatternStyle()
    other.CopyFrom(style)
    for value in (0.2, 0.4, 0.6, 0.8):
        other.GetLayer(0).SetColor(value, 0.0, 0.0)
        style.CopyFrom(other)
        again = seconds(lambda: scene.draw(window))
        assert again < 0.1 * first, (again, first)
    assert (scene.draw(window) != before).any()


scene.run(globals())
