# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Photographs of a bone given back to it, seen from between them: view_photographs.py [FILE.png [skull]]

The bone is that of ct.vti, which Data/fetch.sh fetches, or else the skull."""

import resource
import sys
import time

import hachure
import numpy
import vtk
from sheet import DATA, GAMMA, placed_bone, save, skull
from views import Studio, add_dependent, camera_at, image
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

PHOTOGRAPHS = 19
SIZE = 256  # pixels of a side
DISTANCE, ANGLE = 6.6, 25  # of cameras
REACH = 38  # degrees to where a photograph is gone: beyond its neighbours, which are 30 away
FINEST = 5
DIFFERENCE = 3  # factor
SHOWN = 0  # of the new cameras
MEMORY = 2048  # MiB that colours may take: else level 5 would be left out for n = 16


def bone():
    """What was chosen, and its name."""
    file = DATA / "Fetched/ct.vti"
    if file.exists() and sys.argv[2:] != ["skull"]:
        return placed_bone(file, 226.5), "CT"
    print("no %s: the skull instead; bash Examples/Data/fetch.sh fetches it" % file.name)
    return skull(), "skull"


def painted(data):
    """Lit and shining, in colours of an array."""
    x, y, z = vtk_to_numpy(data.GetPoints().GetData()).T
    bands = 0.5 + 0.5 * numpy.sin(14 * z + 2 * numpy.sin(5 * x) + 2 * numpy.sin(4 * y))
    data.GetPointData().SetScalars(numpy_to_vtk(bands.astype(numpy.float32), deep=True))
    colors = vtk.vtkColorTransferFunction()
    for value, color in ((0, (0.85, 0.75, 0.55)), (0.5, (0.75, 0.35, 0.25)), (1, (0.25, 0.4, 0.55))):
        colors.AddRGBPoint(value, *color)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetLookupTable(colors)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.1)
    actor.GetProperty().SetSpecular(0.6)
    actor.GetProperty().SetSpecularPower(10)
    return actor


def directions(count):
    """Evenly over the upper half of a sphere."""
    height = 0.9 * (numpy.arange(count) + 0.5) / count
    turn = numpy.arange(count) * numpy.pi * (3 - 5 ** 0.5)
    radius = numpy.sqrt(1 - height ** 2)
    return numpy.stack([radius * numpy.sin(turn), -radius * numpy.cos(turn), height], axis=1)


def between(places, count=8):
    """Half way between neighbours, each of which counts once."""
    near = numpy.triu(places @ places.T, 1)
    found = []
    while len(found) < count:
        pair = numpy.unravel_index(near.argmax(), near.shape)
        found.append(places[list(pair)].sum(axis=0) / numpy.linalg.norm(places[list(pair)].sum(axis=0)))
        near[list(pair)] = near[:, list(pair)] = 0
    return found


def taken(studio, places):
    """Photographs with their cameras."""
    cameras = [camera_at(DISTANCE * direction, angle=ANGLE) for direction in places]
    return [(camera, *studio.take(camera)) for camera in cameras]


def given_back(data, photographs, hemisphere):
    """The bone with its photographs; hemisphere: 0, or directions a side for dependent views."""
    style = hachure.style("view")
    style.GetLayer(0).SetMemoryBudget(MEMORY)
    views = style.GetLayer(0).GetViews()
    views.SetFinestLevel(FINEST)
    views.SetHemisphere(hemisphere or 8)
    for camera, colors, covered in photographs:
        views.AddView("base", camera, image(colors, covered))
        if hemisphere:
            view = add_dependent(views, "photograph", camera, image(colors, covered), (REACH, REACH))
            views.RemoveAllFadePoints(view)
            views.AddFadePoint(view, 0, 1)
            views.AddFadePoint(view, 1, 0)
    mapper = hachure.vtkPatternMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    mapper.SetStyle(style)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return Studio(SIZE, SIZE, actor)


def compared(name, studio, wanted):
    """What is seen from new cameras; prints how far it is from what they would have taken."""
    start, memory = time.time(), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    studio.take(wanted[0][0])
    made = time.time() - start
    found = [studio.take(camera)[0] for camera, _, _ in wanted]
    drawn = (time.time() - start - made) / len(wanted)
    memory = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - memory) / 1024
    print("%s: made in %.1f s and up to %.0f MiB more, drawn in %.2f s" % (name, made, memory, drawn))
    errors = []
    for number, (colors, (_, truth, covered)) in enumerate(zip(found, wanted)):
        away = (colors.astype(float) - truth)[covered]
        errors.append((numpy.abs(away).mean(), 10 * numpy.log10(255 ** 2 / (away ** 2).mean())))
        print("  camera %d: %5.2f of 255 away in the mean, %.1f dB" % (number, *errors[-1]))
    print("  mean:     %5.2f of 255 away in the mean, %.1f dB" % tuple(numpy.mean(errors, axis=0)), flush=True)
    return found


def light(colors):
    return (colors / 255.0) ** GAMMA


data, name = bone()
print("%s, %d triangles" % (name, data.GetNumberOfCells()))
studio = Studio(SIZE, SIZE, painted(data))
photographs = taken(studio, directions(PHOTOGRAPHS))
wanted = taken(studio, between(directions(PHOTOGRAPHS)))
pictures = {}
for hemisphere, name in ((0, "independent"), (8, "dependent, n = 8"), (16, "dependent, n = 16")):
    pictures[hemisphere] = compared(name, given_back(data, photographs, hemisphere), wanted)
truth = wanted[SHOWN][1]
row = [truth]
for hemisphere in (16, 0):
    found = pictures[hemisphere][SHOWN]
    row += [found, 255 - numpy.minimum(DIFFERENCE * numpy.abs(found.astype(int) - truth), 255)]
save([[light(colors)[20:-20, 48:-48] for colors in row]], "view_photographs.png")
