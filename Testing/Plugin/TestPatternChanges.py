# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A property that is changed in a moving picture changes nothing else: marks move on, and what they are made of stays."""

import json
import os
import time

import pattern_scene as scene
from paraview import simple
from view_pictures import LABEL, folder, manifest, painted, waves

ball = simple.Sphere(ThetaResolution=24, PhiResolution=24)
CAMERAS = ((0, 0.5, 3), (0.2, 0.5, 2.6), (0.5, 0.6, 2.2), (0.7, 0.6, 2.1))


def growing():
    """A style whose stipples grow in the pictures after that in which they come."""
    field = {"order": "classic", "growthFrames": 12, "numberOfPoints": 4000}
    name = os.path.join(folder(), "growing.json")
    with open(name, "w", encoding="ascii") as file:
        json.dump({"hachure": 1, "layers": [{"type": "stipple", "field": field}]}, file)
    return name


views = manifest("views", painted("waves", waves(), size=256), painted("front", waves(period=60), (0, 3, 0.5), 50, 256))
KINDS = {
    "Pattern": {"PatternPatches": "Automatic", "PatternNumberOfPatches": 4},
    "Noise": {"NoiseStyle": "gabor", "NoiseSpread": 90},
    "Stipple": {"StippleStyleFile": growing()},
    LABEL: {"ViewTextureManifest": views},
}
CHANGES = ({"InkOpacity": 0.5}, {"Paper": "Color", "PaperColor": [0.9, 0.8, 0.3]}, {"BlendMode": "Multiply"}, {})


def change(display, prefix, properties):
    """Those of the representation, the others as they are by default."""
    defaults = {"InkOpacity": 1, "Paper": "As in the style", "BlendMode": "As in the style"}
    for name, value in {**defaults, **properties}.items():
        setattr(display, prefix + name, value)


def draw(kind, changes):
    """Pictures from the cameras, after the changes of each, the last of which is none, and the time of each."""
    where = scene.view((120, 90))
    display = scene.show(ball, where, Representation=kind, **KINDS[kind])
    prefix = "ViewTexture" if kind == LABEL else kind
    shown, seconds = [], []
    for index, position in enumerate(CAMERAS):
        scene.look(where, position)
        for properties in changes:
            if index > 0:
                change(display, prefix, properties)
            start = time.process_time()
            shown.append(scene.picture(where, "%s-%d" % (prefix, len(shown)) if changes is CHANGES else None))
            seconds.append(time.process_time() - start)
    simple.Delete(where)
    return shown, seconds


for kind in KINDS:
    still, _ = draw(kind, [{}] * len(CHANGES))
    shown, seconds = draw(kind, CHANGES)
    last = len(CHANGES) - 1
    for index in range(last, len(shown), len(CHANGES)):
        assert (shown[index] == still[index]).all(), (kind, index, scene.difference(shown[index], still[index]))
    assert scene.difference(shown[last + 1], still[last + 1]) > 1, (kind, "the ink was not changed")
    if kind == LABEL:  # almost all of the time goes into the colours of the first picture
        assert sum(seconds[1:]) < seconds[0], ["%.3f" % second for second in seconds]
