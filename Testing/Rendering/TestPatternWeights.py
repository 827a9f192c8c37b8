# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Weights by what stands out hold a pattern on the hills of a landscape."""

import numpy
import pattern_scene as scene
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkLight

WIDTH, HEIGHT = 240, 160
FRAMES = 15
HILLS = ((-14.0, 70.0, 6.0), (3.0, 78.0, 8.0), (17.0, 72.0, 5.0))
NAME = "interest"


def height(x, y):
    return sum(top * numpy.exp(-((x - a)**2 + (y - b)**2) / 18.0) for a, b, top in HILLS)


def landscape():
    """A plain of 80 x 90 units with three hills at its far end."""
    source = vtkPlaneSource()
    source.SetOrigin(-40, -5, 0)
    source.SetPoint1(40, -5, 0)
    source.SetPoint2(-40, 85, 0)
    source.SetResolution(80, 90)
    source.Update()
    data = source.GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    points[:, 2] = height(points[:, 0], points[:, 1])
    moved = vtkPoints()
    moved.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(moved)
    scene.add_array(data.GetPointData(), NAME, (points[:, 2] > 0.5).astype(float))
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput(), points


def walk(renderer, step):
    camera = renderer.GetActiveCamera()
    way = 1.0 * step
    camera.SetPosition(0.15 * way, way, 1.8)
    camera.SetFocalPoint(0.15 * way, way + 1.0, 1.78)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(45.0)
    camera.SetClippingRange(0.1, 200.0)


def projected(points, renderer):
    matrix = renderer.GetActiveCamera().GetCompositeProjectionTransformMatrix(
        WIDTH / HEIGHT, -1.0, 1.0)
    values = numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    clip = numpy.c_[points, numpy.ones(len(points))] @ values.T
    return (clip[:, :2] / clip[:, 3:] + 1.0) * [WIDTH / 2, HEIGHT / 2] @ [1, 1j]


def slide_on_hills(scheme, source=0, name=""):
    """Mean slide of the pattern over the hills in pixels per frame."""
    style = scene.constant_style(0, 10, 0.5)
    style.SetWeightScheme(scheme)
    style.SetFeatureSource(source)
    style.SetFeatureArrayName(name)
    style.SetSamplesPerPatch(1500)
    data, points = landscape()
    actor = scene.actor_of(data, style)
    renderer = scene.renderer_of(actor)
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(1.0, -0.3, 1.0)
    sun.SetFocalPoint(0.0, 0.0, 0.0)
    renderer.AddLight(sun)
    window = scene.window_of(renderer, size=(WIDTH, HEIGHT))
    # The sides of the hills that the walker sees.
    seen = (points[:, 2] > 1.0) & numpy.array(
        [any(abs(x - a) < 4 and b - 4 < y < b for a, b, _ in HILLS) for x, y, _ in points])
    assert seen.sum() > 20
    slides = []
    for step in range(FRAMES + 1):
        if step:
            before, old = projected(points[seen], renderer), frame
        walk(renderer, step)
        window.Render()
        frame = scene.drawn_frame(actor.GetMapper(), renderer)
        if step:
            z = complex(*frame[2:4]) / complex(*old[2:4])
            carried = complex(*frame[:2]) + z * (before - complex(*old[:2]))
            slides.append(abs(carried - projected(points[seen], renderer)).mean())
    return float(numpy.mean(slides))


def test_perceptual_weights_slide_least_on_hills():
    style = scene.constant_style(0, 10, 0.5)
    paper = slide_on_hills(style.CLASSIC)
    symmetric = slide_on_hills(style.SYMMETRIC)
    unweighted = slide_on_hills(style.UNWEIGHTED)
    print("paper %.3f, symmetric %.3f, unweighted %.3f" % (paper, symmetric, unweighted))
    for source in ("CURVATURE", "TONE", "ARRAY"):
        found = slide_on_hills(style.PERCEPTUAL, getattr(style, source), NAME)
        print("perceptual, %s: %.3f" % (source.lower(), found))
        assert found < 0.4 * paper and found < 0.4 * symmetric, (source, found, paper)


def test_wrong_arrays():
    def render(name, values):
        style = scene.constant_style(0, 10, 0.5)
        style.SetWeightScheme(style.PERCEPTUAL)
        style.SetFeatureSource(style.ARRAY)
        style.SetFeatureArrayName(name)
        ball = scene.sphere(12)
        if values is not None:
            scene.add_array(ball.GetOutput().GetCellData(), name,
                            values(ball.GetOutput().GetNumberOfCells()))
        actor = scene.actor_of(ball.GetOutput(), style)
        renderer = scene.renderer_of(actor)
        window = scene.window_of(renderer, size=(64, 64))
        scene.look(renderer)
        for _ in range(3):
            renderer.GetActiveCamera().Azimuth(3.0)
            window.Render()
        return scene.drawn_frame(actor.GetMapper(), renderer)

    fallback = render("absent", None)
    scene.expect_messages("features: no array 'absent', expected 1 component for every point or cell")
    render("pair", lambda count: numpy.ones((count, 2)))
    scene.expect_messages("features: array 'pair' has 2 components, expected 1")
    render("negative", lambda count: -numpy.ones(count))
    scene.expect_messages("features: array 'negative': featureFactors: strengths[0] is -1.0")
    even = render("even", lambda count: numpy.full(count, 7e-9))
    assert abs(even - fallback).max() < 1e-9, "without array weights are symmetric"


scene.run(globals())
