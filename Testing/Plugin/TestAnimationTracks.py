# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every property can be an animation track, and what is drawn at a time is what its value there draws."""

import animation_scene as time
import pattern_scene as scene
import view_pictures
from paraview import simple
from property_definitions import written

# Names of files and texts have no list of values.
TEXTS = "StyleFile", "StyleSaveName", "ImageFile", "SpotImage", "Manifest", "SaveName", "LegendTitle", "LegendLabelFormat"

ball = simple.Sphere(ThetaResolution=24, PhiResolution=16)
arrays = simple.Calculator(Input=ball, ResultArrayName="height", Function="coordsY")
arrays = simple.Calculator(Input=arrays, ResultArrayName="across", Function="coordsX")
arrays = simple.Calculator(Input=arrays, ResultArrayName="flow", Function="coordsY*iHat")


def values(item, prop):
    """Two values for the keys of a track."""
    domains = {name: prop.FindDomain("vtkSM%sDomain" % name) for name in ("Enumeration", "StringList", "Boolean")}
    if domains["Enumeration"]:
        last = domains["Enumeration"].GetNumberOfEntries() - 1
        return domains["Enumeration"].GetEntryValue(0), domains["Enumeration"].GetEntryValue(last)
    if domains["StringList"]:
        return 0, domains["StringList"].GetNumberOfStrings() - 1
    if domains["Boolean"]:
        return 1, 0
    usual = float((item["default_values"] or "0").split()[-1])
    return usual + 1, usual + 2


def check_all(prefix):
    """Every property that the XML names changes with the time, by values of its own."""
    animation = time.clock()
    where = scene.view((20, 20))
    display = time.show(arrays, where, prefix)
    display.Visibility = 0
    items = [(item, display.SMProxy.GetProperty(item["name"])) for item in written(prefix)]
    refused = [item["name"] for item, prop in items if not prop.GetAnimateable()]
    assert set(refused) <= {prefix + name for name in TEXTS}, refused
    left_out = refused + ["ViewTextureStyle"]  # a list of one style
    items = [(item, prop) for item, prop in items if item["name"] not in left_out]
    for item, prop in items:
        first, last = values(item, prop)
        assert first != last, item["name"]
        time.track(display, item["name"], first, last, prop.GetNumberOfElements() - 1)
    seen = {}
    for moment in 1.0, 0.0:  # the scene is at 0 already
        animation.AnimationTime = moment
        seen[moment] = {item["name"]: prop.GetElement(prop.GetNumberOfElements() - 1) for item, prop in items}
    same = [name for name, value in seen[0.0].items() if seen[1.0][name] == value]
    assert not same, "cannot be animated: %s" % same
    for item, prop in items:
        if item["tag"] != "StringVectorProperty":
            wanted = tuple(float(value) for value in values(item, prop))
            assert (seen[0.0][item["name"]], seen[1.0][item["name"]]) == wanted, (item["name"], wanted, seen)
    buttons = [name for name in ("Reanchor", "AddCamera", "Save", "ReadAgain")
               if display.SMProxy.GetProperty(prefix + name)]
    assert "Reanchor" in buttons
    time.clock()
    simple.Delete(where)
    print(prefix, len(items), "properties are animated,", refused, "are not")


for representation in "Pattern", "Noise", "Stipple", "ViewTexture":
    check_all(representation)

# What is drawn at a time is what a new view draws with the values that the properties have then.
front = view_pictures.painted("front", view_pictures.waves(), extremes=60, size=256)
views = view_pictures.manifest("views", front, view_pictures.painted("all", view_pictures.RED), finestLevel=3)
few = {"StippleNumberOfPoints": 3000}


def plain(value):
    """A value of a property, not the property itself."""
    return value if isinstance(value, (str, float, int)) else list(value)


def draw(prefix, tracks, moments, **properties):
    """Pictures at moments of tracks (name, index, first, last), and the values of the properties then."""
    animation = time.clock()
    where = scene.view((100, 80))
    display = scene.show(arrays, where, Representation=time.LABELS.get(prefix, prefix), **properties)
    scene.look(where, (0, 0, 2.4))
    for name, index, first, last in tracks:
        time.track(display, name, first, last, index)
    shown = {}
    for moment in moments:
        animation.AnimationTime = moment
        taken = {name: plain(getattr(display, name)) for name, _, _, _ in tracks}
        shown[moment] = scene.picture(where, "track-%s-%g" % (prefix, moment)), taken
    time.clock()
    simple.Delete(where)
    return shown


for prefix, properties, *tracks in (
    ("Pattern", {"PatternStyle": "hatch", "PatternInk": "Color"}, ("PatternScale", 0, 1, 3),
     ("PatternInkColor", 0, 0, 1), ("PatternInkColor", 2, 1, 0.5)),
    ("Pattern", {"PatternTone": "Constant"}, ("PatternToneConstant", 0, 0.1, 0.9),
     ("PatternKind", 0, 0, 2.5), ("PatternStyle", 0, 0, 2), ("PatternMotion", 0, 0, 3)),
    ("Noise", {}, ("NoiseScale", 0, 1, 2), ("NoiseRegularity", 0, 1, 0.5), ("NoiseKind", 0, 0, 2)),
    ("Stipple", few, ("StippleNumberOfPoints", 0, 2000, 4000), ("StippleSize", 0, 2, 5)),
    ("ViewTexture", {"ViewTextureManifest": views}, ("ViewTextureLevel", 0, 0, 2),
     ("ViewTextureInkOpacity", 0, 1, 0.2)),
):
    shown = draw(prefix, tracks, (0.25, 0.75), **properties)
    picture, taken = shown[0.75]
    fresh = draw(prefix, (), (0.0,), **dict(properties, **taken))[0.0][0]
    assert (fresh == picture).all(), (prefix, taken, scene.difference(fresh, picture))
    assert scene.difference(shown[0.25][0], picture) > 1, (prefix, tracks)
    assert all(value != shown[0.25][1][name] for name, value in taken.items()), shown
