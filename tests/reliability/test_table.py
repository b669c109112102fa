#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The table of promises names nothing that there is not: test_table.py BUILD."""
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE))
from attack import ATTACKS  # noqa: E402
from attacks import LOADED  # noqa: E402
from promises import promises, with_measured  # noqa: E402

BUILD = sys.argv[1]


def labels():
    said = subprocess.run(["ctest", "--test-dir", BUILD, "-C", "full", "--print-labels"], capture_output=True,
                          text=True, check=True).stdout
    return set(re.findall(r"^  (\S+)$", said, re.M))


def presets():
    return {preset["name"] for preset in json.loads((ROOT / "CMakePresets.json").read_text())["workflowPresets"]}


def unknown(command, known_labels, known_presets):
    """What a command names that there is not; empty if all is there."""
    words = command.split()
    program = ROOT / words[0]
    if words[0] == "cmake":
        return "" if words[:3] == ["cmake", "--workflow", "--preset"] and words[3] in known_presets else command
    if not program.is_file() or not os.access(program, os.X_OK):
        return words[0]
    if words[0] == "./check" and (words[1:2] != ["-L"] or words[2] not in known_labels):
        return command
    return words[1] if words[0] == "tools/reliability" and words[1] not in ATTACKS else ""


class Table(unittest.TestCase):
    def setUp(self):
        self.rows = promises()

    def test_there_are_thirty_promises_in_their_order(self):
        self.assertEqual([row.name for row in self.rows], [f"R{number}" for number in range(1, 31)])

    def test_what_shows_a_promise_is_there(self):
        known = labels(), presets()
        self.assertIn("reliability", known[0])
        for row in self.rows:
            self.assertTrue(row.commands or row.measured == "not measured", row.name)
            for command in row.commands:
                self.assertEqual(unknown(command, *known), "", row.name)

    def test_what_is_not_there_is_seen(self):
        for command in ("./check -L no_suite", "./check", "tools/no_tool", "cmake --workflow --preset no_preset",
                        "tools/reliability R99", "README.md"):
            self.assertNotEqual(unknown(command, labels(), presets()), "", command)

    def test_attacks_are_those_of_the_table(self):
        self.assertTrue(LOADED)
        mine = {row.name for row in self.rows if row.command == f"tools/reliability {row.name}"}
        self.assertEqual(mine, set(ATTACKS))

    def test_counts_fit(self):
        for row in self.rows:
            self.assertLessEqual(row.share, row.cases, row.name)
            self.assertTrue(row.share == 0 or row.name in ATTACKS, row.name)

    def test_every_promise_has_been_measured(self):
        for row in self.rows:
            self.assertTrue(row.measured, row.name)

    def test_a_column_is_replaced(self):
        text = "| R1 | a | 2 | 1 | `x` | old |\n| R11 | a | 2 | 1 | `x` | old |"
        self.assertEqual(with_measured(text, "R1", "new"), text.replace("old", "new", 1))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
