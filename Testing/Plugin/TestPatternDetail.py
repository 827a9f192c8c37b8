# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of low detail, drawn while a user drags, have patterns and leave no trace in the next full one."""

import numpy
import pattern_scene as scene
from paraview import simple

sphere = simple.Sphere(ThetaResolution=300, PhiResolution=300)
sphere.UpdatePipeline()
START = numpy.array([0.0, 0.5, 3.0])
END = numpy.array([1.0, 0.2, 2.5])


def draw(steps):
    """The picture at END of a view that came from START over so many pictures of low detail."""
    where = scene.view(full_detail=steps == 0)
    where.LODResolution = 0.0
    scene.show(sphere, where)
    scene.look(where, START)
    simple.Render(where)
    simple.Render(where)
    low = None
    for step in range(steps):
        scene.look(where, START + (END - START) * (step + 1) / steps)
        where.SMProxy.InteractiveRender()
        if step == steps - 1:
            where.UseInteractiveRenderingForScreenshots = 1
            low = scene.array(where.CaptureWindow(1))
            where.UseInteractiveRenderingForScreenshots = 0
            assert where.SMProxy.GetClientSideObject().GetUsedLODForLastRender()
    scene.look(where, END)
    shown = scene.picture(where, "detail-%d" % steps)
    simple.Delete(where)
    return shown, low


without, _ = draw(0)
with_low, low = draw(4)
assert (without == with_low).all(), "low detail moved the pattern: %f" % scene.difference(without, with_low)
drawn = (low != 128).any(axis=2)
ink = (low[drawn].max(axis=1) < 100).mean()
assert 0.1 < ink < 0.9, "ink in low detail: %.3f" % ink
# Strokes of low and full detail lie on each other.
aside = numpy.roll(without, 4, axis=1)
closeness = scene.difference(low, without) / scene.difference(low, aside)
assert 0.0 < closeness < 0.2, "difference from full detail, as a part of that of other strokes: %f" % closeness

# Also where the first picture of a view is one of low detail, before the full surface has come.
for representation in "Pattern", "Noise":
    shown = []
    with scene.Messages() as messages:
        for first in False, True:
            where = scene.view(full_detail=not first)
            scene.show(sphere, where, Representation=representation)
            if first:
                scene.look(where, START)
                where.SMProxy.InteractiveRender()
                assert where.SMProxy.GetClientSideObject().GetUsedLODForLastRender()
                where.UseInteractiveRenderingForScreenshots = 1
                low = scene.array(where.CaptureWindow(1))
                where.UseInteractiveRenderingForScreenshots = 0
            scene.look(where, END)
            shown.append(scene.picture(where))
            simple.Delete(where)
    assert not messages.text, messages.text
    assert (shown[0] == shown[1]).all(), "%s: %f" % (representation, scene.difference(*shown))
    ink = (low[(low != 128).any(axis=2)].max(axis=1) < 100).mean()
    assert 0.1 < ink < 0.9, "ink in low detail, the first picture: %.3f" % ink

# An array tone is there in low detail too.
with scene.Messages() as messages:
    elevation = simple.Elevation(Input=sphere)
    where = scene.view(full_detail=False)
    scene.show(elevation, where, PatternTone="Array", PatternToneArray=["POINTS", "Elevation"])
    scene.look(where, START)
    simple.Render(where)
    where.SMProxy.InteractiveRender()
assert not messages.text, messages.text

# Noise is there as well, led by an array, and leaves no trace either.
flow = simple.Calculator(Input=sphere, ResultArrayName="flow", Function="iHat+0*coordsX")
led = {"Representation": "Noise", "NoiseDirectionArray": "flow", "NoiseOutline": "Off"}
shown = []
with scene.Messages() as messages:
    for full_detail in True, False:
        where = scene.view(full_detail=full_detail)
        scene.show(flow, where, **led)
        scene.look(where, START)
        simple.Render(where)
        if not full_detail:
            where.SMProxy.InteractiveRender()
            where.UseInteractiveRenderingForScreenshots = 1
            low = scene.array(where.CaptureWindow(1))
            where.UseInteractiveRenderingForScreenshots = 0
        shown.append(scene.picture(where))
        simple.Delete(where)
assert not messages.text, messages.text
assert (shown[0] == shown[1]).all()
drawn = (low != 128).any(axis=2)
ink = (low[drawn].max(axis=1) < 100).mean()
assert 0.1 < ink < 0.9, "ink of noise in low detail: %.3f" % ink
