# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every filter gives the same bytes with 1 and with 8 OpenMP threads."""

import hashlib
import os
import subprocess
import sys

import hachure
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData
from vtkmodules.vtkFiltersSources import vtkSphereSource, vtkSuperquadricSource
from vtkmodules.vtkRenderingCore import vtkCamera


def arrays_of(data):
    kinds = (vtkDataObject.POINT, vtkDataObject.CELL, vtkDataObject.FIELD, vtkDataObject.ROW)
    for kind in kinds:
        attributes = data.GetAttributesAsFieldData(kind)
        for i in range(attributes.GetNumberOfArrays() if attributes else 0):
            if attributes.GetArray(i):  # texts have no array of numbers
                yield attributes.GetArray(i)


def digest(data):
    """A hash of all numbers that a data object holds."""
    result = hashlib.sha256()
    if hasattr(data, "GetPoints") and data.GetPoints():
        result.update(vtk_to_numpy(data.GetPoints().GetData()).tobytes())
    count = 0
    for array in arrays_of(data):
        result.update(vtk_to_numpy(array).tobytes())
        count += array.GetNumberOfValues()
    assert count > 0, "nothing to compare"
    return result.hexdigest()


def camera_at(azimuth):
    camera = vtkCamera()
    camera.SetPosition(0.0, 0.0, 10.0)
    camera.Azimuth(azimuth)
    return camera


def image(values):
    """An image with the components values[row, column, component]."""
    result = vtkImageData()
    result.SetDimensions(values.shape[1], values.shape[0], 1)
    flat = values.reshape(values.shape[0] * values.shape[1], -1).astype(numpy.float32)
    result.GetPointData().SetScalars(numpy_to_vtk(flat, deep=1))
    return result


def bytes_of(values):
    """An image of 8 bits."""
    result = image(values)
    flat = values.reshape(-1, values.shape[2]).astype(numpy.uint8)
    result.GetPointData().SetScalars(numpy_to_vtk(flat, deep=1))
    return result


def metrics_of_waves():
    """All that is measured of a moving pattern."""
    y, x = numpy.mgrid[0:150, 0:160].astype(float)
    metrics = hachure.vtkPatternMetrics()
    for time in range(3):
        metrics.AddFrame(image(
            0.5 + 0.2 * numpy.sin(0.8 * x - 1.1 * time) + 0.2 * numpy.sin(0.7 * y + 0.2 * x)))
        metrics.AddMotion(image(numpy.dstack(
            [x * 0 + 1.3, y * 0 + 0.4, x * 0 + 1, numpy.exp(-x / 200), 5 + 0.01 * y + time])))
        metrics.AddTone(image(x * 0 + 0.5))
    metrics.SetReference(image(0.5 + 0.4 * numpy.sin(0.7 * x + 0.3 * y)))
    return metrics


def digests():
    surface = vtkSphereSource()
    surface.SetThetaResolution(200)
    surface.SetPhiResolution(200)
    sampler = hachure.vtkStratifiedSurfaceSampler()
    sampler.SetInputConnection(surface.GetOutputPort())
    tracker = hachure.vtkSimilarityTracker()
    tracker.SetInputConnection(sampler.GetOutputPort())
    tracker.SetCameraBefore(camera_at(0.0))
    tracker.SetCameraAfter(camera_at(5.0))
    tracker.SetViewportSize(640, 480)
    pattern = hachure.vtkPatternImageSource()
    pattern.SetPattern(pattern.CROSS_HATCH)
    pattern.SetIrregularity(0.5)
    paint = hachure.vtkPatternImageSource()
    paint.SetPattern(paint.PAINT)
    table = hachure.vtkToneCorrectionTable()
    table.SetInputConnection(pattern.GetOutputPort())
    patches = hachure.vtkSurfacePatches()
    patches.SetInputConnection(surface.GetOutputPort())
    patches.SetNumberOfPatches(20)
    patches.AddCamera(camera_at(0.0))
    patches.AddCamera(camera_at(5.0))
    patches.SetMaximumSlide(0.1)
    blend = hachure.vtkPatchBlendWeights()
    blend.SetInputConnection(patches.GetOutputPort())
    blend.SetRings(3)
    directions = hachure.vtkSurfaceDirectionField()
    ring = vtkSuperquadricSource()
    ring.ToroidalOn()
    ring.SetThetaResolution(200)
    ring.SetPhiResolution(64)
    directions.SetInputConnection(ring.GetOutputPort())
    noise = hachure.vtkNoiseKernelPoints()
    noise.SetInputConnection(surface.GetOutputPort())
    noise.SetCamera(camera_at(0.0))
    stipples = hachure.vtkStippleHierarchy()
    stipples.SetInputConnection(surface.GetOutputPort())
    stipples.SetNumberOfPoints(20000)
    classic = hachure.vtkStippleHierarchy()
    classic.SetInputConnection(surface.GetOutputPort())
    classic.SetNumberOfPoints(50000)
    classic.SetOrderToClassic()
    textured = hachure.vtkViewDependentTexture()
    textured.SetInputConnection(surface.GetOutputPort())
    textured.SetCamera(camera_at(0.0))
    values = numpy.random.default_rng(1).integers(0, 256, (100, 100, 4))
    for azimuth in (0, 20, 180):
        textured.GetViews().AddView("view", camera_at(azimuth), bytes_of(values))
    textured.GetViews().SetViewKind(0, hachure.vtkTextureViews.DEPENDENT)
    results = []
    for filter_ in (
            sampler, tracker, pattern, paint, table, patches, blend, directions, noise,
            stipples, classic, textured, metrics_of_waves()):
        filter_.Update()
        results.append(filter_.GetClassName() + " " + digest(filter_.GetOutput()))
    results += ["%d %s" % (i, digest(textured.GetOutput(i))) for i in (1, 2)]
    return "\n".join(results)


if "--digests" in sys.argv:
    print(digests())
    sys.exit(0)

outputs = [
    subprocess.run(
        [sys.executable, __file__, "--digests"],
        env=dict(os.environ, OMP_NUM_THREADS=threads),
        stdout=subprocess.PIPE,
        check=True,
        text=True,
    ).stdout
    for threads in ("1", "8")
]
assert outputs[0].count("\n") == 15, outputs[0]
assert outputs[0] == outputs[1], "\n".join(outputs)
