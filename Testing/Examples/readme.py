# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The README and the code in it."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")


def blocks(language):
    """The blocks of code in this language, in their order."""
    return re.findall(r"^```" + language + r"\n(.*?)^```$", TEXT, re.MULTILINE | re.DOTALL)


def block(language, word):
    """The one block of code in this language that holds the word."""
    found = [code for code in blocks(language) if word in code]
    assert len(found) == 1, "%d blocks of %s with %s" % (len(found), language, word)
    return found[0]


def links(page):
    """What a page of the repository refers to, without addresses on the web."""
    targets = re.findall(r"\]\(([^)#]+)", page.read_text(encoding="utf-8"))
    return [target for target in targets if "://" not in target]
