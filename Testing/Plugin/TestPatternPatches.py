# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Patches made by the representation divide the surface as they say, in low detail too."""

import numpy
import pattern_scene as scene
from paraview import simple

POSITION = (0.8, 0.7, 4.0)
# Two pieces, told apart by the sign of x; a block each when they are grouped.
spheres = [
    simple.Sphere(Center=[x, 0, 0], ThetaResolution=24, PhiResolution=16) for x in (-0.6, 0.6)
]
pieces = simple.AppendGeometry(Input=spheres)
sides = simple.Calculator(Input=pieces, ResultArrayName="side", Function="coordsX / abs(coordsX) + 1")
blocks = simple.GroupDatasets(Input=spheres)


def draw(source=sides, name=None, **properties):
    """A picture of the source in a view of its own, after a turn of the camera."""
    where = scene.view((240, 160))
    scene.show(source, where, **properties)
    for turn in -0.4, 0.0:
        scene.look(where, numpy.add(POSITION, (turn, 0, 0)), up=(turn, 1, 0), angle=24)
        shown = scene.picture(where, name)
    simple.Delete(where)
    return shown


def same(first, second):
    """Whether two pictures are equal."""
    return (first == second).all()


one = draw(name="patches-none", PatternPatches="None")
assert same(one, draw()), "data without patches are not one patch"
assert same(one, draw(PatternPatches="Automatic", PatternNumberOfPatches=1))

# The two pieces, found in four ways.
connected = draw(name="patches-connected", PatternPatches="Connected regions")
assert scene.difference(one, connected) > 1.0, "patches change nothing"
by_array = draw(PatternPatches="Array", PatternPatchArray=["POINTS", "side"])
assert same(connected, by_array), scene.difference(connected, by_array)
assert same(connected, draw(PatternPatches="Creases", PatternCreaseAngle=180))
assert same(draw(blocks, PatternPatches="None"), draw(blocks)), "blocks are patches unasked"
by_block = draw(blocks, PatternPatches="Blocks")
assert scene.difference(connected, by_block) < 0.01, "blocks"  # rounding differs

# Compact patches, and the same ones from the filter, which the data then bring along.
automatic = {"PatternPatches": "Automatic", "PatternNumberOfPatches": 6}
sharp = draw(name="patches-sharp", PatternPatchBlend=0, **automatic)
assert scene.difference(connected, sharp) > 1.0
filtered = scene.HachureSurfacePatches(Input=sides, NumberOfPatches=6)
assert same(sharp, draw(filtered)), "patches of the data are not used"
assert same(one, draw(filtered, PatternPatches="None")), "patches of the data where none were asked for"
blended = draw(name="patches-blended", PatternPatchBlend=2, **automatic)
weighed = scene.HachurePatchBlendWeights(Input=filtered, Rings=2)
assert scene.difference(sharp, blended) > 0.5, "blending changes nothing"
assert same(blended, draw(weighed)), "weights of the data are not used"
assert same(sharp, draw(weighed, PatternPatchBlend=0, **automatic)), "weights of other patches"

# Each face of a box has a pattern of its own.
box = simple.Box()
assert scene.difference(draw(box, PatternPatches="None"), draw(box, PatternPatches="Creases")) > 1.0


def message(**properties):
    """What is reported, once, while this is drawn as one patch."""
    with scene.Messages() as messages:
        assert same(one, draw(**properties)), "wrong patches are drawn"
    return messages.text


fractions = message(PatternPatches="Array", PatternPatchArray=["POINTS", "Normals"])
assert fractions.count("Patch array 'Normals' has 3 components") == 1, fractions
absent = message(PatternPatches="Array", PatternPatchArray=["POINTS", "absent"])
assert absent.count("Patch array 'absent' is missing") == 1, absent

# Low detail has the patches of full detail: strokes lie on each other, and the next full picture is the same.
fine = simple.Sphere(ThetaResolution=150, PhiResolution=150)
where = scene.view((240, 160), full_detail=False)
scene.show(fine, where, **automatic)
scene.look(where, (0, 0.5, 3))
full = scene.picture(where)
full = scene.picture(where, "patches-full")
where.SMProxy.InteractiveRender()
where.UseInteractiveRenderingForScreenshots = 1
low = scene.array(where.CaptureWindow(1))
where.UseInteractiveRenderingForScreenshots = 0
assert where.SMProxy.GetClientSideObject().GetUsedLODForLastRender()
closeness = scene.difference(low, full) / scene.difference(low, numpy.roll(full, 4, axis=1))
assert 0.0 < closeness < 0.3, closeness
assert same(full, scene.picture(where)), "low detail moved the pattern"
