# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of which several processes hold parts look as if one held them: ghosts, blocks, patches, empty processes."""

import os

import parallel_scene as parallel
import pattern_scene as scene
import view_pictures as views
from paraview import simple

SEEN_FROM = parallel.BLOBS_SEEN_FROM
LARGE = 40  # radius
SMALL = (120, 90)
FEW = {"Representation": "Stipple", "StippleNumberOfPoints": 4000, "StippleRefinement": "Off"}

# A surface of more triangles than every process draws: each knows what is near its part.
fine = parallel.blobs(LARGE)
fine_seen_from = [LARGE / 12 * x for x in SEEN_FROM]
for representation in "Pattern", "Noise":
    parallel.still("fine-" + representation, fine, fine_seen_from, Representation=representation)
parallel.still("fine-stipple", fine, fine_seen_from, **FEW)
parallel.still("fine-far", fine, [4 * x for x in fine_seen_from], Representation="Noise", size=(80, 60))

# A small one: some processes off screen; one ghost layer, and no normals.
blobs = parallel.blobs()
parallel.still("off-screen", blobs, (30, 30, 30), (10, 10, 10), Representation="Noise", NoiseStyle="gabor")
ghosts = simple.GhostCellsGenerator(Input=parallel.blobs(normals=False))
parallel.still("ghosts", ghosts, SEEN_FROM, PatternStyle="cross-hatch")

# Data on one process alone, which one reads: the others have nothing.
ball_file = os.path.join(parallel.folder, "ball.stl")
if parallel.RANKS == 1:
    simple.SaveData(ball_file, proxy=simple.Sphere(ThetaResolution=40, PhiResolution=30))
ball = simple.STLReader(FileNames=[ball_file])
parallel.still("alone", ball, (0, 0.4, 2.2), PatternStyle="halftone")
parallel.still("alone-stipple", ball, (0, 0.4, 2.2), size=SMALL, **FEW)

# More processes than pieces.
parallel.still("three-pieces", simple.Sphere(ThetaResolution=3, PhiResolution=20), (0, 0.4, 2.2), PatternStyle="hatch")

# Blocks, each on another process, that touch; and one of them hidden.
rods = parallel.rods()
parallel.still("blocks", rods, (1, 2, 7), PatternStyle="hatch")
parallel.still("hidden-block", rods, (1, 2, 7), PatternStyle="hatch", BlockSelectors=["/Root/Block1"])

# Patches of the whole surface.
for patches in "Automatic", "Connected regions", "Blocks":
    name = "patches-" + patches.split()[0]
    parallel.still(name, rods, (1, 2, 7), size=SMALL, PatternPatches=patches, PatternStyle="hatch")

# Views that are painted on the surface.
manifest = os.path.join(views.folder(), "views.json")
if parallel.RANKS == 1:
    views.manifest("views", views.painted("front", views.waves(), (0, 0.4, 3), size=256))
window = scene.view(parallel.SIZE)
views.show(window, rods, Manifest=manifest)
scene.look(window, (1, 2, 7))
parallel.check("views", scene.picture(window))

parallel.finish()
