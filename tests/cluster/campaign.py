# SPDX-License-Identifier: BSD-3-Clause
"""A campaign on the cluster, and what a test does to its tasks."""
import collections
import json
import os
import pathlib
import re
import signal
import subprocess

from cluster import processes, until

PARTS = 3
SECONDS = 75  # that anything may take
# 36 cells of some tenth of a second, with samples and a reference.
CONFIG = {
    "name": "on_a_cluster", "kind": "convergence", "problems": ["heavy_top"],
    "methods": ["rkmk/rk4", "rkmk/rk4_38", "rkmk/kutta3"], "metrics": ["error.position"],
    "time": {"end": 0.2, "steps": [100000 + 1000 * k for k in range(12)]}, "output": {"samples": 10},
}


def run(*words, **how):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, stdin=subprocess.DEVNULL, **how)


class Campaign:
    """Written by kreisel slurm into a folder, whose name a shell would take apart."""

    def __init__(self, cluster, program, config, name, *words):
        self.cluster = cluster
        self.folder = config.parent / f"{name} & $HOME's %j"
        written = run(program, "slurm", config, "-o", self.folder, "--shards", PARTS, *words)
        assert written.returncode == 0, written.stderr
        self.submitted = 0

    def submit(self, *options):
        done = run("bash", self.folder / "submit.sh", *options, env=self.cluster.environment, cwd="/")
        assert done.returncode == 0, done.stdout + done.stderr
        jobs = dict(re.findall(r"^(\w+): job (\d+)", done.stdout, flags=re.M))
        self.references, self.parts, self.merge = jobs["references"], jobs["parts"], jobs["merge"]
        return self

    def state(self, job):
        """Of a job, or of a task of the array."""
        found = re.search(r"JobState=(\w+)", self.cluster.say("scontrol", "show", "job", job, "--oneliner"))
        return found.group(1) if found else ""

    def task(self, part):
        return f"{self.parts}_{part}"

    def restarts(self, part):
        shown = self.cluster.say("scontrol", "show", "job", self.task(part), "--oneliner")
        return int(re.search(r"Restarts=(\d+)", shown).group(1))

    def wait(self):
        """The state in which the merge ends."""
        ends = ("COMPLETED", "FAILED", "CANCELLED", "TIMEOUT", "NODE_FAIL")
        return until(lambda: f"the merge is {self.state(self.merge)}\n{self.logs()}",
                     lambda: (state := self.state(self.merge)) in ends and state, SECONDS)

    def journal(self, part):
        """The cells that are done, as often as they are there."""
        file = self.folder / f"journal.{part}-of-{PARTS}.jsonl"
        lines = file.read_text().split("\n")[:-1] if file.exists() else []
        return [cell["cell"] for cell in map(json.loads, lines) if cell["status"] == "ok"]

    def programs(self, part):
        """The processes that compute a part, each with its parent: first kreisel, last its workers."""
        words = {str(self.folder), "--shard", f"{part}/{PARTS}"}
        ours = {process: parent for process, (parent, said) in processes().items()
                if said and said[0].endswith("kreisel") and words <= set(said)}
        return dict(sorted(ours.items(), key=lambda one: (one[1] in ours) + (one[0] not in ours.values())))

    def hold(self, part):
        """Stops the workers of a part when some cells are done, as if the next one took for ever: it has begun, and is
        not done. Returns kreisel's process and its parent."""
        until(lambda: f"part {part} has no cells\n{self.logs()}", lambda: self.journal(part), SECONDS)
        programs = self.programs(part)
        for worker in programs.keys() - programs.values():
            os.kill(worker, signal.SIGSTOP)
        done = len(self.journal(part))
        assert done < len(CONFIG["methods"]) * len(CONFIG["time"]["steps"]) / PARTS, f"part {part} is held too late"
        return next(iter(programs.items()))

    def log(self, name):
        file = self.folder / "slurm" / f"{name}.log"
        return file.read_text() if file.exists() else ""

    def logs(self):
        queue = self.cluster.say("squeue", "--states=all")
        return queue + "".join(f"\n--- {file.name}\n{file.read_text()}" for file in self.folder.glob("slurm/*.log"))


def differences(campaign, one_machine):
    """What is lost, doubled, or not the same byte by byte."""
    counts = collections.Counter(cell for part in range(1, PARTS + 1) for cell in campaign.journal(part))
    yield from (f"{cell} was done {count} times" for cell, count in counts.items() if count != 1)
    names = ["results.jsonl", "results.csv"]
    names += sorted(str(file.relative_to(one_machine)) for file in one_machine.glob("trajectories/*"))
    for name in names:
        file = campaign.folder / name
        if not file.exists() or file.read_bytes() != (pathlib.Path(one_machine) / name).read_bytes():
            yield f"{name} is missing or not the same"
    if len(counts) != len(names) - 2:
        yield f"{len(counts)} cells in the journals"
