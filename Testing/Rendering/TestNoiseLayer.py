# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Noise layers: ink is the tone, kernels stay on the surface, and what trims them can be chosen."""

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkImageData, vtkMultiBlockDataSet, vtkPolyData)
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

KINDS = {"gabor": 0, "phasor": 1, "spot": 2}
TONES = (0.05, 0.2, 0.5, 0.8, 0.95)
TOLERANCE = 0.01
SEEDS = range(1, 9)  # a picture has few marks: it is averaged


def noise_style(tone=0.5, **parameters):
    """One noise layer of even tone in black on white."""
    style = hachure.vtkPatternStyle()
    layer = hachure.vtkNoiseLayer()
    layer.GetTone().SetSource(hachure.vtkPatternTone.CONSTANT)
    layer.GetTone().SetConstant(tone)
    for name, value in parameters.items():
        getattr(layer, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
    style.AddLayer(layer)
    return style


def stage(data, style, position=(0.0, 0.0, 3.0), size=(256, 256)):
    actor = scene.actor_of(data, style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=size)
    scene.look(renderer, position)
    return actor, renderer, window


def check_ink(data, position, kinds):
    """Mean over seeds and pixels of the surface; largest error over kinds and tones."""
    actor, renderer, window = stage(data, noise_style(1.0), position)
    mask = (scene.draw(window) == 0).all(axis=2)
    assert 0.3 < mask.mean(), mask.mean()
    worst = (0.0, "")
    for kind, spread, size in kinds:
        style = noise_style(Kind=KINDS[kind], Spread=spread, Size=size)
        actor.GetMapper().SetStyle(style)
        layer = style.GetLayer(0)
        for tone in (0.0, 1.0):
            layer.GetTone().SetConstant(tone)
            assert (scene.draw(window)[mask] == (0 if tone else 255)).all(), (kind, tone)
        for tone in TONES:
            layer.GetTone().SetConstant(tone)
            inks = []
            for seed in SEEDS:
                layer.SetSeed(seed)
                inks.append(scene.ink(scene.draw(window), mask))
            worst = max(worst, (abs(numpy.mean(inks) - tone), (kind, spread, size, tone, inks)))
    print("largest error", worst)
    assert worst[0] < TOLERANCE, worst


def test_ink_equals_tone_on_a_plane():
    check_ink(scene.plane(), (0.0, 0.0, 3.0),
              (("gabor", 0, 8), ("gabor", 90, 7), ("phasor", 0, 8), ("spot", 30, 12)))


def test_ink_equals_tone_on_a_sphere():
    check_ink(scene.sphere(), (0.0, 0.0, 2.2), (("gabor", 90, 8), ("phasor", 0, 7)))


def test_soft_marks_keep_the_tone():
    actor, renderer, window = stage(scene.plane(), noise_style())
    for tone in TONES:
        inks = []
        for seed in SEEDS:
            actor.GetMapper().SetStyle(noise_style(tone, Smoothness=0.6, Spread=90, Seed=seed))
            inks.append(scene.ink(scene.draw(window)))
        assert abs(numpy.mean(inks) - tone) < TOLERANCE, (tone, inks)


def test_pan_shifts_the_picture():
    """By whole pixels, also where half of the surface leaves the picture."""
    pixel = 2.0 * 3.0 * numpy.tan(numpy.radians(15.0)) / 256
    for kind in KINDS.values():
        actor, renderer, window = stage(scene.plane(1.4), noise_style(Kind=kind, Spread=60))
        first = scene.draw(window).astype(int)
        for shift in (9, 140):
            offset = shift * pixel
            scene.look(renderer, (offset, 0.0, 3.0), (offset, 0.0, 0.0))
            moved = scene.draw(window).astype(int)
            difference = numpy.abs(moved[:, :-shift] - first[:, shift:])
            assert difference.mean() < 0.5, (kind, shift, difference.mean())
            assert first[:, shift:].std() > 50, "there is nothing to see"


def test_frames_do_not_depend_on_each_other():
    def frames(order):
        actor, renderer, window = stage(scene.sphere(), noise_style(Spread=90))
        pictures = {}
        for angle in order:
            scene.look(renderer, (3 * numpy.sin(angle), 0.0, 3 * numpy.cos(angle)))
            pictures[angle] = scene.draw(window)
        return pictures
    angles = [0.1 * i for i in range(5)]
    forwards, backwards = frames(angles), frames(angles[::-1])
    assert all((forwards[angle] == backwards[angle]).all() for angle in angles)
    assert (forwards[0.0] != forwards[0.1]).any()


def test_points_that_move_carry_the_noise():
    """Deformed points take their kernels along, as the actor's motion does."""
    data = scene.sphere().GetOutput()
    actor, renderer, window = stage(data, noise_style(Spread=90))
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


def two_squares(gap):
    """A square before a larger one, as two blocks."""
    blocks = vtkMultiBlockDataSet()
    for i, (width, z) in enumerate(((1.0, gap), (3.0, 0.0))):
        source = scene.plane(width)
        source.SetCenter(0.0, 0.0, z)
        source.Update()
        blocks.SetBlock(i, source.GetOutput())
    return blocks


def difference(data, position=(0.0, 0.0, 3.0), **parameters):
    """Where a parameter changes the picture: a map of pixels."""
    _, _, window = stage(data, noise_style(Spread=90, Size=12), position)
    before = scene.draw(window).astype(int)
    _, _, window = stage(data, noise_style(Spread=90, Size=12, **parameters), position)
    return numpy.abs(scene.draw(window).astype(int) - before).max(axis=2)


def test_tests_trim_kernels():
    data = two_squares(0.5)
    for name in ("DepthTest", "ObjectTest", "PartialVisibility"):
        others = {other: False for other in ("DepthTest", "ObjectTest", "PartialVisibility") if other != name}
        _, _, window = stage(data, noise_style(Spread=90, Size=12, **others))
        on = scene.draw(window).astype(int)
        _, _, window = stage(data, noise_style(Spread=90, Size=12, **others, **{name: False}))
        changed = numpy.abs(scene.draw(window).astype(int) - on).max(axis=2) > 10
        assert 0.002 < changed.mean(), (name, changed.mean())
        # What lies far from the edge of the nearer square stays.
        assert not changed[:8].any() or name != "DepthTest", name
    changed = difference(scene.plane(), TriangleTest=True) > 10
    assert 0.01 < changed.mean() < 0.5, changed.mean()


def test_kernels_of_the_triangle_test_end_at_its_edges():
    """With it, the picture of two triangles is that of each alone."""
    def triangles(*which):
        points = vtkPoints()
        for place in ((-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)):
            points.InsertNextPoint(*place)
        polys = vtkCellArray()
        for corners in which:
            polys.InsertNextCell(3)
            for corner in corners:
                polys.InsertCellPoint(corner)
        data = vtkPolyData()
        data.SetPoints(points)
        data.SetPolys(polys)
        return data
    def picture(data):
        _, _, window = stage(data, noise_style(Spread=90, TriangleTest=True, PartialVisibility=False))
        return scene.draw(window)
    both, lower = picture(triangles((0, 1, 2), (0, 2, 3))), picture(triangles((0, 1, 2)))
    inside = numpy.triu(numpy.ones((256, 256), dtype=bool), 4)
    assert (both[inside] == lower[inside]).mean() > 0.999


def test_directions_of_an_array():
    data = scene.plane()
    data.SetResolution(8, 8)
    data.Update()
    surface = data.GetOutput()
    points = vtk_to_numpy(surface.GetPoints().GetData())
    signs = numpy.where(numpy.arange(len(points)) % 2, 1.0, -1.0)  # whatever its sign
    scene.add_array(surface.GetPointData(), "across", numpy.outer(signs, (1.0, 0.0, 0.0)))
    _, _, window = stage(surface, noise_style(Kind=1, Angle=90, DirectionArrayName="across"))
    rows = scene.linear(scene.draw(window)).mean(axis=2)
    _, _, window = stage(surface, noise_style(Kind=1, Angle=90))
    columns = scene.linear(scene.draw(window)).mean(axis=2)
    def change(pixels, axis):
        return numpy.abs(numpy.diff(pixels, axis=axis)).mean()
    assert change(rows, 0) > 2 * change(rows, 1), "strokes run along x"
    assert change(columns, 1) > 2 * change(columns, 0), "strokes run along y"


def test_an_array_that_changes_in_a_block():
    source = scene.plane()
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, source.GetOutput())
    arrows = numpy.tile((1.0, 0.0, 0.0), (4, 1))
    array = scene.add_array(source.GetOutput().GetPointData(), "across", arrows)
    _, _, window = stage(blocks, noise_style(Kind=1, DirectionArrayName="across"))
    before = scene.draw(window)
    vtk_to_numpy(array)[:] = (0.0, 1.0, 0.0)
    array.Modified()
    assert (scene.draw(window) != before).any()


def frequency(pixels):
    """Mean frequency of a picture along x, cycles per pixel."""
    rows = pixels - pixels.mean()
    power = (numpy.abs(numpy.fft.rfft(rows, axis=1)) ** 2).sum(axis=0)
    return (power * numpy.fft.rfftfreq(rows.shape[1])).sum() / power.sum()


def test_sizes_of_an_array_and_of_the_tone():
    data = scene.plane()
    data.SetResolution(8, 8)
    data.Update()
    surface = data.GetOutput()
    points = vtk_to_numpy(surface.GetPoints().GetData())
    scene.add_array(surface.GetPointData(), "height", points[:, 1].astype(float))
    parameters = {"Angle": 90, "SizeFactors": (1.0, 2.0)}
    _, _, window = stage(surface, noise_style(
        Control=2, ControlArrayName="height", ControlRange=(-0.2, 0.2), **parameters))
    pixels = scene.linear(scene.draw(window)).mean(axis=2)
    low, high = frequency(pixels[:64]), frequency(pixels[192:])
    assert 1.6 < low / high < 2.4, (low, high)
    inks = []
    for tone in (0.1, 0.9):
        _, _, window = stage(surface, noise_style(tone, Control=1, **parameters))
        inks.append(frequency(scene.linear(scene.draw(window)).mean(axis=2)))
    assert inks[0] > 1.2 * inks[1], inks


def test_wrong_arrays_name_themselves():
    surface = scene.plane().GetOutput()
    scene.add_array(surface.GetPointData(), "pairs", numpy.zeros((4, 2)))
    for parameters, message in (
            ({"DirectionArrayName": "nothing"}, "direction array 'nothing' is missing"),
            ({"DirectionArrayName": "pairs"}, "direction array 'pairs' has 4 tuples of 2 components"),
            ({"Control": 2, "ControlArrayName": "nothing"}, "control array 'nothing' is missing"),
            ({"Control": 2}, "control array '' is missing"),
            ({"Control": 2, "ControlArrayName": "pairs", "ControlRange": (3.0, 3.0)},
             "control range is [3.000000, 3.000000]; expected two different")):
        _, _, window = stage(surface, noise_style(**parameters))
        pixels = scene.draw(window)
        window.Render()
        scene.expect_messages(message)  # once
        assert pixels.std() > 50, "the noise is drawn all the same"


def test_wrong_spot():
    image = vtkImageData()
    image.SetDimensions(4, 4, 4)
    _, _, window = stage(scene.plane(), noise_style(Kind=2, Image=image))
    window.Render()
    scene.expect_messages("layer 0: image: expected a 2D image with scalars")


def test_spot_of_a_user():
    image = vtkImageData()
    image.SetDimensions(16, 16, 1)
    ring = numpy.hypot(*numpy.meshgrid(*(numpy.arange(16) - 7.5,) * 2))
    values = scene.add_array(image.GetPointData(), "grey", numpy.exp(-((ring - 5) ** 2)).ravel())
    image.GetPointData().SetScalars(values)
    _, _, window = stage(scene.plane(), noise_style(Kind=2, Image=image, Size=16))
    assert scene.draw(window).std() > 50


def test_odd_input():
    """Empty, one triangle, mixed with lines and vertices, without points: right, and silent."""
    lines = vtkPolyData()
    points = vtkPoints()
    for place in ((-1, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 0)):
        points.InsertNextPoint(*place)
    lines.SetPoints(points)
    cells = vtkCellArray()
    cells.InsertNextCell(2)
    cells.InsertCellPoint(0)
    cells.InsertCellPoint(1)
    lines.SetLines(cells)
    triangle = vtkPolyData()
    triangle.SetPoints(points)
    polys = vtkCellArray()
    for corners in ((0, 1, 2), (0, 1, 1), (0, 1, 2), (0, 4, 1)):
        polys.InsertNextCell(3)
        for corner in corners:
            polys.InsertCellPoint(corner)
    triangle.SetPolys(polys)
    both = vtkAppendPolyData()
    both.AddInputData(lines)
    both.AddInputData(triangle)
    both.Update()
    for data, inked in ((vtkPolyData(), False), (lines, False), (triangle, True), (both.GetOutput(), True)):
        _, _, window = stage(data, noise_style(Spread=90))
        for kind in KINDS.values():
            pixels = scene.draw(window)
        assert (pixels.std() > 20) or not inked, kind


def test_other_cells_are_another_surface():
    actor, renderer, window = stage(scene.sphere(24), noise_style(Spread=90))
    window.Render()
    other = scene.sphere(30)
    actor.GetMapper().SetInputConnection(other.GetOutputPort())
    after = scene.draw(window)
    _, _, fresh = stage(other, noise_style(Spread=90))
    assert (after == scene.draw(fresh)).all()


def test_final_quality_is_the_same_picture():
    """As hachure-render draws both: two and four times larger, and the latter hidden pixel by pixel."""
    pictures = []
    for scale, final in ((2, False), (4, True)):
        style = noise_style(Spread=90)
        style.SetPixelScale(scale)
        style.SetFinalQuality(final)
        _, _, window = stage(scene.sphere(), style, size=(256 * scale, 256 * scale))
        blocks = scene.linear(scene.draw(window)).reshape(256, scale, 256, scale, 3)
        pictures.append(255 * blocks.mean(axis=(1, 3)) ** (1 / 2.2))
    difference = numpy.abs(pictures[1] - pictures[0]).mean()
    print("final against interactive", difference)
    assert difference < 2, difference


def test_window_that_changes_its_size():
    _, _, window = stage(scene.sphere(), noise_style(Spread=90))
    for size in ((64, 64), (300, 200), (1, 1), (128, 128)):
        window.SetSize(*size)
        window.Render()
    assert scene.draw(window).std() > 30


scene.run(globals())
