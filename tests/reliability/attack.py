# SPDX-License-Identifier: BSD-3-Clause
"""Attacks by the number of the promise that they test, and what they measure."""
import concurrent.futures
import dataclasses
import shutil
import subprocess

ATTACKS = {}


def attack(promise):
    """Registers a function (kreisel, cases, random, measured) that tries so many cases, or more."""
    def register(function):
        ATTACKS[promise] = function
        return function
    return register


@dataclasses.dataclass
class Measured:
    """What an attack has seen: how many cases, what broke the promise, and a remark."""
    cases: int = 0
    faults: list = dataclasses.field(default_factory=list)
    remark: str = ""

    def case(self, name, *faults):
        """One case, with what is wrong; nothing if the promise was held."""
        self.cases += 1
        self.faults += [f"{name}: {fault}" for fault in faults]

    def require(self, cases):
        """A fault where fewer have been tried."""
        if self.cases < cases:
            self.faults.append(f"there are only {self.cases} cases of {cases}")

    def each(self, kreisel, function, items):
        """Calls a function, which gives the faults of an item, for all of them, some at the same time."""
        with concurrent.futures.ThreadPoolExecutor(kreisel.jobs) as pool:
            for item, faults in pool.map(lambda item: (item, _faults(function, item)), items):
                self.case(item, *faults)


def _faults(function, item):
    try:
        return list(function(item) or ())
    except subprocess.TimeoutExpired as hung:
        return [f"hangs: {hung.cmd}"]


def emptied(folder):
    """The folder, without what an earlier case has left in it."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder
