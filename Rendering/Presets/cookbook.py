#!/usr/bin/python3
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""cookbook.py [--check]: writes README.md, what every built-in style is made of, from their JSON.

--check: writes nothing, and fails where the page is not up to date.
"""

import json
import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]
PAGE = FOLDER / "README.md"
EXAMPLES = ("xtoon",)  # of Examples/Styles

DESCRIPTIONS = {
    "hatch": "Parallel pen strokes that grow wider with the tone.",
    "cross-hatch": "Pen strokes; a second, perpendicular set comes in with darker tones.",
    "halftone": "A square grid of dots, as in newspapers.",
    "cmyk": "A print of the surface's colours in four inks, each in a screen of its own angle.",
    "painterly": "Overlapping dabs of a brush in the surface's colours, with the relief of paint.",
    "paper": "Pen strokes on rough paper, whose grain decides with them where ink goes first.",
    "stipple": "Dots of one size, the more of them the darker it is; each sits on a point of the surface.",
    "stipple-white": "White dots on dark paper: the more of them the lighter it is.",
    "stipple-two-inks": "Black dots for the shadow and white ones for the light, as ink and chalk on toned paper, "
                        "which is left bare between them.",
    "gabor": "Gabor noise without a direction: stipples in light tones, holes in dark ones.",
    "phasor": "Phasor noise: lines of even contrast that bend, branch and end; as wide as the tone.",
    "spot": "Spot noise of fibres: short, loose strokes.",
    "noise-stipple": "Binary stipples, a threshold of isotropic noise; they are finer where it is lighter.",
    "noise-hatch": "Binary hatching, a threshold of noise with one direction: strokes of many lengths.",
    "noise-cross-hatch": "The product of two hatchings: paper stays where both leave it.",
    "graphite": "Two soft hatchings of a pencil, and the grain of the paper: a fine noise that takes away "
                "more of them where it is lighter.",
    "ink": "Three washes, from pale to black, whose edges a noise of large blots moves; where they end is "
           "a step of the tone. The grain of the paper shows in the pale ones.",
    "watercolour": "The surface's colours, thinned by water in large blots; two washes of shadow, one of "
                   "them in the surface's own colours; and pigment and paper, which darken the colours "
                   "in overlay and leave white white.",
    "felt-tip": "The surface's colours in overlay with broad strokes, which make them darker and richer; "
                "grey strokes across in the shadow, and bare slits in the light.",
    "brush": "Large hatches for light, half shadow and shadow on the surface's colours, and the fibres of "
             "the brush, dark and light ones, which stand for its relief.",
    "engraving": "Fine phasor lines. With `directionArray` set to an array of directions, as "
                 "vtkSurfaceDirectionField makes, they follow the shape.",
    "view": "Pictures of the surface, each seen from where it was made: `manifest` names the file that lists "
            "them. Without one it is grey.",
    "xtoon": "What a threshold cannot do: an image says the ink of every value of the noise and every tone "
             "(the X-toon look-up). Here blots have a dark rim, and a fill in four steps.",
}

# Column of the table, group and key in the JSON.
COLUMNS = (("size", "field", "size"), ("regularity", "field", "regularity"),
           ("angle", "field", "angle"), ("spread", "field", "spread"),
           ("smoothness", "field", "smoothness"))
BASIC = {"size", "regularity", "angle", "spread", "smoothness", "kind", "pattern"}


def length(value):
    return "%g px" % value["px"] if "px" in value else "%g mm" % value["mm"]


def shown(value):
    if value is None:
        return ""
    if isinstance(value, dict):
        return length(value)
    if isinstance(value, list):
        return " to ".join("%g" % each for each in value)
    return "%g" % value if isinstance(value, (int, float)) else str(value)


def spaced(key):
    """lowerCamel as words."""
    return re.sub(r"([A-Z])", lambda match: " " + match.group(1).lower(), key)


def others(field):
    return ["%s %s" % (spaced(key), shown(value)) for key, value in field.items() if key not in BASIC]


def tone_text(tone):
    source = tone.get("source", "lit")
    text = [shown(tone.get("constant", 0.5)) if source == "constant" else source]
    text += ["inverted"] if tone.get("invert") else []
    text += ["gamma %g" % tone["gamma"]] if "gamma" in tone else []
    if tone.get("remap") == "smoothstep":
        text.append("step %s" % shown(tone.get("remapRange", [0.25, 0.75])))
    return ", ".join(text)


def ink_text(ink):
    surface = ink.get("colorSource") == "surface"
    text = "the surface's" if surface else "`%s`" % ink.get("color", "#000000")
    return text + (" at %g" % ink["opacity"] if "opacity" in ink else "")


def rows(style):
    head = ["field", *(name for name, _, _ in COLUMNS), "also", "tone", "ink", "blend"]
    yield head
    yield ["---"] * len(head)
    for layer in style["layers"]:
        field = layer["field"]
        what = field.get("kind") or spaced(field.get("pattern", layer["type"]))
        yield [what, *(shown(layer[group].get(key)) for _, group, key in COLUMNS),
               ", ".join(others(field)), tone_text(layer["tone"]), ink_text(layer["ink"]),
               layer["ink"].get("blendMode", "over")]


def paper_text(style):
    paper = style["paper"]
    text = {"constant": "Paper `%s`" % paper.get("color", "#ffffff"), "surface": "On the lit surface",
            "flat": "On the surface's colours without light"}[paper.get("source", "constant")]
    outline = style.get("outline", {})
    if outline.get("enabled"):
        return text + ", outline of %s in `%s`." % (length(outline["width"]), outline["color"])
    return text + ", no outline."


def table(style):
    """A column that no layer fills is left out."""
    lines = list(rows(style))
    kept = [i for i in range(len(lines[0])) if any(line[i] for line in lines[2:])]
    return "\n".join("| %s |" % " | ".join(line[i] for i in kept) for line in lines)


def section(path):
    style = json.loads(path.read_text(encoding="ascii"))
    return "## %s\n\n%s\n%s\n\n%s\n" % (
        path.stem, DESCRIPTIONS[path.stem], paper_text(style), table(style))


def page():
    listed = re.findall(r'\{ "([a-z-]+)", preset_',
                        (FOLDER.parent / "PatternPresets.cxx").read_text(encoding="ascii"))
    files = sorted(path.stem for path in FOLDER.glob("*.json"))
    assert sorted(listed) == files, "listed %s, found %s" % (sorted(listed), files)
    assert set(DESCRIPTIONS) == {*listed, *EXAMPLES}, "a description for every style, and no other"
    parts = [HEAD, *(section(FOLDER / (name + ".json")) for name in listed), TAIL]
    parts += [section(ROOT / "Examples/Styles" / (name + ".json")) for name in EXAMPLES]
    return "\n".join(parts)


HEAD = """# Cookbook

Written by [cookbook.py](cookbook.py) from the styles in this folder. Layers stand in the order in which they are
drawn; what is left out has its default. Styles whose name begins with `stipple` are made of dots that sit on the
surface (Meruvia Pastor and Strothotte 2002, *Frame-Coherent Stippling*). Those from `gabor` on are made of noise, as in
section 4 of Benard et al. 2010 (*A Dynamic Noise Primitive for Coherent Stylization*). Pictures of these:

![A skull in stipples, hatching and cross-hatching](../../Examples/Gallery/noise_styles-0.png)
![A skull in graphite, in washes of ink, and in blots with a dark rim](../../Examples/Gallery/noise_styles-1.png)
![The earth in watercolour, a heated disk in felt-tip, a skull in strokes of a brush](../../Examples/Gallery/noise_styles-2.png)

- **size** is the mean distance of marks, of stipples their diameter; **regularity**, the radius of a kernel over it,
  makes them loose or ruled; **spread** turns them in all directions (90) or in one (0).
- **smoothness** is how softly they end. In **step** A to B, the tone rises from 0 at A to 1 at B: a narrow step makes
  flat washes whose edges the noise moves; with B above 1 the darkest tone is not full ink.
- **ink**: "at" is its opacity. Inks mix in linear light. `multiply` of two black inks is the product of what they leave
  bare; `screen` of white ink takes ink away; `overlay` of black deepens colours and leaves white white.
"""

TAIL = """# With a file beside it

A built-in style holds no pictures. This one is in [Examples/Styles](../../Examples/Styles), with its picture and the
script that draws it.
"""


def main(arguments):
    text = page()
    if "--check" not in arguments:
        PAGE.write_text(text, encoding="utf-8")
        return 0
    if not PAGE.exists() or PAGE.read_text(encoding="utf-8") != text:
        print("%s is not up to date; run %s" % (PAGE, pathlib.Path(__file__).resolve()))
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
