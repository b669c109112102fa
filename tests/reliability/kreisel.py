# SPDX-License-Identifier: BSD-3-Clause
"""The program that is attacked, the experiments it is given, and what it leaves."""
import json
import os
import pathlib
import subprocess

SECONDS = 60  # that any command may take; one that takes longer hangs

# 12 cells of some hundredths of a second, with samples and a reference.
SMALL = {
    "name": "small", "kind": "convergence", "problems": ["heavy_top"],
    "methods": ["rkmk/rk4", "rkmk/kutta3", "crouch_grossman/cg3a"],
    "time": {"end": 0.1, "steps": [2000, 4000, 8000, 16000]}, "output": {"samples": 4},
}
# One cell that ends at once, without a reference.
TINY = {
    "name": "tiny", "kind": "drift", "problems": ["free_top"], "formulations": ["SO3"], "methods": ["rkmk/rk4"],
    "time": {"end": 0.1, "steps": 10}, "metrics": [],
}


class Kreisel:
    """Runs the program without a cache of references, in an environment that a test may change."""

    def __init__(self, program, folder, jobs):
        self.program, self.folder, self.jobs = pathlib.Path(program).resolve(), pathlib.Path(folder), jobs
        self.environment = {**os.environ, "KREISEL_CACHE": "", "LC_ALL": "C", "TERM": "dumb"}

    def _how(self, environment, how):
        return {"stdin": subprocess.DEVNULL, "env": {**self.environment, **(environment or {})}, **how}

    def __call__(self, *words, environment=None, **how):
        """Runs a command to its end. Raises TimeoutExpired where it hangs."""
        return subprocess.run([self.program, *map(str, words)], capture_output=True, text=True, errors="replace",
                              timeout=SECONDS, **self._how(environment, how))

    def start(self, *words, environment=None, **how):
        return subprocess.Popen([self.program, *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                text=True, **self._how(environment, how))

    def write(self, name, config):
        """The file of an experiment."""
        file = self.folder / f"{name}.json"
        file.write_text(json.dumps(config))
        return file

    def done(self, config, folder, *words, **how):
        """Runs an experiment that must succeed."""
        ended = self("run", config, "-o", folder, *words, **how)
        if ended.returncode != 0:
            raise RuntimeError(f"{config}: exit code {ended.returncode}: {ended.stderr}")
        return ended


def outputs(folder):
    """What a run promises to write the same bytes of, by name."""
    folder = pathlib.Path(folder)
    files = [folder / "results.jsonl", folder / "results.csv", *sorted(folder.glob("trajectories/*"))]
    return {str(file.relative_to(folder)): file.read_bytes() for file in files if file.exists()}


def differences(folder, whole):
    """What is lost, doubled, torn or not the same in a folder, beside one of an undisturbed run."""
    found, expected = outputs(folder), outputs(whole)
    for name in sorted(found.keys() | expected.keys()):
        if found.get(name) != expected.get(name):
            yield f"{name} is not that of an undisturbed run"
    yield from journal_faults(folder, [json.loads(line)["cell"] for line in expected["results.jsonl"].splitlines()])


def journal_faults(folder, cells):
    """Cells that journals do not have just once, and lines that are none."""
    text = "".join(file.read_text() for file in sorted(pathlib.Path(folder).glob("journal*.jsonl")))
    if text and not text.endswith("\n"):
        yield "the last line of the journal is torn"
    lines = [json.loads(line) for line in text.splitlines()]
    done = [line["cell"] for line in lines if line["status"] != "interrupted"]
    yield from (f"cell {cell} is {done.count(cell)} times in the journal" for cell in cells if done.count(cell) != 1)
    yield from (f"line without a sum: {line['cell']}" for line in lines if "sum" not in line)
