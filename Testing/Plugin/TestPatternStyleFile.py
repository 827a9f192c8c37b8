# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The style that is drawn is saved to a file, from which a new representation draws the same."""

import json
import os

import pattern_scene as scene
from paraview import simple
from view_pictures import LABEL, WHITE, folder, manifest, paint, painted, waves

ball = simple.Sphere(ThetaResolution=24, PhiResolution=24)
ball = simple.Elevation(Input=ball, LowPoint=[0, -0.5, 0], HighPoint=[0, 0.5, 0])
tone = {"Tone": "Array", "ToneArray": ["POINTS", "Elevation"], "ToneRange": [0.1, 1.3], "ToneGamma": 1.3}
tone.update(InkOpacity=0.7, Paper="Color", PaperColor=[0.9, 1 / 3, 0.7])
paint("tile.png", waves(64))
paint("spot.png", waves(64, 40))
tile, spot = (os.path.join(folder(), name) for name in ("tile.png", "spot.png"))
views = manifest("views", painted("waves", waves(64, 32), size=64), painted("front", WHITE, (0, 3, 0.5), 50), finestLevel=2)
KINDS = {
    "Pattern": dict(tone, Style="halftone", Kind="Image", ImageFile=tile, Scale=0.9, Outline="On", Seed=7),
    "Noise": dict(tone, Kind="Spot", SpotImage=spot, Angle=33, Ink="Color", InkColor=[0.1, 0.2, 0.7]),
    "Stipple": dict(tone, Size=3.3, Carrier="Size", NumberOfPoints=3000, Refinement="Off", Scale=1.2),
    LABEL: {"Manifest": views, "Level": "One for all", "InkOpacity": 0.8, "Outline": "On", "OutlineWidth": 3},
}


def prefix_of(kind):
    """With which names of properties begin."""
    return "ViewTexture" if kind == LABEL else kind


def show(kind, **properties):
    """A new view of the ball, and its representation."""
    where = scene.view((120, 90))
    renamed = {prefix_of(kind) + name: value for name, value in properties.items()}
    display = scene.show(ball, where, Representation=kind, **renamed)
    scene.look(where, (0.3, 0.5, 2.5))
    return where, display


def save(display, kind, file_name=None):
    """Presses the button; returns what was reported."""
    if file_name is not None:
        setattr(display, prefix_of(kind) + "StyleSaveName", file_name)
    with scene.Messages() as messages:
        display.InvokeCommand(prefix_of(kind) + "StyleSave")
    return messages.text


for kind, properties in KINDS.items():
    where, display = show(kind, **properties)
    shown = scene.picture(where, "saved-" + prefix_of(kind))
    file_name = os.path.join(folder(), "styles %s.json" % prefix_of(kind))
    assert "no name" in save(display, kind), kind
    assert not save(display, kind, file_name), kind
    for name in "/nowhere/style.json", folder():
        text = save(display, kind, name)
        assert text.count(name) == 1, (kind, text)
    assert (scene.picture(where) == shown).all(), kind
    simple.Delete(where)
    where, display = show(kind, StyleFile=file_name)
    loaded = scene.picture(where)
    assert (loaded == shown).all(), (kind, scene.difference(loaded, shown))
    simple.Delete(where)

# Views that are in no file, or in another state, would be lost: the manifest first.
where, display = show(LABEL, **KINDS[LABEL])
scene.picture(where)
display.InvokeCommand("ViewTextureAddCamera")
file_name = os.path.join(folder(), "added.json")
if os.path.exists(file_name):
    os.remove(file_name)
text = save(display, LABEL, file_name)
assert "added.json" in text and "manifest" in text and not os.path.exists(file_name), text
display.ViewTextureSaveName = os.path.join(folder(), "added-views.json")
display.InvokeCommand("ViewTextureSave")
shown = scene.picture(where)
assert not save(display, LABEL), "the views were saved"
with open(file_name, encoding="utf-8") as file:
    assert json.load(file)["layers"][0]["field"]["manifest"] == "added-views.json"
simple.Delete(where)
where, display = show(LABEL, StyleFile=file_name)
assert (scene.picture(where) == shown).all()

# A state brings the name, and presses no button.
display.ViewTextureStyleSaveName = os.path.join(folder(), "state-style.json")
state = os.path.join(folder(), "state.pvsm")
simple.SaveState(state)
simple.Delete(where)
simple.LoadState(state)
where = simple.GetRenderViews()[0]
assert where.Representations[0].ViewTextureStyleSaveName.endswith("state-style.json")
assert not os.path.exists(os.path.join(folder(), "state-style.json"))
