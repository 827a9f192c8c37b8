# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Motion per pixel is that of the surface, to 0.01 px: planes and spheres, every kind of change."""

import math

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkCamera

SIZE = (640, 480)
TOLERANCE = 0.01  # px
EYE = (0.3, -0.2, 3.0)
RADIUS = 0.65


def camera_at(position=EYE, focal_point=(0.0, 0.0, 0.0), parallel=False):
    camera = vtkCamera()
    camera.SetPosition(*position)
    camera.SetFocalPoint(*focal_point)
    camera.SetClippingRange(0.5, 10.0)
    camera.SetParallelProjection(parallel)
    camera.SetParallelScale(1.1)
    return camera


class View:
    """The mathematics of a camera, from its defining parameters alone."""

    def __init__(self, camera):
        self.eye = numpy.array(camera.GetPosition())
        forward = numpy.array(camera.GetFocalPoint()) - self.eye
        self.forward = forward / numpy.linalg.norm(forward)
        right = numpy.cross(self.forward, camera.GetViewUp())
        self.right = right / numpy.linalg.norm(right)
        self.up = numpy.cross(self.right, self.forward)
        self.parallel = bool(camera.GetParallelProjection())
        self.half = math.tan(math.radians(camera.GetViewAngle()) / 2)
        if self.parallel:
            self.half = camera.GetParallelScale()

    def rays(self):
        """Origins and directions through all pixel centres, rows from the bottom up."""
        y, x = numpy.mgrid[0:SIZE[1], 0:SIZE[0]] + 0.5
        step = 2 * self.half / SIZE[1]
        offsets = ((x - SIZE[0] / 2)[..., None] * self.right + (y - SIZE[1] / 2)[..., None] * self.up) * step
        if self.parallel:
            return self.eye + offsets, numpy.broadcast_to(self.forward, offsets.shape)
        return numpy.broadcast_to(self.eye, offsets.shape), offsets + self.forward

    def project(self, points):
        local = points - self.eye
        scale = 1.0 if self.parallel else (local @ self.forward)[..., None]
        flat = numpy.stack([local @ self.right, local @ self.up], axis=-1)
        return flat / scale / (2 * self.half / SIZE[1]) + numpy.array(SIZE) / 2


def on_sphere(view, centre=(0.0, 0.0, 0.0), radius=RADIUS):
    """Where the rays meet a sphere first, NaN where they do not."""
    origins, directions = view.rays()
    offset = origins - centre
    a, b = (directions**2).sum(-1), (offset * directions).sum(-1)
    root = b * b - a * ((offset**2).sum(-1) - radius**2)
    with numpy.errstate(invalid="ignore"):
        return origins + directions * ((-b - numpy.sqrt(root)) / a)[..., None]


def on_plane(view):
    """Where the rays meet the plane z = 0."""
    origins, directions = view.rays()
    return origins - directions * (origins[..., 2] / directions[..., 2])[..., None]


def facing_sphere(view, points, radius=RADIUS):
    to_eye = -view.forward if view.parallel else view.eye - points
    lengths = numpy.linalg.norm(numpy.broadcast_to(to_eye, points.shape), axis=-1) * radius
    return (points * to_eye).sum(-1) / lengths


window = scene.window_of(size=(300, 200))


def compute(before, after, surfaces, occluders=()):
    """u, v, visible, facing, distance and label as images."""
    motion = hachure.vtkPatternMotion()
    motion.SetSize(*SIZE)
    motion.SetCameraBefore(before)
    motion.SetCameraAfter(after)
    for arguments in surfaces:
        motion.AddSurface(*arguments)
    for arguments in occluders:
        motion.AddOccluder(*arguments)
    assert motion.Compute(window)
    image = motion.GetOutput()
    assert image.GetDimensions() == (*SIZE, 1)
    values = vtk_to_numpy(image.GetPointData().GetScalars()).astype(float)
    return numpy.moveaxis(values.reshape(SIZE[1], SIZE[0], 6), 2, 0)


def moved(camera, kind):
    """The camera after a translation, orbit, zoom or roll."""
    result = vtkCamera()
    result.DeepCopy(camera)
    if kind == "translate":
        for get, put in ((camera.GetPosition, result.SetPosition),
                         (camera.GetFocalPoint, result.SetFocalPoint)):
            put(*(numpy.array(get()) + (0.07, -0.04, 0.02)))
    elif kind == "rotate":
        result.Azimuth(7.0)
        result.Elevation(-4.0)
        result.OrthogonalizeViewUp()
    elif kind == "zoom":
        result.SetPosition(*(numpy.array(EYE) * 0.9))
        result.SetParallelScale(1.0)
        result.Zoom(1.05)
    elif kind == "roll":
        result.Roll(11.0)
    return result


def motion_error(found, expected, mask):
    assert mask.sum() > 0.1 * mask.size, "hardly anything is seen"
    return float(numpy.hypot(found[0] - expected[..., 0], found[1] - expected[..., 1])[mask].max())


FINE = scene.sphere(512, RADIUS).GetOutput()
SQUARE = scene.plane(2.0).GetOutput()
MOTIONS = ("translate", "rotate", "zoom", "roll")


def test_plane():
    for parallel in (False, True):
        for kind in MOTIONS:
            before = camera_at(parallel=parallel)
            after = moved(before, kind)
            found = compute(before, after, [(SQUARE,)])
            view = View(before)
            points = on_plane(view)
            mask = found[5] == 1
            assert (abs(points[mask]) < 1.01).all()
            pixels = numpy.argwhere(abs(points[..., :2]).max(-1) < 0.99)
            assert mask[tuple(pixels.T)].all(), "the plane has holes"
            expected = View(after).project(points) - view.project(points)
            error = motion_error(found, expected, mask)
            print("plane", "parallel" if parallel else "perspective", kind, error)
            assert error < TOLERANCE, (parallel, kind, error)
            depth = (points - view.eye) @ view.forward
            assert abs(found[4] - depth)[mask].max() < 1e-4


def test_sphere():
    for parallel in (False, True):
        for kind in MOTIONS + ("turn",):
            before = camera_at(parallel=parallel)
            after = moved(before, kind)
            turn = vtkTransform()
            if kind == "turn":
                turn.RotateWXYZ(9.0, 0.3, 1.0, 0.2)
            found = compute(before, after, [(FINE, None, None, turn.GetMatrix())])
            view = View(before)
            points = on_sphere(view)
            facing = facing_sphere(view, points)
            mask = facing > 0.3
            assert (found[5][mask] == 1).all()
            assert numpy.nanmax(abs(found[3] - facing)[mask]) < 2e-3
            rotation = numpy.array([[turn.GetMatrix().GetElement(i, j) for j in range(3)] for i in range(3)])
            goal = points @ rotation.T
            expected = View(after).project(goal) - view.project(points)
            error = motion_error(found, expected, mask)
            print("sphere", "parallel" if parallel else "perspective", kind, error)
            assert error < TOLERANCE, (parallel, kind, error)
            # Seen after: turned to the viewer, pixels at the very edge aside.
            after_facing = facing_sphere(View(after), goal)
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
    before = camera_at()
    after = moved(before, "rotate")
    found = compute(before, after, [(FINE, deformed(FINE, twist))])
    view = View(before)
    points = on_sphere(view)
    mask = facing_sphere(view, points) > 0.3
    expected = View(after).project(twist(points)) - view.project(points)
    error = motion_error(found, expected, mask)
    print("twisted sphere", error)
    assert error < TOLERANCE, error


def test_far_from_the_origin():
    """A scene at a distance of a million, moved there by matrices: no digits get lost."""
    far = numpy.array((1e6, -2e6, 5e5))
    shift = vtkTransform()
    shift.Translate(*far)
    near_before = camera_at()
    near_after = moved(near_before, "rotate")
    near = compute(near_before, near_after, [(FINE,)])
    cameras = []
    for camera in (near_before, near_after):
        cameras.append(vtkCamera())
        cameras[-1].DeepCopy(camera)
        cameras[-1].SetPosition(*(far + camera.GetPosition()))
        cameras[-1].SetFocalPoint(*(far + camera.GetFocalPoint()))
    distant = compute(*cameras, [(FINE, None, shift.GetMatrix())])
    mask = (near[3] > 0.3) & (distant[3] > 0.3)
    assert abs(near[:2] - distant[:2])[:, mask].max() < 1e-3


def occlusion(occluder_is_surface):
    """A plane behind a sphere, and a camera that passes by: seen, and at the edges of it."""
    centre, radius = numpy.array((0.1, 0.0, 1.0)), 0.3
    ball = scene.sphere(256, radius, centre).GetOutput()
    before = camera_at()
    after = moved(before, "translate")
    first = [(SQUARE,), (ball,)] if occluder_is_surface else [(SQUARE,)]
    found = compute(before, after, first, [] if occluder_is_surface else [(ball,)])
    view, next_view = View(before), View(after)
    points = on_plane(view)

    def hidden(eye, size):
        along = points - eye
        closest = numpy.clip(((centre - eye) * along).sum(-1) / (along**2).sum(-1), 0, 1)
        return numpy.linalg.norm(eye + along * closest[..., None] - centre, axis=-1) < size

    pixel = 2 * view.half / SIZE[1] * 2.3  # beside the sphere, generously
    inside = abs(points[..., :2]).max(-1) < 0.95
    goal = next_view.project(points)
    inside &= (goal > 1).all(-1) & (goal < numpy.array(SIZE) - 1).all(-1)
    plane = inside & ~hidden(view.eye, radius + pixel)
    seen = plane & ~hidden(next_view.eye, radius + pixel)
    lost = plane & hidden(next_view.eye, radius - pixel)
    return found, plane, seen, lost, inside & hidden(view.eye, radius - pixel)


def test_visibility_behind_a_sphere():
    for occluder_is_surface in (True, False):
        found, plane, seen, lost, ball = occlusion(occluder_is_surface)
        assert (found[5][plane] == 1).all()
        assert (found[2][seen] == 1).all(), "seen pixels marked as hidden"
        assert lost.sum() > 1000 and (found[2][lost] == 0).all(), "hidden pixels marked as seen"
        assert ball.sum() > 1000 and (found[5][ball] == (2 if occluder_is_surface else 0)).all()
        if not occluder_is_surface:
            assert (found[:, ball] == 0).all()


def test_leaving_the_picture_is_not_visible():
    before = camera_at((0, 0, 3))
    after = camera_at((0.9, 0, 3), (0.9, 0, 0))
    found = compute(before, after, [(SQUARE,)])
    goal = numpy.arange(SIZE[0]) + 0.5 + found[0]
    surface = found[5] == 1
    outside = surface & (goal < 0)
    assert outside.sum() > 1000
    assert (found[2] == (surface & ~outside)).all()
    behind = camera_at((0, 0, -1), (0, 0, -3))
    found = compute(before, behind, [(SQUARE,)])
    assert (found[:3] == 0).all() and (found[5] == 1).any()


def test_no_motion_and_blocks():
    """Equal states give 0 everywhere and all visible; blocks are one surface; nothing is nothing."""
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, scene.sphere(32, 0.4, (-0.5, 0, 0)).GetOutput())
    blocks.SetBlock(2, scene.sphere(32, 0.4, (0.5, 0, 0)).GetOutput())
    camera = camera_at()
    found = compute(camera, camera, [(blocks,)])
    surface = found[5] == 1
    assert surface[:, :320].any() and surface[:, 320:].any()
    assert abs(found[:2]).max() < 1e-6 and (found[2] == surface).all()
    assert (compute(camera, camera, [(vtkPolyData(),)]) == 0).all()
    assert (compute(camera, camera, []) == 0).all()


scene.run(globals())
