# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Steps of a user of ParaView's window. Each is a list of events for ParaView's own test player."""

import xml.etree.ElementTree as xml

MAIN = "pqClientMainWindow/"
PANEL = MAIN + "propertiesDock/propertiesPanel/"
FRAMES = PANEL + "scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/"
DISPLAY = FRAMES + "DisplayFrame/ProxyPanel/"
VIEW = MAIN + (
    "centralwidget/MultiViewWidget/CoreWidget/qt_tabwidget_stackedwidget/MultiViewWidget1/Container/Frame.0/"
    "CentralWidgetFrame/Viewport"
)


def event(place, command, arguments=""):
    """One event; place is the path of a widget."""
    return [("pqevent", {"object": place, "command": command, "arguments": str(arguments)})]


def check(place, name, value):
    """Fails the playing unless this property of a widget has this value."""
    return [("pqcheck", {"object": place, "property": name, "arguments": str(value)})]


def menu(*names):
    """Opens a menu of the menu bar, and chooses the last name in it or in its submenu."""
    place = MAIN + "menubar"
    return event(place, "activate", names[0]) + event("/".join([place, *names[:-1]]), "activate", names[-1])


def open_menu(name, submenu):
    """Opens a menu and a submenu of it, and leaves them open."""
    place = MAIN + "menubar"
    return [event(place, "activate", name), event(place + "/" + name, "activate", submenu)]


def click(place, where):
    """Clicks a widget with the left button; where is x,y in pixels, and for a list ,/row:column."""
    return event(place, "mousePress", "1,1,0," + where) + event(place, "mouseRelease", "1,0,0," + where)


def open_file(file_name):
    """Opens a file of data, not applied."""
    return menu("menu_File", "actionFileOpen") + event(MAIN + "FileOpenDialog", "filesSelected", file_name)


def sphere():
    """A sphere that is round to the eye."""
    place = FRAMES + "PropertiesFrame/ProxyPanel/%sResolution/LineEdit0"
    steps = menu("menuSources", "Alphabetical", "SphereSource")
    for way in ("Theta", "Phi"):
        steps += event(place % way, "set_string", 48)
    return steps + apply()


def hachure_filter(name):
    """A new filter of ours on what is active, from the menu, not applied."""
    return menu("menuFilters", "Hachure", name)


def apply():
    """The button Apply."""
    return event(PANEL + "Accept", "activate")


def represent(label):
    """Chooses a representation in the toolbar."""
    return event(MAIN + "representationToolbar/displayRepresentation/comboBox", "set_string", label)


def display(place, command, arguments=""):
    """Changes a property of how data is shown, in the panel."""
    return event(DISPLAY + place, command, arguments)


def parameter(place, command, arguments=""):
    """Changes a property of a source or filter, in the panel."""
    return event(FRAMES + "PropertiesFrame/ProxyPanel/" + place, command, arguments)


def drag(start, end):
    """Moves the mouse over the view with its left button pressed, between shares of width and height."""
    steps = event(VIEW, "mousePress", "(%g,%g,1,1,0)" % start)
    for share in (0.25, 0.5, 0.75, 1.0):
        place = tuple(a + share * (b - a) for a, b in zip(start, end))
        steps += event(VIEW, "mouseMove", "(%g,%g,1,0,0)" % place)
    return steps + event(VIEW, "mouseRelease", "(%g,%g,1,0,0)" % end)


def picture(file_name, size):
    """Saves the view as a picture, with the dialog for it."""
    options = MAIN + "SaveScreenshotDialog/"
    place = options + "scrollArea/qt_scrollarea_viewport/Container/ProxyWidget/ImageResolution/"
    steps = menu("menu_File", "actionFileSaveScreenshot")
    steps += event(MAIN + "SaveScreenshotFileDialog", "filesSelected", file_name)
    for side, pixels in zip(("width", "height"), size):
        steps += event(place + side, "set_string", pixels)
    return steps + event(options + "widget/OKButton", "activate")


def write(file_name, steps):
    """Writes steps as a file that ParaView plays."""
    root = xml.Element("pqevents")
    for step in steps:
        for tag, attributes in step:
            xml.SubElement(root, tag, attributes)
    xml.indent(root)
    xml.ElementTree(root).write(file_name, encoding="utf-8", xml_declaration=True)
