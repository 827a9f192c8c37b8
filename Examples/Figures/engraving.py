# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A skull in lines that run the way it bends most: engraving.py [FILE.png]"""

import hachure
from sheet import Sheet, save, skull

directions = hachure.vtkSurfaceDirectionField()
directions.SetInputData(skull())
directions.SetRadius(0.03)  # a voxel of the scan
directions.SetSmoothingIterations(60)
directions.Update()

style = hachure.style("engraving")
style.SetPaperColor(1, 1, 1)
style.SetOutlineColor(0, 0, 0)
style.GetLayer(0).SetColor(0, 0, 0)
style.GetLayer(0).SetDirectionArrayName("Direction")
mapper = hachure.vtkPatternMapper()
mapper.SetInputData(directions.GetOutput())
mapper.SetStyle(style)
mapper.ScalarVisibilityOff()

sheet = Sheet(520, 560)
sheet.add(mapper)
sheet.look((-1.6, -5.2, 0.9), (0.03, 0, -0.1), angle=24.5)
sheet.draw()
save([[sheet.picture()]], "engraving.png")
