# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A row of skulls, each with a pattern of its own that one similarity moves: skulls.py [FILE.png]"""

import hachure
import numpy
from sheet import Sheet, save, skull

bone = skull()
sheet = Sheet(900, 300)
style = hachure.style("cross-hatch")
for layer in map(style.GetLayer, range(style.GetNumberOfLayers())):
    layer.SetSize(5)
for place in range(6):
    mapper = hachure.vtkPatternMapper()
    mapper.SetInputData(bone)
    mapper.SetStyle(style)
    actor = sheet.add(mapper)
    actor.SetPosition(1.75 * place, 0, 0)
    actor.RotateZ(-25 + 10 * (place % 3))

# The viewer walks along the row.
for part in numpy.linspace(0, 1, 13):
    sheet.look((-5.6 + 1.6 * part, -5.4, 1.3), (2.85, 0, -0.46), angle=21.2)
    sheet.draw()
save([[sheet.picture()]], "skulls.png")
