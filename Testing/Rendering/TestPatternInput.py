# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Odd input gives the right picture in silence, wrong input its message, nothing a crash."""

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

SIZE = 128
TONE = 0.5


def mesh(points, cells):
    data = vtkPolyData()
    array = vtkPoints()
    for point in points:
        array.InsertNextPoint(*point)
    polys = vtkCellArray()
    for cell in cells:
        polys.InsertNextCell(len(cell), cell)
    data.SetPoints(array)
    data.SetPolys(polys)
    return data


SQUARE = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
TRIANGLES = [(0, 1, 2), (0, 2, 3)]


class Stage:
    """Unlit surfaces at tone .5 on red, seen so that z = 0, |x|, |y| <= 1 fills the picture."""

    def __init__(self, data=None, pattern=0):
        self.style = scene.constant_style(pattern, 8, TONE)
        self.actor = scene.actor_of(data if data is not None else vtkPolyData(), self.style)
        if data is None:
            self.mapper.RemoveAllInputs()
        self.actor.GetProperty().LightingOff()
        self.renderer = scene.renderer_of(self.actor, background=(1.0, 0.0, 0.0))
        self.window = scene.window_of(self.renderer, size=(SIZE, SIZE))
        camera = scene.look(self.renderer)
        camera.ParallelProjectionOn()
        camera.SetParallelScale(1.0)
        camera.SetClippingRange(0.1, 10.0)

    @property
    def mapper(self):
        return self.actor.GetMapper()

    def draw(self):
        """Covered share of the picture and the mean ink there; the background must be intact."""
        return measure(scene.draw(self.window))


def measure(pixels):
    background = (pixels == (255, 0, 0)).all(axis=2)
    assert (pixels[~background][:, 0] == pixels[~background][:, 2]).all(), "not grey"
    covered = ~background
    return covered.mean(), scene.ink(pixels, covered) if covered.any() else None


def check(stage, share, tone=TONE, tolerance=0.02):
    for _ in range(2):
        covered, ink = stage.draw()
        assert abs(covered - share) < tolerance, (covered, share)
        assert share == 0.0 or abs(ink - tone) < 0.03, ink
    stage.renderer.GetActiveCamera().Roll(3.0)
    stage.draw()
    stage.renderer.GetActiveCamera().Roll(-3.0)
    assert abs(stage.draw()[0] - share) < tolerance


def test_a_good_square():
    check(Stage(mesh(SQUARE, TRIANGLES)), 1.0)
    check(Stage(mesh(SQUARE, [(0, 1, 2, 3)])), 1.0)


def test_empty():
    check(Stage(vtkPolyData()), 0.0)
    check(Stage(mesh([], [])), 0.0)
    check(Stage(mesh(SQUARE, [])), 0.0)


def test_single_triangle():
    check(Stage(mesh(SQUARE, TRIANGLES[:1])), 0.5)


def test_tiny_and_huge():
    small = mesh([tuple(1e-6 * c for c in p) for p in SQUARE], TRIANGLES)
    large = mesh([tuple(1e6 * c for c in p) for p in SQUARE], TRIANGLES)
    for data, scale in ((small, 1e-6), (large, 1e6)):
        stage = Stage(data)
        camera = scene.look(stage.renderer, (0.0, 0.0, 3.0 * scale))
        camera.SetParallelScale(scale)
        camera.SetClippingRange(scale, 10.0 * scale)
        check(stage, 1.0)


def test_degenerate_and_duplicate_cells():
    cells = TRIANGLES + [(0, 0, 1), (2, 2, 2), (0, 1, 0), TRIANGLES[0], TRIANGLES[1], (0, 1)]
    check(Stage(mesh(SQUARE, cells)), 1.0)
    line = mesh([(-1, 0, 0), (0, 0, 0), (1, 0, 0)], [(0, 1, 2)])
    check(Stage(line), 0.0)
    check(Stage(mesh([(0, 0, 0)] * 3, [(0, 1, 2)])), 0.0)


def test_non_manifold():
    # Three sheets at one edge, seen from the side of two of them.
    points = SQUARE + [(-1, 0, 0), (1, 0, 0), (-1, 0, 1), (1, 0, 1)]
    check(Stage(mesh(points, TRIANGLES + [(4, 5, 7), (4, 7, 6), (4, 5, 2)])), 1.0)


def stock_share(data):
    """How much of the picture VTK's own mapper covers."""
    stage = Stage(data)
    mapper = vtkPolyDataMapper()
    mapper.SetInputDataObject(data)
    stage.actor.SetMapper(mapper)
    return stage.draw()[0]


def test_coordinates_that_are_no_numbers():
    for bad in (float("nan"), float("inf"), -float("inf")):
        points = SQUARE + [(bad, 0, 0), (0, bad, bad)]
        for cells in (TRIANGLES, TRIANGLES + [(0, 1, 4), (1, 2, 5)]):
            data = mesh(points, cells)
            share = stock_share(data)
            assert share == (1.0 if bad != bad else 0.0), "VTK draws other things now"
            check(Stage(data), share)
            scene.expect_messages("2 input point(s) have a coordinate that is not finite")
    check(Stage(mesh([(float("nan"),) * 3] * 3, [(0, 1, 2)])), 0.0)


def test_topology_changes_between_frames():
    stage = Stage(mesh(SQUARE, TRIANGLES))
    check(stage, 1.0)
    producer = vtkTrivialProducer()
    stage.mapper.SetInputConnection(producer.GetOutputPort())
    for i in range(6):
        if i % 3 == 0:
            data, share = mesh(SQUARE, TRIANGLES), 1.0
        elif i % 3 == 1:
            data, share = mesh(SQUARE, TRIANGLES[:1]), 0.5
        else:
            data, share = vtkPolyData(), 0.0
        producer.SetOutput(data)
        check(stage, share)


def test_mesh_edited_in_place():
    data = mesh(SQUARE, TRIANGLES)
    stage = Stage(data)
    check(stage, 1.0)
    before = scene.drawn_frame(stage.mapper, stage.renderer)
    for i in range(4):
        data.GetPoints().SetPoint(i, *(0.5 * c for c in SQUARE[i]))
    data.GetPoints().Modified()
    data.Modified()
    check(stage, 0.25)
    after = scene.drawn_frame(stage.mapper, stage.renderer)
    assert abs(scene.frame_scale(after) / scene.frame_scale(before) - 0.5) < 0.01, (before, after)
    data.GetPolys().Reset()
    data.GetPolys().InsertNextCell(3, TRIANGLES[0])
    data.Modified()
    check(stage, 0.125)


def test_resized_windows():
    stage = Stage(mesh(SQUARE, TRIANGLES))
    for size in ((200, 200), (400, 300), (1, 1), (7, 300), (200, 200)):
        stage.window.SetSize(*size)
        covered, ink = stage.draw()
        assert scene.picture(stage.window).shape[:2] == size[::-1]
        assert abs(covered - min(1.0, size[1] / size[0])) < 0.02, (size, covered)
        assert min(size) < 100 or abs(ink - TONE) < 0.03, (size, ink)


def test_viewport_without_size():
    stage = Stage(mesh(SQUARE, TRIANGLES))
    for viewport in ((0.5, 0.5, 0.5, 0.5), (0.5, 0.0, 0.5, 1.0), (0.0, 0.0, 1.0, 1.0)):
        stage.renderer.SetViewport(*viewport)
        stage.window.Render()
    assert abs(stage.draw()[0] - 1.0) < 0.02


def test_without_input():
    """VTK's renderer skips what has no bounds; whoever draws the mapper all the same is told once."""
    stage = Stage()
    assert stage.draw()[0] == 0.0
    scene.expect_messages()
    for _ in range(2):
        stage.mapper.Render(stage.renderer, stage.actor)
    scene.expect_messages("input: none is connected; expected polydata or a composite of polydata")
    stage.mapper.SetInputDataObject(mesh(SQUARE, TRIANGLES))
    check(stage, 1.0)


def test_without_style():
    stage = Stage(mesh(SQUARE, TRIANGLES))
    style = stage.style
    check(stage, 1.0)
    stage.mapper.SetStyle(None)
    assert (scene.draw(stage.window) == 255).all(), "VTK's own white surface"
    stage.mapper.SetStyle(style)
    check(stage, 1.0)
    stage.mapper.SetStyle(hachure.vtkPatternStyle())
    assert (scene.draw(stage.window) == 255).all(), "bare paper"


def test_layer_that_cannot_be_drawn():
    stage = Stage(mesh(SQUARE, TRIANGLES))
    stage.style.GetLayer(0).SetPattern(hachure.vtkImagePatternLayer.IMAGE)
    assert (scene.draw(stage.window) == 255).all(), "bare paper"
    stage.window.Render()
    assert len(scene.messages) == 1 and "image" in scene.messages[0].lower(), scene.messages
    scene.messages.clear()
    stage.style.GetLayer(0).SetPattern(hachure.vtkImagePatternLayer.HATCH)
    check(stage, 1.0)


def test_actor_removed_and_back():
    stage = Stage(mesh(SQUARE, TRIANGLES))
    check(stage, 1.0)
    stage.renderer.RemoveActor(stage.actor)
    assert stage.draw()[0] == 0.0
    stage.renderer.AddActor(stage.actor)
    check(stage, 1.0)
    stage.actor.VisibilityOff()
    assert stage.draw()[0] == 0.0
    stage.actor.VisibilityOn()
    check(stage, 1.0)
    stage.renderer.RemoveActor(stage.actor)
    stage.actor = None
    assert measure(scene.draw(stage.window))[0] == 0.0


def test_mapper_of_two_actors():
    stage = Stage(mesh([(0.4 * x, 0.4 * y, z) for x, y, z in SQUARE], TRIANGLES))
    stage.actor.SetPosition(-0.5, 0.0, 0.0)
    second = vtkActor()
    second.SetMapper(stage.mapper)
    second.SetProperty(stage.actor.GetProperty())
    second.SetPosition(0.5, 0.0, 0.0)
    stage.renderer.AddActor(second)
    check(stage, 0.32)
    # Each moves its pattern with itself: half a period would show.
    stage.draw()
    halves = scene.picture(stage.window)
    stage.actor.AddPosition(0.0, 0.25, 0.0)  # 16 pixels
    check(stage, 0.32)
    after = scene.picture(stage.window)
    assert (after[:, SIZE // 2:] == halves[:, SIZE // 2:]).all(), "the one that stays moved"
    left, moved = halves[:-16, :SIZE // 2], after[16:, :SIZE // 2]
    assert (abs(left.astype(int) - moved) <= 8).mean() > 0.99, "the one that moved left its pattern"


def test_actors_of_two_renderers():
    stage = Stage(mesh(SQUARE, TRIANGLES))
    other = scene.renderer_of(stage.actor, background=(1.0, 0.0, 0.0))
    other.SetActiveCamera(stage.renderer.GetActiveCamera())
    stage.renderer.SetViewport(0.0, 0.0, 0.5, 1.0)
    other.SetViewport(0.5, 0.0, 1.0, 1.0)
    stage.window.AddRenderer(other)
    stage.window.SetSize(2 * SIZE, SIZE)
    check(stage, 1.0)
    stage.window.RemoveRenderer(stage.renderer)
    stage.window.Render()
    stage.window.RemoveRenderer(other)
    stage.window.AddRenderer(stage.renderer)
    stage.renderer.SetViewport(0.0, 0.0, 1.0, 1.0)
    check(stage, 0.5)  # the window is twice as wide as high


def test_window_finalised_and_used_again():
    stage = Stage(mesh(SQUARE, TRIANGLES))
    check(stage, 1.0)
    before = scene.drawn_frame(stage.mapper, stage.renderer)
    stage.window.Finalize()
    check(stage, 1.0)
    stage.mapper.ReleaseGraphicsResources(stage.window)
    check(stage, 1.0)
    assert abs(scene.drawn_frame(stage.mapper, stage.renderer) - before).max() < 1e-6


def test_renderer_in_another_window():
    stage = Stage(mesh(SQUARE, TRIANGLES))
    check(stage, 1.0)
    stage.window.RemoveRenderer(stage.renderer)
    other = scene.window_of(stage.renderer, size=(SIZE, SIZE))
    stage.window = other
    check(stage, 1.0)


def test_objects_deleted_in_any_order():
    for order in (("window", "renderer", "actor"), ("actor", "renderer", "window"),
                  ("renderer", "actor", "window")):
        stage = Stage(mesh(SQUARE, TRIANGLES))
        stage.draw()
        for name in order:
            delattr(stage, name)


def test_camera_behind_and_inside():
    data = scene.sphere(16, 1.0)
    stage = Stage(data)
    stage.renderer.GetActiveCamera().ParallelProjectionOff()
    for position, target in (((0, 0, 0.1), (0, 0, 0)), ((0, 0, 3), (0, 0, 6)), ((0, 0, 1.0), (0, 0, 0)),
                             ((0, 0, 3), (0, 0, 0))):
        scene.look(stage.renderer, position, target)
        covered, ink = stage.draw()
        assert ink is None or numpy.isfinite(ink)
    assert covered > 0.3 and abs(ink - TONE) < 0.05, (covered, ink)


scene.run(globals())
