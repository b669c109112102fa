# SPDX-License-Identifier: BSD-3-Clause
"""The table of promises in README.md, which is read here and whose last column is written here."""
import dataclasses
import pathlib
import re

TABLE = pathlib.Path(__file__).resolve().parent / "README.md"
COLUMNS = 6


@dataclasses.dataclass
class Promise:
    """A row of the table."""
    name: str      # R1
    text: str
    cases: int     # that are tried in full; 0: they are not counted
    share: int     # of them in ./check; 0: none, or in suites of their own
    commands: list
    measured: str

    @property
    def command(self):
        """The one that shows it; none where there is none yet."""
        return self.commands[0] if self.commands else None


def number(text):
    found = re.search(r"\d[\d,]*", text)
    return int(found.group().replace(",", "")) if found else 0


def cells(line):
    """Of a row, whose texts hold no bars."""
    return [cell.strip() for cell in line.strip()[1:-1].split("|")]


def promises(text=None):
    """The rows of the table, in their order."""
    rows = [cells(line) for line in (TABLE.read_text() if text is None else text).splitlines()
            if line.startswith("| R")]
    for row in rows:
        if len(row) != COLUMNS:
            raise ValueError(f"{row[0]}: expected {COLUMNS} columns, got {len(row)}")
    return [Promise(name, text, number(cases), number(share), re.findall(r"`([^`]+)`", commands), measured)
            for name, text, cases, share, commands, measured in rows]


def with_measured(text, name, measured):
    """The text with another last column in the row of a promise."""
    def changed(line):
        return f"| {' | '.join([*cells(line)[:COLUMNS - 1], measured])} |"
    return "\n".join(changed(line) if line.startswith(f"| {name} |") else line for line in text.split("\n"))
