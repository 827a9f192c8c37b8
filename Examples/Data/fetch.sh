#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# fetch.sh [DIR]: fetches data whose terms do not allow a copy in this repository from the packages of
# Debian 12, without installing them, into DIR; default: the folder Fetched beside this script, where
# the quality report and the figures look. Needs apt-get update once.

set -eu
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-$here/Fetched}
mkdir -p "$out"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# fetch PACKAGE FILE NAME SHA256: the file of a package under another name.
fetch() {
  if ! (cd "$work" && apt-get -qq -o APT::Sandbox::User=root download "$1"); then
    echo "fetch.sh: the package $1 cannot be downloaded; try apt-get update" >&2
    exit 1
  fi
  dpkg-deb --fsys-tarfile "$work/$1"_*.deb | tar -xO -f - "./$2" > "$work/$3"
  if ! echo "$4  $work/$3" | sha256sum --check --quiet; then
    echo "fetch.sh: $2 of the package $1 is another file than expected" >&2
    exit 1
  fi
  mv "$work/$3" "$out/$3"
  echo "$out/$3"
}

fetch calculix-cgx-examples usr/share/doc/calculix-cgx-examples/examples/result.frd blade.frd \
  73bc3b01504cb0d6f594cbf0c2c301e0b5f7167bd73f4adc1fa0fa6ecd852cc0

# A scan as InVesalius keeps it: 256 x 256 x 108 numbers of 16 bits in an archive.
scan=usr/share/doc/invesalius-examples/examples/Cranium.inv3
fetch invesalius-examples "$scan" cranium.inv3 \
  3b34f11f7c4f557f4c65cd6543c412a2f6ceb0cfecfd9c41184420e02d9b7e2a
{
  cat <<'END'
<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt32">
<ImageData WholeExtent="0 255 0 255 0 107" Origin="0 0 0" Spacing="0.9570312 0.9570312 1.5">
<Piece Extent="0 255 0 255 0 107">
<PointData Scalars="HU"><DataArray type="Int16" Name="HU" format="binary">
END
  # The number of bytes, 0xd80000, goes before them.
  { printf '\0\0\330\0'; tar -xzOf "$out/cranium.inv3" --wildcards '*/matrix.dat'; } | base64 -w0
  printf '\n</DataArray></PointData></Piece></ImageData></VTKFile>\n'
} > "$work/ct.vti"
mv "$work/ct.vti" "$out/ct.vti"
rm "$out/cranium.inv3"
echo "$out/ct.vti"
