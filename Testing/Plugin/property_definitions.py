# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the XML of a representation says of its properties."""

from paraview import servermanager

definitions = servermanager.vtkSMProxyManager.GetProxyManager().GetActiveSessionProxyManager()


def written(representation):
    """Properties in the XML that the plugin brings and that are set: dictionaries of their attributes, and a tag."""
    manager = definitions.GetProxyDefinitionManager()
    proxy = manager.GetProxyDefinition("representations", representation + "Representation")
    elements = [proxy.GetNestedElement(i) for i in range(proxy.GetNumberOfNestedElements())]
    names = "name", "command", "number_of_elements", "default_values", "panel_visibility"
    return [
        dict({name: element.GetAttribute(name) for name in names}, tag=element.GetName())
        for element in elements
        if element.GetName().endswith("VectorProperty") and not element.GetAttribute("information_only")
    ]
