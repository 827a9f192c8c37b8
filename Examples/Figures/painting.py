# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Dabs of paint follow a protein that folds from one measured model to another: painting.py [FILE.png]"""

import gzip

import hachure
import numpy
import vtk
from sheet import DATA, Sheet, save

with gzip.open(DATA / "pdb2k39_ca.pdb.gz", "rt") as file:
    atoms = [[float(line[i:i + 8]) for i in (30, 38, 46)] for line in file if line.startswith("ATOM")]
models = numpy.array(atoms).reshape(-1, 76, 3)[:, :71]  # without the loose end
models -= models.mean(axis=(0, 1))


def tube(backbone):
    """A tube along the backbone, with the same triangles for every model."""
    points = vtk.vtkPoints()
    for atom in backbone:
        points.InsertNextPoint(atom)
    spline = vtk.vtkParametricSpline()
    spline.SetPoints(points)
    curve = vtk.vtkParametricFunctionSource()
    curve.SetParametricFunction(spline)
    curve.SetUResolution(600)
    skin = vtk.vtkTubeFilter()
    skin.SetInputConnection(curve.GetOutputPort())
    skin.SetRadius(2.2)
    skin.SetNumberOfSides(20)
    skin.CappingOn()
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(skin.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


patches = hachure.vtkSurfacePatches()
patches.SetInputData(tube(models[0]))
patches.SetNumberOfPatches(40)
weights = hachure.vtkPatchBlendWeights()
weights.SetInputConnection(patches.GetOutputPort())
weights.SetRings(3)
weights.Update()
surface = weights.GetOutput()

# Colours from blue to red along the chain: the tube has as many points for every step of it.
place = vtk.vtkFloatArray()
for point in range(surface.GetNumberOfPoints()):
    place.InsertNextValue(point / surface.GetNumberOfPoints())
surface.GetPointData().SetScalars(place)
colors = vtk.vtkColorTransferFunction()
for value, color in ((0, (0.10, 0.25, 0.55)), (0.35, (0.25, 0.62, 0.62)), (0.6, (0.95, 0.80, 0.40)),
                     (0.8, (0.90, 0.45, 0.25)), (1, (0.60, 0.12, 0.20))):
    colors.AddRGBPoint(value, *color)

sheet = Sheet(260, 260)
mapper = hachure.vtkPatternMapper()
mapper.SetLookupTable(colors)
mapper.SetInputData(surface)  # a copy would begin the patterns anew
mapper.SetStyle(hachure.style("painterly"))
mapper.GetStyle().GetLayer(0).SetSize(7)
sheet.add(mapper)
sheet.renderer.SetBackground(mapper.GetStyle().GetPaperColor())
sheet.look((0, -75, 10), (-1, 0, 0), angle=26)

row = []
for part in numpy.linspace(0, 2, 31):
    first = min(int(part), 1)
    backbone = models[first] + (part - first) * (models[first + 1] - models[first])
    folded = tube(backbone)
    surface.SetPoints(folded.GetPoints())
    surface.GetPointData().SetNormals(folded.GetPointData().GetNormals())
    sheet.draw()
    if round(15 * part) % 15 == 0:
        row.append(sheet.picture())
save([row], "painting.png")
