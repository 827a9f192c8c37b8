# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Noise on translucent surfaces: every one has its own, and its ink is its tone."""

import numpy
import pattern_scene as scene
from noise_scene import (
    SIZE, correlation, disc, drawn, front_actor, in_front, noise_style, sphere_actor, tone_of)

KINDS = {"gabor": 0, "phasor": 1, "spot": 2}


def test_each_sphere_has_its_tone():
    for name, kind in KINDS.items():
        for tone in (0.2, 0.5):
            for peeling in (False, True):
                picture = drawn([front_actor(0.5, noise_style(kind, tone), 0.6)], peeling)
                inside = tone_of(picture[disc(0.6)], 0.6)
                print("%s, peeling %d: tone %.4f, expected %.1f, deviation %.4f" % (
                    name, peeling, inside.mean(), tone, inside.std()))
                assert abs(inside.mean() - tone) < 0.025, name
                assert inside.std() > 0.25, "%s is flat: %g" % (name, inside.std())


def test_nested_spheres():
    """Every sphere is drawn as it is alone; the outer one lets the inner one through."""
    for name, kind in KINDS.items():
        styles = noise_style(kind, 0.5), noise_style(kind, 0.3, Seed=7)
        actors = [front_actor(0.3, styles[1], 0.6), front_actor(0.5, styles[0], 0.5)]
        inner = drawn(actors[:1], True)[disc(0.45)]
        outer = drawn(actors[1:], True)[disc(0.45)]
        both = drawn(actors, True)[disc(0.45)]
        assert abs(tone_of(inner, 0.6).mean() - 0.3) < 0.03, name
        assert abs(tone_of(outer, 0.5).mean() - 0.5) < 0.03, name
        difference = numpy.abs(both - in_front(outer, inner, 0.5)).mean()
        print("%s: nested spheres differ by %.4f" % (name, difference))
        assert difference < 0.01, name
        # Without peeling VTK mixes the two whatever their order, but both are there.
        mixed = drawn(actors, False)[disc(0.45)]
        assert correlation(mixed, outer) > 0.3 and correlation(mixed, inner) > 0.3, name
        assert mixed.std() > 0.15, name


def test_opaque_and_nearly_opaque_look_alike():
    """The same kernels: where the whole disc of a kernel is seen the pictures agree."""
    style = noise_style(0, 0.5)
    opaque = drawn([sphere_actor(0.5, style, 1.0)], False)[disc(0.55)]
    actor = sphere_actor(0.5, style, 0.999)
    actor.GetProperty().BackfaceCullingOn()
    translucent = drawn([actor], False)[disc(0.55)]
    assert correlation(opaque, translucent) > 0.95


def test_two_layers():
    style = noise_style(0, 0.4)
    other = noise_style(1, 0.4, Angle=-45.0, Seed=3).GetLayer(0)
    style.AddLayer(other)
    actor = sphere_actor(0.5, style, 0.5)
    actor.GetProperty().BackfaceCullingOn()
    inside = tone_of(drawn([actor], False)[disc(0.6)], 0.5)
    assert inside.std() > 0.25
    assert abs(inside.mean() - (1.0 - 0.6 * 0.6)) < 0.03


def test_camera_moves():
    """The second picture of a moved camera is that of a window that has never seen another one."""
    actor = sphere_actor(0.5, noise_style(0, 0.5), 0.5)
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=SIZE)
    scene.look(renderer, position=(0.0, 0.0, 2.2))
    window.Render()
    scene.look(renderer, position=(1.0, 0.2, 1.9))
    window.Render()
    moved = scene.picture(window)
    fresh = scene.renderer_of(sphere_actor(0.5, noise_style(0, 0.5), 0.5))
    other = scene.window_of(fresh, size=SIZE)
    scene.look(fresh, position=(1.0, 0.2, 1.9))
    other.Render()
    assert (moved == scene.picture(other)).all()


def test_viewport_beside_the_origin():
    """VTK draws translucent surfaces of a viewport into images that begin at its corner."""
    actor = front_actor(0.5, noise_style(0, 0.5), 0.5)
    for peeling in (False, True):
        alone = drawn([actor], peeling)
        larger = tuple(2 * size for size in SIZE)
        beside = drawn([actor], peeling, size=larger, viewport=(0.25, 0.5, 0.75, 1.0))
        cut = beside[SIZE[1] :, SIZE[0] // 2 : 3 * SIZE[0] // 2]
        assert numpy.abs(cut - alone).mean() < 0.01, numpy.abs(cut - alone).mean()
        assert alone.std() > 0.15


def test_missing_array_is_an_error():
    drawn([sphere_actor(0.5, noise_style(0, 0.5, DirectionArrayName="Wind"), 0.5)], False)
    scene.expect_messages("array 'Wind' is missing")


if __name__ == "__main__":
    scene.run(globals())
