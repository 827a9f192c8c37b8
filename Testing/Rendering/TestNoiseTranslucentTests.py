# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What trims kernels on opaque surfaces does so on translucent ones: blocks, triangles and depth."""

import numpy
import pattern_scene as scene
from noise_scene import (
    SIZE, blocks_of, correlation, disc, drawn, in_front, noise_style, tone_of, translucent)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

SWITCHES = ({}, {"ObjectTest": False}, {"DepthTest": False}, {"ObjectTest": False, "DepthTest": False},
            {"TriangleTest": True}, {"TriangleTest": True, "ObjectTest": False, "DepthTest": False})


def test_tones_with_every_test_on_and_off():
    """Of nested spheres, and of spheres that overlap, as blocks of one surface."""
    outer = scene.sphere(12)
    for name, inner, region in (("nested", scene.sphere(12, 0.3), disc(0.4)),
                                ("overlapping", scene.sphere(12, 0.4, (0.1, 0.05, -0.3)), disc(0.4))):
        for switches in SWITCHES:
            style = noise_style(0, 0.4, Spread=90.0, Overlap=64.0, **switches)
            alone = [drawn([translucent(source, style, 0.5, "back")], True)[region]
                     for source in (outer, inner)]
            for picture in alone:
                assert abs(tone_of(picture, 0.5).mean() - 0.4) < 0.03, (name, switches)
            both = drawn([translucent(blocks_of(outer, inner), style, 0.5, "back")], True)[region]
            expected = in_front(*alone, 0.5)
            print("%s, %s: %.4f, expected %.4f" % (name, switches, both.mean(), expected.mean()))
            assert abs(both.mean() - expected.mean()) < 0.015, (name, switches)
            assert both.std() > 0.15, (name, switches)


def two_halves(*which):
    """The left and the right half of a square, as blocks, with space for the others."""
    halves = []
    for left in (-2.0, 0.0):
        half = scene.plane()
        half.SetOrigin(left, -2.0, 0.0)
        half.SetPoint1(left + 2.0, -2.0, 0.0)
        half.SetPoint2(left, 2.0, 0.0)
        half.Update()
        halves.append(half)
    blocks = blocks_of(*halves)
    for i in {0, 1}.difference(which):
        blocks.GetBlock(i).GetPointData().Initialize()
        blocks.GetBlock(i).GetPolys().Initialize()
    return blocks


def test_kernels_of_other_blocks():
    """With the test, blocks are drawn as each alone; without, marks run on into the next one."""
    middle = SIZE[0] // 2
    for on in (True, False):
        style = noise_style(0, 0.5, Spread=90.0, ObjectTest=on)
        both = drawn([translucent(two_halves(0, 1), style, 0.6)], False)
        left = drawn([translucent(two_halves(0), style, 0.6)], False)
        changed = numpy.abs(both - left)[:, :middle] > 0.02
        print("object test %d: %.4f of the pixels by the border, %.4f of the others" % (
            on, changed[:, -6:].mean(), changed[:, :-7].mean()))
        assert changed[:, :-7].mean() < 0.001
        assert changed[:, -6:-1].mean() < 0.001 if on else changed[:, -6:-1].mean() > 0.1


def test_front_and_back_differ():
    """Of one sphere, each side has its own kernels, unless nothing tells them apart."""
    for depth_test in (True, False):
        style = noise_style(0, 0.5, DepthTest=depth_test)
        pictures = {}
        for culled in ("none", "back", "front"):
            actor = translucent(scene.sphere(), style, 0.5, culled)
            pictures[culled] = drawn([actor], True)[disc(0.6)]
        alike = correlation(pictures["back"], pictures["front"])
        assert abs(alike) < 0.1 if depth_test else alike > 0.9, alike
        both = in_front(pictures["back"], pictures["front"], 0.5)
        assert numpy.abs(both - pictures["none"]).mean() < 0.01
        for name, picture in pictures.items():
            assert picture.std() > 0.15, name


def surface(cells, strips=(), lines=()):
    """Polygons and strips of points on a grid of 5 x 5 places from -1 to 1, bent down at the rim."""
    points = vtkPoints()
    for row in range(5):
        for column in range(5):
            x, y = column / 2.0 - 1.0, row / 2.0 - 1.0
            points.InsertNextPoint(x, y, -0.05 * (x * x + y * y))
    data = vtkPolyData()
    data.SetPoints(points)
    for lists, put in ((cells, data.SetPolys), (strips, data.SetStrips), (lines, data.SetLines)):
        array = vtkCellArray()
        for corners in lists:
            array.InsertNextCell(len(corners))
            for corner in corners:
                array.InsertCellPoint(corner)
        put(array)
    return data


TRIANGLES = [cell for i in (0, 2, 10, 12) for cell in ((i, i + 2, i + 12), (i, i + 12, i + 10))]
QUADS = [(i, i + 2, i + 12, i + 10) for i in (0, 2, 10, 12)]
STRIPS = [(10, 0, 12, 2, 14, 4), (20, 10, 22, 12, 24, 14)]


def opaque_and_translucent(data, **switches):
    style = noise_style(0, 0.5, Spread=90.0, PartialVisibility=False, **switches)
    return [drawn([translucent(data, style, opacity)], False) for opacity in (1.0, 0.9999)]


def test_kernels_of_other_triangles():
    """However VTK numbers the primitives that it draws, behind lines too, the picture is the opaque one."""
    pictures = []
    for name, data in (("triangles", surface(TRIANGLES)), ("quads", surface(QUADS)),
                       ("strips", surface([], STRIPS)), ("mixed", surface(QUADS[:2], STRIPS[1:])),
                       ("lines", surface(TRIANGLES, lines=[(0, 1, 2)]))):
        opaque, clear = opaque_and_translucent(data, TriangleTest=True)
        pictures.append(clear)
        alike = correlation(opaque[4:-4, 4:-4].ravel(), clear[4:-4, 4:-4].ravel())
        without = drawn([translucent(data, noise_style(0, 0.5, Spread=90.0), 0.9999)], False)
        changed = (numpy.abs(clear - without) > 0.1).mean()
        print("%s: correlation %.3f with the opaque one, the test changes %.3f" % (name, alike, changed))
        assert alike > 0.97, (name, alike)
        assert 0.02 < changed < 0.5, (name, changed)


def test_polygons_count_as_one():
    """VTK cuts polygons of many corners in its own way: marks run on inside them, and end at their edges."""
    octagon = (0, 2, 4, 14, 24, 22, 20, 10)
    whole = surface([octagon])
    on, off = [drawn([translucent(whole, noise_style(0, 0.5, Spread=90.0, TriangleTest=test), 0.9)], False)
               for test in (True, False)]
    assert on.std() > 0.3
    assert (numpy.abs(on - off) > 0.02).mean() < 0.01


def test_blocks_with_lines_and_changed_cells():
    """The numbers of primitives follow the data."""
    data = surface(QUADS)
    style = noise_style(0, 0.5, Spread=90.0, TriangleTest=True)
    actor = translucent(data, style, 0.9)
    window = scene.window_of(scene.renderer_of(actor), size=SIZE)
    window.SetAlphaBitPlanes(1)
    renderer = window.GetRenderers().GetFirstRenderer()
    scene.look(renderer, position=(0.0, 0.0, 2.2))
    window.Render()
    other = surface(QUADS[::-1], lines=[(0, 1, 2)])
    actor.GetMapper().SetInputDataObject(other)
    window.Render()
    found = scene.picture(window)[:, :, 0] / 255.0
    expected = drawn([translucent(other, style, 0.9)], False)
    assert (found == expected).all(), (found != expected).mean()


scene.run(globals())
