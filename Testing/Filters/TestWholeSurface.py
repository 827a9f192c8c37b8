# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A surface as a whole and its parts: the order does not depend on who has what, and parts find their cells in it."""

import hachure
import numpy
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkClipPolyData, vtkElevationFilter, vtkStripper
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkPlaneSource, vtkSphereSource

IDS = hachure.vtkWholeSurface.GetCellIdsName()


def made(source, **properties):
    for name, value in properties.items():
        getattr(source, "Set" + name)(value)
    source.Update()
    return source.GetOutput()


def ball(resolution=24):
    colored = vtkElevationFilter()
    colored.SetInputData(made(vtkSphereSource(), ThetaResolution=resolution, PhiResolution=resolution))
    data = made(colored, LowPoint=(0, 0, -0.5), HighPoint=(0, 0, 0.5))
    data.GetCellData().AddArray(numbered("Cell", data.GetNumberOfCells()))
    return data


def numbered(name, count):
    array = numpy_to_vtk(numpy.arange(count), deep=True)
    array.SetName(name)
    return array


def assemble(data, filter_=None):
    """The part and the whole."""
    assembly = hachure.vtkWholeSurface()
    assembly.SetInputData(data)
    assembly.SetFilter(filter_)
    assembly.Update()
    return assembly.GetOutputDataObject(0), assembly.GetOutputDataObject(1)


def corners(data):
    """Of every polygon the places of its corners."""
    ids = vtkIdList()
    places = []
    for cell in range(data.GetNumberOfPolys()):
        data.GetPolys().GetCellAtId(cell, ids)
        places.append([data.GetPoint(ids.GetId(i)) for i in range(ids.GetNumberOfIds())])
    return places


def rows(data, name, of_cells=True):
    attributes = data.GetCellData() if of_cells else data.GetPointData()
    return vtk_to_numpy(attributes.GetArray(name))


def taken(data, cells):
    """Some cells of polydata, with their arrays and all points."""
    part = vtkPolyData()
    part.SetPoints(data.GetPoints())
    part.GetPointData().ShallowCopy(data.GetPointData())
    polygons, ids, numbers = vtkCellArray(), vtkIdList(), vtkIdList()
    for cell in cells:
        data.GetPolys().GetCellAtId(int(cell), ids)
        polygons.InsertNextCell(ids)
        numbers.InsertNextId(int(cell))
    part.SetPolys(polygons)
    part.GetCellData().CopyAllocate(data.GetCellData())
    for index, cell in enumerate(cells):
        part.GetCellData().CopyData(data.GetCellData(), int(cell), index)
    return part


def cut(part, whole, **properties):
    filter_ = hachure.vtkSurfacePart()
    filter_.SetInputData(0, part)
    filter_.SetInputData(1, whole)
    return made(filter_, **properties)


def blocks(composite):
    return [composite.GetBlock(i) for i in range(composite.GetNumberOfBlocks())]


@calldata_type(VTK_STRING)
def note(_, __, text):
    messages.append(text)


# All cells are there, with their arrays, and the part knows which is which.
data = ball()
part, whole = assemble(data)
assert whole.GetNumberOfCells() == data.GetNumberOfCells() and whole.GetNumberOfPoints() == data.GetNumberOfPoints()
ids = rows(part, IDS)
assert sorted(ids) == list(range(data.GetNumberOfCells())) and (ids != numpy.arange(len(ids))).any()
shown, of_whole = corners(data), corners(whole)
assert all(shown[i] == of_whole[ids[i]] for i in range(len(ids)))
assert (rows(whole, "Cell")[ids] == rows(data, "Cell")).all()
heights = rows(whole, "Elevation", False)
assert numpy.allclose(heights, [(whole.GetPoint(i)[2] + 0.5) for i in range(len(heights))], atol=1e-6)
assert hachure.vtkWholeSurface.GetWhole(part).GetNumberOfCells() == data.GetNumberOfCells()
assert hachure.vtkWholeSurface.GetWhole(data) is None

# Other orders of cells and points, and several parts put together, are the same whole.
halves = vtkAppendPolyData()
middle = [numpy.mean(places, axis=0) for places in shown]
for half in ([i for i, place in enumerate(middle) if place[0] < 0.1],
             [i for i, place in enumerate(middle) if place[0] >= 0.1]):
    halves.AddInputData(taken(data, half[::-1]))
other = assemble(made(halves))[1]
assert other.GetNumberOfPoints() == whole.GetNumberOfPoints()
assert corners(other) == of_whole and (rows(other, "Elevation", False) == heights).all()
assert (vtk_to_numpy(other.GetPolys().GetConnectivityArray()) ==
        vtk_to_numpy(whole.GetPolys().GetConnectivityArray())).all()

# While a surface moves, its cells stay.
moving = vtkPolyData()
moving.DeepCopy(data)
assembly = hachure.vtkWholeSurface()
assembly.SetInputData(moving)
assembly.Update()
before = vtk_to_numpy(assembly.GetOutputDataObject(1).GetPolys().GetConnectivityArray()).copy()
places = vtk_to_numpy(moving.GetPoints().GetData())
places[:, 0], places[:, 2] = -places[:, 2], places[:, 0] * 3.0
moving.GetPoints().Modified()
assembly.Update()
after = assembly.GetOutputDataObject(1)
assert (vtk_to_numpy(after.GetPolys().GetConnectivityArray()) == before).all()
turned = [0.5 - after.GetPoint(i)[0] for i in range(len(heights))]
assert numpy.allclose(rows(after, "Elevation", False), turned, atol=1e-6)

# A filter runs on the whole; what it adds is in the part as well.
patches = hachure.vtkSurfacePatches()
patches.SetMethod(patches.AUTOMATIC)
patches.SetNumberOfPatches(5)
blend = hachure.vtkPatchBlendWeights()
blend.SetInputConnection(patches.GetOutputPort())
divided, whole_divided = assemble(data, patches)
assert len(set(rows(divided, "PatchId"))) == 5
assert (rows(whole_divided, "PatchId")[rows(divided, IDS)] == rows(divided, "PatchId")).all()

# A part: its cells on the points of the whole, and others around it that are marked.
chosen = [i for i, place in enumerate(middle) if place[2] > 0.2]
cap = taken(part, chosen)
drawn = blocks(cut(cap, whole, Surroundings=0.1, MaximumNumberOfCells=0))
assert len(drawn) == 2 and drawn[0].GetPoints() is whole.GetPoints()
assert sorted(map(str, corners(drawn[0]))) == sorted(str(shown[i]) for i in chosen)
assert (rows(drawn[0], "Cell") == rows(whole, "Cell")[rows(drawn[0], IDS)]).all()
assert not hachure.vtkSurfacePart.IsSurroundings(drawn[0]) and hachure.vtkSurfacePart.IsSurroundings(drawn[1])
around = rows(drawn[1], "Cell")
assert not set(around) & set(chosen)
lowest = min(numpy.array(shown[i])[:, 2].min() for i in chosen)
for i in set(range(len(shown))) - set(chosen):
    near = max(place[2] for place in shown[i]) > lowest - 0.05
    assert near <= (i in around), i
assert min(middle[i][2] for i in around) > lowest - 0.1 * 3 ** 0.5 - 0.1
narrow = blocks(cut(cap, whole, Surroundings=0, MaximumNumberOfCells=0))
assert 0 < narrow[1].GetNumberOfCells() < drawn[1].GetNumberOfCells()
assert hachure.vtkSurfacePart.GetSurroundedBlock(narrow[1]) == 0
assert hachure.vtkSurfacePart.GetSurroundedBlock(narrow[0]) == -1

# All others surround a part of a small surface. Of a cell that was cut, one of the pieces has all.
small = blocks(cut(cap, whole))
assert set(rows(small[1], "Cell")) == set(range(len(shown))) - set(chosen)
halves = []
for inside in False, True:
    plane = vtkPlane()
    plane.SetOrigin(0.0, 0.0, 0.2)
    plane.SetNormal(0.0, 0.0, 1.0)
    clip = vtkClipPolyData()
    clip.SetInputData(part)
    clip.SetClipFunction(plane)
    clip.SetInsideOut(inside)
    clip.Update()
    assert clip.GetOutput().GetNumberOfPolys() > len(shown) // 4
    halves.append(rows(blocks(cut(clip.GetOutput(), whole))[0], IDS))
assert sum(map(len, halves)) == len(shown) == len(set(halves[0]) | set(halves[1]))

# All of it: the whole itself. Nothing of it: no cells, but the bounds of all. Parts of nothing known pass.
everything = blocks(cut(part, whole))
assert len(everything) == 1 and everything[0].GetPolys() is whole.GetPolys()
nothing = blocks(cut(taken(part, []), whole))
assert nothing[0].GetNumberOfCells() == 0 and nothing[0].GetNumberOfPoints() == whole.GetNumberOfPoints()
unknown = blocks(cut(data, None))
assert len(unknown) == 1 and unknown[0].GetPolys() is data.GetPolys()

# Vertices and lines stay with their part, strips become triangles, ghosts are left out.
both = vtkAppendPolyData()
both.AddInputData(data)
both.AddInputData(made(vtkLineSource(), Resolution=7))
mixed, whole_mixed = assemble(made(both))
assert whole_mixed.GetNumberOfLines() == 0 and whole_mixed.GetNumberOfPolys() == data.GetNumberOfPolys()
assert list(rows(mixed, IDS)[:1]) == [-1]
with_line = blocks(cut(mixed, whole_mixed))
assert len(with_line) == 1 and with_line[0].GetNumberOfLines() == 1
assert with_line[0].GetBounds()[1] >= 0.5 and with_line[0].GetNumberOfPolys() == data.GetNumberOfPolys()
assert sorted(rows(with_line[0], IDS)[1:]) == list(range(data.GetNumberOfPolys()))
strips = vtkStripper()
strips.SetInputData(made(vtkSphereSource()))
assert assemble(made(strips))[1].GetNumberOfPolys() == made(vtkSphereSource()).GetNumberOfPolys()
ghosted = ball()
ghosts = numpy_to_vtk((numpy.arange(ghosted.GetNumberOfCells()) % 3 == 0).astype(numpy.uint8), deep=True)
ghosts.SetName("vtkGhostType")
ghosted.GetCellData().AddArray(ghosts)
count = int((numpy.arange(ghosted.GetNumberOfCells()) % 3 != 0).sum())
assert [surface.GetNumberOfCells() for surface in assemble(ghosted)] == [count, count]

# Composites keep their blocks, with those that are empty or missing.
composite = vtkMultiBlockDataSet()
composite.SetBlock(0, ball(8))
composite.SetBlock(1, vtkPolyData())
composite.SetBlock(2, None)
composite.SetBlock(3, made(vtkPlaneSource(), XResolution=3, YResolution=3))
parts, wholes = assemble(composite)
assert [block.GetNumberOfCells() if block else None for block in blocks(wholes)][0::3] == [
    composite.GetBlock(0).GetNumberOfCells(), 9]
assert len(blocks(cut(parts, wholes))) == 4
for empty in vtkPolyData(), vtkMultiBlockDataSet():
    assert [surface.GetNumberOfElements(1) for surface in assemble(empty)] == [0, 0]

# Too large a surface says so, and its part passes with the filter run on it.
messages = []
assembly = hachure.vtkWholeSurface()
assembly.AddObserver("ErrorEvent", note)
assembly.SetInputData(data)
assembly.SetFilter(patches)
assembly.SetMaximumNumberOfCells(100)
assembly.Update()
assert "%d polygons in all processes, expected at most 100" % data.GetNumberOfCells() in messages[0]
assert assembly.GetOutputDataObject(1).GetNumberOfCells() == 0
passed = assembly.GetOutputDataObject(0)
assert len(set(rows(passed, "PatchId"))) == 5 and not passed.GetCellData().HasArray(IDS)
