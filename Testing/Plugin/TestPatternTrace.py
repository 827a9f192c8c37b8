# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView traces while a representation is chosen and set, run as a script, draws the same."""

import pattern_scene as scene
from paraview import servermanager, simple, smtrace
from view_pictures import LABEL, WHITE, manifest, painted, waves

views = manifest("views", painted("waves", waves(64, 32), size=64), painted("front", WHITE, (0, 3, 0.5), 50), finestLevel=2)
tone = {"Tone": "Array", "ToneArray": ["POINTS", "Elevation"], "ToneRange": [0.1, 1.3]}
KINDS = {
    "Pattern": dict(tone, Style="halftone", Scale=1.5, Patches="Automatic", NumberOfPatches=3),
    "Noise": dict(tone, Style="gabor", Angle=33, Ink="Color", InkColor=[0.1, 0.2, 0.7]),
    "Stipple": dict(tone, Size=4, Refinement="Off", NumberOfPoints=3000, Paper="Lit surface"),
    LABEL: {"Manifest": views, "InkOpacity": 0.5, "Outline": "On", "OutlineWidth": 3},
}


def item(key, *arguments, **named):
    """What the window notes while the user does something, until finalize() is called."""
    return smtrace._create_trace_item_internal(key, arguments, named)  # pylint: disable=protected-access


def traced(display, kind, properties):
    """The script of choosing the representation and setting its properties."""
    smtrace.start_trace()
    item("CallMethod", display.SMProxy, "SetRepresentationType", kind).finalize()
    display.SetRepresentationType(kind)
    changes = item("PropertiesModified", display.SMProxy)
    for name, value in properties.items():
        setattr(display, ("ViewTexture" if kind == LABEL else kind) + name, value)
    changes.finalize()
    return smtrace.stop_trace()


def show():
    """A view of a ball as a surface."""
    where = scene.view((120, 90))
    display = scene.show(ball, where, Representation="Surface")
    scene.look(where, (0.3, 0.5, 2.5))
    servermanager.ProxyManager().RegisterProxy("representations", "shown", display.SMProxy)
    simple.SetActiveView(where)
    simple.SetActiveSource(ball)
    return where, display


ball = simple.Elevation(
    registrationName="Ball",
    Input=simple.Sphere(ThetaResolution=24, PhiResolution=24),
    LowPoint=[0, -0.5, 0],
    HighPoint=[0, 0.5, 0],
)
for kind, properties in KINDS.items():
    where, display = show()
    surface = scene.picture(where)
    script = traced(display, kind, properties)
    shown = scene.picture(where, "traced-" + kind.split("-")[0])
    assert scene.difference(shown, surface) > 3, kind
    simple.Delete(where)
    where, display = show()
    assert (scene.picture(where) == surface).all(), kind
    exec(compile(script, "trace", "exec"), {})  # pylint: disable=exec-used
    again = scene.picture(where)
    assert (again == shown).all(), (kind, scene.difference(again, shown), script)
    simple.Delete(where)
