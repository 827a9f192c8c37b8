# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Nothing but frames moves patterns: whatever else draws in between, pictures stay the same."""

import pattern_scene as scene
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkRenderingCore import (
    vtkHardwareSelector, vtkPropPicker, vtkWindowToImageFilter)

STEPS = 8


class Stage:
    """Two spheres, one hiding the other, that share no state with other stages."""

    def __init__(self, size=(200, 200)):
        self.actors = [scene.actor_of(scene.sphere(24, 0.5, (-0.3, 0.0, 0.3)), "hatch"),
                       scene.actor_of(scene.sphere(24, 0.4, (0.4, 0.1, -0.4)), "halftone")]
        self.renderer = scene.renderer_of(*self.actors)
        self.window = scene.window_of(self.renderer, size=size)
        scene.look(self.renderer)

    def move(self, step):
        move(self.renderer, step)


def move(renderer, step):
    camera = renderer.GetActiveCamera()
    camera.Azimuth(4.0 + step)
    camera.Elevation(1.5)
    camera.Dolly(1.02)
    renderer.ResetCameraClippingRange()


def path(stage, disturb=None):
    """The pictures along a camera path; disturb(stage) after every frame."""
    pictures = []
    for step in range(STEPS):
        stage.move(step)
        pictures.append(scene.draw(stage.window))
        if disturb:
            disturb(stage)
    return pictures


def check_path(disturb=None, stage=None):
    for step, (ours, expected) in enumerate(zip(path(stage or Stage(), disturb), undisturbed)):
        different = (ours != expected).any(axis=2).sum()
        assert different == 0, "%d pixels differ in step %d" % (different, step)


undisturbed = path(Stage())


def test_pictures_differ_along_the_path():
    assert all((a != b).any() for a, b in zip(undisturbed, undisturbed[1:]))
    assert all(0.05 < scene.ink(a) < 0.6 for a in undisturbed)


def test_the_same_path_again():
    check_path()


def test_same_frame_twice():
    def again(stage):
        first = scene.picture(stage.window)
        for _ in range(3):
            assert (scene.draw(stage.window) == first).all(), "the same frame drawn anew differs"
    check_path(again)


def test_frames_of_another_window():
    other = scene.window_of(scene.renderer_of(), size=(120, 90))
    renderer = other.GetRenderers().GetFirstRenderer()

    def draw_other(stage):
        for actor in stage.actors:
            renderer.AddActor(actor)
        renderer.ResetCamera()
        renderer.GetActiveCamera().Azimuth(17.0)
        other.Render()
    check_path(draw_other)


def test_two_viewports_follow_their_own_cameras():
    stage = Stage()
    left, right = stage.renderer, scene.renderer_of(*stage.actors)
    stage.window.SetSize(400, 200)
    left.SetViewport(0.0, 0.0, 0.5, 1.0)
    right.SetViewport(0.5, 0.0, 1.0, 1.0)
    stage.window.AddRenderer(right)
    right.SetActiveCamera(copied_camera(left))
    for step, expected in enumerate(undisturbed):
        if step % 2 == 0:
            right.GetActiveCamera().Azimuth(-9.0)
        stage.move(step)
        found = scene.draw(stage.window)[:, :200]
        assert (found == expected).all(), step
    assert (scene.picture(stage.window)[:, 200:] != undisturbed[-1]).any()


def copied_camera(renderer):
    camera = renderer.MakeCamera()
    camera.DeepCopy(renderer.GetActiveCamera())
    return camera


def test_viewport_with_an_offset():
    """The same picture wherever the viewport lies in its window, but for rounding of positions."""
    stage = Stage((450, 330))
    stage.renderer.SetViewport(100 / 450, 80 / 330, 300 / 450, 280 / 330)
    for step, expected in enumerate(undisturbed):
        stage.move(step)
        found = scene.draw(stage.window)[80:280, 100:300]
        difference = abs(found.astype(int) - expected)
        assert difference.max() <= 8 and (difference > 0).mean() < 0.01, (step, difference.max())


def test_stereo():
    for kind in ("RedBlue", "Anaglyph", "SplitViewportHorizontal", "Interlaced", "Left", "Right"):
        def stereo(stage, name="SetStereoTypeTo" + kind):
            getattr(stage.window, name)()
            stage.window.StereoRenderOn()
            stage.window.Render()
            stage.window.StereoRenderOff()
        check_path(stereo)


def test_path_in_stereo():
    """The pattern moves with the view between the eyes: where a path ends, stereo or not."""
    plain, stereo = Stage(), Stage()
    stereo.window.SetStereoTypeToRedBlue()
    stereo.window.StereoRenderOn()
    for step in range(STEPS):
        for stage in (plain, stereo):
            stage.move(step)
            stage.window.Render()
    stereo.window.StereoRenderOff()
    stereo.window.Render()
    for a, b in zip(plain.actors, stereo.actors):
        expected = scene.drawn_frame(a.GetMapper(), plain.renderer)
        found = scene.drawn_frame(b.GetMapper(), stereo.renderer)
        # What is hidden is measured for one eye.
        assert abs(expected - found)[:2].max() < 0.5, (expected, found)


def tiles(stage):
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(stage.window)
    grabber.SetScale(3)
    grabber.ReadFrontBufferOff()
    grabber.Update()
    assert grabber.GetOutput().GetDimensions()[:2] == (600, 600)


def elsewhere(disturb):
    """The same from another point of view, from which no frame was drawn."""
    def there_and_back(stage):
        camera = stage.renderer.GetActiveCamera()
        before = copied_camera(stage.renderer)
        camera.Azimuth(25.0)
        camera.Roll(10.0)
        disturb(stage)
        camera.DeepCopy(before)
    return there_and_back


def test_tiles():
    check_path(tiles)
    check_path(elsewhere(tiles))


def test_selection():
    def select(stage):
        selector = vtkHardwareSelector()
        selector.SetRenderer(stage.renderer)
        selector.SetArea(0, 0, 199, 199)
        selector.SetFieldAssociation(vtkDataObject.FIELD_ASSOCIATION_CELLS)
        selection = selector.Select()
        assert selection.GetNumberOfNodes() == 2, selection.GetNumberOfNodes()
        props = {selection.GetNode(i).GetProperties().Get(selection.GetNode(i).PROP())
                 for i in range(2)}
        assert props == set(stage.actors)
        assert all(selection.GetNode(i).GetSelectionList().GetNumberOfTuples() > 50
                   for i in range(2))
    check_path(select)
    check_path(elsewhere(select))


def test_picking():
    def pick(stage):
        picker = vtkPropPicker()
        assert picker.Pick(80, 100, 0, stage.renderer)
        assert picker.GetActor() in stage.actors
    check_path(pick)


def peeling(stage, on):
    stage.renderer.SetUseDepthPeeling(on)
    stage.renderer.SetMaximumNumberOfPeels(6)
    stage.window.SetAlphaBitPlanes(on)
    for actor in stage.actors:
        actor.GetProperty().SetOpacity(0.5 if on else 1.0)


def test_depth_peeling():
    def peel(stage):
        before = scene.picture(stage.window)
        peeling(stage, True)
        assert (scene.draw(stage.window) != before).any()
        peeling(stage, False)
        assert (scene.draw(stage.window) == before).all()
    check_path(peel)


def test_styles_in_between():
    """Outline or layer off for one picture."""
    def toggle(stage):
        style = stage.actors[0].GetMapper().GetStyle()
        style.OutlineOff()
        style.GetLayer(0).EnabledOff()
        stage.window.Render()
        style.GetLayer(0).EnabledOn()
        style.OutlineOn()
    check_path(toggle)


def stand_ins(stage):
    """Coarse mappers for the actors of a stage."""
    coarse = []
    for actor, (radius, center) in zip(stage.actors, ((0.5, (-0.3, 0.0, 0.3)), (0.4, (0.4, 0.1, -0.4)))):
        mapper = actor.GetMapper()
        coarse.append(scene.actor_of(scene.sphere(8, radius, center), mapper.GetStyle()).GetMapper())
        coarse[-1].SetTrackedMapper(mapper)
    return coarse


def put(mappers, stage):
    for actor, mapper in zip(stage.actors, mappers):
        actor.SetMapper(mapper)


def test_stand_ins_of_lower_detail():
    """Frames that a stand-in draws on the way leave patterns to the next full frame."""
    plain, other = Stage(), Stage()
    full = [actor.GetMapper() for actor in other.actors]
    coarse = stand_ins(other)
    for step in range(STEPS):
        for stage in (plain, other):
            stage.move(step)
        if step % 3 == 1:
            put(coarse, other)
            drawn = scene.draw(other.window)
            assert 0.05 < scene.ink(drawn) < 0.6
            put(full, other)
        else:
            expected, found = scene.draw(plain.window), scene.draw(other.window)
            assert (expected == found).all(), "%d: %d pixels" % (
                step, (expected != found).any(axis=2).sum())


def test_stand_ins_that_come_first():
    """Before the full surface is known, or was ever drawn: there is a pattern, and no trace of it."""
    expected = scene.draw(Stage().window)
    for known in (True, False):
        stage = Stage()
        camera = copied_camera(stage.renderer)
        full = [actor.GetMapper() for actor in stage.actors]
        sources = [mapper.GetInputAlgorithm() for mapper in full]
        put(stand_ins(stage), stage)
        for mapper in full:
            if known:
                mapper.Update()
            else:
                mapper.RemoveAllInputConnections(0)
        for step in range(2):
            stage.move(step)
            found = scene.ink(scene.draw(stage.window))
            assert abs(found - scene.ink(expected)) < 0.3 * scene.ink(expected), (known, found)
        for mapper, source in zip(full, sources):
            mapper.SetInputConnection(source.GetOutputPort())
        put(full, stage)
        stage.renderer.SetActiveCamera(camera)
        assert (scene.draw(stage.window) == expected).all(), known


scene.run(globals())
