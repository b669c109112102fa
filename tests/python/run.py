#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tests of the Python package: run.py PROGRAM [PATTERN], those in files test_PATTERN.py, by default all.

Where a library is missing the test says so and is skipped, unless KREISEL_REQUIRE has `python`.
"""
import importlib.util
import os
import pathlib
import sys
import tempfile
import unittest

SKIPPED = 77
HERE = pathlib.Path(__file__).resolve().parent
LIBRARIES = ("pandas", "matplotlib", "mpmath", "nbclient", "nbformat", "ipykernel")


def require_libraries():
    missing = [name for name in LIBRARIES if importlib.util.find_spec(name) is None]
    if missing:
        print("python: skipped: there is no " + ", ".join(missing) + "; tools/setup python installs it")
        sys.exit(1 if "python" in os.environ.get("KREISEL_REQUIRE", "").split() else SKIPPED)


def main(program, pattern="*"):
    require_libraries()
    package = str(HERE.parents[1] / "python")
    sys.path[:0] = [package, str(HERE)]
    sys.dont_write_bytecode = True
    with tempfile.TemporaryDirectory() as home:  # of matplotlib and of the notebook's kernel
        os.environ.update(KREISEL=os.path.abspath(program), KREISEL_CACHE="", MPLBACKEND="Agg", MPLCONFIGDIR=home,
                          IPYTHONDIR=home, JUPYTER_RUNTIME_DIR=home, PYTHONPATH=package, PYTHONDONTWRITEBYTECODE="1",
                          PYDEVD_DISABLE_FILE_VALIDATION="1")
        tests = unittest.defaultTestLoader.discover(str(HERE), f"test_{pattern}.py", str(HERE))
        result = unittest.TextTestRunner(verbosity=2).run(tests)
    sys.exit(0 if result.wasSuccessful() and result.testsRun > 0 else 1)


if __name__ == "__main__":
    main(*sys.argv[1:])
