# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkViewDependentTexture tells the colours that vtkViewTextureLayer draws."""

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkCamera

VIEWS = hachure.vtkTextureViews
SIZE = 512  # of the picture
FACING = 0.35  # least cosine; closer to the outline pixels see other places


def image(pixels):
    height, width, components = pixels.shape
    result = vtkImageData()
    result.SetDimensions(width, height, 1)
    result.GetPointData().SetScalars(
        numpy_to_vtk(pixels.reshape(-1, components).astype(numpy.uint8), deep=True))
    return result


def waves(phase, size, period):
    """A smooth picture: what is next to a point differs little from it."""
    y, x = numpy.mgrid[0:size, 0:size] * (2.0 * numpy.pi / period)
    return image(numpy.stack([127.5 + 100.0 * numpy.sin(x + phase), 127.5 + 100.0 * numpy.cos(y - phase),
                              127.5 + 100.0 * numpy.sin(x - y + 2 * phase)], axis=2))


def camera_at(position, up=(0.0, 1.0, 0.0)):
    camera = vtkCamera()
    camera.SetPosition(*position)
    camera.SetViewUp(*up)
    return camera


def views_around(kind=VIEWS.OCTAHEDRAL, hemisphere=8):
    """From six sides fine and coarse pictures for all cameras and one for those nearby, all different."""
    views = VIEWS()
    views.SetFinestLevel(4)
    views.SetHemisphere(hemisphere)
    views.SetHemisphereMap(kind)
    places = [sign * numpy.eye(3)[axis] for axis in range(3) for sign in (1, -1)]
    for number, place in enumerate(places):
        up = (0.0, 0.0, 1.0) if place[1] else (0.0, 1.0, 0.0)
        for kind_of_view, size in enumerate((256, 128, 64)):
            picture = waves(number + 2 * kind_of_view, size, size)
            index = views.AddView("view", camera_at(3.0 * place, up), picture)
            dependent = int(size == 128)
            views.SetViewKind(index, dependent)
            for i in range(4 * dependent):
                side = numpy.roll(place, 1 + i // 2) * (1 if i % 2 else -1)
                views.AddExtremePoint(index, 2.0 * place + 2.2 * side)
    return views


def colors_of(data, views, camera):
    texture = hachure.vtkViewDependentTexture()
    texture.SetInputData(data)
    texture.SetViews(views)
    texture.SetCamera(camera)
    texture.SetViewportSize(SIZE, SIZE)
    texture.Update()
    return vtk_to_numpy(texture.GetOutput(2).GetPointData().GetArray("Colors")).astype(float)


def drawn(data, views, position):
    layer = hachure.vtkViewTextureLayer()
    layer.SetViews(views)
    style = hachure.vtkPatternStyle()
    style.AddLayer(layer)
    actor = scene.actor_of(data, style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    return scene.draw(window), scene.look(renderer, position), window


def seen(data, camera, position):
    """Of the sphere's points: whether they are seen well, and where in the picture, in pixels."""
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    matrix = camera.GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0)
    values = numpy.array([[matrix.GetElement(i, k) for k in range(4)] for i in range(4)])
    clip = numpy.column_stack([points, numpy.ones(len(points))]) @ values.T
    arm = numpy.array(position) - points
    facing = (arm * points).sum(axis=1) / numpy.linalg.norm(arm, axis=1) / numpy.linalg.norm(points, axis=1)
    return facing > FACING, (0.5 * clip[:, :2] / clip[:, 3:] + 0.5) * SIZE - 0.5


def error_of(colors, picture, places, ring=0):
    """How far colours are outside of those of the four pixels around, or also of rings around these."""
    corner = numpy.floor(places).astype(int)
    steps = range(-ring, ring + 2)
    pixels = numpy.stack([picture[corner[:, 1] + dy, corner[:, 0] + dx] for dx in steps for dy in steps])
    least, most = pixels.min(axis=0).astype(float), pixels.max(axis=0).astype(float)
    return numpy.maximum(numpy.maximum(colors - most, least - colors), 0.0)


def check(views, position):
    data = scene.sphere(64).GetOutput()
    _, camera, window = drawn(data, views, position)
    picture = scene.draw(window)
    visible, places = seen(data, camera, position)
    found = colors_of(data, views, camera)
    colors = found[visible, :3]
    # On rims and corners of cells, where colours bend, some places are brighter than all pixels around; most of
    # all where charts that face up and down meet, as directions are resampled there.
    error = numpy.percentile(error_of(colors, picture, places[visible]), 99.5)
    largest = error_of(colors, picture, places[visible], 1).max()
    print("points", visible.sum(), "error", error, largest, "spread", colors.std())
    assert visible.sum() > 700 and (found[visible, 3] == 255).all()
    assert colors.std() > 25, "there is something to tell apart"
    assert error <= 3.0 and largest <= 12.0, (error, largest)
    return picture


def test_colours_are_those_of_the_picture():
    for position in ((0.0, 0.0, 3.0), (1.2, 1.0, 2.0), (-2.6, 0.3, -0.7), (0.0, -2.8, 1.2)):
        for distance in (1.0, 2.0):
            check(views_around(), distance * numpy.array(position))


def test_other_maps_of_directions():
    check(views_around(VIEWS.DISK, 4), (1.2, 1.0, 2.0))
    check(views_around(VIEWS.DISK, 16), (1.2, 1.0, 2.0))


def test_blend_points():
    views = views_around()
    views.AddBlendPoint((1.2, 1.0, 2.0), (-1.2, -1.0, -2.0), 50.0)
    picture = check(views, (1.2, 1.0, 2.0))
    assert (picture != check(views_around(), (1.2, 1.0, 2.0))).any()


scene.run(globals())
