# SPDX-License-Identifier: BSD-3-Clause
"""Runs mutants and reports the first suite to fail for each of them."""

import os
import sys
import time

from .build import Build, Overlay, run_suite
from .mutants import sample_of
from .report import Counts, Journal, read_reasons


def verdict_of_line(build, mutant):
    """The suite that turned red; "not compiled", or "survived"."""
    overlay = Overlay(build, mutant.file, mutant.changed((build.source / mutant.file).read_text()))
    for suite in mutant.suites:
        if not build.seeing(suite, mutant.file):
            continue
        for program in overlay.programs(suite):
            if program is None:
                return "not compiled"
            if run_suite(program)[0]:
                return suite
    return "survived"


def add_arguments(parser):
    parser.add_argument("--list", action="store_true", help="print the mutants and stop")
    parser.add_argument("--report", action="store_true", help="run nothing: the counts and the report of what has been run")
    parser.add_argument("--sample", type=int, metavar="N", help="N mutants chosen at random (default: all)")
    parser.add_argument("--seed", type=int, default=1, help="seed of that choice (default: 1)")
    parser.add_argument("--again", action="store_true", help="run those too that have been killed before, their file unchanged")
    parser.add_argument("--build", metavar="DIR", help="a complete build of the working tree with the tests (default: one "
                        "of a copy, in build/mutation)")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count() or 1, help="jobs of the compiler")


def judge(name, title, everything, mutants, arguments, verdict=verdict_of_line):
    """Runs `mutants`, prints a line for each and the counts, and writes the report. Returns the counts."""
    if arguments.sample:
        mutants = sample_of(mutants, arguments.sample, arguments.seed)
    if arguments.list:
        print("\n".join(map(str, mutants)), f"{len(mutants)} mutants", sep="\n")
        sys.exit(0)
    if not mutants:
        sys.exit("there is nothing to mutate in these files")
    journal, reasons = Journal(name), read_reasons()
    if arguments.report:
        mutants = [mutant for mutant in mutants if journal.verdict(mutant)]
    left = [mutant for mutant in mutants if arguments.again or journal.verdict(mutant) in (None, "survived")]
    left.sort(key=lambda mutant: mutant.file.endswith(".hpp"))  # what takes longest comes last
    print(f"{len(mutants)} mutants, {len(mutants) - len(left)} of which have a verdict already")
    if not arguments.report:
        run(left, Build(arguments.build, arguments.jobs), journal, verdict)
    counts = Counts({mutant: journal.verdict(mutant) for mutant in mutants}, reasons)
    print("", *counts.summary(), f"report: {journal.write_report(title, everything, reasons)}", sep="\n")
    return counts


def run(mutants, build, journal, verdict):
    begin = time.monotonic()
    for count, mutant in enumerate(mutants, start=1):
        found = verdict(build, mutant)
        journal.add(mutant, found)
        left = (time.monotonic() - begin) / count * (len(mutants) - count)
        print(f"[{count}/{len(mutants)}, {left / 60:.0f} min left] {found:>12}  {mutant}", flush=True)
