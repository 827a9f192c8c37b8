# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A light goes around a skull in stipples: stipple_light.py [FILE.png]"""

import hachure
from sheet import Sheet, save, skull

AZIMUTHS = (-80, -35, 10, 55)  # of the light, degrees to the right of the viewer
ELEVATION = 35
AMBIENT = 0.15  # so that shadows stay drawn

row = []
bone = skull()
for azimuth in AZIMUTHS:
    mapper = hachure.vtkPatternMapper()
    mapper.SetInputData(bone)
    mapper.SetStyle(hachure.style("stipple"))
    mapper.GetStyle().GetLayer(0).SetSize(2)
    sheet = Sheet(225, 280, light=(azimuth, ELEVATION))
    sheet.renderer.GetLights().GetItemAsObject(1).SwitchOff()
    sheet.add(mapper).GetProperty().SetAmbient(AMBIENT)
    sheet.look((-1.9, -5.1, 0.9), (0.03, 0, -0.12), angle=24)
    sheet.draw()
    row.append(sheet.picture())
save([row], "stipple_light.png")
