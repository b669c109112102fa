# SPDX-License-Identifier: BSD-3-Clause
"""Markdown of texts that are none."""
import re

# An underscore within a word is none: of an escaped one in a heading mkdocs 1.4 shows a control character in its menu.
SPECIAL = re.compile(r"([\\`*{}\[\]<>|#]|(?<![^\W_])_|_(?![^\W_]))")


def escaped(text):
    return SPECIAL.sub(r"\\\1", text)


def code(text):
    return f"`{text}`" if "`" not in text else escaped(text)


def table(titles, lines):
    """Cells are Markdown already."""
    head = "| " + " | ".join(titles) + " |\n|" + "---|" * len(titles) + "\n"
    return head + "".join("| " + " | ".join(cells) + " |\n" for cells in lines) + "\n"


def anchor(heading):
    """What mkdocs makes of a heading."""
    return re.sub(r"\s", "-", re.sub(r"[^\w\s-]", "", heading).strip().lower())
