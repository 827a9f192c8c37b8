# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Models of a protein, and a tube along its backbone that has the same triangles for all of them."""

import gzip

import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTubeFilter

ATOMS = 76


def backbones(folder):
    """Positions of the atoms in every model, in a box of about size 1."""
    with gzip.open(folder + "/pdb2k39_ca.pdb.gz", "rt") as file:
        atoms = [line for line in file if line.startswith("ATOM")]
    places = numpy.array([[float(line[i:i + 8]) for i in (30, 38, 46)] for line in atoms])
    models = places.reshape(-1, ATOMS, 3)
    return (models - models.mean((0, 1))) / 30.0


def tube(backbone, radius=0.03):
    """Strips around a smooth curve (Catmull and Rom) through the atoms."""
    padded = numpy.concatenate([backbone[:1], backbone, backbone[-1:]])
    before, start, end, after = (padded[i:ATOMS - 1 + i, None] for i in range(4))
    t = (numpy.arange(8) / 8)[None, :, None]
    square = 2 * before - 5 * start + 4 * end - after
    cube = 3 * start - before - 3 * end + after
    curve = 0.5 * (2 * start + (end - before) * t + square * t**2 + cube * t**3).reshape(-1, 3)
    points, lines, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    for point in curve:
        points.InsertNextPoint(*point)
    lines.InsertNextCell(len(curve), range(len(curve)))
    data.SetPoints(points)
    data.SetLines(lines)
    filter_ = vtkTubeFilter()
    filter_.SetInputData(data)
    filter_.SetRadius(radius)
    filter_.SetNumberOfSides(12)
    filter_.Update()
    return filter_.GetOutput()
