# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Views are shown around the surface, are no part of pictures that are taken, and are moved with the mouse."""

import json
import os

import numpy
import pattern_scene as scene
from paraview import simple
from paraview.vtk.vtkRenderingUI import vtkGenericRenderWindowInteractor
from view_pictures import BLUE, RED, folder, manifest, painted, show

SIZE = (240, 180)
EYE = (4, 2, 7)

ball = simple.Sphere(ThetaResolution=48, PhiResolution=48)
file_name = manifest("views", painted("all", RED), painted("front", BLUE, extremes=40))


def saved(display):
    """The views in the manifest that the button writes."""
    display.SMProxy.InvokeCommand("ViewTextureSave")
    with open(display.ViewTextureSaveName, encoding="utf-8") as file:
        return json.load(file)["views"]


def differ(first, second):
    """Where two pictures do."""
    return (numpy.abs(first.astype(int) - second) > 8).any(axis=2)


def beside(picture):
    """The share of a picture that is drawn outside of the surface; borders may differ."""
    return (differ(picture, plain) & ground).mean()


where = scene.view(SIZE)
display = show(where, ball, Manifest=file_name, SaveName=os.path.join(folder(), "saved.json"))
scene.look(where, EYE)
plain = scene.picture(where)
ground = (numpy.abs(plain.astype(int) - 128) <= 2).all(axis=2)

# They are drawn beside the surface, too, and go with their representation.
display.ViewTextureShowViews = 1
shown = scene.picture(where, "view-editing")
assert beside(shown) > 0.01, beside(shown)
display.Visibility = 0
assert (numpy.abs(scene.picture(where).astype(int) - 128) <= 2).all(), "something is left"
display.Visibility = 1
assert (scene.picture(where) == shown).all()
display.Representation = "Surface"
assert beside(scene.picture(where)) < 0.002
display.Representation = "View-dependent Texture"
assert (scene.picture(where) == shown).all()

# The picture of an added view has none of them in it.
display.SMProxy.InvokeCommand("ViewTextureAddCamera")
display.ViewTextureShowViews = 0
display.ViewTextureDisplay = "Dependent only"
taken = scene.picture(where, "view-editing-taken")
assert beside(taken) < 0.002
assert saved(display)[2]["name"] == "view 1"
display.ViewTextureDisplay = "As in the style"

# Without an interactor there is nothing to edit with; with one a view is dragged to where the mouse goes.
interactor = vtkGenericRenderWindowInteractor()
where.SMProxy.SetupInteractor(interactor)
interactor.SetRenderWindow(where.GetRenderWindow())
interactor.Initialize()
display.ViewTextureShowViews = 1
scene.picture(where)
renderer = where.GetRenderer()


def at(point):
    """Where a point of the scene is in the window."""
    renderer.SetWorldPoint(*point, 1.0)
    renderer.WorldToDisplay()
    return [round(value) for value in renderer.GetDisplayPoint()[:2]]


def drag(start, end):
    """With the left button."""
    interactor.SetEventInformation(*start, 0, 0, "\0", 0, "")
    interactor.MouseMoveEvent()
    interactor.LeftButtonPressEvent()
    interactor.SetEventInformation(*end, 0, 0, "\0", 0, "")
    interactor.MouseMoveEvent()
    interactor.LeftButtonReleaseEvent()


before = saved(display)
start = at((0, 0, 2.2))  # in its picture, on the way from the camera to the surface
drag(start, (start[0] - 15, start[1] + 15))
after = saved(display)
moved = [i for i, view in enumerate(after) if not numpy.allclose(view["camera"]["position"], before[i]["camera"]["position"])]
assert len(moved) == 1, moved
position = after[moved[0]]["camera"]["position"]
assert abs(numpy.linalg.norm(position) - 3) < 1e-6 and position[1] > 0.1, position
assert numpy.allclose(where.CameraPosition, EYE), "the camera has moved"
assert differ(scene.picture(where, "view-editing-moved"), shown).any()
display.ViewTextureShowViews = 0
drag(start, (start[0] - 15, start[1] + 15))
assert saved(display) == after
