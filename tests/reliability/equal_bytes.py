# SPDX-License-Identifier: BSD-3-Clause
"""The same bytes, however a run is cut into pieces and wherever it takes place."""
import os
import shutil

from attack import attack, emptied
from kreisel import SMALL, outputs

# Fails in some cells, skips others, needs two references, and has quad cells.
MIXED = {**SMALL, "name": "mixed", "precision": ["double", "quad"], "formulations": ["SO3xR3", "SE3"],
         "projections": ["none", "position_velocity"], "problems": ["heavy_top", "double_pendulum"],
         "methods": ["rkmk/rk4", "crouch_grossman/cg3a", "baseline/rk4_quaternion"],
         "time": {"end": 0.1, "steps": [4, 20, 100]}, "output": {"samples": 2}}


def run(kreisel, config, folder, *words, **how):
    ended = kreisel("run", config, "-o", folder, *words, **how)
    return [] if ended.returncode in (0, 1) else [f"exit code {ended.returncode}: {ended.stderr}"]


def lines(folder):
    return sorted((folder / "results.jsonl").read_bytes().splitlines())


def by_workers(kreisel, config, whole, jobs):
    folder = emptied(kreisel.folder / f"workers{jobs}")
    yield from run(kreisel, config, folder, "-j", jobs)
    if outputs(folder) != whole:
        yield "other bytes"


def by_shards(kreisel, config, whole, shards):
    """The last part stands in a folder of its own, the others share one."""
    folder = emptied(kreisel.folder / f"shards{shards}")
    alone, merged = emptied(kreisel.folder / f"alone{shards}"), kreisel.folder / f"merged{shards}"
    shutil.rmtree(merged, ignore_errors=True)
    for shard in range(1, shards + 1):
        yield from run(kreisel, config, alone if shard == shards else folder, "--shard", f"{shard}/{shards}")
    ended = kreisel("merge", *([folder] if shards > 1 else []), alone, "-o", merged)
    if ended.returncode != 1 or outputs(merged) != whole:
        yield f"merge: exit code {ended.returncode}: {ended.stderr}"


def by_order(kreisel, whole, axis):
    config = kreisel.write(f"reversed_{axis}", {**MIXED, axis: MIXED[axis][::-1]})
    folder = emptied(kreisel.folder / f"reversed_{axis}")
    yield from run(kreisel, config, folder)
    if lines(folder) != sorted(whole["results.jsonl"].splitlines()):
        yield "other lines"


@attack("R13")
def cut(kreisel, cases, random, measured):
    """One case for each number of workers, of parts, and for each axis whose order changes."""
    config, folder = kreisel.write("mixed", MIXED), emptied(kreisel.folder / "whole")
    run(kreisel, config, folder)
    whole = outputs(folder)
    kinds = [("workers", jobs) for jobs in (1, 2, 4, 16)]
    kinds += [("shards", shards) for shards in range(1, 8)]
    kinds += [("order", axis) for axis in ("methods", "problems", "formulations", "precision", "projections")]

    def same(kind):
        what, value = kind
        if what == "order":
            return by_order(kreisel, whole, value)
        return (by_workers if what == "workers" else by_shards)(kreisel, config, whole, value)

    measured.each(kreisel, same, kinds if cases >= len(kinds) else random.sample(kinds, cases))
    measured.remark = f"{len(whole['results.jsonl'].splitlines())} cells, {len(whole) - 2} of them with samples"


ODD_NAMES = ["with space", "it's", 'say "no"', "$(touch evil)", "a;b", "ä中😀", "new\nline", "tab\there", "%s%n",
             "back\\slash", "*?[a]", "#hash", "x" * 200]
ENVIRONMENTS = [{"LC_ALL": "C.UTF-8"}, {"LC_ALL": "POSIX"}, {"LC_ALL": "de_DE.UTF-8"}, {"LC_ALL": "tr_TR.UTF-8"},
                {"LC_ALL": "xx_XX"}, {"TZ": "Pacific/Kiritimati"}, {"TZ": "America/St_Johns"}, {"TZ": "nonsense"},
                {"COLUMNS": "3"}, {"POSIXLY_CORRECT": "1"}, {"LANG": "fa_IR.UTF-8", "LC_ALL": ""},
                {"MALLOC_PERTURB_": "165"}]
MASKS = [0o000, 0o022, 0o077, 0o027]


@attack("R28")
def elsewhere(kreisel, cases, random, measured):
    """Languages, times, masks of permissions and paths; commas for decimal points where such a language is there."""
    config, folder = kreisel.write("small", SMALL), emptied(kreisel.folder / "whole")
    kreisel.done(config, folder)
    whole = outputs(folder)

    def there(place):
        number, what, value = place
        folder = emptied(kreisel.folder / (f"odd/{value}" if what == "name" else f"place{number}"))
        how = {"mask": {"preexec_fn": lambda: os.umask(value)}, "environment": {"environment": value},
               "name": {"cwd": folder}}[what]
        written = config
        if what == "name":  # a relative path, too
            written, out = shutil.copy(config, folder / f"{value[:200]}.json"), "out"
        else:
            out = folder
        yield from run(kreisel, written, out, **how)
        if outputs(folder / out) != whole:
            yield "other bytes"

    places = [("name", name) for name in ODD_NAMES] + [("mask", mask) for mask in MASKS]
    places += [("environment", environment) for environment in ENVIRONMENTS]
    measured.each(kreisel, there, [(number, *place) for number, place in enumerate(places)])
    measured.require(cases)
