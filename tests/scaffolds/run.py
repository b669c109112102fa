#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What `kreisel new` writes compiles with the project's flags in both precisions, is laid out as the project is, and
runs: run.py PROGRAM BUILD.

A method or problem is compiled as the objects beside it are (BUILD/compile_commands.json), without writing one. A file
with a mistake must not compile.
"""
import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, BUILD = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
TARGETS = {"method": "kreisel_methods", "problem": "kreisel_problems"}
ENTRIES = [("method", "commutator_free/scaffolded"), ("method", "crouch_grossman/scaffolded"),
           ("method", "rkmk/scaffolded"), ("problem", "scaffolded")]


def new(kind, name, folder):
    """The file that is written."""
    done = subprocess.run([PROGRAM, "new", kind, name, "-o", folder], capture_output=True, text=True, check=True)
    return pathlib.Path(done.stdout.strip())


def compile_command(target, file):
    """The command of a target's objects, that checks another file."""
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        if f"/{target}.dir/" in entry.get("output", "") or any(f"/{target}.dir/" in word for word in words):
            # Neither an object nor the list of its headers is written.
            kept = [word for word, option in zip(words[:words.index("-o")], [""] + words)
                    if word not in ("-MD", "-MT", "-MF") and option not in ("-MT", "-MF")]
            return entry["directory"], kept + ["-fsyntax-only", "-c", str(file)]
    raise LookupError(f"{target}: no object of it in compile_commands.json")


def compiles(kind, precision, file):
    folder, command = compile_command(f"{TARGETS[kind]}_{precision}", file)
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


class Scaffolds(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_methods_and_problems_compile(self):
        for kind, name in ENTRIES:
            file = new(kind, name, self.folder / name.split("/")[0])
            for precision in ("binary64", "binary128"):
                with self.subTest(kind=kind, name=name, precision=precision):
                    done = compiles(kind, precision, file)
                    self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_mistake_does_not_compile(self):
        file = new("method", "rkmk/mistaken", self.folder)
        file.write_text(file.read_text().replace(".order = 3", ".ordre = 3"))
        done = compiles("method", "binary64", file)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("mistaken.cpp", done.stderr)

    @unittest.skipUnless(shutil.which("clang-format-14"), "no clang-format-14")
    def test_the_layout_is_that_of_the_project(self):
        style = (pathlib.Path(__file__).parents[2] / ".clang-format").read_text()
        (self.folder / ".clang-format").write_text(style)
        for kind, name in ENTRIES + [("method", "crouch_grossman/a_name_of_20_letters"), ("method", "rkmk/a")]:
            file = new(kind, name, self.folder / "layout" / name)
            with self.subTest(name=name):
                done = subprocess.run(["clang-format-14", file], capture_output=True, text=True, check=True)
                self.assertEqual(done.stdout, file.read_text())

    def test_an_experiment_runs_to_its_tables(self):
        config = new("experiment", "scaffolded", self.folder)
        results = self.folder / "results"
        run = subprocess.run([PROGRAM, "run", config, "-o", results], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        table = subprocess.run([PROGRAM, "table", results], capture_output=True, text=True)
        self.assertEqual(table.returncode, 0, table.stderr)
        self.assertIn("rkmk/rk4", table.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
