# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The defaults in the plugin's XML equal those of the classes, and every command exists."""

import os
import xml.etree.ElementTree as xml

import hachure

folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Plugin")
compared = 0


def read(value):
    """The value of a getter as a list, numbers as floats."""
    values = value if isinstance(value, (tuple, list)) else [value]
    return [item if isinstance(item, str) else float(item) for item in values]


def compare(proxy):
    """Compares every property of this proxy with a new object of its class."""
    global compared
    thing = getattr(hachure, proxy.get("class"))()
    for item in proxy.iter():
        command = item.get("command", "")
        if not item.tag.endswith("VectorProperty") or item.get("default_values") is None:
            continue
        where = proxy.get("name") + "." + item.get("name")
        assert hasattr(thing, command), where + ": no " + command
        actual = read(getattr(thing, command.replace("Set", "Get", 1))())
        written = item.get("default_values")
        if item.tag == "StringVectorProperty":
            expected = [written]
        else:
            expected = [float(number) for number in written.split()]
        assert actual == expected, "%s: %s in XML, %s in C++" % (where, expected, actual)
        compared += 1


for name in sorted(os.listdir(folder)):
    if name.endswith(".xml"):
        tree = xml.parse(os.path.join(folder, name))
        for kind in ("SourceProxy", "RenderViewExporterProxy"):
            for proxy in tree.iter(kind):
                compare(proxy)
assert compared >= 10, compared
