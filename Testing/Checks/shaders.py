#!/usr/bin/python3
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""shaders.py FOLDER [DUMPS]: glslangValidator accepts every shader text below FOLDER.

Kernels are validated at three GLSL versions, alone with the ones before them and all together. Complete
shaders (*FS.glsl of fragments, *VS.glsl of vertices, *CS.glsl of computations) get the pieces named by their tags put in, with one
layer of every kind.
DUMPS: a folder of whole programs as they were drawn (*.vert, *.frag), validated too when it is there.
"""

import itertools
import os
import re
import subprocess
import sys
import tempfile

KERNEL_VERSIONS = (150, 330, 460)
GLUE_VERSION = 150
# Of layers' texts.
CONSTANTS = (
    ("LEVEL", "1.0"), ("ASPECT", "1.0"), ("PERIOD", "32.0"), ("POWER", "0.5"), ("IDSHERE", "hachureNoIds@"),
    ("HEMISPHEREMAP", "hemisphereSquare"), ("HEMISPHERE", "8.0"), ("HASDEPENDENT", "1"), ("HASINDEPENDENT", "1"),
)


def read(path):
    with open(path, encoding="ascii") as file:
        return file.read()


def validate(name, text, stage="frag"):
    """Prints what is wrong with this text and returns whether it is right."""
    with tempfile.NamedTemporaryFile("w", suffix="." + stage, delete=False) as file:
        file.write(text)
    result = subprocess.run(
        ["glslangValidator", file.name], capture_output=True, text=True, check=False
    )
    os.unlink(file.name)
    if result.returncode != 0:
        print(name + ":\n" + result.stdout.replace(file.name, name) + result.stderr)
    return result.returncode == 0


def kernel_order(root):
    """Kernels in the order in which they are compiled into C++, files missing there at the end."""
    folder = os.path.join(root, "Filters/Core/Kernels")
    header = os.path.join(root, "Filters/Core/Kernels.h")
    present = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
    order = re.findall(r'"Kernels/(\w+\.glsl)"', read(header)) if os.path.exists(header) else []
    order = [name for name in order if name in present]
    order += [name for name in present if name.endswith(".glsl") and name not in order]
    return [os.path.join(folder, name) for name in order]


def glue_pieces(root):
    """Every shader text of Rendering by its name."""
    pieces = {}
    for folder, _, names in os.walk(os.path.join(root, "Rendering")):
        for name in names:
            if name.endswith(".glsl"):
                pieces[name[: -len(".glsl")]] = read(os.path.join(folder, name))
    return pieces


NOISE_TAG = "//Hachure::NoiseSums::Dec"


def noise_variants(text, pieces, kernels):
    """A text with the sums of noises put in, once for every kind; other texts as they are. Layers' texts
    have the pure functions from elsewhere, and keep their number."""
    if NOISE_TAG not in text:
        return [text]
    parts = sections(pieces["NoiseSums"])
    layer = "@" in text
    share = "NoShares" if layer else "Shares"
    texts = []
    for term, field in (("Gabor", "Table"), ("Phasor", "Phase"), ("Spot", "Table")):
        names = ["Kernels", share, "Numbers", term, "Adding", "Lists", "Sum", field]
        sums = "".join(parts[name] for name in names)
        if not layer:
            sums = (kernels + sums + parts["Seen"]).replace("@", "")
        texts.append(text.replace(NOISE_TAG, sums).replace("NOISEROW", "1024"))
    return texts


def layer_texts(pieces):
    """The text of every kind of layer. Of one that has sections the first goes with each other one, bare
    and with all options: those whose sections are for tags in it, as OptionDec and OptionImpl."""
    texts = []
    for name in sorted(pieces):
        if not name.endswith("Layer") or name == "PatternLayer":
            continue
        parts = sections(pieces[name])
        if not parts:
            variants = noise_variants(pieces[name], pieces, "")
            ink = sections(pieces["NoiseLayer"])["Threshold"] if NOISE_TAG in pieces[name] else ""
            texts += [variant + ink for variant in variants]
            continue
        base, *others = parts
        options = [other for other in others if other.endswith(("Dec", "Impl"))]
        full = parts[base]
        for option in options:
            word, place = re.match(r"(\w+?)(Dec|Impl)$", option).groups()
            full = full.replace("//Hachure::%s::%s" % (word, place), parts[option])
        for other in others:
            if other not in options:
                texts += [parts[base] + parts[other], full + parts[other]]
    return texts


def stack(pieces, kernels):
    """Declarations and calls of one layer of every kind with every blend mode, as they are drawn."""
    declarations, calls = "", ""
    blends = re.findall(r"^vec3 (blend\w+)\(", kernels, re.MULTILINE) or ["mix"]
    pairs = itertools.product(layer_texts(pieces), blends)
    for number, (kind, blend) in enumerate(pairs):
        text = kind + pieces.get("PatternLayer", "")
        separation = "processInks(hachureSurfaceHere, hachureCurve@.w).x"
        curve = "toneCurve(tones[0], hachureCurve@.x, hachureCurve@.y, hachureRemap@)"
        text = text.replace("CURVE", curve if number % 2 else separation)
        for constant, value in CONSTANTS:
            text = text.replace(constant, value)
        text = text.replace("INKCOLOR", "hachureInk@.rgb" if number % 2 else "hachureSurfaceHere")
        declarations += text.replace("BLEND", blend).replace("@", str(number))
        calls += "  color = hachureLayer%d(color, position, tones);\n" % number
    return declarations, calls


def sections(text):
    """The pieces of a file that holds several, by the name after //Section."""
    parts = re.split(r"^//Section (\w+)\n", text, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2]))


def assemble(text, kernels, pieces, paper="Paper"):
    """A whole fragment shader: pieces for tags, VTK's outputs for gl_FragData."""
    declarations, calls = stack(pieces, kernels)
    outline = sections(pieces.get("PatternOutline", ""))
    surface = sections(pieces.get("PatternSurfaceImages", ""))
    for tag, piece in (
        ("//Hachure::Compose::Dec", kernels + pieces.get("PatternCompose", "")),
        ("//Hachure::Outline::Dec", outline.get("Functions", "")),
        ("//Hachure::Outline::Impl", outline.get("Call", "")),
        ("//Hachure::Crease::Impl", outline.get("Crease", "")),
        ("//Hachure::Seen::Dec", pieces.get("PatternSeen", "") + pieces.get("PatternRuns", "")),
        ("//Hachure::ColorAt::Dec", sections(pieces.get("PatternColorAt", "")).get("Images", "")),
        ("//Hachure::Patches::Dec",
         pieces.get("PatternPatches", "") + pieces.get("PatternPatchRecords", "")),
        ("//Hachure::Picture::Impl", sections(pieces.get("PatternPicture", "")).get(paper, "")),
        ("//Hachure::Surface::Dec",
         "".join(surface.get(name + "Dec", "") for name in ("Place", "Run", "Patch"))),
        ("//Hachure::Surface::Impl",
         "".join(surface.get(name + "Impl", "") for name in ("Place", "Run", "Patch"))),
        ("LAYERS", "3"),
        ("PAPER", "hachureSurfaceHere" if paper == "Paper" else "hachurePaperHere"),
        ("//Hachure::Layers::Dec", declarations),
        ("//Hachure::Layers::Impl", calls),
        ("//VTK::System::Dec", "#version %d" % GLUE_VERSION),
    ):
        text = text.replace(tag, piece)
    outputs = sorted(set(re.findall(r"gl_FragData\[(\d)\]", text)))
    declared = "\n".join("out vec4 fragOutput%s;" % output for output in outputs)
    text = text.replace("//VTK::Output::Dec", declared)
    return re.sub(r"gl_FragData\[(\d)\]", r"fragOutput\1", text)


def main(root, dumps):
    good = True
    paths = kernel_order(root)
    texts = [read(path) for path in paths]
    main_function = "\nvoid main()\n{\n}\n"
    for version in KERNEL_VERSIONS:
        head = "#version %d\n" % version
        for count, path in enumerate(paths, start=1):
            good &= validate(
                "%s at %d" % (path, version), head + "\n".join(texts[:count]) + main_function
            )
    pieces = glue_pieces(root)
    kernels = "\n".join(texts)
    for name, piece in pieces.items():
        stage = {"FS": "frag", "VS": "vert", "CS": "comp"}.get(name[-2:])
        for text in noise_variants(piece, pieces, kernels) if stage else ():
            for paper in ("Paper", "NoPaper") if "//Hachure::Picture::Impl" in text else ("Paper",):
                good &= validate(name + ".glsl", assemble(text, kernels, pieces, paper), stage)
    if dumps and os.path.isdir(dumps):
        for name in sorted(os.listdir(dumps)):
            stage = name.rsplit(".", 1)[-1]
            if stage in ("vert", "frag", "geom"):
                good &= validate(name, read(os.path.join(dumps, name)), stage)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else None))
