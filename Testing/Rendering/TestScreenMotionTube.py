# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A tube along a protein's backbone, from one model of it to others, against cast rays."""

import sys

import motion_scene as motion
import numpy
import pattern_scene as scene
import protein_tube
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkRenderingCore import vtkCamera

DATA = sys.argv[sys.argv.index("-D") + 1]
RAYS = 1500


class Caster:
    """Where rays meet a surface, by VTK's own search."""

    def __init__(self, data):
        triangles = vtkTriangleFilter()
        triangles.SetInputData(data)
        triangles.Update()
        self.data = triangles.GetOutput()
        self.points = vtk_to_numpy(self.data.GetPoints().GetData()).astype(float)
        self.corners = vtk_to_numpy(self.data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(self.data)
        self.locator.BuildLocator()

    def cast(self, origin, target):
        """Triangle, weights of its corners and the part of the way, or None."""
        part, sub, cell = mutable(0.0), mutable(0), mutable(0)
        place, local = [0.0] * 3, [0.0] * 3
        if not self.locator.IntersectWithLine(origin, target, 1e-9, part, place, local, sub, cell):
            return None
        return int(cell), numpy.array([1 - local[0] - local[1], local[0], local[1]]), float(part)

    def place(self, cell, weights):
        return weights @ self.points[self.corners[cell]]


def check_pair(first, second):
    before, after = motion.camera_at((0.0, 0.0, 4.0)), vtkCamera()
    after.DeepCopy(before)
    after.Azimuth(3.0)
    found = motion.compute(before, after, [(first, second)])
    casters = Caster(first), Caster(second)
    views = motion.View(before), motion.View(after)
    directions = views[0].rays()[1]
    pixels = numpy.argwhere(found[3] > 0.3)
    pixels = pixels[numpy.random.default_rng(1).choice(len(pixels), RAYS, replace=False)]
    errors, wrong = [], numpy.zeros(2, int)
    for y, x in pixels:
        hit = casters[0].cast(views[0].eye, views[0].eye + 10 * directions[y, x])
        assert hit is not None, "nothing is there"
        start, goal = casters[0].place(*hit[:2]), casters[1].place(*hit[:2])
        expected = views[1].project(goal) - views[0].project(start)
        errors.append(numpy.hypot(*(found[:2, y, x] - expected)))
        blocked = casters[1].cast(views[1].eye, goal)
        seen = blocked is None or blocked[2] > 1 - 1e-4
        visible = found[2, y, x] == 1
        wrong += (seen and not visible, visible and not seen)
    return numpy.array(errors), wrong


def test_models():
    models = protein_tube.backbones(DATA)
    first = protein_tube.tube(models[0])
    for number in (1, 57, 115):
        errors, wrong = check_pair(first, protein_tube.tube(models[number]))
        print("model", number, "error", errors.max(), "visibility wrong at", wrong, "of", RAYS)
        # At an edge of the picture of a triangle the ray may meet its neighbour.
        assert errors.max() < 0.01, errors.max()
        assert (wrong < (0.02 * RAYS, 0.004 * RAYS)).all(), wrong


scene.run(globals())
