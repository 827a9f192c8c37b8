# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The example of an animation saves frames that differ a little from those before them."""

import os
import pathlib
import sys

import numpy
from paraview.vtk.util.numpy_support import vtk_to_numpy
from paraview.vtk.vtkIOImage import vtkPNGReader

FRAMES = 8

root = pathlib.Path(__file__).resolve().parents[2]
output = os.path.join(os.path.abspath(sys.argv[sys.argv.index("-T") + 1]), "example-animation")
os.makedirs(output, exist_ok=True)
os.chdir(root)
sys.argv = ["paraview_animation.py", os.path.join(output, "warm.png")]
script = root / "Examples/Python/paraview_animation.py"
exec(script.read_text(encoding="utf-8"), {})  # pylint: disable=exec-used


def frame(number):
    """A picture that was saved."""
    reader = vtkPNGReader()
    reader.SetFileName(os.path.join(output, "warm.%04d.png" % number))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    assert (height, width) == (240, 320)
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[:, :, 0] / 255


frames = [frame(number) for number in range(FRAMES)]
inside = [(frames[0] != frames[0][0, 0]) & (picture != picture[0, 0]) for picture in frames]
assert all(mask.mean() > 0.1 for mask in inside), [mask.mean() for mask in inside]
far = numpy.abs(frames[0] - frames[-1])[inside[-1]].mean()
near = [numpy.abs(a - b)[mask].mean() for a, b, mask in zip(frames, frames[1:], inside[1:])]
print("neighbours", numpy.round(near, 3), "first and last %.3f" % far)
assert 0 < min(near) and max(near) < 0.8 * far, (near, far)
