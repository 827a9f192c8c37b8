# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""All representations are chosen in the toolbar, changed in the panel, undone, redone and turned with the mouse."""

import steps
import window

LABELS = {"Pattern": "pattern", "Noise": "noise", "Stipple": "stipple", "View-dependent Texture": "view-texture"}
TOOLBAR = steps.MAIN + "representationToolbar/displayRepresentation/comboBox"
STYLE = steps.DISPLAY + "PatternStyle/ComboBox"
SEARCH = steps.PANEL + "SearchBox/SearchLineEdit"

chosen = [steps.sphere()]
for label, name in LABELS.items():
    chosen += [steps.represent(label), steps.check(TOOLBAR, "currentText", label), window.picture(name)]
printed = window.play(
    *chosen,
    steps.represent("Pattern"),
    steps.event(STYLE, "set_string", "halftone"),
    steps.menu("menu_Edit", "actionEditUndo"),
    steps.check(STYLE, "currentText", "cross-hatch"),
    window.picture("undone"),
    steps.menu("menu_Edit", "actionEditRedo"),
    steps.check(STYLE, "currentText", "halftone"),
    steps.drag((0.4, 0.5), (0.6, 0.65)),
    # The search line shows advanced properties without the gear.
    steps.event(SEARCH, "set_string", "invert tone"),
    steps.display("PatternToneInvert/ComboBox", "set_string", "On"),
    window.picture("inverted"),
)

assert "ERR|" not in printed and "WARN|" not in printed, printed
pictures = {name: window.shown(name) for name in [*LABELS.values(), "undone", "inverted"]}
assert window.differing(pictures["pattern"], pictures.pop("undone")) == 0
for name, picture in pictures.items():
    # The sphere is in the middle; the axes are at the lower left.
    assert (picture[90:, :40] == picture[-1, 0]).all(), name + " draws on the ground"
    for other in pictures:
        alike = window.differing(picture, pictures[other]) < 0.01 * picture.size / 3
        assert alike == (other == name), "%s looks like %s" % (name, other)
for name in LABELS.values():
    window.compare(name)
