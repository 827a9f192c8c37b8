# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of xtoon.json: blots of pale ink with a rim where it dries darkest: xtoon.py [FILE.png]"""

import sys

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk

COLUMNS, ROWS = 128, 64  # values of the noise, tones
value, tone = numpy.meshgrid((numpy.arange(COLUMNS) + 0.5) / COLUMNS, numpy.linspace(0, 1, ROWS))
inside = tone - value  # how far in a blot; blots grow with the tone
fill = 0.12 + 0.6 * numpy.floor(3.999 * tone) / 3
rim = 0.85 * numpy.exp(-(inside / 0.07) ** 2)
ink = numpy.where(inside > 0, numpy.clip(fill + rim, 0, 1), 0)

image = vtk.vtkImageData()
image.SetDimensions(COLUMNS, ROWS, 1)
image.GetPointData().SetScalars(
    numpy_to_vtk(numpy.round(255 * (1 - ink)).astype(numpy.uint8).ravel(), deep=True))
writer = vtk.vtkPNGWriter()
writer.SetInputData(image)
writer.SetCompressionLevel(9)
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "xtoon.png")
writer.Write()
