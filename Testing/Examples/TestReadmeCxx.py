# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The README's project in C++ finds the installed libraries, builds and runs."""

import os
import pathlib
import shutil
import subprocess

import hachure
import readme
from rendering_program import fresh_folder

fresh_folder()
prefix = os.environ["HACHURE_PREFIX"]
assert hachure.__file__.startswith(prefix), "the package is not the installed one"
pathlib.Path("CMakeLists.txt").write_text(readme.block("cmake", "find_package"), encoding="utf-8")
pathlib.Path("picture.cxx").write_text(readme.block("cpp", "int main()"), encoding="utf-8")
shutil.rmtree("build", ignore_errors=True)
subprocess.run(["cmake", "-S", ".", "-B", "build", "-DCMAKE_BUILD_TYPE=Release",
                "-DCMAKE_PREFIX_PATH=" + prefix, "-DVTK_DIR=" + os.environ["VTK_DIR"]], check=True)
subprocess.run(["cmake", "--build", "build"], check=True)
done = subprocess.run(["build/picture"], capture_output=True, text=True, timeout=100)
assert done.returncode == 0 and done.stderr == "", done.stderr

# The script runs with the installed package, too.
exec(readme.block("python", "vtkParametricBoy"), {})  # pylint: disable=exec-used
