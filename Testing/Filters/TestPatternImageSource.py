#!/usr/bin/env python3
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The share of texels below a tone is the tone, for every pattern and for any number of threads."""

import os
import subprocess
import sys

import hachure
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy


patterns = [
    hachure.vtkPatternImageSource.HATCH,
    hachure.vtkPatternImageSource.CROSS_HATCH,
    hachure.vtkPatternImageSource.HALFTONE,
    hachure.vtkPatternImageSource.STIPPLE,
    hachure.vtkPatternImageSource.PAINT,
    hachure.vtkPatternImageSource.PAPER,
]


def screen(pattern, irregularity, seed=1):
    source = hachure.vtkPatternImageSource()
    source.SetPattern(pattern)
    source.SetIrregularity(irregularity)
    source.SetSize(128)
    source.SetSeed(seed)
    source.Update()
    image = source.GetOutput()
    assert image.GetDimensions() == (128, 128, 1)
    assert image.GetFieldData().GetArray("Periods").GetValue(0) == 8
    assert vtk_to_numpy(image.GetPointData().GetArray("Gradient")).min() > 0
    return vtk_to_numpy(image.GetPointData().GetScalars())


def all_bytes():
    return b"".join(screen(pattern, 0.6).tobytes() for pattern in patterns)


if "--bytes" in sys.argv:
    sys.stdout.buffer.write(all_bytes())
    sys.exit(0)

for pattern in patterns:
    for irregularity in (0.0, 0.6):
        values = screen(pattern, irregularity)
        # Texels along a ruled line share one value, the middle of their steps: 8 values a hatch.
        bound = 1e-4 if irregularity > 0.0 else 0.5 / 8 + 1e-4
        for tone in (0.1, 0.25, 0.5, 0.9):
            assert abs((values < tone).mean() - tone) < bound, (pattern, irregularity, tone)
        ordered = np.sort(values)
        first = np.searchsorted(ordered, ordered, "left")
        last = np.searchsorted(ordered, ordered, "right")
        assert abs(ordered - 0.5 * (first + last) / len(ordered)).max() < 0.5 / len(ordered)

assert (screen(0, 0.6) != screen(0, 0.6, seed=2)).any()

for threads in ("1", "8"):
    environment = dict(os.environ, OMP_NUM_THREADS=threads)
    again = subprocess.run(
        [sys.executable, __file__, "--bytes"], env=environment, stdout=subprocess.PIPE, check=True
    )
    assert again.stdout == all_bytes(), threads
