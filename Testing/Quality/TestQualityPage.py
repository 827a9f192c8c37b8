# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of the quality report in a browser: its tables are there and its strips show and play."""

import os
import re
import shutil
import subprocess
import sys
import tempfile

import vtkmodules.vtkCommonCore  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

FOLDER = os.path.dirname(os.path.abspath(__file__))
OUT = os.path.join(sys.argv[sys.argv.index("-T") + 1], "QualityPage")
PAGE = os.path.join(OUT, "quality.html")
BROWSER = shutil.which("chromium") or shutil.which("chromium-browser")
WIDTH, HEIGHT = 1280, 3600
SIDE = 160  # of a strip
SKIPPED = 125
# No profile, no network, nothing in the background.
QUIET = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--disable-dev-shm-usage",
         "--host-resolver-rules=MAP * ~NOTFOUND", "--hide-scrollbars", "--enable-logging=stderr")


def browse(page, *arguments):
    with tempfile.TemporaryDirectory() as profile:
        done = subprocess.run([BROWSER, *QUIET, "--user-data-dir=" + profile, *arguments,
                               "file://" + page], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert "CONSOLE" not in done.stderr, done.stderr
    return done.stdout


def screenshot(page, *arguments):
    name = page + ".png"
    browse(page, "--screenshot=" + name, "--window-size=%d,%d" % (WIDTH, HEIGHT), *arguments)
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
    return pixels.reshape(HEIGHT, WIDTH, -1)[::-1, :, 0]


def variant(text, name):
    path = os.path.join(OUT, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def runs(marked):
    """Lengths of the stretches in a row of booleans."""
    return [len(run) for run in re.findall("1+", "".join("01"[bool(here)] for here in marked))]


def check_dom(dom):
    for text in ("slide ratio", "similarity", "Scene: sphere", "bidirectional advection"):
        assert text in dom, text
    assert dom.count('class="strip six"') == 4 and dom.count("<polyline") == 4
    assert dom.count('<td class="best">') >= 4, "the best of a row is marked"


def check_strips(text):
    """Frames and differences stand side by side, dark where there is ink, and nowhere else is a picture."""
    still = text.replace("infinite alternate", "infinite alternate paused")
    shown = screenshot(variant(still, "still.html"))
    empty = screenshot(variant(re.sub(r"background-image:url\([^)]*\)", "", still), "empty.html"))
    assert shown.shape == empty.shape and (empty < 128).sum() > 5000, "text and tables"
    changed = abs(shown - empty) > 32
    columns, rows = runs(changed.any(axis=0)), runs(changed.any(axis=1))
    print("columns", columns, "rows", rows, "dark", (shown[changed] < 128).sum())
    assert 0.5 * 2 * SIDE < sum(columns) <= 2 * SIDE, columns
    assert 0.5 * 2 * SIDE < sum(rows) <= 2 * SIDE, rows
    assert (shown[changed] < 128).sum() > 4000, "ink in the strips"


def check_motion(text):
    """The last picture of a strip is another one than the first."""
    speed = "infinite alternate"
    first = screenshot(variant(text.replace(speed, speed + " paused"), "first.html"))
    last = screenshot(variant(text.replace(speed, "forwards paused; animation-delay: -2s"), "last.html"))
    assert (abs(first - last) > 64).sum() > 500, "strips play"


if not BROWSER:
    print("no chromium")
    sys.exit(SKIPPED)
report = [sys.executable, os.path.join(FOLDER, "report.py"), "--out", OUT, "--reduced", "--motion", "rotate"]
for axis, names in (("scene", ("sphere",)), ("field", ("screen", "similarity"))):
    report += [argument for name in names for argument in ("--" + axis, name)]
subprocess.run(report, check=True)
with open(PAGE, encoding="utf-8") as file:
    content = file.read()
check_dom(browse(PAGE, "--dump-dom"))
check_strips(content)
check_motion(content)
