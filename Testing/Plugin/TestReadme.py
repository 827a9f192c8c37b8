# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The README's script for pvbatch draws, with the plugin found through PV_PLUGIN_PATH."""

import os
import pathlib
import re
import sys

import numpy
from paraview.vtk.util.numpy_support import vtk_to_numpy
from paraview.vtk.vtkIOImage import vtkPNGReader

root = pathlib.Path(__file__).resolve().parents[2]
output = os.path.join(os.path.abspath(sys.argv[sys.argv.index("-T") + 1]), "readme-skull.png")
text = (root / "README.md").read_text(encoding="utf-8")
scripts = re.findall(r"^```python\n(from paraview.*?)^```$", text, re.MULTILINE | re.DOTALL)
assert len(scripts) == 1, len(scripts)
script = scripts[0].replace('"skull.png"', repr(output))
assert output in script

os.chdir(root)
if os.path.exists(output):
    os.remove(output)
exec(script, {})  # pylint: disable=exec-used

reader = vtkPNGReader()
reader.SetFileName(output)
reader.Update()
width, height, _ = reader.GetOutput().GetDimensions()
pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)
assert (height, width) == (480, 480)
assert (pixels[:30, :30] == 255).all(), "the ground is not white"
# Strokes: ink and paper in turns, and few greys between, which a shaded surface is made of.
ink = (pixels.max(axis=2) < 60).mean()
grey = ((pixels.min(axis=2) > 90) & (pixels.max(axis=2) < 190)).mean()
assert ink > 0.05 and grey < ink, "ink %.3f, grey %.3f" % (ink, grey)
turns = numpy.diff((pixels[height // 2, :, 0] < 128).astype(int)).astype(bool).sum()
assert turns > 20, turns
