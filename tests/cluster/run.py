#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`kreisel slurm` on a real Slurm, which is started and stopped here: run.py PROGRAM [TEST...].

Where Slurm or munge is missing the test says so and is skipped, unless KREISEL_REQUIRE has `cluster`. With
KREISEL_CLUSTER_LOGS=1 the logs of the daemons follow.
"""
import os
import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
SKIPPED = 77


def require_slurm():
    from cluster import DAEMONS, find
    missing = [daemon for daemon in (*DAEMONS, "sbatch") if find(daemon) is None]
    if missing:
        print("cluster: skipped: there is no " + ", ".join(missing) + "; tools/setup cluster installs it")
        sys.exit(1 if "cluster" in os.environ.get("KREISEL_REQUIRE", "").split() else SKIPPED)


def main(program, *names):
    sys.path.insert(0, str(HERE))
    require_slurm()
    os.environ["KREISEL"] = os.path.abspath(program)
    loader = unittest.defaultTestLoader
    loader.testNamePatterns = [f"*{name}*" for name in names] or None
    result = unittest.TextTestRunner(verbosity=2).run(loader.discover(str(HERE), "test_*.py", str(HERE)))
    sys.exit(0 if result.wasSuccessful() and result.testsRun > 0 else 1)


if __name__ == "__main__":
    main(*sys.argv[1:])
