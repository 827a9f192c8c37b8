# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What hachure-views cannot use: one clear line, exit code 2, nothing written, nothing replaced."""

import os

import hachure
import vtk

from rendering_program import draw, fresh_folder, refused, run, write_sphere, write_volume

fresh_folder()
write_sphere("sphere.vtp")
write_volume("volume.vti")
with open("file", "w", encoding="ascii") as out:
    out.write("a file")
with open("bad.json", "w", encoding="ascii") as out:
    out.write('{"hachureViews": 1, "views": [{"image": "no.png", "camera":'
              ' {"position": [0, 0, 1], "focalPoint": [0, 0, 0]}}]}')

# Printing actions need no input.
assert draw("--help").stdout.startswith("usage: hachure-views")
assert draw("--version").stdout.startswith("hachure-views ")

# The command line.
refused("no input file given; try hachure-views --help")
refused("unknown option '--bogus'; try hachure-views --help", "sphere.vtp", "--bogus")
refused("--camera needs a value", "sphere.vtp", "--camera")
refused("two input files given: 'sphere.vtp' and 'b.vtp'", "sphere.vtp", "b.vtp")
refused("no camera given: --camera, --orbit, --hemisphere or --cameras", "sphere.vtp")
for option, value, expected in (
        ("--camera", "1,2,3", "X,Y,Z/X,Y,Z/X,Y,Z"), ("--camera", "1,2,3/0,0", "X,Y,Z/X,Y,Z/X,Y,Z"),
        ("--camera", "1,2,nan/0,0,0", "X,Y,Z/X,Y,Z"), ("--camera", "1,2,3/0,0,0/", "X,Y,Z/X,Y,Z"),
        ("--camera", "1,2,3/1,2,3", "a position beside the focal point"),
        ("--camera", "0,0,3/0,0,0/0,0,1", "a view up across their line"),
        ("--camera", "0,0,3/0,0,0/0,0,0", "a view up across their line"),
        ("--view-angle", "0", "degrees from 0.01 to 179"), ("--view-angle", "180", "0.01 to 179"),
        ("--orbit", "0", "whole number from 1 to 1000"), ("--orbit", "1001", "from 1 to 1000"),
        ("--hemisphere", "1.5", "whole number"), ("--size", "640", "WxH"), ("--size", "8x8", "WxH"),
        ("--kind", "both", "dependent or independent"), ("--extreme-angle", "91", "0.01 to 90"),
        ("--extreme-angle", "0", "degrees from 0.01 to 90"), ("--light", "40", "AZ,EL"),
        ("--isovalue", "high", "expected a number"), ("--up", "w", "one of x y z")):
    refused(f"bad value '{value}' for {option}", "sphere.vtp", "--orbit", 1, option, value)
    refused(expected, "sphere.vtp", "--orbit", 1, f"{option}={value}")
refused("--extreme-angle needs --kind dependent", "sphere.vtp", "--orbit", 1, "--extreme-angle", 9)
refused("are one axis", "sphere.vtp", "--orbit", 1, "--up", "y", "--front=-y")
refused("give its view up too", "sphere.vtp", "--up", "y", "--camera", "0,5,0/0,0,0")

# Inputs and folders.
refused("cannot read 'missing.vtp': No such file", "missing.vtp", "--orbit", 1)
refused("'volume.vti' is a volume: give --isovalue V", "volume.vti", "--orbit", 1)
refused("cannot use 'no.json': ", "sphere.vtp", "--cameras", "no.json")
refused("views[0].image: \"no.png\": no such file", "sphere.vtp", "--cameras", "bad.json")
refused("cannot write into 'file/views': ", "sphere.vtp", "--orbit", 1, "--output", "file/views")
refused("cannot write into '/proc/views': ", "sphere.vtp", "--orbit", 1, "--output", "/proc/views")

# A camera that is a matrix cannot be drawn from.
views, manifest = hachure.vtkTextureViews(), hachure.vtkTextureViewsManifest()
picture = vtk.vtkImageData()
picture.SetDimensions(4, 4, 1)
picture.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 3)
views.AddView("calibrated", vtk.vtkMatrix4x4(), picture)
assert manifest.Write("matrix.json", views)
refused("the view 'calibrated' of 'matrix.json' has a matrix", "sphere.vtp", "--cameras",
        "matrix.json")

# What was painted stays: an image alone, and a manifest alone.
JOB = ("sphere.vtp", "--orbit", 2, "--size", "64x48")


def state(folder):
    """All files with the times of their last change."""
    return {name: os.stat(os.path.join(folder, name)).st_mtime_ns for name in os.listdir(folder)}


for name in ("orbit-2.png", "views.json", "orbit-1-mask.png"):
    folder = "painted-" + name
    os.mkdir(folder)
    with open(os.path.join(folder, name), "w", encoding="ascii") as out:
        out.write("with care")
    before = state(folder)
    refused(f"'{folder}/{name}' is there already: --overwrite replaces it", *JOB, "--output", folder)
    assert state(folder) == before
    draw(*JOB, "--output", folder, "--overwrite")
    assert len(os.listdir(folder)) == 7 and state(folder)[name] > before[name]

# Nothing is left where there is no display.
if os.environ.get("DISPLAY"):
    done = run(*JOB, "--output", "new", environment={**os.environ, "DISPLAY": ":no"})
    assert done.returncode != 0 and not os.path.exists("new"), done.stderr
