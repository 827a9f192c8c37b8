#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# with_display.sh COMMAND [ARGUMENT...]: runs COMMAND on the display that is there, else on a virtual one.
# -noreset: without it the virtual server resets when its last client leaves and refuses the next one.

if [ -n "$DISPLAY" ]; then
  exec "$@"
fi
if ! command -v xvfb-run >/dev/null; then
  echo "error: no display and no xvfb-run; set DISPLAY or install the packages xvfb and xauth" >&2
  exit 1
fi
exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$@"
