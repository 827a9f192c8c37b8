# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A sphere with views of it in a window, their widget, and a hand that moves mouse and keys."""

import hachure
import numpy
import vtkmodules.vtkInteractionStyle  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkCamera, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
    vtkRenderWindowInteractor, vtkWindowToImageFilter)

from view_scene import image, new_views, watched

SIZE = (400, 300)
EXTREMES = ((2.0, 0.0, 3.5), (0.0, 2.0, 3.5), (-2.0, 0.0, 3.5), (0.0, -2.0, 3.5))


def matrix_of(rows):
    result = vtkMatrix4x4()
    result.DeepCopy([float(number) for row in rows for number in row])
    return result


# Moves, turns and makes three times as large.
TRANSFORM = numpy.array(
    [[0.0, -3.0, 0.0, 5.0], [3.0, 0.0, 0.0, -2.0], [0.0, 0.0, 3.0, 1.0], [0.0, 0.0, 0.0, 1.0]])


def camera(position, up=(0.0, 1.0, 0.0)):
    result = vtkCamera()
    result.SetPosition(*position)
    result.SetViewUp(*up)
    return result


def two_views():
    """One with a range, one without, and a blend point."""
    views = new_views()
    views.AddView("front", camera((0.0, 0.0, 4.0)), image(30, 20))
    views.AddView("side", camera((2.5, 1.0, 1.5)), image(20, 30, seed=2))
    views.SetViewKind(0, hachure.vtkTextureViews.DEPENDENT)
    for extreme in EXTREMES:
        views.AddExtremePoint(0, extreme)
    views.AddBlendPoint((-1.5, 1.0, 1.0), (1.0, 0.0, 0.0), 40.0)
    return views


class Scene:
    """The surface is moved by `transform`, which is also the widget's."""

    def __init__(self, views, transform=None, parallel=False):
        source = vtkSphereSource()
        source.SetThetaResolution(40)
        source.SetPhiResolution(40)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self.transform = numpy.eye(4) if transform is None else numpy.array(transform)
        self.actor.SetUserMatrix(matrix_of(self.transform))
        self.renderer = vtkRenderer()
        self.renderer.AddActor(self.actor)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(*SIZE)
        self.window.AddRenderer(self.renderer)
        self.interactor = vtkRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.window)
        self.widget = watched(hachure.vtkTextureViewsWidget())
        self.drawn = watched(self.widget.GetRepresentation())
        self.drawn.SetModelToWorld(self.actor.GetUserMatrix())
        self.drawn.PlaceWidget(self.actor.GetBounds())
        self.views = views
        self.widget.SetViews(views)
        self.widget.SetInteractor(self.interactor)
        self.widget.SetDefaultRenderer(self.renderer)
        self.widget.On()
        self.look_from((3.0, 2.5, 9.0), parallel)

    def look_from(self, position, parallel=False):
        """Looks at the middle of the surface from a place in its coordinates, and draws."""
        looking = self.renderer.GetActiveCamera()
        looking.SetPosition(*self.world(position))
        looking.SetFocalPoint(*self.world((0.0, 0.0, 0.0)))
        looking.SetParallelProjection(parallel)
        looking.SetParallelScale(4.0 * numpy.linalg.norm(self.transform[:3, 0]))
        self.renderer.ResetCameraClippingRange()
        self.window.Render()

    def world(self, point):
        return (self.transform @ (*point, 1.0))[:3]

    def display(self, point):
        """Where a point of the surface's coordinates is in the window, and its depth."""
        self.renderer.SetWorldPoint(*self.world(point), 1.0)
        self.renderer.WorldToDisplay()
        return numpy.array(self.renderer.GetDisplayPoint())

    def event(self, name, place=(0, 0), shift=False, key="\0", symbol=None, control=False):
        x, y = (int(round(number)) for number in place[:2])
        self.interactor.SetEventInformation(x, y, control, shift, key, 0, symbol)
        self.interactor.InvokeEvent(name)

    def drag(self, places, shift=False):
        self.event("LeftButtonPressEvent", places[0])
        for place in places[1:]:
            self.event("MouseMoveEvent", place, shift)
        self.event("LeftButtonReleaseEvent", places[-1])

    def press(self, symbol, key="\0", place=(5, 5), control=False):
        for name in ("KeyPressEvent", "CharEvent"):
            self.event(name, place, key=key, symbol=symbol, control=control)

    def pixels(self):
        """Red, green and blue of the window, row by row from the bottom up."""
        self.renderer.ResetCameraClippingRange()
        reader = vtkWindowToImageFilter()
        reader.SetInput(self.window)
        reader.ReadFrontBufferOff()
        reader.Update()
        scalars = reader.GetOutput().GetPointData().GetScalars()
        return vtk_to_numpy(scalars).reshape(SIZE[1], SIZE[0], 3).copy()


def place_of(get, *arguments):
    result = [0.0] * 3
    get(*arguments, result)
    return numpy.array(result)
