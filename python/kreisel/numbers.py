# SPDX-License-Identifier: BSD-3-Clause
"""Numbers as they are written: doubles exactly, quad numbers as text with all their digits, or converted."""
from __future__ import annotations

import json
from functools import lru_cache
from typing import Any, Callable, Literal

Quad = Literal["text", "mpmath", "double"]
"""What becomes of a number with 113 bits: its decimal digits, an mpf of mpmath, or the nearest double."""

QUAD_BITS = 113


@lru_cache(maxsize=1)
def quad_context():
    """The context of mpmath with the precision of quad, apart from `mpmath.mp`, whose precision others set."""
    import mpmath

    context = mpmath.MPContext()
    context.prec = QUAD_BITS
    return context


def quad_converter(quad: Quad) -> Callable[[str], Any]:
    """Raises ValueError for a name that is none of `Quad`."""
    if quad == "text":
        return str
    if quad == "mpmath":
        return quad_context().mpf
    if quad == "double":
        return float
    raise ValueError(f'quad: expected "text", "mpmath" or "double", got {quad!r}')


def _whole(text: str) -> int | float:
    return -0.0 if text == "-0" else int(text)  # the sign of zero is part of a double


def parse_json(text: str | bytes) -> Any:
    """JSON in which every double reads back exactly."""
    return json.loads(text, parse_int=_whole)
