# SPDX-License-Identifier: BSD-3-Clause
"""What a mutant is, and which sources there are to change."""

import dataclasses
import hashlib
import random
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SUITES = {
    "lie/small_angle.hpp": ["series", "lie", "mechanics", "methods", "orders"],
    "lie": ["lie", "mechanics", "methods", "orders"],
    "mechanics": ["mechanics", "problems", "methods", "orders"],
    "methods": ["orders", "methods"],
}


@dataclasses.dataclass(frozen=True)
class Mutant:
    """One changed line of one file."""

    file: str  # below the root
    line: int  # from 1
    kind: str
    before: str
    after: str

    @property
    def suites(self):
        return SUITES.get(self.file) or SUITES[self.file.split("/")[0]]

    @property
    def key(self):
        """Without the line, so that a reason or a verdict outlives an edit elsewhere in the file."""
        return (self.file, " ".join(self.before.split()), " ".join(self.after.split()))

    def changed(self, text):
        lines = text.split("\n")
        if lines[self.line - 1] != self.before:
            raise ValueError(f"{self}: the line has changed")
        lines[self.line - 1] = self.after
        return "\n".join(lines)

    def __str__(self):
        return f"{self.file}:{self.line}: {self.kind}: {self.before.strip()} -> {self.after.strip()}"


def tracked_files():
    """The sources: files that git tracks or would add; without git, all files but those of builds and results."""
    try:
        listing = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                                 check=True, capture_output=True)
    except (OSError, subprocess.CalledProcessError):
        names = (str(path.relative_to(ROOT)) for path in sorted(ROOT.rglob("*")) if path.is_file())
        return [name for name in names if name.split("/")[0] not in ("build", "results", ".git")]
    return [name for name in listing.stdout.decode().split("\0") if name and (ROOT / name).is_file()]


def digest(file):
    return hashlib.sha256((ROOT / file).read_bytes()).hexdigest()[:16]


def sample_of(mutants, count, seed):
    """`count` mutants, in the order of the sources."""
    chosen = random.Random(seed).sample(range(len(mutants)), min(count, len(mutants)))
    return [mutants[i] for i in sorted(chosen)]
