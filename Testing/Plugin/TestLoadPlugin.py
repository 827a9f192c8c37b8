# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin loads into a ParaView that did not know it, without the libraries of another VTK."""

import sys

from paraview import servermanager, simple

plugin = sys.argv[1]


def loaded():
    manager = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager()
    info = manager.GetLocalInformation()
    return [
        info.GetPluginName(i) for i in range(info.GetNumberOfPlugins()) if info.GetPluginLoaded(i)
    ]


assert "Hachure" not in loaded()
simple.LoadPlugin(plugin, remote=False)
assert "Hachure" in loaded(), loaded()
with open("/proc/self/maps", encoding="ascii", errors="replace") as maps:
    libraries = maps.read()
assert "HachureFilters-9" not in libraries, "the libraries of plain VTK came along"
