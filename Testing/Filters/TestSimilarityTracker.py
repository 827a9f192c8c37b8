#!/usr/bin/env python3
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Rolling the camera turns the pattern with the image; dollying scales it."""

import hachure
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkCamera

sphere = vtkSphereSource()
sphere.SetThetaResolution(48)
sphere.SetPhiResolution(24)
sampler = hachure.vtkStratifiedSurfaceSampler()
sampler.SetInputConnection(sphere.GetOutputPort())
before, after = vtkCamera(), vtkCamera()
before.SetPosition(0.0, 0.0, 10.0)
after.SetPosition(0.0, 0.0, 10.0)
after.Roll(20.0)
tracker = hachure.vtkSimilarityTracker()
tracker.SetInputConnection(sampler.GetOutputPort())
tracker.SetCameraBefore(before)
tracker.SetCameraAfter(after)
tracker.Update()


def value(name):
    return tracker.GetOutput().GetValueByName(0, name)


assert tracker.GetOutput().GetNumberOfRows() == 1
assert value("Status").ToString() == "Similarity"
assert abs(value("AngleDegrees").ToDouble() - 20.0) < 1e-9, value("AngleDegrees")
assert abs(value("Scale").ToDouble() - 1.0) < 1e-9
assert value("Residual").ToDouble() < 1e-9

after.SetPosition(0.0, 0.0, 5.0)  # the tracker must notice
tracker.Update()
assert 1.9 < value("Scale").ToDouble() < 2.2, value("Scale")
