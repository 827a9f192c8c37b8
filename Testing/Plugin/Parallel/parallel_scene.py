# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests with several processes share: surfaces of which each holds a part, and pictures that must be alike.

One process draws all pictures and keeps them; more processes draw them again, and each picture is compared.
"""

import os
import sys
import traceback

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))

import pattern_scene as scene  # noqa: E402 (it is in the folder above)
from paraview import simple  # noqa: E402
from paraview.vtk.vtkParallelCore import vtkMultiProcessController  # noqa: E402

SIZE = (200, 150)
MEAN = 1.0  # largest mean difference, in levels
BOX, CROWD = 24, 28  # a seam: in a square of so many a side so many pixels differ by more than STRONG levels
STRONG = 64

controller = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
test = os.path.splitext(os.path.basename(sys.argv[0]))[0]
folder = os.path.join(scene.output_folder, test)
os.makedirs(folder, exist_ok=True)
failures = []


def abort(*problem):
    """Ends this process at once, and by that all others, which would wait for it."""
    traceback.print_exception(*problem)
    sys.stderr.flush()
    os._exit(1)


if RANKS > 1:
    sys.excepthook = abort


def seam(first, second):
    """The most pixels that differ strongly in one square of a picture: strokes that end, or lines that should not be."""
    strong = (numpy.abs(first.astype(int) - second).max(axis=2) > STRONG).astype(int)
    sums = numpy.pad(strong, BOX).cumsum(axis=0).cumsum(axis=1)
    return (sums[BOX:, BOX:] - sums[:-BOX, BOX:] - sums[BOX:, :-BOX] + sums[:-BOX, :-BOX]).max()


def compare(name, shown, wanted, by="%d processes" % RANKS):
    """Notes where a picture is not like the one of a single process."""
    mean, crowd = scene.difference(shown, wanted), seam(shown, wanted)
    print("%-20s %s: mean difference %.3f levels, %d pixels at most in a square" % (name, by, mean, crowd), flush=True)
    if mean >= MEAN or crowd >= CROWD:
        failures.append("%s by %s: mean difference %.3f levels, %d pixels in a square" % (name, by, mean, crowd))


def check(name, shown):
    """Keeps the picture of one process, or compares that of more; it must show something."""
    if RANK > 0:
        return
    assert (shown != 128).mean() > 0.02, name + " is empty"
    file_name = os.path.join(folder, name + ".npy")
    if RANKS == 1:
        numpy.save(file_name, shown)
    else:
        numpy.save(os.path.join(folder, "%s-%d.npy" % (name, RANKS)), shown)
        compare(name, shown, numpy.load(file_name))


def finish():
    """Says what was not alike."""
    assert not failures, "\n".join([""] + failures)


def still(name, source, position, focal=(0.0, 0.0, 0.0), size=SIZE, **properties):
    """A view of its own, with one picture of the source."""
    where = scene.view(size)
    where.RemoteRenderThreshold = 0
    scene.show(source, where, **properties)
    scene.look(where, position, focal)
    check(name, scene.picture(where))
    simple.Delete(where)


def blobs(radius=12, normals=True):
    """An isosurface of which every process holds a part: 5,000 triangles, that is 37 for each square of the radius."""
    wavelet = simple.Wavelet(WholeExtent=3 * [-radius, radius], XFreq=20, YFreq=10, ZFreq=13)
    return simple.Contour(
        Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[150], ComputeNormals=normals
    )


BLOBS_SEEN_FROM = (36.0, 18.0, 36.0)

BLOCKS = """
import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
information = self.GetOutputInformation(0)
key = self.GetExecutive().UPDATE_TIME_STEP()
time = information.Get(key) if information.Has(key) else 0.0
output = self.GetOutputDataObject(0)
BLOCKS, ROUND, LONG = 4, 24, 8
for block in range(BLOCKS):
    output.SetBlock(block, None)
    output.GetMetaData(block).Set(vtkMultiBlockDataSet.NAME(), "Block%d" % block)
    if block % ranks != rank:
        continue
    along, around = numpy.mgrid[0 : LONG + 1, 0:ROUND]
    x = (block + along / LONG) * 1.0 - 0.5 * BLOCKS
    radius = 0.8 + 0.25 * numpy.sin(2 * x + 2 * time)
    angle = around * 2 * numpy.pi / ROUND
    places = numpy.stack([x, radius * numpy.cos(angle), radius * numpy.sin(angle)], axis=-1).reshape(-1, 3)
    first = (along * ROUND + around)[:-1]
    beside = (along * ROUND + (around + 1) % ROUND)[:-1]
    quads = numpy.stack([first, beside, beside + ROUND, first + ROUND], axis=-1).reshape(-1, 4)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    cells = vtkCellArray()
    cells.SetData(4, numpy_to_vtkIdTypeArray(quads.astype(numpy.int64).ravel(), deep=True))
    rod = vtkPolyData()
    rod.SetPoints(points)
    rod.SetPolys(cells)
    output.SetBlock(block, rod)
if information.Has(key):
    output.GetInformation().Set(output.DATA_TIME_STEP(), time)
"""

TIMES = """
information = self.GetOutputInformation(0)
executive = self.GetExecutive()
information.Remove(executive.TIME_STEPS())
for step in range(4):
    information.Append(executive.TIME_STEPS(), 0.25 * step)
information.Remove(executive.TIME_RANGE())
information.Append(executive.TIME_RANGE(), 0.0)
information.Append(executive.TIME_RANGE(), 0.75)
"""


def rods():
    """Four blocks that touch, one process after the other having one, and that swell and shrink with time.

    Their script brings the names of numpy into that of the test, such as where.
    """
    return simple.ProgrammableSource(
        OutputDataSetType="vtkMultiblockDataSet", Script=BLOCKS, ScriptRequestInformation=TIMES
    )
