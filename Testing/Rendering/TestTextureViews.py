# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Views keep what they are given, count their changes one by one, and say where they stand."""

import hachure
import numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkCamera

from view_scene import depth_image, expect_error, image, new_views, number_of_errors

Views = hachure.vtkTextureViews


def camera(position=(0.5, -2.0, 3.0), parallel=False):
    result = vtkCamera()
    result.SetPosition(*position)
    result.SetFocalPoint(0.1, 0.2, 0.3)
    result.SetViewUp(0.0, 0.6, 0.8)
    result.SetViewAngle(25.0)
    result.SetParallelProjection(parallel)
    result.SetParallelScale(1.5)
    return result


def matrix(rows):
    result = vtkMatrix4x4()
    result.DeepCopy([number for row in rows for number in row])
    return result


def projected(views, index, point):
    result = vtkMatrix4x4()
    assert views.ComputeModelToClip(index, result)
    return numpy.array(result.MultiplyPoint((*point, 1.0)))


def counters(views, index):
    return (views.GetViewImageMTime(index), views.GetViewCameraMTime(index),
            views.GetViewRangeMTime(index))


def triple(get, *arguments):
    """The three numbers that a getter writes."""
    result = [0.0] * 3
    get(*arguments, result)
    return tuple(result)


def test_list():
    views = new_views()
    for name in "abcd":
        assert views.AddView(name, camera(), image()) == views.FindView(name)

    def names():
        return "".join(views.GetViewName(i) for i in range(views.GetNumberOfViews()))

    for start, end, expected in ((0, 2, "bcad"), (3, 0, "dbca"), (1, 1, "dbca"), (0, 3, "bcad")):
        views.MoveView(start, end)
        assert names() == expected, (names(), expected)
    views.RemoveView(1)
    assert names() == "bad" and views.FindView("c") == -1
    views.SetViewName(0, "a")
    assert views.FindView("a") == 0
    views.RemoveAllViews()
    assert views.GetNumberOfViews() == 0


def test_camera():
    views, given = new_views(), camera()
    views.AddView("a", given, image(8, 4))
    given.SetPosition(9, 9, 9)
    found = views.GetViewCamera(0)
    assert found.GetPosition() == (0.5, -2.0, 3.0) and found.GetFocalPoint() == (0.1, 0.2, 0.3)
    assert found.GetViewAngle() == 25.0 and not found.GetParallelProjection()
    found.SetPosition(9, 9, 9)
    assert views.GetViewCamera(0).GetPosition() == (0.5, -2.0, 3.0), "only a copy was moved"
    assert views.GetViewMatrix(0) is None
    views.SetViewUp(0, (0.1, 3.0, 4.0))
    assert triple(views.GetViewUp, 0) == (0.1, 3.0, 4.0), "as long as it was given"
    assert abs(numpy.linalg.norm(views.GetViewCamera(0).GetViewUp()) - 1.0) < 1e-12


def test_projection():
    """The image's upper right corner is where the angle of view and its aspect say."""
    for parallel in (False, True):
        given = vtkCamera()
        given.SetPosition(0, 0, 5)
        given.SetViewAngle(90.0)
        given.SetParallelProjection(parallel)
        given.SetParallelScale(5.0)
        views = new_views()
        views.AddView("a", given, image(20, 10))
        clip = projected(views, 0, (10.0, 5.0, 0.0))
        assert numpy.allclose(clip[:2] / clip[3], 1.0), clip
        near, far = (projected(views, 0, (0.0, 0.0, z)) for z in (2.0, -2.0))
        assert near[2] / near[3] < far[2] / far[3]
        eye = [0.0] * 4
        assert views.ComputeEye(0, eye)
        assert eye == ([0, 0, 1, 0] if parallel else [0, 0, 5, 1]), eye
        # The same as a matrix, also one of other sign, which projects alike.
        for sign in (1.0, -1.0):
            same = vtkMatrix4x4()
            views.ComputeModelToClip(0, same)
            same.DeepCopy([sign * same.GetElement(i // 4, i % 4) for i in range(16)])
            views.AddView("b", same, image(20, 10))
            last = views.GetNumberOfViews() - 1
            assert views.GetViewCamera(last) is None
            assert views.GetViewMatrix(last).GetElement(3, 3) == same.GetElement(3, 3)
            other = [0.0] * 4
            assert views.ComputeEye(last, other)
            assert numpy.allclose(eye, other), (eye, other)
        views.SetViewCamera(1, given)
        assert views.GetViewMatrix(1) is None and views.GetViewCamera(1)


def test_extreme_points_and_fades():
    views = new_views()
    views.AddView("a", camera(), image())
    assert views.GetViewKind(0) == Views.INDEPENDENT and views.GetFadeMode(0) == Views.CURVE
    for i in range(3):
        assert views.AddExtremePoint(0, (i, 0.5, 1.0)) == i
    views.SetExtremePoint(0, 1, (7, 8, 9))
    views.RemoveExtremePoint(0, 0)
    found = [triple(views.GetExtremePoint, 0, i) for i in range(2)]
    assert found == [(7, 8, 9), (2, 0.5, 1)] and views.GetNumberOfExtremePoints(0) == 2

    def curve():
        result = []
        for i in range(views.GetNumberOfFadePoints(0)):
            point = [0.0] * 2
            views.GetFadePoint(0, i, point)
            result.append(tuple(point))
        return result

    assert curve() == [(0, 1), (0.5, 1), (1, 0)]
    assert views.AddFadePoint(0, 0.5, 0.25) == 2, "after the one of the same angle"
    assert views.AddFadePoint(0, 0.1, 0.75) == 1
    assert curve() == [(0, 1), (0.1, 0.75), (0.5, 1), (0.5, 0.25), (1, 0)]
    views.RemoveAllFadePoints(0)
    assert curve() == []


def test_blend_points():
    views = new_views()
    assert views.AddBlendPoint((1, 2, 3), (0, 0, 2), 40) == 0
    assert views.AddBlendPoint((0, 0, 0), (1, 0, 0), 100) == 1
    views.SetBlendPoint(1, (4, 5, 6), (0, 1, 0), 0)
    views.RemoveBlendPoint(0)
    assert triple(views.GetBlendPointPosition, 0) == (4, 5, 6)
    assert triple(views.GetBlendPointDirection, 0) == (0, 1, 0)
    assert views.GetBlendPointPercentage(0) == 0 and views.GetNumberOfBlendPoints() == 1


def test_counters():
    """A change is counted where it belongs, and nowhere else."""
    views = new_views()
    views.AddView("a", camera(), image(8, 4))
    views.AddView("b", camera(), image(8, 4))
    picture = views.GetViewImage(0)
    mask = image(8, 4, 1)
    changes = (
        (lambda: picture.Modified(), 0),
        (lambda: views.SetViewMask(0, mask), 0),
        (lambda: mask.Modified(), 0),
        (lambda: views.SetViewMask(0, None), 0),
        (lambda: views.SetViewImage(0, image(16, 8)), 0),
        (lambda: views.SetViewCamera(0, camera((1, 2, 3))), 1),
        (lambda: views.SetViewUp(0, (1, 0, 0)), 1),
        (lambda: views.SetViewMatrix(0, vtkMatrix4x4()), 1),
        (lambda: views.SetViewKind(0, Views.DEPENDENT), 2),
        (lambda: views.AddExtremePoint(0, (1, 2, 3)), 2),
        (lambda: views.SetExtremePoint(0, 0, (3, 2, 1)), 2),
        (lambda: views.SetFadeMode(0, Views.EVEN), 2),
        (lambda: views.AddFadePoint(0, 0.25, 0.5), 2),
        (lambda: views.RemoveAllFadePoints(0), 2),
        (lambda: views.SetViewDepth(0, depth_image(16, 8), 1, 2), None),
        (lambda: views.SetViewName(0, "c"), None),
        (lambda: views.AddBlendPoint((0, 0, 0), (0, 0, 1), 50), None),
        (lambda: views.SetBaseCells(20), None),
    )
    for number, (change, which) in enumerate(changes):
        before, other, total = counters(views, 0), counters(views, 1), views.GetMTime()
        change()
        after = counters(views, 0)
        changed = [i for i in range(3) if after[i] > before[i]]
        assert changed == ([] if which is None else [which]), (number, changed)
        assert counters(views, 1) == other and views.GetMTime() > total, number
    # The camera is for the aspect of the image.
    views.SetViewDepth(0, None, 0, 0)
    before = counters(views, 0)
    views.SetViewImage(0, image(8, 8))
    assert counters(views, 0)[1] > before[1]
    # What is said again is no change.
    views.SetViewKind(0, Views.DEPENDENT)
    before = views.GetMTime()
    views.SetViewKind(0, Views.DEPENDENT)
    views.SetFadeMode(0, Views.EVEN)
    views.SetExtremePoint(0, 0, (3, 2, 1))
    views.SetHemisphere(8)
    assert views.GetMTime() == before


def test_copies():
    source, views = new_views(), new_views()
    for name in "ab":
        source.AddView(name, camera(), image(8, 4, 4, seed=ord(name)))
    source.SetViewMask(1, image(8, 4, 1))
    source.SetViewImageFileName(1, "/a/b.png")
    source.AddBlendPoint((1, 2, 3), (0, 0, 1), 25)
    source.SetBaseCells(7)
    source.SetFinestLevel(3)
    source.SetHemisphere(16)
    source.SetHemisphereMap(Views.DISK)
    views.ShallowCopy(source)
    assert views.GetViewImage(0) is source.GetViewImage(0)
    views = new_views()
    views.DeepCopy(source)
    assert views.GetViewImage(0) is not source.GetViewImage(0)
    assert (views.GetBaseCells(), views.GetFinestLevel(), views.GetHemisphere(),
            views.GetHemisphereMap()) == (7, 3, 16, Views.DISK)
    assert views.GetViewImageFileName(1) == "/a/b.png" and views.GetNumberOfBlendPoints() == 1
    # Only what differs is counted when it is copied again.
    before = [counters(views, i) for i in range(2)]
    kept = views.GetViewImage(0)
    views.DeepCopy(source)
    assert [counters(views, i) for i in range(2)] == before and views.GetViewImage(0) is kept
    source.GetViewImage(1).SetScalarComponentFromDouble(7, 3, 0, 2, 1)
    source.SetViewUp(0, (1, 0, 0))
    source.SetFadeMode(0, Views.MIDDLE)
    views.DeepCopy(source)
    after = [counters(views, i) for i in range(2)]
    assert [[after[i][k] > before[i][k] for k in range(3)] for i in range(2)] == [
        [False, True, True], [True, False, False]]
    assert views.GetViewImage(1).GetScalarComponentAsDouble(7, 3, 0, 2) == 1
    expect_error(lambda: views.DeepCopy(None), "expected views to copy, got null")


def test_wrong_indices():
    views = new_views()
    point = [0.0] * 4
    calls = {
        "RemoveView": (), "SetViewName": ("a",), "GetViewName": (), "SetViewImage": (image(),),
        "GetViewImage": (), "SetViewMask": (None,), "GetViewMask": (), "GetViewDepth": (),
        "SetViewDepth": (None, 0, 1), "GetViewDepthRange": (point[:2],),
        "SetViewImageFileName": ("a",), "GetViewImageFileName": (), "SetViewMaskFileName": ("a",),
        "GetViewMaskFileName": (), "SetViewDepthFileName": ("a",), "GetViewDepthFileName": (),
        "SetViewCamera": (camera(),), "GetViewCamera": (), "SetViewMatrix": (vtkMatrix4x4(),),
        "GetViewMatrix": (), "SetViewUp": (point[:3],), "GetViewUp": (point[:3],),
        "ComputeModelToClip": (vtkMatrix4x4(),), "ComputeEye": (point,), "SetViewKind": (1,),
        "GetViewKind": (), "AddExtremePoint": (point[:3],), "SetExtremePoint": (0, point[:3]),
        "GetExtremePoint": (0, point[:3]), "RemoveExtremePoint": (0,), "RemoveAllExtremePoints": (),
        "GetNumberOfExtremePoints": (), "SetFadeMode": (1,), "GetFadeMode": (),
        "AddFadePoint": (0, 1), "GetFadePoint": (0, point[:2]), "RemoveAllFadePoints": (),
        "GetNumberOfFadePoints": (), "GetViewImageMTime": (), "GetViewCameraMTime": (),
        "GetViewRangeMTime": (), "MoveView": (0,),
    }
    for number, range_text in ((0, "there are none"), (2, "expected 0 to 1")):
        for _ in range(number):
            views.AddView("a", camera(), image())
        before = views.GetMTime()
        for name, arguments in calls.items():
            for index in (-1, number):
                expect_error(lambda: getattr(views, name)(index, *arguments),
                             "%s: view %d is out of range" % (name, index), range_text)
        assert views.GetMTime() == before
    expect_error(lambda: views.MoveView(0, 2), "MoveView: view 2 is out of range")
    for call in (lambda: views.GetExtremePoint(0, 0, point[:3]),
                 lambda: views.SetExtremePoint(0, 0, point[:3]),
                 lambda: views.RemoveExtremePoint(0, 0)):
        expect_error(call, "extreme point 0 is out of range; there are none")
    expect_error(lambda: views.GetFadePoint(0, 3, point[:2]), "fade point 3", "0 to 2")
    for call in (lambda: views.GetBlendPointPosition(0, point[:3]),
                 lambda: views.GetBlendPointDirection(0, point[:3]),
                 lambda: views.GetBlendPointPercentage(0), lambda: views.RemoveBlendPoint(0),
                 lambda: views.SetBlendPoint(0, point[:3], (0, 0, 1), 0)):
        expect_error(call, "blend point 0 is out of range")


def test_wrong_values():
    nan, inf = float("nan"), float("inf")
    views = new_views()
    views.AddView("a", camera(), image(8, 4))
    views.SetViewMask(0, image(8, 4, 1))
    views.SetViewDepth(0, depth_image(8, 4), 1, 2)
    before, total = counters(views, 0), views.GetMTime()
    volume = image(2, 2)
    volume.SetDimensions(2, 1, 2)
    short = image(8, 4)
    short.SetDimensions(8, 5, 1)
    for wrong, text in ((None, "got null"), (vtkImageData(), "one slice, got 0 x 0"),
                        (volume, "got 2 x 1 x 2"), (depth_image(8, 4), "expected 8-bit"),
                        (image(8, 4, 5), "expected 1 to 4 components, got 5"),
                        (short, "point scalars")):
        expect_error(lambda: views.SetViewImage(0, wrong), "SetViewImage", text)
        assert expect_error(lambda: views.AddView("b", camera(), wrong), "AddView", text) == -1
        if wrong:
            expect_error(lambda: views.SetViewMask(0, wrong), "SetViewMask", text)
    size = "expected the size of the image, 8 x 4, got 4 x 8"
    expect_error(lambda: views.SetViewMask(0, image(4, 8)), size)
    expect_error(lambda: views.SetViewDepth(0, depth_image(4, 8), 0, 1), size)
    expect_error(lambda: views.SetViewImage(0, image(4, 8)), "size of the mask, 8 x 4, got 4 x 8")
    expect_error(lambda: views.SetViewDepth(0, image(8, 4), 0, 1), "expected 16-bit")
    for low, high in ((1, 1), (2, 1), (nan, 1), (0, inf)):
        expect_error(lambda: views.SetViewDepth(0, depth_image(8, 4), low, high), "two distances")

    for change, text in (
            (lambda c: c.SetPosition(0.1, 0.2, 0.3), "the position is the focal point"),
            (lambda c: c.SetPosition(nan, 0, 0), "expected three finite numbers, got (nan, 0, 0)"),
            (lambda c: c.SetPosition(1e300, 0, 0), "is too far from the position (1e+300, 0, 0)"),
            (lambda c: c.SetViewUp(-0.4, 2.2, -2.7), "does not point across"),
            (lambda c: (c.ParallelProjectionOn(), c.SetParallelScale(0)), "scale above 0, got 0")):
        wrong = camera()
        change(wrong)
        expect_error(lambda: views.SetViewCamera(0, wrong), "SetViewCamera", text)
        assert expect_error(lambda: views.AddView("b", wrong, image()), "AddView", text) == -1
    expect_error(lambda: views.SetViewUp(0, (-0.4, 2.2, -2.7)), "does not point across")
    expect_error(lambda: views.SetViewUp(0, (0, 0, 0)), "does not point across")
    expect_error(lambda: views.SetViewCamera(0, None), "expected a camera, got null")

    sheared = [[1, 2, 3, 4], [2, 1, 0, 1], [3, 3, 3, 5], [0, 0, 0, 1]]
    rounded = numpy.array([[0.1, 0.2, 0.7, 0.4], [1 / 3, -0.9, 0.3, 1 / 7], [0] * 4, [0, 0, 0.3, 1]])
    rounded[2] = 0.3 * rounded[0] + 0.7 * rounded[1]
    assert matrix(rounded).Determinant() != 0.0, "but only by rounding"
    for rows, text in ((sheared, "singular"), ([[0] * 4] * 4, "determinant is 0"),
                       (rounded, "singular"),
                       ([[nan] * 4] * 4, "16 finite numbers")):
        expect_error(lambda: views.SetViewMatrix(0, matrix(rows)), "SetViewMatrix", text)
        assert expect_error(lambda: views.AddView("b", matrix(rows), image()), text) == -1
    expect_error(lambda: views.SetViewMatrix(0, None), "expected a matrix, got null")

    expect_error(lambda: views.SetViewKind(0, 2), "kind 2 is out of range; expected 0 to 1")
    expect_error(lambda: views.SetFadeMode(0, -1), "mode -1 is out of range; expected 0 to 2")
    expect_error(lambda: views.AddExtremePoint(0, (0, inf, 0)), "got (0, inf, 0)")
    expect_error(lambda: views.AddFadePoint(0, 1.5, 0), "angle 1.5 is out of range")
    expect_error(lambda: views.AddFadePoint(0, nan, 0), "angle nan is out of range")
    expect_error(lambda: views.AddFadePoint(0, 0, -0.5), "share -0.5 is out of range")
    expect_error(lambda: views.AddBlendPoint((nan, 0, 0), (0, 0, 1), 1), "got (nan, 0, 0)")
    expect_error(lambda: views.AddBlendPoint((0, 0, 0), (0, 0, 0), 1), "expected a direction")
    expect_error(lambda: views.AddBlendPoint((0, 0, 0), (0, 0, 1), 101), "percentage 101 is out")
    expect_error(lambda: views.SetHemisphere(6), "expected 4, 8 or 16, got 6")
    assert counters(views, 0) == before and views.GetMTime() == total
    assert views.GetNumberOfViews() == 1 and views.GetNumberOfBlendPoints() == 0


def test_far_away_matrix():
    """A map projection's coordinates leave a determinant that is small but not zero."""
    far = camera()
    far.SetPosition(5e6, 5e6, 12.0)
    far.SetFocalPoint(5e6, 5e6 + 10.0, 0.0)
    views, found = new_views(), vtkMatrix4x4()
    views.AddView("a", far, image())
    assert views.ComputeModelToClip(0, found)
    assert views.AddView("b", found, image()) == 1
    eye = [0.0] * 4
    assert views.ComputeEye(1, eye)
    assert numpy.allclose(eye, (5e6, 5e6, 12.0, 1.0), rtol=1e-9, atol=1e-2), eye


test_list()
test_camera()
test_projection()
test_extreme_points_and_fades()
test_blend_points()
test_counters()
test_copies()
test_wrong_indices()
test_wrong_values()
test_far_away_matrix()
assert number_of_errors() == 0
