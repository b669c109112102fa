#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Installs a build into an empty folder and uses it from there: run.py BUILD [PATTERN], the tests of test_PATTERN.py.

A test that needs a shell or a library that is missing is skipped by name, unless KREISEL_REQUIRE has `docs` (shells and
mandoc) or `python`.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent


def main(build, pattern="*"):
    sys.path.insert(0, str(HERE))
    with tempfile.TemporaryDirectory() as scratch:
        prefix, home = pathlib.Path(scratch) / "prefix", pathlib.Path(scratch) / "home"
        home.mkdir()
        subprocess.run(["cmake", "--install", build, "--prefix", prefix], check=True, stdout=subprocess.DEVNULL)
        for name in list(os.environ):
            if name.startswith(("KREISEL_", "XDG_")) and name != "KREISEL_REQUIRE":
                del os.environ[name]
        os.environ.update(HOME=str(home), PREFIX=str(prefix), BUILD=os.path.abspath(build))
        os.environ.update(PATH=f"{prefix}/bin:/usr/bin:/bin")
        tests = unittest.defaultTestLoader.discover(str(HERE), f"test_{pattern}.py", str(HERE))
        result = unittest.TextTestRunner(verbosity=2).run(tests)
    sys.exit(0 if result.wasSuccessful() and result.testsRun > 0 else 1)


if __name__ == "__main__":
    main(*sys.argv[1:])
