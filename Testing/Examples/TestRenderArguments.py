# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments and inputs that cannot be used: one clear line, exit code 2, nothing written."""

import vtk

from rendering_program import draw, fresh_folder, refused, write_sphere, write_volume

fresh_folder()
write_sphere("sphere.vtp")
write_volume("volume.vti")
for name, content in (("broken.vtp", "no XML"), ("broken.stl", ""), ("file", "a file"),
                      ("bad.json", "{"), ("unknown.json", '{"hachure": 1, "lairs": []}'),
                      ("notes.txt", "")):
    with open(name, "w", encoding="ascii") as out:
        out.write(content)
empty = vtk.vtkXMLPolyDataWriter()
nothing = vtk.vtkPolyData()
nothing.SetPoints(vtk.vtkPoints())
empty.SetInputData(nothing)
empty.SetFileName("empty.vtp")
empty.Write()

# Printing actions need no input.
assert draw("--help").stdout.startswith("usage: hachure-render")
assert draw("--version").stdout.startswith("hachure-render ")
styles = draw("--list-styles").stdout.split()
assert styles[:4] == ["hatch", "cross-hatch", "halftone", "cmyk"], styles

# The command line.
refused("no input file given")
refused("unknown option '--bogus'", "sphere.vtp", "--bogus")
refused("--array needs a value", "sphere.vtp", "--array")
refused("two input files given: 'sphere.vtp' and 'b.vtp'", "sphere.vtp", "b.vtp")
for option, value, expected in (
        ("--isovalue", "high", "expected a number"), ("--isovalue", "nan", "expected a number"),
        ("--orbit", "0", "whole number"), ("--orbit", "1.5", "whole number"),
        ("--size", "640", "WxH"), ("--size", "8x8", "WxH"), ("--size", "640x480x2", "WxH"),
        ("--zoom", "0:1", "A:B"), ("--zoom", "1:2:3", "A:B"), ("--light", "40", "AZ,EL"),
        ("--light", "0,100", "AZ,EL"), ("--supersample", "9", "from 1 to 8"),
        ("--quality", "best", "interactive or final"),
        ("--up", "w", "one of x y z")):
    refused(f"bad value '{value}' for {option}", "sphere.vtp", option, value)
    refused(expected, "sphere.vtp", f"{option}={value}")
refused("--zoom A:B needs --orbit", "sphere.vtp", "--zoom", "1:2")
refused("leave out --orbit and --zoom", "sphere.vtp", "--orbit", 4, "--animation", "a.json")
refused("at most 16384", "sphere.vtp", "--size", "16384x64")
refused("are one axis", "sphere.vtp", "--up", "y", "--front=-y")

# Inputs.
refused("cannot read 'missing.vtp': No such file", "missing.vtp")
refused("unknown file type 'notes.txt'; known: .vtp", "notes.txt")
refused("cannot read 'broken.vtp'", "broken.vtp")
refused("'broken.stl'", "broken.stl")
refused("'empty.vtp' holds no points", "empty.vtp")
refused("'volume.vti' is a volume: give --isovalue V inside its scalar range [", "volume.vti")
refused("isovalue 1e+09 lies outside the scalar range [", "volume.vti", "--isovalue", "1e9")
refused("is a surface already", "sphere.vtp", "--isovalue", "1")
refused("no array 'speed' on the surface; it has: Normals, height", "sphere.vtp", "--array",
        "speed")

# Styles and folders.
refused("unknown style 'scribble'; known: hatch, cross-hatch, halftone", "sphere.vtp", "--style",
        "scribble")
refused("cannot use style file 'none.json'", "sphere.vtp", "--style", "none.json")
refused("cannot use style file 'bad.json'", "sphere.vtp", "--style", "bad.json")
refused("lairs: unknown key", "sphere.vtp", "--style", "unknown.json")
refused("cannot write into 'file/pictures': ", "sphere.vtp", "--output", "file/pictures")
refused("cannot write into '/proc/pictures': ", "sphere.vtp", "--output", "/proc/pictures")
