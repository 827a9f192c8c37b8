# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The reduced quality report: its files are whole, and patterns slide and boil as little as promised."""

import json
import os
import re
import subprocess
import sys

FOLDER = os.path.dirname(os.path.abspath(__file__))
OUT = os.path.join(sys.argv[sys.argv.index("-T") + 1], "QualityReduced")
# Largest slide ratio and median boil of the image pattern that follows by similarities.
SIMILARITY = {"translate": (0.05, 0.002), "zoom": (0.08, 0.004), "roll": (0.005, 0.002)}


def report(*arguments):
    command = [sys.executable, os.path.join(FOLDER, "report.py"), *arguments]
    return subprocess.run(command, capture_output=True, text=True)


def check_rows(rows):
    keys = {"scene", "motion", "field", "ink", "lighting", "metric", "value"}
    assert rows and all(set(row) == keys for row in rows), rows[:2]
    assert all(row["value"] is None or isinstance(row["value"], float) for row in rows)
    names = [tuple(row[key] for key in sorted(keys - {"value"})) for row in rows]
    assert len(set(names)) == len(names), "a value is there twice"


def check_page(text, clips):
    assert text.count('class="strip six"') == 2 * clips, "strips of frames and differences"
    assert text.count("data:image/png;base64,iVBORw0KGgo") == 2 * clips
    outside = re.findall(r'(?:src|href)=|url\((?!data:)|https?://', text)
    assert not outside, outside


def value(rows, motion, field, metric):
    found = [row["value"] for row in rows
             if (row["motion"], row["field"], row["metric"]) == (motion, field, metric)
             and (row["scene"], row["ink"], row["lighting"]) == ("sphere", "noise", "unlit")]
    assert len(found) == 1, (motion, field, metric, found)
    return found[0]


done = report("--out", OUT, "--reduced")
assert done.returncode == 0, done.stderr
print(done.stdout)
with open(os.path.join(OUT, "quality.json"), encoding="utf-8") as file:
    rows = json.load(file)
with open(os.path.join(OUT, "quality.html"), encoding="utf-8") as file:
    page = file.read()
check_rows(rows)
check_page(page, len({tuple(row[key] for key in ("motion", "field")) for row in rows}))

door = value(rows, "translate", "screen", "SlideRatio")
assert abs(door - 1) <= 0.01, door
for motion, (slide, boil) in SIMILARITY.items():
    assert value(rows, motion, "screen", "MeanMotion") > 1.0, "nothing moved"
    assert value(rows, motion, "similarity", "SlideRatio") <= slide, (motion, rows)
    assert value(rows, motion, "similarity", "BoilMedian") <= boil, (motion, rows)

wrong = report("--out", OUT, "--reduced", "--field", "none")
assert wrong.returncode == 2 and "invalid choice: 'none'" in wrong.stderr, wrong.stderr
