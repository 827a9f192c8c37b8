# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A pattern travels, turns and grows with its object: travelling.py [FILE.png]"""

import functools

import hachure
import numpy
from sheet import Sheet, save, skull

sheet = Sheet(900, 300)
mapper = hachure.vtkPatternMapper()
mapper.SetInputData(skull())
mapper.SetStyle(hachure.style("hatch"))
layer = mapper.GetStyle().GetLayer(0)
layer.SetSize(5)
layer.SetLodStart(1.7)  # strokes grow as long as they may before finer ones take over
layer.SetLodEnd(1.95)
actor = sheet.add(mapper)
sheet.look((0, -40, 0), (0, 0, 0), angle=5.4)

# Four of 61 frames, printed over each other.
pictures = []
for part in numpy.linspace(0, 1, 61):
    actor.SetPosition(-4.5 + 8.4 * part ** 0.9, 0, 0.35 - 0.35 * part)
    actor.SetScale(0.84 * 1.65 ** part)
    actor.SetOrientation(0, 60 * part - 40, -28)
    sheet.draw()
    if round(60 * part) % 20 == 0:
        pictures.append(sheet.picture())
save([[functools.reduce(numpy.minimum, pictures)]], "travelling.png")
