# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# Sourced by the checks. list_files PATTERN...: the source files below the current folder that match, as
# version control knows them, or all of them where there is none.
list_files()
{
  if [ "$(git rev-parse --show-toplevel 2>/dev/null)" = "$(pwd -P)" ]; then
    git ls-files -- "$@" | while read -r file; do
      if [ -e "$file" ]; then
        echo "$file"
      fi
    done
  else
    local pattern
    for pattern in "$@"; do
      find . -path ./build -prune -o -type f -name "$(basename "$pattern")" -print | sed 's|^\./||' |
        case "$pattern" in
          */*) grep "^$(dirname "$pattern")/" ;;
          *) cat ;;
        esac
    done
  fi
}
