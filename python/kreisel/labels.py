# SPDX-License-Identifier: BSD-3-Clause
"""Labels of kreisel's figures, which are enhanced text of gnuplot, and names as text of matplotlib."""
from __future__ import annotations

def _item(label: str, at: int) -> tuple[str, int]:
    """The text of the character or group at a place, and the place behind it."""
    if label[at] == "\\":
        return label[at + 1:at + 2], at + 2
    if label[at] != "{":
        return label[at], at + 1
    text, at = "", at + 1
    while at < len(label) and label[at] != "}":
        part, at = _item(label, at)
        text += part
    return text, at + 1


def _literal(text: str) -> str:
    """What shows as this text in mathematics."""
    return "".join("\\" + c if c in "\\{}_^$%#& " else c for c in text)


def _never_hidden(text: str) -> str:
    """matplotlib leaves curves whose label begins with an underscore out of legends."""
    return r"$\_$" + text[1:] if text.startswith("_") else text


def plain_text(text: str) -> str:
    """What shows as this text, whatever it holds: matplotlib reads mathematics between dollar signs."""
    return _never_hidden(text.replace("$", r"\$"))


def matplotlib_text(label: str) -> str:
    r"""x_{ref} becomes x$_{\mathrm{ref}}$; a backslash makes the next character literal."""
    text, at = "", 0
    while at < len(label):
        if label[at] in "_^" and at + 1 < len(label):
            shift = label[at]
            part, at = _item(label, at + 1)
            text += rf"${shift}{{\mathrm{{{_literal(part)}}}}}$"
        else:
            part, at = _item(label, at)
            text += part.replace("$", r"\$")
    return _never_hidden(text)
