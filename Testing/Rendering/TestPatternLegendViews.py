# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Legends in several views, sizes, screenshots and on several grounds; and what is told of wrong input."""

import hachure
import numpy
import pattern_scene as scene
from legend_scene import Stage, array_style, image_layer
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import vtkTextProperty, vtkWindowToImageFilter

Image = hachure.vtkImagePatternLayer
Style = hachure.vtkPatternStyle
SIZE = (240, 180)


class View:
    """A lit ball and its legend."""

    def __init__(self, actor, legend=None, size=SIZE):
        self.renderer = scene.renderer_of(actor)
        self.window = scene.window_of(self.renderer, size=size)
        scene.look(self.renderer)
        if legend:
            self.renderer.AddViewProp(legend)

    def draw(self):
        return scene.draw(self.window)


def ball():
    actor = scene.actor_of(scene.sphere(), "hatch")
    legend = hachure.vtkPatternLegendActor()
    legend.SetSurface(actor)
    legend.SetPosition(0.76, 0.05)
    legend.SetPosition2(0.2, 0.9)
    return actor, legend


def test_the_surface_stays():
    """A legend changes no pixel beside it, whatever frame it is drawn in."""
    actor, legend = ball()
    plain, shown = View(actor), View(actor, legend)
    for _ in range(3):
        pictures = plain.draw(), shown.draw()
        assert (pictures[0][:, :170] == pictures[1][:, :170]).all()
        assert (pictures[0][:, 182:] != pictures[1][:, 182:]).any()
        for view in plain, shown:
            view.renderer.GetActiveCamera().Azimuth(5.0)
            view.renderer.ResetCameraClippingRange()


def test_two_views():
    """One legend in two windows of different size; each shows what it shows alone."""
    actor, legend = ball()
    views = [View(actor, legend), View(actor, legend, (300, 200))]
    first = [view.draw() for view in views]
    again = [view.draw() for view in views]
    for before, after in zip(first, again):
        assert (before == after).all()
    alone = View(*ball(), (300, 200)).draw()
    assert (alone == first[1]).all()


def test_resizing():
    """Back at its size the window shows what it showed; without room there is nothing."""
    stage = Stage(array_style(image_layer(Image.HALFTONE)), SIZE)
    before = stage.draw()
    stage.window.SetSize(400, 300)
    larger = stage.draw()
    assert (larger < 128).any(axis=2).sum() > 1.5 * (before < 128).any(axis=2).sum()
    stage.window.SetSize(*SIZE)
    assert (stage.draw() == before).all()
    stage.legend.SetPosition2(0.0, 0.0)
    stage.draw()
    assert stage.legend.GetNumberOfSwatches() == 0
    stage.legend.SetPosition2(0.94, 0.94)
    stage.renderer.SetViewport(0.5, 0.5, 0.5, 0.5)
    stage.draw()
    stage.renderer.SetViewport(0.0, 0.0, 1.0, 1.0)
    assert (stage.draw() == before).all()
    stage.window.SetSize(9, 7)
    stage.draw()


def screenshot(window, scale):
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.SetScale(scale)
    grabber.ReadFrontBufferOff()
    grabber.Update()
    image = grabber.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)


def halved(pixels):
    height, width, _ = pixels.shape
    return scene.linear(pixels).reshape(height // 2, 2, width // 2, 2, 3).mean(axis=(1, 3))


def test_screenshot_in_tiles():
    """Twice as large, the swatches show the same marks, finer, and the texts stand where they stood."""
    stage = Stage(array_style(image_layer(Image.HALFTONE)), SIZE)
    stage.legend.SetTitle("title")
    small = stage.draw()
    places = [0, 0, 0, 0], [0, 0, 0, 0]
    stage.legend.GetSwatch(0, [0.0, 0.0], places[0])
    large = screenshot(stage.window, 2)
    stage.legend.GetSwatch(0, [0.0, 0.0], places[1])
    assert places[1] == [2 * number for number in places[0]], places
    difference = abs(halved(large) - scene.linear(small)).mean(axis=2)
    x, y, width, height = places[0]
    swatch = difference[y : y + height, x : x + width]
    assert swatch.mean() < 0.02, swatch.mean()
    inked = [(pixels < 128).any(axis=2) for pixels in (small, large)]
    inked[0][y - 2 : y + height + 2, : x + width + 2] = False
    inked[1][2 * y - 4 : 2 * (y + height) + 4, : 2 * (x + width) + 4] = False
    boxes = [(rows.min(), rows.max(), columns.min(), columns.max())
             for rows, columns in map(numpy.nonzero, inked)]
    assert abs(numpy.array(boxes[1]) / 2.0 - boxes[0]).max() <= 3.0, boxes
    assert (stage.draw() == small).all(), "the screenshot left a trace"
    # The same as a window of that size at two pixels for one.
    style = array_style(image_layer(Image.HALFTONE))
    style.SetPixelScale(2.0)
    whole = Stage(style, (2 * SIZE[0], 2 * SIZE[1]))
    whole.legend.SetTitle("title")
    assert abs(whole.draw().astype(int) - large).mean() < 0.5


def test_grounds():
    """Texts are seen on any ground, which shows between marks without paper."""
    style = array_style(image_layer(Image.HATCH))
    style.SetPaperSource(Style.NO_PAPER)
    for ground, text in ((0.1, 0.2, 0.5), 255), ((0.9, 0.8, 0.3), 0):
        stage = Stage(style, SIZE, ground)
        stage.legend.SetValueRange(-0.2, 1.2)  # tone 0 and tone 1 at the ends
        picture = stage.draw()
        (_, _, pixels), = stage.swatches(picture)
        bare = numpy.round(255.0 * numpy.array(ground))
        assert abs(pixels[2].astype(int) - bare).max() <= 1, "tone 0 is bare ground"
        assert (pixels[-3] == 0).all(), "tone 1 is ink"
        assert (picture == text).all(axis=2).sum() > 40, "no text that is seen"
    stage = Stage(style, SIZE, (0.0, 0.0, 0.0))
    stage.legend.SetValueRange(-0.2, 1.2)
    stage.window.SetAlphaBitPlanes(1)
    stage.renderer.SetBackgroundAlpha(0.0)
    stage.draw()
    place = [0, 0, 0, 0]
    stage.legend.GetSwatch(0, [0.0, 0.0], place)
    x, y, width, height = place
    data = vtkUnsignedCharArray()
    stage.window.GetRGBACharPixelData(x, y, x + width - 1, y + height - 1, 0, data)
    alpha = vtk_to_numpy(data).reshape(height, width, 4)[:, :, 3] / 255.0
    assert alpha[2].max() == 0.0 and alpha[-3].min() == 1.0
    assert abs(alpha.mean() - 0.5) < 0.05, alpha.mean()
    stage.legend.AutomaticColorOff()
    font = vtkTextProperty()
    font.SetColor(1.0, 0.0, 0.0)
    stage.legend.SetLabelTextProperty(font)
    assert (stage.draw() == (255, 0, 0)).all(axis=2).any()


def test_labels_find_room():
    stage = Stage(array_style(image_layer(Image.HATCH), ends=(0.0, 1.0)), (300, 300))
    stage.legend.SetNumberOfLabels(11)
    counts = []
    for height in 0.9, 0.5, 0.25:
        stage.legend.SetPosition2(0.9, height)
        stage.draw()
        counts.append(len(stage.labels()))
    assert counts[0] == 11 and 11 > counts[1] > counts[2] > 0, counts
    stage.legend.SetPosition2(0.9, 0.9)
    stage.legend.SetOrientation(stage.legend.HORIZONTAL)
    stage.legend.SetLabelFormat("%.5f m")
    stage.draw()
    assert 1 < len(stage.labels()) < 6 and stage.labels()[0][0] == "0.00000 m", stage.labels()
    stage.legend.RoundLabelsOff()
    stage.legend.SetNumberOfLabels(2)
    stage.legend.SetLabelFormat("%g")
    stage.legend.SetValueRange(0.123, 0.456)
    stage.draw()
    assert stage.labels() == [("0.123", 0.0), ("0.456", 1.0)]


def test_styles_change():
    """Another style, or another size of its marks, shows at once."""
    actor, legend = ball()
    view = View(actor, legend)
    pictures = [view.draw()]
    actor.GetMapper().GetStyle().GetLayer(0).SetSize(14.0)
    pictures.append(view.draw())
    actor.GetMapper().SetStyle(hachure.style("halftone"))
    pictures.append(view.draw())
    for before, after in zip(pictures, pictures[1:]):
        assert (before[:, 182:] != after[:, 182:]).any()


def test_every_preset():
    """Each has a legend; that of views says that there is none."""
    stage = Stage(None, (120, 100))
    for index in range(Style.GetNumberOfPresets()):
        style = hachure.style(Style.GetPresetName(index))
        stage.legend.SetStyle(style)
        picture = stage.draw()
        if Style.GetPresetName(index) == "view":
            scene.expect_messages("the style has no layer with a tone that could be shown")
        else:
            (_, _, pixels), = stage.swatches(picture)
            assert pixels.std() > 3.0, Style.GetPresetName(index)
            scene.expect_messages()


def test_wrong_input():
    stage = Stage(None, SIZE)
    stage.draw()
    stage.draw()
    scene.expect_messages("no style to show; expected SetStyle, or SetSurface")
    stage.legend.SetStyle(Style())
    stage.draw()
    scene.expect_messages("the style has no layer with a tone that could be shown")
    stage.legend.SetStyle(array_style(image_layer(Image.HATCH), "depth", (3.0, 3.0)))
    stage.draw()
    scene.expect_messages("tone range of array 'depth' is [3, 3]; expected two different finite numbers")
    assert stage.legend.GetNumberOfSwatches() == 0
    stage.legend.SetStyle(array_style(image_layer(Image.HATCH)))
    stage.legend.SetLayer(3)
    stage.draw()
    scene.expect_messages("the style has no layer 3 that could be shown")
    assert stage.legend.GetToneAt(0.5) == -1.0
    scene.expect_messages("the style has no layer 3 that could be shown")
    stage.legend.SetLayer(-1)
    for wrong in "%s", "%d", "none", "%g and %g", "%*g", "%.9999999999g", "":
        stage.legend.SetLabelFormat(wrong)
        stage.draw()
        scene.expect_messages("label format '" + wrong + "' takes no number")
        assert stage.labels()[-1][0] == "1"


scene.run(globals())
