# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Small scenes for the tests of the mapper, the pictures of them as numbers, and VTK's messages."""

import math
import traceback

import hachure
import numpy
import vtkmodules.vtkInteractionStyle  # noqa: F401
from vtkmodules.numpy_interface.dataset_adapter import numpyTovtkDataArray
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkUnsignedCharArray
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow

messages = []


@calldata_type(VTK_STRING)
def _remember(_caller, _event, text):
    messages.append(text)


# What VTK reports is kept for the tests instead of printed.
vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
_output = vtkOutputWindow.GetInstance()
_output.SetDisplayModeToNever()
_output.AddObserver("ErrorEvent", _remember)
_output.AddObserver("WarningEvent", _remember)


def expect_messages(*expected):
    """Exactly these messages were reported since the last call: each holds its text, in order."""
    found = list(messages)
    messages.clear()
    assert len(found) == len(expected), "%d messages, expected %d: %s" % (
        len(found), len(expected), found)
    for message, part in zip(found, expected):
        assert part in message, "%r is not in %r" % (part, message)


def run(namespace):
    """Runs every function test_* of a module; an error message that nobody expected fails."""
    failed = []
    for name, function in list(namespace.items()):
        if not name.startswith("test_"):
            continue
        try:
            function()
            expect_messages()
        except AssertionError:
            traceback.print_exc()
            failed.append(name)
            messages.clear()
    if failed:
        raise SystemExit("failed: " + ", ".join(failed))


def window_of(*renderers, size=(256, 256), offscreen=True):
    window = vtkRenderWindow()
    window.SetOffScreenRendering(offscreen)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    for renderer in renderers:
        window.AddRenderer(renderer)
    return window


def renderer_of(*actors, background=(1.0, 1.0, 1.0)):
    renderer = vtkRenderer()
    renderer.SetBackground(*background)
    for actor in actors:
        renderer.AddActor(actor)
    return renderer


def actor_of(data, style, ambient=None):
    """An actor that draws polydata or a composite of it; style: one, or the name of a preset."""
    mapper = hachure.vtkPatternMapper()
    if hasattr(data, "GetOutputPort"):
        mapper.SetInputConnection(data.GetOutputPort())
    else:
        mapper.SetInputDataObject(data)
    mapper.SetStyle(hachure.style(style) if isinstance(style, str) else style)
    actor = vtkActor()
    actor.SetMapper(mapper)
    if ambient is not None:
        actor.GetProperty().SetAmbient(ambient)
    return actor


def constant_style(pattern, size, tone, irregularity=0.0, angle=45.0):
    """One layer of even tone in black on white, without outline."""
    style = hachure.vtkPatternStyle()
    layer = hachure.vtkImagePatternLayer()
    layer.SetPattern(pattern)
    layer.SetSize(size)
    layer.SetAngle(angle)
    layer.SetIrregularity(irregularity)
    layer.GetTone().SetSource(hachure.vtkPatternTone.CONSTANT)
    layer.GetTone().SetConstant(tone)
    style.AddLayer(layer)
    return style


def sphere(resolution=48, radius=0.5, center=(0.0, 0.0, 0.0)):
    source = vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.SetRadius(radius)
    source.SetCenter(*center)
    source.Update()
    return source


def plane(width=10.0):
    """A square in the plane z = 0 around the origin, facing +z."""
    source = vtkPlaneSource()
    source.SetOrigin(-width / 2, -width / 2, 0)
    source.SetPoint1(width / 2, -width / 2, 0)
    source.SetPoint2(-width / 2, width / 2, 0)
    source.Update()
    return source


def add_array(attributes, name, values):
    array = numpyTovtkDataArray(numpy.asarray(values), name)
    attributes.AddArray(array)
    return array


def look(renderer, position=(0.0, 0.0, 3.0), focal_point=(0.0, 0.0, 0.0), up=(0.0, 1.0, 0.0)):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*position)
    camera.SetFocalPoint(*focal_point)
    camera.SetViewUp(*up)
    renderer.ResetCameraClippingRange()
    return camera


def picture(window):
    """The finished picture as bytes: rows from the bottom up, columns, RGB."""
    width, height = window.GetSize()
    data = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, width - 1, height - 1, 0, data, 0)
    return vtk_to_numpy(data).reshape(height, width, 3).copy()


def draw(window):
    window.Render()
    return picture(window)


def linear(pixels):
    """Display-referred bytes in linear light, 0 to 1 (gamma 2.2)."""
    return (numpy.asarray(pixels, dtype=float) / 255.0) ** 2.2


def ink(pixels, mask=None):
    """Mean coverage of black ink on white paper."""
    coverage = 1.0 - linear(pixels).mean(axis=2)
    return float(coverage.mean() if mask is None else coverage[mask].mean())


def drawn_frame(mapper, renderer):
    frame = [0.0] * 6
    assert mapper.GetDrawnFrame(renderer, frame), "no frame was drawn"
    return numpy.array(frame)


def committed_frame(mapper, renderer):
    frame = [0.0] * 6
    assert mapper.GetCommittedFrame(renderer, frame), "no frame was committed"
    return numpy.array(frame)


def frame_scale(frame):
    return math.hypot(frame[2], frame[3])
