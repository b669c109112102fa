# SPDX-License-Identifier: BSD-3-Clause
"""Markdown of texts that are none."""
import re

SPECIAL = re.compile(r"([\\`*_{}\[\]<>|#])")


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
