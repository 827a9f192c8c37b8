# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of time share: tracks, and pictures at a time."""

import os
import sys

import pattern_scene as scene
from paraview import simple
from paraview.vtk.vtkIOXML import vtkXMLPolyDataWriter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import protein_tube  # noqa: E402  pylint: disable=wrong-import-position

LABELS = {"ViewTexture": "View-dependent Texture"}  # of representations that are not named as their prefix


def clock(frames=5, start=0.0, end=1.0):
    """The animation scene, without tracks, in frames from start to end."""
    animation = simple.GetAnimationScene()
    for cue in list(animation.Cues):
        if cue.GetXMLName() == "KeyFrameAnimationCue":
            simple.Delete(cue)
    animation.PlayMode = "Sequence"
    animation.StartTime, animation.EndTime, animation.NumberOfFrames = start, end, frames
    animation.AnimationTime = start
    return animation


def track(display, name, first, last, index=0):
    """Animates an element of a property evenly from first to last."""
    cue = simple.GetAnimationTrack(name, index=index, proxy=display)
    cue.KeyFrames = [simple.CompositeKeyFrame(KeyTime=time, KeyValues=[value], Interpolation="Ramp")
                     for time, value in ((0, first), (1, last))]
    return cue


def picture_at(where, time, name=None):
    """The view at a time of the animation."""
    simple.GetAnimationScene().AnimationTime = time
    return scene.picture(where, name)


def fix_clipping(where, size):
    """Clipping planes around a cube of this half size. ParaView's follow the surface a picture late: depths round
    otherwise in another order of times."""
    where.MaxClipBounds = [-size, size] * 3
    where.LockBounds = 1


def show(source, where, prefix, **properties):
    """Shows the source with one of the representations; properties are named without their prefix."""
    renamed = {prefix + name: value for name, value in properties.items()}
    return scene.show(source, where, Representation=LABELS.get(prefix, prefix), **renamed)


def orbit(where, distance, center=(0.0, 0.0, 0.0), quarters=1):
    """Lets the camera go around a centre by quarters of a turn; it looks along -z first."""
    cue = simple.GetCameraTrack(view=where)
    cue.Mode = "Path-based"
    corners = [(0, 1), (1, 0), (0, -1), (-1, 0)][: quarters + 1]
    path = [coordinate for x, z in corners
            for coordinate in (center[0] + distance * x, center[1], center[2] + distance * z)]
    key = simple.CameraKeyFrame(KeyTime=0, PositionPathPoints=path, FocalPathPoints=list(center), ViewUp=[0, 1, 0],
                                Position=path[:3], FocalPoint=list(center), ClosedPositionPath=0)
    cue.KeyFrames = [key, simple.CameraKeyFrame(KeyTime=1)]
    return cue


def tube_series(count):
    """Tubes around the shapes of a protein: a time series of fixed connectivity, at times 0, 1, ..."""
    files = []
    for model, backbone in enumerate(protein_tube.backbones(scene.data_folder)[:count]):
        files.append(os.path.join(scene.output_folder, "tube_%d.vtp" % model))
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(files[-1])
        writer.SetInputData(protein_tube.tube(backbone))
        writer.Write()
    return simple.OpenDataFile(files)


def disk_contour(value=400.0):
    """An isosurface of the temperature around a heated disk."""
    disk = simple.OpenDataFile(os.path.join(scene.data_folder, "disk_out_ref.ex2"))
    contour = simple.Contour(Input=disk, ContourBy=["POINTS", "Temp"], Isosurfaces=[value], ComputeScalars=0)
    return contour
