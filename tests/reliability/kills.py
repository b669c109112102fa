# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are killed or interrupted at random instants, and go on."""
import shlex
import signal
import time

from attack import attack, emptied
from kreisel import SMALL, differences

# Stops within two seconds: time enough for cells of some tenths of a second, and for their samples.
LONG = {**SMALL, "name": "long", "time": {"end": 0.1, "steps": [30000, 60000, 100000, 200000]},
        "output": {"samples": 100}}


def undisturbed(kreisel, config):
    """The folder of a run that nothing disturbs, and how long it takes, s."""
    folder, start = kreisel.folder / "whole", time.monotonic()
    kreisel.done(config, folder, "-j", 2)
    return folder, time.monotonic() - start


def killed(kreisel, config, folder, after):
    """Whether the run was killed before its end."""
    process = kreisel.start("run", config, "-o", folder, "-j", "2", "--resume")
    time.sleep(after)
    process.kill()
    process.communicate()
    return process.returncode == -signal.SIGKILL


@attack("R4")
def kill(kreisel, cases, random, measured):
    """Some runs are killed several times before they are left alone."""
    config = kreisel.write("small", SMALL)
    whole, seconds = undisturbed(kreisel, config)

    def resumed(case):
        number, kills = case
        folder = emptied(kreisel.folder / f"killed{number}")
        for after in kills:
            while not killed(kreisel, config, folder, after):
                emptied(folder)
                after /= 2  # the machine has become faster
        ended = kreisel("run", config, "-o", folder, "--resume", "-j", "2")
        if ended.returncode != 0:
            yield f"exit code {ended.returncode}: {ended.stderr}"
        yield from differences(folder, whole)
        yield from (f"left behind: {file.name}" for file in folder.rglob("*.part"))

    runs, left = [], cases
    while left > 0:
        kills = [random.uniform(0, seconds) for _ in range(min(left, random.randint(1, 3)))]
        runs.append((len(runs), kills))
        left -= len(kills)
    measured.each(kreisel, resumed, runs)
    measured.cases = sum(len(kills) for _, kills in runs)
    measured.remark = f"{measured.cases} kills in {len(runs)} runs"


def started(kreisel, config, folder):
    """A run that catches signals: from before its manifest is written."""
    process = kreisel.start("run", config, "-o", folder, "-j", "2")
    while not (folder / "manifest.json").exists() and process.poll() is None:
        time.sleep(0.002)
    return process


def stopped(process, which, after, again):
    """The exit code of a run that gets a signal, or two, what it says, and how long it takes, s."""
    time.sleep(after)
    start = time.monotonic()
    process.send_signal(which)
    if again is not None:
        time.sleep(again)
        process.send_signal(which)
    said = process.communicate()[1]
    return process.returncode, said, time.monotonic() - start


@attack("R5")
def interrupt(kreisel, cases, random, measured):
    """By SIGINT and SIGTERM, in half of the cases once more soon after; and then goes on as it says."""
    config = kreisel.write("long", LONG)
    whole, seconds = undisturbed(kreisel, config)
    stops = []

    def interrupted(case):
        number, which, after, again = case
        for _ in range(8):
            folder = emptied(kreisel.folder / f"interrupted{number}")
            code, said, lasted = stopped(started(kreisel, config, folder), which, after, again)
            if code != 0:
                break
            after /= 2  # it has come to its end: the machine has become faster
        stops.append(lasted)
        if code != 130:
            yield f"exit code {code}: {said}"
            return
        if lasted > 2:
            yield f"stopped after {lasted:.1f} s"
        table = kreisel("table", folder)
        if table.returncode not in (0, 1):
            yield f"table: exit code {table.returncode}: {table.stderr}"
        command = shlex.split(said.rpartition("continue with: kreisel ")[2])
        ended = kreisel(*command)
        if ended.returncode != 0:
            yield f"{command}: exit code {ended.returncode}: {ended.stderr}"
        yield from differences(folder, whole)

    measured.each(kreisel, interrupted,
                  [(number, (signal.SIGINT, signal.SIGTERM)[number % 2], random.uniform(0, 0.5 * seconds),
                    random.uniform(0, 0.3) if number // 2 % 2 else None) for number in range(cases)])
    measured.remark = f"stopped after {max(stops):.1f} s at most"
