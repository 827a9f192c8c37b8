#!/usr/bin/env python3
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Kernels of a sphere from Python: their number follows the picture, not the triangles."""

import hachure
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkCamera

camera = vtkCamera()
camera.SetPosition(0.0, 0.0, 3.0)
sums = []
for resolution in (12, 60, 300):
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(resolution)
    sphere.SetPhiResolution(resolution)
    points = hachure.vtkNoiseKernelPoints()
    points.SetInputConnection(sphere.GetOutputPort())
    points.SetCamera(camera)
    points.SetRadius(8.0)
    points.Update()
    weights = vtk_to_numpy(points.GetOutput().GetPointData().GetArray("Weight"))
    assert weights.min() >= 0.0 and weights.max() == 1.0
    sums.append((weights.astype(float) ** 2).sum())
# A sphere of 12 x 12 is 8 % smaller in the picture.
assert sums[2] > 5000.0, sums
assert abs(sums[1] / sums[2] - 1.0) < 0.05, sums
assert 0.85 < sums[0] / sums[2] < 1.0, sums

points.SetOverlap(0.0)
points.SetSpread(200.0)
assert points.GetOverlap() == 1.0 and points.GetSpread() == 90.0
assert "Overlap: 1" in str(points)
