# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""window_pictures.py [FOLDER [NAME...]]: draws the pictures of ParaView's window in Plugin/README.md.

Plays the steps of a user in the real window on a virtual screen, with the plugin of build/paraview (or of
$HACHURE_BUILD), into its own folder or FOLDER. Needs the packages paraview and xvfb, and libqt5svg5 for the
icons of the window.
"""

import os
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "../..")
sys.path.insert(0, os.path.join(ROOT, "Testing/Plugin/Window"))

import screen  # pylint: disable=wrong-import-position
import steps  # pylint: disable=wrong-import-position

SIZE = (1200, 760)
PLAYED = "is finished"  # what ParaView says after the last step
STILL = 60.0  # seconds without a change on the screen; dialogs keep ParaView from saying that it has played
LIMIT = 300.0  # seconds that the steps may take

SEARCH = steps.PANEL + "SearchBox/SearchLineEdit"

skull = [
    steps.open_file(os.path.join(ROOT, "Examples/Data/skull.vti")),
    steps.apply(),
    steps.menu("menuFilters", "Common", "Contour"),
    steps.apply(),
]
turned = [
    steps.click(steps.MAIN + "pipelineBrowserDock/pipelineBrowser", "14,10,/0:0/0:1"),  # the eye of the file
    steps.event(steps.MAIN + "cameraToolbar/actionPositiveY", "activate"),
    steps.drag((0.5, 0.5), (0.4, 0.46)),
    steps.event(steps.MAIN + "cameraToolbar/actionZoomToData", "activate"),
]
PICTURES = {
    "window-surface": skull,
    "window-pattern": skull + turned + [steps.represent("Pattern")],
    "window-search": skull + turned + [steps.represent("Noise"), steps.event(SEARCH, "set_string", "noise")],
    "window-menu": skull + turned + steps.open_menu("menuFilters", "Hachure"),
}


def start(display, name, home):
    """Starts ParaView, which plays the steps of a picture; its process and the name of its log."""
    script = os.path.join(home, name + ".xml")
    steps.write(script, PICTURES[name])
    build = os.environ.get("HACHURE_BUILD", os.path.join(ROOT, "build/paraview"))
    plugins = os.path.abspath(os.path.join(build, "lib/paraview-5.11/plugins"))
    environment = dict(os.environ, DISPLAY=display, HOME=home, XDG_CONFIG_HOME="", PV_PLUGIN_PATH=plugins)
    log_name = os.path.join(home, name + ".log")
    command = ["paraview", "-geometry", "%dx%d+0+0" % SIZE, "--dr", "--test-script=" + script]
    with open(log_name, "w", encoding="utf-8") as log:
        return subprocess.Popen(command, env=environment, stdout=log, stderr=subprocess.STDOUT), log_name


def when_still(virtual, process, log_name):
    """The screen when the steps are played and nothing changes any more."""
    begin = since = time.monotonic()
    before = virtual.pixels()
    while True:
        time.sleep(0.5)
        now, pixels = time.monotonic(), virtual.pixels()
        if (pixels != before).any():
            since, before = now, pixels
        with open(log_name, encoding="utf-8") as log:
            printed = log.read()
        if "Success =  false" in printed or process.poll() is not None or now - begin > LIMIT:
            sys.exit("error: the steps were not played:\n" + printed)
        still = STILL if PLAYED not in printed else STILL / 15
        if "Playing" in printed and now - since > still and (pixels != pixels[0, 0]).any():
            return pixels


def main(folder, names):
    """Draws the pictures of these names, or all."""
    os.makedirs(folder, exist_ok=True)
    virtual = screen.VirtualScreen(*SIZE)
    try:
        for name in names or PICTURES:
            with tempfile.TemporaryDirectory() as home:
                process, log_name = start(virtual.display, name, home)
                file_name = os.path.join(folder, name + ".png")
                try:
                    screen.write_png(file_name, when_still(virtual, process, log_name))
                finally:
                    process.kill()
                    process.wait()
            print("%s: %d bytes" % (file_name, os.path.getsize(file_name)))
    finally:
        virtual.close()


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else HERE, sys.argv[2:])
