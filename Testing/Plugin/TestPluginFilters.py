# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters of the plugin run in ParaView, with their properties passed on."""

import pattern_scene as scene
from paraview import servermanager, simple

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
