# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the guide, and the blocks in them.

A line `<!-- run by FILE -->` before a block of commands names the script that runs them, `<!-- needs PURPOSE -->` what
tools/setup must have installed for them. A block after a line that ends in `NAME`: is that file.
"""
import dataclasses
import os
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^```(\w*)\s*$")
MARK = re.compile(r"^<!-- (run by|needs) (\S+) -->$")
NAMED = re.compile(r"`([\w./-]+\.\w+)`:$")


@dataclasses.dataclass
class Block:
    page: str
    line: int
    language: str
    text: str
    mark: str = ""      # "run by" or "needs"
    argument: str = ""  # of the mark
    name: str = ""      # of the file that it is

    @property
    def place(self):
        return f"{self.page}:{self.line}"


def pages(root=ROOT):
    return sorted((root / "docs").rglob("*.md"))


def with_meaning(block, before):
    """What the text before a block says about it."""
    written = [line for line in before if line.strip()]
    mark = MARK.match(before[-1]) if before else None
    if mark:
        block.mark, block.argument = mark.groups()
        written.pop()
    named = NAMED.search(written[-1]) if written else None
    if named and block.language not in ("sh", "text"):
        block.name = named.group(1)
    return block


def blocks(page, root=ROOT):
    lines = page.read_text(encoding="utf-8").split("\n")
    found, start, language, before = [], None, "", 0
    for i, line in enumerate(lines):
        fence = FENCE.match(line)
        if fence and start is None:
            start, language = i, fence.group(1)
        elif fence:
            block = Block(os.path.relpath(page, root), start + 1, language, "\n".join(lines[start + 1:i]) + "\n")
            found.append(with_meaning(block, lines[before:start]))
            start, before = None, i + 1
    if start is not None:
        raise ValueError(f"{page}:{start + 1}: the block does not end")
    return found
