# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The tone controls noise on translucent surfaces: that of every side, wherever VTK gets it from."""

import hachure
import numpy
import pattern_scene as scene
from noise_scene import SIZE, blocks_of, correlation, disc, drawn, in_front, noise_style, translucent
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkLight

Tone = hachure.vtkPatternTone
OPACITY = 0.6


def half_inked():
    """A threshold image that inks half of the paper, whatever the tone."""
    image = vtkImageData()
    image.SetDimensions(2, 1, 1)
    image.GetPointData().SetScalars(
        scene.add_array(image.GetPointData(), "paper", numpy.array([0.0, 1.0])))
    return image


def controlled_style(source=Tone.LIT, control=1, **values):
    """Waves across x, up to three times as long where the tone is 1; their ink is that of half a tone."""
    style = noise_style(0, 0.5, Angle=90.0, Control=control, SizeFactors=(1.0, 3.0),
                        ThresholdImage=half_inked(), Size=5.0, **values)
    style.GetLayer(0).GetTone().SetSource(source)
    return style


def sun(x):
    """A light from the side of the view."""
    light = vtkLight()
    light.SetLightTypeToCameraLight()
    light.SetPosition(x, 0.0, 0.4)
    light.SetFocalPoint(0.0, 0.0, 0.0)
    return light


def frequency(picture, columns):
    """Mean number of edges of marks per pixel along x, on the sphere."""
    inside = disc(0.6)
    inside[:, : columns[0]] = False
    inside[:, columns[1] :] = False
    marks = picture > 1.0 - OPACITY / 2.0
    changes = marks[:, 1:] != marks[:, :-1]
    return changes[inside[:, 1:]].mean()


LEFT, RIGHT = (0, 70), (90, 160)


def ratio(picture):
    """Frequency of the left half over that of the right one."""
    return frequency(picture, LEFT) / frequency(picture, RIGHT)


def test_frequency_follows_the_light():
    """Of a sphere that is lit from the left, marks of its front are fine there, of its back, which is
    seen from inside, on the other side."""
    for peeling in (False, True):
        for culled, expected in (("back", 1.0), ("front", -1.0)):
            with_tone, without = [
                ratio(drawn([translucent(scene.sphere(), controlled_style(control=control), OPACITY, culled)],
                            peeling, light=sun(-1.0))) for control in (1, 0)]
            print("peeling %d, %s culled: frequency left over right %.2f, without control %.2f" % (
                peeling, culled, with_tone, without))
            assert 0.85 < without < 1.18, without
            assert with_tone**expected > 1.4, with_tone


def test_both_sides_at_once():
    """With both of them every side is drawn as it is alone."""
    pictures = [drawn([translucent(scene.sphere(), controlled_style(), OPACITY, culled)], True, light=sun(-1.0))
                for culled in ("back", "front", "none")]
    difference = numpy.abs(in_front(*pictures[:2], OPACITY) - pictures[2])[disc(0.6)]
    print("both sides differ from each alone by %.4f" % difference.mean())
    assert difference.mean() < 0.01
    assert pictures[2][disc(0.6)].std() > 0.15


def test_blocks_behind_each_other():
    """Four layers: those of two nested spheres."""
    outer, inner = scene.sphere(), scene.sphere(radius=0.35)
    def picture(data, culled="none"):
        return drawn([translucent(data, controlled_style(), OPACITY, culled)], True, light=sun(-1.0))[disc(0.35)]
    # The inner one lets through what passes two surfaces.
    behind = picture(inner) - (1.0 - OPACITY) ** 2 * (1.0 - picture(outer, "front"))
    expected = in_front(picture(outer, "back"), behind, OPACITY)
    difference = numpy.abs(picture(blocks_of(outer, inner)) - expected).mean()
    print("four layers differ from each alone by %.4f" % difference)
    assert difference < 0.01


def test_every_source_of_tones():
    """What VTK's shader makes a tone of: the picture is that of the opaque surface."""
    data = scene.sphere().GetOutput()
    points = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    scene.add_array(data.GetPointData(), "height", points[:, 0] + 0.5)
    for source in (Tone.LIT, Tone.LIT_COLOR, Tone.ARRAY, Tone.LIGHT, Tone.HIGHLIGHT, Tone.LUMINANCE):
        style = controlled_style(source)
        style.GetLayer(0).GetTone().SetArrayName("height")
        pictures = [drawn([translucent(data, style, opacity, "back")], False, light=sun(-1.0))
                    for opacity in (1.0, 0.9999)]
        alike = correlation(pictures[0][disc(0.5)], pictures[1][disc(0.5)])
        print("source %d: correlation %.3f" % (source, alike))
        assert alike > 0.93, (source, alike)


def test_light_that_moves():
    """Marks follow it, although neither surface nor camera has changed."""
    actor = translucent(scene.sphere(), controlled_style(), OPACITY)
    light = sun(-1.0)
    renderer = scene.renderer_of(actor)
    renderer.AddLight(light)
    window = scene.window_of(renderer, size=SIZE)
    window.SetAlphaBitPlanes(1)
    scene.look(renderer, position=(0.0, 0.0, 2.2))
    window.Render()
    light.SetPosition(1.0, 0.0, 0.4)
    moved = scene.draw(window)[:, :, 0] / 255.0
    fresh = drawn([translucent(scene.sphere(), controlled_style(), OPACITY)], False, light=sun(1.0))
    assert (moved == fresh).all()


def test_what_comes_after_is_as_before():
    """Opaque surfaces, and translucent ones without control, are drawn the same beside such a surface."""
    def others():
        plain = translucent(scene.sphere(24, 0.2, (-0.3, 0.3, 0.0)), noise_style(0, 0.5), OPACITY)
        hatched = scene.actor_of(scene.sphere(24, 0.2, (-0.3, -0.3, 0.0)), "cross-hatch")
        return [plain, hatched]
    controlled = translucent(scene.sphere(24, 0.2, (0.35, 0.0, 0.0)), controlled_style(), OPACITY)
    for peeling in (False, True):
        expected = drawn(others(), peeling)[:, :75]
        found = drawn([controlled] + others(), peeling)[:, :75]
        assert (found == expected).all(), (found != expected).mean()


scene.run(globals())
