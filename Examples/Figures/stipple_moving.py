# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A skull in stipples turns and comes nearer, while the light moves: stipple_moving.py [FILE.png]"""

import hachure
import numpy
from sheet import Sheet, save, skull

AMBIENT = 0.15  # so that shadows stay drawn

sheet = Sheet(900, 300)
key, fill = map(sheet.renderer.GetLights().GetItemAsObject, range(2))
fill.SwitchOff()
mapper = hachure.vtkPatternMapper()
mapper.SetInputData(skull())
mapper.SetStyle(hachure.style("stipple"))
mapper.GetStyle().GetLayer(0).SetSize(2)
actor = sheet.add(mapper)
actor.GetProperty().SetAmbient(AMBIENT)
sheet.look((0, -40, 0), (0, 0, 0), angle=5)

# Four frames, printed over each other.
paper = numpy.ones((300, 900, 3))
for part in numpy.linspace(0, 1, 4):
    actor.SetPosition(8.1 * part ** 0.95 - 4.1, 0, 0.1 - 0.05 * part)
    actor.SetScale(1.15 * 1.35 ** part)
    actor.SetOrientation(0, 20 - 30 * part, 75 * part - 60)
    key.SetDirectionAngle(40 - 20 * part, 130 * part - 80)
    sheet.draw()
    paper = numpy.minimum(paper, sheet.picture())
save([[paper]], "stipple_moving.png")
