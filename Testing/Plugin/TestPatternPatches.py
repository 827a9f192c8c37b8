# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Patches made by the representation divide the surface as they say, in low detail too."""

import numpy
import pattern_scene as scene
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

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

# Compact patches; those of the filter, which the data then bring along, are other ones: the representation makes
# them in an order of cells that does not depend on the data's.
automatic = {"PatternPatches": "Automatic", "PatternNumberOfPatches": 6}
compact = draw(name="patches-compact", PatternPatchBlend=0, **automatic)
assert scene.difference(connected, compact) > 1.0
turned = draw(PatternPatchBlend=0, PatternNormalWeight=2, **automatic)
assert not same(turned, compact), "the weight of normals changes nothing"
filtered = scene.HachureSurfacePatches(Input=sides, NumberOfPatches=6)
from_filter = {"PatternPatches": "Array", "PatternPatchArray": ["CELLS", "PatchId"]}
sharp = draw(filtered, name="patches-sharp", PatternPatchBlend=0, **from_filter)
assert scene.difference(connected, sharp) > 1.0
assert same(sharp, draw(filtered)), "patches of the data are not used"
assert same(one, draw(filtered, PatternPatches="None")), "patches of the data where none were asked for"
blended = draw(filtered, name="patches-blended", PatternPatchBlend=2, **from_filter)
strong = draw(filtered, PatternPatchBlend=2, PatternPatchPower=0.3, **from_filter)
assert strong.mean() < blended.mean() - 0.2, (strong.mean(), blended.mean())
weighed = scene.HachurePatchBlendWeights(Input=filtered, Rings=2)
assert scene.difference(sharp, blended) > 0.5, "blending changes nothing"
assert same(blended, draw(weighed)), "weights of the data are not used"
assert same(sharp, draw(weighed, PatternPatchBlend=0, **from_filter)), "weights of other patches"

distance = {"PatternPatchBlendMode": "Distance", "PatternPatchBlendDistance": 0.1}
far = draw(filtered, name="patches-far", **distance, **from_filter)
weighed = scene.HachurePatchBlendWeights(Input=filtered, WidthMode="Distance", Distance=0.1)
assert scene.difference(blended, far) > 0.2, "a distance changes nothing"
assert same(far, draw(weighed)), "weights by distance"
distance["PatternPatchBlendDistance"] = 0
assert same(sharp, draw(filtered, **distance, **from_filter)), "no distance is no sharp border"
cells = draw(filtered, PatternPatchBlend=1, PatternBorderWeights="By cells", **from_filter)
assert not same(cells, draw(filtered, PatternPatchBlend=1, **from_filter)), "weights on borders change nothing"
assert same(cells, draw(scene.HachurePatchBlendWeights(Input=filtered, Rings=1, Initial="Faces")))

# Two blocks that touch hang together, unless they are not to be joined.
half = simple.Clip(Input=spheres[0], ClipType="Plane", Invert=1)
half.ClipType.Origin, half.ClipType.Normal = [-0.6, 0, 0], [1, 0, 0]
other = simple.Clip(Input=spheres[0], ClipType="Plane", Invert=0)
other.ClipType.Origin, other.ClipType.Normal = [-0.6, 0, 0], [1, 0, 0]
halves = simple.GroupDatasets(Input=[simple.ExtractSurface(Input=clip) for clip in (half, other)])
regions = {"PatternPatches": "Connected regions", "PatternPatchBlend": 0}
joined = draw(halves, **regions)
assert scene.difference(joined, draw(halves, PatternPatches="None")) < 0.01  # rounding differs with blocks
apart = draw(halves, PatternJoinBlocks=0, **regions)
assert scene.difference(apart, draw(halves, PatternPatches="Blocks", PatternPatchBlend=0)) < 0.01
assert scene.difference(joined, apart) > 0.5

# The cells that are selected in the view, of the ball on the right, are a patch, through the filter.
where = scene.view((240, 160))
scene.show(sides, where, Representation="Surface")
scene.look(where, POSITION, angle=24)
simple.Render(where)
simple.SelectSurfaceCells(Rectangle=[120, 0, 240, 160], View=where)
picked = scene.HachureSurfacePatches(Input=sides, Method="Selection")
picked.Selection = servermanager._getPyProxy(sides.SMProxy.GetSelectionInput(0))
simple.ClearSelection(sides)
simple.Delete(where)
left, right = numpy.split(vtk_to_numpy(servermanager.Fetch(picked).GetCellData().GetArray("PatchId")), 2)
assert not left.any() and 0.3 < right.mean() < 0.6, (left.mean(), right.mean())
assert scene.difference(one, draw(picked)) > 0.5, "a selection changes nothing"

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
