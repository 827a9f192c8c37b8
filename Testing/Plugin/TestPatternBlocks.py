# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Scalar colours, opacity, hidden blocks and backfaces work as for Surface, and bad input is reported."""

import numpy
import pattern_scene as scene
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

left = simple.Sphere(Center=[-0.7, 0, 0], ThetaResolution=40, PhiResolution=40)
right = simple.Sphere(Center=[0.7, 0, 0], ThetaResolution=40, PhiResolution=40)
both = simple.GroupDatasets(Input=[left, right])


def draw(source=both, name=None, color=None, **properties):
    """A picture of the source in a view of its own."""
    where = scene.view()
    display = scene.show(source, where, **properties)
    if color:
        simple.ColorBy(display, color)
    scene.look(where, (0, 0.5, 5))
    shown = scene.picture(where, name)
    simple.Delete(where)
    return shown


def halves(shown):
    """Shares of drawn pixels in the left and in the right half."""
    drawn = (numpy.abs(shown.astype(int) - 128) > 2).any(axis=2)
    middle = shown.shape[1] // 2
    return drawn[:, :middle].mean(), drawn[:, middle:].mean()


plain = draw()
assert min(halves(plain)) > 0.05, halves(plain)

# Block visibility.
hidden = draw(name="blocks-hidden", BlockSelectors=["/Root/Sphere1"])
assert halves(hidden)[0] < 0.001 or halves(hidden)[1] < 0.001, halves(hidden)
assert max(halves(hidden)) > 0.05, halves(hidden)

# Scalar colours are on the surface, so on paper that shows it.
elevation = simple.Elevation(Input=both, LowPoint=[0, -0.5, 0], HighPoint=[0, 0.5, 0])
colored = draw(
    elevation, "blocks-colored", ("POINTS", "Elevation"), PatternPaper="Surface colors"
)
strength = colored.max(axis=2).astype(int) - colored.min(axis=2)
assert (strength > 60).mean() > 0.05, "no scalar colours"
assert (plain.max(axis=2) == plain.min(axis=2)).all(), "colours where none were asked for"

# Translucent: the ground shows through both sides of a sphere (255 would be 223), the pattern stays.
clear = draw(name="blocks-translucent", Opacity=0.5)
drawn = (numpy.abs(plain.astype(int) - 128) > 2).any(axis=2)
assert clear[drawn].max() < 230 and clear[drawn].min() < 90, (clear[drawn].max(), clear[drawn].min())
assert clear[drawn].std() > 15, "no pattern on translucent surfaces"

# Faces that are drawn otherwise do not disturb.
assert min(halves(draw(BackfaceRepresentation="Wireframe"))) > 0.05


def message(**properties):
    """What is reported while this is drawn."""
    with scene.Messages() as messages:
        draw(**properties)
    return messages.text


assert message() == ""
assert message(PatternStyleFile="/nowhere/style.json").count("/nowhere/style.json") == 1
missing = message(source=elevation, PatternTone="Array", PatternToneArray=["POINTS", "absent"])
assert "absent" in missing, missing


def selected(source, representation):
    """The cells that a selection in the left half of the view finds, by their centres."""
    where = scene.view()
    display = scene.show(source, where)
    display.Representation = representation
    scene.look(where, (0, 0.5, 5))
    before = scene.picture(where)
    simple.SelectSurfaceCells(Rectangle=[0, 0, scene.SIZE[0] // 2, scene.SIZE[1]], View=where)
    centers = simple.CellCenters(Input=simple.MergeBlocks(Input=simple.ExtractSelection(Input=source)))
    found = vtk_to_numpy(servermanager.Fetch(centers).GetPoints().GetData())
    simple.ClearSelection(source)
    assert (before == scene.picture(where)).all(), "selecting in %s changed the picture" % representation
    simple.Delete(where)
    return found


# A selection finds the same cells as in Surface: of blocks, and of a volume, whose cells are not those drawn.
volume = simple.Tetrahedralize(
    Input=simple.Transform(Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]))
)
volume.Input.Transform.Scale = [0.2, 0.2, 0.2]
for source in both, volume:
    wanted = selected(source, "Surface")
    assert len(wanted) > 50, len(wanted)
    assert numpy.array_equal(selected(source, "Pattern"), wanted), len(wanted)
