# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Where a source changes below a representation, it draws what a new one in a new view does."""

import json
import os

import numpy
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

# All with normals: VTK draws blocks of which some have none in another way after other data.
ball = simple.Sphere(ThetaResolution=16, PhiResolution=16)
cone = simple.GenerateSurfaceNormals(Input=simple.Cone(Resolution=12))
both = simple.GroupDatasets(Input=[ball, cone])
shown_source = simple.Transform(Input=ball)  # whose input is another one later


def finer():
    """Other cells and points."""
    ball.ThetaResolution = 24


def moved():
    """The same cells elsewhere."""
    shown_source.Transform.Translate = [0.2, 0.1, 0]


def another():
    """Another source."""
    shown_source.Input = cone


def blocks():
    """A multiblock dataset instead of polydata."""
    shown_source.Input = both


def begin():
    """As it is first."""
    ball.ThetaResolution = 16
    shown_source.Transform.Translate = [0, 0, 0]
    shown_source.Input = ball


def show(kind):
    """A new view of the source."""
    where = scene.view((120, 90))
    scene.show(shown_source, where, Representation=kind, **KINDS[kind])
    scene.look(where, CAMERA)
    return where


def draw(where, name=None):
    """Its picture."""
    where.UseFXAA = 0  # a new view resets that of all
    return scene.picture(where, name)


for kind in KINDS:
    where = show(kind)
    draw(where)
    # Marks and patches go with a surface whose points move.
    for change in finer, another, blocks, begin, moved:
        change()
        shown = draw(where, "source-%s-%s" % (kind.split("-")[0], change.__name__))
        new = show(kind)
        wanted = draw(new)
        simple.Delete(new)
        if change is moved:
            shown, wanted = (0.1 * (picture == 128).all(axis=2) for picture in (shown, wanted))
        difference = numpy.abs(shown.astype(float) - wanted).mean()
        assert difference < 0.001, (kind, change.__name__, difference)
    simple.Delete(where)
    begin()
