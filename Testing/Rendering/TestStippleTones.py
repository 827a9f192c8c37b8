# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stipples follow whatever shades the surface: a grey texture, a normal map, an illumination of one's own."""

import hachure
import numpy
import pattern_scene as scene
from stipple_scene import stage, stipple_layer
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkPolyDataTangents, vtkTriangleFilter
from vtkmodules.vtkRenderingCore import vtkLight, vtkTexture

TONE = hachure.vtkPatternTone


def texture_of(pixels, srgb=False):
    """Rows from the bottom up, columns, components, as bytes."""
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    flat = pixels.reshape(-1, pixels.shape[2]).astype(numpy.uint8)
    image.GetPointData().SetScalars(scene.add_array(image.GetPointData(), "colors", flat))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.SetColorModeToDirectScalars()
    texture.SetUseSRGBColorSpace(srgb)
    return texture


def tone_style(source):
    style = hachure.vtkPatternStyle()
    layer = stipple_layer(NumberOfPoints=20000)
    layer.GetTone().SetSource(source)
    style.AddLayer(layer)
    return style


def halves(window):
    """Ink of the left and of the right half."""
    pixels = scene.draw(window)
    return scene.ink(pixels[60:196, 60:120]), scene.ink(pixels[60:196, 136:196])


def test_a_grey_texture():
    grey = numpy.full((8, 8, 3), 230)
    grey[:, :4] = 77
    actor, _, window = stage(scene.plane(1.6), tone_style(TONE.LIT_COLOR))
    actor.SetTexture(texture_of(grey))
    left, right = halves(window)
    assert abs(left - (1 - 77 / 255)) < 0.02 and abs(right - (1 - 230 / 255)) < 0.02, (left, right)


def test_a_normal_map():
    """Normals that turn away from the light are as dark as the surface would be that has them."""
    source = scene.plane(1.6)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    tangents = vtkPolyDataTangents()
    tangents.SetInputConnection(triangles.GetOutputPort())
    actor, renderer, window = stage(tangents, tone_style(TONE.LIT))
    actor.GetProperty().LightingOn()
    actor.GetProperty().SetInterpolationToPBR()
    light = vtkLight()
    light.SetLightTypeToHeadlight()
    renderer.AddLight(light)
    flat = halves(window)
    normals = numpy.full((8, 8, 3), (128, 128, 255))
    normals[:, :4] = (235, 128, 195)  # 58 degrees aside
    actor.GetProperty().SetNormalTexture(texture_of(normals))
    left, right = halves(window)
    assert abs(right - flat[1]) < 0.03, (right, flat)
    assert left > right + 0.1, (left, right)


def test_an_illumination_of_ones_own():
    actor, renderer, window = stage(scene.plane(1.6), tone_style(TONE.LIT))
    actor.GetProperty().LightingOn()
    actor.GetShaderProperty().AddFragmentShaderReplacement(
        "//VTK::Light::Impl", False,
        "  diffuse = vec3(vertexVC.x < 0.0 ? 0.2 : 0.7);\n  //VTK::Light::Impl\n", False)
    light = vtkLight()
    light.SetLightTypeToHeadlight()
    renderer.AddLight(light)
    left, right = halves(window)
    assert abs(left - 0.8) < 0.03 and abs(right - 0.3) < 0.03, (left, right)


if __name__ == "__main__":
    scene.run(globals())
