# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of which several processes hold parts look as if one held them: ghosts, blocks, patches, empty processes."""

import os

import parallel_scene as parallel
import pattern_scene as scene
import view_pictures as views
from paraview import simple

SEEN_FROM = parallel.BLOBS_SEEN_FROM
FEW = {"Representation": "Stipple", "StippleNumberOfPoints": 4000, "StippleRefinement": "Off"}

blobs = parallel.blobs()
for representation in "Pattern", "Noise":
    parallel.still(representation, blobs, SEEN_FROM, Representation=representation)
parallel.still("Stipple", blobs, SEEN_FROM, **FEW)

# Near the border of the parts, and small, where surroundings are wide.
parallel.still("near", blobs, (9, 6, 22), (2, 1, 8), Representation="Noise")
parallel.still("far", blobs, [4 * x for x in SEEN_FROM], Representation="Noise", size=(80, 60))

# One ghost layer, and no normals.
ghosts = simple.GhostCellsGenerator(Input=parallel.blobs(normals=False))
parallel.still("ghosts", ghosts, SEEN_FROM, PatternStyle="cross-hatch")

# Data on one process alone, which one reads: the others have nothing.
ball_file = os.path.join(parallel.folder, "ball.stl")
if parallel.RANKS == 1:
    simple.SaveData(ball_file, proxy=simple.Sphere(ThetaResolution=40, PhiResolution=30))
ball = simple.STLReader(FileNames=[ball_file])
parallel.still("alone", ball, (0, 0.4, 2.2), PatternStyle="halftone")
parallel.still("alone-stipple", ball, (0, 0.4, 2.2), **FEW)

# More processes than pieces, and some off screen.
parallel.still("three-pieces", simple.Sphere(ThetaResolution=3, PhiResolution=20), (0, 0.4, 2.2), PatternStyle="hatch")
parallel.still("off-screen", blobs, (30, 30, 30), (10, 10, 10), Representation="Noise", NoiseStyle="gabor")

# Blocks, each on another process, that touch; and one of them hidden.
rods = parallel.rods()
parallel.still("blocks", rods, (1, 2, 7), PatternStyle="hatch")
parallel.still("hidden-block", rods, (1, 2, 7), PatternStyle="hatch", BlockSelectors=["/Root/Block1"])

# Patches of the whole surface.
for patches in "Automatic", "Connected regions", "Blocks":
    parallel.still("patches-" + patches, rods, (1, 2, 7), PatternPatches=patches, PatternStyle="hatch")

# Views that are painted on the surface.
manifest = os.path.join(views.folder(), "views.json")
if parallel.RANKS == 1:
    views.manifest("views", views.painted("front", views.waves(), (0, 0.4, 3), size=256))
window = scene.view(parallel.SIZE)
views.show(window, rods, Manifest=manifest)
scene.look(window, (1, 2, 7))
parallel.check("views", scene.picture(window))

parallel.finish()
