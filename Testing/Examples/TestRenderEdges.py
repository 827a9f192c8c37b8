# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Faces that meet in a sharp edge and share its points are drawn with a line between them."""

import json

import numpy
import vtk

from rendering_program import draw, fresh_folder, picture

fresh_folder()
cube = vtk.vtkCubeSource()
shared = vtk.vtkCleanPolyData()
shared.SetInputConnection(cube.GetOutputPort())
shared.Update()
surface = shared.GetOutput()
assert surface.GetNumberOfPoints() == 8
surface.GetPointData().Initialize()  # no normals
writer = vtk.vtkXMLPolyDataWriter()
writer.SetInputData(surface)
writer.SetFileName("cube.vtp")
writer.Write()
with open("lines.json", "w", encoding="ascii") as out:
    json.dump({"hachure": 1, "outline": {"enabled": True, "width": {"px": 2}}}, out)

draw("cube.vtp", "--style", "lines.json", "--size", "160x120", "--supersample", "1",
     "--output", "cube")
# Across the middle: left end, the edge between the two faces in front, right end.
dark = picture("cube/frame_0000.png")[60].mean(axis=1) < 0.5
starts = numpy.flatnonzero(dark[1:] & ~dark[:-1])
assert len(starts) == 3, starts
