# SPDX-License-Identifier: BSD-3-Clause
"""The figures of an experiment as data: what `kreisel plot` draws, from the report that the program makes of a folder.

The program selects cells, fits orders and laws, and words the legends; figures drawn from here agree with its PDFs.
"""
from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Union

import numpy as np

from .errors import KreiselError
from .numbers import parse_json
from .places import HeatFigure, SpaceFigure, read_heat, read_space
from .program import call_program
from .results import Results

_BEFORE, _AFTER = '<script type="application/json" id="data">', "</script>"


class NotDrawn(KreiselError):
    """A figure that the program does not draw, with its reason."""


@dataclass(frozen=True)
class Curve:
    """Coordinates have the units of the panel's labels."""

    label: str  #: enhanced text of gnuplot
    style: int  #: from 1
    x: np.ndarray
    y: np.ndarray
    fitted: tuple[int, ...] = ()  #: which points the order or law in the label was fitted to
    marked: tuple[int, ...] = ()  #: which points of a line bear its mark, beside another one of its colour


@dataclass(frozen=True)
class Mark:
    """A small text at a point, such as the order beside a slope triangle."""

    x: float
    y: float
    text: str


@dataclass(frozen=True)
class Panel:
    """Labels are enhanced text of gnuplot."""

    title: str
    x_label: str
    y_label: str
    log_x: bool
    log_y: bool
    from_zero: bool  #: a linear y axis that starts at zero
    curves: tuple[Curve, ...]
    guides: tuple[tuple[np.ndarray, np.ndarray], ...]  #: fitted laws and slope triangles
    marks: tuple[Mark, ...]
    x_range: tuple[float, float] | None = None  #: none: all that is drawn
    y_range: tuple[float, float] | None = None


@dataclass(frozen=True)
class FigureData:
    """A figure: panels beside and below each other."""

    name: str
    title: str
    note: str  #: what is wanting of the results; empty: nothing
    columns: int
    with_marks: bool  #: curves through measured points, not over time
    panels: tuple[Panel, ...]
    width: float | None = None  #: of the page, cm; none: as the legends require
    axes_height: float = 5.0  #: cm
    font_size: float = 7.5  #: points
    with_lines: bool = True  #: between the points of curves


def _array(values: list[float | None]) -> np.ndarray:
    return np.array([np.nan if value is None else value for value in values], dtype=np.float64)


def _abscissae(curves: list[dict[str, Any]]) -> list[np.ndarray]:
    """A curve with the x of an earlier one has the index of that curve in place of numbers."""
    all_x: list[np.ndarray] = []
    for one in curves:
        all_x.append(all_x[one["x"]] if isinstance(one["x"], int) else _array(one["x"]))
    return all_x


def _panel(data: dict[str, Any]) -> Panel:
    curves = tuple(Curve(one["label"], one["style"], x, _array(one["y"]), tuple(one.get("fitted", ())),
                         tuple(one.get("marked", ())))
                   for one, x in zip(data["curves"], _abscissae(data["curves"])))
    guides = tuple((_array(one["x"]), _array(one["y"])) for one in data["guides"])
    marks = tuple(Mark(**one) for one in data["marks"])
    return Panel(data["title"], data["x_label"], data["y_label"], data["log_x"], data["log_y"], data["from_zero"],
                 curves, guides, marks, *(tuple(data[key]) if key in data else None for key in ("x_range", "y_range")))


def _report_of(results: Results) -> dict[str, Any]:
    with tempfile.TemporaryDirectory(prefix="kreisel-") as scratch:
        page = Path(scratch) / "report.html"
        call_program(["report", results.folder, "-o", page])
        text = page.read_text(encoding="utf-8")
    begin = text.index(_BEFORE) + len(_BEFORE)
    return parse_json(text[begin:text.index(_AFTER, begin)])


Drawn = Union[FigureData, HeatFigure, SpaceFigure]


def read_figures(results: Results) -> dict[str, Drawn | NotDrawn]:
    """The figures that the config asks for, by name; of one that the program does not draw, the reason."""
    report = _report_of(results)
    figures: dict[str, Drawn | NotDrawn] = {}
    for one in report["figures"]:
        if "panels" in one:
            figures[one["name"]] = FigureData(one["name"], one["title"], report["wanting"], one["columns"],
                                              one["marks"], tuple(map(_panel, one["panels"])), one.get("width"),
                                              one["axes_height"], one["font_size"], one["lines"])
        elif "heat" in one:
            figures[one["name"]] = read_heat(one, report["wanting"])
        elif "space" in one:
            figures[one["name"]] = read_space(one, report["wanting"])
        else:
            figures[one["name"]] = NotDrawn(one["not_drawn"])
    return figures
