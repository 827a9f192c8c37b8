# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The buttons of View-dependent Texture in the panel add views and save them; a filter of the menu runs."""

import json
import os

import steps
import window

BUTTON = "%s/0QPushButton0"
saved = os.path.join(window.OUTPUT, "views.json")

printed = window.play(
    steps.sphere(),
    steps.represent("View-dependent Texture"),
    steps.display(BUTTON % "ViewTextureAddCamera", "activate"),
    steps.drag((0.4, 0.5), (0.6, 0.65)),
    steps.display(BUTTON % "ViewTextureAddCamera", "activate"),
    steps.display("ViewTextureSaveName/FileChooser/FileLineEdit", "set_string", saved),
    steps.display(BUTTON % "ViewTextureSave", "activate"),
    steps.hachure_filter("HachureStipples"),
    steps.parameter("NumberOfPoints/IntRangeWidget/LineEdit", "set_string", 3000),
    steps.apply(),
    steps.represent("Points"),
    window.picture("stipples"),
)
assert "ERR|" not in printed, printed
with open(saved, encoding="ascii") as file:
    views = json.load(file)["views"]
assert [view["kind"] for view in views] == ["dependent"] * 2, views
for view in views:
    picture = window.pixels(os.path.join(window.OUTPUT, view["image"]))
    assert picture.min() != picture.max(), view["image"] + " is empty"
first, second = (view["camera"]["position"] for view in views)
assert abs(first[0]) < 0.01 and abs(second[0]) > 1, (first, second)
# 3000 white points, of which the picture shows half.
assert 0.05 < (window.shown("stipples") > 240).all(axis=2).mean() < 0.25
