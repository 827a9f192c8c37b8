# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Two views stipple a source each in its own way; a state file and a traced Python script bring both back."""

import os

import pattern_scene as scene
from paraview import simple, smstate

options = (
    {"StippleStyle": "stipple-two-inks", "StippleSize": 3.2, "StippleSeed": 4, "StippleRefinement": "Off"},
    {"StippleStyle": "stipple-white", "StippleScale": 1.5, "StippleCarrier": "Size", "StippleGrowth": 0.6},
)
options[0].update(StippleNumberOfPoints=9000, StippleOutline="On", StippleOutlineWidth=3)
options[1].update(StippleNumberOfPoints=12000, StippleTone="Array", StippleToneRange=[0.6, -0.5])
options[1].update(StipplePaper="Color", StipplePaperColor=[0.2, 0, 0.3], StippleMemoryBudget=64)


def open_view(source, choice):
    """A view of the source with these options."""
    where = scene.view((160, 120))
    arrays = {"StippleToneArray": ["POINTS", "Elevation"]} if choice else {}
    scene.show(source, where, Representation="Stipple", **dict(choice, **arrays))
    scene.look(where, (0, 0.5, 3))
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
    shown = [scene.picture(where, "stipple-%s-%d" % (name, index)) for index, where in enumerate(views)]
    shown.sort(key=lambda picture: scene.difference(picture, alone[0]))
    for picture, wanted in zip(shown, alone):
        assert (picture == wanted).all(), (name, scene.difference(picture, wanted))


alone = []
for choice in options:
    alone.append(scene.picture(open_view(new_source(), choice)))
    clear()
plain = scene.picture(open_view(new_source(), {}))
clear()
for first, second in (alone[0], alone[1]), (alone[0], plain), (alone[1], plain):
    assert scene.difference(first, second) > 5

source = new_source()
views = [open_view(source, choice) for choice in options]
for where, wanted in zip(views, alone):
    assert (scene.picture(where) == wanted).all(), "views disturb each other"

state = os.path.join(scene.output_folder, "stipple.pvsm")
simple.SaveState(state)
script = smstate.get_state()
clear()
simple.LoadState(state)
check_views("pvsm")
clear()
exec(compile(script, "script", "exec"), {})  # pylint: disable=exec-used
check_views("python")
