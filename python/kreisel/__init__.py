# SPDX-License-Identifier: BSD-3-Clause
"""kreisel from Python: experiments are run by the program, results are read into pandas.

    import kreisel
    results = kreisel.run("orders_heavy_top", "results/orders_heavy_top")
    results.cells, results.trajectory(0), results.final(0)
    kreisel.plot_convergence(results.cells, "error.position")

Units are SI throughout. Names are imported from here alone: what the modules below do is Python today, and can be
taken over by a compiled module without a change for users.
"""
from .curves import NotDrawn, read_figures
from .errors import (ConfigError, DamagedResults, DamagedResultsWarning, FormatError, KreiselError, MissingResults,
                     ProgramFailed, ProgramNotFound)
from .plots import plot_convergence, plot_drift, plot_figure, plot_trajectory
from .program import find_program
from .results import Results, load
from .running import run
from .samples import rotations, vectors
from .states import BodyState, Reaction, State

__all__ = [
    "BodyState", "ConfigError", "DamagedResults", "DamagedResultsWarning", "FormatError", "KreiselError",
    "MissingResults", "NotDrawn", "ProgramFailed", "ProgramNotFound", "Reaction", "Results", "State", "find_program",
    "load", "plot_convergence", "plot_drift", "plot_figure", "plot_trajectory", "read_figures", "rotations", "run",
    "vectors",
]
