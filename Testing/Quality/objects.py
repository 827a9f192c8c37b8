# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The surfaces of the scenes, of radius 0.65 or so about the origin, and how some of them deform.

A deformation gives the surfaces of a scene at every frame: points move, connectivity stays.
"""

import math
import os

import blade as blade_file
import numpy
import protein_tube
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOExodus import vtkExodusIIReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

RADIUS = 0.65
TUBE_RADIUS = 0.15  # five wavelengths of the inks across, so that there is a pattern to follow
TUBE_SIZE = 2.0  # a part of the protein fills the picture
SKULL_LEVEL = 2.9  # the bone, in the file's units
BLADE_MODE = 0
BLADE_SIZE = 2.6  # a part of the blade fills the picture
BLADE_PLACE = (0.45, -0.4, 0.0)
BLADE_SWAY = 0.4  # where the blade moves most, scene units
DATA = os.environ.get("HACHURE_DATA") or os.path.join(
    os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Data")

# What Examples/Data/fetch.sh brings.
FETCHED = os.path.join(DATA, "Fetched")


class Missing(Exception):
    """The data of a scene are not there; the message says what to do."""


def steps(frames):
    """-1/2 times the number of steps to 1/2 times it: the middle of a clip is the middle of its path."""
    return [frame - (frames - 1) / 2 for frame in range(frames)]


def placed(surface, move=(0, 0, 0), scale=(1, 1, 1), turn=(0, 0, 0, 1)):
    transform = vtkTransform()
    transform.Translate(*move)
    transform.RotateWXYZ(*turn)
    transform.Scale(*scale)
    apply = vtkTransformPolyDataFilter()
    apply.SetTransform(transform)
    apply.SetInputData(surface)
    apply.Update()
    return apply.GetOutput()


def fitted(surface, turn=(0, 0, 0, 1)):
    """About the origin and about as large as the ball."""
    if not surface.GetNumberOfPolys():
        raise RuntimeError("no surface in the data of this scene")
    scale = 2.6 * RADIUS / surface.GetLength()
    centre = [-scale * c for c in surface.GetCenter()]
    return placed(placed(surface, move=centre, scale=(scale,) * 3), turn=turn)


def with_normals(surface, crease=None):
    """crease: edges sharper than this many degrees get two normals; None keeps all points as they are."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SetSplitting(crease is not None)
    normals.SetConsistency(False)
    if crease is not None:
        normals.SetFeatureAngle(crease)
    normals.Update()
    return normals.GetOutput()


def ball(radius=RADIUS):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(96)
    source.SetPhiResolution(96)
    source.Update()
    return source.GetOutput()


def square(width=6.0):
    """In the plane z = 0, facing the camera."""
    source = vtkPlaneSource()
    source.SetOrigin(-width / 2, -width / 2, 0)
    source.SetPoint1(width / 2, -width / 2, 0)
    source.SetPoint2(-width / 2, width / 2, 0)
    source.SetResolution(24, 24)
    source.Update()
    return source.GetOutput()


def skull():
    reader = vtkXMLImageDataReader()
    reader.SetFileName(os.path.join(DATA, "skull.vti"))
    contour = vtkContourFilter()
    contour.SetInputConnection(reader.GetOutputPort())
    contour.SetValue(0, SKULL_LEVEL)
    contour.ComputeNormalsOff()
    contour.Update()
    return fitted(with_normals(contour.GetOutput()))


def disk():
    """The walls of a chamber around a turning disk, seen from above and the side."""
    reader = vtkExodusIIReader()
    reader.SetFileName(os.path.join(DATA, "disk_out_ref.ex2"))
    surface = vtkCompositeDataGeometryFilter()
    surface.SetInputConnection(reader.GetOutputPort())
    surface.Update()
    return fitted(with_normals(surface.GetOutput(), crease=50), turn=(-55, 1, 0, 0))


def triangles(surface):
    apply = vtkTriangleFilter()
    apply.SetInputData(surface)
    apply.Update()
    return apply.GetOutput()


def protein_model(part):
    """A tube along the backbone of the first measured model, or on the way to the second."""
    first, second = protein_tube.backbones(DATA)[:2]
    backbone = TUBE_SIZE * ((1 - part) * first + part * second)
    return with_normals(triangles(protein_tube.tube(backbone, TUBE_RADIUS)))


def protein():
    return protein_model(0)


def blade():
    """Of a turbocharger's compressor; its vectors are a mode of vibration."""
    path = os.path.join(FETCHED, "blade.frd")
    if not os.path.exists(path):
        raise Missing("%s is not there; Examples/Data/fetch.sh fetches it" % path)
    surface = blade_file.surface(path, BLADE_MODE)
    upright = fitted(with_normals(surface, crease=50), turn=(60, 0, 1, 0))
    return placed(upright, move=BLADE_PLACE, scale=(BLADE_SIZE,) * 3, turn=(25, 0, 0, 1))


def moved(surface, points):
    """The surface with other points, and normals to match."""
    result = surface.NewInstance()
    result.ShallowCopy(surface)
    places = vtkPoints()
    places.SetData(numpy_to_vtk(numpy.ascontiguousarray(points, dtype=numpy.float32), deep=1))
    result.SetPoints(places)
    return with_normals(result)


def bend(surfaces, frames):
    """The upper part sways from side to side, the lower part the other way."""
    result = []
    for s in steps(frames):
        states = []
        for surface in surfaces:
            points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
            points[:, 0] += 0.13 * math.sin(0.2 * s) * numpy.sin(2.4 * points[:, 1])
            states.append(moved(surface, points))
        result.append(states)
    return result


def grow(surfaces, frames):
    return [[placed(surface, scale=(1.025**s,) * 3) for surface in surfaces] for s in steps(frames)]


def fold(_surfaces, frames):
    return [[protein_model(0.016 * frame)] for frame in range(frames)]


def vibrate(surfaces, frames):
    """P + a sin(wt) D for the displacements D of a mode."""
    result = []
    for s in steps(frames):
        states = []
        for surface in surfaces:
            sway = vtk_to_numpy(surface.GetPointData().GetVectors())
            sway = sway * (BLADE_SWAY / numpy.linalg.norm(sway, axis=1).max())
            points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
            states.append(moved(surface, points + math.sin(0.2 * s) * sway))
        result.append(states)
    return result
