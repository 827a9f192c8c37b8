# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A view draws on as if no other one had been there, when that is closed: ParaView's windows share their OpenGL."""

import gc

import pattern_scene as scene
from paraview import simple
from view_pictures import LABEL, RED, manifest, painted, waves

CAMERAS = ((0, 0.5, 4), (0.3, 0.5, 4), (0.6, 0.6, 3.8))
views = manifest("views", painted("waves", waves(), size=256), painted("other", RED, (0, 3, 0.5), 50), finestLevel=2)
kinds = [
    {"Representation": "Pattern", "PatternOutline": "On"},
    {"Representation": "Noise", "NoiseBackEnd": "Gather"},
    {"Representation": "Stipple", "StippleRefinement": "Off", "StippleNumberOfPoints": 1000},
    {"Representation": LABEL, "ViewTextureManifest": views},
]
balls = [
    simple.Sphere(Center=(index % 2 - 0.5, index // 2 - 0.5, 0), Radius=0.45, ThetaResolution=20, PhiResolution=20)
    for index in range(len(kinds))
]


def show():
    """A view of all balls, each in its kind."""
    where = scene.view((150, 150))
    for ball, kind in zip(balls, kinds):
        scene.show(ball, where, **kind)
    return where


def draw(where, cameras):
    """Pictures from the cameras, one after the other."""
    shown = []
    for position in cameras:
        where.UseFXAA = 0  # a new view resets that of all
        scene.look(where, position)
        shown.append(scene.picture(where))
    return shown


with scene.Messages() as messages:
    first = show()
    alone = draw(first, CAMERAS)
    second = show()
    shown = draw(second, CAMERAS[:1])
    simple.Delete(first)
    del first
    gc.collect()  # its window goes with the last reference
    shown += draw(second, CAMERAS[1:])
assert not messages.text, messages.text
for wanted, picture in zip(alone, shown):
    assert (picture == wanted).all(), scene.difference(picture, wanted)
for index in range(len(kinds)):
    rows, columns = 75 * (index // 2), 75 * (index % 2)
    part = [picture[rows : rows + 75, columns : columns + 75] for picture in alone[:2]]
    assert part[0].std() > 10 and scene.difference(*part) > 1, index
