# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of time share: tracks, and pictures at a time."""

import pattern_scene as scene
from paraview import simple

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


def show(source, where, prefix, **properties):
    """Shows the source with one of the representations; properties are named without their prefix."""
    renamed = {prefix + name: value for name, value in properties.items()}
    return scene.show(source, where, Representation=LABELS.get(prefix, prefix), **renamed)
