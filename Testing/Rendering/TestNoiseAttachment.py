# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Noise on surfaces whose cells change from frame to frame: it neither boils nor pops nor slides."""

import hachure
import numpy
import pattern_scene as scene
from sweep_scene import changes, inside, isosurface, stage, sweep
from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

KINDS = {"gabor": 0, "phasor": 1, "spot": 2}
FRAMES = 11


def noise_style(tone=0.5, **parameters):
    style = hachure.vtkPatternStyle()
    layer = hachure.vtkNoiseLayer()
    layer.GetTone().SetSource(hachure.vtkPatternTone.CONSTANT)
    layer.GetTone().SetConstant(tone)
    for name, value in parameters.items():
        getattr(layer, "Set" + name)(value)
    style.AddLayer(layer)
    return style


def test_isosurface_sweep():
    """Little of the picture changes in a frame, and in every frame as much; contrast and ink stay."""
    mask = inside(noise_style(1.0), FRAMES)
    for kind, number in KINDS.items():
        style = dict(Kind=number, Spread=90, Size=12, Smoothness=1)
        attached = sweep(noise_style(**style), FRAMES)
        anew = sweep(noise_style(Life=0, **style), FRAMES)
        boil, without = changes(attached, mask), changes(anew, mask)
        print(kind, "changes by", numpy.median(boil), boil.max(), "without", numpy.median(without))
        assert without.min() > 0.9 and boil.max() < 0.1, (kind, boil, without)
        assert boil.max() < 2.0 * numpy.median(boil), (kind, boil)
        contrast = numpy.array([picture[mask].std() for picture in attached])
        contrast /= numpy.mean([picture[mask].std() for picture in anew])
        assert abs(contrast - 1.0).max() < 0.05, (kind, contrast)
        inks = numpy.array([picture[mask].mean() for picture in attached])
        assert abs(inks - 0.5).max() < 0.02, (kind, inks)


def test_still_pictures_stay():
    """The same frame twice, and one drawn before a sweep, in another renderer, and as translucent."""
    contour = isosurface()
    actor, _, window = stage(contour, noise_style(Spread=90))
    for opacity in (1.0, 0.6):
        actor.GetProperty().SetOpacity(opacity)
        for value in (150.0, 151.0, 153.0):
            contour.SetValue(0, value)
            first = scene.draw(window)
            assert (scene.draw(window) == first).all(), (opacity, value)


def fresh(data, style, **parameters):
    _, _, window = stage(data, style, **parameters)
    return scene.draw(window)


def test_renderers_remember_for_themselves():
    contour = isosurface()
    mapper_stages = [stage(contour, noise_style(Spread=90)) for _ in range(2)]
    (actor, _, window), (_, other_renderer, other_window) = mapper_stages
    other_renderer.RemoveAllViewProps()
    other_renderer.AddActor(actor)
    window.Render()
    contour.SetValue(0, 152.0)
    carried = scene.draw(window)
    anew = scene.draw(other_window)
    new = isosurface(152.0)
    assert (anew == fresh(new, noise_style(Spread=90))).all()
    assert (carried != anew).any()


def test_where_history_cannot_be_used():
    """After Reanchor, backwards in time, without a life, with anchored patterns: as a first frame."""
    def expected(value):
        return fresh(isosurface(value), noise_style(Spread=90))

    def after(action, value=152.0, **parameters):
        contour = isosurface()
        style = noise_style(Spread=90, **parameters)
        actor, renderer, window = stage(contour, style)
        actor.GetMapper().SetAnimationTime(5.0)
        window.Render()
        action(actor.GetMapper(), renderer, style)
        contour.SetValue(0, value)
        return scene.draw(window)

    new = expected(152.0)
    assert (after(lambda mapper, *_: mapper.SetAnimationTime(6.0)) != new).any()
    assert (after(lambda mapper, *_: mapper.SetAnimationTime(4.0)) == new).all()
    assert (after(lambda mapper, renderer, _: mapper.Reanchor(renderer)) == new).all()
    assert (after(lambda *_: None, Life=0) == new).all()
    assert (after(lambda *_: None, Distribution=1) != after(lambda *_: None)).any()
    anchored = after(lambda mapper, _, style: style.SetTrackingMode(style.ANCHORED))
    assert (anchored == new).all()


def test_tiles_do_not_advance():
    """A screenshot in tiles between two frames changes neither of them."""
    pictures = []
    for tiled in (False, True):
        contour = isosurface()
        _, _, window = stage(contour, noise_style(Spread=90))
        window.Render()
        contour.SetValue(0, 152.0)
        if tiled:
            window.SetTileScale(2)
            for viewport in ((0, 0, 0.5, 0.5), (0.5, 0, 1, 0.5)):
                window.SetTileViewport(*viewport)
                window.Render()
            window.SetTileScale(1)
            window.SetTileViewport(0, 0, 1, 1)
        pictures.append(scene.draw(window))
    assert (pictures[0] == pictures[1]).all()


def plate(cells, stretch=1.0, ids=True):
    """Squares of a plate, 8 x 8, with global ids."""
    data, points, polys, numbers = vtkPolyData(), vtkPoints(), vtkCellArray(), vtkIdTypeArray()
    for y in range(9):
        for x in range(9):
            points.InsertNextPoint(stretch * (x - 4) / 4.0, (y - 4) / 4.0, 0.0)
    for cell in cells:
        corner = 9 * (cell // 8) + cell % 8
        polys.InsertNextCell(4)
        for step in (0, 1, 10, 9):
            polys.InsertCellPoint(corner + step)
        numbers.InsertNextValue(100 + cell)
    data.SetPoints(points)
    data.SetPolys(polys)
    if ids:
        data.GetCellData().SetGlobalIds(numbers)
    return data


def test_cells_with_ids_keep_their_points():
    """A plate that is stretched loses its right side: the left looks as if it had not."""
    pictures = []
    for cells in (range(64), [cell for cell in range(64) if cell % 8 < 6]):
        data = plate(range(64))
        _, _, window = stage(data, noise_style(Spread=90), distance=5.0)
        window.Render()
        data.ShallowCopy(plate(cells, stretch=1.1))
        pictures.append(scene.draw(window))
    assert (pictures[0] != pictures[1]).any()
    left = [picture[:, :128].astype(int) for picture in pictures]
    difference = abs(left[0] - left[1])
    print("difference", difference.max(), difference.mean())
    assert difference.max() <= 2, "but for rounding"
    without = fresh(plate(range(64), stretch=1.1), noise_style(Spread=90), distance=5.0)
    assert (pictures[0][:, :128] != without[:, :128]).any(), "areas are those of the first frame"


def test_odd_surfaces():
    """Nothing, a triangle, a corner that is not finite (which is named), and back."""
    def triangle(*places):
        data, points, polys = vtkPolyData(), vtkPoints(), vtkCellArray()
        for place in places:
            points.InsertNextPoint(*place)
        for first in range(0, len(places), 3):
            polys.InsertNextCell(3)
            for corner in range(3):
                polys.InsertCellPoint(first + corner)
        data.SetPoints(points)
        data.SetPolys(polys)
        return data

    corners = ((-1, -1, 0), (1, -1, 0), (0, 1, 0))
    broken = triangle(*corners, (0, 0, 0), (1, 0, float("nan")), (0, 1, 0))
    data = plate(range(64))
    _, _, window = stage(data, noise_style(Spread=90), distance=5.0)
    first = scene.draw(window)
    for other in (vtkPolyData(), triangle(*corners), broken, plate(range(3)), vtkPolyData()):
        data.ShallowCopy(other)
        pixels = scene.draw(window)
        assert (pixels.std() > 10) == (other.GetNumberOfCells() > 0)
    scene.expect_messages("1 input point(s) have a coordinate that is not finite")
    data.ShallowCopy(plate(range(64)))
    last = scene.draw(window).astype(int)
    print("back", abs(last - first).max(), (last != first).sum())
    assert (last == first).all()


scene.run(globals())
