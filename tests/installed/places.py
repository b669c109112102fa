# SPDX-License-Identifier: BSD-3-Clause
"""Where things were installed, and what calls them."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

PREFIX = pathlib.Path(os.environ["PREFIX"])
PROGRAM = PREFIX / "bin/kreisel"
SHARE = PREFIX / "share/kreisel"


def say(*command, **how):
    """What a command prints; it must succeed."""
    done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, **how)
    if done.returncode != 0:
        raise AssertionError(f"{command} fails with exit code {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def names(topic):
    return re.findall(r"^  (\S+)", say(PROGRAM, "list", topic), flags=re.M)


def commands():
    return re.findall(r"^  (\w+) ", say(PROGRAM, "--help").split("Subcommands:")[1], flags=re.M)


def needs(tool, purpose):
    """Skips a test by name where a tool is missing."""
    if shutil.which(tool) is None and purpose not in os.environ.get("KREISEL_REQUIRE", "").split():
        raise unittest.SkipTest(f"there is no {tool}; tools/setup {purpose} installs it")


class Scratch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.scratch = pathlib.Path(scratch.name)

    def kreisel(self, *arguments):
        return say(PROGRAM, *arguments, cwd=self.scratch)
