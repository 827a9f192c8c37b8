# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Patches, the weights by which they blend, and strokes that each patch carries: patches.py [FILE.png]"""

import hachure
import numpy
import vtk
from sheet import Sheet, save, skull
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

COUNT = 40

patches = hachure.vtkSurfacePatches()
patches.SetInputData(skull())
patches.SetNumberOfPatches(COUNT)
weights = hachure.vtkPatchBlendWeights()
weights.SetInputConnection(patches.GetOutputPort())
weights.SetRings(8)
weights.Update()
surface = weights.GetOutput()


def colored(data, colors):
    """A mapper of the surface with colours per cell or per point, as its attributes."""
    copy = vtk.vtkPolyData()
    copy.ShallowCopy(surface)
    array = numpy_to_vtk(colors.astype(numpy.uint8), deep=True)
    array.SetName("colors")
    getattr(copy, data)().SetScalars(array)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(copy)
    getattr(mapper, "SetScalarModeToUse" + data[3:-4] + "Data")()
    return mapper


hue = numpy.arange(COUNT)[:, None] * 2.4 + numpy.array([0, 2.1, 4.2])
palette = 190 + 55 * numpy.cos(hue)
ids = vtk_to_numpy(surface.GetCellData().GetArray("PatchId"))
near = vtk_to_numpy(surface.GetPointData().GetArray("BlendPatches"))
share = vtk_to_numpy(surface.GetPointData().GetArray("BlendWeights"))
blended = (palette[near] * share[..., None]).sum(axis=1)

hatching = hachure.vtkPatternMapper()
hatching.SetInputData(surface)  # its arrays tell patches and weights
hatching.SetStyle(hachure.style("hatch"))
hatching.GetStyle().GetLayer(0).SetSize(5)

row = []
for mapper in (colored("GetCellData", palette[ids]), colored("GetPointData", blended), hatching):
    sheet = Sheet(300, 340)
    sheet.add(mapper)
    # The strokes follow each part of the skull through a turn.
    for angle in numpy.linspace(-60, 20, 41) if mapper is hatching else (20,):
        turn = numpy.radians(angle)
        sheet.look((6 * numpy.sin(turn), -6 * numpy.cos(turn), 1.2), (0, 0, 0), angle=23.5)
        sheet.draw()
    row.append(sheet.picture())
save([row], "patches.png")
