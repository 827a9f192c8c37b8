# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""View-dependent textures: a view is seen as it was made from its own camera, dependent ones only from
near it, and each at its level of detail."""

import os
import tempfile

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkCamera

VIEWS = hachure.vtkTextureViews
LAYER = hachure.vtkViewTextureLayer
GREY = 188  # sRGB of half of the light: see test_what_nobody_knows_is_grey
SIZE = (256, 256)


def image(pixels):
    """Of rows from the bottom up, 8 bits."""
    height, width, components = pixels.shape
    result = vtkImageData()
    result.SetDimensions(width, height, 1)
    result.GetPointData().SetScalars(
        numpy_to_vtk(pixels.reshape(-1, components).astype(numpy.uint8), deep=True))
    return result


def even(color, size=64):
    return image(numpy.tile(numpy.array(color, dtype=numpy.uint8), (size, size, 1)))


def waves(size=256, period=32.0):
    """A smooth picture of three colours that are told apart everywhere."""
    y, x = numpy.mgrid[0:size, 0:size] * (2.0 * numpy.pi / period)
    return numpy.stack([127.5 + 120.0 * numpy.sin(x + 0.5 * y), 127.5 + 120.0 * numpy.cos(y),
                        127.5 + 120.0 * numpy.sin(x - y)], axis=2)


def camera_at(position, focal_point=(0.0, 0.0, 0.0)):
    camera = vtkCamera()
    camera.SetPosition(*position)
    camera.SetFocalPoint(*focal_point)
    camera.SetViewUp(0.0, 1.0, 0.0)
    return camera


def view_layer(finest=4, **parameters):
    layer = LAYER()
    layer.GetViews().SetFinestLevel(finest)
    for name, value in parameters.items():
        getattr(layer, "Set" + name)(value)
    return layer


def add_view(layer, position, picture, dependent=False, extreme=None):
    """extreme: angle in degrees of four extreme points around the camera."""
    views = layer.GetViews()
    index = views.AddView("view", camera_at(position), picture)
    assert index >= 0
    if dependent:
        views.SetViewKind(index, VIEWS.DEPENDENT)
    for turn in (("Azimuth", 1), ("Azimuth", -1), ("Elevation", 1), ("Elevation", -1)):
        if extreme is not None:
            camera = camera_at(position)
            getattr(camera, turn[0])(turn[1] * extreme)
            views.AddExtremePoint(index, camera.GetPosition())
    return index


def stage(data, layer, position=(0.0, 0.0, 3.0), size=SIZE):
    style = hachure.vtkPatternStyle()
    style.AddLayer(layer)
    actor = scene.actor_of(data, style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=size)
    scene.look(renderer, position)
    return actor, renderer, window


def color_at(window, x=0.5, y=0.5):
    picture = scene.draw(window)
    return tuple(int(c) for c in picture[int(y * picture.shape[0]), int(x * picture.shape[1])])


def near(found, expected, tolerance=4):
    assert numpy.abs(numpy.array(found) - expected).max() <= tolerance, (found, expected)


def test_what_nobody_knows_is_grey():
    found = color_at(stage(scene.sphere(), view_layer())[2])
    near(found, (128, 128, 128))
    below = view_layer(Base=LAYER.BELOW)
    assert color_at(stage(scene.sphere(), below)[2]) == (255, 255, 255), "the paper is seen"


def test_a_view_seen_from_its_own_camera_is_reproduced():
    for dependent in (False, True):
        layer = view_layer(finest=5)
        picture = waves()
        add_view(layer, (0.0, 0.0, 3.0), image(picture), dependent, 60.0 if dependent else None)
        found = scene.draw(stage(scene.plane(3.0), layer)[2]).astype(float)
        inside = numpy.zeros(SIZE, dtype=bool)
        inside[40:-40, 40:-40] = True
        error = (found - picture)[inside]
        decibels = 10.0 * numpy.log10(255.0 ** 2 / numpy.mean(error ** 2))
        print("dependent" if dependent else "independent", "PSNR", decibels)
        assert decibels >= 30.0, decibels


def test_no_seams_between_charts():
    """Directions are kept in frames of two families; a triangle may lie on charts of both."""
    layer = view_layer(finest=5, Base=LAYER.BELOW)
    add_view(layer, (3.0, 0.5, 0.5), even((200, 30, 30), 256), True, 60.0)
    window = stage(scene.sphere(120), layer, (3.0, 0.5, 0.5))[2]
    picture = scene.draw(window)[84:-84, 84:-84].astype(int)
    away = numpy.abs(picture - (200, 30, 30)).max()
    print("away from the colour of the view", away)
    assert away <= 8, away


def test_a_dependent_view_is_seen_from_near_its_camera_only():
    layer = view_layer(finest=3, Base=LAYER.BELOW)
    add_view(layer, (0.0, 0.0, 3.0), even((200, 30, 30)), True, 40.0)
    actor, renderer, window = stage(scene.plane(1.0), layer)
    shares = []
    for angle in range(0, 70, 5):
        turn = numpy.radians(angle)
        scene.look(renderer, (3.0 * numpy.sin(turn), 0.0, 3.0 * numpy.cos(turn)))
        shares.append(color_at(window)[1])
    near(shares[0], 30, 6)
    assert shares[9] > 230 and shares[-1] == 255, shares
    assert all(b >= a - 3 for a, b in zip(shares, shares[1:])), shares


def test_its_own_camera_sees_a_dependent_view_everywhere():
    """Also where charts that face up and down meet, whose directions are stored in other frames."""
    layer = view_layer(finest=3)
    add_view(layer, (0.0, 0.0, 3.0), even((250, 10, 10), 200), True, 60.0)
    for side in (3.0, -3.0):
        add_view(layer, (0.0, 0.0, side), even((10, 10, 250), 200))
    actor, renderer, window = stage(scene.sphere(40, 1.0), layer, (0.0, 0.0, 5.0))
    pixels = scene.draw(window).astype(int)
    y, x = numpy.mgrid[0:SIZE[1], 0:SIZE[0]] - (SIZE[0] - 1) / 2
    inside = numpy.hypot(x, y) < 85  # of a radius of 97
    print("blue at most", pixels[inside, 2].max())
    assert pixels[inside, 0].min() > 235 and pixels[inside, 2].max() < 90


def test_a_view_from_afar_replaces_the_near_one():
    layer = view_layer(finest=5)
    add_view(layer, (0.0, 0.0, 3.0), even((200, 30, 30), 128))
    add_view(layer, (0.0, 0.0, 48.0), even((30, 30, 200), 128))
    actor, renderer, window = stage(scene.plane(1.0), layer, size=(128, 128))
    near(color_at(window), (200, 30, 30))
    scene.look(renderer, (0.0, 0.0, 48.0))
    near(color_at(window), (30, 30, 200))
    reds = []
    for i in range(41):
        scene.look(renderer, (0.0, 0.0, 3.0 * 16.0 ** (i / 40.0)))
        reds.append(color_at(window)[0])
    assert max(abs(b - a) for a, b in zip(reds, reds[1:])) < 60, reds


def test_colours_go_with_the_surface():
    """A turned actor seen by a turned camera gives the same picture."""
    layer = view_layer()
    add_view(layer, (0.0, 0.0, 3.0), image(waves(128)), True, 60.0)
    actor, renderer, window = stage(scene.sphere(), layer)
    straight = scene.draw(window)
    actor.RotateY(90.0)
    camera = scene.look(renderer, (3.0, 0.0, 0.0))
    assert camera is not None
    assert numpy.abs(scene.draw(window).astype(int) - straight).max() <= 3


def test_the_picture_does_not_depend_on_frames_before_or_on_tiles():
    layer = view_layer()
    add_view(layer, (0.0, 0.0, 3.0), image(waves(128)), True, 60.0)
    add_view(layer, (0.0, 3.0, 0.5), image(waves(128, 20.0)))
    actor, renderer, window = stage(scene.sphere(), layer)
    first = scene.draw(window)
    scene.look(renderer, (1.0, 1.0, 2.0))
    other = scene.draw(window)
    assert (first != other).any()
    scene.look(renderer, (0.0, 0.0, 3.0))
    assert (scene.draw(window) == first).all()
    fresh = stage(scene.sphere(), layer, (1.0, 1.0, 2.0))[2]
    assert (scene.draw(fresh) == other).all()


def test_changes_of_views_are_seen():
    layer = view_layer(finest=2)
    index = add_view(layer, (0.0, 0.0, 3.0), even((10, 200, 10)))
    actor, renderer, window = stage(scene.plane(), layer)
    near(color_at(window), (10, 200, 10))
    layer.GetViews().SetViewImage(index, even((200, 10, 200)))
    near(color_at(window), (200, 10, 200))
    layer.GetViews().SetViewKind(index, VIEWS.DEPENDENT)
    layer.SetDisplay(LAYER.INDEPENDENT_ONLY)
    near(color_at(window), (128, 128, 128))
    layer.SetDisplay(LAYER.COMBINED)
    near(color_at(window), (200, 10, 200))
    layer.GetViews().RemoveView(index)
    near(color_at(window), (128, 128, 128))


def test_blend_points_show_the_base():
    layer = view_layer(finest=2)
    add_view(layer, (0.0, 0.0, 3.0), even((250, 0, 0)), True)
    add_view(layer, (0.0, 0.0, 3.0), even((0, 0, 250)))
    actor, renderer, window = stage(scene.plane(), layer)
    near(color_at(window), (250, 0, 0))
    layer.GetViews().AddBlendPoint((0.0, 0.0, 3.0), (0.0, 0.0, -1.0), 100.0)
    near(color_at(window), (0, 0, 250))


def test_tone_and_opacity_hold_it_back():
    layer = view_layer(finest=1)
    add_view(layer, (0.0, 0.0, 3.0), even((0, 0, 0)))
    actor, renderer, window = stage(scene.plane(), layer)
    near(color_at(window), (0, 0, 0))
    layer.GetTone().SetConstant(0.5)
    near(color_at(window), (GREY, GREY, GREY))
    layer.SetOpacity(0.0)
    near(color_at(window), (255, 255, 255))


def test_the_surface_may_be_the_base():
    layer = view_layer(Base=LAYER.BELOW)
    add_view(layer, (0.0, 0.0, 3.0), even((0, 0, 0, 0)), True)
    actor, renderer, window = stage(scene.plane(), layer)
    actor.GetMapper().GetStyle().SetPaperSource(hachure.vtkPatternStyle.SURFACE)
    actor.GetProperty().SetColor(0.2, 0.4, 0.6)
    near(color_at(window), (51, 102, 153))


def test_translucent_surfaces_have_the_same_colours():
    layer = view_layer(finest=3)
    add_view(layer, (0.0, 0.0, 3.0), image(waves(128)))
    actor, renderer, window = stage(scene.plane(), layer)
    opaque = scene.draw(window)
    actor.ForceTranslucentOn()
    assert numpy.abs(scene.draw(window).astype(int) - opaque).max() <= 2


def test_a_deformed_surface_keeps_its_marks():
    """They turn with the surface: what the camera sees of a turned plane is what it saw before."""
    layer = view_layer(finest=3, Base=LAYER.BELOW)
    add_view(layer, (0.0, 0.0, 3.0), even((200, 30, 30)), True, 30.0)
    source = scene.plane(1.0)
    data = vtkPolyData()
    data.DeepCopy(source.GetOutput())
    actor, renderer, window = stage(data, layer)
    near(color_at(window), (200, 30, 30), 8)
    points = data.GetPoints()
    places = [points.GetPoint(i) for i in range(points.GetNumberOfPoints())]
    data.GetPointData().SetNormals(None)
    for i, (x, y, _) in enumerate(places):  # turned to face +x
        points.SetPoint(i, 0.0, y, -x)
    points.Modified()
    data.Modified()
    scene.look(renderer, (3.0, 0.0, 0.0))
    near(color_at(window), (200, 30, 30), 8)
    scene.look(renderer, (2.0, 0.0, 3.0))
    assert color_at(window)[1] > 200


def test_odd_surfaces():
    layer = view_layer()
    add_view(layer, (0.0, 0.0, 3.0), even((30, 200, 30)))
    for data in (vtkPolyData(), vtkMultiBlockDataSet()):
        assert color_at(stage(data, layer)[2]) == (255, 255, 255)
    cube = vtkCubeSource()
    cube.Update()
    near(color_at(stage(cube, layer)[2]), (30, 200, 30), 8)
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, scene.sphere(12, 0.3, (-0.4, 0.0, 0.0)).GetOutput())
    blocks.SetBlock(1, None)
    blocks.SetBlock(2, vtkPolyData())
    blocks.SetBlock(3, scene.sphere(12, 0.3, (0.4, 0.0, 0.0)).GetOutput())
    window = stage(blocks, layer)[2]
    near(color_at(window, 0.3), (30, 200, 30), 8)
    near(color_at(window, 0.7), (30, 200, 30), 8)


def test_other_cells_are_another_surface():
    layer = view_layer()
    add_view(layer, (0.0, 0.0, 3.0), even((30, 200, 30)))
    source = scene.sphere(12)
    actor, renderer, window = stage(source, layer)
    scene.draw(window)
    for resolution in (40, 6):
        source.SetThetaResolution(resolution)
        near(color_at(window), (30, 200, 30), 8)


def test_one_level_for_all():
    layer = view_layer(finest=5, Level=LAYER.ONE)
    add_view(layer, (0.0, 0.0, 3.0), image(waves()))
    assert (scene.draw(stage(scene.plane(3.0), layer)[2]) != 128).any()


def test_a_small_budget_leaves_out_levels():
    layer = view_layer(finest=5, MemoryBudget=2)
    add_view(layer, (0.0, 0.0, 3.0), even((30, 200, 30)))
    near(color_at(stage(scene.plane(), layer)[2]), (30, 200, 30), 8)
    scene.expect_messages("more than the memory budget of 2 MiB; the finest level is")


def test_style_files_hold_the_manifest():
    folder = tempfile.mkdtemp()
    layer = view_layer(finest=2, Base=LAYER.BELOW, Display=LAYER.COVERAGE, MemoryBudget=64)
    style = hachure.vtkPatternStyle()
    style.AddLayer(layer)
    add_view(layer, (0.0, 0.0, 3.0), even((30, 200, 30)), True, 30.0)
    assert not style.SaveFile(os.path.join(folder, "style.json"))
    scene.expect_messages("layers[0].field.manifest: the views have no manifest")
    manifest = hachure.vtkTextureViewsManifest()
    name = os.path.join(folder, "views.json")
    assert manifest.Write(name, layer.GetViews())
    layer.SetManifestFileName(name)
    assert style.SaveFile(os.path.join(folder, "style.json"))
    again = hachure.vtkPatternStyle()
    assert again.LoadFile(os.path.join(folder, "style.json"))
    copy = again.GetLayer(0)
    assert copy.GetViews().GetNumberOfViews() == 1
    assert copy.GetViews().GetNumberOfExtremePoints(0) == 4
    assert (copy.GetBase(), copy.GetDisplay(), copy.GetMemoryBudget()) == (
        LAYER.BELOW, LAYER.COVERAGE, 64)


def test_wrong_input():
    layer = view_layer()
    layer.SetViews(None)
    scene.expect_messages("the views are null")
    add_view(layer, (0.0, 0.0, 3.0), even((30, 200, 30)))
    kept = layer.GetViews()
    assert not layer.ReadManifest("/nowhere/views.json")
    scene.expect_messages("/nowhere/views.json")
    assert layer.GetViews() is kept and kept.GetNumberOfViews() == 1
    matrix = vtkMatrix4x4()
    matrix.Zero()
    assert kept.AddView("flat", matrix, even((0, 0, 0))) == -1
    scene.expect_messages("matrix")
    near(color_at(stage(scene.plane(), layer)[2]), (30, 200, 30), 8)


def test_a_view_that_cannot_be_drawn_is_named_and_nothing_is_lost():
    layer = view_layer(finest=2)
    add_view(layer, (0.0, 0.0, 3.0), even((30, 200, 30)))
    window = stage(scene.plane(), layer)[2]
    before = scene.draw(window)
    too_wide = add_view(layer, (0.0, 0.0, 3.0), image(numpy.zeros((1, 16400, 3))))
    scene.draw(window)
    scene.expect_messages("layer 0: views[1].width is 16400; expected 1 to 16384 pixels")
    assert (scene.draw(window) == 255).all(), "the same picture, told of once"
    layer.GetViews().RemoveView(too_wide)
    assert (scene.draw(window) == before).all()


scene.run(globals())
