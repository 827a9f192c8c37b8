# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of states share: two views of a source, drawn in different ways, come back as they were."""

import os

import pattern_scene as scene
from paraview import simple, smstate


def new_source():
    """A ball with an array."""
    ball = simple.Sphere(ThetaResolution=30, PhiResolution=30)
    return simple.Elevation(Input=ball, LowPoint=[0, -0.5, 0], HighPoint=[0, 0.5, 0])


def clear():
    """Leaves nothing."""
    for proxy in simple.GetRenderViews() + list(simple.GetSources().values()):
        simple.Delete(proxy)
    assert not simple.GetRenderViews()


def check_views(name, alone, check):
    """The two that came back are as they were."""
    views = simple.GetRenderViews()
    assert len(views) == 2, (name, len(views))
    for where in views:
        where.UseFXAA = 0  # no part of states
    shown = [scene.picture(where, "%s-%d" % (name, index)) for index, where in enumerate(views)]
    shown.sort(key=lambda picture: scene.difference(picture, alone[0]))
    for picture, wanted in zip(shown, alone):
        assert (picture == wanted).all(), (name, scene.difference(picture, wanted))
    for where in views:
        check(where)


def two_views_come_back(name, options, open_view, least, check=lambda where: None):
    """From a state file and from a traced script, and neither disturbs the other. open_view(source, choice): a view with
    one of the two options, or with {}; least: the difference of these three; check: of a view that came back."""
    clear()
    alone = []
    for choice in options:
        alone.append(scene.picture(open_view(new_source(), choice)))
        clear()
    plain = scene.picture(open_view(new_source(), {}))
    clear()
    for first, second in (alone[0], alone[1]), (alone[0], plain), (alone[1], plain):
        assert scene.difference(first, second) > least, scene.difference(first, second)
    source = new_source()
    views = [open_view(source, choice) for choice in options]
    for where, wanted in zip(views, alone):
        assert (scene.picture(where) == wanted).all(), "views disturb each other"
    state = os.path.join(scene.output_folder, name + ".pvsm")
    simple.SaveState(state)
    script = smstate.get_state()
    clear()
    simple.LoadState(state)
    check_views(name + "-pvsm", alone, check)
    clear()
    exec(compile(script, "script", "exec"), {})  # pylint: disable=exec-used
    check_views(name + "-python", alone, check)
