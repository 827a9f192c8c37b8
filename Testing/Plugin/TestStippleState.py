# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Two views stipple a source each in its own way; a state file and a traced Python script bring both back."""

import pattern_scene as scene
from state_scene import two_views_come_back

options = (
    {"StippleStyle": "stipple-two-inks", "StippleSize": 3.2, "StippleSeed": 4, "StippleRefinement": "Off"},
    {"StippleStyle": "stipple-white", "StippleScale": 1.5, "StippleCarrier": "Size", "StippleGrowth": 0.6},
)
options[0].update(StippleNumberOfPoints=9000, StippleOutline="On", StippleOutlineWidth=3)
options[1].update(StippleNumberOfPoints=12000, StippleTone="Array", StippleToneRange=[0.6, -0.5])
options[1].update(StipplePaper="Color", StipplePaperColor=[0.2, 0, 0.3], StippleMemoryBudget=64)


def open_view(source, choice):
    """A view of the source with these options."""
    where = scene.view((160, 120))
    arrays = {"StippleToneArray": ["POINTS", "Elevation"]} if choice else {}
    scene.show(source, where, Representation="Stipple", **dict(choice, **arrays))
    scene.look(where, (0, 0.5, 3))
    return where


two_views_come_back("stipple", options, open_view, 5)
