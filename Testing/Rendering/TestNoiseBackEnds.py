# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of noise layers are the same whatever sums up the kernels."""

import os
import subprocess
import sys

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData

SIZE = (190, 150)
Mapper = hachure.vtkPatternMapper
CARDS = {"gather": Mapper.GATHER, "compute": Mapper.COMPUTE, "splat": Mapper.SPLAT}
KINDS = {"gabor": 0, "phasor": 1, "spot": 2}


def noise_style(kind, **values):
    """One noise, whose tone is that of the light."""
    style = hachure.vtkPatternStyle()
    layer = hachure.vtkNoiseLayer()
    layer.SetKind(kind)
    layer.SetSize(7.0)
    for name, value in values.items():
        getattr(layer, "Set" + name)(value)
    style.AddLayer(layer)
    return style


def two_blocks():
    """A sphere that a smaller one hides in part."""
    blocks = vtkMultiBlockDataSet()
    for i, source in enumerate(
        (scene.sphere(), scene.sphere(radius=0.25, center=(0.2, 0.1, 0.6)))
    ):
        block = vtkPolyData()
        block.ShallowCopy(source.GetOutput())
        blocks.SetBlock(i, block)
    return blocks


def drawn(data, style, back_end, viewport=(0.0, 0.0, 1.0, 1.0)):
    actor = scene.actor_of(data, style)
    actor.GetMapper().SetNoiseBackEnd(back_end)
    renderer = scene.renderer_of(actor)
    renderer.SetViewport(*viewport)
    window = scene.window_of(renderer, size=SIZE)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Azimuth(20.0)
    renderer.GetActiveCamera().Zoom(1.3)
    renderer.ResetCameraClippingRange()
    window.Render()
    return scene.picture(window).astype(float)[:, :, 0]


def compare(data, name, style, **where):
    expected = drawn(data, style, Mapper.CPU, **where)
    assert expected.std() > 40.0, "%s: no pattern to compare" % name
    for card, back_end in CARDS.items():
        difference = numpy.abs(drawn(data, style, back_end, **where) - expected)
        inked = (expected < 255.0).mean()
        few = (difference > 8.0).mean() / inked
        print("%s, %s: mean %.4f, %.5f of the pixels" % (name, card, difference.mean(), few))
        assert difference.mean() < 1.0, "%s, %s: mean %g" % (name, card, difference.mean())
        assert few < 0.002, "%s, %s: %g of the pixels differ" % (name, card, few)


def test_kinds():
    for name, kind in KINDS.items():
        compare(scene.sphere(), name, noise_style(kind))


def test_smooth_marks():
    compare(scene.sphere(), "smooth", noise_style(0, Smoothness=0.4, Spread=90.0))


def test_blocks_that_hide_each_other():
    for name, kind in KINDS.items():
        compare(two_blocks(), "blocks, " + name, noise_style(kind))


def test_switched_tests():
    for switch in ("DepthTest", "PartialVisibility", "ObjectTest"):
        compare(two_blocks(), "without " + switch, noise_style(0, **{switch: False}))
    compare(two_blocks(), "triangles", noise_style(0, TriangleTest=True))
    compare(two_blocks(), "no test",
            noise_style(1, DepthTest=False, PartialVisibility=False, ObjectTest=False))


def test_viewport_beside_the_origin():
    for name, kind in KINDS.items():
        compare(two_blocks(), "viewport, " + name, noise_style(kind),
                viewport=(0.35, 0.2, 0.95, 0.9))


def test_large_and_small_kernels():
    compare(scene.sphere(), "large", noise_style(0, Size=40.0, Regularity=3.0))
    compare(scene.sphere(), "small", noise_style(0, Size=3.0, Overlap=8.0))


def test_camera_in_the_surface():
    """Kernels all around: some behind the viewer."""
    style = noise_style(0)
    pictures = []
    for back_end in [Mapper.CPU] + list(CARDS.values()):
        actor = scene.actor_of(scene.sphere(), style)
        actor.GetMapper().SetNoiseBackEnd(back_end)
        actor.GetProperty().SetAmbient(0.4)
        renderer = scene.renderer_of(actor)
        window = scene.window_of(renderer, size=SIZE)
        scene.look(renderer, position=(0.1, 0.0, 0.2), focal_point=(0.4, 0.1, -0.3))
        window.Render()
        pictures.append(scene.picture(window).astype(float))
    for picture in pictures[1:]:
        assert numpy.abs(picture - pictures[0]).mean() < 1.0


def test_automatic_is_one_of_them():
    expected = drawn(scene.sphere(), noise_style(0), Mapper.CPU)
    assert Mapper().GetNoiseBackEnd() == Mapper.AUTOMATIC
    difference = numpy.abs(drawn(scene.sphere(), noise_style(0), Mapper.AUTOMATIC) - expected)
    assert difference.mean() < 1.0


def test_one_that_is_not_there_is_a_warning():
    """Where OpenGL is too old for compute shaders: said once, and drawn with another one."""
    environment = dict(os.environ, MESA_GL_VERSION_OVERRIDE="3.3", MESA_GLSL_VERSION_OVERRIDE="330")
    subprocess.run([sys.executable, __file__, "--old"], env=environment, check=True)


def draw_with_old_opengl():
    expected = drawn(scene.sphere(), noise_style(0), Mapper.CPU)
    actor = scene.actor_of(scene.sphere(), noise_style(0))
    actor.GetMapper().SetNoiseBackEnd(Mapper.COMPUTE)
    scene.expect_messages()
    difference = numpy.abs(drawn(scene.sphere(), noise_style(0), Mapper.COMPUTE) - expected)
    scene.expect_messages("cannot sum noises with the back end COMPUTE")
    assert difference.mean() < 1.0


if __name__ == "__main__":
    if "--old" in sys.argv:
        draw_with_old_opengl()
    else:
        scene.run(globals())
