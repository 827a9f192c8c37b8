# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a surface to paint over, and what makes views of them."""

import hachure
import numpy
import vtk
from sheet import Sheet
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

LIGHTS = ((-4, -6, 6), 0.85), ((6, -3, 1), 0.3), ((0, 6, 4), 0.3)  # places, brightness


def camera_at(position, focal_point=(0, 0, 0), angle=30):
    camera = vtk.vtkCamera()
    camera.SetPosition(*position)
    camera.SetFocalPoint(*focal_point)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(angle)
    return camera


def around(azimuth, elevation=0, distance=1):
    """A place around the origin, degrees from the front, which is where -y is, to the right."""
    azimuth, elevation = numpy.radians(azimuth), numpy.radians(elevation)
    return distance * numpy.array([numpy.cos(elevation) * numpy.sin(azimuth),
                                   -numpy.cos(elevation) * numpy.cos(azimuth), numpy.sin(elevation)])


class Studio:
    """Takes pictures of a surface under lights that stay, to paint over."""

    def __init__(self, width, height, actor):
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.renderer.AddActor(actor)
        for place, brightness in LIGHTS:
            light = vtk.vtkLight()
            light.SetLightTypeToSceneLight()
            light.SetPosition(*place)
            light.SetIntensity(brightness)
            self.renderer.AddLight(light)
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(width, height)
        self.window.AddRenderer(self.renderer)

    def take(self, camera):
        """Bytes [row from below, column, colour], and where the surface is."""
        self.renderer.SetActiveCamera(camera)
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        width, height = self.window.GetSize()
        colors, depths = vtk.vtkUnsignedCharArray(), vtk.vtkFloatArray()
        self.window.GetPixelData(0, 0, width - 1, height - 1, 1, colors, 0)
        self.window.GetZbufferData(0, 0, width - 1, height - 1, depths)
        self.depths = vtk_to_numpy(depths).reshape(height, width).copy()
        return vtk_to_numpy(colors).reshape(height, width, 3).copy(), self.depths < 1

    def places(self):
        """Of every pixel of the last picture the place of what it shows."""
        height, width = self.depths.shape
        camera = self.renderer.GetActiveCamera()
        matrix = camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1)
        to_place = numpy.linalg.inv([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        rows, columns = numpy.mgrid[0:height, 0:width] + 0.5
        clip = numpy.stack([2 * columns / width - 1, 2 * rows / height - 1, 2 * self.depths - 1,
                            numpy.ones_like(rows)], axis=-1) @ to_place.T
        return clip[..., :3] / clip[..., 3:]


def image(colors, alpha):
    """Bytes of colours, with where they count, as booleans or from 0 to 1."""
    alpha = numpy.round(255 * numpy.clip(alpha, 0, 1)).astype(numpy.uint8)
    pixels = numpy.dstack([colors, alpha])
    result = vtk.vtkImageData()
    result.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    result.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 4), deep=True))
    return result


def add_dependent(views, name, camera, picture, reach):
    """A view that is gone where the camera is `reach` degrees aside: (to the sides, up and down)."""
    index = views.AddView(name, camera, picture)
    views.SetViewKind(index, views.DEPENDENT)
    for azimuth, elevation in ((reach[0], 0), (0, reach[1]), (-reach[0], 0), (0, -reach[1])):
        aside = vtk.vtkCamera()
        aside.DeepCopy(camera)
        aside.Azimuth(azimuth)
        aside.Elevation(elevation)
        views.AddExtremePoint(index, aside.GetPosition())
    return index


def shown(surface, style, width=300, height=300):
    """A sheet with a surface in a style."""
    mapper = hachure.vtkPatternMapper()
    mapper.SetInputData(surface)
    mapper.ScalarVisibilityOff()
    mapper.SetStyle(style)
    sheet = Sheet(width, height)
    sheet.add(mapper)
    return sheet
