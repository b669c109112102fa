# SPDX-License-Identifier: BSD-3-Clause
"""The style of kreisel's figures in matplotlib: the colours, marks and dashes of plots/gnuplot/style.gp."""
from __future__ import annotations

from contextlib import contextmanager
from typing import Any, Iterator

# Colours of Okabe and Ito, distinguishable with any colour vision.
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")
# Open circle, square, triangles up and down, diamond, cross, plus, pentagon, asterisk.
MARKS = ("o", "s", "^", "v", "D", "x", "+", "p", (8, 2, 0))
# Lengths of strokes and gaps, in line widths; none: solid.
DASHES = ((), (8, 3), (2, 2), (10, 3, 2, 3), (10, 3, 2, 3, 2, 3))
GUIDE = {"color": "#777777", "linewidth": 0.6}
GRID = {"color": "#bbbbbb", "linewidth": 0.4}
NOTE = {"color": "#555555", "fontsize": 6.5}

# viridis without its brightest end: even in lightness.
PALETTE = ("#440154", "#482878", "#3e4989", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58", "#b5de2b")

FONT_SIZE = 7.5  # points on the page
_LETTERS = ("font.size", "axes.titlesize", "axes.labelsize", "legend.fontsize", "xtick.labelsize", "ytick.labelsize",
            "figure.titlesize")
RC = {
    "font.family": "DejaVu Sans", "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.5, "axes.grid": True,
    "axes.axisbelow": True, "grid.color": GRID["color"], "grid.linewidth": GRID["linewidth"],
    "legend.frameon": False, "lines.linewidth": 1.0, "lines.markersize": 3.5, "lines.markeredgewidth": 0.8,
}


def line_style(number: int, marks: bool) -> dict[str, Any]:
    """The style of a curve by its number, from 1: what a call of `plot` takes. Colour, mark and dash all differ, so
    that curves can be told apart in print and with any colour vision."""
    n = number - 1
    dashes = DASHES[(n + n // len(COLOURS)) % len(DASHES)]
    # Dashed curves are drawn over solid ones, which would hide them where both coincide.
    style = {"color": COLOURS[n % len(COLOURS)], "linestyle": (0, dashes) if dashes else "-",
             "zorder": 2.1 if dashes else 2}
    return {**style, "marker": MARKS[n % len(MARKS)], "markerfacecolor": "none"} if marks else style


@contextmanager
def house_style(font_size: float = FONT_SIZE) -> Iterator[None]:
    """What is drawn within has the fonts (size in points), lines and axes of kreisel; the settings of the caller come back afterwards.

    The page itself is made outside: with it matplotlib may choose a backend, which would be forgotten with the rest.
    """
    import matplotlib.pyplot as plt

    with plt.rc_context({**RC, **dict.fromkeys(_LETTERS, font_size)}):
        yield
