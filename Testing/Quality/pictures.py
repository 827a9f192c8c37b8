# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures inside the report's page: strips of frames, which it plays, and curves."""

import base64
import html

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

SIDE = 160  # of the pictures at half the size, in pixels
SHOWN = 6  # frames in a strip
LEVELS = 15  # grey levels but one; few keep the page small


def png(values):
    """values[row, column] from 0 (white) to 1 (black), row 0 at the bottom, as the address of an image."""
    levels = numpy.rint(numpy.clip(values, 0, 1) * LEVELS) / LEVELS
    grey = numpy.rint(255 * (1 - levels) ** (1 / 2.2)).astype(numpy.uint8)
    image = vtkImageData()
    image.SetDimensions(grey.shape[1], grey.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(grey.ravel(), deep=1))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.WriteToMemoryOn()
    writer.Write()
    data = vtk_to_numpy(writer.GetResult()).tobytes()
    return "data:image/png;base64," + base64.b64encode(data).decode()


def chosen(count, spread):
    """Numbers of the frames in a strip: those in the middle, or from all over the clip."""
    if spread:
        return numpy.linspace(0, count - 1, SHOWN).round().astype(int)
    return numpy.clip(numpy.arange(SHOWN) + max(count - SHOWN, 0) // 2, 0, count - 1)


def strip(pictures, title, spread=False):
    """Some of the pictures at half the size, played forth and back."""
    row = numpy.hstack([pictures[i] for i in chosen(len(pictures), spread)])
    address = png(row.reshape(SIDE, 2, SIDE * SHOWN, 2).mean(axis=(1, 3)))
    return ('<div class="strip six" role="img" aria-label="%s" style="background-image:url(%s)"></div>'
            % (html.escape(title), address))


def plot(values, title, top, width=220, height=76):
    """A curve over the steps of a clip, from 0 to top."""
    values = numpy.nan_to_num(numpy.asarray(values, dtype=float))
    top = max(top, 1e-9)
    left, right, floor, ceiling = 4, width - 4, height - 14, 18
    across = numpy.linspace(left, right, max(len(values), 2))
    points = " ".join("%.1f,%.1f" % (x, floor - (floor - ceiling) * y / top)
                      for x, y in zip(across, values))
    return ('<svg width="%d" height="%d" role="img"><line x1="%d" x2="%d" y1="%d" y2="%d" class="rim"/>'
            '<line x1="%d" x2="%d" y1="%d" y2="%d"/><polyline points="%s"/>'
            '<text x="%d" y="12">%s, 0 to %.3g</text><text x="%d" y="%d">first step</text>'
            '<text x="%d" y="%d" text-anchor="end">last</text></svg>'
            % (width, height, left, right, ceiling, ceiling, left, right, floor, floor, points, left,
               html.escape(title), top, left, height - 2, right, height - 2))
