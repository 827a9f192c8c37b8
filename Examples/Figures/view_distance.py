# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A vase whose flowers are replaced by simpler ones from afar: view_distance.py [FILE.png]"""

import hachure
import numpy
import vtk
from sheet import SCALE, save
from views import Studio, add_dependent, around, camera_at, image, shown

BLUE, PALE = (24, 52, 132), (120, 150, 214)
PROFILE = ((0.02, -1.3), (0.42, -1.3), (0.46, -1.24), (0.62, -0.75), (0.80, -0.1), (0.72, 0.45), (0.42, 0.85),
           (0.30, 1.05), (0.34, 1.22), (0.47, 1.32), (0.43, 1.33), (0.27, 1.15))  # radius, height
DISTANCE, FAR = 6.0, 28.0  # of the cameras of the views
SIDES = 160
MARGIN = 0.01  # of soft edges of paint, as wide as the vase is


def vase():
    points = vtk.vtkPoints()
    for radius, height in PROFILE:
        points.InsertNextPoint(radius, 0, height)
    curve = vtk.vtkParametricSpline()
    curve.SetPoints(points)
    line = vtk.vtkParametricFunctionSource()
    line.SetParametricFunction(curve)
    line.SetUResolution(200)
    turned = vtk.vtkRotationalExtrusionFilter()
    turned.SetInputConnection(line.GetOutputPort())
    turned.SetResolution(SIDES)
    turned.CappingOff()
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(turned.GetOutputPort())
    joined = vtk.vtkCleanPolyData()
    joined.SetInputConnection(triangles.GetOutputPort())
    joined.SetTolerance(1e-5)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(joined.GetOutputPort())
    normals.AutoOrientNormalsOn()
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput()


class Paint:
    """Colours over a picture. Places are as on the vase: across from its middle, and up."""

    def __init__(self, studio, camera):
        self.camera = camera
        self.colors, self.covered = studio.take(camera)
        seen = studio.places()
        right = numpy.cross(camera.GetDirectionOfProjection(), (0, 0, 1))
        self.x, self.y = seen @ right, seen[..., 2]
        self.alpha = numpy.zeros(self.x.shape)
        self.soft = max(MARGIN, 0.5 * numpy.median(numpy.abs(numpy.diff(self.x[self.covered.any(1)], axis=1))))

    def lay(self, inside, color):
        """inside: how far within the shape a pixel is."""
        share = numpy.clip(0.5 + inside / (2 * self.soft), 0, 1) * self.covered
        self.colors[:] = (1 - share[..., None]) * self.colors + share[..., None] * numpy.array(color)
        self.alpha = 1 - (1 - self.alpha) * (1 - share)

    def leaf(self, start, end, width, color, bend=0.0, vein=None):
        """A pointed shape from one place to another, bent to its left."""
        start, along = numpy.array(start), numpy.subtract(end, start)
        length = numpy.hypot(*along)
        u = ((self.x - start[0]) * along[0] + (self.y - start[1]) * along[1]) / length
        v = ((self.y - start[1]) * along[0] - (self.x - start[0]) * along[1]) / length
        t = numpy.clip(u / length, 0, 1)
        v = v - bend * 4 * t * (1 - t)
        half = width * numpy.sqrt(t) * (1 - t) * 1.3
        self.lay(numpy.minimum(half - numpy.abs(v), numpy.minimum(u, length - u)), color)
        if vein is not None:
            self.lay(numpy.minimum(0.006 - numpy.abs(v), numpy.minimum(u - 0.08 * length, 0.85 * length - u)), vein)

    def disk(self, centre, radius, color):
        self.lay(radius - numpy.hypot(self.x - centre[0], self.y - centre[1]), color)

    def stem(self, places, width, color):
        """Through places, straight between them."""
        distance = numpy.full(self.x.shape, numpy.inf)
        for (ax, ay), (bx, by) in zip(places, places[1:]):
            t = numpy.clip(((self.x - ax) * (bx - ax) + (self.y - ay) * (by - ay))
                           / ((bx - ax) ** 2 + (by - ay) ** 2), 0, 1)
            distance = numpy.minimum(distance, numpy.hypot(self.x - ax - t * (bx - ax), self.y - ay - t * (by - ay)))
        self.lay(width - distance, color)

    def flower(self, centre, size, petals, turn=0.0):
        """With veins and a rim of a darker blue."""
        for ring, (scale, color, dark) in enumerate(((1, PALE, BLUE), (0.68, (178, 198, 238), BLUE))):
            for angle in turn + (numpy.arange(petals) + 0.5 * ring) * 2 * numpy.pi / petals:
                tip = numpy.add(centre, scale * size * numpy.array([numpy.cos(angle), numpy.sin(angle)]))
                self.leaf(tip, centre, 1.25 * scale * size / petals * 2.0, dark)
                self.leaf(tip, centre, 1.25 * scale * size / petals * 2.0 - 0.022, color, vein=dark)
        self.disk(centre, 0.17 * size, BLUE)
        self.disk(centre, 0.09 * size, (240, 240, 250))

    def picture(self):
        return image(self.colors, self.alpha)


def curve(*places):
    """Through three places, as many short lines."""
    t = numpy.linspace(0, 1, 24)[:, None]
    a, b, c = (numpy.array(place) for place in places)
    return list((1 - t) ** 2 * a + 2 * t * (1 - t) * (2 * b - 0.5 * a - 0.5 * c) + t ** 2 * c)


def paint_front(paint):
    paint.stem(curve((0.05, -1.15), (-0.12, -0.5), (0.0, 0.0)), 0.014, BLUE)
    paint.stem(curve((-0.06, -0.7), (0.18, -0.55), (0.3, -0.42)), 0.011, BLUE)
    paint.stem(curve((-0.10, -0.45), (-0.28, -0.3), (-0.36, -0.42)), 0.011, BLUE)
    for start, end, bend in (((-0.02, -0.95), (0.34, -0.9), 0.05), ((-0.03, -0.85), (-0.36, -0.72), -0.05),
                             ((-0.11, -0.42), (0.18, -0.3), -0.04), ((0.0, -1.05), (-0.3, -1.1), 0.04)):
        paint.leaf(end, start, 0.10, BLUE, bend)
        paint.leaf(end, start, 0.07, PALE, bend, vein=BLUE)
    paint.flower((0.0, 0.08), 0.40, 9)
    paint.flower((0.34, -0.40), 0.20, 7, 0.3)
    paint.flower((-0.38, -0.46), 0.18, 7, 0.1)
    for i, x in enumerate(numpy.linspace(-0.22, 0.22, 5)):
        paint.disk((x, 0.92 + 0.02 * (i % 2)), 0.022, BLUE)


def paint_side(paint):
    for k in range(5):
        y = -0.95 + 0.34 * k
        paint.leaf((0.30, y + 0.32), (0, y), 0.11, BLUE, -0.03)
        paint.leaf((-0.30, y + 0.32), (0, y), 0.11, BLUE, 0.03)
    paint.stem([(0, -1.15), (0, 0.72)], 0.014, BLUE)
    paint.disk((0, 0.76), 0.05, BLUE)


def paint_far(paint):
    """Few bold shapes on opaque porcelain: what is fine would be lost, and must be covered."""
    paint.stem(curve((0.05, -1.15), (-0.14, -0.6), (0.0, 0.0)), 0.05, BLUE)
    paint.leaf((0.42, -0.62), (-0.05, -0.9), 0.22, BLUE)
    paint.leaf((-0.46, -0.42), (-0.08, -0.7), 0.22, BLUE)
    for angle in numpy.arange(5) * 2 * numpy.pi / 5 + numpy.pi / 2:
        paint.disk(0.27 * numpy.array([numpy.cos(angle), numpy.sin(angle)]) + (0, 0.1), 0.17, BLUE)
    paint.disk((0, 0.1), 0.12, (245, 245, 250))
    paint.alpha = paint.covered.astype(float)


def porcelain(surface):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(0.80, 0.83, 0.88)
    look.SetAmbient(0.25)
    return actor


def near_views(views, actor):
    """Shading for all cameras, and patterns for those in front of them."""
    studio = Studio(300, 400, actor)
    for azimuth, elevation in (*((45 * i, 5) for i in range(8)), (0, 60), (0, -60)):
        camera = camera_at(around(azimuth, elevation, DISTANCE))
        views.AddView("shading", camera, image(*studio.take(camera)))
    studio = Studio(600, 800, actor)
    for name, azimuth, brush in (("front", 0, paint_front), ("right", 100, paint_side), ("left", -100, paint_side)):
        paint = Paint(studio, camera_at(around(azimuth, 0, DISTANCE)))
        brush(paint)
        add_dependent(views, name, paint.camera, paint.picture(), (60, 60))


def far_view(views, actor):
    paint = Paint(Studio(300, 400, actor), camera_at(around(0, 0, FAR)))
    paint_far(paint)
    add_dependent(views, "far", paint.camera, paint.picture(), (75, 60))


def pictures(columns, with_far):
    """Of columns (distance, width, height in pixels): one pixel is the same angle in all."""
    surface = vase()
    actor = porcelain(surface)
    style = hachure.style("view")
    views = style.GetLayer(0).GetViews()
    views.SetFinestLevel(6)
    near_views(views, actor)
    if with_far:
        far_view(views, actor)
    sheet = shown(surface, style)
    row = []
    for distance, width, height in columns:
        angle = 2 * numpy.degrees(numpy.arctan(numpy.tan(numpy.radians(15)) * height / HEIGHT))
        sheet.window.SetSize(SCALE * width, SCALE * height)
        sheet.look(around(14, 4, distance), (0, 0, 0), angle=angle)
        sheet.draw()
        row.append(sheet.picture())
    return row


def enlarged(picture, width, height):
    """Its middle, every pixel as 2 x 2."""
    row, column = (picture.shape[0] - height // 2) // 2, (picture.shape[1] - width // 2) // 2
    return picture[row:, column:][:height // 2, :width // 2].repeat(2, axis=0).repeat(2, axis=1)


HEIGHT = 400
FAR_COLUMNS = (13, 150, HEIGHT // 2), (20, 120, HEIGHT // 2), (FAR, 100, HEIGHT // 2)
near, *first = pictures(((DISTANCE, 270, HEIGHT), *FAR_COLUMNS), True)
second = pictures(FAR_COLUMNS, False)
rows = [numpy.hstack([*row, enlarged(row[-1], 150, HEIGHT // 2)]) for row in (second, first)]
save([[near, numpy.vstack(rows)]], "view_distance.png", 63)
