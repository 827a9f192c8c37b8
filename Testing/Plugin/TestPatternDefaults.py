# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Defaults in the XML equal those of the class, every property reaches it, and no style is forgotten."""

import os
import xml.etree.ElementTree as xml

import pattern_scene as scene
from paraview import servermanager, simple

folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Plugin/Representations")
written = xml.parse(os.path.join(folder, "PatternRepresentation.xml")).find(".//RepresentationProxy")
properties = [item for item in written if item.tag.endswith("VectorProperty")]
assert len(properties) >= 15, len(properties)
with_default = [item for item in properties if item.get("default_values") is not None]
without = [item.get("name") for item in properties if item not in with_default]
assert all(name.endswith("Array") for name in without), "only arrays, which the data decide, have no default"


def numbers_or_text(item, text):
    """A value of the property in comparable form."""
    if item.tag == "StringVectorProperty":
        return text
    return [float(part) for part in text.split()]


# A proxy that only asks: its object is as the constructor left it.
asking = ['<Proxy name="PatternGetters" class="vtkPatternRepresentation">']
for item in with_default:
    assert item.get("command") == "Set" + item.get("name"), item.get("name")
    count = item.get("number_of_elements")
    never = "-77 " * int(count)  # stays when the question fails
    asking.append(
        '<%s name="%s" command="Get%s" information_only="1" number_of_elements="%s" default_values="%s" />'
        % (item.tag, item.get("name"), item.get("name"), count, never)
    )
asking.append("</Proxy>")
definitions = servermanager.vtkSMProxyManager.GetProxyManager().GetActiveSessionProxyManager()
assert definitions.LoadConfigurationXML(
    "<ServerManagerConfiguration><ProxyGroup name='misc'>%s</ProxyGroup></ServerManagerConfiguration>"
    % "".join(asking)
)
getters = definitions.NewProxy("misc", "PatternGetters")
getters.UpdateVTKObjects()
getters.UpdatePropertyInformation()
for item in with_default:
    actual = getters.GetProperty(item.get("name"))
    values = [actual.GetElement(i) for i in range(actual.GetNumberOfElements())]
    in_class = values[0] if item.tag == "StringVectorProperty" else [float(v) for v in values]
    in_xml = numbers_or_text(item, item.get("default_values"))
    assert in_class == in_xml, "%s: %s in C++, %s in XML" % (item.get("name"), in_class, in_xml)

# All four kinds of proxies expose every property, with the default of the XML where data have no say.
for proxy in (
    "GeometryRepresentation",
    "StructuredGridRepresentation",
    "UniformGridRepresentation",
    "UnstructuredGridRepresentation",
):
    extended = definitions.NewProxy("representations", proxy)
    extended.UpdateVTKObjects()
    extended.UpdatePropertyInformation()
    kinds = extended.GetProperty("Representation").GetDomain("list")
    texts = [kinds.GetString(i) for i in range(kinds.GetNumberOfStrings())]
    assert "Pattern" in texts, "%s: %s" % (proxy, texts)
    for item in properties:
        assert extended.GetProperty(item.get("name")), proxy + " lacks " + item.get("name")

# The table of the README names every property.
with open(os.path.join(folder, "../../README.md"), encoding="utf-8") as readme:
    rows = [line.split("|")[1] for line in readme if line.startswith("| `Pattern")]
listed = [name.strip("` ") for row in rows for name in row.split(",")]
assert sorted(listed) == sorted(item.get("name") for item in properties), listed

# The list of styles is that of the class, which names them all when there is an error.
domain = extended.GetProperty("PatternStyle").GetDomain("styles")
offered = [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]
where = scene.view()
with scene.Messages() as messages:
    display = scene.show(simple.Sphere(), where, PatternStyle="no such style")
    simple.Render(where)
assert '"no such style"; expected one of ' + ", ".join(offered) + "." in messages.text, messages.text
