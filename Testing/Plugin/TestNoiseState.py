# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A view in noise comes back from a state file and from a Python script, which ParaView traces."""

import os

import pattern_scene as scene
from paraview import simple, smstate
from state_scene import clear

options = {"NoiseStyle": "gabor", "NoiseSpread": -60, "NoiseRegularity": 2, "NoiseSmoothness": 0.3}
options.update(NoiseScale=1.5, NoiseAngle=20, NoiseSeed=2, NoiseControl="Array", NoiseSizeFactors=[0.5, 3])
options.update(NoiseDirectionArray="Normals", NoiseControlRange=[-0.5, 0.5], NoiseDepthTest="Off")
options.update(NoiseTone="Constant", NoiseToneConstant=0.3, NoiseOutlineInk="Color", NoiseOutlineColor=[0.7, 0, 0])


def open_view(choice):
    """A view of a sphere with these options."""
    sphere = simple.Elevation(Input=simple.Sphere(ThetaResolution=30, PhiResolution=30))
    where = scene.view((160, 120))
    if choice:
        choice = dict(choice, NoiseControlArray=["POINTS", "Elevation"])
    scene.show(sphere, where, Representation="Noise", **choice)
    scene.look(where, (0, 0.5, 3))
    return where


def only_view():
    """The picture of the one that came back."""
    (where,) = simple.GetRenderViews()
    where.UseFXAA = 0  # no part of states
    return scene.picture(where, "noise-state")


plain = scene.picture(open_view({}))
clear()
wanted = scene.picture(open_view(options))
assert scene.difference(plain, wanted) > 5

state = os.path.join(scene.output_folder, "noise.pvsm")
simple.SaveState(state)
script = smstate.get_state()
clear()
simple.LoadState(state)
assert (only_view() == wanted).all(), "pvsm"
clear()
exec(compile(script, "script", "exec"), {})  # pylint: disable=exec-used
assert (only_view() == wanted).all(), "Python"
