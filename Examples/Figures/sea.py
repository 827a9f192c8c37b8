# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The globe: sea with its temperature and how often that was measured, land, and coast."""

import numpy
import vtk
from sheet import DATA
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

CELL = 5, 4  # degrees of longitude and latitude
WEST = 20


def heights():
    """Metres, [latitude, longitude] from -89.5 and 20.5 degrees on, for every degree."""
    reader = vtk.vtkNetCDFCFReader()
    reader.SetFileName(str(DATA / "etopo60.cdf"))
    reader.UpdateInformation()
    reader.SphericalCoordinatesOff()
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetArray("ROSE")).reshape(180, 360)


def cells(name, month):
    """Values of the sea by cells, NaN on land."""
    reader = vtk.vtkXMLImageDataReader()
    reader.SetFileName(str(DATA / "esku_sst_obs.vti"))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetArray(name)).reshape(12, 46, 72)[month]


def grown(field):
    """Cells without a value get the mean of their neighbours, so that the sea reaches its coasts."""
    wide = numpy.pad(field, ((1, 1), (0, 0)), constant_values=numpy.nan)
    around = numpy.stack([numpy.roll(wide, (i, j), (0, 1))[1:-1] for i in (-1, 0, 1) for j in (-1, 0, 1)])
    known = numpy.isfinite(around)
    mean = numpy.where(known, around, 0).sum(axis=0) / numpy.where(known.any(axis=0), known.sum(axis=0), numpy.nan)
    return numpy.where(numpy.isfinite(field), field, mean)


def interpolated(field, latitude, longitude):
    x, y = (longitude - WEST) / CELL[0], (latitude + 90) / CELL[1]
    i, j = x.astype(int), y.astype(int)
    south, north = (field[k, i % 72] * (1 - x + i) + field[k, (i + 1) % 72] * (x - i) for k in (j, j + 1))
    return south * (1 - y + j) + north * (y - j)


def named(values, name):
    array = numpy_to_vtk(numpy.ascontiguousarray(values, dtype=numpy.float32).ravel(), deep=True)
    array.SetName(name)
    return array


def on_sphere(latitude, longitude):
    """Places at radius 1, by degrees."""
    latitude, longitude = numpy.radians(latitude), numpy.radians(longitude)
    return numpy.stack([numpy.cos(latitude) * numpy.cos(longitude),
                        numpy.cos(latitude) * numpy.sin(longitude), numpy.sin(latitude)], axis=-1)


def globe(month):
    """Sea, with the arrays SST_degC and log10_nobs, land and coast, of radius 1."""
    latitude, longitude = numpy.mgrid[-89.5:90, 20.5:381]
    grid = vtk.vtkStructuredGrid()
    grid.SetDimensions(*latitude.shape[::-1], 1)
    for name in ("SST_degC", "log10_nobs"):
        field = grown(grown(cells(name, month)))
        grid.GetPointData().AddArray(named(interpolated(field, latitude, longitude), name))
    grid.GetPointData().SetScalars(named(heights()[:, numpy.arange(361) % 360], "height"))
    grid.SetPoints(vtk.vtkPoints())
    places = on_sphere(latitude, longitude).reshape(-1, 3)
    grid.GetPoints().SetData(numpy_to_vtk(places, deep=True))
    surface = vtk.vtkStructuredGridGeometryFilter()
    surface.SetInputData(grid)
    parts = vtk.vtkClipPolyData()
    parts.SetInputConnection(surface.GetOutputPort())
    parts.InsideOutOn()
    parts.GenerateClippedOutputOn()
    parts.Update()
    coast = vtk.vtkContourFilter()
    coast.SetInputConnection(surface.GetOutputPort())
    coast.SetValue(0, 0)
    coast.Update()
    return parts.GetOutput(), parts.GetClippedOutput(), coast.GetOutput()
