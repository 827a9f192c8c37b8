# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Defaults in the XML equal those of the classes, every property reaches them, and no style is forgotten."""

import os

import pattern_scene as scene
from paraview import simple
from property_definitions import definitions, written

PROXIES = (
    "GeometryRepresentation",
    "StructuredGridRepresentation",
    "UniformGridRepresentation",
    "UnstructuredGridRepresentation",
)
LABELS = {"ViewTexture": "View-dependent Texture"}  # of those that are not named as their class


def asking_proxy(representation, properties):
    """A proxy that only asks: its object is as the constructor left it."""
    text = '<Proxy name="%sGetters" class="vtk%sRepresentation">' % (representation, representation)
    for item in properties:
        never = "-77 " * int(item["number_of_elements"])  # stays when the question fails
        text += (
            '<%s name="%s" command="%s" information_only="1" number_of_elements="%s" default_values="%s" />'
            % (item["tag"], item["name"], item["command"].replace("Set", "Get", 1),
               item["number_of_elements"], never)
        )
    text += "</Proxy>"
    assert definitions.LoadConfigurationXML(
        "<ServerManagerConfiguration><ProxyGroup name='misc'>%s</ProxyGroup></ServerManagerConfiguration>" % text
    )
    getters = definitions.NewProxy("misc", representation + "Getters")
    getters.UpdateVTKObjects()
    getters.UpdatePropertyInformation()
    return getters


def check_defaults(representation, properties):
    """Of the class and of the XML."""
    with_default = [item for item in properties if item["default_values"] is not None]
    without = [item["name"] for item in properties if item not in with_default]
    assert all(name.endswith("Array") for name in without), "only arrays, which the data decide, have no default"
    getters = asking_proxy(representation, with_default)
    for item in with_default:
        actual = getters.GetProperty(item["name"])
        in_class = [actual.GetElement(i) for i in range(actual.GetNumberOfElements())]
        in_xml = [item["default_values"]]
        if item["tag"] != "StringVectorProperty":
            in_class = [float(value) for value in in_class]
            in_xml = [float(value) for value in item["default_values"].split()]
        assert in_class == in_xml, "%s: %s in C++, %s in XML" % (item["name"], in_class, in_xml)


def check_proxy(proxy, representation, properties):
    """One of the kinds of proxies exposes every property."""
    extended = definitions.NewProxy("representations", proxy)
    extended.UpdateVTKObjects()
    extended.UpdatePropertyInformation()
    kinds = extended.GetProperty("Representation").GetDomain("list")
    texts = [kinds.GetString(i) for i in range(kinds.GetNumberOfStrings())]
    assert LABELS.get(representation, representation) in texts, "%s: %s" % (proxy, texts)
    for item in properties:
        assert extended.GetProperty(item["name"]), proxy + " lacks " + item["name"]


def styles(representation):
    """Those that are offered."""
    display = simple.GetDisplayProperties(ball, where)
    domain = display.SMProxy.GetProperty(representation + "Style").GetDomain("styles")
    return [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]


pattern = written("Pattern")
least_counts = {"Noise": 40, "Stipple": 35, "ViewTexture": 30}
others = {representation: written(representation) for representation in least_counts}
assert len(pattern) >= 60, len(pattern)
for representation, least in least_counts.items():
    assert len(others[representation]) >= least, (representation, len(others[representation]))
for representation, properties in ("Pattern", pattern), *others.items():
    check_defaults(representation, properties)
    assert all(item["name"].startswith(representation) for item in properties), properties
    for proxy in PROXIES:
        check_proxy(proxy, representation, properties)

# A property of another representation sets what it says, or is one of Pattern and the same in all but its name.
assert all(item["command"] == "Set" + item["name"] for item in pattern)
named = {item["name"]: item for item in pattern}
for representation, properties in others.items():
    for item in properties:
        stem = item["name"][len(representation) :]
        if item["command"] != "Set" + item["name"] and stem != "Style":
            assert item == dict(named["Pattern" + stem], name=item["name"]), item

# The table of the plugin's page names every property.
readme_file = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Plugin/README.md")
with open(readme_file, encoding="utf-8") as readme:
    rows = [line.split("|")[1] for line in readme if line.startswith("| `Pattern")]
listed = [name.strip("` ") for row in rows for name in row.split(",")]
assert sorted(listed) == sorted(named), listed

# The lists of styles together are that of the class, which names them all when there is an error.
ball = simple.Sphere()
where = scene.view()
with scene.Messages() as messages:
    scene.show(ball, where, PatternStyle="no such style")
    simple.Render(where)
wanted = messages.text.split('"no such style"; expected one of ')[1].split(".")[0].split(", ")
listed = [name for representation in ("Pattern", *others) for name in styles(representation)]
assert sorted(listed) == sorted(wanted), wanted
