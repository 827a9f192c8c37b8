# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tone comes from light as VTK computes it, or from data; what is wrong with the data is said."""

import hachure
import numpy
import pattern_scene as scene
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper

SIZE = 256
GREY = 191  # 0.75, the colour of surface without data
# Half a level of the picture where it is lightest, and half a level of 255 tones.
TONE_ERROR = 0.0064


def grid(cells):
    """A square that fills the picture, in equal cells across; arrays can be added to it."""
    source = vtkPlaneSource()
    source.SetOrigin(-1, -1, 0)
    source.SetPoint1(1, -1, 0)
    source.SetPoint2(-1, 1, 0)
    source.SetResolution(cells, 1)
    source.Update()
    return source.GetOutput()


def array_style(name, low=0.0, high=1.0, size=0.5):
    """Under two pixels per period the ink is an even grey, whose value is the tone."""
    style = scene.constant_style(0, size, 0.0)
    tone = style.GetLayer(0).GetTone()
    tone.SetSource(tone.ARRAY)
    tone.SetArrayName(name)
    tone.SetRange(low, high)
    return style


def stage(data, style):
    actor = scene.actor_of(data, style)
    actor.GetProperty().LightingOff()
    actor.GetMapper().ScalarVisibilityOff()
    renderer = scene.renderer_of(actor, background=(1.0, 0.0, 0.0))
    window = scene.window_of(renderer, size=(SIZE, SIZE))
    camera = scene.look(renderer)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(1.0)
    return actor, renderer, window


def tones(pixels):
    """Tone of each column."""
    assert (pixels == pixels[:1]).all(), "rows differ"
    return 1.0 - scene.linear(pixels[0]).mean(axis=1)


def test_point_array():
    data = grid(4)
    x = numpy.array([data.GetPoint(i)[0] for i in range(data.GetNumberOfPoints())])
    scene.add_array(data.GetPointData(), "ramp", 10.0 * x)
    expected = (numpy.arange(SIZE) + 0.5) / SIZE
    _, _, window = stage(data, array_style("ramp", -10.0, 10.0))
    assert abs(tones(scene.draw(window)) - expected).max() < TONE_ERROR
    style = array_style("ramp", 10.0, -10.0)
    _, _, window = stage(data, style)
    assert abs(tones(scene.draw(window)) - expected[::-1]).max() < TONE_ERROR, "range from high to low"
    style.GetLayer(0).GetTone().SetRange(-5.0, 5.0)
    clamped = numpy.clip(2.0 * expected - 0.5, 0.0, 1.0)
    assert abs(tones(scene.draw(window)) - clamped).max() < TONE_ERROR, "values outside are clamped"
    style.GetLayer(0).GetTone().SetRange(-10.0, 10.0)
    style.GetLayer(0).GetTone().InvertOn()
    assert abs(tones(scene.draw(window)) - expected[::-1]).max() < TONE_ERROR, "inverted"
    style.GetLayer(0).GetTone().InvertOff()
    style.GetLayer(0).GetTone().SetGamma(2.0)
    assert abs(tones(scene.draw(window)) - expected**2).max() < TONE_ERROR, "gamma"


def test_cell_array_with_nan():
    data = grid(8)
    values = numpy.array([0.0, 0.25, numpy.nan, 0.5, 0.75, numpy.inf, 1.0, 2.0])
    scene.add_array(data.GetCellData(), "cells", values)
    _, _, window = stage(data, array_style("cells"))
    pixels = scene.draw(window)
    columns = pixels[0].reshape(8, SIZE // 8, 3)[:, 4:-4]
    for column, value in zip(columns, values):
        if numpy.isfinite(value):
            ink = 1.0 - scene.linear(column)
            assert abs(ink - min(value, 1.0)).max() < TONE_ERROR, (value, ink)
        else:
            assert (abs(column.astype(int) - GREY) <= 1).all(), (value, column)


def test_nan_color_of_the_lookup_table():
    data = grid(2)
    scene.add_array(data.GetCellData(), "cells", [numpy.nan, 0.0])
    actor, _, window = stage(data, array_style("cells"))
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("cells")
    mapper.GetLookupTable().SetNanColor(0.0, 1.0, 0.0, 1.0)
    pixels = scene.draw(window)
    assert (pixels[0, 8] == (0, 255, 0)).all() and (pixels[0, -8] == 255).all(), pixels[0]


def test_magnitude_and_component():
    data = grid(1)
    scene.add_array(data.GetCellData(), "vector", [[0.3, 0.4, 0.0]])
    style = array_style("vector")
    _, _, window = stage(data, style)
    for component, tone in ((0, 0.3), (1, 0.4), (2, 0.0), (-1, 0.5)):
        style.GetLayer(0).GetTone().SetComponent(component)
        assert abs(tones(scene.draw(window)) - tone).max() < TONE_ERROR, component


def test_association():
    data = grid(1)
    scene.add_array(data.GetPointData(), "both", [0.2] * 4)
    scene.add_array(data.GetCellData(), "both", [0.8])
    style = array_style("both")
    tone = style.GetLayer(0).GetTone()
    _, _, window = stage(data, style)
    for association, value in (
            (tone.POINTS_THEN_CELLS, 0.2), (tone.CELLS, 0.8), (tone.POINTS, 0.2)):
        tone.SetArrayAssociation(association)
        assert abs(tones(scene.draw(window)) - value).max() < TONE_ERROR, association


def check_error(style, data, *expected):
    _, _, window = stage(data, style)
    pixels = scene.draw(window)
    window.Render()
    scene.expect_messages(*expected)
    assert (abs(pixels.astype(int) - GREY) <= 1).all(), pixels[0, 0]


def test_wrong_arrays():
    data = grid(2)
    scene.add_array(data.GetCellData(), "cells", [0.5, 0.5])
    names = vtkStringArray()
    names.SetName("names")
    names.InsertNextValue("a")
    names.InsertNextValue("b")
    data.GetCellData().AddArray(names)
    check_error(array_style("none"), data, "no point or cell array 'none'")
    check_error(array_style(""), data, "no point or cell array ''")
    check_error(array_style("names"), data, "tone array 'names' is a vtkStringArray; expected numbers")
    check_error(array_style("cells", 2.0, 2.0), data,
                "tone range of array 'cells' is [2, 2]; expected two different finite numbers")
    check_error(array_style("cells", 0.0, float("nan")), data, "tone range of array 'cells' is [0, nan]")
    style = array_style("cells")
    style.GetLayer(0).GetTone().SetComponent(3)
    check_error(style, data, "tone array 'cells' has 1 components; component 3 was asked for")
    style = array_style("cells")
    style.GetLayer(0).GetTone().SetArrayAssociation(hachure.vtkPatternTone.POINTS)
    check_error(style, data, "no point array 'cells'")


def test_error_ends_when_the_array_comes():
    data = grid(1)
    _, _, window = stage(data, array_style("late"))
    window.Render()
    scene.expect_messages("no point or cell array 'late'")
    scene.add_array(data.GetCellData(), "late", [0.5])
    data.Modified()
    assert abs(tones(scene.draw(window)) - 0.5).max() < TONE_ERROR


def test_block_without_the_array():
    blocks = vtkMultiBlockDataSet()
    left, right = grid(2), grid(2)
    for block, cell in ((left, 0), (right, 1)):
        ids = block.GetCellData()
        scene.add_array(ids, "dummy", [0, 0])
        block.BuildCells()
        block.DeleteCell(1 - cell)
        block.RemoveDeletedCells()
    scene.add_array(left.GetCellData(), "cells", [1.0])
    blocks.SetBlock(0, left)
    blocks.SetBlock(1, right)
    _, _, window = stage(blocks, array_style("cells"))
    pixels = scene.draw(window)
    assert (pixels[0, :120] == 0).all()
    assert (abs(pixels[0, 136:].astype(int) - GREY) <= 1).all(), pixels[0, 200]


def lit_scene(mapper, ambient, diffuse, color=(1.0, 1.0, 1.0)):
    actor = vtkActor()
    actor.SetMapper(mapper)
    surface = actor.GetProperty()
    surface.SetAmbient(ambient)
    surface.SetDiffuse(diffuse)
    surface.SetColor(*color)
    surface.SetInterpolationToPhong()
    renderer = scene.renderer_of(actor, background=(1.0, 1.0, 1.0))
    renderer.AutomaticLightCreationOff()
    for position, intensity, light_color in (
            ((3, 4, 5), 0.7, (1.0, 0.9, 0.7)), ((-4, 1, 2), 0.4, (0.6, 0.8, 1.0))):
        light = vtkLight()
        light.SetPosition(*position)
        light.SetIntensity(intensity)
        light.SetColor(*light_color)
        renderer.AddLight(light)
    scene.look(renderer, (0.0, 0.0, 2.2))
    return renderer


def lit_pictures(ambient, diffuse, color, source):
    """Luma of VTK's own picture, and linear paper of ours."""
    data = scene.sphere()
    stock = vtkPolyDataMapper()
    stock.SetInputConnection(data.GetOutputPort())
    ours = hachure.vtkPatternMapper()
    ours.SetInputConnection(data.GetOutputPort())
    style = scene.constant_style(0, 0.5, 0.0)
    style.GetLayer(0).GetTone().SetSource(source)
    ours.SetStyle(style)
    tone = hachure.vtkPatternTone
    stock_color = color if source == tone.LIT_COLOR else (1.0, 1.0, 1.0)
    first = scene.window_of(lit_scene(stock, ambient, diffuse, stock_color), size=(SIZE, SIZE))
    second = scene.window_of(lit_scene(ours, ambient, diffuse, color), size=(SIZE, SIZE))
    luma = scene.draw(first) @ numpy.array([0.2126, 0.7152, 0.0722]) / 255.0
    return luma, scene.linear(scene.draw(second)).mean(axis=2)


def test_lit_tone_is_that_of_vtks_white_surface():
    tone = hachure.vtkPatternTone
    for ambient, diffuse in ((0.0, 1.0), (0.3, 0.6), (1.0, 0.0)):
        luma, paper = lit_pictures(ambient, diffuse, (0.9, 0.2, 0.1), tone.LIT)
        assert abs(luma - paper).max() < 0.008, (ambient, diffuse, abs(luma - paper).max())


def test_lit_color_has_the_surfaces_colour():
    tone = hachure.vtkPatternTone
    luma, paper = lit_pictures(0.2, 0.8, (0.9, 0.4, 0.1), tone.LIT_COLOR)
    assert abs(luma - paper).max() < 0.008, abs(luma - paper).max()


scene.run(globals())
