# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures clips: frames of ink, and the exact motion between them."""

import hachure
import numpy
import scenes
from studio import array_of, image_of
from vtkmodules.util.numpy_support import vtk_to_numpy

ALWAYS = ("Contrast", "CooccurrenceError", "FacingSlope", "ToneError", "ToneFlicker")
SLOW = ("SlideRatio", "NormalSlideRatio", "Coherence", "MeanSlide", "SimilaritySlide", "MeanMotion",
        "LargestMotion", "BoilMedian", "BoilLargest", "Pop") + ALWAYS
FAST = ("DistanceSlope",) + ALWAYS
EVERY_WAY = ("SlideRatio", "MeanSlide", "SimilaritySlide")  # slides in every direction, not for strokes
MINIMUM_FACING = 0.3  # n.v, as vtkPatternMetrics has it
# Pixels of a cell, below which there is too little pattern in it to speak of its tone.
MINIMUM_CELL_PIXELS = int((2 * scenes.WAVELENGTH) ** 2)


def similarity_slide(motions):
    """The mean slide, in pixels per step, that no motion by one similarity for each surface avoids.

    As the image patterns are carried (Breslav et al. 2007, section 3.2), but from all points that are
    seen in both frames. Counted where n.v > 0.3.
    """
    slides = []
    for values in map(array_of, motions):
        row, column = numpy.nonzero(values[..., 2] > 0)
        before = column + 1j * row
        seen = values[row, column].astype(float)
        after = before + seen[:, 0] + 1j * seen[:, 1]
        for label in numpy.unique(seen[:, 5]):
            here = seen[:, 5] == label
            p = before[here] - before[here].mean()
            c = after[here] - after[here].mean()
            turn = numpy.vdot(p, c)
            size = numpy.sqrt((numpy.abs(c) ** 2).sum() / max((numpy.abs(p) ** 2).sum(), 1e-30))
            z = size * turn / max(abs(turn), 1e-30)
            slides.append(numpy.abs(z * p - c)[seen[here, 3] > MINIMUM_FACING])
    slides = numpy.concatenate(slides)
    return float(slides.mean()) if len(slides) else float("nan")


def new_metrics(frames, motions, cells, reference, tone=None):
    """The filter with a clip.

    cells: of every frame; reference: the ink drawn flat; tone: the even tone that was asked for.
    """
    metrics = hachure.vtkPatternMetrics()
    metrics.SetWavelength(scenes.WAVELENGTH)
    metrics.SetMinimumFacing(MINIMUM_FACING)
    metrics.SetMinimumCellPixels(MINIMUM_CELL_PIXELS)
    metrics.SetReference(image_of(reference))
    for frame, motion, cell in zip(frames, motions, cells):
        metrics.AddFrame(image_of(frame))
        metrics.AddMotion(motion)
        metrics.AddCells(image_of(cell))
        if tone is not None:
            seen = array_of(motion)[..., 5] > 0
            metrics.AddTone(image_of(numpy.where(seen, tone, -1.0)))
    return metrics


def table_of(metrics):
    table = metrics.GetOutput()
    found = {table.GetValueByName(row, "Metric").ToString():
             table.GetValueByName(row, "Value").ToDouble() for row in range(table.GetNumberOfRows())}
    if "NormalSlideRatio" not in found:
        raise RuntimeError("the motion of this clip cannot be measured; see VTK's message")
    return found


def measure(metrics, motions, strokes=False, fast=False):
    """The values of a clip by name, NaN where not defined, and some for every step.

    strokes: whether slides show across the marks alone; fast: whether the motion is too fast for them.
    """
    if fast:
        metrics.AddObserver("WarningEvent", lambda *_: None)  # says that slides cannot be told
    metrics.Update()
    found = table_of(metrics)
    found["SimilaritySlide"] = similarity_slide(motions[:-1])
    steps = metrics.GetOutput(1)
    columns = ("Frequency", "Contrast") if fast else ("NormalSlide" if strokes else "Slide", "Boil")
    names = FAST if fast else SLOW
    return ({name: found[name] for name in names
             if name in found and not (strokes and name in EVERY_WAY)},
            {name: vtk_to_numpy(steps.GetColumnByName(name))[:len(motions) - 1] for name in columns})


def followed(frame, motion):
    """frame, taken at where the surface seen at each pixel has moved to; NaN where it is not seen."""
    values = array_of(motion)
    y, x = numpy.mgrid[0:frame.shape[0], 0:frame.shape[1]]
    x = numpy.clip(x + values[..., 0], 0, frame.shape[1] - 1.001)
    y = numpy.clip(y + values[..., 1], 0, frame.shape[0] - 1.001)
    column, row = x.astype(int), y.astype(int)
    x, y = x - column, y - row
    lower = frame[row, column] * (1 - x) + frame[row, column + 1] * x
    upper = frame[row + 1, column] * (1 - x) + frame[row + 1, column + 1] * x
    return numpy.where(values[..., 2] > 0, lower * (1 - y) + upper * y, numpy.nan)


def differences(frames, motions):
    """|next frame, moved back, - frame| of every step; 0 where a point is not seen in both."""
    return [numpy.nan_to_num(numpy.abs(followed(after, motion) - before))
            for before, after, motion in zip(frames, frames[1:], motions)]
