# SPDX-License-Identifier: BSD-3-Clause
"""Words for legends: what tells cells apart."""
from __future__ import annotations

from typing import Any, Iterable

import pandas as pd

_AXES = ("label", "formulation", "method", "projection", "precision", "controller")
_WORDS = {"h": "h = {:.3g} s", "tolerance": "tolerance {:g}"}


def identity_columns(cells: pd.DataFrame) -> list[str]:
    """The columns that say what was run, except for the steps."""
    prefixes = ("parameter.", "option.", "projection_option.")
    return [name for name in cells.columns
            if name in ("problem", "t_end", *_AXES) or name.startswith(prefixes)]


class Legends:
    """What tells a curve from the others: "rkmk/kutta3, cayley", or only the method. An option is named where it
    differs among cells of one method or projection, a parameter where no label stands for it."""

    def __init__(self, cells: pd.DataFrame, names: Iterable[str]):
        varying = [name for name in names if cells[name].nunique(dropna=False) > 1]
        if "label" in varying:
            varying = [name for name in varying if name != "problem" and not name.startswith("parameter.")]
        owners = {"option": "method", "projection_option": "projection"}
        self._shown: dict[str, tuple[str, set[str]] | None] = {}
        for name in varying:
            owner = owners.get(name.partition(".")[0])
            if owner is None:
                self._shown[name] = None
                continue
            counts = cells.groupby(owner)[name].nunique(dropna=False)
            self._shown[name] = owner, set(counts.index[counts > 1])

    def of(self, row: pd.Series) -> str:
        words = []
        for name, of_owner in self._shown.items():
            if pd.notna(row[name]) and (of_owner is None or row[of_owner[0]] in of_owner[1]):
                words.append(self._word(name, row[name]))
        return ", ".join(words) or str(row["method"])

    @staticmethod
    def _word(name: str, value: Any) -> str:
        if name == "projection" and value == "none":
            return "no projection"
        family, _, key = name.partition(".")
        if family in ("option", "projection_option", "parameter") and key != "coordinates":
            return f"{key}={value}"
        return _WORDS.get(name, "{}").format(value)
