# SPDX-License-Identifier: BSD-3-Clause
"""Figures with matplotlib in the style of kreisel's own. Each function returns what matplotlib can go on with."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, Sequence

import numpy as np
import pandas as pd

from . import style
from .curves import Drawn, NotDrawn, Panel, read_figures
from .labels import matplotlib_text, plain_text
from .layout import Page, legend_below, new_axes
from .legends import Legends, identity_columns
from .places import HeatFigure, SpaceFigure, draw_heat, draw_space
from .results import Cell, Results

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def _set_scales(ax: Axes, log_x: bool, log_y: bool) -> None:
    from matplotlib.ticker import NullFormatter

    ax.set_xscale("log" if log_x else "linear")
    ax.set_yscale("log" if log_y else "linear")
    for axis, logarithmic in ((ax.xaxis, log_x), (ax.yaxis, log_y)):
        if logarithmic:
            axis.set_minor_formatter(NullFormatter())  # labels at powers of ten only


def _drawable(values: np.ndarray, logarithmic: bool) -> np.ndarray:
    """A curve is interrupted where a logarithmic axis has no place for it."""
    return np.where(values > 0, values, np.nan) if logarithmic else values


def draw_panel(ax: Axes, panel: Panel, with_marks: bool, page: Page = Page(), with_lines: bool = True) -> None:
    """Draws a panel of a figure into axes."""
    for x, y in panel.guides:
        ax.plot(_drawable(x, panel.log_x), _drawable(y, panel.log_y), **style.GUIDE)
    for curve in panel.curves:
        looks = style.line_style(curve.style, with_marks or bool(curve.marked))
        if not with_marks and curve.marked:
            looks["markevery"] = list(curve.marked)
        ax.plot(_drawable(curve.x, panel.log_x), _drawable(curve.y, panel.log_y),
                label=matplotlib_text(curve.label) or None, **(looks if with_lines else {**looks, "linestyle": "none"}))
    for mark in panel.marks:
        ax.text(mark.x, mark.y, matplotlib_text(mark.text), ha="center", va="center", **style.NOTE)
    _set_scales(ax, panel.log_x, panel.log_y)
    if panel.from_zero:
        ax.set_ylim(bottom=0)
    if panel.x_range:
        ax.set_xlim(panel.x_range)
    if panel.y_range:
        ax.set_ylim(panel.y_range)
    ax.set_title(matplotlib_text(panel.title))
    ax.set_xlabel(matplotlib_text(panel.x_label))
    ax.set_ylabel(matplotlib_text(panel.y_label))
    legend_below(ax, page)


def draw_figure(data: Drawn) -> Figure:
    """Draws the panels of a figure, beside and below each other, its heat maps, or what it shows in space."""
    if isinstance(data, HeatFigure):
        return draw_heat(data)
    if isinstance(data, SpaceFigure):
        return draw_space(data)
    title = "\n".join(filter(None, map(plain_text, (data.title, data.note))))
    page = Page(data.width, data.axes_height, data.font_size)
    axes = new_axes([[curve.label for curve in panel.curves] for panel in data.panels], data.columns, title, page,
                    [plain_text(panel.title) for panel in data.panels])
    with style.house_style(page.font_size):
        for ax, panel in zip(axes, data.panels):
            draw_panel(ax, panel, data.with_marks, page, data.with_lines)
    return axes[0].figure


def plot_figure(results: Results, name: str | None = None) -> Figure:
    """A figure that the config asks for, the first one if no name is given: with the curves, fitted orders and legends
    of `kreisel plot`. Raises KeyError for another name, NotDrawn where the program draws no curves."""
    figures = read_figures(results)
    if not figures:
        raise NotDrawn(f"{results.name}: the config asks for no figure")
    if name is None:
        name = next(iter(figures))
    if name not in figures:
        raise KeyError(f"expected a figure of the experiment ({', '.join(figures)}), got {name!r}")
    data = figures[name]
    if isinstance(data, NotDrawn):
        raise data
    return draw_figure(data)


def _doubles(column: pd.Series) -> np.ndarray:
    """Numbers rounded to double, those of quad cells too; NaN where there is none."""
    return np.array([np.nan if pd.isna(value) else float(value) for value in column], dtype=np.float64)


def _titled(name: str, units: dict[str, str]) -> str:
    unit = units.get(name, "")
    return f"{name} [{unit}]" if unit not in ("", "1") else name


def _draw_curves(curves: list[tuple[str, np.ndarray, np.ndarray]], x_label: str, y_label: str, logarithmic: bool,
                 marks: bool, ax: Axes | None) -> Axes:
    ax = ax if ax is not None else new_axes([[label for label, _, _ in curves]])[0]
    with style.house_style():
        for number, (label, x, y) in enumerate(curves, 1):
            ax.plot(_drawable(x, logarithmic), _drawable(y, logarithmic), label=plain_text(label),
                    **style.line_style(number, marks))
        _set_scales(ax, logarithmic, logarithmic)
        ax.set_xlabel(plain_text(x_label))
        ax.set_ylabel(plain_text(y_label))
        legend_below(ax)
    return ax


def plot_convergence(cells: pd.DataFrame, metric: str = "error.position", x: str | None = None,
                     ax: Axes | None = None) -> Axes:
    """A metric against the step size, or against any other column `x`, such as "cost.evaluations": a curve for each
    combination, of all cells or of those rows that are left.

    By default x is "h", or "tolerance" where all steps are chosen. A combination without a value is in the legend with
    its status. Orders are not fitted here: `plot_figure` has those of the program. Raises KeyError for a column that
    there is not.
    """
    x = x or ("h" if "h" in cells and cells["h"].notna().any() else "tolerance")
    for name in (metric, x):
        if name not in cells:
            raise KeyError(f"expected a column of the cells, got {name!r}")
    identity = identity_columns(cells)
    legends = Legends(cells, identity)
    curves = []
    for _, group in cells.groupby(identity, dropna=False, sort=False):
        ran = group[group["status"] != "skipped"]
        if ran.empty:
            continue
        label = legends.of(ran.iloc[0])
        ok = ran[(ran["status"] == "ok") & ran[metric].notna() & ran[x].notna()]
        if (ran["status"] != "ok").all():
            label += f": {ran['status'].iloc[0]}"
        at = _doubles(ok[x])
        order = np.argsort(at, kind="stable")
        curves.append((label, at[order], _doubles(ok[metric])[order]))
    units = cells.attrs.get("units", {})
    return _draw_curves(curves, _titled(x, units), _titled(metric, units), True, True, ax)


def plot_drift(results: Results, metric: str = "defect.position", cells: Iterable[Cell] | None = None,
               ax: Axes | None = None) -> Axes:
    """The running maximum of a defect or of the change of a first integral over time (s), both axes logarithmic: of
    these cells, or of all that have samples. A cell that does not have this metric is left out; raises KeyError if none
    has it."""
    table = results.cells
    if cells is None:
        cells = list(table.index[table["trajectory"].notna()]) if "trajectory" in table else []
    sampled = {cell: results.trajectory(cell, quad="double") for cell in (results.record(one)["cell"] for one in cells)}
    column = f"{metric}.max"
    drawn = {cell: samples for cell, samples in sampled.items() if column in samples}
    if not drawn:
        raise KeyError(f"expected a sampled metric, got {metric!r}")
    rows = table.loc[list(drawn)]
    steps = [name for name in ("h", "tolerance") if name in table]
    legends = Legends(rows, [*identity_columns(table), *steps])
    curves = [(legends.of(rows.loc[cell]), samples.index.to_numpy(), samples[column].to_numpy())
              for cell, samples in drawn.items()]
    units = next(iter(drawn.values())).attrs["units"]
    return _draw_curves(curves, "t [s]", "max " + _titled(metric, {metric: units[column]}), True, False, ax)


def plot_trajectory(results: Results, cell: Cell, columns: Sequence[str] | None = None, ax: Axes | None = None) -> Axes:
    """Columns of a trajectory over time (s), which must have one unit; by default x of the first body (m)."""
    samples = results.trajectory(cell, quad="double")
    units = samples.attrs["units"]
    names = list(columns) if columns is not None else [name for name in samples.columns if name[-3:-1] == ".x"][:3]
    found = {units[name] for name in names}
    if len(found) != 1:
        raise ValueError(f"expected columns of one unit, got {', '.join(sorted(found)) or 'no column'}")
    curves: list[Any] = [(name, samples.index.to_numpy(), samples[name].to_numpy()) for name in names]
    return _draw_curves(curves, "t [s]", f"[{found.pop()}]", False, False, ax)
