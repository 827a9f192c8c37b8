# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of ParaView's real window share: it plays steps there, see steps.py, and compares pictures.

Arguments of a test: the program paraview, the folder of plugins, then -T with the folder to write to and -V with
the folder of baseline pictures.
"""

import json
import os
import shutil
import subprocess
import sys

import steps

try:
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader
except ImportError as missing:
    print("pictures cannot be read: %s" % missing)
    sys.exit(125)

NAME = os.path.splitext(os.path.basename(sys.argv[0]))[0]
PARAVIEW, PLUGINS = sys.argv[1:3]
OPTIONS = dict(zip(sys.argv[3::2], sys.argv[4::2]))
OUTPUT = os.path.join(OPTIONS["-T"], NAME)
SIZE = (240, 180)
ALLOWED = 10  # pixels on edges, by the rounding of other processors
shutil.rmtree(OUTPUT, ignore_errors=True)
os.makedirs(OUTPUT)


def picture(name):
    """Saves the view as a picture, see shown()."""
    return steps.picture(os.path.join(OUTPUT, name + ".png"), SIZE)


def write(name, content):
    """Writes JSON to a file of the output folder, and returns its whole name."""
    file_name = os.path.join(OUTPUT, name)
    with open(file_name, "w", encoding="ascii") as file:
        json.dump(content, file)
    return file_name


def play(*played):
    """Plays steps in a window of a user who never had one before, and returns what it printed."""
    os.makedirs(OUTPUT + "/home")
    script = os.path.join(OUTPUT, NAME + ".xml")
    steps.write(script, played)
    environment = dict(os.environ, HOME=OUTPUT + "/home", XDG_CONFIG_HOME="", PV_PLUGIN_PATH=PLUGINS)
    command = [PARAVIEW, "-geometry", "1000x700+0+0", "--dr", "--exit"]
    command += ["--test-directory=" + OUTPUT, "--test-script=" + script]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    printed = done.stdout + done.stderr
    assert done.returncode == 0, "exit code %d:\n%s" % (done.returncode, printed)
    return printed


def pixels(file_name):
    """A picture as an array height x width x 3 of bytes, rows upwards."""
    reader = vtkPNGReader()
    reader.SetFileName(file_name)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return values.reshape(height, width, -1)[:, :, :3].astype(int)


def shown(name):
    """A picture that was saved."""
    return pixels(os.path.join(OUTPUT, name + ".png"))


def differing(first, second):
    """Pixels that differ by more than 16 levels."""
    return int((numpy.abs(first - second).max(axis=2) > 16).sum())


def compare(name):
    """Compares a picture with its baseline, the file NAME-name.png."""
    baseline = os.path.join(OPTIONS["-V"], "%s-%s.png" % (NAME, name))
    assert os.path.exists(baseline), "no baseline: compare %s by eye and copy it to %s" % (name, baseline)
    count = differing(shown(name), pixels(baseline))
    assert count <= ALLOWED, "%s: %d pixels differ from the baseline" % (name, count)
