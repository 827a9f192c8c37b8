# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Exported views show the surface where their cameras say, and read back as they were asked for."""

import json
import os
import shlex

import hachure
import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

import readme
from rendering_program import draw, fresh_folder, run, write_sphere

NOTHING = 65535


def load(name):
    views, manifest = hachure.vtkTextureViews(), hachure.vtkTextureViewsManifest()
    assert manifest.Read(name, views), manifest.GetError()
    return views


def array(image):
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)


def eye_of(views, index):
    eye = [0.0] * 4
    assert views.ComputeEye(index, eye)
    return numpy.array(eye[:3])


def seen_points(views, index):
    """The points of the surface at all covered pixels, by camera and depth image."""
    matrix = vtk.vtkMatrix4x4()
    assert views.ComputeModelToClip(index, matrix)
    matrix.Invert()
    inverse = numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    depth = array(views.GetViewDepth(index))[:, :, 0].astype(float)
    rows, columns = numpy.nonzero(depth != NOTHING)
    height, width = depth.shape
    clip = numpy.stack([(columns + 0.5) / width * 2 - 1, (rows + 0.5) / height * 2 - 1,
                        numpy.zeros(len(rows)), numpy.ones(len(rows))])
    through = inverse @ clip
    eye = eye_of(views, index)
    rays = (through[:3] / through[3]).T - eye
    forward = numpy.array(views.GetViewCamera(index).GetDirectionOfProjection())
    limits = [0.0] * 2
    views.GetViewDepthRange(index, limits)
    near, far = limits
    distances = near + depth[rows, columns] / 65534.0 * (far - near)
    return eye + rays * (distances / (rays @ forward))[:, None]


def check_images(views, index):
    """Mask, alpha and depth agree on where the surface is; the picture is white beside it."""
    picture, mask = array(views.GetViewImage(index)), array(views.GetViewMask(index))[:, :, 0]
    depth = array(views.GetViewDepth(index))[:, :, 0]
    assert picture.shape[2] == 4 and set(numpy.unique(mask)) == {0, 255}
    assert (picture[:, :, 3] == mask).all() and ((depth == NOTHING) == (mask == 0)).all()
    assert (picture[mask == 0][:, :3] == 255).all()
    assert picture[mask != 0][:, :3].std() > 20, "it is shaded"
    assert (picture[mask != 0][:, 0] < 250).mean() > 0.5
    return mask != 0


fresh_folder()
write_sphere("sphere.vtp")

# A sphere of radius 1: every pixel's depth leads to it, and its outline is where it must be.
done = draw("sphere.vtp", "--camera", "0,0,5/0,0,0/1,0,0", "--camera", "3,4,0/0.1,0,0",
            "--view-angle", 40, "--orbit", 3, "--hemisphere", 12, "--size", "120x100", "--output",
            "a/b", "--kind", "dependent", "--extreme-angle", 25)
assert "17 views in a/b" in done.stderr, done.stderr
views = load("a/b/views.json")
names = [views.GetViewName(i) for i in range(views.GetNumberOfViews())]
assert names == ["camera-1", "camera-2", *(f"orbit-{i}" for i in (1, 2, 3)),
                 *(f"hemisphere-{i:02d}" for i in range(1, 13))], names
files = [name + ending for name in names for ending in (".png", "-mask.png", "-depth.png")]
assert sorted(os.listdir("a/b")) == sorted([*files, "views.json"]), os.listdir("a/b")
for index, name in enumerate(names):
    covered = check_images(views, index)
    points = seen_points(views, index)
    radii = numpy.linalg.norm(points, axis=1)
    assert radii.min() > 0.985 and radii.max() < 1.003, (name, radii.min(), radii.max())
    # They are on the near side, up to where the tangents from the eye make the outline. Facets reach
    # over it by half their 7.5 degrees.
    eye = eye_of(views, index)
    distance = numpy.linalg.norm(eye)
    assert (points @ eye).min() > 1.0 - distance * numpy.sin(numpy.radians(3.75)), name
    if name != "camera-2":
        angle = numpy.radians(views.GetViewCamera(index).GetViewAngle())
        radius = 50.0 / numpy.tan(angle / 2) / numpy.sqrt(distance ** 2 - 1)
        assert abs(covered.sum() / (numpy.pi * radius ** 2) - 1) < 0.03, name
    # Four extreme points at the angle asked for, as far from the focal point, on all four sides.
    assert views.GetViewKind(index) == views.DEPENDENT
    focal = numpy.array(views.GetViewCamera(index).GetFocalPoint())
    sides = []
    for point in range(views.GetNumberOfExtremePoints(index)):
        place = [0.0] * 3
        views.GetExtremePoint(index, point, place)
        aside = numpy.array(place) - focal
        assert abs(numpy.linalg.norm(aside) / numpy.linalg.norm(eye - focal) - 1) < 1e-9
        cosine = aside @ (eye - focal) / numpy.linalg.norm(eye - focal) ** 2
        assert abs(numpy.degrees(numpy.arccos(cosine)) - 25) < 1e-6, name
        sides.append(place)
    assert len({tuple(numpy.round(side, 6)) for side in sides}) == 4
assert views.GetViewCamera(0).GetPosition() == (0, 0, 5)
assert views.GetViewCamera(0).GetViewUp() == (1, 0, 0)
assert views.GetViewCamera(1).GetViewUp() == (0, 1, 0), "up as files of this type stand"
assert views.GetViewCamera(1).GetViewAngle() == 40

# Orbits go around the axis that points up, beginning at the front; hemispheres stay above.
eyes = [eye_of(views, i) for i in range(len(names))]
assert numpy.allclose(eyes[2][:2], 0, atol=1e-9) and eyes[2][2] > 0
assert all(abs(eye[1]) < 1e-9 for eye in eyes[2:5]) and eyes[3][0] > 0 > eyes[4][0]
assert min(eye[1] for eye in eyes[5:]) > 0
directions = numpy.array([eye / numpy.linalg.norm(eye) for eye in eyes[5:]])
closest = numpy.sort(directions @ directions.T, axis=1)[:, -2]
assert numpy.degrees(numpy.arccos(closest)).min() > 20, "they are spread"

# The cameras of a manifest, with all that belongs to them: the same files again.
draw("sphere.vtp", "--cameras", "a/b/views.json", "--output", "again")
for name in sorted(os.listdir("a/b")):
    with open("a/b/" + name, "rb") as one, open("again/" + name, "rb") as other:
        assert one.read() == other.read(), name
draw("sphere.vtp", "--cameras", "a/b/views.json", "--output", "other", "--size", "60x64", "--kind",
     "independent")
other = load("other/views.json")
assert other.GetViewImage(3).GetDimensions() == (60, 64, 1)
assert other.GetViewKind(3) == other.INDEPENDENT and other.GetNumberOfExtremePoints(3) == 0
assert other.GetViewCamera(3).GetPosition() == views.GetViewCamera(3).GetPosition()

# Without a display the images are the same, or the refusal clear and nothing written.
JOB = ("sphere.vtp", "--orbit", 1, "--size", "64x48", "--output")
draw(*JOB, "first")
bare = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
done = run(*JOB, "bare", environment=bare)
if done.returncode == 0:
    for name in os.listdir("first"):
        with open("first/" + name, "rb") as one, open("bare/" + name, "rb") as other:
            assert one.read() == other.read(), name
else:
    assert done.returncode == 2 and "no display to draw with" in done.stderr, done.stderr
    assert not os.path.exists("bare")
with open("first/views.json", encoding="utf-8") as stream:
    text = json.load(stream)
assert text["hachureViews"] == 1 and text["views"][0]["image"] == "orbit-1.png"
assert text["views"][0]["kind"] == "independent" and text["views"][0]["extremes"] == []

# A camera that looks elsewhere is noted; its files are there.
done = draw("sphere.vtp", "--camera", "0,0,5/0,0,9", "--size", "64x48", "--output", "away")
assert "note: 'camera-1' sees nothing of the surface" in done.stderr
assert not array(load("away/views.json").GetViewMask(0)).any()

# The skull of the examples.
skull = str(readme.ROOT / "Examples/Data/skull.vti")
draw(skull, "--isovalue", 2.9, "--orbit", 4, "--size", "160x120", "--output", "skull")
views = load("skull/views.json")
for index in range(4):
    covered = check_images(views, index)
    rows, columns = numpy.nonzero(covered)
    assert rows.min() > 0 and rows.max() < 119 and rows.max() - rows.min() > 100, "it fills it"
    assert 0.1 < covered.mean() < 0.6

# The commands of the README.
commands = [line for code in readme.blocks("sh") for line in code.splitlines()
            if line.startswith("hachure-views ")]
assert len(commands) == 2
for line in commands:
    words = [str(readme.ROOT / word) if word.startswith("Examples/") else word
             for word in shlex.split(line)[1:]]
    draw(*words, "--size", "64x48")
assert load("views/views.json").GetNumberOfViews() == 6
assert load("front/views.json").GetNumberOfExtremePoints(0) == 4
assert array(load("front/views.json").GetViewMask(0)).any()
