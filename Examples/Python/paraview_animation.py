# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Saves an animation of a surface that grows around a heated disk: pvbatch paraview_animation.py [FILE.png]"""

import sys

from paraview.simple import *

disk = OpenDataFile("Examples/Data/disk_out_ref.ex2")
warm = Contour(Input=disk, ContourBy=["POINTS", "Temp"], Isosurfaces=[402])
view = CreateRenderView(ViewSize=[320, 240], UseFXAA=0, CameraPosition=[8, -20, 9], CameraViewUp=[0, 0, 1])
display = Show(warm, view)
display.Representation = "Stipple"
display.StippleSize, display.StippleNumberOfPoints = 3, 20000
GetAnimationScene().PlayMode = "Sequence"
GetAnimationScene().NumberOfFrames = 8
for name, proxy, first, last in ("ContourValues", warm, 402, 400), ("StippleToneGamma", display, 1.5, 0.7):
    keys = ((0, first), (1, last))
    GetAnimationTrack(name, 0, proxy).KeyFrames = [CompositeKeyFrame(KeyTime=t, KeyValues=[v]) for t, v in keys]
display.InvokeCommand("StippleReanchor")  # whatever was looked at before
SaveAnimation(sys.argv[1] if len(sys.argv) > 1 else "warm.png", view)
