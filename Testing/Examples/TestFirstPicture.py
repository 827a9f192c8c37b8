# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The README's first script runs and draws separate strokes on white paper."""

import pathlib
import subprocess
import sys

from rendering_program import fresh_folder, ink, picture

fresh_folder()
examples = pathlib.Path(__file__).resolve().parents[2] / "Examples"
subprocess.run([sys.executable, examples / "Python" / "first_picture.py", "out.png"], check=True,
               timeout=200)
pixels = picture("out.png").mean(axis=2)
assert pixels.shape == (400, 400)
assert (pixels[:15, :15] == 1).all()
assert 0.02 < ink(pixels) < 0.5, ink(pixels)
# Along a line through the middle, paper and ink take turns many times.
dark = pixels[200] < 0.5
assert (dark[1:] != dark[:-1]).sum() > 20
