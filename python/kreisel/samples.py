# SPDX-License-Identifier: BSD-3-Clause
"""Trajectories: the samples of a cell over time."""
from __future__ import annotations

import io

import numpy as np
import pandas as pd

from .columns import split_title
from .numbers import Quad, quad_converter


def sample_table(text: bytes, quad_cell: bool, quad: Quad) -> pd.DataFrame:
    """The samples, indexed by t in s; units of all columns, and of t, in `attrs["units"]`. What was not measured is
    NaN, of quad cells None."""
    convert = quad_converter(quad)
    if quad_cell and quad != "double":
        frame = pd.read_csv(io.BytesIO(text), dtype=str, keep_default_na=False)
        frame = frame.applymap(lambda number: convert(number) if number else None)
    else:
        frame = pd.read_csv(io.BytesIO(text), dtype=np.float64, float_precision="round_trip")
    titles = [split_title(title) for title in frame.columns]
    frame.columns = [name for name, _ in titles]
    frame = frame.set_index("t")
    frame.attrs["units"] = dict(titles)
    return frame


def rotations(samples: pd.DataFrame, body: str) -> np.ndarray:
    """R of a body at each sample, body to space, of shape (samples, 3, 3)."""
    columns = [f"{body}.R{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3)]
    return samples[columns].to_numpy().reshape(-1, 3, 3)


def vectors(samples: pd.DataFrame, body: str, quantity: str) -> np.ndarray:
    """`x` (m, space axes), `v` (m/s, space axes) or `omega` (rad/s, body axes) of a body, of shape (samples, 3)."""
    return samples[[f"{body}.{quantity}{i}" for i in (1, 2, 3)]].to_numpy()
