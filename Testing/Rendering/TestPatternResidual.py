# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""How far a pattern slides over a turning sphere: the mapper's number against one by hand."""

import math

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkRenderingCore import vtkCamera

SIZE = 320
RADIUS = 0.65
DISTANCE = 3.2
TURN = 1.2  # degrees per frame
LIMIT = 0.3


def camera_at(degrees):
    angle = math.radians(degrees)
    camera = vtkCamera()
    camera.SetPosition(DISTANCE * math.sin(angle), 0.0, DISTANCE * math.cos(angle))
    camera.SetClippingRange(0.3, 12.0)
    return camera


def residuals(mapper, renderer, limit):
    table = vtkTable()
    assert mapper.GetPatchResiduals(renderer, limit, table)
    return [vtk_to_numpy(table.GetColumnByName(name)) for name in ("PatchId", "Residual", "Weight")]


def turning_sphere():
    """The mapper, the renderer and the sphere after one step."""
    ball = scene.sphere(96, RADIUS)
    actor = scene.actor_of(ball, scene.constant_style(0, 12, 0.5))
    renderer = scene.renderer_of(actor)
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    mapper, table = actor.GetMapper(), vtkTable()
    assert not mapper.GetPatchResiduals(renderer, LIMIT, table) and not table.GetNumberOfRows()
    for degrees in (0.0, TURN):
        renderer.GetActiveCamera().DeepCopy(camera_at(degrees))
        window.Render()
    return mapper, renderer, ball, window


def seen_by(camera, points, normals):
    """Positions in the picture, areas up to a factor, and n.v."""
    matrix = camera.GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0)
    rows = numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    clip = numpy.c_[points, numpy.ones(len(points))] @ rows.T
    to_eye = numpy.array(camera.GetPosition()) - points
    away = numpy.linalg.norm(to_eye, axis=1)
    facing = (to_eye * normals).sum(axis=1) / away
    # A disc is seen under a solid angle, and the picture is wider away from its middle.
    area = facing / away**2 * (away / clip[:, 3])**3
    return (clip[:, :2] / clip[:, 3:] + 1.0) * SIZE / 2, area, facing


def by_hand(ball, limit):
    """The slide by the transform of vtkSimilarityTracker, over its own samples."""
    sampler = hachure.vtkStratifiedSurfaceSampler()
    sampler.SetInputConnection(ball.GetOutputPort())
    tracker = hachure.vtkSimilarityTracker()
    tracker.SetInputConnection(sampler.GetOutputPort())
    tracker.SetViewportSize(SIZE, SIZE)
    cameras = camera_at(0.0), camera_at(TURN)
    tracker.SetCameraBefore(cameras[0])
    tracker.SetCameraAfter(cameras[1])
    tracker.Update()
    row = tracker.GetOutput()
    z = complex(*(row.GetValueByName(0, name).ToDouble() for name in ("ZReal", "ZImaginary")))
    data = sampler.GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    normals = vtk_to_numpy(data.GetPointData().GetNormals()).astype(float)
    (p, areas, _), (c, after, facing) = (seen_by(camera, points, normals) for camera in cameras)
    weight = numpy.sqrt(numpy.maximum(areas, 0) * numpy.maximum(after, 0))
    p, c = p @ [1, 1j], c @ [1, 1j]
    p, c = (q - (weight * q).sum() / weight.sum() for q in (p, c))
    counted = weight * (facing >= limit)
    return float((counted * abs(z * p - c)).sum() / counted.sum())


def test_residual_over_the_facing_part():
    mapper, renderer, ball, _ = turning_sphere()
    patches, whole, _ = residuals(mapper, renderer, -1.0)
    assert list(patches) == [0]
    assert abs(whole[0] - mapper.GetResidual(renderer)) < 1e-9
    _, front, weight = residuals(mapper, renderer, LIMIT)
    print("all", whole[0], by_hand(ball, -1.0), "facing", front[0], by_hand(ball, LIMIT))
    # The mapper also knows which samples the picture shows, and how much of those at the rim.
    assert abs(whole[0] - by_hand(ball, -1.0)) < 0.01 * whole[0]
    assert abs(front[0] - by_hand(ball, LIMIT)) < 0.01 * front[0]
    assert 0.52 < front[0] < 0.57 < 0.59 < whole[0] < 0.64, (front, whole)
    # The disc of the sphere without its steep rim; samples stand for discs in squares.
    disc = math.pi * (SIZE * RADIUS / math.sqrt(DISTANCE**2 - RADIUS**2) / 2
                      / math.tan(math.radians(15)))**2
    assert 0.85 * disc < weight[0] * 4 / math.pi < 0.97 * disc, (weight, disc)


def test_wrong_limit_and_other_modes():
    mapper, renderer, _, window = turning_sphere()
    table = vtkTable()
    assert not mapper.GetPatchResiduals(renderer, 2.0, table)
    scene.expect_messages("minimumFacing is 2.0")
    mapper.GetStyle().SetTrackingMode(mapper.GetStyle().ANCHORED)
    window.Render()
    assert not mapper.GetPatchResiduals(renderer, LIMIT, table)
    assert table.GetNumberOfColumns() == 0


scene.run(globals())
