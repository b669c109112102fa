# SPDX-License-Identifier: BSD-3-Clause
"""Where panels and their legends lie on the page, in cm, as in plots/figures/layout.cpp."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Sequence

from .style import FONT_SIZE, house_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes

CM = 1 / 2.54  # in
PANEL_WIDTH, PAGE_WIDTH, AXES_HEIGHT = 8.5, 17.0, 5.0
_LEFT, _RIGHT, _TOP, _BELOW, _BOTTOM, _TITLE = 1.6, 0.4, 0.6, 1.25, 0.15, 0.5
_ROW, _RAISED, _CHARACTER, _SAMPLE = 0.4, 0.14, 0.15, 1.2


@dataclass(frozen=True)
class Page:
    """How large a figure and its letters are."""

    width: float | None = None  #: cm; none: columns of PANEL_WIDTH, and more where a legend is longer
    axes_height: float = AXES_HEIGHT  #: cm
    font_size: float = FONT_SIZE  #: points

    @property
    def scale(self) -> float:
        """By how much letters, and the space around them, are larger than the standard."""
        return self.font_size / FONT_SIZE


def _panel_width(legends: Sequence[Sequence[str]], titles: Sequence[str], columns: int, page: Page) -> float:
    """Neither legends nor titles are cut: a panel is at least as wide as its longest entry and as its title, unless the
    width is given."""
    if page.width is not None:
        return page.width / columns
    widest = max((len(label) for labels in legends for label in labels), default=0)
    title = max(map(len, titles), default=0)
    width = PANEL_WIDTH if columns <= 2 else PAGE_WIDTH / columns
    return max(width, page.scale * (max(_SAMPLE + _CHARACTER * widest, _LEFT + _CHARACTER * title) + _RIGHT))


def _legend_height(labels: Sequence[str]) -> float:
    """Entries with something raised are higher."""
    return sum(_ROW + (_RAISED if "^" in label else 0) for label in labels)


def new_axes(legends: Sequence[Sequence[str]], columns: int = 1, title: str = "", page: Page = Page(),
             titles: Sequence[str] = ()) -> list[Axes]:
    """Axes for one panel for each legend, on a new page that leaves space for these below and for `titles` above."""
    import matplotlib.pyplot as plt

    columns, scale, axes_height = min(columns, len(legends)), page.scale, page.axes_height
    rows = [legends[at:at + columns] for at in range(0, len(legends), columns)]
    heights = [axes_height + scale * (_TOP + _BELOW + max(map(_legend_height, row)) + _BOTTOM) for row in rows]
    width = _panel_width(legends, titles, columns, page)
    heading = scale * _TITLE * (title.count("\n") + 1) if title else 0
    page_width, page_height = columns * width, sum(heights) + heading
    figure = plt.figure(figsize=(page_width * CM, page_height * CM))
    with house_style(page.font_size):
        if title:
            figure.suptitle(title, y=1 - 0.15 * scale / page_height, va="top")
        axes = []
        top = page_height - heading
        for row, height in zip(rows, heights):
            for column in range(len(row)):
                left, bottom = column * width + scale * _LEFT, top - scale * _TOP - axes_height
                axes.append(figure.add_axes([left / page_width, bottom / page_height,
                                             (width - scale * (_LEFT + _RIGHT)) / page_width,
                                             axes_height / page_height]))
            top -= height
    return axes


def legend_below(ax: Axes, page: Page = Page()) -> None:
    """The legend under the label of the x axis, from the left edge of the panel, where `new_axes` has left space."""
    handles, labels = ax.get_legend_handles_labels()
    if labels:
        width = ax.get_position().width * ax.figure.get_figwidth() / CM
        at = (-1.5 * page.scale / width, -_BELOW * page.scale / page.axes_height)
        ax.legend(handles, labels, loc="upper left", bbox_to_anchor=at, borderaxespad=0, borderpad=0,
                  labelspacing=0.35, handlelength=3)
