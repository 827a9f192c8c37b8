# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Patches of one surface have patterns that move by themselves and blend without a change of tone."""

import hachure
import numpy
import patch_scene
import pattern_scene as scene
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkTable

HATCH, CROSS_HATCH, HALFTONE = 0, 1, 2


def flat_view(data, style, size=(256, 256), distance=3.0):
    actor = scene.actor_of(data, style)
    actor.GetProperty().LightingOff()
    renderer = scene.renderer_of(actor, background=(1.0, 0.0, 0.0))
    window = scene.window_of(renderer, size=size)
    scene.look(renderer, (0.0, 0.0, distance))
    return actor, renderer, window


def patch_frames(actor, renderer, count):
    frames = []
    for patch in range(count):
        frame = [0.0] * 6
        assert actor.GetMapper().GetDrawnFrame(renderer, patch, frame), patch
        frames.append(numpy.array(frame))
    return frames


def test_one_patch_changes_nothing():
    plain = patch_scene.grid()
    one = patch_scene.grid()
    patch_scene.split(one, places=())
    pictures = [scene.draw(flat_view(data, scene.constant_style(HATCH, 8, 0.4))[2])
                for data in (plain, one)]
    assert (pictures[0] == pictures[1]).all()


def test_each_patch_moves_by_itself():
    """A plane that turns about the vertical: its halves come nearer and go away."""
    data = patch_scene.grid()
    patch_scene.split(data)
    actor, renderer, window = flat_view(data, scene.constant_style(HATCH, 8, 0.4))
    scene.draw(window)
    start = patch_frames(actor, renderer, 2)
    for angle in range(1, 21):
        actor.SetOrientation(0.0, angle, 0.0)
        scene.draw(window)
    left, right = (scene.frame_scale(now) / scene.frame_scale(then)
                   for now, then in zip(patch_frames(actor, renderer, 2), start))
    assert left / right > 1.1, (left, right)
    table = vtkTable()
    assert actor.GetMapper().GetPatchResiduals(renderer, -1.0, table)
    residuals, weights = (vtk_to_numpy(table.GetColumnByName(name)) for name in ("Residual", "Weight"))
    assert len(residuals) == 2 and residuals.min() > 0.01, residuals
    mean = (residuals * weights).sum() / weights.sum()
    assert abs(actor.GetMapper().GetResidual(renderer) - mean) < 1e-3 * mean, (residuals, weights)
    frame = [0.0] * 6
    assert not actor.GetMapper().GetDrawnFrame(renderer, 2, frame)
    assert not actor.GetMapper().GetDrawnFrame(renderer, -1, frame)


def turned_plane(style, size=(256, 256)):
    """A plane in two halves that has turned: its left half has come nearer and the right one gone."""
    data = patch_scene.grid()
    patch_scene.split(data)
    actor, renderer, window = flat_view(data, style, size)
    scene.draw(window)
    for angle in range(1, 31):
        actor.SetOrientation(0.0, angle, 0.0)
        pixels = scene.draw(window)
    return pixels, actor, renderer


def period_along_y(columns):
    profile = scene.linear(columns).mean(axis=(1, 2))
    profile = (profile - profile.mean()) * numpy.hanning(len(profile))
    power = numpy.abs(numpy.fft.rfft(profile, 16 * len(profile)))
    return 16 * len(profile) / float(power.argmax())


def test_every_pixel_has_the_pattern_of_its_patch():
    style = scene.constant_style(HATCH, 10, 0.4, angle=0.0)
    pixels, actor, renderer = turned_plane(style)
    for frame, columns in zip(patch_frames(actor, renderer, 2), (slice(40, 110), slice(146, 216))):
        scale = scene.frame_scale(frame)
        assert abs(scale - 1.0) > 0.05, scale
        period = period_along_y(pixels[:, columns])
        wanted = 10.0 * scale if scale >= 1.0 else 20.0 * scale  # below 1 it is drawn at double size
        half = 0.5 * wanted
        assert min(abs(period - wanted), abs(period - half)) < 0.2, (period, wanted)


def test_blocks_have_the_patterns_of_their_patches():
    """Blocks in patches, each with vertices of its own, look like one surface of the same patches."""
    def draw_turned(parts):
        blocks = [patch_scene.grid() for _ in range(parts)]
        for number, block in enumerate(blocks):
            patch_scene.split(block)
            if parts > 1:
                patch_scene.keep_patch(block, number)
        data = blocks[0]
        if parts > 1:
            data = vtkMultiBlockDataSet()
            for number, block in enumerate(blocks):
                data.SetBlock(number, block)
        actor, renderer, window = flat_view(data, scene.constant_style(HATCH, 8, 0.4))
        scene.draw(window)
        for angle in range(1, 21):
            actor.SetOrientation(0.0, angle, 0.0)
            pixels = scene.draw(window)
        return pixels.astype(int), patch_frames(actor, renderer, 2)

    one, frames = draw_turned(1)
    two, same_frames = draw_turned(2)
    assert numpy.allclose(frames, same_frames, atol=1e-6), (frames, same_frames)
    difference = numpy.abs(one - two)
    assert (difference > 16).mean() < 0.001, (difference.mean(), difference.max())


def test_borders_do_not_show_before_the_patches_move():
    style = scene.constant_style(CROSS_HATCH, 8, 0.4, 0.35)
    pictures = []
    for places, width in (((0.0,), 0.0), ((0.0,), 0.6), ((-0.3, 0.2), 0.5)):
        data = patch_scene.grid()
        patch_scene.split(data, places, width)
        actor, renderer, window = flat_view(data, style)
        pictures.append(scene.draw(window).astype(int))
        frames = patch_frames(actor, renderer, len(places) + 1)
        assert all((frame == frames[0]).all() for frame in frames), frames
    assert numpy.abs(pictures[0] - pictures[1]).max() <= 1, "the weights do not show"


def worst_tone(pattern, places, width, turned=False):
    """Largest error of the mean ink in windows that slide across the borders."""
    data = patch_scene.grid()
    patch_scene.split(data, places, width)
    style = scene.constant_style(pattern, 8, 0.5)
    layer = style.GetLayer(0)
    actor, renderer, window = flat_view(data, style, (384, 384))
    scene.draw(window)
    if turned:
        # The patches turn and grow against each other, over more than half an octave.
        for _ in range(12):
            patch_scene.twist(data, places[0], 2.5, 1.04)
            scene.draw(window)
        scales = [scene.frame_scale(frame) for frame in patch_frames(actor, renderer, 2)]
        assert scales[1] / scales[0] > 1.3, scales
    worst = (0.0, "")
    for tone in (0.1, 0.25, 0.5, 0.75, 0.9):
        layer.GetTone().SetConstant(tone)
        inks = []
        for angle in (45.0, 20.0, 80.0):
            layer.SetAngle(angle)
            inks.append(1.0 - scene.linear(scene.draw(window)).mean(axis=2))
        columns = numpy.mean(inks, axis=(0, 1))
        means = numpy.convolve(columns, numpy.ones(48) / 48, "valid")
        error = numpy.abs(means - tone).max()
        worst = max(worst, (error, "tone %g: %g" % (tone, means[numpy.abs(means - tone).argmax()])))
    return worst


def test_tone_holds_across_borders():
    for pattern in (HATCH, CROSS_HATCH, HALFTONE):
        for places, width, turned in (((0.0,), 0.0, False), ((0.0,), 0.6, False),
                                      ((-0.2, 0.2), 0.5, False), ((0.0,), 0.8, True)):
            error, case = worst_tone(pattern, places, width, turned)
            print("pattern", pattern, places, width, turned, "error", error, case)
            assert error < 0.02, (pattern, places, width, turned, error, case)


def test_the_first_corner_of_triangles_does_not_matter():
    """Patches are told by the last corner, which several triangles may share."""
    # All turned; by chance; back; and so that few points are the last ones of many triangles.
    orders = (lambda cells: numpy.ones(len(cells), int),
              lambda cells: numpy.random.default_rng(1).integers(0, 3, len(cells)),
              lambda cells: numpy.full(len(cells), 2),
              lambda cells: 2 - numpy.argmin(cells % 7, axis=1))
    for width in (0.0, 0.8):
        data = patch_scene.grid()
        cells = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        patch_scene.split(data, (-0.3, 0.4), width)
        actor, renderer, window = flat_view(data, scene.constant_style(HALFTONE, 8, 0.4))
        for _ in range(6):
            scene.draw(window)
            patch_scene.twist(data, -0.3, 2.5, 1.04)
            patch_scene.twist(data, 0.4, 2.5, 1.02)
        scene.draw(window)
        before, frames = scene.draw(window).astype(int), patch_frames(actor, renderer, 3)
        assert abs(scene.frame_scale(frames[1]) / scene.frame_scale(frames[0]) - 1.0) > 0.1, frames
        for corners in orders:
            cells[:] = [numpy.roll(cell, turn) for cell, turn in zip(cells, corners(cells))]
            data.GetPolys().Modified()
            after = scene.draw(window).astype(int)
            # Patterns stay where they were drawn.
            assert numpy.allclose(patch_frames(actor, renderer, 3), frames), "the patterns moved"
            difference = numpy.abs(after - before)
            assert (difference > 16).mean() < 0.001, (width, difference.mean(), difference.max())


def test_power_of_weights_strengthens_borders():
    data = patch_scene.grid()
    patch_scene.split(data, (0.0,), 0.8)
    style = scene.constant_style(HATCH, 8, 0.3)
    layer = style.GetLayer(0)
    _, _, window = flat_view(data, style, (384, 384))
    scene.draw(window)
    for _ in range(12):
        patch_scene.twist(data, 0.0, 2.5, 1.04)
        scene.draw(window)
    inks = {}
    for power in (1.0, 0.5):
        layer.SetPatchPower(power)
        columns = (1.0 - scene.linear(scene.draw(window)).mean(axis=2)).mean(axis=0)
        inks[power] = columns[176:208].mean(), columns[:64].mean()
    border, inside = zip(*(inks[power] for power in (1.0, 0.5)))
    # At the border itself each of two weights is 1/2: ink by 2 / sqrt(2) more, less its overlap.
    assert 1.2 < border[1] / border[0] < 1.45, inks
    assert abs(inside[1] - inside[0]) < 0.01, inks
    layer.GetTone().SetConstant(1.0)
    assert scene.ink(scene.draw(window)) > 0.999, "full ink stays full ink"


def test_translucent_patches_look_like_opaque_ones():
    data = patch_scene.grid()
    patch_scene.split(data, (0.0,), 0.6)
    style = scene.constant_style(HALFTONE, 8, 0.4)
    actor, _, window = flat_view(data, style)
    opaque = scene.draw(window)
    actor.ForceTranslucentOn()
    translucent = scene.draw(window)
    difference = numpy.abs(opaque.astype(int) - translucent)
    assert difference.mean() < 0.5 and (difference > 16).mean() < 0.005, difference.mean()


def test_many_patches():
    data = patch_scene.grid(64)
    cells = data.GetNumberOfCells()
    patch_scene.number_cells(data, numpy.arange(cells) * 1000 // cells)
    actor, renderer, window = flat_view(data, scene.constant_style(HATCH, 8, 0.4))
    pixels = scene.draw(window)
    assert abs(scene.ink(pixels) - 0.4) < 0.02, scene.ink(pixels)
    assert len(patch_frames(actor, renderer, 1000)) == 1000


def test_wrong_patches():
    def draw_with(name, values, array_name=None):
        data = patch_scene.grid(4)
        if values is not None:
            scene.add_array(data.GetCellData(), name, values)
        actor, _, window = flat_view(data, scene.constant_style(HATCH, 8, 0.4))
        if array_name is not None:
            actor.GetMapper().SetPatchArrayName(array_name)
        pixels = scene.draw(window)
        assert abs(scene.ink(pixels) - 0.4) < 0.02, "the surface is drawn all the same"

    draw_with("PatchId", None)
    draw_with("PatchId", None, "")
    # Negative: belongs to none, drawn with the first.
    draw_with("PatchId", numpy.arange(32) - 2)
    draw_with("PatchId", numpy.where(numpy.arange(32) < 16, -10**18, 1))
    scene.expect_messages()
    draw_with("PatchId", None, "Parts")
    scene.expect_messages("no cell array 'Parts'")
    draw_with("PatchId", numpy.linspace(0.0, 3.0, 32))
    scene.expect_messages("patch array 'PatchId' is a vtkDoubleArray of 1 components")
    draw_with("PatchId", numpy.zeros((32, 2), dtype=numpy.int32))
    scene.expect_messages("of 2 components; expected one whole number")
    draw_with("PatchId", numpy.full(32, 8192))
    scene.expect_messages("has the value 8192 at cell 0; expected less than 8192")


scene.run(globals())
