#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# spelling.sh FOLDER: no common misspelling in any text below FOLDER.
. "$(dirname "$0")/files.sh"
cd "$1" || exit 2
list_files '*.h' '*.cxx' '*.glsl' '*.py' '*.sh' '*.md' '*.cmake' '*.txt' '*.xml' '*.json' '*.module' |
  xargs -r codespell
