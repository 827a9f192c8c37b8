# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stipples move with the surface, to a fraction of a pixel; where more are needed others join them."""

import itertools

import numpy
import pattern_scene as scene
from stipple_scene import stage, stipple_style

SIZE = 6.0  # diameter of dots, pixels: large enough to tell where their middle is
TONE = 0.15  # so few that they do not touch
PICTURE = (360, 360)
MARGIN = 8  # pixels from the border within which a dot may be cut off
FACING = 0.4  # n.v on the sphere: dots at its rim are cut off
DISTANCE = 3.0
RADIUS = 0.7
LARGEST = 0.05  # distance of a dot from its place on the surface, pixels, root mean square
SEARCHED = 1.0  # pixels about that place
KEPT = 0.9  # share of dots that have not begun to shrink where the surface turns away
ROUNDING = 0.05  # of a spot's area: bytes and pixels
WHOLE = numpy.pi * SIZE ** 2 / 4  # area of a dot
SPECK = 0.3  # of ink in all, below which a spot in the byte picture may be missed, pixels


def shifts(values):
    """The values of the eight neighbours of all pixels and of themselves."""
    wide = numpy.pad(values, 1, mode="edge")
    rows, columns = values.shape
    return [wide[i:i + rows, j:j + columns] for i, j in itertools.product(range(3), repeat=2)]


def spots(pixels):
    """The middle and the ink of every connected spot: rows of x, y, area."""
    ink = 1.0 - scene.linear(pixels[..., 0])
    outside = ink.size
    labels = numpy.where(ink > 0, numpy.arange(ink.size).reshape(ink.shape), outside)
    while True:
        joined = numpy.where(ink > 0, numpy.minimum.reduce(shifts(labels)), outside)
        if (joined == labels).all():
            break
        labels = joined
    here = labels < outside
    names, place = numpy.unique(labels[here], return_inverse=True)
    y, x = numpy.nonzero(here)
    area, sum_x, sum_y = (numpy.bincount(place, weights, len(names))
                          for weights in (ink[here], ink[here] * x, ink[here] * y))
    return numpy.column_stack([sum_x / area, sum_y / area, area])


def inside(found):
    """Which of them the border of the picture does not cut off."""
    return ((found[:, :2] > MARGIN) & (found[:, :2] < numpy.array(PICTURE) - 1 - MARGIN)).all(axis=1)


def whole(found):
    """Those that are one dot, grown and in full."""
    return found[inside(found) & (numpy.abs(found[:, 2] / WHOLE - 1) < ROUNDING)]


class View:
    """From pixels to a surface at rest and back, for a camera."""

    def __init__(self, renderer):
        width, height = PICTURE
        camera = renderer.GetActiveCamera()
        matrix = camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1)
        self.matrix = numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        self.eye = numpy.array(camera.GetPosition())

    def hit(self, name, found):
        """The places on plane or sphere that are seen at spots; NaN where it turns away."""
        ends = numpy.column_stack([2 * (found[:, :2] + 0.5) / PICTURE - 1, numpy.zeros(len(found)),
                                   numpy.ones(len(found))]) @ numpy.linalg.inv(self.matrix).T
        rays = ends[:, :3] / ends[:, 3:] - self.eye
        rays /= numpy.linalg.norm(rays, axis=1)[:, None]
        if name == "plane":
            return self.eye - rays * (self.eye[2] / rays[:, 2])[:, None]
        along = -rays @ self.eye
        height = along ** 2 - self.eye @ self.eye + RADIUS ** 2
        depth = along - numpy.sqrt(numpy.where(height > 0, height, numpy.nan))
        places = self.eye + rays * depth[:, None]
        facing = -(places * rays).sum(axis=1) / RADIUS
        return numpy.where((facing > FACING)[:, None], places, numpy.nan)

    def seen(self, name, found):
        return numpy.isfinite(self.hit(name, found)[:, 0])

    def places(self, name, found):
        return self.hit(name, found)[self.seen(name, found)]

    def pixels(self, places):
        ends = numpy.column_stack([places, numpy.ones(len(places))]) @ self.matrix.T
        return (ends[:, :2] / ends[:, 3:] + 1) / 2 * PICTURE - 0.5


def nearest(wanted, found):
    """For every one the spot next to it, and how far away that is."""
    away = numpy.linalg.norm(wanted[:, None, :2] - found[None, :, :2], axis=2)
    index = away.argmin(axis=1)
    return found[index], away[numpy.arange(len(wanted)), index]


def surface(name):
    return scene.plane(4.0) if name == "plane" else scene.sphere(200, RADIUS)


def carried(actor, places):
    """Where the actor's motion takes places of the model."""
    matrix = actor.GetMatrix()
    values = numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    return places @ values[:3, :3].T + values[:3, 3]


def pan(_actor, renderer):
    scene.look(renderer, (0.057, 0.031, DISTANCE), (0.057, 0.031, 0.0))


def roll(_actor, renderer):
    scene.look(renderer, (0.0, 0.0, DISTANCE), up=(0.2, 1.0, 0.0))


def approach(_actor, renderer):
    scene.look(renderer, (0.0, 0.0, DISTANCE - 0.2))


def orbit(_actor, renderer):
    scene.look(renderer, (0.3, 0.1, DISTANCE))


def turn_the_surface(actor, renderer):
    actor.RotateY(7.0)
    actor.RotateX(3.0)
    actor.SetPosition(0.03, 0.02, 0.01)
    renderer.ResetCameraClippingRange()


def check_motion(name, move):
    """Whole dots are there after the motion as well, where the surface has carried them."""
    actor, renderer, window = stage(
        surface(name), stipple_style(TONE, Size=SIZE), (0.0, 0.0, DISTANCE), PICTURE)
    before = whole(spots(scene.draw(window)))
    view = View(renderer)
    before = before[view.seen(name, before)]
    assert len(before) > 100, len(before)
    move(actor, renderer)
    wanted = View(renderer).pixels(carried(actor, view.places(name, before)))
    shown = inside(wanted)
    moved = numpy.linalg.norm(wanted - before[:, :2], axis=1)[shown].mean()
    away = nearest(wanted[shown], whole(spots(scene.draw(window))))[1]
    there = away < SEARCHED
    error = numpy.sqrt((away[there] ** 2).mean())
    print(name, move.__name__, len(away), "dots, there", there.mean(), "error", error, "moved", moved)
    assert moved > 1.0, moved
    assert there.mean() >= KEPT, (name, move.__name__, there.mean())
    assert error <= LARGEST, (name, move.__name__, error)


def test_dots_stay_on_the_surface():
    for name, move in itertools.product(("plane", "sphere"), (pan, roll, approach, orbit, turn_the_surface)):
        check_motion(name, move)


def test_a_darker_tone_only_adds_ink():
    """No pixel gets lighter, so that every dot of a lighter tone is in the darker one."""
    for name, carrier in itertools.product(("plane", "sphere"), (0, 1)):
        style = stipple_style(0.0, Size=SIZE, Carrier=carrier)
        _, _, window = stage(surface(name), style, (0.0, 0.0, DISTANCE), PICTURE)
        lighter = scene.draw(window).astype(int)
        for tone in numpy.linspace(0.04, 1.0, 25):
            style.GetLayer(0).GetTone().SetConstant(tone)
            darker = scene.draw(window).astype(int)
            assert (darker <= lighter).all(), (name, tone, (darker - lighter).max())
            assert (darker < lighter).any(), (name, tone)
            lighter = darker


def check_joined(name, before, view, after, later):
    """Every dot of the picture before is in the one after, and as large; some may touch others by then."""
    alone = before[(before[:, 2] > SPECK) & (before[:, 2] < (1 + ROUNDING) * WHOLE)]
    alone = alone[view.seen(name, alone)]
    wanted = later.pixels(view.places(name, alone))
    shown = inside(wanted)
    found, away = nearest(wanted[shown], after)
    touching = (found[:, 2] > (1 + ROUNDING) * WHOLE) & (away < SIZE)
    there = (away < SEARCHED) & (found[:, 2] > alone[shown, 2] - SPECK)
    print(name, len(there), "dots, there", there.sum(), "touching", (touching & ~there).sum())
    assert (there | touching).all() and there.mean() > 0.98, (name, there.mean())


def test_a_larger_picture_only_adds_dots():
    """In a zoom every dot stays, and none shrinks; the other way round none comes in."""
    for name in ("plane", "sphere"):
        _, renderer, window = stage(
            surface(name), stipple_style(TONE, Size=SIZE), (0.0, 0.0, DISTANCE), PICTURE)
        before, view = spots(scene.draw(window)), View(renderer)
        numbers = [inside(before).sum()]
        for _ in range(4):
            renderer.GetActiveCamera().Zoom(1.2)
            after, later = spots(scene.draw(window)), View(renderer)
            check_joined(name, before, view, after, later)
            numbers.append(inside(after).sum())
            before, view = after, later
        if name == "plane":  # so others do come in: the tone is even
            assert max(numbers) < 1.1 * min(numbers), numbers


if __name__ == "__main__":
    scene.run(globals())
