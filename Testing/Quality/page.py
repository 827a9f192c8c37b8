# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The quality report as one HTML page that needs no other file and no script."""

import html
import math

import numpy
from pictures import SHOWN, SIDE, plot

STYLE = """
body { font: 14px/1.4 sans-serif; margin: 2em auto; max-width: 1180px; padding: 0 1em; color: #222;
  background: #fff; }
h2 { margin-top: 2em; border-bottom: 2px solid #222; }
h3 { margin-bottom: .3em; }
p, dl { max-width: 60em; }
table { border-collapse: collapse; }
th, td { border: 1px solid #ccc; padding: 2px 6px; text-align: right; vertical-align: middle; }
th { background: #f4f4f4; }
th.name { text-align: left; font-weight: normal; }
td.best { background: #d8f0d8; font-weight: bold; }
caption { text-align: left; font-weight: bold; padding: 2px 0; }
caption span { font-weight: normal; color: #555; }
dl { display: grid; grid-template-columns: 12em auto; margin: .2em 0 .2em 1em; }
dt { font-weight: bold; }
dd { margin: 0; }
.tables { display: flex; flex-wrap: wrap; gap: 1em 1.5em; font-size: 13px; align-items: flex-start; }
.clips th.name { font-weight: bold; }
.clips th.name small { font-weight: normal; display: block; }
.numbers { border: 0; font-size: 12px; }
.numbers td { border: 0; padding: 0 6px; }
.numbers td:first-child { text-align: left; color: #555; }
svg { display: block; }
svg line { stroke: #888; } svg line.rim { stroke: #ddd; } svg polyline { fill: none; stroke: #06c; }
svg text { font-size: 11px; }
.strip { width: %(side)dpx; height: %(side)dpx; outline: 1px solid #ddd; }
.six { animation: strip 1.2s steps(%(shown)d, jump-none) infinite alternate; }
@keyframes strip { to { background-position: -%(width)dpx 0; } }
@media (prefers-reduced-motion: reduce) { .six { animation: none; } }
""" % {"side": SIDE, "shown": SHOWN, "width": SIDE * (SHOWN - 1)}

# What a metric is called, what it tells, and the best value there is. In the order of the summary.
METRICS = {
    "SlideRatio": ("slide ratio", "how far the pattern slides over the surface / how far the surface "
                   "moves; 0: fixed on the surface, 1: fixed in the image", 0),
    "NormalSlideRatio": ("slide ratio across", "the same, only across the strokes", 0),
    "BoilMedian": ("boil", "what remains of the change from frame to frame after the best slide; "
                   "median over the steps", 0),
    "Contrast": ("contrast", "deviation of the ink / that of the same ink drawn flat on paper with an "
                 "even tone", 1),
    "CooccurrenceError": ("co-occurrence error", "how much the texture of the marks differs from that of "
                          "the same ink drawn flat", 0),
    "FacingSlope": ("slope over tilt (β)", "how the frequency of the pattern grows where the surface "
                    "turns away; 0: flat like paper, 1: squeezed like the surface", 0),
    "DistanceSlope": ("slope over distance (γ)", "how it grows with the distance, over three octaves; "
                      "0: marks keep their size, 1: they shrink like the surface", 0),
    "ToneError": ("tone error", "largest difference of the ink in a window and the tone asked for", 0),
    "ToneFlicker": ("tone flicker", "deviation over time of the mean ink of places on the surface, three "
                    "wavelengths wide", 0),
}
# Only beside the clips.
DETAILS = {
    "Coherence": "coherence", "MeanSlide": "mean slide, pixels",
    "SimilaritySlide": "slide that no similarity avoids, pixels", "MeanMotion": "mean motion, pixels",
    "LargestMotion": "largest motion, pixels", "BoilLargest": "largest boil", "Pop": "pop",
}
# The curves.
STEPS = {"Slide": "slide in pixels", "NormalSlide": "slide across in pixels", "Boil": "boil",
         "Frequency": "periods per pixel", "Contrast": "contrast"}


def name_of(metric):
    return METRICS[metric][0] if metric in METRICS else DETAILS.get(metric, metric)


def number(value):
    return "–" if math.isnan(value) else "%.4f" % value


def best_of(values, metric):
    """Whether each value, as it is printed, is the nearest to what is best."""
    away = [abs(round(value, 4) - METRICS[metric][2]) for value in values]
    known = [distance for distance in away if not math.isnan(distance)]
    return [len(known) > 1 and distance == min(known) for distance in away]


def summary(clips, metric):
    """A table of one metric: motions down, fields across, mean over the scenes; empty without values."""
    motions, fields = ([*dict.fromkeys(c[key] for c in clips)] for key in ("motion", "field"))
    rows = []
    for motion in motions:
        found = [[c["values"].get(metric, math.nan) for c in clips
                  if (c["motion"], c["field"]) == (motion, field)] for field in fields]
        known = [[value for value in values if not math.isnan(value)] for values in found]
        if not any(known):
            continue
        means = [float(numpy.mean(values)) if values else math.nan for values in known]
        cells = ("<td%s>%s</td>" % (' class="best"' if best else "", number(value))
                 for value, best in zip(means, best_of(means, metric)))
        rows.append('<tr><th class="name">%s</th>%s</tr>' % (html.escape(motion), "".join(cells)))
    if not rows:
        return ""
    head = "".join("<th>%s</th>" % html.escape(field) for field in fields)
    return ("<table><caption>%s <span>best: %g</span></caption><tr><th></th>%s</tr>%s</table>"
            % (name_of(metric), METRICS[metric][2], head, "".join(rows)))


def summaries(clips):
    parts = []
    for ink, lighting in dict.fromkeys((c["ink"], c["lighting"]) for c in clips):
        chosen = [c for c in clips if (c["ink"], c["lighting"]) == (ink, lighting)]
        strokes = not any("SlideRatio" in c["values"] for c in chosen)
        tables = (summary(chosen, metric) for metric in METRICS
                  if strokes or metric != "NormalSlideRatio")
        parts.append('<h3>%s, %s</h3><div class="tables">%s</div>' % (
            html.escape(ink), html.escape(lighting), "".join(tables)))
    return parts


def legend():
    entries = "".join("<dt>%s</dt><dd>%s</dd>" % (name, text) for name, text, _ in METRICS.values())
    return "<h2>What the numbers mean</h2><dl>%s</dl>" % entries


def clip_row(clip, tops):
    name = "%s<small>%s, %s</small>" % tuple(
        html.escape(clip[key]) for key in ("field", "ink", "lighting"))
    numbers = "".join("<tr><td>%s</td><td>%s</td></tr>" % (name_of(key), number(value))
                      for key, value in clip["values"].items())
    plots = "".join(plot(values, STEPS[key], tops[key]) for key, values in clip["steps"].items())
    return ('<tr><th class="name">%s</th><td>%s</td><td>%s</td><td><table class="numbers">%s</table></td>'
            "<td>%s</td></tr>" % (name, clip["frames"], clip["differences"], numbers, plots))


def anchor(scene):
    return html.escape(scene.replace(" ", "-"))


def scene_parts(clips, scene):
    parts = ['<h2 id="%s">Scene: %s</h2>' % (anchor(scene), html.escape(scene))]
    of_scene = [c for c in clips if c["scene"] == scene]
    for motion in dict.fromkeys(c["motion"] for c in of_scene):
        chosen = [c for c in of_scene if c["motion"] == motion]
        tops = {key: max(numpy.nanmax(numpy.append(c["steps"][key], 0)) for c in chosen
                         if key in c["steps"]) for c in chosen for key in c["steps"]}
        rows = [clip_row(c, tops) for c in chosen]
        parts.append('<h3>%s</h3><table class="clips"><tr><th>field</th><th>frames</th><th>differences'
                     "</th><th>numbers</th><th>step by step</th></tr>%s</table>"
                     % (html.escape(motion), "\n".join(rows)))
    return parts


def explained(explanation):
    """Paragraphs, and pairs of a term and its meaning."""
    return ["<p>%s</p>" % html.escape(entry) if isinstance(entry, str)
            else "<dl><dt>%s</dt><dd>%s</dd></dl>" % tuple(map(html.escape, entry))
            for entry in explanation]


def page(clips, explanation):
    scenes = list(dict.fromkeys(c["scene"] for c in clips))
    parts = ['<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>Hachure: quality'
             "</title><style>%s</style></head><body><h1>Quality of moving patterns</h1>" % STYLE]
    parts += explained(explanation)
    parts.append("<p>Clips by scene: %s</p>" % ", ".join(
        '<a href="#%s">%s</a>' % (anchor(scene), html.escape(scene)) for scene in scenes))
    parts.append("<h2>Mean over the scenes</h2>")
    parts += summaries(clips)
    parts.append(legend())
    for scene in scenes:
        parts += scene_parts(clips, scene)
    return "\n".join(parts + ["</body></html>\n"])
