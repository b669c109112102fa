# SPDX-License-Identifier: BSD-3-Clause
"""Runs of 100 million steps."""
import json
import math
import os
import sys

from attack import attack, emptied

SHORT, LONG = 1_000_000, 100_000_000
STEP = 1e-6  # s, of which all are alike
MOTIONS = [("free_top", "SO3"), ("heavy_top", "SO3"), ("heavy_top", "SO3xR3")]
ROOM = 1.1  # times the memory of the short run, which no two runs take to the byte


def run(kreisel, problem, formulation, steps):
    """The largest defect of orthogonality and the peak memory, kB."""
    folder = emptied(kreisel.folder / f"{problem}_{formulation}_{steps}")
    config = kreisel.write(folder.name, {
        "name": "long", "kind": "drift", "problems": [problem], "formulations": [formulation],
        "methods": ["rkmk/rk4"], "metrics": ["defect.orthogonality"], "time": {"end": steps * STEP, "steps": steps}})
    process = kreisel.start("run", config, "-o", folder, "-j", "1")
    said = process.stderr.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise RuntimeError(f"{config}: exit code {process.returncode}: {said}")
    line = json.loads((folder / "results.jsonl").read_text())
    return line["metrics"]["defect.orthogonality"], used.ru_maxrss


@attack("R29")
def last(kreisel, cases, random, measured):
    """A hundred times the steps take no more memory, and rotations leave SO(3) as round-off at random does."""
    grown = []

    def lasting(motion):
        before, memory = run(kreisel, *motion, SHORT)
        after, most = run(kreisel, *motion, LONG)
        grown.append(f"{' '.join(motion)} {before:.1e} to {after:.1e}")
        if most > ROOM * memory:
            yield f"{most} kB after {memory} kB"
        for steps, defect in ((SHORT, before), (LONG, after)):
            bound = 2 * sys.float_info.epsilon * math.sqrt(steps)
            if not defect <= bound:
                yield f"a defect of {defect:.1e} after {steps:,} steps, above {bound:.1e}"

    measured.each(kreisel, lasting, MOTIONS)
    measured.require(cases)
    measured.remark = f"the defect of orthogonality from {SHORT:,} to {LONG:,} steps: " + ", ".join(sorted(grown))
