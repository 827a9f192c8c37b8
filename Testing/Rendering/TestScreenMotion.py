# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Motion per pixel is that of the surface, to 0.01 px: planes and spheres, every kind of change."""

import motion_scene as motion
import numpy
import pattern_scene as scene
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkCamera

TOLERANCE = 0.01  # px


def motion_error(found, expected, mask):
    assert mask.sum() > 0.1 * mask.size, "hardly anything is seen"
    return float(numpy.hypot(found[0] - expected[..., 0], found[1] - expected[..., 1])[mask].max())


FINE = scene.sphere(512, motion.RADIUS).GetOutput()
SQUARE = scene.plane(2.0).GetOutput()
MOTIONS = ("translate", "rotate", "zoom", "roll")


def test_plane():
    for parallel in (False, True):
        for kind in MOTIONS:
            before = motion.camera_at(parallel=parallel)
            after = motion.moved(before, kind)
            found = motion.compute(before, after, [(SQUARE,)])
            view = motion.View(before)
            points = motion.on_plane(view)
            mask = found[5] == 1
            assert (abs(points[mask]) < 1.01).all()
            pixels = numpy.argwhere(abs(points[..., :2]).max(-1) < 0.99)
            assert mask[tuple(pixels.T)].all(), "the plane has holes"
            expected = motion.View(after).project(points) - view.project(points)
            error = motion_error(found, expected, mask)
            print("plane", "parallel" if parallel else "perspective", kind, error)
            assert error < TOLERANCE, (parallel, kind, error)
            depth = (points - view.eye) @ view.forward
            assert abs(found[4] - depth)[mask].max() < 1e-4


def test_floor_behind_the_camera():
    """Two triangles that reach from far away to behind the camera, which walks over them."""
    floor = scene.plane(40.0).GetOutput()
    before = motion.camera_at((0.0, -1.0, 0.3), (0.2, 0.0, 0.2))
    before.SetViewUp(0.0, 0.0, 1.0)
    before.SetClippingRange(0.01, 100.0)
    after = vtkCamera()
    after.DeepCopy(before)
    after.SetPosition(0.02, -0.95, 0.31)
    found = motion.compute(before, after, [(floor,)])
    view = motion.View(before)
    points = motion.on_plane(view)
    mask = found[5] == 1
    expected = motion.View(after).project(points) - view.project(points)
    error = motion_error(found, expected, mask)
    print("floor", error)
    assert error < TOLERANCE, error


def rotation(matrix):
    return numpy.array([[matrix.GetElement(i, j) for j in range(3)] for i in range(3)])


def test_sphere():
    for parallel in (False, True):
        for kind in MOTIONS + ("turn",):
            before = motion.camera_at(parallel=parallel)
            after = motion.moved(before, kind)
            turn = vtkTransform()
            if kind == "turn":
                turn.RotateWXYZ(9.0, 0.3, 1.0, 0.2)
            found = motion.compute(before, after, [(FINE, None, None, turn.GetMatrix())])
            view = motion.View(before)
            points = motion.on_sphere(view)
            facing = motion.facing_sphere(view, points)
            mask = facing > 0.3
            assert (found[5][mask] == 1).all()
            assert numpy.nanmax(abs(found[3] - facing)[mask]) < 2e-3
            goal = points @ rotation(turn.GetMatrix()).T
            expected = motion.View(after).project(goal) - view.project(points)
            error = motion_error(found, expected, mask)
            print("sphere", "parallel" if parallel else "perspective", kind, error)
            assert error < TOLERANCE, (parallel, kind, error)
            # Seen after: turned to the viewer, pixels at the very edge aside.
            after_facing = motion.facing_sphere(motion.View(after), goal)
            assert (found[2][mask & (after_facing > 0.1)] == 1).all()
            hidden = numpy.isfinite(facing) & (after_facing < -0.02)
            assert (found[2][hidden] == 0).all()


def deformed(data, function):
    result = vtkPolyData()
    result.DeepCopy(data)
    points = vtk_to_numpy(result.GetPoints().GetData())
    points[:] = function(points.astype(float))
    return result


def twist(points):
    """Turned about z by 0.4 rad per unit of z, and grown by a tenth."""
    angle = 0.4 * points[..., 2]
    c, s = numpy.cos(angle), numpy.sin(angle)
    x, y = points[..., 0], points[..., 1]
    return 1.1 * numpy.stack([c * x - s * y, s * x + c * y, points[..., 2]], axis=-1)


def test_deforming_points():
    before = motion.camera_at()
    after = motion.moved(before, "rotate")
    found = motion.compute(before, after, [(FINE, deformed(FINE, twist))])
    view = motion.View(before)
    points = motion.on_sphere(view)
    mask = motion.facing_sphere(view, points) > 0.3
    expected = motion.View(after).project(twist(points)) - view.project(points)
    error = motion_error(found, expected, mask)
    print("twisted sphere", error)
    assert error < TOLERANCE, error


def test_far_from_the_origin():
    """A scene at a distance of a million, moved there by matrices: no digits get lost."""
    far = numpy.array((1e6, -2e6, 5e5))
    shift = vtkTransform()
    shift.Translate(*far)
    near_before = motion.camera_at()
    near_after = motion.moved(near_before, "rotate")
    near = motion.compute(near_before, near_after, [(FINE,)])
    cameras = []
    for camera in (near_before, near_after):
        cameras.append(vtkCamera())
        cameras[-1].DeepCopy(camera)
        cameras[-1].SetPosition(*(far + camera.GetPosition()))
        cameras[-1].SetFocalPoint(*(far + camera.GetFocalPoint()))
    distant = motion.compute(*cameras, [(FINE, None, shift.GetMatrix())])
    mask = (near[3] > 0.3) & (distant[3] > 0.3)
    assert abs(near[:2] - distant[:2])[:, mask].max() < 1e-3


scene.run(globals())
