#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# bash Examples/gallery.sh [FOLDER]: draws the pictures of README.md with the program and the Python
# package of build/vtk (or of $HACHURE_BUILD) into Examples/Gallery or FOLDER.

set -eu -o pipefail
cd "$(dirname "$0")/.."
build=${HACHURE_BUILD:-build/vtk}
gallery=${1:-Examples/Gallery}
program=$build/bin/hachure-render
skull=(Examples/Data/skull.vti --isovalue 2.9)
export OMP_WAIT_POLICY=passive

if [ ! -x "$program" ]; then
  echo "error: no $program; run bash Examples/run.sh first, it builds it" >&2
  exit 1
fi
if [ -z "${DISPLAY:-}" ]; then
  # All pictures share one virtual display.
  exec Testing/with_display.sh bash Examples/gallery.sh "$@"
fi
mkdir -p "$gallery"
frames=$(mktemp -d)
trap 'rm -rf "$frames"' EXIT

# draw ARGUMENT...: runs the program; its frames are then in $frames.
draw()
{
  rm -f "$frames"/*
  if ! "$program" "$@" --output "$frames" 2>"$frames/log"; then
    cat "$frames/log" >&2
    exit 1
  fi
}

# keep NAME [FRAME]: makes a frame of the last drawing a picture of the gallery.
keep()
{
  cp "$frames/$(printf 'frame_%04d.png' "${2:-0}")" "$gallery/$1.png"
  echo "$gallery/$1.png"
}

for style in hatch cross-hatch halftone; do
  draw "${skull[@]}" --style "$style" --size 360x420
  keep "skull-$style"
done

draw Examples/Data/etopo60.cdf --style Examples/Styles/relief.json --size 340x340
keep relief

for motion in turn zoom; do
  draw "${skull[@]}" --animation "Examples/Gallery/$motion.json" --size 240x280
  for frame in 0 12 24 36; do
    keep "$motion-$frame" "$frame"
  done
done

package=$(echo "$build"/lib*/python3*/*-packages)
PYTHONPATH="$package" /usr/bin/python3 Examples/Python/first_picture.py "$gallery/first-picture.png"
echo "$gallery/first-picture.png"

# The figures of the paper; some print how far patterns slide.
for figure in travelling patches elongated painting table skulls landscape engraving \
  stipple_light stipple_moving stipple_refined stipple_uncertainty pattern_legend; do
  PYTHONPATH="$package" /usr/bin/python3 "Examples/Figures/$figure.py" "$gallery/$figure.png"
  echo "$gallery/$figure.png"
done
# The photographs are of the skull even where the scan is that fetch.sh fetches.
for figure in view_distance view_photographs view_layers; do
  PYTHONPATH="$package" /usr/bin/python3 "Examples/Figures/$figure.py" "$gallery/$figure.png" skull
  echo "$gallery/$figure.png"
done
for row in 0 1; do
  PYTHONPATH="$package" /usr/bin/python3 Examples/Figures/view_scales.py "$gallery/view_scales-$row.png" "$row"
  echo "$gallery/view_scales-$row.png"
done
for row in 0 1 2; do
  PYTHONPATH="$package" /usr/bin/python3 Examples/Figures/noise_styles.py "$gallery/noise_styles-$row.png" "$row"
  echo "$gallery/noise_styles-$row.png"
done
