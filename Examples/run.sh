#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# bash Examples/run.sh: installs what is missing, builds, and draws the default animation into
# build/examples/skull. A second run does only what changed.

set -u -o pipefail
cd "$(dirname "$0")/.." || exit 1
output=build/examples/skull
stamp=build/examples/skull.stamp
program=build/vtk/bin/hachure-render
mkdir -p build/logs build/examples

job=("$program" Examples/Data/skull.vti --isovalue 2.9 --style cross-hatch
  --orbit 96 --zoom 0.6:1 --size 960x720 --output "$output" --movie)

fail()
{
  echo "error: $1" >&2
  exit 1
}

# logged NAME COMMAND...: runs quietly; shows the log where the command fails.
logged()
{
  local log=build/logs/example-$1.log
  shift
  if ! "$@" >"$log" 2>&1; then
    grep -E '(^|[^A-Za-z])error:|CMake Error' "$log" | head -20 >&2
    tail -20 "$log" >&2
    fail "'$*' failed, see above and $PWD/$log"
  fi
}

bash Testing/install_packages.sh \
  g++ cmake ninja-build libvtk9-dev libglm-dev libcairo2-dev xvfb xauth libgl1-mesa-dri || exit 1

echo "building ..."
if command -v ccache >/dev/null; then
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi
if [ ! -e build/vtk/build.ninja ]; then
  # Tests need more packages; Testing/run.sh adds them to the same build.
  logged configure cmake --preset vtk -DHACHURE_BUILD_TESTING=OFF
fi
logged build cmake --build build/vtk --parallel "$(nproc)" --target hachure-render

# What the pictures depend on: the program with its libraries, the input, the command.
state()
{
  sha256sum "$program" build/vtk/lib/libHachure*.so Examples/Data/skull.vti
  printf '%s ' "${job[@]}"
}

if [ -e "$stamp" ] && [ "$(state)" = "$(cat "$stamp")" ] && [ -e "$output/movie.ogv" ] &&
  [ -e "$output/contact.png" ] && [ "$(ls "$output"/frame_*.png 2>/dev/null | wc -l)" -eq 96 ]; then
  echo "nothing changed: $PWD/$output"
  exit 0
fi

rm -f "$stamp"
# Threads that wait shall sleep: 10 % less CPU time here.
export OMP_WAIT_POLICY=passive
logged display Testing/with_display.sh /usr/bin/python3 Testing/check_display.py
start=$SECONDS
Testing/with_display.sh "${job[@]}" || fail "drawing failed, see above"
state >"$stamp"
echo "drawn in $((SECONDS - start)) s: $PWD/$output (frames, movie.ogv, contact.png)"
