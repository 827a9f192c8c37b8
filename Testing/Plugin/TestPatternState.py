# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Two views draw a source each in its own way, and a state file brings both back."""

import os

import pattern_scene as scene
from paraview import simple

options = (
    {"PatternStyle": "hatch", "PatternPatches": "Automatic", "PatternNumberOfPatches": 5, "PatternPatchBlend": 3},
    {"PatternStyle": "halftone", "PatternScale": 1.5, "PatternPaperGrain": "On", "PatternPaperContrast": 0.7},
)
options[0].update(PatternToneRemap="Smooth step", PatternToneRemapRange=[0.1, 0.6])
options[1].update(PatternInkOpacity=0.6, PatternOutlineInk="Color", PatternOutlineColor=[0.7, 0, 0])
sphere = simple.Sphere(ThetaResolution=30, PhiResolution=30)


def open_view(choice):
    """A view of the sphere with these options."""
    where = scene.view((160, 120))
    scene.show(sphere, where, **choice)
    scene.look(where, (0, 0.5, 3))
    return where


alone = []
for choice in options:
    where = open_view(choice)
    alone.append(scene.picture(where))
    simple.Delete(where)
assert scene.difference(*alone) > 5

views = [open_view(choice) for choice in options]
for where, wanted in zip(views, alone):
    assert (scene.picture(where) == wanted).all(), "views disturb each other"

state = os.path.join(scene.output_folder, "pattern.pvsm")
simple.SaveState(state)
for proxy in views + [sphere]:
    simple.Delete(proxy)
assert not simple.GetRenderViews()
simple.LoadState(state)
views = simple.GetRenderViews()
assert len(views) == 2, len(views)
for where in views:
    where.UseFXAA = 0  # no part of states
shown = [scene.picture(where, "state-%d" % index) for index, where in enumerate(views)]
found = sorted(range(2), key=lambda index: scene.difference(shown[index], alone[0]))
assert (shown[found[0]] == alone[0]).all(), scene.difference(shown[found[0]], alone[0])
assert (shown[found[1]] == alone[1]).all(), scene.difference(shown[found[1]], alone[1])
