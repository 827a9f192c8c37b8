# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark of frames in ParaView, on a small surface, prints what it promises; never how long it took."""

import json
import os
import runpy
import sys

script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../Benchmarks/paraview_frames.py")
plugin, options = sys.argv[1], dict(zip(sys.argv[2::2], sys.argv[3::2]))
result = os.path.join(options["-T"], "paraview-frames.json")
LABELS = ["Surface", "Surface LIC", "Pattern"]
small = ["--triangles", "1000", "--size", "160x90", "--frames", "1", "--only", ",".join(LABELS)]
sys.argv = [script, plugin, *small, "--json", result]
runpy.run_path(script, run_name="__main__")

with open(result, encoding="ascii") as file:
    rows = json.load(file)
assert [row["representation"] for row in rows] == LABELS, rows
for row in rows:
    assert (row["ranks"], row["width"], row["height"], row["frames"]) == (1, 160, 90, 1), row
    assert 500 < row["triangles"] < 2500, row
    for key in ("cpu_ms", "wall_ms", "cpu_to_surface", "wall_to_surface", "cpu_to_surface_lic", "wall_to_surface_lic"):
        assert row[key] > 0, (row["representation"], key, row[key])
    bounds = {"within_bound_of_surface", "within_bound_of_surface_lic"}
    ours = not row["representation"].startswith("Surface")
    assert bounds & set(row) == (bounds if ours else set()), row
assert rows[0]["cpu_to_surface"] == 1 and rows[1]["cpu_to_surface_lic"] == 1, rows
