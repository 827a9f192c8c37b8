#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# fetch.sh [DIR]: fetches data whose terms do not allow a copy in this repository from the packages of
# Debian 12, without installing them, into DIR; default: the folder Fetched beside this script, where
# the quality report looks. Needs apt-get update once.

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
