# SPDX-License-Identifier: BSD-3-Clause
"""The state of a mechanism, as a cell reports it at its end."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable

import numpy as np


@dataclass(frozen=True)
class BodyState:
    """One body, whatever its formulation."""

    x: np.ndarray  #: mass centre, space axes, m
    R: np.ndarray  #: rotation, body to space, 3 x 3
    v: np.ndarray  #: velocity of the mass centre, space axes, m/s
    omega: np.ndarray  #: angular velocity, body axes, rad/s


@dataclass(frozen=True)
class Reaction:
    """The wrench of a joint on its second-named body, space axes."""

    force: np.ndarray  #: N
    torque: np.ndarray  #: about the joint's point of the second body, N m
    unique: bool  #: otherwise it is the one of least norm
    driving_force: Any = None  #: N, along the axis; None where no shift is prescribed
    driving_torque: Any = None  #: N m, about the axis; None where no turn is prescribed


@dataclass(frozen=True)
class State:
    """Numbers of quad cells are text or mpf in arrays of objects, those of double cells are float64."""

    t: Any  #: time, s
    bodies: dict[str, BodyState]
    multipliers: dict[str, Any] = field(default_factory=dict)  #: by name, "lambda.pin.1"; absent where not unique
    reactions: dict[str, Reaction] = field(default_factory=dict)  #: by joint
    theta: np.ndarray = field(default_factory=lambda: np.empty(0))  #: angles of torsion springs, all turns counted, rad
    turns: np.ndarray = field(default_factory=lambda: np.empty(0, dtype=np.int64))  #: full turns of these
    units: dict[str, str] = field(default_factory=dict)  #: of the multipliers, N or N m


def _array(values: Any, convert: Callable[[Any], Any], quad: bool) -> np.ndarray:
    numbers = np.array(values, dtype=object)
    converted = np.array([convert(value) for value in numbers.flat], dtype=object).reshape(numbers.shape)
    exact = quad and not all(isinstance(value, float) for value in converted.flat)
    return converted if exact else converted.astype(np.float64)


def state_of(record: dict[str, Any], of_quad: Callable[[str], Any]) -> State:
    """The final state of a record that has one."""
    quad = record["precision"] == "quad"
    convert = of_quad if quad else float
    state = record["final"]

    def array(values: Any) -> np.ndarray:
        return _array(values, convert, quad)

    bodies = {body["name"]: BodyState(*(array(body[part]) for part in ("x", "R", "v", "omega")))
              for body in state["bodies"]}
    titles = [title.rpartition(" [") for title in state.get("multiplier_names", ())]
    names = [name for name, _, _ in titles]
    return State(
        t=convert(state["t"]),
        bodies=bodies,
        multipliers=dict(zip(names, map(convert, state.get("multipliers", ())))),
        reactions={reaction["joint"]: Reaction(array(reaction["force"]), array(reaction["torque"]),
                                               reaction.get("unique", True),
                                               *(convert(reaction[key]) if key in reaction else None
                                                 for key in ("driving_force", "driving_torque")))
                   for reaction in state.get("reactions", ())},
        theta=array(state.get("theta", [])),
        turns=np.array(state.get("turns", []), dtype=np.int64),
        units=dict(zip(names, (unit[:-1] for _, _, unit in titles))))
