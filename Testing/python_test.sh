#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# python_test.sh PYTHON [--enable-bt] SCRIPT [ARGUMENT...]: what vtk_add_test_python calls as its interpreter.
# --enable-bt is an option of VTK's own interpreter, so drop it for the system's.

python=$1
shift
if [ "$1" = --enable-bt ]; then
  shift
fi
exec "$(dirname "$0")/with_display.sh" "$python" "$@"
