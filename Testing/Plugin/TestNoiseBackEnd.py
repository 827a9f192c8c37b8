# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What sums up noise can be chosen, for pictures of full and of low detail, and does not show in them."""

import os

# An OpenGL without compute shaders tells by a warning that they were asked for.
os.environ.update(MESA_GL_VERSION_OVERRIDE="3.3", MESA_GLSL_VERSION_OVERRIDE="330")

import pattern_scene as scene  # noqa: E402
from paraview import simple  # noqa: E402

STYLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Rendering/Presets/phasor.json")
WARNING = "cannot sum noises with the back end COMPUTE"

sphere = simple.Sphere(ThetaResolution=60, PhiResolution=60)
sphere.UpdatePipeline()


def draw(representation, back_end, full_detail=True):
    """The picture, and what was reported with it."""
    with scene.Messages() as messages:
        where = scene.view(full_detail=full_detail)
        choices = {"StyleFile": STYLE, "BackEnd": back_end}
        renamed = {representation + name: value for name, value in choices.items()}
        scene.show(sphere, where, Representation=representation, **renamed)
        scene.look(where, (0, 0, 3))
        if full_detail:
            shown = scene.picture(where)
        else:
            where.SMProxy.InteractiveRender()
            where.UseInteractiveRenderingForScreenshots = 1
            shown = scene.array(where.CaptureWindow(1))
        simple.Delete(where)
    return shown, messages.text


for representation in "Noise", "Pattern":
    for full_detail in True, False:
        expected, reported = draw(representation, "CPU", full_detail)
        assert not reported, reported
        assert expected.std() > 40
        for back_end in "Automatic", "Gather", "Splat", "Compute":
            shown, reported = draw(representation, back_end, full_detail)
            case = representation, full_detail, back_end
            assert reported.count(WARNING) == (back_end == "Compute"), (case, reported)
            assert scene.difference(shown, expected) < 1, (case, scene.difference(shown, expected))
