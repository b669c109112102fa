# SPDX-License-Identifier: BSD-3-Clause
"""Results of an experiment, read from its folder."""
from __future__ import annotations

import os
import warnings
from functools import cached_property
from numbers import Integral
from pathlib import Path
from typing import Any, Union

import pandas as pd

from .columns import ColumnUnits, cell_table
from .errors import DamagedResults, DamagedResultsWarning, MissingResults
from .folder import FolderContents, read_folder, read_samples, read_times
from .numbers import Quad, quad_converter
from .samples import sample_table
from .states import State, state_of

Cell = Union[str, int, pd.Series]
"""A cell by its hash, by its place in `Results.cells`, or by its row of it."""

_TIME_UNITS = {"cpu_s": "s", "run_s": "s", "step_s": "s", "memory": "B"}


class Results:
    """What `run` and `load` return. The folder stays as it is: nothing here writes into it."""

    def __init__(self, contents: FolderContents, keep: Any = None):
        """`keep` lives as long as the results do: the owner of a temporary folder."""
        self._records = contents.records
        self._places = {record["cell"]: place for place, record in enumerate(contents.records)}
        self._keep = keep
        self.folder = contents.folder
        self.manifest = contents.manifest  #: how the results were produced, as written
        self.damage = tuple(contents.damage)  #: what was left out; empty unless `load` was told to

    def __repr__(self) -> str:
        return f"<kreisel.Results {self.name}: {len(self._records)} cells in {self.folder}>"

    @property
    def config(self) -> dict[str, Any]:
        """The config as resolved, with all defaults."""
        return self.manifest.get("config", {})

    @property
    def name(self) -> str:
        """Of the experiment."""
        return self.config.get("name", self.folder.name)

    @property
    def kind(self) -> str:
        """Of the experiment: "convergence", "drift", ..."""
        return self.config.get("kind", "")

    @cached_property
    def cells(self) -> pd.DataFrame:
        """One row a cell in the order of the plan, with the columns of results.csv, indexed by the cell's hash.

        Doubles are exact. Numbers of quad cells are text, in columns of objects; `cells_as` converts them. Column names
        have no unit; units are in `attrs["units"]`. What was not measured is missing.
        """
        return self.cells_as("text")

    def cells_as(self, quad: Quad) -> pd.DataFrame:
        """The same with numbers of quad cells as "text", as "mpmath" numbers, or rounded to "double"."""
        return cell_table(self._records, self._units, quad_converter(quad))

    @property
    def failed(self) -> pd.DataFrame:
        """The cells whose method failed: `status` and `detail` say why, `t_reached` (s) says when."""
        return self.cells[~self.cells["status"].isin(["ok", "skipped"])]

    @cached_property
    def _units(self) -> ColumnUnits:
        table = self.folder / "results.csv"
        if table.is_file():
            return ColumnUnits(table)
        warnings.warn(f"{table}: there is no such file: columns have no units", stacklevel=4)
        return ColumnUnits(None)

    @cached_property
    def times(self) -> pd.DataFrame:
        """What differs from run to run, indexed by the cell's hash: `cpu_s` (s) of each cell; `run_s` (s), `step_s` (s
        per step) and `memory` (B) where the kind of the experiment measures them. Raises DamagedResults."""
        costs, damage = read_times(self.folder, self.manifest.get("program", {}).get("build", ""))
        if damage and not self.damage:
            raise DamagedResults(damage)
        rows = [{name: costs.get(cell, {}).get(name) for name in _TIME_UNITS} for cell in self._places]
        frame = pd.DataFrame(rows, index=pd.Index(self._places, name="cell"), columns=list(_TIME_UNITS), dtype=float)
        frame = frame.dropna(axis="columns", how="all")
        frame.attrs["units"] = {name: _TIME_UNITS[name] for name in frame.columns}
        return frame

    def record(self, cell: Cell) -> dict[str, Any]:
        """The line of results.jsonl of a cell: everything that is known of it. Raises KeyError."""
        return self._records[self._place_of(cell)]

    def final(self, cell: Cell, quad: Quad = "text") -> State:
        """The state at the end. Raises MissingResults if the cell has none, which is so of cells that were skipped."""
        record = self.record(cell)
        if "final" not in record:
            raise MissingResults(f"cell {record['cell']} has no final state; its status is {record['status']}")
        return state_of(record, quad_converter(quad))

    def trajectory(self, cell: Cell, quad: Quad = "text") -> pd.DataFrame:
        """The samples of a cell, indexed by t (s): "top.x1", "top.R23", "top.omega3", "lambda.pin.2", ...; units in
        `attrs["units"]`. Raises MissingResults if none were kept, DamagedResults if they are not those of the cell."""
        record = self.record(cell)
        if "trajectory" not in record:
            raise MissingResults(f'cell {record["cell"]} has no samples; set "output": {{"samples": K}}')
        text = read_samples(self.folder, record)
        if isinstance(text, str):
            raise DamagedResults([text])
        frame = sample_table(text, record["precision"] == "quad", quad)
        frame.attrs["cell"] = record["cell"]
        return frame

    def _place_of(self, cell: Cell) -> int:
        if isinstance(cell, Integral):
            return range(len(self._records))[int(cell)]
        name = cell.name if isinstance(cell, pd.Series) else cell
        if name not in self._places:
            raise KeyError(f"expected a cell of {self.folder} (a row, its place or its hash), got {name!r}")
        return self._places[name]


def load(folder: str | os.PathLike, *, leave_out_damage: bool = False) -> Results:
    """Reads a results folder. Every sum is checked: of lines, manifests, references and listed files now, of samples
    when they are read.

    Raises DamagedResults, which names each damaged file and where possible its line; with `leave_out_damage` the rest
    is read, with a DamagedResultsWarning. Raises FormatError for a folder of another format, MissingResults for one
    without results.
    """
    return read_results(Path(folder), leave_out_damage)


def read_results(folder: Path, leave_out_damage: bool = False, keep: Any = None) -> Results:
    """The same, for results whose folder is `keep`'s."""
    contents = read_folder(folder)
    if contents.damage and not leave_out_damage:
        raise DamagedResults(contents.damage)
    if contents.damage:
        warnings.warn("\n".join(contents.damage), DamagedResultsWarning, stacklevel=3)
    return Results(contents, keep)
