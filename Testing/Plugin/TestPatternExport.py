# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A script exports the contours of a view as SVG and PDF."""

import os
import xml.etree.ElementTree

import pattern_scene as scene
from paraview import servermanager, simple

SVG = "{http://www.w3.org/2000/svg}"

where = scene.view()
scene.show(simple.Sphere(ThetaResolution=60, PhiResolution=60), where)
scene.look(where, (0.6, 0.5, 2.5))
simple.Render(where)


def contours(path):
    root = xml.etree.ElementTree.parse(path).getroot()
    assert abs(float(root.get("width")[:-2]) - scene.SIZE[0] * 25.4 / 96) < 1e-3, root.get("width")
    return root.findall(".//" + SVG + "path"), root


def fresh(name):
    path = os.path.join(scene.output_folder, name)
    if os.path.exists(path):
        os.remove(path)
    return path


def export(name, **options):
    proxy = servermanager.CreateProxy("exporters", "HachureVectorExporter")
    proxy.SetView(where.SMProxy)
    path = fresh(name)
    proxy.GetProperty("FileName").SetElement(0, path)
    for option, value in options.items():
        proxy.GetProperty(option).SetElement(0, value)
    proxy.UpdateVTKObjects()
    proxy.Write()
    return path


lines, root = contours(export("TestPatternExport.svg"))
assert len(lines) == 1 and lines[0].get("d").endswith("Z"), len(lines)
assert root.find(SVG + "rect").get("fill") == "#808080"
lines, root = contours(export("TestPatternExport.svg", Background=0, Silhouettes=0))
assert not lines and root.find(SVG + "rect") is None
assert open(export("TestPatternExport.pdf"), "rb").read(5) == b"%PDF-"
