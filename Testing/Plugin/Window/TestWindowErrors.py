# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A style file with a fault: the window shows the message, and draws the surface as before."""

import os

import steps
import window

BAD = {"hachure": 1, "layers": [{"type": "image", "field": {"pattern": "scribble"}}]}
MESSAGES = steps.MAIN + "outputWidgetDock"

style = window.write("bad.json", BAD)
printed = window.play(
    steps.sphere(),
    steps.represent("Pattern"),
    window.picture("before"),
    steps.check(MESSAGES, "visible", "false"),
    steps.display("PatternStyleFile/FileChooser/FileLineEdit", "set_string", style),
    steps.check(MESSAGES, "visible", "true"),
    window.picture("after"),
)
assert "ERR|" in printed and "scribble" in printed, printed
before, after = window.shown("before"), window.shown("after")
assert window.differing(before, after) == 0 and (before > 240).all(axis=2).mean() > 0.05
