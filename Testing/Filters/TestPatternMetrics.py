#!/usr/bin/env python3
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A pattern fixed in the image, one on the surface, and a pop, measured from arrays of numpy."""

import math

import hachure
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

SIZE = 120
SHIFT = numpy.array([1.6, -0.9])
y, x = numpy.mgrid[0:SIZE, 0:SIZE].astype(float)


def image(values):
    """An image with the components values[row, column, component]."""
    result = vtkImageData()
    result.SetDimensions(SIZE, SIZE, 1)
    values = numpy.ascontiguousarray(values.reshape(SIZE * SIZE, -1), dtype=numpy.float32)
    result.GetPointData().SetScalars(numpy_to_vtk(values, deep=1))
    return result


def ink(place, seed):
    """Waves of about 10 pixels, from 0 to 1."""
    random = numpy.random.default_rng(seed)
    total = 0
    for angle in random.uniform(0, 2 * math.pi, 12):
        wave = 2 * math.pi / 10 * random.uniform(0.8, 1.2)
        total = total + numpy.cos(
            wave * (math.cos(angle) * (x - place[0]) + math.sin(angle) * (y - place[1]))
            + random.uniform(0, 6))
    return numpy.clip(0.5 + 0.1 * total, 0, 1)


def measure(frames):
    metrics = hachure.vtkPatternMetrics()
    metrics.SetWavelength(10)
    motion = numpy.dstack([numpy.full_like(x, SHIFT[0]), numpy.full_like(x, SHIFT[1]), x * 0 + 1])
    for frame in frames:
        metrics.AddFrame(image(frame))
    for _ in frames[1:]:
        metrics.AddMotion(image(motion))
    metrics.Update()
    table = metrics.GetOutput()
    values = {table.GetValueByName(row, "Metric").ToString():
              table.GetValueByName(row, "Value").ToDouble() for row in range(table.GetNumberOfRows())}
    return values, vtk_to_numpy(metrics.GetOutput(1).GetColumnByName("Boil"))


door, boil = measure([ink([0, 0], 1)] * 4)
assert abs(door["SlideRatio"] - 1) < 0.01, door
assert (boil < 0.0005).all(), boil

texture, boil = measure([ink(t * SHIFT, 1) for t in range(4)])
assert texture["SlideRatio"] < 0.005 and texture["Coherence"] > 0.9995, texture
assert math.isnan(texture["DistanceSlope"])

pop, boil = measure([ink(t * SHIFT, 1 if t < 2 else 2) for t in range(5)])
assert boil[1] > 0.3 and (numpy.delete(boil, 1) < 0.0005).all(), boil
assert pop["Pop"] > 300, pop
