# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The installed package imports and comes from the folder that it was installed to."""

import os
import sys

import hachure

prefix = os.path.realpath(sys.argv[1])
assert os.path.realpath(hachure.__file__).startswith(prefix), hachure.__file__
with open("/proc/self/maps", encoding="ascii", errors="replace") as maps:
    libraries = {line.split()[-1] for line in maps if "/libHachure" in line}
assert libraries, "no library of the project is loaded"
assert all(path.startswith(prefix) for path in libraries), libraries

style = hachure.style("cross-hatch")
assert style.GetNumberOfLayers() > 0
try:
    hachure.style("no such style")
    raise AssertionError("an unknown style was accepted")
except ValueError as error:
    assert "cross-hatch" in str(error)
