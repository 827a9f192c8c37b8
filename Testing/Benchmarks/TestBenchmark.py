# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""hachure-benchmark on a small surface prints rows with all keys; bad arguments have their line."""

import json
import os
import shutil
import subprocess
import sys

PROGRAM, FOLDER = sys.argv[1:3]
KEYS = {"layer", "config", "triangles", "patches", "width", "height", "plain_cpu_ms", "pattern_cpu_ms",
        "cpu_ratio", "wall_ratio", "gpu_ms", "memory_bytes"}
STATED = ("style cross-hatch", "surface covers", "memory_bytes is", "gpu_ms")

shutil.rmtree(FOLDER, ignore_errors=True)
os.makedirs(FOLDER)
os.chdir(FOLDER)


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=240)


def refused(message, *arguments):
    done = run(*arguments)
    assert done.returncode == 2, (arguments, done.returncode, done.stderr)
    assert done.stderr.count("\n") == 1 and done.stderr.startswith("hachure-benchmark: ")
    assert message in done.stderr, (message, done.stderr)
    assert done.stdout == "" and not os.listdir("."), os.listdir(".")


def positive(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and value > 0


assert run("--help").stdout.startswith("usage: hachure-benchmark")
refused("unknown option '--bogus'", "--bogus")
refused("--frames needs a value", "--frames")
refused("unknown layer 'oil'; known: image", "--layer", "oil")
refused("no layer given", "--layer", "")
refused("bad value '1.5' for --frames: expected a whole number", "--frames", "1.5")
refused("bad value '99' for --triangles", "--triangles", "1000,99")
refused("bad value '8x8' for --size: expected WxH", "--size", "8x8")
refused("cannot use style 'scribble'", "--style=scribble", "--json=a.json")
refused("cannot use style 'none.json'", "--style", "none.json")
refused("cannot write 'none/a.json'", "--json", "none/a.json")

done = run("--layer", "image", "--triangles", "1000", "--size", "160x90", "--frames", "1",
           "--json", "rows.json")
assert done.returncode == 0, done.stderr
rows = json.loads(done.stdout)
assert os.listdir(".") == ["rows.json"]
with open("rows.json", encoding="ascii") as written:
    assert json.load(written) == rows
assert len(rows) == 1
row = rows[0]
assert set(row) == KEYS, set(row) ^ KEYS
assert (row["layer"], row["width"], row["height"]) == ("image", 160, 90)
assert 500 < row["triangles"] < 2000, row["triangles"]
for key in ("plain_cpu_ms", "pattern_cpu_ms", "cpu_ratio", "wall_ratio"):
    assert positive(row[key]), (key, row[key])
assert row["gpu_ms"] is None or positive(row["gpu_ms"])
assert isinstance(row["memory_bytes"], int) and row["memory_bytes"] >= 0
for text in STATED:
    assert text in row["config"], (text, row["config"])
covered = float(row["config"].split("surface covers ")[1].split(" %")[0])
assert 20 < covered < 36, covered
