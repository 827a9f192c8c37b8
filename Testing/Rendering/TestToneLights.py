# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers follow single lights, highlights and colours, each as VTK itself lights the surface."""

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper

SIZE = 96
# A level of the picture where it is lightest; tones of opaque surfaces have 255 levels.
TONE_ERROR = 0.009
LUMA = numpy.array([0.2126, 0.7152, 0.0722])
Tone = hachure.vtkPatternTone


def sun():
    light = vtkLight()
    light.SetPosition(3, 4, 5)
    light.SetIntensity(0.8)
    light.SetColor(1.0, 0.8, 0.5)
    return light


def spot():
    light = vtkLight()
    light.PositionalOn()
    light.SetPosition(-1.2, 0.4, 1.6)
    light.SetFocalPoint(0.0, 0.1, 0.3)
    light.SetConeAngle(14.0)
    light.SetExponent(3.0)
    light.SetAttenuationValues(0.2, 0.1, 0.2)
    return light


def bulb():
    light = vtkLight()
    light.PositionalOn()
    light.SetPosition(1.0, -1.0, 1.0)
    light.SetAttenuationValues(0.5, 0.0, 0.5)
    light.SetColor(0.3, 0.6, 1.0)
    return light


def headlight():
    light = vtkLight()
    light.SetLightTypeToHeadlight()
    light.SetIntensity(0.9)
    return light


def studio():
    light = vtkLight()
    light.SetLightTypeToCameraLight()
    light.SetPosition(-1.0, 0.5, 0.5)
    return light


LIGHTS = (sun, spot, bulb, headlight, studio)
_source = scene.sphere()
SPHERE = _source.GetOutput()


def stage(mapper, lights, prepare=lambda surface: None):
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetInterpolationToPhong()
    prepare(actor.GetProperty())
    renderer = scene.renderer_of(actor)
    renderer.AutomaticLightCreationOff()
    for light in lights:
        renderer.AddLight(light)
    scene.look(renderer, (0.3, -0.4, 2.2))
    return renderer, scene.window_of(renderer, size=(SIZE, SIZE))


def stock_luma(lights, prepare):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(SPHERE)
    _, window = stage(mapper, lights, prepare)
    return scene.draw(window) @ LUMA / 255.0


def pattern(source, index=-1, power=0.0):
    """Under two pixels per period the ink is an even grey, whose value is the tone."""
    style = scene.constant_style(0, 0.5, 0.0)
    tone = style.GetLayer(0).GetTone()
    tone.SetSource(source)
    tone.SetLightIndex(index)
    tone.SetHighlightPower(power)
    mapper = hachure.vtkPatternMapper()
    mapper.SetInputData(SPHERE)
    mapper.SetStyle(style)
    return mapper


def tones(window):
    return 1.0 - scene.linear(scene.draw(window)).mean(axis=2)


def matt(surface):
    surface.SetAmbient(0.1)
    surface.SetDiffuse(0.85)


def mirror(surface):
    surface.SetAmbient(0.0)
    surface.SetDiffuse(0.0)
    surface.SetSpecular(1.0)
    surface.SetSpecularPower(12.0)


def dark_lights(count):
    """Lights that are on and give nothing: with several, VTK has one formula for all kinds."""
    lights = [vtkLight() for _ in range(count)]
    for light in lights:
        light.SetIntensity(0.0)
    return lights


def check(mapper, lights, expected, prepare):
    _, window = stage(mapper, lights, prepare)
    found = tones(window)
    assert abs(found - expected).max() < TONE_ERROR, abs(found - expected).max()
    return found


def test_each_light_alone():
    for index, make in enumerate(LIGHTS):
        luma = stock_luma([make()], matt)
        found = check(pattern(Tone.LIGHT, index), [one() for one in LIGHTS], 1.0 - luma, matt)
        assert numpy.ptp(found) > 0.3, (index, "the light does not show")


def test_all_lights_are_those_of_lit():
    lights = [one() for one in LIGHTS]
    luma = stock_luma(lights, matt)
    check(pattern(Tone.LIGHT), lights, 1.0 - luma, matt)
    check(pattern(Tone.LIT), lights, 1.0 - luma, matt)


def test_highlights():
    lights = [one() for one in LIGHTS]
    luma = stock_luma(lights, mirror)
    disc = stock_luma(dark_lights(2), mirror) < 0.5
    check(pattern(Tone.HIGHLIGHT), lights, luma * disc, mirror)
    for index, make in enumerate(LIGHTS):
        luma = stock_luma([make()] + dark_lights(1), mirror)
        found = check(pattern(Tone.HIGHLIGHT, index), lights, luma * disc, mirror)
        assert found.max() > 0.3, (index, "nothing shines")
    # An exponent of its own in place of the surface's.
    check(pattern(Tone.HIGHLIGHT, 0, 12.0), lights, stock_luma([sun()] + dark_lights(1), mirror) * disc,
          lambda surface: None)


def test_translucent_surfaces_agree():
    def draw(source, opacity):
        mapper = pattern(source, 1)
        _, window = stage(mapper, [one() for one in LIGHTS],
                          lambda surface: (matt(surface), surface.SetOpacity(opacity),
                                           surface.BackfaceCullingOn(),
                                           surface.SetColor(0.2, 0.4, 0.8)))
        return tones(window)
    for source in (Tone.LIGHT, Tone.HIGHLIGHT, Tone.LUMINANCE, Tone.BLACK):
        assert abs(draw(source, 1.0) - draw(source, 0.9999)).max() < TONE_ERROR, source


def test_luminance_is_that_of_the_colour():
    color = numpy.array([0.2, 0.5, 0.9])
    for diffuse, ambient in ((1.0, 0.0), (0.3, 0.2), (0.0, 1.0)):
        mapper = pattern(Tone.LUMINANCE)
        _, window = stage(mapper, [sun()], lambda surface: (
            surface.SetDiffuse(diffuse), surface.SetAmbient(ambient), surface.SetColor(*color)))
        found = tones(window)
        assert abs(found[SIZE // 2, SIZE // 2] - (1.0 - color @ LUMA)) < TONE_ERROR, diffuse


def test_light_that_is_off_and_surface_without_light():
    lights = [sun(), spot()]
    lights[1].SwitchOff()
    mapper = pattern(Tone.LIGHT, 1)
    renderer, window = stage(mapper, lights, matt)
    assert abs(tones(window)[SIZE // 2, SIZE // 2] - 0.9) < TONE_ERROR, "ambient light alone"
    lights[0].SwitchOff()
    assert abs(tones(window)[SIZE // 2, SIZE // 2] - 0.9) < TONE_ERROR, "all lights are off"
    lights[0].SwitchOn()
    renderer.GetActors().GetLastActor().GetProperty().LightingOff()
    assert abs(tones(window)).max() < TONE_ERROR, "a surface that takes no light is paper"


def test_missing_light():
    mapper = pattern(Tone.LIGHT, 2)
    _, window = stage(mapper, [sun(), headlight()])
    assert abs(tones(window)[SIZE // 2, SIZE // 2] - 1.0) < TONE_ERROR
    window.Render()
    scene.expect_messages("tone from light 2: the renderer has 2 lights, counted from 0")
    mapper.GetStyle().GetLayer(0).GetTone().SetLightIndex(1)
    assert tones(window)[SIZE // 2, SIZE // 2] < 0.5


def test_four_tones_at_once_and_no_fifth():
    style = hachure.vtkPatternStyle()
    colors = ((0, 1, 1), (1, 0, 1), (1, 1, 0), (0, 0, 0), (0, 0, 0))
    for index in range(5):
        layer = scene.constant_style(0, 0.5, 0.0).GetLayer(0)
        layer.SetColor(*colors[index])
        layer.SetBlendMode(layer.MULTIPLY)
        layer.GetTone().SetSource(Tone.LIGHT)
        layer.GetTone().SetLightIndex(index)
        layer.SetEnabled(index < 4)
        style.AddLayer(layer)
    mapper = hachure.vtkPatternMapper()
    mapper.SetInputData(SPHERE)
    mapper.SetStyle(style)
    _, window = stage(mapper, [one() for one in LIGHTS], matt)
    paper = scene.linear(scene.draw(window))
    alone = [1.0 - tones(stage(pattern(Tone.LIGHT, i), [one() for one in LIGHTS], matt)[1])
             for i in range(4)]
    for channel in range(3):
        expected = alone[channel] * alone[3]
        assert abs(paper[:, :, channel] - expected).max() < 2.0 * TONE_ERROR, channel
    style.GetLayer(4).EnabledOn()
    window.Render()
    scene.expect_messages("a style may use 4 different tones besides constants and separations; "
                          "the one of layer 4 is one too many")


scene.run(globals())
