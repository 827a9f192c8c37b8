# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Styles read and write JSON without loss, and say where a wrong one is wrong."""

import json
import os
import tempfile

import hachure
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkImagingSources import vtkImageCanvasSource2D
from vtkmodules.vtkIOImage import vtkBMPWriter, vtkPNGWriter

errors = []


@calldata_type(VTK_STRING)
def remember(_caller, _event, text):
    errors.append(text)


def new_style():
    style = hachure.vtkPatternStyle()
    style.AddObserver("ErrorEvent", remember)
    return style


def expect_error(result, *parts):
    """The call failed with exactly one message, which holds all parts."""
    assert result in (False, "", None), result
    assert len(errors) == 1, errors
    for part in parts:
        assert part in errors[0], "%r is not in %r" % (part, errors[0])
    errors.clear()


def write_picture(name, writer):
    writer.SetFileName(name)
    writer.SetInputData(new_picture())
    writer.Write()


def new_picture():
    canvas = vtkImageCanvasSource2D()
    canvas.SetScalarTypeToUnsignedChar()
    canvas.SetExtent(0, 15, 0, 15, 0, 0)
    canvas.SetDrawColor(90)
    canvas.FillBox(0, 7, 0, 15)
    canvas.Update()
    return canvas.GetOutput()


def document(layer="", top=""):
    """A style with one layer; both arguments are further members."""
    return '{"hachure": 1%s, "layers": [{"type": "image"%s}]}' % (
        ", " + top if top else "",
        ", " + layer if layer else "",
    )


def values(thing):
    """All that has a setter, but what belongs to the output or to VTK."""
    names = (n[3:] for n in dir(thing) if n.startswith("Get"))
    names = (n for n in names if hasattr(thing, "Set" + n) and not n.startswith("Object"))
    skipped = ("Tone", "PixelScale", "FinalQuality", "Debug", "GlobalWarningDisplay", "MemkindDirectory",
               "ReferenceCount")
    return {n: getattr(thing, "Get" + n)() for n in names if n not in skipped}


def test_every_parameter_of_noise_survives():
    style, layer = new_style(), hachure.vtkNoiseLayer()
    layer.SetColor(1.0 / 3.0, 0.7, 1.0)
    layer.SetColorSource(layer.SURFACE)
    layer.SetOpacity(0.35)
    layer.SetBlendMode(layer.OVERLAY)
    layer.SetSeed(4294967295)
    layer.EnabledOff()
    layer.SetKind(layer.PHASOR)
    layer.SetSize(0.6)
    layer.SetSizeUnit(layer.MILLIMETRES)
    layer.SetRegularity(1.0 / 3.0)
    layer.SetAngle(-30.5)
    layer.SetSpread(12.5)
    layer.SetDirectionArrayName('a "name"')
    layer.SetControl(layer.ARRAY)
    layer.SetControlArrayName("depth")
    layer.SetControlRange(1e300, -1.0 / 3.0)
    layer.SetSizeFactors(0.5, 3.0)
    layer.SetRegularityFactors(0.7, 1.5)
    layer.SetSmoothness(0.25)
    layer.SetOverlap(48.5)
    layer.SetFade(2.5)
    layer.SetLife(3)
    layer.SetDistribution(layer.CLASSIC)
    layer.ObjectTestOff()
    layer.TriangleTestOn()
    layer.DepthTestOff()
    layer.PartialVisibilityOff()
    style.AddLayer(layer)
    copy = new_style()
    assert copy.FromJson(style.ToJson()), errors
    mine, default = values(layer), values(hachure.vtkNoiseLayer())
    assert mine == values(copy.GetLayer(0)), (mine, values(copy.GetLayer(0)))
    files = ("Image", "ImageFileName", "ThresholdImage", "ThresholdImageFileName")
    same = [n for n in mine if mine[n] == default[n] and n not in files]
    assert not same, "the test left the defaults of " + str(same)


def test_every_parameter_of_stipples_survives():
    style, layer = new_style(), hachure.vtkStippleLayer()
    layer.SetColor(1.0 / 3.0, 0.7, 1.0)
    layer.SetColorSource(layer.SURFACE)
    layer.SetOpacity(0.35)
    layer.SetBlendMode(layer.OVERLAY)
    layer.SetSeed(4294967295)
    layer.EnabledOff()
    layer.SetSize(0.6)
    layer.SetSizeUnit(layer.MILLIMETRES)
    layer.SetCarrier(layer.SIZE)
    layer.SetGrowth(1.0 / 3.0)
    layer.SetGrowthFrames(17)
    layer.SetLife(3)
    layer.SetOrder(layer.CLASSIC)
    layer.SetNumberOfPoints(12345)
    layer.RefinementOff()
    layer.SetMemoryBudget(77)
    style.AddLayer(layer)
    copy = new_style()
    assert copy.FromJson(style.ToJson()), errors
    assert '"growthFrames": 17' in " ".join(style.ToJson().split()).replace('" :', '":')
    mine, default = values(layer), values(hachure.vtkStippleLayer())
    assert mine == values(copy.GetLayer(0)), (mine, values(copy.GetLayer(0)))
    same = [n for n in mine if mine[n] == default[n]]
    assert not same, "the test left the defaults of " + str(same)


def test_wrong_factors_of_noise():
    style = new_style()
    text = '{"hachure": 1, "layers": [{"type": "noise", "field": {"%s": [1, 100]}}]}'
    for key in ("sizeFactors", "regularityFactors"):
        errors.clear()
        assert not style.FromJson(text % key)
        assert "layers[0].field.%s[1]" % key in errors[-1] and "0.25" in errors[-1], errors
    errors.clear()


def test_every_parameter_survives():
    style = new_style()
    tone, layer = hachure.vtkPatternTone(), hachure.vtkImagePatternLayer()
    tone.SetSource(tone.ARRAY)
    tone.SetArrayName('a "name" with \u00e9')
    tone.SetArrayAssociation(tone.CELLS)
    tone.SetComponent(-1)
    tone.SetRange(1e300, -1.0 / 3.0)
    tone.SetConstant(0.1 + 0.2)
    tone.SetGamma(2.2)
    tone.InvertOn()
    tone.SetRemap(tone.SMOOTHSTEP)
    tone.SetSteps(7)
    tone.SetRemapRange(0.9, 1.0 / 3.0)
    tone.SetLightIndex(3)
    tone.SetHighlightPower(45.5)
    tone.SetBlackGeneration(0.7)
    layer.SetTone(tone)
    layer.SetColor(1.0 / 3.0, 0.7, 1.0)
    layer.SetOpacity(0.35)
    layer.SetBlendMode(layer.OVERLAY)
    layer.SetSeed(4294967295)
    layer.EnabledOff()
    layer.SetPattern(layer.HALFTONE)
    layer.SetSize(0.6)
    layer.SetSizeUnit(layer.MILLIMETRES)
    layer.SetAngle(-30.5)
    layer.SetIrregularity(0.25)
    layer.SetDensities(3)
    layer.SetDabLength(4.5)
    layer.SetDabJitter(30)
    layer.SetDabDensity(2)
    layer.SetBristles(0.25)
    layer.SetBump(0.75)
    layer.SetColorVariation(0.125)
    layer.SetPaperContrast(0.4)
    layer.SetPaperSize(0.3)
    layer.SetPaperSizeUnit(layer.MILLIMETRES)
    layer.SetColorSource(layer.SURFACE)
    layer.SetMotion(layer.DYNAMIC_SOLID)
    layer.SetSurfacePeriod(0.125)
    layer.SetLodStart(1.1)
    layer.SetLodEnd(1.9)
    layer.SetPatchPower(0.5)
    layer.SetTransition(layer.BLEND_SCREENS)
    layer.SetPace(layer.CLASSIC)
    layer.SetTransitionTime(0.4)
    layer.SetToneCorrection(layer.TRANSITION_ONLY)
    style.AddLayer(layer)
    style.AddLayer(hachure.vtkImagePatternLayer())
    style.SetPaperSource(style.FLAT)
    style.SetPaperColor(16 / 255, 32 / 255, 255 / 255)
    style.SetDotsPerInch(300)
    style.OutlineOn()
    style.SetOutlineColor(0.123456789012345678, 0, 1)
    style.SetOutlineWidth(0.2)
    style.SetOutlineWidthUnit(layer.MILLIMETRES)
    style.OutlineSilhouetteOff()
    style.OutlineCreasesOff()
    style.OutlineBordersOff()
    style.SetOutlineCreaseAngle(33)
    style.SetTrackingMode(style.ANCHORED)
    style.SetWeightScheme(style.CLASSIC)
    style.SetFeatureSource(style.TONE)
    style.SetFeatureArrayName("strength")
    style.LockRotationOn()
    style.LockScaleOn()
    style.SetSamplesPerPatch(321)
    style.SetPixelScale(2)

    style.FinalQualityOn()

    copy = new_style()
    assert copy.FromJson(style.ToJson()), errors
    second = copy.GetLayer(0)
    for one, other in ((style, copy), (layer, second), (tone, second.GetTone())):
        default = values(type(one)() if one is not layer else hachure.vtkImagePatternLayer())
        mine = values(one)
        assert mine == values(other), (mine, values(other))
        same = [n for n in mine if mine[n] == default[n] and n not in ("Image", "ImageFileName")]
        assert not same, "the test left the defaults of " + str(same)
    assert copy.GetPixelScale() == 1, "the output's scale is not part of a style"
    assert not copy.GetFinalQuality(), "nor is its quality"
    assert copy.ToJson() == style.ToJson()
    text = json.loads(style.ToJson())
    assert text["paper"]["color"] == "#1020ff"
    assert text["layers"][0]["field"]["size"] == {"mm": 0.6, "dpi": 300}
    assert text["layers"][1]["field"]["size"] == {"px": 8}
    assert '"opacity" : 0.35' in shortened(style), style.ToJson()


def test_names_of_motions():
    names = ("similarity", "fixedInImage", "texture", "dynamicSolid")
    for value, name in enumerate(names):
        style = new_style()
        assert style.FromJson(document('"field": {"motion": "%s"}' % name)), errors
        assert style.GetLayer(0).GetMotion() == value, name
        assert json.loads(style.ToJson())["layers"][0]["field"]["motion"] == name
    expect_error(
        new_style().FromJson(document('"field": {"motion": "solid"}')),
        'layers[0].field.motion: unknown "solid"', "dynamicSolid")
    expect_error(
        new_style().FromJson(document('"field": {"surfacePeriod": -1}')),
        "layers[0].field.surfacePeriod: -1 is out of range")


def shortened(style):
    """Numbers stay as people write them when no other number needs more digits."""
    style.GetLayer(0).SetColor(0, 0, 0)
    style.GetLayer(0).GetTone().SetConstant(0.3)
    style.GetLayer(0).GetTone().SetRange(0, 1)
    style.SetOutlineColor(0, 0, 0)
    return style.ToJson()


def test_absent_keys_are_defaults():
    style = new_style()
    assert style.LoadPreset("cross-hatch")
    style.SetOutlineWidth(9)
    assert style.FromJson('{"hachure": 1}'), errors
    assert style.ToJson() == new_style().ToJson()


def test_wrong_styles():
    field, tone, ink = '"field": {%s}', '"tone": {%s}', '"ink": {%s}'
    cases = [
        ("", "style: not valid JSON"),
        ('{"hachure": 1,}', "not valid JSON", "Line 1, Column 15"),
        ('{"hachure": 1} x', "not valid JSON"),
        ('{"hachure": 1, "hachure": 1}', "Duplicate key: 'hachure'"),
        ("[" * 5000, "not valid JSON"),
        ("[]", "style: expected an object, got a list"),
        ("{}", "hachure: missing"),
        ('{"hachure": 2}', "hachure: version 2 is unknown; expected 1"),
        ('{"hachure": "1"}', "hachure: expected a number, got a text"),
        ('{"hachure": 1, "layer": []}', "layer: unknown key; expected one of"),
        ('{"hachure": 1, "layers": {}}', "layers: expected a list"),
        ('{"hachure": 1, "layers": [7]}', "layers[0]: expected an object, got a number"),
        ('{"hachure": 1, "layers": [{}]}', "layers[0].type: missing"),
        ('{"hachure": 1, "layers": [{"type": "x"}]}', 'layers[0].type: unknown "x"', '"image"'),
        (document('"seed": -1'), "layers[0].seed: -1 is out of range; expected 0 to 4294967295"),
        (document('"seed": 1.5'), "layers[0].seed: expected a whole number, got 1.5"),
        (document('"enabled": 1'), "layers[0].enabled: expected true or false, got a number"),
        (document(ink % '"colour": "#000000"'), "layers[0].ink.colour: unknown key", "color"),
        (document(ink % '"color": "red"'), 'layers[0].ink.color: expected a colour', '"red"'),
        (document(ink % '"color": "#12345g"'), "layers[0].ink.color: expected a colour"),
        (document(ink % '"color": [0, 1]'), "layers[0].ink.color: expected a list of 3 numbers"),
        (document(ink % '"color": [0, 1, 2]'), "layers[0].ink.color[2]: 2 is out of range"),
        (document(ink % '"opacity": 1.5'), "ink.opacity: 1.5 is out of range; expected 0 to 1"),
        (document(ink % '"opacity": null'), "ink.opacity: expected a number, got null"),
        (document(ink % '"blendMode": "add"'), 'ink.blendMode: unknown "add"', '"overlay"'),
        (document('"ink": []'), "layers[0].ink: expected an object, got a list"),
        (document(tone % '"source": 1'), "layers[0].tone.source: expected a text, got a number"),
        (document(tone % '"range": [0, "a"]'), "tone.range[1]: expected a number, got a text"),
        (document(tone % '"gamma": 0'), "tone.gamma: 0 is out of range; expected 0.01 to 100"),
        (document(field % '"pattern": "dots"'), 'field.pattern: unknown "dots"', '"crossHatch"'),
        (document(field % '"size": 8'), "layers[0].field.size: expected a length"),
        (document(field % '"size": {"px": 8, "mm": 1}'), "field.size: expected a length"),
        (document(field % '"size": {"px": 0}'), "field.size.px: 0 is out of range"),
        (document(field % '"size": {"px": 8, "dpi": 96}'), "field.size.dpi: unknown key"),
        (document(field % '"angle": 1e999'), "style: not valid JSON"),
        (
            document(field % '"size": {"mm": 1, "dpi": 300}', '"paper": {"dotsPerInch": 96}'),
            "layers[0].field.size.dpi: 300 differs from 96 in paper.dotsPerInch",
        ),
        (document(field % '"image": "no.png"'), "layers[0].field.image", '"no.png": no such file'),
        (document(top='"outline": {"creases": "yes"}'), "outline.creases: expected true or false"),
        (document(top='"tracking": {"samplesPerPatch": 1}'), "tracking.samplesPerPatch: 1 is out"),
    ]
    for text, *parts in cases:
        style = new_style()
        style.LoadPreset("halftone")
        before, time = style.ToJson(), style.GetMTime()
        expect_error(style.FromJson(text), *parts)
        assert style.ToJson() == before and style.GetMTime() == time, text


def test_files(folder):
    picture = os.path.join(folder, "pictures", "paper.png")
    styles = os.path.join(folder, "styles")
    for name in (styles, os.path.dirname(picture)):
        os.mkdir(name)
    write_picture(picture, vtkPNGWriter())
    name = os.path.join(styles, "a.json")
    image = '"field": {"pattern": "image", "image": "../pictures/paper.png"}'
    with open(name, "w") as file:
        file.write(document(image))
    style, copy = new_style(), new_style()
    assert style.LoadFile(name), errors
    layer = style.GetLayer(0)
    assert layer.GetImage().GetDimensions() == (16, 16, 1)
    assert os.path.samefile(layer.GetImageFileName(), picture)
    second = os.path.join(folder, "b.json")
    assert style.SaveFile(second), errors
    with open(second) as file:
        assert json.load(file)["layers"][0]["field"]["image"] == "pictures/paper.png"
    assert copy.LoadFile(second) and copy.ToJson() == style.ToJson()

    nowhere = os.path.join(folder, "nowhere", "c.json")
    expect_error(style.LoadFile(nowhere), "cannot read the style file", nowhere)
    expect_error(style.LoadFile(folder), "cannot read the style file")
    expect_error(style.SaveFile(nowhere), "cannot write the style file", nowhere)
    with open(name, "w") as file:
        file.write(document(image.replace("paper.png", "../styles/a.json")))
    expect_error(style.LoadFile(name), "a.json: layers[0].field.image", "not a picture format")
    for writer, ending in ((vtkPNGWriter(), "png"), (vtkBMPWriter(), "bmp")):
        damaged = os.path.join(styles, "damaged." + ending)
        write_picture(damaged, writer)
        os.truncate(damaged, 60)
        with open(name, "w") as file:
            file.write(document('"field": {"image": "damaged.%s"}' % ending))
        expect_error(style.LoadFile(name), "layers[0].field.image", "the file is damaged")
    layer.SetImage(new_picture())
    expect_error(style.ToJson(), "layers[0].field.image: the image has no file")
    layer.AddObserver("ErrorEvent", remember)
    expect_error(layer.ReadImage("no.png"), "ReadImage", '"no.png": no such file')
    assert layer.GetImageFileName() == "" and layer.GetImage()


def test_presets():
    count = hachure.vtkPatternStyle.GetNumberOfPresets()
    names = [hachure.vtkPatternStyle.GetPresetName(i) for i in range(count)]
    assert names == [
        "hatch", "cross-hatch", "halftone", "cmyk", "painterly", "paper", "stipple", "stipple-white",
        "stipple-two-inks", "gabor", "phasor", "spot", "noise-stipple", "noise-hatch", "noise-cross-hatch", "graphite", "ink", "watercolour",
        "felt-tip", "brush", "engraving", "view"], names
    assert hachure.vtkPatternStyle.GetPresetName(count) is None
    assert hachure.vtkPatternStyle.GetDefaultPresetName() in names
    layer = hachure.vtkImagePatternLayer
    patterns = [layer.HATCH, layer.CROSS_HATCH, layer.HALFTONE, layer.HALFTONE, layer.PAINT,
                layer.HATCH]
    texts = set()
    for i, name in enumerate(names):
        style = new_style()
        assert style.LoadPreset(name), errors
        layer = style.GetLayer(0)
        if i < len(patterns):
            assert layer.GetPattern() == patterns[i], name
        else:
            assert layer.GetTypeName() == (
                {"s": "stipple", "v": "view"}.get(name[0]) if name.startswith(("stipple", "view"))
                else "noise"), name
        without = name in ("painterly", "brush", "view") or name.startswith("stipple")
        assert style.GetOutline() != without, name
        texts.add(style.ToJson())
    assert len(texts) == len(names)
    expect_error(style.LoadPreset("dots"), 'unknown style "dots"', "hatch, cross-hatch, halftone, cmyk")


test_every_parameter_survives()
test_every_parameter_of_noise_survives()
test_every_parameter_of_stipples_survives()
test_wrong_factors_of_noise()
test_names_of_motions()
test_absent_keys_are_defaults()
test_wrong_styles()
with tempfile.TemporaryDirectory() as temporary:
    test_files(temporary)
test_presets()
assert not errors, errors
