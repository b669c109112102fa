# SPDX-License-Identifier: BSD-3-Clause
"""Heat maps and figures in space, as data of the program's and drawn in the style of its figures."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import style
from .labels import matplotlib_text, plain_text
from .layout import CM

if TYPE_CHECKING:
    from matplotlib.colors import Colormap
    from matplotlib.figure import Figure

# Centimetres, as in plots/gnuplot/heat_map.gp.
_CHARACTER, _PLACE_WIDTH, _PLACE_HEIGHT, _RIGHT, _BELOW, _LEAST = 0.14, 1.2, 0.62, 2.9, 1.3, 2.8
_SPACE_WIDTH, _SPACE_HEIGHT = 10.5, 8.0
_LABEL_PAD = 8  # points, beyond numbers such as -0.001
_SLANT = 40  # degrees, of values that have no room beside each other


@dataclass(frozen=True)
class HeatMap:
    """A metric over two axes."""

    label: str  #: enhanced text of gnuplot
    values: np.ndarray  #: a row for each value of the y axis, a column for each of the x axis; NaN where there is none


@dataclass(frozen=True)
class HeatFigure:
    """Maps of the same axes, one below the other."""

    name: str
    title: str
    note: str  #: what is wanting of the results; empty: nothing
    x_label: str  #: enhanced text of gnuplot
    y_label: str
    x_values: tuple[str, ...]
    y_values: tuple[str, ...]
    log: bool  #: whether the scale of colours is logarithmic
    maps: tuple[HeatMap, ...]
    width: float | None = None  #: of the page, cm; none: as the texts require
    axes_height: float | None = None  #: of a map, cm
    font_size: float = style.FONT_SIZE  #: points


@dataclass(frozen=True)
class SpaceFigure:
    """The path of a mass centre (m, space axes) over time (s), and outlines of bodies at instants."""

    name: str
    title: str
    note: str
    low: tuple[float, float, float]  #: corners of the cube that is shown, m
    high: tuple[float, float, float]
    view: tuple[float, float]  #: elevation and azimuth of gnuplot, degrees
    t: np.ndarray
    path: np.ndarray  #: of shape (instants, 3)
    lines: tuple[tuple[float, np.ndarray], ...]  #: instants and points
    width: float | None = None  #: of the page, cm
    font_size: float = style.FONT_SIZE  #: points


def read_heat(one: dict[str, Any], note: str) -> HeatFigure:
    heat = one["heat"]
    maps = []
    for data in heat["maps"]:
        values = np.full((len(heat["y_values"]), len(heat["x_values"])), np.nan)
        for x, y, value in data["places"]:
            values[y, x] = value
        maps.append(HeatMap(data["label"], values))
    return HeatFigure(one["name"], one["title"], note, heat["x_label"], heat["y_label"], tuple(heat["x_values"]),
                      tuple(heat["y_values"]), heat["log"], tuple(maps), heat.get("width"), heat.get("axes_height"),
                      heat["font_size"])


def read_space(one: dict[str, Any], note: str) -> SpaceFigure:
    space = one["space"]
    lines = tuple((time, np.array(points, dtype=float)) for time, points in space["lines"])
    return SpaceFigure(one["name"], one["title"], note, tuple(space["low"]), tuple(space["high"]),
                       tuple(space["view"]), np.array(space["t"], dtype=float), np.array(space["path"], dtype=float),
                       lines, space.get("width"), space["font_size"])


def _heading(figure: HeatFigure | SpaceFigure) -> str:
    return "\n".join(filter(None, map(plain_text, (figure.title, figure.note))))


def _colours() -> Colormap:
    from matplotlib.colors import LinearSegmentedColormap

    return LinearSegmentedColormap.from_list("kreisel", style.PALETTE)


def draw_heat(data: HeatFigure) -> Figure:
    """A map for each metric, one below the other, with the values in their places."""
    import matplotlib.pyplot as plt
    from matplotlib.colors import LogNorm, Normalize

    scale, columns = data.font_size / style.FONT_SIZE, len(data.x_values)
    widest = scale * _CHARACTER * max(map(len, data.x_values))
    left, right = scale * (1.1 + _CHARACTER * max(map(len, data.y_values))), scale * _RIGHT
    place = scale * _PLACE_WIDTH if data.width is None else (data.width - left - right) / columns
    slanted = widest > place
    below = scale * _BELOW + (0.7 * widest if slanted else 0)
    if slanted and data.width is None:
        left = max(left, 0.8 * widest - place / 2)
    wide, high = place * columns, data.axes_height or scale * max(_PLACE_HEIGHT * len(data.y_values), _LEAST)
    heading = _heading(data)
    top = 0.35 + (0.5 * scale * (heading.count("\n") + 1) if heading else 0)
    width, height = left + wide + right, len(data.maps) * (high + below + 0.35) + top
    figure = plt.figure(figsize=(width * CM, height * CM))
    with style.house_style(data.font_size):
        if heading:
            figure.suptitle(heading, y=1 - 0.15 / height, va="top")
        for number, one in enumerate(data.maps):
            bottom = height - top - number * (high + below + 0.35) - high
            ax = figure.add_axes([left / width, bottom / height, wide / width, high / height])
            drawn = one.values[np.isfinite(one.values)]
            norm = (LogNorm if data.log else Normalize)(drawn.min(), drawn.max())
            image = ax.imshow(one.values, origin="lower", aspect="auto", cmap=_colours(), norm=norm)
            ax.grid(False)
            for (y, x), value in np.ndenumerate(one.values):
                if np.isfinite(value):
                    colour = "white" if norm(value) < 2 / 3 else "black"
                    ax.text(x, y, f"{value:.1e}", ha="center", va="center", fontsize=5.5 * scale, color=colour)
            slant = {"rotation": _SLANT, "ha": "right", "rotation_mode": "anchor"} if slanted else {}
            ax.set_xticks(range(len(data.x_values)), [plain_text(value) for value in data.x_values], **slant)
            ax.set_yticks(range(len(data.y_values)), [plain_text(value) for value in data.y_values])
            ax.set_xlabel(matplotlib_text(data.x_label))
            ax.set_ylabel(matplotlib_text(data.y_label))
            bar = figure.add_axes([(left + wide + 0.35) / width, bottom / height, 0.3 / width, high / height])
            figure.colorbar(image, cax=bar, label=matplotlib_text(one.label))
    return figure


def draw_space(data: SpaceFigure) -> Figure:
    """The path, coloured by time, over its shadow on the floor, with outlines of bodies."""
    import matplotlib.pyplot as plt
    from matplotlib.colors import Normalize
    from matplotlib.ticker import MaxNLocator
    from mpl_toolkits.mplot3d.art3d import Line3DCollection

    width = data.width or _SPACE_WIDTH
    figure = plt.figure(figsize=(width * CM, width * _SPACE_HEIGHT / _SPACE_WIDTH * CM))
    with style.house_style(data.font_size):
        ax = figure.add_axes([0.06, 0.17, 0.64, 0.75], projection="3d")
        colours = _colours()
        norm = Normalize(data.t[0], data.t[-1])
        for time, points in data.lines:
            ax.plot(*points.T, color=colours(norm(time)), linewidth=0.6)
        ax.plot(data.path[:, 0], data.path[:, 1], data.low[2], **style.GUIDE)
        pieces = Line3DCollection(np.stack([data.path[:-1], data.path[1:]], axis=1), cmap=colours, norm=norm)
        pieces.set_array(data.t[:-1])
        ax.add_collection(pieces)
        for low, high, set_limits, set_label, label in zip(
                data.low, data.high, (ax.set_xlim, ax.set_ylim, ax.set_zlim),
                (ax.set_xlabel, ax.set_ylabel, ax.set_zlabel), ("x_1", "x_2", "x_3")):
            set_limits(low, high)
            set_label(matplotlib_text(label) + " [m]")
        for axis in (ax.xaxis, ax.yaxis, ax.zaxis):
            axis.set_major_locator(MaxNLocator(4, steps=[1, 2, 5, 10]))
            axis.labelpad = _LABEL_PAD
        ax.set_box_aspect((1, 1, 1))
        elevation, azimuth = data.view  # which gnuplot counts from above, and from the negative second axis
        ax.view_init(90 - elevation, azimuth - 90)
        ax.set_title(_heading(data))
        figure.colorbar(pieces, cax=figure.add_axes([0.86, 0.25, 0.025, 0.45]), label="t [s]")
    return figure
