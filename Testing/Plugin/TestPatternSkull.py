# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The skull in all styles: ink where Surface has none, and the picture that plain VTK draws."""

import glob
import os
import subprocess
import sys

import numpy
import pattern_scene as scene
from paraview import simple
from paraview.vtk.vtkIOImage import vtkPNGReader

STYLES = {"hatch": "Pattern", "cross-hatch": "Pattern", "halftone": "Pattern", "gabor": "Noise", "phasor": "Noise",
          "stipple": "Stipple"}
# Mean difference from VTK in levels, and pixels that differ by more than 16. Depth ranges differ, so that
# single pixels of outlines do; the same strokes half a pixel aside differ by 4 levels.
MEAN = 0.1
PIXELS = 60

reader = simple.XMLImageDataReader(FileName=[os.path.join(scene.data_folder, "skull.vti")])
skull = simple.Contour(Input=reader, ContourBy=["POINTS", "value"], Isosurfaces=[2.9])
skull.UpdatePipeline()
bounds = numpy.array(skull.GetDataInformation().GetBounds()).reshape(3, 2)
center = bounds.mean(axis=1)
position = center + (bounds[:, 1] - bounds[:, 0]).max() * numpy.array([0.7, -2.4, 0.4])
up = (0.0, 0.0, 1.0)


def draw(name, **properties):
    """A picture of the skull in a view of its own."""
    where = scene.view((480, 360))
    display = scene.show(skull, where, **properties)
    scene.look(where, position, center, up)
    shown = scene.picture(where, name)
    size = shown.shape[1], shown.shape[0]
    simple.Delete(where)
    return shown, size


surface, size = draw("paraview-surface", Representation="Surface")
pictures = {}
for style, kind in STYLES.items():
    pictures[style], _ = draw("paraview-" + style, **{"Representation": kind, kind + "Style": style})
object_pixels = (surface != 128).any(axis=2)
for style, shown in pictures.items():
    assert scene.difference(shown, surface) > 10, style + " looks like Surface"
    ink = (shown[object_pixels].max(axis=1) < 100).mean()
    paper = (shown[object_pixels].min(axis=1) > 200).mean()
    assert ink > 0.1 and paper > 0.3, "%s: ink %.3f, paper %.3f" % (style, ink, paper)
    assert (shown[~object_pixels] == 128).mean() > 0.98, style + " draws beside the surface"

# The same with plain VTK, in a process of its own: two copies of VTK cannot share one.
build = os.environ.get("HACHURE_VTK_BUILD", "")
packages = glob.glob(os.path.join(build, "lib", "python3*", "*", "hachure"))
if not packages:
    print("not compared with VTK: no package hachure in '%s'; build the preset vtk first" % build)
    sys.exit(125)
surface_file = os.path.join(scene.output_folder, "skull.vtp")
simple.SaveData(surface_file, proxy=skull)
vector = lambda values: ",".join(repr(float(value)) for value in values)
environment = dict(os.environ, PYTHONPATH=os.path.dirname(packages[0]))
command = [os.path.join(os.path.dirname(os.path.abspath(__file__)), "draw_with_vtk.py"), surface_file]
command += [str(size[0]), str(size[1]), vector(position), vector(center), vector(up), "30", scene.output_folder]
subprocess.run(["/usr/bin/python3"] + command + list(STYLES), check=True, env=environment, timeout=100)
for style in STYLES:
    png = vtkPNGReader()
    png.SetFileName(os.path.join(scene.output_folder, "vtk-%s.png" % style))
    png.Update()
    with_vtk = scene.array(png.GetOutput())
    mean = scene.difference(pictures[style], with_vtk)
    differing = (numpy.abs(pictures[style].astype(int) - with_vtk).max(axis=2) > 16).sum()
    print("%s: mean difference from VTK %.4f levels, %d pixels differ" % (style, mean, differing))
    assert mean < MEAN and differing < PIXELS, style
