# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Manifests of views read back as they were written, and a wrong one changes nothing."""

import json
import os
import re
import tempfile

import hachure
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkCamera

from view_scene import depth_image, expect_error, image, new_views, number_of_errors, pixels, watched

Views = hachure.vtkTextureViews
THIRD = 1.0 / 3.0


def write_picture(name, picture):
    writer = vtkPNGWriter()
    writer.SetInputData(picture)
    writer.SetFileName(name)
    writer.Write()


def camera(parallel=False):
    result = vtkCamera()
    result.SetPosition(THIRD, 0.1, 10.0 + 1e-9)
    result.SetFocalPoint(0.2, -0.7, 1e-300)
    result.SetViewAngle(1e2 / 7.0)
    result.SetParallelProjection(parallel)
    result.SetParallelScale(1.5 * THIRD)
    return result


def full_views():
    """Every kind of everything, and nothing with its default."""
    views = new_views()
    views.SetBaseCells(99)
    views.SetFinestLevel(5)
    views.SetHemisphere(16)
    views.SetHemisphereMap(Views.DISK)
    views.AddView('front "\u00e9"/..', camera(), image(8, 6, 4, seed=1))
    views.AddView("side", camera(parallel=True), image(6, 6, 3, seed=2))
    matrix = vtkMatrix4x4()
    matrix.DeepCopy([THIRD, 2, 3, 4, 0, 0.7, 0, -1, 0, 0, 1, 2, 0, 0, -1, 5])
    views.AddView("", matrix, image(5, 7, 2, seed=3))
    views.AddView("side", camera(), image(3, 3, 1, seed=4))
    views.SetViewUp(0, (0.1, 7.0, -0.3))
    views.SetViewMask(0, image(8, 6, 1, seed=5))
    views.SetViewDepth(0, depth_image(8, 6), 1.0 + THIRD, 12.0)
    views.SetViewKind(1, Views.DEPENDENT)
    for i in range(4):
        views.AddExtremePoint(1, (i * THIRD, 2.0, -3.0))
    views.SetFadeMode(1, Views.MIDDLE)
    views.SetFadeMode(2, Views.EVEN)
    views.RemoveAllFadePoints(1)
    views.AddFadePoint(2, 0.1 + 0.2, THIRD)
    views.AddBlendPoint((1, THIRD, 3), (0, 0, -7), 12.5)
    views.AddBlendPoint((0, 0, 0), (1, 0, 0), 100)
    return views


def triple(get, *arguments, size=3):
    result = [0.0] * size
    get(*arguments, result)
    return tuple(result)


def all_of(views):
    """Everything that views hold but the names of files and the counters."""
    result = [views.GetBaseCells(), views.GetFinestLevel(), views.GetHemisphere(),
              views.GetHemisphereMap()]
    for i in range(views.GetNumberOfViews()):
        matrix, seen = views.GetViewMatrix(i), views.GetViewCamera(i)
        result += [views.GetViewName(i), views.GetViewKind(i), views.GetFadeMode(i)]
        result += [pixels(get(i)) for get in (
            views.GetViewImage, views.GetViewMask, views.GetViewDepth)]
        result.append(triple(views.GetViewDepthRange, i, size=2))
        if matrix:
            result.append([matrix.GetElement(k // 4, k % 4) for k in range(16)])
        else:
            result += [seen.GetPosition(), seen.GetFocalPoint(), triple(views.GetViewUp, i)]
            result.append(seen.GetParallelScale() if seen.GetParallelProjection()
                          else [seen.GetViewAngle()])
        result += [triple(views.GetExtremePoint, i, k)
                   for k in range(views.GetNumberOfExtremePoints(i))]
        result += [triple(views.GetFadePoint, i, k, size=2)
                   for k in range(views.GetNumberOfFadePoints(i))]
    for i in range(views.GetNumberOfBlendPoints()):
        result += [triple(views.GetBlendPointPosition, i), triple(views.GetBlendPointDirection, i),
                   views.GetBlendPointPercentage(i)]
    return result


def counters(views):
    return [(views.GetViewImageMTime(i), views.GetViewCameraMTime(i), views.GetViewRangeMTime(i))
            for i in range(views.GetNumberOfViews())]


def manifest():
    return watched(hachure.vtkTextureViewsManifest())


def test_round_trip(folder):
    views, copy, file = full_views(), new_views(), manifest()
    name = os.path.join(folder, "views.json")
    assert file.Write(name, views) and file.GetError() == ""
    written = sorted(os.listdir(folder))
    stem = written[0].split("-")[0]
    assert stem.startswith("front_") and stem.isascii(), stem
    assert written == sorted([stem + ".png", stem + "-mask.png", stem + "-depth.png", "side.png",
                              "view.png", "side-2.png", "views.json"]), written
    assert views.GetViewImageFileName(3) == os.path.realpath(os.path.join(folder, "side-2.png"))
    assert views.GetViewMaskFileName(1) == ""
    with open(name, encoding="utf-8") as stream:
        text = stream.read()
    assert json.loads(text)["views"][1]["image"] == "side.png"
    assert file.Read(name, copy)
    assert all_of(copy) == all_of(views)
    # All is in files now, so that only the manifest is written again, and is the same.
    stamps = {one: os.stat(os.path.join(folder, one)).st_mtime_ns for one in written}
    assert file.Write(name, copy)
    assert sorted(os.listdir(folder)) == written
    assert all(os.stat(os.path.join(folder, one)).st_mtime_ns == stamps[one] for one in written
               if one != "views.json")
    with open(name, encoding="utf-8") as stream:
        assert stream.read() == text
    return name, views, copy


def test_reading_again(name, views, copy):
    """Only what was changed on disk is counted."""
    file = manifest()
    before, kept = counters(copy), copy.GetViewImage(1)
    assert file.Read(name, copy) and counters(copy) == before
    write_picture(os.path.join(os.path.dirname(name), "side.png"), image(6, 6, 3, seed=9))
    views.SetViewUp(0, (1, 7, 0))
    views.AddExtremePoint(3, (1, 2, 3))
    assert file.Write(name, views) and file.Read(name, copy)
    changed = [tuple(a > b for a, b in zip(*pair)) for pair in zip(counters(copy), before)]
    assert changed == [(False, True, False), (True, False, False), (False,) * 3,
                       (False, False, True)], changed
    assert copy.GetViewImage(1) is not kept and pixels(copy.GetViewImage(1)) != pixels(kept)


def test_other_folders(folder, views):
    """A manifest in another folder has copies; one above refers to what is below."""
    file, copy = manifest(), new_views()
    other = os.path.join(folder, "other")
    os.mkdir(other)
    below = full_views()
    assert file.Write(os.path.join(other, "views.json"), below)
    assert len(os.listdir(other)) == 7
    above = os.path.join(folder, "above.json")
    assert file.Write(above, below) and file.Read(above, copy)
    with open(above, encoding="utf-8") as stream:
        assert json.load(stream)["views"][1]["image"] == "other/side.png"
    assert all_of(copy) == all_of(below)
    third = os.path.join(folder, "third")
    os.mkdir(third)
    assert file.Write(os.path.join(third, "views.json"), views)
    assert os.path.exists(os.path.join(third, "side.png"))
    # Names relative to the working folder, and an empty list.
    os.chdir(third)
    assert file.Write("empty.json", new_views()) and file.Read("empty.json", copy)
    assert copy.GetNumberOfViews() == 0 and copy.GetBaseCells() == 144


def test_defaults(folder):
    views, file = full_views(), manifest()
    name = os.path.join(folder, "small.json")
    write_picture(os.path.join(folder, "a.png"), image())
    with open(name, "w", encoding="utf-8") as stream:
        stream.write('{"hachureViews": 1, "views": [{"image": "a.png", "camera":'
                     ' {"position": [0, 0, 1], "focalPoint": [0, 0, 0]}}]}')
    assert file.Read(name, views), file.GetError()
    expected = new_views()
    expected.AddView("", vtkCamera(), image())
    assert all_of(views) == all_of(expected)


def test_documentation(folder):
    """The example of the documentation reads, and means what it says."""
    page = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples",
                        "Programs", "views.schema.md")
    with open(page, encoding="utf-8") as stream:
        text = re.search("```json\n(.*?)```", stream.read(), re.DOTALL).group(1)
    for name, picture in (("front", image()), ("front-mask", image()), ("side", image(5, 5)),
                          ("front-depth", depth_image())):
        write_picture(os.path.join(folder, name + ".png"), picture)
    with open(os.path.join(folder, "views.json"), "w", encoding="utf-8") as stream:
        stream.write(text)
    views, file = new_views(), manifest()
    assert file.Read(os.path.join(folder, "views.json"), views), file.GetError()
    assert views.GetViewName(1) == "all around" and views.GetViewKind(1) == Views.INDEPENDENT
    assert views.GetNumberOfExtremePoints(0) == 4 and views.GetNumberOfBlendPoints() == 1
    assert triple(views.GetViewDepthRange, 0, size=2) == (8.5, 12)


def good():
    return {
        "hachureViews": 1,
        "cells": {"baseCells": 10, "finestLevel": 2, "hemisphere": 4, "map": "disk"},
        "views": [
            {"name": "a", "image": "a.png", "mask": "mask.png", "depth": "depth.png",
             "depthRange": [1, 2], "kind": "dependent",
             "camera": {"position": [0, 0, 9], "focalPoint": [0, 0, 0], "viewUp": [0, 1, 0],
                        "viewAngle": 30},
             "extremes": [[1, 2, 3]], "fade": {"mode": "even", "curve": [[0, 1], [1, 0]]}},
            {"image": "a.png",
             "camera": {"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}}],
        "blendPoints": [{"position": [0, 0, 9], "direction": [0, 0, -1], "percentage": 50}],
    }


REMOVED = object()


def changed(path, value):
    """The good manifest with one value set, or taken away."""
    result = good()
    place = result
    for key in path[:-1]:
        place = place[key]
    if value is REMOVED:
        del place[path[-1]]
    else:
        place[path[-1]] = value
    return json.dumps(result)


def wrong_manifests():
    view, seen = ("views", 0), ("views", 0, "camera")
    pair = ("views", 1, "camera", "matrix")
    for path, value, *parts in (
            (("hachureViews",), 2, "hachureViews: version 2 is unknown; expected 1"),
            (("hachureViews",), REMOVED, "hachureViews: missing", '"hachureViews": 1'),
            (("hachureViews",), "1", "hachureViews: expected a number, got a text"),
            (("view",), [], "view: unknown key; expected one of hachureViews, cells, views"),
            (("cells", "levels"), 3, "cells.levels: unknown key"),
            (("cells",), [], "cells: expected an object, got a list"),
            (("cells", "baseCells"), 0, "cells.baseCells: 0 is out of range; expected 1 to"),
            (("cells", "baseCells"), 1.5, "cells.baseCells: expected a whole number, got 1.5"),
            (("cells", "finestLevel"), 9, "cells.finestLevel: 9 is out of range; expected 0 to 8"),
            (("cells", "hemisphere"), 5, "cells.hemisphere: expected 4, 8 or 16, got 5"),
            (("cells", "hemisphere"), 32, "cells.hemisphere: 32 is out of range"),
            (("cells", "map"), "sphere", 'cells.map: unknown "sphere"', '"octahedral", "disk"'),
            (("views",), {}, "views: expected a list, got an object"),
            (view, 7, "views[0]: expected an object, got a number"),
            ((*view, "colour"), 1, "views[0].colour: unknown key"),
            ((*view, "name"), 1, "views[0].name: expected a text, got a number"),
            ((*view, "image"), REMOVED, "views[0].image: missing"),
            ((*view, "image"), 3, "views[0].image: expected a text, got a number"),
            ((*view, "image"), "", 'views[0].image: expected the name of a file, got ""'),
            ((*view, "image"), "no.png", 'views[0].image: "no.png": no such file'),
            ((*view, "image"), ".", "views[0].image", "no such file"),
            ((*view, "image"), "text.png", "views[0].image", "text.png", "not a picture format"),
            ((*view, "image"), "cut.png", "views[0].image", "cut.png", "the file is damaged"),
            ((*view, "image"), "depth.png", 'views[0].image: "depth.png": expected 8-bit'),
            ((*view, "mask"), "small.png",
             'views[0].mask: "small.png": expected the size of the image, 8 x 6, got 4 x 6'),
            ((*view, "mask"), "no.png", 'views[0].mask: "no.png": no such file'),
            ((*view, "depth"), "small-depth.png",
             'views[0].depth: "small-depth.png": expected the size of the image, 8 x 6, got 4 x 6'),
            ((*view, "depth"), "a.png", 'views[0].depth: "a.png": expected 16-bit'),
            ((*view, "depthRange"), REMOVED, "views[0].depthRange: missing"),
            ((*view, "depthRange"), [2, 2], "views[0].depthRange: expected two distances"),
            ((*view, "depthRange"), [2], "views[0].depthRange: expected a list of 2 numbers"),
            ((*view, "depth"), REMOVED, "views[0].depthRange: unknown key"),
            ((*view, "kind"), "both", 'views[0].kind: unknown "both"', '"dependent"'),
            (seen, REMOVED, "views[0].camera: missing"),
            (seen, [], "views[0].camera: expected an object, got a list"),
            ((*seen, "position"), REMOVED, "views[0].camera.position: missing"),
            ((*seen, "focalPoint"), REMOVED, "views[0].camera.focalPoint: missing"),
            ((*seen, "position"), [0, 0], "views[0].camera.position: expected a list of 3 numbers"),
            ((*seen, "position"), [0, "0", 1], "views[0].camera.position[1]: expected a number"),
            ((*seen, "position"), [0, 0, 0],
             "views[0].camera: the position is the focal point (0, 0, 0)"),
            ((*seen, "viewUp"), [0, 0, -3], "views[0].camera: the view up (0, 0, -3) does not"),
            ((*seen, "viewUp"), [0, 0, 0], "views[0].camera: the view up (0, 0, 0) does not"),
            ((*seen, "viewAngle"), 180, "views[0].camera: expected a view angle", "got 180"),
            ((*seen, "viewAngle"), 0, "views[0].camera: expected a view angle", "got 0"),
            ((*seen, "parallelScale"), 1, "views[0].camera.viewAngle: a camera with a parallel"),
            (seen, {"position": [0, 0, 1], "focalPoint": [0, 0, 0], "parallelScale": 0},
             "views[0].camera: expected a parallel scale above 0, got 0"),
            ((*seen, "matrix"), [1] * 16, "views[0].camera.matrix: the matrix is singular"),
            (("views", 1, "camera", "position"), [0, 0, 1],
             "views[1].camera.position: unknown key; expected one of matrix"),
            (pair, [0] * 16, "views[1].camera.matrix: the matrix is singular", "determinant is 0"),
            (pair, [1] * 15, "views[1].camera.matrix: expected a list of 16 numbers"),
            ((*pair, 3), None, "views[1].camera.matrix[3]: expected a number, got null"),
            ((*view, "extremes"), [1, 2, 3], "views[0].extremes[0]: expected a list of 3 numbers"),
            ((*view, "extremes"), 1, "views[0].extremes: expected a list, got a number"),
            ((*view, "extremes", 0, 2), "3", "views[0].extremes[0][2]: expected a number"),
            ((*view, "fade"), "even", "views[0].fade: expected an object, got a text"),
            ((*view, "fade", "mode"), "fast", 'views[0].fade.mode: unknown "fast"', '"middle"'),
            ((*view, "fade", "power"), 2, "views[0].fade.power: unknown key"),
            ((*view, "fade", "curve"), [[0, 1, 2]], "fade.curve[0]: expected a list of 2 numbers"),
            ((*view, "fade", "curve"), [[0, 1], [1.5, 0]], "curve[1][0]: 1.5 is out of range"),
            ((*view, "fade", "curve"), [[0, -1]], "curve[0][1]: -1 is out of range"),
            ((*view, "fade", "curve"), [[0.5, 1], [0.25, 0]], "fade.curve[1][0]", "become less"),
            (("blendPoints", 0), [], "blendPoints[0]: expected an object, got a list"),
            (("blendPoints", 0, "percentage"), 101,
             "blendPoints[0].percentage: 101 is out of range; expected 0 to 100"),
            (("blendPoints", 0, "percentage"), -1, "blendPoints[0].percentage: -1 is out of range"),
            (("blendPoints", 0, "percentage"), REMOVED, "blendPoints[0].percentage: missing"),
            (("blendPoints", 0, "direction"), [0, 0, 0], "blendPoints[0].direction: expected a dir"),
            (("blendPoints", 0, "share"), 1, "blendPoints[0].share: unknown key")):
        yield changed(path, value), parts
    outside = "must be relative to the manifest's folder and stay in it"
    for name in ("../a.png", "in/../../x/a.png", "in/../a.png", os.path.abspath("x/a.png")):
        yield changed((*view, "image"), name), ["views[0].image", name, outside]
        yield changed((*view, "mask"), name), ["views[0].mask", name, outside]
        yield changed((*view, "depth"), name), ["views[0].depth", name, outside]
    for name in ("link.png", "link/a.png"):
        yield changed((*view, "image"), name), ["views[0].image", name, "is a link out of"]
    yield "", ["manifest: not valid JSON"]
    yield "{", ["manifest: not valid JSON"]
    yield "[]", ["manifest: expected an object, got a list"]
    yield "[" * 5000, ["manifest: not valid JSON"]
    yield changed(("hachureViews",), 1) + "x", ["not valid JSON"]
    yield '{"hachureViews": 1, "hachureViews": 1}', ["Duplicate key: 'hachureViews'"]
    yield changed((*seen, "viewAngle"), float("inf")), ["not valid JSON"]


def test_wrong_manifests(folder):
    inside = os.path.join(folder, "x")
    os.makedirs(os.path.join(inside, "in"))
    os.chdir(folder)
    for where, picture in (("a.png", image()), ("x/a.png", image()), ("x/mask.png", image(8, 6, 1)),
                           ("x/depth.png", depth_image()), ("x/small.png", image(4, 6)),
                           ("x/small-depth.png", depth_image(4, 6)), ("x/cut.png", image(64, 64))):
        write_picture(where, picture)
    os.truncate("x/cut.png", 60)
    with open("x/text.png", "w", encoding="utf-8") as stream:
        stream.write("no picture")
    os.symlink("../a.png", "x/link.png")
    os.symlink("..", "x/link")
    os.symlink("a.png", "x/good-link.png")
    name = os.path.join(inside, "views.json")
    file, views = manifest(), full_views()

    def read(text):
        with open(name, "w", encoding="utf-8") as stream:
            stream.write(text)
        return file.Read(name, views)

    before, times, total = all_of(views), counters(views), views.GetMTime()
    for text, parts in wrong_manifests():
        result = expect_error(lambda: read(text), "Read: ", "views.json: ", *parts)
        assert result is False and all(part in file.GetError() for part in parts)
        assert all_of(views) == before and counters(views) == times, text
        assert views.GetMTime() == total
    for missing in ("no.json", "no/views.json", "x", ""):
        assert not expect_error(lambda: file.Read(missing, views), "manifest", missing)
    assert not expect_error(lambda: file.Read(None, views), "got null")
    assert not expect_error(lambda: file.Read(name, None), "got null")
    assert all_of(views) == before and views.GetMTime() == total
    # The manifest that the wrong ones were made of is right, and so is a link that stays inside.
    assert read(json.dumps(good())) and file.GetError() == ""
    assert read(changed(("views", 0, "image"), "good-link.png")), file.GetError()
    assert views.GetNumberOfViews() == 2 and views.GetHemisphere() == 4


def test_writing_fails(folder):
    """What was there stays, and nothing is left of what was begun."""
    file, views = manifest(), full_views()
    name = os.path.join(folder, "views.json")

    def failed(target, *parts):
        before = {one: os.stat(os.path.join(folder, one)).st_mtime_ns for one in os.listdir(folder)}
        total = views.GetMTime()
        assert expect_error(lambda: file.Write(target, views), "Write: ", *parts) is False
        assert {one: os.stat(os.path.join(folder, one)).st_mtime_ns
                for one in os.listdir(folder)} == before
        assert views.GetMTime() == total and views.GetViewImageFileName(0) == ""

    failed(os.path.join(folder, "nowhere", "views.json"), "no folder for the manifest")
    failed("", "no folder for the manifest")
    os.mkdir(name)
    failed(name, "cannot write the manifest", name)
    os.rmdir(name)
    with open(name, "w", encoding="utf-8") as stream:
        stream.write("painted with care")
    for way, text in ((".side.png.part", "cannot write the image"),
                      (".views.json.part", "cannot write the manifest")):
        os.mkdir(os.path.join(folder, way))  # in the way of the second image, of the manifest
        failed(name, text)
        os.rmdir(os.path.join(folder, way))
    views.GetViewImage(2).DeepCopy(vtkImageData())
    failed(name, "Write", 'the image of the view "": expected an image of one slice')
    with open(name, encoding="utf-8") as stream:
        assert stream.read() == "painted with care"
    # A file that bears the name of a view is somebody's.
    views = full_views()
    with open(os.path.join(folder, "side.png"), "w", encoding="utf-8") as stream:
        stream.write("mine")
    assert file.Write(name, views)
    assert os.path.basename(views.GetViewImageFileName(1)) == "side-2.png"
    with open(os.path.join(folder, "side.png"), encoding="utf-8") as stream:
        assert stream.read() == "mine"
    assert not [one for one in os.listdir(folder) if one.endswith(".part")]


with tempfile.TemporaryDirectory() as temporary:
    test_other_folders(temporary, test_round_trip(temporary)[1])
with tempfile.TemporaryDirectory() as temporary:
    test_reading_again(*test_round_trip(temporary))
with tempfile.TemporaryDirectory() as temporary:
    test_defaults(temporary)
with tempfile.TemporaryDirectory() as temporary:
    test_documentation(temporary)
with tempfile.TemporaryDirectory() as temporary:
    test_wrong_manifests(temporary)
with tempfile.TemporaryDirectory() as temporary:
    test_writing_fails(temporary)
assert number_of_errors() == 0
