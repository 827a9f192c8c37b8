#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# bash Testing/run.sh: installs what is missing, builds for VTK, for ParaView and with sanitizers, runs
# every check and test, prints one summary. Exit code 0 when everything passed.

set -u -o pipefail
cd "$(dirname "$0")/.." || exit 1
logs=build/logs
mkdir -p "$logs"
jobs=$(nproc)
failures=()
rows=()
export OMP_WAIT_POLICY=passive
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export GIT_CONFIG_COUNT=1 GIT_CONFIG_KEY_0=safe.directory GIT_CONFIG_VALUE_0=$PWD
if command -v ccache >/dev/null; then
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi

packages=(
  g++ cmake ninja-build libvtk9-dev paraview-dev libglm-dev libcairo2-dev libgtest-dev
  xvfb xauth libgl1-mesa-dri openmpi-bin libqt5svg5 chromium
  clang-format clang-tidy libomp-dev codespell glslang-tools git librsvg2-bin poppler-utils
)

# step NAME COMMAND...: runs the command with its output in a log; the end of the log is shown if it fails.
step()
{
  local name=$1 start=$SECONDS result=passed
  shift
  printf '%-28s ' "$name ..."
  if ! "$@" >"$logs/$name.log" 2>&1; then
    result=FAILED
    failures+=("$name: see $PWD/$logs/$name.log")
  fi
  printf '%s, %d s\n' "$result" $((SECONDS - start))
  rows+=("$(printf '%-28s %-8s %5d s' "$name" "$result" $((SECONDS - start)))")
  if [ "$result" = FAILED ]; then
    # Compilers say what is wrong before the end of the log; tests say it in it.
    grep -E '(^|[^A-Za-z])error:|CMake Error|\*\*\*(Failed|Timeout|Exception)' "$logs/$name.log" | head -20
    tail -30 "$logs/$name.log"
    return 1
  fi
}

build()
{
  local preset=$1
  shift
  step "configure-$preset" cmake --preset "$preset" -DHACHURE_STRICT=ON -DHACHURE_BUILD_TESTING=ON &&
    step "build-$preset" cmake --build "build/$preset" --parallel "$jobs" "$@"
}

# All tests of a build share one display.
run_tests()
{
  local preset=$1
  shift
  step "test-$preset" Testing/with_display.sh ctest --test-dir "build/$preset" --parallel "$jobs" \
    --output-on-failure --no-tests=error --output-junit "$PWD/$logs/$preset.xml" "$@"
}

summary()
{
  echo
  echo "Summary"
  printf '  %s\n' "${rows[@]}"
  local preset attribute counts
  for preset in vtk sanitize paraview; do
    if [ -e "$logs/$preset.xml" ]; then
      counts=
      for attribute in tests failures skipped; do
        counts+=" $(sed -n "s/.*\b$attribute=\"\([0-9]*\)\".*/\1/p" "$logs/$preset.xml" | head -1) $attribute,"
      done
      echo "  $preset:${counts%,}"
      sed -n 's/.*<testcase name="\([^"]*\)".*status="notrun".*/    not run: \1/p
              s/.*<testcase name="\([^"]*\)".*status="fail".*/    failed: \1/p' "$logs/$preset.xml"
    fi
  done
  if [ ${#failures[@]} -gt 0 ]; then
    printf '  FAILED %s\n' "${failures[@]}"
    echo "  after $((SECONDS / 60)) min $((SECONDS % 60)) s"
    exit 1
  fi
  echo "  everything passed in $((SECONDS / 60)) min $((SECONDS % 60)) s"
  exit 0
}

rm -f "$logs"/*.xml
step packages bash Testing/install_packages.sh "${packages[@]}" || summary
if ! step display Testing/with_display.sh /usr/bin/python3 Testing/check_display.py; then
  echo "error: no OpenGL context. With no screen, install xvfb and libgl1-mesa-dri; with one, check DISPLAY." >&2
  summary
fi
build vtk && run_tests vtk
build sanitize --target hachure-sanitized && run_tests sanitize
build paraview && run_tests paraview
summary
