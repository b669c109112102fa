# SPDX-License-Identifier: BSD-3-Clause
"""Verdicts, kept from run to run, and the report made from them."""

import collections
import dataclasses
import json
import subprocess
import sys
from pathlib import Path

from .build import HOME
from .mutants import ROOT, digest

REASONS = Path(__file__).resolve().parent / "survivors.txt"


def read_reasons(file=REASONS):
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


@dataclasses.dataclass
class Counts:
    """Of some verdicts, which stand by mutant."""

    verdicts: dict
    reasons: dict

    def of(self, wanted):
        return sum(wanted(mutant, found) for mutant, found in self.verdicts.items())

    @property
    def not_compiled(self):
        return self.of(lambda mutant, found: found == "not compiled")

    @property
    def viable(self):
        return len(self.verdicts) - self.not_compiled

    @property
    def survivors(self):
        return [mutant for mutant, found in self.verdicts.items() if found == "survived"]

    @property
    def unexplained(self):
        return [mutant for mutant in self.survivors if mutant.key not in self.reasons]

    @property
    def killed(self):
        return self.viable - len(self.survivors)

    @property
    def share(self):
        return self.killed / max(self.viable, 1)

    def grouped(self, group):
        groups = collections.defaultdict(dict)
        for mutant, found in self.verdicts.items():
            groups[group(mutant)][mutant] = found
        return [(name, Counts(groups[name], self.reasons)) for name in sorted(groups)]

    def row(self, name):
        explained = len(self.survivors) - len(self.unexplained)
        return (f"| {name} | {len(self.verdicts)} | {self.not_compiled} | {self.viable} | {self.killed} | {explained} "
                f"| {len(self.unexplained)} |")

    def table(self, title, group):
        return ["", f"| {title} | mutants | not compiled | viable | killed | survived with a reason | survived without |",
                "|---|--:|--:|--:|--:|--:|--:|", *(counts.row(name) for name, counts in self.grouped(group)),
                self.row("all")]

    def summary(self):
        yield f"{len(self.verdicts)} mutants, {self.not_compiled} of which do not compile"
        for suite in sorted({found for found in self.verdicts.values()} - {"survived", "not compiled"}):
            yield f"  killed by {suite}: {self.of(lambda mutant, found: found == suite)}"
        yield f"killed: {self.killed} of {self.viable} ({100 * self.share:.1f} %)"
        for mutant in self.survivors:
            yield f"survived: {mutant}\n    {self.reasons.get(mutant.key, 'no reason is known')}"


class Journal:
    """Verdicts of one tool in build/mutation/<name>.json. One is valid while the mutated file is unchanged."""

    def __init__(self, name):
        self.name, self.path = name, HOME / f"{name}.json"
        self.entries = json.loads(self.path.read_text()) if self.path.is_file() else {}

    @staticmethod
    def id_of(mutant):
        return "\n".join((str(mutant.line), *mutant.key, digest(mutant.file)))

    def verdict(self, mutant):
        return self.entries.get(self.id_of(mutant), {}).get("verdict")

    def add(self, mutant, verdict):
        self.entries[self.id_of(mutant)] = {"verdict": verdict, "sources": sources()}
        self.path.parent.mkdir(parents=True, exist_ok=True)
        self.path.write_text(json.dumps(self.entries, indent=1))

    def write_report(self, title, mutants, reasons):
        """build/mutation/report-<name>.md, from all valid verdicts on `mutants`."""
        held = {mutant: self.entries[self.id_of(mutant)] for mutant in mutants if self.verdict(mutant)}
        counts = Counts({mutant: entry["verdict"] for mutant, entry in held.items()}, reasons)
        run_at = collections.Counter(entry["sources"] for entry in held.values())
        lines = [f"# {title}", "", f"Verdicts on {len(held)} of {len(mutants)} mutants, by the sources they were run with: "
                 + ", ".join(f"{count} at {sources}" for sources, count in sorted(run_at.items())) + ".", "", "```",
                 *(line for line in counts.summary() if not line.startswith("survived")), "```"]
        lines += counts.table("file", lambda mutant: mutant.file) + counts.table("kind", lambda mutant: mutant.kind)
        lines += ["", "## Survivors", ""]
        for mutant in counts.survivors:
            lines.append(f"- `{mutant.file}:{mutant.line}` ({mutant.kind}): `{mutant.before.strip()}` became "
                         f"`{mutant.after.strip()}`. {reasons.get(mutant.key, '**No reason is known.**')}")
        report = HOME / f"report-{self.name}.md"
        report.write_text("\n".join(lines + ([] if counts.survivors else ["None."])) + "\n")
        return report


def sources():
    """The commit, and whether the working tree differs from it."""
    run = subprocess.run(["git", "describe", "--always", "--dirty", "--exclude=*"], cwd=ROOT, capture_output=True, text=True)
    return run.stdout.strip() or "unknown sources"
