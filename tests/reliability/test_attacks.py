#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A program that breaks its promises is found out by the attacks: test_attacks.py PROGRAM [PROMISE...].

It runs kreisel, and then changes the results, says nothing and always succeeds."""
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import attacks  # noqa: E402, F401
from attack import ATTACKS, Measured  # noqa: E402
from kreisel import Kreisel  # noqa: E402

PROGRAM, NAMES = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
UNTRUE = """#!/bin/sh
"{program}" "$@" 2>/dev/null
for word; do
    [ -f "$word/results.csv" ] && date +%N >> "$word/results.csv"
done
exit 0
"""
# These need valgrind, clang or minutes.
TOO_LONG = {"R10", "R20", "R21", "R29"}


class Untrue(unittest.TestCase):
    def test_every_attack_finds_it_out(self):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        script = folder / "untrue"
        script.write_text(UNTRUE.format(program=PROGRAM))
        script.chmod(0o755)
        for name in NAMES or sorted(ATTACKS.keys() - TOO_LONG):
            with self.subTest(promise=name):
                measured, inside = Measured(), folder / name
                inside.mkdir()
                try:
                    ATTACKS[name](Kreisel(script, inside, os.cpu_count()), 2, random.Random(1), measured)
                except subprocess.CalledProcessError as other:  # a script has no libraries
                    self.assertEqual(other.cmd[0], "ldd")
                self.assertTrue(measured.faults)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
