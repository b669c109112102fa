# SPDX-License-Identifier: BSD-3-Clause
"""Mutants of the sources, and whether some test turns red for each of them.

A mutant is one changed line of one file. Mutants are built in a copy of the working tree (build/mutation), in double
precision and without optimisation; the suites of MUTANT.suites run one after another until one is red.
"""

import dataclasses
import os
import random
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
TREE = ROOT / "build" / "mutation" / "tree"
BUILD = ROOT / "build" / "mutation" / "build"
SUITES = {
    "lie/small_angle.hpp": ["series", "lie", "mechanics", "methods", "orders"],
    "lie": ["lie", "mechanics", "methods", "orders"],
    "mechanics": ["mechanics", "problems", "methods", "orders"],
    "methods": ["orders", "methods"],
}
TIMEOUT = 300  # s for one suite: a mutant that loops for ever is one that a test has seen


@dataclasses.dataclass(frozen=True)
class Mutant:
    file: str  # below the root
    line: int  # from 1
    kind: str
    before: str
    after: str

    @property
    def suites(self):
        return SUITES.get(self.file) or SUITES[self.file.split("/")[0]]

    def __str__(self):
        return f"{self.file}:{self.line}: {self.kind}: {self.before.strip()} -> {self.after.strip()}"


def tracked_files():
    """The sources: what git knows or would add; without git, all files but those of builds and results."""
    try:
        listing = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                                 check=True, capture_output=True)
    except (OSError, subprocess.CalledProcessError):
        names = (str(path.relative_to(ROOT)) for path in sorted(ROOT.rglob("*")) if path.is_file())
        return [name for name in names if name.split("/")[0] not in ("build", "results", ".git")]
    return [name for name in listing.stdout.decode().split("\0") if name and (ROOT / name).is_file()]


def copy_tree():
    """Brings the copy up to date; what has not changed keeps its time, so that it is not built again."""
    wanted = tracked_files()
    for name in wanted:
        source, target = ROOT / name, TREE / name
        if target.is_file() and target.read_bytes() == source.read_bytes():
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, target)
    for path in list(TREE.rglob("*")):
        if path.is_file() and str(path.relative_to(TREE)) not in set(wanted):
            path.unlink()


def configure():
    subprocess.run(["cmake", "-S", str(TREE), "-B", str(BUILD), "-G", "Ninja", "-D", "CMAKE_BUILD_TYPE=Release",
                    "-D", "CMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG", "-D", "KREISEL_BINARY128=OFF"],
                   check=True, stdout=subprocess.DEVNULL)


def build(suite, jobs):
    run = subprocess.run(["cmake", "--build", str(BUILD), "-j", str(jobs), "--target", f"test_{suite}_binary64"],
                         capture_output=True, text=True)
    return run.returncode == 0


def is_red(suite):
    try:
        run = subprocess.run([str(BUILD / f"test_{suite}_binary64"), "--abort"], stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL, timeout=TIMEOUT)
    except subprocess.TimeoutExpired:
        return True
    return run.returncode != 0


def must_be_green(suite, jobs, known=set()):
    """Ends the program unless the suite is green without any mutation; asked once per suite."""
    if suite in known:
        return
    if not build(suite, jobs):
        sys.exit(f"the suite {suite} does not build without any mutation")
    if is_red(suite):
        sys.exit(f"the suite {suite} is red without any mutation")
    known.add(suite)


def verdict(mutant, jobs):
    """The suite that turned red; "not compiled", or "survived"."""
    target = TREE / mutant.file
    original = target.read_text()
    lines = original.split("\n")
    assert lines[mutant.line - 1] == mutant.before, f"{mutant}: the line has changed"
    lines[mutant.line - 1] = mutant.after
    for suite in mutant.suites:
        must_be_green(suite, jobs)
        target.write_text("\n".join(lines))
        try:
            if not build(suite, jobs):
                return "not compiled"
            if is_red(suite):
                return suite
        finally:
            target.write_text(original)
    return "survived"


def judge(mutants, jobs, reasons=None):
    """Runs all mutants and prints one line each and the counts. Returns the share killed and the unexplained survivors."""
    reasons = reasons or {}
    copy_tree()
    configure()
    verdicts, begin = {}, time.monotonic()
    for count, mutant in enumerate(mutants, start=1):
        verdicts[mutant] = verdict(mutant, jobs)
        left = (time.monotonic() - begin) / count * (len(mutants) - count)
        print(f"[{count}/{len(mutants)}, {left / 60:.0f} min left] {verdicts[mutant]:>12}  {mutant}", flush=True)
    return report(verdicts, reasons)


def report(verdicts, reasons):
    viable = {mutant: found for mutant, found in verdicts.items() if found != "not compiled"}
    survivors = [mutant for mutant, found in viable.items() if found == "survived"]
    unexplained = [mutant for mutant in survivors if reason_of(mutant, reasons) is None]
    killed = len(viable) - len(survivors)
    print(f"\n{len(verdicts)} mutants, {len(verdicts) - len(viable)} of which do not compile")
    for suite in sorted(set(viable.values()) - {"survived"}):
        print(f"  killed by {suite}: {sum(found == suite for found in viable.values())}")
    print(f"killed: {killed} of {len(viable)}")
    for mutant in survivors:
        print(f"survived: {mutant}\n    {reason_of(mutant, reasons) or 'no reason is known'}")
    return killed / max(len(viable), 1), unexplained


def sample_of(mutants, count, seed):
    """`count` mutants, in the order of the sources: neighbours share what has to be built."""
    chosen = random.Random(seed).sample(range(len(mutants)), min(count, len(mutants)))
    return [mutants[i] for i in sorted(chosen)]


def key(mutant):
    return (mutant.file, " ".join(mutant.before.split()), " ".join(mutant.after.split()))


def reason_of(mutant, reasons):
    return reasons.get(key(mutant))


def read_reasons(file):
    """Blocks of four lines: file, line before, line after, reason; blocks are separated by an empty line, # comments."""
    reasons, block = {}, []
    for line in Path(file).read_text().split("\n") + [""]:
        if line.startswith("#"):
            continue
        if line.strip():
            block.append(" ".join(line.split()))
            continue
        if block:
            if len(block) != 4:
                sys.exit(f"{file}: expected file, before, after and reason, got {block}")
            reasons[tuple(block[:3])] = block[3]
        block = []
    return reasons


def default_jobs():
    return os.cpu_count() or 1
