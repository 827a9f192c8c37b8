#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# format.sh FOLDER: every C++ file below FOLDER has the layout of .clang-format.
. "$(dirname "$0")/files.sh"
cd "$1" || exit 2
list_files '*.h' '*.cxx' | xargs -r clang-format --style=file --dry-run -Werror
