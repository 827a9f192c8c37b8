# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Where a source changes below a representation, it draws what a new one in a new view does."""

import json
import os

import pattern_scene as scene
from paraview import simple
from view_pictures import LABEL, WHITE, folder, manifest, painted, waves


def still_stipples():
    """A style whose stipples are those of the surface alone."""
    field = {"size": {"px": 3}, "numberOfPoints": 3000, "refinement": False, "life": 0}
    name = os.path.join(folder(), "still.json")
    with open(name, "w", encoding="ascii") as file:
        json.dump({"hachure": 1, "layers": [{"type": "stipple", "field": field}]}, file)
    return name


views = manifest("views", painted("waves", waves(64, 32), size=64), painted("front", WHITE, (0, 3, 0.5), 50), finestLevel=2)
KINDS = {
    "Pattern": {"PatternPatches": "Automatic", "PatternNumberOfPatches": 3, "PatternTracking": "Anchored"},
    "Noise": {"NoiseSpread": 90, "NoiseLife": 0},
    "Stipple": {"StippleStyleFile": still_stipples()},
    LABEL: {"ViewTextureManifest": views},
}
CAMERA = (0.3, 0.5, 2.5)

ball = simple.Sphere(ThetaResolution=16, PhiResolution=16)
cone = simple.Cone(Resolution=12)
both = simple.GroupDatasets(Input=[ball, cone])
shown_source = simple.Transform(Input=ball)  # whose input is another one later


def finer():
    """Other cells and points."""
    ball.ThetaResolution = 24


def moved():
    """The same cells elsewhere."""
    shown_source.Transform.Rotate = [0, 0, 40]


def another():
    """Another source."""
    shown_source.Input = cone


def blocks():
    """A multiblock dataset instead of polydata."""
    shown_source.Input = both


def empty():
    """Nothing at all."""
    shown_source.Input = simple.Threshold(Input=ball, Scalars=["POINTS", "Normals"], UpperThreshold=-9, LowerThreshold=-9)


def begin():
    """As it is first."""
    ball.ThetaResolution = 16
    shown_source.Transform.Rotate = [0, 0, 0]
    shown_source.Input = ball


def show(kind):
    """A new view of the source."""
    where = scene.view((120, 90))
    scene.show(shown_source, where, Representation=kind, **KINDS[kind])
    scene.look(where, CAMERA)
    return where


def fresh(kind):
    """The picture of a new representation in a new view."""
    where = show(kind)
    shown = scene.picture(where)
    simple.Delete(where)
    return shown


for kind in KINDS:
    begin()
    for change in finer, moved, another, blocks, begin:
        where = show(kind)
        scene.picture(where)
        change()
        where.UseFXAA = 0
        shown = scene.picture(where)
        wanted = fresh(kind)
        print(kind, change.__name__, scene.difference(shown, wanted))
        simple.Delete(where)
