#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# lint.sh FOLDER BUILD: clang-tidy finds nothing in the C++ files that changed since the main branch, or,
# on the main branch, in the last commit. BUILD holds compile_commands.json. Exit code 125: nothing to do.
. "$(dirname "$0")/files.sh"
cd "$1" || exit 2
database=$2/compile_commands.json
if ! git rev-parse -q --verify HEAD >/dev/null 2>&1 || [ ! -e "$database" ]; then
  echo "not a checkout, or no $database"
  exit 125
fi
base=$(git merge-base HEAD origin/main 2>/dev/null || true)
if [ -z "$base" ] || [ "$base" = "$(git rev-parse HEAD)" ]; then
  base=$(git rev-parse -q --verify HEAD~1 || true)
fi
if [ -n "$base" ]; then
  changed=$(git diff --name-only --diff-filter=d "$base" -- '*.cxx')
else
  changed=$(list_files '*.cxx')
fi
files=()
for file in $changed; do
  # Only what this build compiles has flags to be checked with.
  if grep -qF "\"file\": \"$PWD/$file\"" "$database"; then
    files+=("$file")
  fi
done
if [ ${#files[@]} -eq 0 ]; then
  echo "no C++ file changed"
  exit 125
fi
printf '%s\n' "${files[@]}" |
  xargs -P "$(nproc)" -n 1 clang-tidy --quiet -p "$2" \
    --extra-arg=-Wno-unknown-warning-option --extra-arg=-Qunused-arguments 2>/dev/null
