# SPDX-License-Identifier: BSD-3-Clause
"""Small experiments that all tests share, run once."""
import atexit
import functools
import shutil
import struct
import tempfile
from pathlib import Path

import kreisel

ROOT = Path(__file__).resolve().parents[2]

# Both precisions, an option as an axis, steps to a tolerance, failed and skipped cells, and samples.
ORDERS = {
    "name": "orders", "kind": "convergence", "precision": ["double", "quad"],
    "problems": ["heavy_top", {"name": "heavy_top", "label": "slow", "parameters": {"omega": [0, 1.5, -0.0461538]}}],
    "formulations": ["SO3xR3", "SO3"],
    "methods": [{"name": "rkmk/kutta3", "coordinates": ["exp", "cayley"]}, "rkmk/dopri5", "variational/lie_verlet"],
    "time": {"end": 0.5, "steps": [2, 64, 128, 256, 512], "tolerance": 1e-4}, "output": {"samples": 2},
    "figure": [{"kind": "convergence", "name": "errors", "title": "of_x $", "facet": "precision",
                "metric": "error.position"},
               {"kind": "drift", "name": "defects", "metric": "defect.position"},
               {"kind": "path3d", "name": "path", "select": {"steps": 64}},
               {"kind": "path3d", "name": "one_path", "view": [70, 20], "select": {
                   "steps": 64, "precision": "double", "problem": "slow", "formulation": "SO3xR3",
                   "method": "rkmk/dopri5"}},
               {"kind": "heat_map", "name": "map", "metric": ["error.position", "error.omega"], "x": "steps",
                "select": {"precision": "double", "problem": "slow", "formulation": "SO3xR3",
                           "steps": [64, 128, 256, 512]}}],
}

_ROD = {"name": "rod", "mass": 1, "inertia": [0.01, 0.05, 0.05], "x": [0.5, 0, 0]}
_PLANE = {"type": "planar", "name": "pin", "between": ["ground", "rod"], "point": [0, 0, 0], "axis": [0, 0, 1]}
_SPRING = {"type": "torsion_spring", "between": ["ground", "rod"], "axis": [0, 0, 1], "stiffness": 1, "turns": 1}

# One name, pin.2, for a force and for a torque; an angle that counts turns.
PINS = {
    "name": "pins", "kind": "trajectory",
    "problems": [
        {"name": "multibody", "label": "ball", "parameters": {
            "bodies": [_ROD], "joints": [{**_PLANE, "type": "spherical"}]}},
        {"name": "multibody", "label": "plane", "parameters": {
            "bodies": [_ROD], "joints": [_PLANE], "forces": [_SPRING]}}],
    "methods": ["rkmk/rk4"], "time": {"end": 0.5, "steps": 50}, "output": {"samples": 5}, "figure": [],
}
del PINS["problems"][0]["parameters"]["joints"][0]["axis"]

TIMED = {
    "name": "timed", "kind": "work_precision", "problems": ["free_top"], "formulations": ["SO3"],
    "methods": ["rkmk/rk4"], "time": {"end": 0.1, "steps": [8, 16]},
}


@functools.lru_cache(maxsize=None)
def scratch():
    """A folder that lives as long as the tests."""
    folder = Path(tempfile.mkdtemp(prefix="kreisel-tests-"))
    atexit.register(shutil.rmtree, folder)
    return folder


@functools.lru_cache(maxsize=None)
def results_of(name):
    config = {"orders": ORDERS, "pins": PINS, "timed": TIMED}[name]
    return kreisel.run(config, scratch() / name, jobs=1, progress=False)


def copy_of(name, to):
    """A copy of the results, to be damaged."""
    target = Path(to) / name
    if target.exists():
        shutil.rmtree(target)
    shutil.copytree(results_of(name).folder, target)
    return target


def bits(number):
    """What a double is made of: -0 is not 0."""
    return struct.pack("<d", float(number))
