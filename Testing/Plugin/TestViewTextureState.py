# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Two views with textures of their own come back from a state file and from a Python script, which ParaView traces."""

import pattern_scene as scene
from state_scene import two_views_come_back
from view_pictures import BLUE, RED, manifest, painted, show, waves

manifests = (
    manifest("first", painted("all", RED), painted("front", waves(), extremes=50, size=256)),
    manifest("second", painted("waves", waves(period=60), size=256), painted("front", BLUE, extremes=25), finestLevel=3),
)
options = (
    {"Manifest": manifests[0], "Level": "One for all", "Outline": "On", "OutlineWidth": 3, "MemoryBudget": 64},
    {"Manifest": manifests[1], "Base": "What lies below", "Paper": "Color", "PaperColor": [0.2, 0.6, 0]},
)
options[0].update(Tone="Array", ToneRange=[0.6, -0.5], PropagateUp="Off")
options[1].update(InkOpacity=0.8, ClassicShares="On", ExtremeAngle=20, SaveName="/nowhere/a.json")


def open_view(source, choice):
    """A view of the source with these options."""
    where = scene.view((160, 120))
    arrays = {"ToneArray": ["POINTS", "Elevation"]} if choice is options[0] else {}
    show(where, source, **dict(choice, **arrays))
    scene.look(where, (0.6, 0, 3))
    return where


def check_names(where):
    """No button was pressed when the view came back."""
    display = where.Representations[0]
    display.SMProxy.UpdatePropertyInformation()
    assert len(display.ViewTextureNames) == 2, "a button was pressed"


two_views_come_back("view", options, open_view, 3, check_names)
