#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# newer_vtk.sh FOLDER BUILD: the filters and the rendering compile with the headers of another VTK, syntax
# only. HACHURE_NEWER_VTK_INCLUDE lists its include folders, separated by colons: the single one of an
# installation, or all of a configured source and build tree. BUILD holds our own generated headers.
# Exit code 125: there is nothing to compile with.
. "$(dirname "$0")/files.sh"
cd "$1" || exit 2
build=$2
if [ -z "$HACHURE_NEWER_VTK_INCLUDE" ]; then
  echo "skipped (125): HACHURE_NEWER_VTK_INCLUDE names no VTK headers"
  exit 125
fi
if [ ! -e "$build/Rendering/HachureRenderingModule.h" ]; then
  echo "skipped (125): $build holds no configured build"
  exit 125
fi

# VTK's targets say that its FFT computes in double, and vtkFFT.h does not compile otherwise.
flags=(-std=c++17 -fopenmp -Wall -Wextra -Wshadow -Werror -Dkiss_fft_scalar=double)
IFS=: read -r -a folders <<<"$HACHURE_NEWER_VTK_INCLUDE"
found=
for folder in "${folders[@]}"; do
  flags+=(-isystem "$folder")
  if [ -e "$folder/vtkObject.h" ]; then
    found=1
  fi
done
if [ -z "$found" ]; then
  echo "HACHURE_NEWER_VTK_INCLUDE: no vtkObject.h in '$HACHURE_NEWER_VTK_INCLUDE'" >&2
  exit 1
fi
for folder in "$build/Filters" "$build/Rendering" Filters Filters/Core Rendering Rendering/Layers \
  Rendering/Layers/*/ Rendering/Widgets; do
  flags+=(-I "$folder")
done

mapfile -t sources < <(list_files '*.cxx' | grep -E '^(Filters|Rendering)/' | grep -v '^Filters/Core/')
printf '%s\n' "${sources[@]}" |
  xargs -P "$(nproc)" -n 1 "${CXX:-c++}" -fsyntax-only "${flags[@]}" || exit 1
echo "${#sources[@]} files compile"
