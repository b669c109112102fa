# SPDX-License-Identifier: BSD-3-Clause
"""Disks that are full or broken at one of the calls of a run that write, one after the other."""
import errno
import itertools
import os
import pathlib
import subprocess

from attack import attack, emptied
from kreisel import SMALL, differences

SOURCE = pathlib.Path(__file__).parent / "faults.cpp"
# 50 cells, half of them in quad, with samples and a reference.
FIFTY = {**SMALL, "name": "fifty", "methods": ["rkmk/rk4", "rkmk/kutta3", "rkmk/heun", "rkmk/midpoint", "rkmk/euler"],
         "precision": ["double", "quad"], "time": {"end": 0.001, "steps": [2, 4, 6, 8, 10]}, "output": {"samples": 2}}
KINDS = [(errno.ENOSPC, True), (errno.EIO, False)]  # a full disk stays full


def library(kreisel):
    file = kreisel.folder / "faults.so"
    subprocess.run([os.environ.get("CXX", "c++"), "-std=c++20", "-O1", "-shared", "-fPIC", SOURCE, "-o", file, "-ldl"],
                   check=True)
    return file


class FaultyDisk:
    """Of which the calls that write into a folder are counted, and fail from or at one of them."""

    def __init__(self, preloaded, folder, at, error=0, lasts=False):
        self.counter = folder.with_suffix(".count")
        self.counter.write_bytes(bytes(8))
        self.environment = {"LD_PRELOAD": str(preloaded), "KREISEL_FAULT_FOLDER": str(folder),
                            "KREISEL_FAULT_AT": str(at), "KREISEL_FAULT_ERROR": str(error),
                            "KREISEL_FAULT_LASTS": str(int(lasts)), "KREISEL_FAULT_COUNTER": str(self.counter)}

    def calls(self):
        return int.from_bytes(self.counter.read_bytes(), "little")


@attack("R6")
def fault(kreisel, cases, random, measured):
    """The first of the cases are those at which all calls are tried; fewer cases are a choice of them."""
    config, preloaded = kreisel.write("fifty", FIFTY), library(kreisel)
    whole = emptied(kreisel.folder / "whole")
    sound = FaultyDisk(preloaded, whole, 0)
    kreisel.done(config, whole, "-j", 1, environment=sound.environment)
    calls = sound.calls()

    def broken(case):
        at, (error, lasts) = case
        folder = emptied(kreisel.folder / f"{at}-{error}")
        disk = FaultyDisk(preloaded, folder, at, error, lasts)
        ended = kreisel("run", config, "-o", folder, "-j", 1, environment=disk.environment)
        if disk.calls() < at:
            yield f"only {disk.calls()} calls"
        if ended.returncode != 3:
            yield f"exit code {ended.returncode}: {ended.stderr}"
        if os.strerror(error) not in ended.stderr:
            yield f"no reason in: {ended.stderr}"
        again = kreisel("run", config, "-o", folder, "--resume", "-j", 1)
        if again.returncode != 0:
            yield f"resume: exit code {again.returncode}: {again.stderr}"
        yield from differences(folder, whole)

    every = list(itertools.product(range(1, calls + 1), KINDS))
    measured.each(kreisel, broken, every if cases >= len(every) else sorted(random.sample(every, cases)))
    measured.remark = f"a run of 50 cells writes by {calls} calls"
