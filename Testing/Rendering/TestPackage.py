# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package of this build imports, and refuses another VTK than its own."""

import subprocess
import sys

import hachure
import vtkmodules.vtkCommonCore as core

assert hachure.__version__
assert callable(hachure.style)

# A process of its own, in which VTK claims to be another version.
script = (
    "import vtkmodules.vtkCommonCore as core\n"
    "core.vtkVersion = type('vtkVersion', (), {'GetVTKVersion': staticmethod(lambda: '0.0.0')})\n"
    "import hachure\n"
)
result = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
assert result.returncode != 0, "another VTK was accepted"
expected = "hachure was built for VTK " + core.vtkVersion.GetVTKVersion()
assert expected in result.stderr and "this Python has VTK 0.0.0" in result.stderr, result.stderr
