# SPDX-License-Identifier: BSD-3-Clause
"""What has to be computed again: cells whose config, program or libraries have changed, and no others."""
import json
import pathlib
import re
import shutil
import subprocess

from attack import attack, emptied
from kreisel import TINY

BASE = {**TINY, "name": "base", "problems": [{"name": "heavy_top", "label": "top", "parameters": {"mass": 15}}],
        "formulations": ["SO3xR3", "SE3"], "methods": [{"name": "rkmk/rk4", "coordinates": "exp"}],
        "metrics": ["defect.position"]}
CELLS = 2


def problem(**parameters):
    return {"problems": [{**BASE["problems"][0], "parameters": {"mass": 15, **parameters}}]}


def method(**options):
    return {"methods": [{**BASE["methods"][0], **options}]}


# Every cell of a changed experiment is another one.
CHANGED = [
    {"time": {"end": 0.2, "steps": 10}}, {"time": {"end": 0.1, "steps": 11}}, {"time": {"end": 0.1, "tolerance": 1e-6}},
    problem(mass=15.000000000000002), problem(omega=[0, 150, -4.6]), problem(lever=[0, 1.5, 0]),
    problem(gravity=[0, 0, -9.8]), problem(inertia=[0.25, 0.47, 0.25]), problem(R=[[0, -1, 0], [1, 0, 0], [0, 0, 1]]),
    method(coordinates="cayley"), method(dexpinv="seed"), {"methods": ["rkmk/rk4_38"]}, {"methods": ["rkmk/kutta3"]},
    {"projections": ["position"]}, {"projections": [{"name": "position", "every": 2}]}, {"precision": "quad"},
    {"formulations": ["S3xR3"]}, {"metrics": ["defect.velocity"]}, {"metrics": []}, {"output": {"samples": 2}},
    {"problems": [{"name": "forced_heavy_top", "label": "top"}]},
]
# These write the same cells in other words.
SAME = [
    {"description": "in other words"}, {"projections": ["none"]}, {"precision": ["double"]},
    {"formulations": ["SE3", "SO3xR3"]}, problem(mass=15.0), problem(omega=[0, 150, -4.61538]),
    method(dexpinv="exact"), {"methods": ["rkmk/rk4"]}, {"time": {"end": 0.1, "step": 0.01}},
    {"time": {"steps": {"from": 10, "levels": 1}, "end": 1e-1}}, {"output": {"samples": 0}},
]


def taken_over(ended):
    found = re.search(r"\((\d+) taken over from before\)", ended.stderr)
    return int(found[1]) if found else 0


def resumed(kreisel, name, base, text, expected, **how):
    """The faults of a resume in a copy of a folder, which takes over so many cells."""
    folder, file = kreisel.folder / name, kreisel.folder / f"{name}.json"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(base, folder)
    file.write_text(text)
    ended = kreisel("run", file, "-o", folder, "--resume", **how)
    if ended.returncode not in (0, 1):
        yield f"exit code {ended.returncode}: {ended.stderr}"
    if taken_over(ended) != expected:
        yield f"{taken_over(ended)} cells are taken over, not {expected}: {ended.stderr}"


def other_library(kreisel, name, library, build_id):
    """A folder with a copy of a library that has another build id, and computes the same."""
    folder = emptied(kreisel.folder / name)
    bytes_of, mark = library.read_bytes(), bytes.fromhex(build_id)
    assert bytes_of.count(mark) == 1, f"{library}: {build_id}"
    (folder / library.name).write_bytes(bytes_of.replace(mark, bytes(byte ^ 0xff for byte in mark)))
    return folder


def loaded(kreisel):
    """The paths of the libraries by name."""
    said = subprocess.run(["ldd", kreisel.program], capture_output=True, text=True, check=True).stdout
    return {name: pathlib.Path(path) for name, path in re.findall(r"(\S+) => (\S+)", said)}


@attack("R27")
def change(kreisel, cases, random, measured):
    config, base = kreisel.write("base", BASE), emptied(kreisel.folder / "base")
    kreisel.done(config, base)
    for number, changes in enumerate(CHANGED):
        text = json.dumps({**BASE, **changes})
        measured.case(changes, *resumed(kreisel, f"changed{number}", base, text, 0))
    backwards = json.dumps(dict(reversed(BASE.items())), indent=3, ensure_ascii=True)
    same = [json.dumps({**BASE, **changes}) for changes in SAME] + [backwards]
    for number, text in enumerate(same):
        measured.case(text, *resumed(kreisel, f"same{number}", base, text, CELLS))
    libraries, paths = json.loads((base / "manifest.json").read_text())["program"]["loaded"], loaded(kreisel)
    for name, build_id in libraries.items():
        if name == "libc.so.6":  # it goes with the loader, which only accepts its own
            continue
        folder = other_library(kreisel, name, paths[name].resolve(), build_id)
        (folder / paths[name].resolve().name).rename(folder / name)
        faults = resumed(kreisel, f"with_{name}", base, json.dumps(BASE), 0,
                         environment={"LD_LIBRARY_PATH": str(folder)})
        measured.case(name, *faults)
    measured.require(cases)
    measured.remark = f"{len(CHANGED)} changes, {len(same)} that are none, {len(libraries) - 1} libraries"
