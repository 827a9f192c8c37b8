#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# walls.sh FOLDER: the rules that keep the parts of the project apart. Prints every line that breaks one.
. "$(dirname "$0")/files.sh"
cd "$1" || exit 2
broken=0

# refuse RULE PATTERN FILE...: no line of the files may match the pattern.
refuse()
{
  local rule=$1 pattern=$2
  shift 2
  if [ $# -gt 0 ] && grep -nHE "$pattern" "$@"; then
    echo "broken rule: $rule" >&2
    broken=1
  fi
}

mapfile -t core < <(list_files 'Filters/Core/*.h' 'Filters/Core/*.cxx' 'Filters/Core/*.glsl')
refuse "the core knows nothing of VTK" '#[[:space:]]*include[[:space:]]*[<"](.*/)?vtk' "${core[@]}"

mapfile -t parallel < <(list_files '*.h' '*.cxx' | grep -v '^Filters/Core/Parallel\.h$')
refuse "OpenMP only in Filters/Core/Parallel.h" '#[[:space:]]*pragma[[:space:]]+omp|_Pragma\("omp' "${parallel[@]}"

mapfile -t drawing < <(list_files '*.h' '*.cxx' | grep -E '^(Filters|Rendering|Plugin|Examples)/')
refuse "shader text only in .glsl files" \
  '"[^"]*(#version +[0-9]|\bgl_[A-Z][A-Za-z]+|\b(uniform|varying|attribute|in|out)[[:space:]]+(highp[[:space:]]+)?(float|u?int|[iub]?vec[234]|mat[234]|[iu]?sampler[A-Z0-9][A-Za-z0-9]*)\b|\btexelFetch\(|\btexture(Lod)?\(|\b[iu]?vec[234][[:space:]]*\()' \
  "${drawing[@]}"

mapfile -t kernels < <(list_files 'Filters/Core/Kernels/*.glsl')
if [ ${#kernels[@]} -gt 0 ]; then
  refuse "kernels are pure: no uniform, texture, derivative or out argument" \
    '^[^/]*\b(uniform|sampler2D|texture|texelFetch|textureLod|dFdx|dFdy|fwidth|inout|out)\b' "${kernels[@]}"
  refuse "kernels are ASCII" "$(printf '[^\t -~]')" "${kernels[@]}"
fi

mapfile -t sources < <(list_files '*.h' '*.cxx')
for file in "${sources[@]}"; do
  if ! head -2 "$file" | grep -q 'SPDX-License-Identifier: BSD-3-Clause'; then
    echo "$file:1: no licence line"
    echo "broken rule: every source file begins with its licence" >&2
    broken=1
  fi
done

exit $broken
