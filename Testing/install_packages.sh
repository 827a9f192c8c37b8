#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# install_packages.sh PACKAGE...: installs the Debian packages that are missing, as root or with sudo.

missing=()
for package in "$@"; do
  if ! dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed'; then
    missing+=("$package")
  fi
done
if [ ${#missing[@]} -eq 0 ]; then
  exit 0
fi
if ! command -v apt-get >/dev/null; then
  echo "error: this is not a Debian system; install what these Debian packages hold, then run again:" >&2
  echo "  ${missing[*]}" >&2
  exit 1
fi
administrator=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "error: packages are missing and there is no sudo; as root, run:" >&2
    echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  administrator=(sudo)
fi
echo "installing ${#missing[@]} packages: ${missing[*]}"
log=$(mktemp)
# Asks nothing: configuration questions get their default answers.
install() { "${administrator[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "$@" >>"$log" 2>&1; }
if ! { install update -q && install install -q -y --no-install-recommends "${missing[@]}"; }; then
  tail -15 "$log" >&2
  echo "error: installing failed, see above and $log; check the network and the package sources, then run:" >&2
  echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
  exit 1
fi
rm -f "$log"
