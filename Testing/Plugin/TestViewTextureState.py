# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Two views with textures of their own come back from a state file and from a Python script, which ParaView traces."""

import os

import pattern_scene as scene
from paraview import simple, smstate
from view_pictures import BLUE, RED, manifest, painted, show, waves

manifests = (
    manifest("first", painted("all", RED), painted("front", waves(), extremes=50, size=256)),
    manifest("second", painted("waves", waves(period=60), size=256), painted("front", BLUE, extremes=25), finestLevel=3),
)
options = (
    {"Manifest": manifests[0], "Level": "One for all", "Outline": "On", "OutlineWidth": 3, "MemoryBudget": 64},
    {"Manifest": manifests[1], "Base": "What lies below", "Paper": "Color", "PaperColor": [0.2, 0.6, 0]},
)
options[0].update(Tone="Array", ToneRange=[0.6, -0.5], PropagateUp="Off")
options[1].update(InkOpacity=0.8, ClassicShares="On", ExtremeAngle=20, SaveName="/nowhere/a.json")


def open_view(source, choice):
    """A view of the source with these options."""
    where = scene.view((160, 120))
    arrays = {"ToneArray": ["POINTS", "Elevation"]} if choice is options[0] else {}
    show(where, source, **dict(choice, **arrays))
    scene.look(where, (0.6, 0, 3))
    return where


def new_source():
    """A ball with an array."""
    ball = simple.Sphere(ThetaResolution=30, PhiResolution=30)
    return simple.Elevation(Input=ball, LowPoint=[0, -0.5, 0], HighPoint=[0, 0.5, 0])


def clear():
    """Leaves nothing."""
    for proxy in simple.GetRenderViews() + list(simple.GetSources().values()):
        simple.Delete(proxy)
    assert not simple.GetRenderViews()


def check_views(name):
    """The two that came back are as they were."""
    views = simple.GetRenderViews()
    assert len(views) == 2, (name, len(views))
    for where in views:
        where.UseFXAA = 0  # no part of states
    shown = [scene.picture(where, "view-%s-%d" % (name, index)) for index, where in enumerate(views)]
    shown.sort(key=lambda picture: scene.difference(picture, alone[0]))
    for picture, wanted in zip(shown, alone):
        assert (picture == wanted).all(), (name, scene.difference(picture, wanted))
    for where in views:
        display = where.Representations[0]
        display.SMProxy.UpdatePropertyInformation()
        assert len(display.ViewTextureNames) == 2, "a button was pressed"


clear()
alone = []
for choice in options:
    alone.append(scene.picture(open_view(new_source(), choice)))
    clear()
plain = scene.picture(open_view(new_source(), {}))
clear()
for first, second in (alone[0], alone[1]), (alone[0], plain), (alone[1], plain):
    assert scene.difference(first, second) > 3, scene.difference(first, second)

source = new_source()
views = [open_view(source, choice) for choice in options]
for where, wanted in zip(views, alone):
    assert (scene.picture(where) == wanted).all(), "views disturb each other"

state = os.path.join(scene.output_folder, "view-texture.pvsm")
simple.SaveState(state)
script = smstate.get_state()
clear()
simple.LoadState(state)
check_views("pvsm")
clear()
exec(compile(script, "script", "exec"), {})  # pylint: disable=exec-used
check_views("python")
