# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the README says is so: links, pictures, options, commands, the script and the style."""

import os
import re
import shlex
import subprocess

import hachure
import numpy
from vtk import vtkActor, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter
from vtk.util.numpy_support import vtk_to_numpy

import readme
from rendering_program import PROGRAM, draw, fresh_folder, picture

LARGEST_PICTURE = 110e3

fresh_folder()
pages = [readme.ROOT / name for name in ("README.md", "Plugin/README.md", "Rendering/Layers/README.md")]
for page in pages:
    for target in readme.links(page):
        assert (page.parent / target).exists(), "%s refers to %s" % (page, target)

# Paths in the text and in commands, but those of builds.
top = sorted(path.name for path in readme.ROOT.iterdir() if path.is_dir() and path.name != "build")
for page in pages:
    for path in re.findall(r"(?<![\w/])(?:%s)/[\w./-]*\w" % "|".join(map(re.escape, top)),
                           page.read_text(encoding="utf-8")):
        assert "Grain" in path or (readme.ROOT / path).exists(), "%s names %s" % (page, path)

# Every picture is shown, drawn by the command for it, and small.
shown = {os.path.normpath(page.parent / target) for page in pages for target in readme.links(page)}
gallery = sorted((readme.ROOT / "Examples/Gallery").glob("*.png"))
gallery += sorted((readme.ROOT / "Examples/ParaView").glob("*.png"))
assert {name for name in shown if name.endswith(".png")} == {str(path) for path in gallery}, shown
programs = ("Examples/gallery.sh", "Examples/ParaView/window_pictures.py")
command = "".join((readme.ROOT / name).read_text(encoding="utf-8") for name in programs)
for path in gallery:
    stem = re.split(r"-[\d]+$", path.stem)[0]
    assert stem in command or stem.startswith("skull-"), "no command draws %s" % path
    assert path.stat().st_size < LARGEST_PICTURE, path
    assert 0.01 < (picture(str(path)) < 0.9).mean() < 0.95, "%s is empty" % path

# The options of the README and of --help are the same.
help_options = set(re.findall(r"^  (--[\w-]+)", draw("--help").stdout, re.MULTILINE))
table = "\n".join(line for line in readme.TEXT.splitlines() if line.startswith("| `--"))
assert set(re.findall(r"--[\w-]+", table)) == help_options, help_options
for style in draw("--list-styles").stdout.split():
    assert "`%s`" % style in table, style

# The properties of the plugin's page are those that ParaView shows.
xml = (readme.ROOT / "Plugin/Representations/PatternRepresentation.xml").read_text(encoding="utf-8")
plugin_page = pages[1].read_text(encoding="utf-8")
rows = "\n".join(line for line in plugin_page.splitlines() if line.startswith("| `Pattern"))
assert set(re.findall(r"`(\w+)`", rows)) == set(re.findall(r'VectorProperty name="(\w+)"', xml)), rows

# Its commands draw.
commands = [line for code in readme.blocks("sh") for line in code.splitlines()
            if line.startswith("hachure-render ")]
assert len(commands) >= 5
for line in commands:
    words = [str(readme.ROOT / word) if word.startswith("Examples/") else word
             for word in shlex.split(line)[1:]]
    if "--orbit" in words:
        words[words.index("--orbit") + 1] = "3"
    draw(*words, "--size", "64x48", "--supersample", "1", "--output", "frames")

# The script: its lines are those of first_picture.py, and draw strokes.
script = readme.block("python", "vtkParametricBoy")
whole = (readme.ROOT / "Examples/Python/first_picture.py").read_text(encoding="utf-8")
for line in filter(None, script.splitlines()):
    assert line == "window.Render()" or line + "\n" in whole, line
names = {}
exec(script, names)  # pylint: disable=exec-used
grab = vtkWindowToImageFilter()
grab.SetInput(names["window"])
grab.Update()
image = grab.GetOutput()
width, height, _ = image.GetDimensions()
pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
dark = pixels[height // 2].mean(axis=1) < 128
light = pixels[height // 2].mean(axis=1) > 250
assert dark.any() and light.any() and numpy.diff(light.astype(int)).astype(bool).sum() > 10

# The views that the command writes are drawn by the script that reads them.
program = os.path.join(os.path.dirname(PROGRAM), "hachure-views")
skull = str(readme.ROOT / "Examples/Data/skull.vti")
subprocess.run([program, skull, "--isovalue", "2.9", "--orbit", "6", "--size", "128x128", "--output", "views"],
               check=True, timeout=200)
names = {}
exec(readme.block("python", "ReadManifest").replace("Examples/Data/skull.vti", skull), names)  # pylint: disable=exec-used
assert names["mapper"].GetStyle().GetLayer(0).GetViews().GetNumberOfViews() == 6
sheet = vtkRenderer()
actor = vtkActor()
actor.SetMapper(names["mapper"])
sheet.AddActor(actor)
sheet.SetBackground(0, 0, 1)
window = vtkRenderWindow()
window.AddRenderer(sheet)
window.Render()
grab.SetInput(window)
grab.Update()
image = grab.GetOutput()
pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(-1, 3).astype(int)
bone = pixels[pixels[:, 0] > 0]
assert len(bone) > 0.1 * len(pixels) and (numpy.ptp(bone, axis=1) < 4).mean() > 0.99 and bone.std() > 5

# The style reads without a complaint, and the next reader gets the same.
style = hachure.vtkPatternStyle()
assert style.FromJson(readme.block("json", '"hachure": 1'))
layer = style.GetLayer(0)
assert style.GetNumberOfLayers() == 1 and layer.GetTone().GetArrayName() == "speed"
again = hachure.vtkPatternStyle()
assert again.FromJson(style.ToJson()) and again.ToJson() == style.ToJson()
