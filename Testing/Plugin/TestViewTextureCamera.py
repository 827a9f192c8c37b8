# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The camera of a view, and what it sees, becomes a part of the texture at once, and is saved to a manifest."""

import json
import os

import numpy
import pattern_scene as scene
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from paraview.vtk.vtkIOImage import vtkPNGReader
from view_pictures import RED, WHITE, aside, folder, is_color, manifest, paint, painted, same, show, waves

SIZE = (240, 180)
TURN, SCALE, SHIFT = 40.0, 2.0, (3.0, -1.0, 0.5)  # of the actor: about y, then by a factor, then along

ball = simple.Sphere(ThetaResolution=48, PhiResolution=48)


def to_model(point):
    """Into the coordinates of the surface."""
    x, y, z = (numpy.array(point) - SHIFT) / SCALE
    c, s = numpy.cos(numpy.radians(TURN)), numpy.sin(numpy.radians(TURN))
    return numpy.array((c * x - s * z, y, s * x + c * z))


def open_view(**properties):
    """The ball, moved, in a view."""
    where = scene.view(SIZE)
    display = show(where, ball, **properties)
    display.Orientation = [0, TURN, 0]
    display.Scale = [SCALE] * 3
    display.Position = SHIFT
    return where, display


def look(where, degrees):
    """From somewhere around the ball."""
    x, y, z = aside(degrees, 6.0)
    scene.look(where, numpy.array(SHIFT) + (x, y + 0.5, z), SHIFT)


def names(display):
    """Of its views."""
    display.SMProxy.UpdatePropertyInformation()
    return list(display.ViewTextureNames)


def press(display, button):
    """As in the panel; returns what it tells."""
    with scene.Messages() as messages:
        display.SMProxy.InvokeCommand("ViewTexture" + button)
    return messages.text


def read(name):
    """A picture of four components from the folder."""
    reader = vtkPNGReader()
    reader.SetFileName(os.path.join(folder(), name))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)


for old in os.listdir(folder()):
    os.remove(os.path.join(folder(), old))
first = manifest("first", painted("waves", waves(period=90), (0, 0, 3), size=256), finestLevel=5)
saved = os.path.join(folder(), "saved.json")

# What is seen from a camera becomes a dependent view that is seen from there alone.
where, display = open_view(Manifest=first)
look(where, 20)
display.ViewTextureExtremeAngle = 60
seen = scene.picture(where, "view-camera-seen")
assert names(display) == ["waves"]
assert press(display, "AddCamera") == ""
assert names(display) == ["waves", "view 1"]
display.ViewTextureDisplay = "Dependent only"
again = scene.picture(where, "view-camera-again")
inside = (numpy.abs(seen.astype(int) - 128) > 2).any(axis=2)
inside = inside & numpy.roll(inside, 6, 0) & numpy.roll(inside, -6, 0) & numpy.roll(inside, 6, 1) & numpy.roll(inside, -6, 1)
error = (seen.astype(float) - again)[inside]
assert inside.mean() > 0.1 and seen[inside].std() > 20, (inside.mean(), seen[inside].std())
assert numpy.sqrt((error**2).mean()) < 20, numpy.sqrt((error**2).mean())
look(where, 20 + 80)
assert is_color(scene.picture(where), WHITE)

# It is saved in the coordinates of the surface.
look(where, 20)
display.ViewTextureSaveName = saved
assert press(display, "Save") == ""
with open(saved, encoding="utf-8") as file:
    written = json.load(file)
view = written["views"][1]
assert [item["name"] for item in written["views"]] == ["waves", "view 1"]
assert view["kind"] == "dependent" and len(view["extremes"]) == 4
place = to_model(where.CameraPosition)
assert numpy.allclose(view["camera"]["position"], place, atol=1e-6), (view["camera"], place)
assert numpy.allclose(view["camera"]["focalPoint"], (0, 0, 0), atol=1e-6)
for point in view["extremes"]:
    cosine = numpy.dot(point, place) / numpy.linalg.norm(point) / numpy.linalg.norm(place)
    assert abs(numpy.degrees(numpy.arccos(cosine)) - 60) < 1e-3, point
    assert abs(numpy.linalg.norm(point) - numpy.linalg.norm(place)) < 1e-6
image = read(view["image"])
assert image.shape == (SIZE[1], SIZE[0], 4)
drawn = (numpy.abs(seen.astype(int) - 128) > 2).any(axis=2)
assert abs((image[..., 3] > 0).mean() - drawn.mean()) < 0.02, ((image[..., 3] > 0).mean(), drawn.mean())
assert (image[drawn & (image[..., 3] > 0)][:, :3] == seen[drawn & (image[..., 3] > 0)]).mean() > 0.99

# What was saved is what was shown.
fresh_where, fresh = open_view(Manifest=saved, Display="Dependent only")
look(fresh_where, 20)
difference = scene.difference(scene.picture(fresh_where, "view-camera-saved"), again)
assert difference < 0.5, difference
assert names(fresh) == ["waves", "view 1"]
simple.Delete(fresh_where)

# A manifest is written in its own place where no other is named; a transparent picture changes nothing.
display.ViewTextureSaveName = ""
display.ViewTextureManifest = saved
display.ViewTextureDisplay = "As in the style"
display.ViewTexturePicture = "Transparent"
display.ViewTextureExtremeAngle = 40
look(where, 50)
before = scene.picture(where)
assert press(display, "AddCamera") == "" and names(display) == ["waves", "view 1", "view 2"]
difference = scene.difference(scene.picture(where), before)
assert difference < 0.5, difference
display.ViewTextureOutline = "On"
scene.picture(where)
assert names(display) == ["waves", "view 1", "view 2"], "another property loses views"
display.ViewTextureOutline = "As in the style"
assert press(display, "Save") == ""
with open(saved, encoding="utf-8") as file:
    view = json.load(file)["views"][2]
assert read(view["image"]).max() == 0
place = to_model(where.CameraPosition)
cosine = numpy.dot(view["extremes"][0], place) / numpy.dot(place, place)
assert abs(numpy.degrees(numpy.arccos(cosine)) - 40) < 1e-3

# What is painted is seen when the manifest is read again; what was added and not saved is gone then.
assert press(display, "AddCamera") == ""
paint(view["image"], RED, SIZE[0])
text = press(display, "ReadAgain")
assert text == "" and names(display) == ["waves", "view 1", "view 2"], (text, names(display))
reddened = scene.picture(where, "view-camera-painted").astype(float) - before
assert reddened[..., 0].mean() > reddened[..., 1].mean() + 3, reddened.mean(axis=(0, 1))
simple.Delete(where)

# A camera is also added to a style without a manifest, and none where there is nothing to add it to.
where, display = open_view()
look(where, 20)
assert "no name of a manifest" in press(display, "Save")
assert "not read from a manifest" in press(display, "ReadAgain")
display.ViewTexturePicture = "As drawn"
assert press(display, "AddCamera") == "" and press(display, "AddCamera") == ""
assert names(display) == ["view 1", "view 2"]
display.ViewTextureSaveName = os.path.join(folder(), "new.json")
assert press(display, "Save") == "" and os.path.exists(display.ViewTextureSaveName)
display.ViewTextureSaveName = "/nowhere/a.json"
assert "/nowhere" in press(display, "Save")
simple.Delete(where)
halftone = os.path.join(folder(), "halftone.json")
with open(halftone, "w", encoding="ascii") as file:
    json.dump({"hachure": 1, "layers": [{"type": "image", "field": {"pattern": "halftone"}}]}, file)
where, display = open_view(StyleFile=halftone)
look(where, 20)
scene.picture(where)
assert "no layer of views" in press(display, "AddCamera")
assert names(display) == []
