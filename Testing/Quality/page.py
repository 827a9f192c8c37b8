# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The quality report as one HTML page that needs no other file and no script."""

import base64
import html
import math

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

SIDE = 160  # of the pictures at half the size, in pixels
SHOWN = 6  # frames in a strip
LEVELS = 15  # grey levels but one; few keep the page small

STYLE = """
body { font: 14px sans-serif; margin: 2em; color: #222; }
table { border-collapse: collapse; margin: 1em 0; }
th, td { border: 1px solid #ccc; padding: 3px 8px; text-align: right; vertical-align: middle; }
th, td.name { text-align: left; font-weight: normal; background: #f4f4f4; }
.numbers { columns: 2; margin: 0; padding: 0; list-style: none; font-size: 12px; }
.strip { width: %(side)dpx; height: %(side)dpx; animation-iteration-count: infinite; }
.six { animation: strip 1.5s steps(%(shown)d) infinite; }
@keyframes strip { to { background-position: -%(width)dpx 0; } }
@media (prefers-reduced-motion: reduce) { .six { animation: none; } }
""" % {"side": SIDE, "shown": SHOWN, "width": SIDE * SHOWN}


def number(value):
    return "–" if math.isnan(value) else "%.4f" % value


def png(values):
    """values[row, column] from 0 (white) to 1 (black), row 0 at the bottom, as the address of an image."""
    levels = numpy.rint(numpy.clip(values, 0, 1) * LEVELS) / LEVELS
    grey = numpy.rint(255 * (1 - levels) ** (1 / 2.2)).astype(numpy.uint8)
    image = vtkImageData()
    image.SetDimensions(grey.shape[1], grey.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(grey.ravel(), deep=1))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.WriteToMemoryOn()
    writer.Write()
    data = vtk_to_numpy(writer.GetResult()).tobytes()
    return "data:image/png;base64," + base64.b64encode(data).decode()


def strip(pictures, title):
    """Some of the pictures at half the size, one after the other and again."""
    chosen = numpy.linspace(0, len(pictures) - 1, SHOWN).round().astype(int)
    row = numpy.hstack([pictures[i] for i in chosen])
    address = png(row.reshape(SIDE, 2, SIDE * SHOWN, 2).mean(axis=(1, 3)))
    return '<div class="strip six" title="%s" style="background-image:url(%s)"></div>' % (
        html.escape(title), address)


def plot(values, title, width=180, height=60):
    """A curve over the steps of a clip, from 0 to its largest value."""
    values = numpy.nan_to_num(numpy.asarray(values, dtype=float))
    top = max(float(values.max(initial=0.0)), 1e-9)
    across = numpy.linspace(2, width - 2, max(len(values), 2))
    points = " ".join("%.1f,%.1f" % (x, height - 2 - (height - 16) * y / top)
                      for x, y in zip(across, values))
    return ('<svg width="%d" height="%d"><polyline points="%s" fill="none" stroke="#06c"/>'
            '<text x="2" y="11" font-size="11">%s, up to %.3g</text></svg>'
            % (width, height, points, html.escape(title), top))


def summary(clips, metric, ink, lighting):
    """A table of one metric: motions down, fields across, mean over the scenes."""
    chosen = [c for c in clips if c["ink"] == ink and c["lighting"] == lighting]
    motions, fields = ([*dict.fromkeys(c[key] for c in chosen)] for key in ("motion", "field"))
    rows = ["<tr><th>%s</th>%s</tr>" % (metric, "".join("<th>%s</th>" % f for f in fields))]
    for motion in motions:
        cells = []
        for field in fields:
            found = [c["values"].get(metric, math.nan) for c in chosen
                     if (c["motion"], c["field"]) == (motion, field)]
            found = [value for value in found if not math.isnan(value)]
            cells.append("<td>%s</td>" % number(numpy.mean(found) if found else math.nan))
        rows.append('<tr><td class="name">%s</td>%s</tr>' % (motion, "".join(cells)))
    return "<table>%s</table>" % "".join(rows)


def clip_row(clip):
    name = "<br>".join(html.escape(clip[key]) for key in ("motion", "field", "ink", "lighting"))
    numbers = "".join("<li>%s %s</li>" % (key, number(value)) for key, value in clip["values"].items())
    plots = "<br>".join(plot(values, key) for key, values in clip["steps"].items())
    return ('<tr><td class="name">%s</td><td>%s</td><td>%s</td><td><ul class="numbers">%s</ul></td>'
            "<td>%s</td></tr>" % (name, clip["frames"], clip["differences"], numbers, plots))


def page(clips, explanation):
    parts = ['<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>Hachure: quality'
             "</title><style>%s</style></head><body><h1>Quality of moving patterns</h1>" % STYLE]
    parts += ["<p>%s</p>" % html.escape(text) for text in explanation]
    parts.append("<h2>Mean over the scenes</h2>")
    for ink, lighting in dict.fromkeys((c["ink"], c["lighting"]) for c in clips):
        parts.append("<h3>%s, %s</h3>" % (html.escape(ink), html.escape(lighting)))
        parts += [summary(clips, metric, ink, lighting)
                  for metric in ("NormalSlideRatio", "SlideRatio", "BoilMedian")
                  if any(metric in c["values"] for c in clips if c["ink"] == ink)]
    for scene in dict.fromkeys(c["scene"] for c in clips):
        parts.append("<h2>%s</h2><table><tr><th>clip</th><th>frames</th><th>differences along the "
                     "motion</th><th>numbers</th><th>step by step</th></tr>" % html.escape(scene))
        parts += [clip_row(c) for c in clips if c["scene"] == scene]
        parts.append("</table>")
    return "\n".join(parts + ["</body></html>\n"])
