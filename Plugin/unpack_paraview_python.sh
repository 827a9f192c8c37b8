#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# unpack_paraview_python.sh FOLDER: Debian's python3-paraview conflicts with python3-vtk9, which VTK's
# development files need. Its files are needed all the same, to wrap classes and to run pvbatch's scripts,
# so unpack them into FOLDER in the version of the installed ParaView, without installing them.

set -e -o pipefail
folder=$1
if [ -z "$folder" ]; then
  echo "usage: $0 FOLDER" >&2
  exit 2
fi
if [ -e "$folder/complete" ]; then
  exit 0
fi
if ! version=$(dpkg-query -W -f '${Version}' paraview 2>/dev/null); then
  echo "error: the Debian package paraview is not installed; run: apt-get install paraview-dev" >&2
  exit 1
fi
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
if ! apt-get download -q "python3-paraview=$version" >download.log 2>&1; then
  cat download.log >&2
  echo "error: could not download python3-paraview $version; run apt-get update, or check the network" >&2
  exit 1
fi
dpkg -x python3-paraview_*.deb .
rm python3-paraview_*.deb
touch complete
