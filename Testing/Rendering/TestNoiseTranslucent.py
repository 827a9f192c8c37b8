# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Noise on translucent surfaces: every one has its own, and its ink is its tone."""

import hachure
import numpy
import pattern_scene as scene

SIZE = (160, 160)
KINDS = {"gabor": 0, "phasor": 1, "spot": 2}


def noise_style(kind, tone, **values):
    """Black ink of one tone on white paper."""
    style = hachure.vtkPatternStyle()
    layer = hachure.vtkNoiseLayer()
    layer.SetKind(kind)
    layer.SetSize(6.0)
    for name, value in values.items():
        getattr(layer, "Set" + name)(value)
    layer.GetTone().SetSource(hachure.vtkPatternTone.CONSTANT)
    layer.GetTone().SetConstant(tone)
    style.AddLayer(layer)
    return style


def sphere_actor(radius, style, opacity):
    actor = scene.actor_of(scene.sphere(radius=radius), style)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def drawn(actors, peeling, size=SIZE):
    """Display-referred grey, 0 to 1."""
    renderer = scene.renderer_of(*actors)
    window = scene.window_of(renderer, size=size)
    window.SetAlphaBitPlanes(1)
    if peeling:
        renderer.SetUseDepthPeeling(True)
        renderer.SetMaximumNumberOfPeels(8)
        renderer.SetOcclusionRatio(0.0)
    scene.look(renderer, position=(0.0, 0.0, 2.2))
    window.Render()
    return scene.picture(window)[:, :, 0] / 255.0


def disc(share):
    """Pixels within a share of the half picture around its middle."""
    y, x = numpy.mgrid[0 : SIZE[1], 0 : SIZE[0]]
    return numpy.hypot(x - SIZE[0] / 2 + 0.5, y - SIZE[1] / 2 + 0.5) < share * SIZE[0] / 2


def tone_of(picture, opacity):
    """Of one surface alone in front of white, whose display-referred colour VTK blends."""
    own = numpy.clip((picture - (1.0 - opacity)) / opacity, 0.0, 1.0)
    return 1.0 - scene.linear(255.0 * own)


def in_front(front, behind, opacity):
    """The picture of a surface, which alone is `front`, in front of others that alone are `behind`."""
    return front - (1.0 - opacity) * (1.0 - behind)


def front_actor(radius, style, opacity):
    actor = sphere_actor(radius, style, opacity)
    actor.GetProperty().BackfaceCullingOn()
    return actor


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


def correlation(one, other):
    return numpy.corrcoef(one, other)[0, 1]


def test_front_and_back_differ():
    """Of one sphere, each side has its own kernels."""
    pictures = {}
    for culled in ("none", "back", "front"):
        actor = sphere_actor(0.5, noise_style(0, 0.5), 0.5)
        actor.GetProperty().SetBackfaceCulling(culled == "back")
        actor.GetProperty().SetFrontfaceCulling(culled == "front")
        pictures[culled] = drawn([actor], True)[disc(0.6)]
    assert abs(correlation(pictures["back"], pictures["front"])) < 0.1
    both = in_front(pictures["back"], pictures["front"], 0.5)
    assert numpy.abs(both - pictures["none"]).mean() < 0.01
    for name, picture in pictures.items():
        assert picture.std() > 0.15, name


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


def test_missing_array_is_an_error():
    drawn([sphere_actor(0.5, noise_style(0, 0.5, DirectionArrayName="Wind"), 0.5)], False)
    scene.expect_messages("array 'Wind' is missing")


if __name__ == "__main__":
    scene.run(globals())
