# SPDX-License-Identifier: BSD-3-Clause
"""Lines of results.jsonl as the columns of results.csv: the same names in the same order, numbers as numbers."""
from __future__ import annotations

import csv
from collections import Counter
from pathlib import Path
from typing import Any, Callable, Iterator

import numpy as np
import pandas as pd

_PREFIXES = {"parameters": "parameter.", "options": "option.", "projection_options": "projection_option.",
             "metrics": "", "cost": "cost.", "final": "final."}
_FIELDS = ("cell", "problem", "label", "series", "parameters", "formulation", "method", "options", "projection",
           "projection_options", "precision", "steps", "h", "tolerance", "controller", "t_begin", "t_end", "status",
           "detail", "steps_done", "t_reached", "bodies", "metrics", "trajectory", "trajectory_sum", "cost", "final")
_MOST_BODIES = 16  # of which the table has the final state
_MEASURED = ("metrics", "final")  # numbers of the engine, which are text in quad

Entry = tuple[str, Any]


def split_title(title: str) -> tuple[str, str]:
    """("h", "s") of "h [s]"; the unit is empty where there is none."""
    name, bracket, unit = title.rpartition(" [")
    return (name, unit[:-1]) if bracket and title.endswith("]") else (title, "")


def _entries(name: str, value: Any) -> Iterator[Entry]:
    """A scalar, or the numbers of a vector or matrix; objects have no column."""
    if isinstance(value, list):
        for index, element in enumerate(value, 1):
            yield from _entries(f"{name}.{index}", element)
    elif not isinstance(value, dict):
        yield name, value


def _final_entries(state: dict[str, Any]) -> Iterator[Entry]:
    yield "t", state["t"]
    for body in state["bodies"]:
        for quantity in ("x", "R", "v", "omega"):
            yield from _entries(f"{body['name']}.{quantity}", body[quantity])
    for name, number in zip(state.get("multiplier_names", ()), state.get("multipliers", ())):
        yield name, number  # with its unit: "lambda.pin.1 [N]"
    for reaction in state.get("reactions", ()):
        for quantity in ("force", "torque"):
            yield from _entries(f"reaction.{reaction['joint']}.{quantity}", reaction[quantity])
        for quantity in ("force", "torque"):
            if f"driving_{quantity}" in reaction:
                yield f"drive.{reaction['joint']}.{quantity}", reaction[f"driving_{quantity}"]
    for quantity in ("theta", "turns"):
        yield from _entries(quantity, state.get(quantity, []))


def _field_entries(field: str, value: Any) -> Iterator[Entry]:
    if field == "final":
        if len(value["bodies"]) <= _MOST_BODIES:
            for name, number in _final_entries(value):
                yield "final." + split_title(name)[0], number
    elif isinstance(value, dict):
        for name, inner in value.items():
            yield from _entries(_PREFIXES[field] + name, inner)
    else:
        yield field, value


class ColumnUnits:
    """Units of columns by name, from the titles of results.csv. What has several units, of different problems, has a
    column for each, whose name keeps the unit: "parameter.k [N/m]"."""

    def __init__(self, table: Path | None):
        self._units: dict[str, str] = {}
        self._ambiguous: dict[str, dict[str, str]] = {}
        if table is not None:
            with table.open(encoding="utf-8", newline="") as file:
                self._read(csv.reader(file))

    def _read(self, rows: Iterator[list[str]]) -> None:
        titles = [split_title(title) for title in next(rows)]
        several = {name for name, count in Counter(name for name, _ in titles).items() if count > 1}
        self._units = {name: unit for name, unit in titles if unit and name not in several}
        self._ambiguous = {name: {} for name in several}
        columns = [(index, *title) for index, title in enumerate(titles) if title[0] in several]
        for row in rows if columns else ():
            for index, name, unit in columns:
                if row[index]:
                    self._ambiguous[name][row[0]] = unit

    def column(self, name: str, cell: str) -> str:
        """The name of the column in which a cell has this value."""
        unit = self._ambiguous.get(name, {}).get(cell, "")
        return f"{name} [{unit}]" if unit else name

    def of(self, column: str) -> str:
        """The unit of a column; empty where it has none."""
        return self._units.get(column) or split_title(column)[1]


def _column(values: list[Any], has_unit: bool) -> pd.Series | list[Any]:
    """Numbers become float64, or whole numbers where they have no unit; what is neither stays as it is."""
    known = [value for value in values if value is not None]
    numbers = all(isinstance(value, (int, float)) and not isinstance(value, bool) for value in known)
    if not known or not numbers:
        return pd.Series(values, dtype=object)
    if not has_unit and all(isinstance(value, int) for value in known):
        return pd.Series(values, dtype="int64" if len(known) == len(values) else "Int64")
    return pd.Series([np.nan if value is None else float(value) for value in values], dtype="float64")


def cell_table(records: list[dict[str, Any]], units: ColumnUnits, of_quad: Callable[[str], Any]) -> pd.DataFrame:
    """One row a record, indexed by the cell's hash; units in `attrs["units"]`. `of_quad` converts numbers of quad
    cells."""
    groups: dict[str, dict[str, list[Any]]] = {field: {} for field in _FIELDS}
    for row, record in enumerate(records):
        convert = of_quad if record["precision"] == "quad" else None
        for field, columns in groups.items():
            if field not in record:
                continue
            for name, value in _field_entries(field, record[field]):
                values = columns.setdefault(units.column(name, record["cell"]), [])
                values.extend([None] * (row - len(values)))
                values.append(convert(value) if convert and field in _MEASURED and isinstance(value, str) else value)
    flat = {name: values + [None] * (len(records) - len(values))
            for columns in groups.values() for name, values in columns.items()}
    frame = pd.DataFrame({name: _column(values, units.of(name) != "") for name, values in flat.items()})
    frame = frame.set_index("cell") if records else frame
    frame.attrs["units"] = {name: units.of(name) for name in frame.columns if units.of(name)}
    return frame
