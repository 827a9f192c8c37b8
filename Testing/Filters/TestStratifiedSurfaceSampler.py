# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Samples of a scan, per patch, from a script; the same for any number of threads."""

import os
import subprocess
import sys

import hachure
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

import numpy


def sample_skull():
    reader = vtkXMLImageDataReader()
    reader.SetFileName(os.environ["HACHURE_DATA"] + "/skull.vti")
    surface = vtkFlyingEdges3D()
    surface.SetInputConnection(reader.GetOutputPort())
    surface.SetValue(0, 2.9)
    surface.Update()
    skull = surface.GetOutput()

    triangles = vtk_to_numpy(skull.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = vtk_to_numpy(skull.GetPoints().GetData()).astype(float)
    corners = points[triangles]
    slab = ((corners[:, 0, 2] - points[:, 2].min()) // 40).astype(numpy.int32)
    patch = numpy_to_vtk(slab, deep=True)
    patch.SetName("slab")
    skull.GetCellData().AddArray(patch)

    sampler = hachure.vtkStratifiedSurfaceSampler()
    sampler.SetInputData(skull)
    sampler.SetPatchArrayName("slab")
    sampler.Update()
    return sampler.GetOutput(), corners, slab


def array(data, name):
    return vtk_to_numpy(data.GetArray(name))


def checksum():
    """All bytes of the output in one number."""
    samples = sample_skull()[0]
    data = [samples.GetPointData().GetArray(i) for i in range(samples.GetPointData().GetNumberOfArrays())]
    return hash(b"".join(vtk_to_numpy(a).tobytes() for a in data + [samples.GetPoints().GetData()]))


def run(threads):
    environment = dict(os.environ, OMP_NUM_THREADS=str(threads), PYTHONHASHSEED="0")
    command = [sys.executable, __file__, "--checksum"]
    return subprocess.run(command, env=environment, stdout=subprocess.PIPE, check=True, text=True).stdout


if "--checksum" in sys.argv:
    print(checksum())
    sys.exit(0)

samples, corners, slab = sample_skull()
patch = array(samples.GetPointData(), "PatchId")
cell = array(samples.GetPointData(), "CellId")
weights = array(samples.GetPointData(), "Barycentrics")
position = vtk_to_numpy(samples.GetPoints().GetData())
spacing = array(samples.GetFieldData(), "PatchSpacing")
identity = array(samples.GetPointData(), "SampleId")

areas = 0.5 * numpy.linalg.norm(
    numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
)
assert len(spacing) == slab.max() + 1 > 3
for i in range(len(spacing)):
    assert 480 <= (patch == i).sum() <= 500, (i, (patch == i).sum())
    assert abs(spacing[i] - (areas[slab == i].sum() / 500) ** 0.5) < 1e-6 * spacing[i]
assert (slab[cell] == patch).all()
assert numpy.abs((weights[:, :, None] * corners[cell]).sum(axis=1) - position).max() < 1e-4
assert len(set(identity)) == len(identity)
assert run(1) == run(8)
