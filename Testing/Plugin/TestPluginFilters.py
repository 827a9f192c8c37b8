# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters of the plugin run in ParaView, with their properties passed on; menus can show them."""

import glob
import os
import xml.etree.ElementTree as xml

import numpy
import pattern_scene as scene
import view_pictures as views
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

PLUGIN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Plugin")
FROM_INPUT = {"Distance", "ArrayName"}  # their defaults come from the input


def proxies():
    """The elements of all sources and filters of the plugin."""
    for name in sorted(glob.glob(os.path.join(PLUGIN, "*.xml"))):
        yield from xml.parse(name).iter("SourceProxy")


def check_menu(element, icons):
    """Help that fits a tooltip, and an icon that ParaView has."""
    name, text = element.get("name"), element.find("Documentation")
    assert element.get("label").replace(" ", "") == name, name  # Python calls it by its label
    assert 20 < len(text.get("short_help")) < 80 and 20 < len(text.get("long_help")) < 100, name
    entry = element.find("Hints/ShowInMenu")
    assert entry.get("category") == "Hachure" and entry.get("icon").startswith(":/pqWidgets/Icons/"), name
    if icons:
        assert os.path.basename(entry.get("icon")).encode("utf-16-be") in icons, entry.get("icon")


def check_defaults(element, inputs):
    """A new filter has the values in the XML, which TestPluginDefaults compares with those of the class."""
    proxy = getattr(scene, element.get("name"))(**inputs)
    for item in element:
        name, written = item.get("name"), item.get("default_values")
        if written is None or name in FROM_INPUT:
            continue
        values = proxy.SMProxy.GetProperty(name)
        count = values.GetNumberOfElements()
        actual = [str(values.GetElement(i)) for i in range(count)]
        if item.tag != "StringVectorProperty":
            actual, written = [float(value) for value in actual], [float(value) for value in written.split()]
        else:
            written = [written]
        assert actual == written, (element.get("name"), name, actual, written)


sphere = simple.Sphere(ThetaResolution=40, PhiResolution=30)
samples = scene.HachureSurfaceSamples(Input=sphere)
for wanted in (500, 2000):
    samples.SamplesPerPatch = wanted
    data = servermanager.Fetch(samples)
    assert abs(data.GetNumberOfPoints() - wanted) < 0.15 * wanted, data.GetNumberOfPoints()
for name in ("Normals", "Barycentrics", "PatchId", "SampleId"):
    assert data.GetPointData().HasArray(name), name

stipples = scene.HachureStipples(Input=sphere, NumberOfPoints=3000, Order="Classic", GenerateParticleMesh=True)
data = servermanager.Fetch(stipples)
assert data.GetNumberOfPoints() == 3000 and data.GetPointData().HasArray("StippleSpacing")
particles = servermanager.Fetch(simple.ExtractSurface(Input=stipples[1]))
assert particles.GetNumberOfPolys() > 5000, particles.GetNumberOfPolys()

image = scene.HachurePatternImage(Pattern="Halftone", Size=128, Periods=16)
data = servermanager.Fetch(image)
assert data.GetDimensions() == (128, 128, 1), data.GetDimensions()
assert data.GetFieldData().GetArray("Periods").GetValue(0) == 16
low, high = data.GetPointData().GetArray("Screen").GetRange()
assert 0 <= low < 0.1 and 0.9 < high <= 1, (low, high)

patches = scene.HachureSurfacePatches(Input=sphere, NumberOfPatches=7)
assert servermanager.Fetch(patches).GetCellData().GetArray("PatchId").GetRange() == (0, 6)
weights = scene.HachurePatchBlendWeights(Input=patches, Rings=2)
data = servermanager.Fetch(weights).GetPointData()
assert data.GetArray("BlendPatches").GetRange(0) == (0, 6)
assert 0.2 < data.GetArray("BlendWeights").GetRange(0)[0] < 0.6

height = simple.Calculator(Input=sphere, Function="coordsZ", ResultArrayName="Height")
field = scene.HachureDirectionField(Input=height, Method="Gradient", ArrayName="Height")
for perpendicular, low, high in ((0, 0.6, 0.8), (1, 0.0, 0.02)):  # from 0 at the poles to 1 between
    field.Perpendicular = perpendicular
    direction = servermanager.Fetch(field).GetPointData().GetArray("Direction")
    slopes = sorted(abs(direction.GetComponent(i, 2)) for i in range(direction.GetNumberOfTuples()))
    assert low <= slopes[len(slopes) // 2] <= high, slopes[len(slopes) // 2]
field = scene.HachureDirectionField(Input=sphere)
assert servermanager.Fetch(field).GetPointData().GetArray("PrincipalCurvatures").GetNumberOfComponents() == 2

picked = simple.IDSelectionSource(IDs=[value for cell in range(5) for value in (-1, cell)], FieldType="CELL")
patches = scene.HachureSurfacePatches(Input=sphere, Selection=picked, Method="Selection")
values = servermanager.Fetch(patches).GetCellData().GetArray("PatchId")
assert [values.GetValue(i) for i in range(7)] == [1] * 5 + [0] * 2

# Queries have to be frozen first.
query = simple.SelectionQuerySource(QueryString="id < 5")
with scene.Messages() as messages:
    scene.HachureSurfacePatches(Input=sphere, Selection=query, Method="Selection").UpdatePipeline()
assert messages.text.count("Selection node 0 has the content type QUERY") == 1, messages.text

# The patches of a new filter are chosen from the arrays that there are.
samples = scene.HachureSurfaceSamples(Input=patches)
choices = samples.GetProperty("PatchArrayName")
assert choices.GetData() == "" and list(choices.Available) == ["", "PatchId"], choices.Available
samples.PatchArrayName = "PatchId"
assert servermanager.Fetch(samples).GetNumberOfPoints() == 1000
choices = scene.HachureDirectionField(Input=height).GetProperty("ArrayName")
assert set(choices.Available) == {"Normals", "Height"}, choices.Available

table = scene.HachureToneCorrectionTable(Input=image)
data = servermanager.Fetch(table)
assert data.GetDimensions() == (256, 96, 1) and data.GetPointData().HasArray("Threshold"), data.GetDimensions()
table.Transition = "None"
assert servermanager.Fetch(table).GetDimensions() == (256, 48, 1)

# Views of a manifest as data; pictures that were painted since are read again.
manifest = views.manifest("filters", views.painted("all", views.RED), views.painted("front", views.BLUE, extremes=60))
cells = scene.HachureViewTextureCells(Input=views.plane, Manifest=manifest, Level=2)


def colors():
    """The colours that are seen from everywhere, of cells that have one."""
    array = vtk_to_numpy(servermanager.Fetch(cells).GetCellData().GetArray("Independent"))
    return array[array[:, 3] == 255][:, :3]


assert len(colors()) > 100 and numpy.abs(colors() - views.RED).max() < 2, colors()
assert servermanager.Fetch(cells, idx=1).GetNumberOfLines() > 10
views.paint("all.png", views.WHITE)
cells.InvokeCommand("ReadAgain")
cells.UpdatePipeline()
assert numpy.abs(colors() - views.WHITE).max() < 2, colors()
cells.Manifest = "none.json"
with scene.Messages() as messages:
    cells.UpdatePipeline()
assert messages.text.count("cannot read the manifest") == 1, messages.text

resources = glob.glob("/usr/lib/*/libpqComponents-pv*.so*")
if not resources:
    print("ParaView's window is not installed: icons are not looked up")
found = b"".join(open(name, "rb").read() for name in resources[:1])
inputs = {"HachurePatternImage": {}, "HachureToneCorrectionTable": {"Input": image}}
names = []
for element in proxies():
    names.append(element.get("name"))
    check_menu(element, found)
    check_defaults(element, inputs.get(names[-1], {"Input": patches}))
assert len(names) >= 8, names
