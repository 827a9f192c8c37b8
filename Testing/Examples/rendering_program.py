# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the programs share: running them, small inputs, reading their pictures."""

import os
import shutil
import subprocess
import sys

import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

PROGRAM, FOLDER = sys.argv[1:3]
NAME = os.path.basename(PROGRAM)


def fresh_folder():
    """An empty working folder, made the current one."""
    shutil.rmtree(FOLDER, ignore_errors=True)
    os.makedirs(FOLDER)
    os.chdir(FOLDER)


def run(*arguments, environment=None):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                          timeout=240, env=environment)


def draw(*arguments):
    """Runs a job that must succeed."""
    done = run(*arguments)
    assert done.returncode == 0, done.stderr
    return done


def refused(message, *arguments):
    """Runs a job that must be refused with one line that holds the message, and leave nothing."""
    before = sorted(os.listdir("."))
    done = run(*arguments)
    assert done.returncode == 2, (arguments, done.returncode, done.stderr)
    assert done.stderr.count("\n") == 1 and done.stderr.startswith(NAME + ": "), done.stderr
    assert message in done.stderr, (message, done.stderr)
    assert done.stdout == ""
    assert sorted(os.listdir(".")) == before, "something was written"


def write_sphere(name, with_array=True):
    """A sphere as .vtp; the array "height" is its z from -1 to 1."""
    source = vtk.vtkSphereSource()
    source.SetRadius(1.0)
    source.SetThetaResolution(48)
    source.SetPhiResolution(24)
    source.Update()
    sphere = source.GetOutput()
    if with_array:
        height = numpy_to_vtk(vtk_to_numpy(sphere.GetPoints().GetData())[:, 2], deep=True)
        height.SetName("height")
        sphere.GetPointData().AddArray(height)
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetInputData(sphere)
    writer.SetFileName(name)
    writer.Write()


def write_volume(name):
    """The distance to the centre on a small grid as .vti."""
    source = vtk.vtkRTAnalyticSource()
    source.SetWholeExtent(-8, 8, -8, 8, -8, 8)
    writer = vtk.vtkXMLImageDataWriter()
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(name)
    writer.Write()


def picture(name):
    """Pixels as an array [row from the bottom, column, channel], 0 to 1."""
    reader = vtk.vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1) / 255.0


def ink(pixels):
    """Mean linear coverage by black on white."""
    return float((1.0 - pixels ** 2.2).mean())
