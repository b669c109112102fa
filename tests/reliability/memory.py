# SPDX-License-Identifier: BSD-3-Clause
"""Commands under valgrind's memcheck, with all processes that they start."""
import shutil
import subprocess

from attack import attack, emptied
from kreisel import SMALL

BROKEN = 99
SECONDS = 600
# Cells in both precisions with samples and a reference, and some that are skipped.
CHECKED = {**SMALL, "name": "checked", "methods": ["rkmk/rk4", "generalized_alpha/index2", "baseline/rk4_quaternion"],
           "precision": ["double", "quad"], "formulations": ["SO3xR3", "SE3"],
           "time": {"end": 0.001, "steps": [1, 2, 4, 8]}, "output": {"samples": 1}}


@attack("R20")
def memcheck(kreisel, cases, random, measured):
    """No invalid access, no use of what is not set, nothing definitely lost."""
    valgrind = shutil.which("valgrind")
    if valgrind is None:
        measured.case("valgrind", "is not installed (tools/setup maintain)")
        return
    results = emptied(kreisel.folder / "memcheck") / "results"
    config = kreisel.write("checked", CHECKED)
    wrong = kreisel.write("wrong", {"name": "..", "kind": "drfit", "methods": [7], "time": {"end": -1}})
    commands = [("run", config, "-o", results, "-j", "2"), ("run", config, "-o", results, "--resume"),
                ("table", results), ("verify", results, "--cells", "4"), ("diff", results, results),
                ("report", results), ("merge", results), ("plan", config), ("check", wrong), ("list",),
                ("info", "heavy_top"), ("schema",)]
    for words in commands:
        ended = subprocess.run(
            [valgrind, "--quiet", "--trace-children=yes", "--leak-check=full", "--show-leak-kinds=definite",
             "--errors-for-leak-kinds=definite", f"--error-exitcode={BROKEN}", kreisel.program, *map(str, words)],
            capture_output=True, text=True, env=kreisel.environment, timeout=SECONDS)
        found = ended.returncode not in (0, 2) or "==" in ended.stderr
        measured.case(words[0], *([f"exit code {ended.returncode}: {ended.stderr[-2000:]}"] if found else []))
    measured.require(cases)
