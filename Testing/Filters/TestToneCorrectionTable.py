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


def thresholds(steps=96):
    assert table.GetOutput().GetDimensions() == (256, steps, 1), table.GetOutput().GetDimensions()
    return vtk_to_numpy(table.GetOutput().GetPointData().GetArray("Threshold")).reshape(steps, 256)


fine = thresholds().copy()
assert (numpy.diff(fine, axis=1) >= 0).all()
assert (fine[:, 0] < 0).all() and (fine[:, 255] > 1).all()
# The picture at scale 2 is the picture at scale 1; in between the blend of two screens is narrower.
assert (fine[0] == fine[-1]).all()
assert fine[32, 25] > fine[0, 25] + 0.03
assert table.GetOutput().GetFieldData().GetArray("TexelsPerPixel").GetValue(0) == 4.0

table.SetPeriodInPixels(4.0)  # wider edges: the thresholds of pale tones go further down
table.Update()
assert thresholds()[0, 0] < fine[0, 0]

# A single octave, from half the size to twice: its edges become narrower with every step.
table.SetTransition(table.CROSS_FADE)
table.Update()
single = thresholds(48)
assert abs(numpy.diff(single, axis=0)).max() < 0.1
assert (numpy.diff(single[:, 0]) > -1e-3).all() and single[-1, 0] > single[0, 0] + 0.1

table.SetToneCorrection(table.NO_CORRECTION)
table.Update()
assert abs(thresholds(48) - numpy.linspace(0.0, 1.0, 256)).max() < 1e-6

# Looks as at scale 1, where the uncorrected threshold is the tone.
table.SetTransition(table.BLEND_SCREENS)
table.SetToneCorrection(table.TRANSITION_ONLY)
table.Update()
assert abs(thresholds()[0] - numpy.linspace(0.0, 1.0, 256))[1:-1].max() < 0.005
assert abs(thresholds()[48] - numpy.linspace(0.0, 1.0, 256)).max() > 0.02
