# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""draw_with_vtk.py SURFACE.vtp WIDTH HEIGHT POSITION FOCAL UP ANGLE FOLDER STYLE...

Draws a surface with VTK alone as TestPatternSkull.py does with ParaView: FOLDER/vtk-<STYLE>.png for every
style. Vectors are three numbers separated by commas.
"""

import sys

import hachure
import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

surface, width, height, position, focal, up, angle, folder = sys.argv[1:9]
vector = lambda text: [float(part) for part in text.split(",")]

reader = vtkXMLPolyDataReader()
reader.SetFileName(surface)
# In the order in which ParaView's representation takes it.
whole = hachure.vtkWholeSurface()
whole.SetInputConnection(reader.GetOutputPort())
part = hachure.vtkSurfacePart()
part.SetInputConnection(0, whole.GetOutputPort(0))
part.SetInputConnection(1, whole.GetOutputPort(1))
part.Update()
for style in sys.argv[9:]:
    mapper = hachure.vtkPatternMapper()
    mapper.SetInputConnection(part.GetOutputPort())
    mapper.SetWholeSurface(whole.GetOutputDataObject(1))
    mapper.ScalarVisibilityOff()
    mapper.GetStyle().LoadPreset(style)
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.SetBackground(0.5, 0.5, 0.5)
    renderer.AddActor(actor)
    renderer.AutomaticLightCreationOff()
    light = vtkLight()
    light.SetLightTypeToHeadlight()
    renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(vector(position))
    camera.SetFocalPoint(vector(focal))
    camera.SetViewUp(vector(up))
    camera.SetViewAngle(float(angle))
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(int(width), int(height))
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName("%s/vtk-%s.png" % (folder, style))
    writer.Write()
