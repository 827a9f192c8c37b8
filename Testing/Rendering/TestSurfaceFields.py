# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Patterns that lie on the surface: textures stay on it, solid textures grow and halve with the distance."""

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLVertexBufferObject

LAYER = hachure.vtkImagePatternLayer
TEXTURE, SOLID = LAYER.TEXTURE, LAYER.DYNAMIC_SOLID
SIZE = 256
PERIOD = 0.1  # model units of the plane; its texture coordinates go from 0 to 1 over WIDTH
WIDTH = 10.0


def style_of(motion, pattern=LAYER.HATCH, tone=0.4, period=PERIOD, angle=30.0, size=8):
    style = scene.constant_style(pattern, size, tone, angle=angle)
    style.GetLayer(0).SetMotion(motion)
    style.GetLayer(0).SetSurfacePeriod(period)
    return style


def plane_data(with_coordinates, tilt=0.0, shift=0.0, scale=1.0):
    transform = vtkTransform()
    transform.Translate(shift, 0.0, 0.0)
    transform.RotateX(tilt)
    transform.Scale(scale, scale, scale)
    tilted = vtkTransformPolyDataFilter()
    tilted.SetInputData(scene.plane(WIDTH).GetOutput())
    tilted.SetTransform(transform)
    tilted.Update()
    data = tilted.GetOutput()
    if not with_coordinates:
        data.GetPointData().SetTCoords(None)
    return data


def stage(data, style, center=0.0, height=2.0):
    """An unlit object in parallel projection; height: model units from the bottom to the top."""
    actor = scene.actor_of(data, style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    camera = scene.look(renderer, (center, 0.0, 3.0), (center, 0.0, 0.0))
    camera.ParallelProjectionOn()
    camera.SetParallelScale(height / 2.0)
    return actor, renderer, window


def difference(one, other):
    return numpy.abs(one.astype(int) - other.astype(int)).max(axis=2)


FIELDS = (
    ("coordinates", True, TEXTURE, PERIOD / WIDTH),
    ("triplanar", False, TEXTURE, PERIOD),
    ("solid", True, SOLID, PERIOD),
)


def test_pattern_stays_on_a_moving_plane():
    for name, with_coordinates, motion, period in FIELDS:
        actor, _, window = stage(plane_data(with_coordinates), style_of(motion, period=period))
        before = scene.draw(window)
        assert 0.3 < scene.ink(before) < 0.5, (name, scene.ink(before))
        assert (before < 60).any() and (before > 200).any(), name
        pixel = 2.0 / SIZE
        actor.SetPosition(13 * pixel, 7 * pixel, 0.0)
        moved = scene.draw(window)
        changed = difference(moved[7:, 13:], before[:-7, :-13])
        assert changed.max() <= 2, (name, changed.max())
        assert difference(moved, before).max() > 100, "the motion must show"


def test_pattern_stays_on_a_rolling_sphere():
    for motion in (TEXTURE, SOLID):
        _, renderer, window = stage(scene.sphere().GetOutput(), style_of(motion, period=0.05), height=1.2)
        before = scene.draw(window)
        renderer.GetActiveCamera().Roll(-90.0)
        turned = numpy.rot90(scene.draw(window), -1)
        turned = turned if difference(turned, before).mean() < 10 else numpy.rot90(turned, 2)
        changed = difference(turned, before)
        # Pixels on an edge of a triangle may belong to either.
        assert (changed > 12).mean() < 0.002, (motion, (changed > 12).mean())


def test_ink_equals_tone():
    worst = (0.0, "")
    for name, with_coordinates, motion, period in FIELDS:
        for pattern in (LAYER.HATCH, LAYER.CROSS_HATCH, LAYER.HALFTONE):
            style = style_of(motion, pattern, period=period)
            layer = style.GetLayer(0)
            actor, renderer, window = stage(plane_data(with_coordinates), style)
            for tilt in (0.0, 50.0):
                actor.SetOrientation(tilt, 0.0, 0.0)
                renderer.ResetCameraClippingRange()
                for tone in (0.0, 0.07, 0.3, 0.6, 0.9, 1.0):
                    inks = []
                    layer.GetTone().SetConstant(tone)
                    for angle in (20.0, 45.0, 80.0):
                        layer.SetAngle(angle)
                        inks.append(scene.ink(scene.draw(window)))
                    error = abs(numpy.mean(inks) - tone)
                    case = "%s pattern %d tilt %g tone %g: %s" % (name, pattern, tilt, tone, inks)
                    worst = max(worst, (error, case))
                    assert error < 0.01, case
    print("largest error", worst)


def test_solid_zoom():
    """Mean ink holds at every distance, and twice the distance is the same picture."""
    style = style_of(SOLID, LAYER.HALFTONE)
    actor, renderer, window = stage(plane_data(False), style)
    renderer.GetActiveCamera().ParallelProjectionOff()
    pictures = {}
    for distance in (2.0, 2.3, 2.6, 2.8, 3.1, 3.4, 3.7, 4.0, 8.0):
        scene.look(renderer, (0.0, 0.0, distance))
        pictures[distance] = scene.draw(window)
        assert abs(scene.ink(pictures[distance]) - 0.4) < 0.02, (distance, scene.ink(pictures[distance]))
    for one, other in ((2.0, 4.0), (4.0, 8.0)):
        assert difference(pictures[one], pictures[other]).max() <= 3, (one, other)
    assert difference(pictures[2.0], pictures[2.8]).max() > 100


def test_texture_grows_with_the_surface():
    """Twice as near, the pattern is twice as large; far away it is an even grey."""
    _, renderer, window = stage(plane_data(False), style_of(TEXTURE, LAYER.HALFTONE, angle=0.0))
    means = []
    for height in (2.0, 1.0):
        renderer.GetActiveCamera().SetParallelScale(height / 2.0)
        pixels = scene.linear(scene.draw(window))[..., 0]
        spectrum = numpy.abs(numpy.fft.rfft(pixels, axis=1)).mean(axis=0)
        spectrum[0] = 0.0
        means.append(int(spectrum.argmax()))
    assert abs(means[0] - 2.0 / PERIOD) <= 1 and abs(means[1] - 1.0 / PERIOD) <= 1, means
    renderer.GetActiveCamera().SetParallelScale(5.0 * WIDTH)
    center = scene.draw(window)[SIZE // 2 - 5 : SIZE // 2 + 5, SIZE // 2 - 5 : SIZE // 2 + 5]
    assert numpy.ptp(center) <= 1 and abs(scene.ink(center) - 0.4) < 0.01, center


def test_translucent_surfaces_look_alike():
    for name, with_coordinates, motion, period in FIELDS:
        actor, _, window = stage(plane_data(with_coordinates, 40.0), style_of(motion, period=period))
        opaque = scene.draw(window)
        actor.ForceTranslucentOn()
        changed = difference(scene.draw(window), opaque)
        assert changed.max() <= 3, (name, changed.max())


def test_far_from_the_origin():
    """VTK moves far vertices to the origin of its buffers; the pattern does not go with them."""
    style = style_of(TEXTURE, period=0.125, angle=90.0)
    near = 0.53
    far = 2048.0 + near  # whole tiles, and a part of a period, so that it shows
    pictures = []
    buffers = vtkOpenGLVertexBufferObject
    methods = (buffers.DISABLE_SHIFT_SCALE, buffers.AUTO_SHIFT_SCALE)
    for shift, method in zip((near, far), methods):
        data = plane_data(False, shift=shift, scale=0.1)
        actor, _, window = stage(data, style, center=shift, height=1.0)
        actor.GetMapper().SetVBOShiftScaleMethod(method)
        pictures.append(scene.draw(window))
    # A float holds the position to a thirtieth of a pixel.
    changed = difference(*pictures)
    assert changed.max() <= 30 and changed.mean() < 3, (changed.max(), changed.mean())


def test_edges_are_drawn_over_the_pattern():
    actor, _, window = stage(scene.sphere(12).GetOutput(), style_of(TEXTURE, period=0.05), height=1.2)
    plain = scene.draw(window)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(1.0, 0.0, 0.0)
    edged = scene.draw(window)
    red = (edged[..., 0] > 200) & (edged[..., 1] < 40)
    assert red.mean() > 0.01
    apart = difference(edged, plain)[~red]
    assert numpy.median(apart) == 0, numpy.median(apart)


scene.run(globals())
