# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A blade of a turbocharger's compressor and the modes in which it vibrates, as CalculiX computed them."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_HEXAHEDRON, vtkUnstructuredGrid
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

HEXAHEDRON = 4  # of 20 nodes, in the file
# Its nodes: corners, edges below, upright edges, edges above; VTK has the upright edges last.
NODES = [*range(12), *range(16, 20), *range(12, 16)]
WIDTH = 12  # characters of a number


def blocks(lines):
    """The records of a file (CalculiX GraphiX manual, result format) by block: header and lines."""
    header, records = None, []
    for line in lines:
        if line[:5] in ("    2", "    3", "  100"):
            header, records = line, []
        elif line.startswith(" -3") and header:
            yield header, records
            header = None
        elif header:
            records.append(line)


def numbers(line, count):
    return [float(line[13 + WIDTH * i:13 + WIDTH * (i + 1)]) for i in range(count)]


def elements(records, places):
    """Nodes of every element; they go on for two lines below its type."""
    result = []
    for line in records:
        if line.startswith(" -1"):
            if int(line[13:18]) != HEXAHEDRON:
                raise ValueError("blade: element type %s, expected %d" % (line[13:18], HEXAHEDRON))
            result.append([])
        else:
            result[-1] += [places[int(number)] for number in line[3:].split()]
    return [[cell[i] for i in NODES] for cell in result]


def read(path):
    """Points, cells of quadratic hexahedra, and the displacements of every mode."""
    points, cells, modes, places = None, None, [], {}
    with open(path, encoding="ascii", errors="replace") as file:
        for header, records in blocks(file):
            if header.startswith("    2"):
                places = {int(line[3:13]): i for i, line in enumerate(records)}
                points = numpy.array([numbers(line, 3) for line in records])
            elif header.startswith("    3"):
                cells = elements(records, places)
            elif any(line.startswith(" -4  DISP") for line in records):
                modes.append(numpy.array([numbers(line, 3) for line in records if line.startswith(" -1")]))
    return points, cells, modes


def surface(path, mode):
    """Its surface at rest, as polydata, with the vectors Displacement of a mode, 1 where it is largest."""
    points, cells, modes = read(path)
    grid, places = vtkUnstructuredGrid(), vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=1))
    grid.SetPoints(places)
    for cell in cells:
        grid.InsertNextCell(VTK_QUADRATIC_HEXAHEDRON, len(cell), cell)
    displacement = modes[mode] / numpy.linalg.norm(modes[mode], axis=1).max()
    array = numpy_to_vtk(displacement, deep=1)
    array.SetName("Displacement")
    grid.GetPointData().AddArray(array)
    outside = vtkDataSetSurfaceFilter()
    outside.SetInputData(grid)
    outside.SetNonlinearSubdivisionLevel(2)
    outside.Update()
    outside.GetOutput().GetPointData().SetActiveVectors("Displacement")
    return outside.GetOutput()
