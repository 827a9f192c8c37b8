#!/usr/bin/env python3
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A pipeline from a pattern image to its thresholds, which grow with the tone at every scale."""

import hachure
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

source = hachure.vtkPatternImageSource()
source.SetPatternToCrossHatch()
source.SetIrregularity(0.5)
table = hachure.vtkToneCorrectionTable()
table.SetInputConnection(source.GetOutputPort())
table.SetPeriodInPixels(8.0)
table.Update()


def thresholds():
    assert table.GetOutput().GetDimensions() == (256, 48, 1)
    return vtk_to_numpy(table.GetOutput().GetPointData().GetArray("Threshold")).reshape(48, 256)


fine = thresholds().copy()
assert (numpy.diff(fine, axis=1) >= 0).all()
assert (fine[:, 0] < 0).all() and (fine[:, 255] > 1).all()
# The picture at scale 2 is the picture at scale 1; in between the blend of two screens is narrower.
assert abs(fine[0] - fine[-1]).max() < 0.01
assert fine[16, 25] > fine[0, 25] + 0.03
assert table.GetOutput().GetFieldData().GetArray("TexelsPerPixel").GetValue(0) == 4.0

table.SetPeriodInPixels(4.0)  # wider edges: the thresholds of pale tones go further down
table.Update()
assert thresholds()[0, 0] < fine[0, 0]

table.LodBlendingOff()
table.Update()
assert abs(thresholds()[16] - thresholds()[4]).max() < 0.1
