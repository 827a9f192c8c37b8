# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stipples: their ink is the tone, they stay on the surface, and none is seen that is hidden."""

import hachure
import numpy
import pattern_scene as scene
from stipple_scene import stage, stipple_layer, stipple_style
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

TONES = (0.05, 0.2, 0.5, 0.75, 0.9)
TOLERANCE = 0.02
TONE = hachure.vtkPatternTone


def check_ink(data, position, **parameters):
    actor, renderer, window = stage(data, stipple_style(1.0), position)
    mask = (scene.draw(window) == 0).all(axis=2)
    assert 0.3 < mask.mean(), mask.mean()
    style = stipple_style(0.0, **parameters)
    actor.GetMapper().SetStyle(style)
    assert (scene.draw(window)[mask] == 255).all(), "tone 0 is bare paper"
    worst = (0.0, "")
    for tone in TONES:
        style.GetLayer(0).GetTone().SetConstant(tone)
        found = scene.ink(scene.draw(window), mask)
        worst = max(worst, (abs(found - tone), (tone, found)))
    print("largest error", worst, parameters)
    assert worst[0] < TOLERANCE, (worst, parameters)


def test_ink_equals_tone_on_a_plane():
    for parameters in ({}, {"Size": 6.0}, {"Carrier": 1}, {"Growth": 1.0}):
        check_ink(scene.plane(3.0), (0.0, 0.0, 3.0), **parameters)


def test_ink_equals_tone_on_a_sphere():
    for parameters in ({}, {"Carrier": 1}):
        check_ink(scene.sphere(), (0.0, 0.0, 2.2), **parameters)


def test_frames_do_not_depend_on_each_other():
    def frames(order):
        actor, renderer, window = stage(scene.sphere(), stipple_style())
        pictures = {}
        for angle in order:
            scene.look(renderer, (3 * numpy.sin(angle), 0.0, 3 * numpy.cos(angle)))
            pictures[angle] = scene.draw(window)
        return pictures
    angles = [0.1 * i for i in range(5)]
    forwards, backwards = frames(angles), frames(angles[::-1])
    assert all((forwards[angle] == backwards[angle]).all() for angle in angles)
    assert (forwards[0.0] != forwards[0.1]).any()


def test_points_that_move_carry_the_stipples():
    """Deformed points take their stipples along, as the actor's motion does."""
    data = scene.sphere().GetOutput()
    actor, renderer, window = stage(data, stipple_style())
    window.Render()
    actor.SetPosition(0.2, 0.1, 0.0)
    by_actor = scene.draw(window)
    actor.SetPosition(0.0, 0.0, 0.0)
    points = vtk_to_numpy(data.GetPoints().GetData())
    points += numpy.array([0.2, 0.1, 0.0], dtype=points.dtype)
    data.GetPoints().Modified()
    by_points = scene.draw(window)
    difference = numpy.abs(by_actor.astype(int) - by_points)
    assert difference.mean() < 0.5, difference.mean()


def test_stretched_surfaces_keep_their_tone():
    data = scene.plane(1.2)
    data.SetResolution(20, 20)
    data.Update()
    surface = data.GetOutput()
    actor, renderer, window = stage(surface, stipple_style(0.4))
    window.Render()
    points = vtk_to_numpy(surface.GetPoints().GetData())
    points[points[:, 0] > 0, 0] *= 2.0
    surface.GetPoints().Modified()
    pixels = scene.draw(window)
    left, right = scene.ink(pixels[100:156, 90:125]), scene.ink(pixels[100:156, 131:200])
    assert abs(left - 0.4) < 0.03 and abs(right - 0.4) < 0.03, (left, right)


def squares(*places):
    """Squares (width, z) as blocks."""
    blocks = vtkMultiBlockDataSet()
    for i, (width, z) in enumerate(places):
        source = scene.plane(width)
        source.SetCenter(0.0, 0.0, z)
        source.Update()
        blocks.SetBlock(i, source.GetOutput())
    return blocks


def test_hidden_stipples_are_not_drawn():
    """A second square behind the first, at any distance, changes nothing."""
    style = stipple_style(0.4)
    _, _, window = stage(squares((1.2, 0.0)), style)
    alone = scene.draw(window)
    for gap in (0.02, 0.2):
        blocks = squares((1.2, 0.0), (1.2, -gap))
        _, _, window = stage(blocks, style)
        ink = scene.ink(scene.draw(window)[80:176, 80:176])
        assert abs(ink - 0.4) < TOLERANCE, (gap, ink)
    assert abs(scene.ink(alone[80:176, 80:176]) - 0.4) < TOLERANCE


def test_backs_of_a_closed_surface_are_hidden_where_it_is_thin():
    """A disc of less than a pixel's thickness, seen from both sides."""
    from vtkmodules.vtkFiltersSources import vtkCubeSource
    plate = vtkCubeSource()
    plate.SetXLength(1.0)
    plate.SetYLength(1.0)
    plate.SetZLength(0.004)
    for side in (2.0, -2.0):
        _, _, window = stage(plate, stipple_style(0.4), (0.0, 0.0, side))
        ink = scene.ink(scene.draw(window)[80:176, 80:176])
        assert abs(ink - 0.4) < TOLERANCE, (side, ink)


def test_open_surfaces_show_stipples_on_both_sides():
    for side in (3.0, -3.0):
        _, _, window = stage(scene.plane(1.5), stipple_style(0.4), (0.0, 0.0, side))
        ink = scene.ink(scene.draw(window)[80:176, 80:176])
        assert abs(ink - 0.4) < TOLERANCE, (side, ink)


def test_tone_of_an_array():
    data = scene.plane(1.5)
    data.SetResolution(30, 30)
    data.Update()
    surface = data.GetOutput()
    points = vtk_to_numpy(surface.GetPoints().GetData())
    values = points[:, 0] / 1.5 + 0.5
    values[points[:, 1] > 0.6] = numpy.nan
    scene.add_array(surface.GetPointData(), "along", values)
    style = stipple_style()
    style.GetLayer(0).GetTone().SetSource(TONE.ARRAY)
    style.GetLayer(0).GetTone().SetArrayName("along")
    _, _, window = stage(surface, style)
    pixels = scene.draw(window)
    edges = numpy.linspace(58, 198, 8).astype(int)
    for begin, end in zip(edges[:-1], edges[1:]):
        middle = 0.5 * (begin + end) - 128.0
        tone = middle * (2 * 3.0 * numpy.tan(numpy.radians(15.0)) / 256) / 1.5 + 0.5
        ink = scene.ink(pixels[60:160, begin:end])
        assert abs(ink - tone) < 0.03, (tone, ink)
    grey = pixels[232:240, 100:150].reshape(-1, 3)
    assert (grey == (128, 0, 0)).all(), grey[0]  # of the lookup table, without data


def test_inks_and_papers():
    """White on dark is black on white the other way round; two inks are drawn both."""
    dark = hachure.vtkPatternStyle()
    dark.SetPaperColor(0.0, 0.0, 0.0)
    layer = stipple_layer(0.3)
    layer.SetColor(1.0, 1.0, 1.0)
    dark.AddLayer(layer)
    _, _, window = stage(scene.plane(), stipple_style(0.3))
    black = scene.linear(scene.draw(window))
    _, _, window = stage(scene.plane(), dark)
    white = scene.linear(scene.draw(window))
    assert numpy.abs(black + white - 1.0).max() < 0.02
    two = hachure.vtkPatternStyle()
    for seed, color in ((1, (1.0, 0.0, 0.0)), (2, (0.0, 0.0, 1.0))):
        layer = stipple_layer(0.2, Seed=seed)
        layer.SetColor(*color)
        two.AddLayer(layer)
    _, _, window = stage(scene.plane(), two)
    pixels = scene.linear(scene.draw(window)).mean(axis=(0, 1))
    red, blue = 1.0 - pixels[2], 1.0 - pixels[0]  # the other is taken away
    assert abs(blue - 0.2) < TOLERANCE and abs(red - 0.2 * 0.8) < TOLERANCE, (red, blue)


def test_seeds_and_numbers_of_points():
    _, _, window = stage(scene.plane(3.0), stipple_style())
    first = scene.draw(window)
    _, _, window = stage(scene.plane(3.0), stipple_style(Seed=7))
    assert (scene.draw(window) != first).any()
    # More points are the same ones and others.
    pictures = []
    for number in (20000, 24000):
        style = stipple_style(0.2, NumberOfPoints=number, Refinement=False)
        _, _, window = stage(scene.plane(3.0), style)
        pictures.append(scene.draw(window))
    assert (pictures[0] == pictures[1]).mean() > 0.999  # but for rounding
    _, _, window = stage(scene.plane(3.0), stipple_style(NumberOfPoints=0, Refinement=False))
    assert (scene.draw(window) == 255).all()


def test_a_spent_budget_is_told_once():
    """And the ink stays the tone: stipples are larger."""
    style = stipple_style(0.4, NumberOfPoints=3000, MemoryBudget=0)
    _, renderer, window = stage(scene.plane(), style, (0.0, 0.0, 12.0))
    window.Render()
    scene.expect_messages("stipples that views asked for take all of the memory budget of 0 MiB")
    for distance in (8.0, 120.0, 6.0):  # of which the middle one has enough
        scene.look(renderer, (0.0, 0.0, distance))
        ink = scene.ink(scene.draw(window))
        assert abs(ink - 0.4) < 0.03 or distance > 100.0, (distance, ink)


def test_odd_input():
    """Empty, one triangle, mixed with lines and vertices, without points: right, and silent."""
    points = vtkPoints()
    for place in ((-1, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 0)):
        points.InsertNextPoint(*place)
    lines = vtkPolyData()
    lines.SetPoints(points)
    cells = vtkCellArray()
    cells.InsertNextCell(2)
    cells.InsertCellPoint(0)
    cells.InsertCellPoint(1)
    lines.SetLines(cells)
    triangle = vtkPolyData()
    triangle.SetPoints(points)
    polys = vtkCellArray()
    for corners in ((0, 1, 2), (0, 1, 1), (0, 1, 2), (0, 4, 1), (0, 3, 1)):
        polys.InsertNextCell(3)
        for corner in corners:
            polys.InsertCellPoint(corner)
    triangle.SetPolys(polys)
    both = vtkAppendPolyData()
    both.AddInputData(lines)
    both.AddInputData(triangle)
    both.Update()
    empty = vtkMultiBlockDataSet()
    empty.SetNumberOfBlocks(3)
    empty.SetBlock(1, vtkPolyData())
    empty.SetBlock(2, triangle)
    cases = ((vtkPolyData(), False), (lines, False), (triangle, True), (both.GetOutput(), True),
             (empty, True))
    for order in (0, 1):
        for data, inked in cases:
            _, _, window = stage(data, stipple_style(NumberOfPoints=3000, Order=order))
            pixels = scene.draw(window)
            assert (pixels.std() > 20) or not inked, order


def test_points_that_are_not_finite():
    data = scene.sphere().GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData())
    points[700] = numpy.nan
    _, _, window = stage(data, stipple_style())
    assert scene.draw(window).std() > 50
    scene.expect_messages("1 input point(s) have a coordinate that is not finite")


def test_other_cells_are_another_surface():
    actor, renderer, window = stage(scene.sphere(24), stipple_style())
    window.Render()
    other = scene.sphere(30)
    actor.GetMapper().SetInputConnection(other.GetOutputPort())
    after = scene.draw(window)
    _, _, fresh = stage(other, stipple_style())
    assert (after == scene.draw(fresh)).all()


def test_windows_of_other_sizes():
    _, _, window = stage(scene.sphere(), stipple_style())
    before = scene.draw(window)
    window.SetSize(1, 1)
    window.Render()
    window.SetSize(300, 200)
    window.Render()
    window.SetSize(256, 256)
    assert (scene.draw(window) == before).all()


if __name__ == "__main__":
    scene.run(globals())
