# SPDX-License-Identifier: BSD-3-Clause
"""Running experiments with the program."""
from __future__ import annotations

import json
import os
import tempfile
from fractions import Fraction
from pathlib import Path
from typing import Any, Iterator, Mapping, Sequence, Union

import numpy as np

from .errors import ConfigError
from .program import call_program
from .results import Results, read_results

Config = Union[Mapping[str, Any], str, os.PathLike]
"""A config itself, the path of one, or the name of one that comes with kreisel."""

Patterns = Union[str, Sequence[str]]


def _as_json(value: Any) -> Any:
    """What a config may hold beside the types of JSON: numbers and arrays of numpy, and coefficients as fractions."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if isinstance(value, Fraction):
        return str(value)
    raise TypeError(f"a config cannot hold a {type(value).__name__}")


def _config_text(config: Mapping[str, Any]) -> str:
    config = dict(config)
    if isinstance(config.get("extends"), str):  # relative to the working folder, not to the file that is written here
        config["extends"] = os.path.abspath(config["extends"])
    return json.dumps(config, default=_as_json, ensure_ascii=False, allow_nan=False, indent=2)


def _changes(settings: Mapping[str, Any], filters: Mapping[str, Patterns]) -> Iterator[str]:
    for pointer, value in settings.items():
        yield from ("--set", f"{pointer}={json.dumps(value, default=_as_json, allow_nan=False)}")
    for axis, patterns in filters.items():
        yield from ("--filter", f"{axis}={patterns if isinstance(patterns, str) else ','.join(patterns)}")


def _run_file(config: str | os.PathLike, options: Sequence[str], show: bool) -> None:
    call_program(["run", os.fspath(config), *options], show=show)


def _run_object(config: Mapping[str, Any], options: Sequence[str], show: bool) -> None:
    with tempfile.TemporaryDirectory(prefix="kreisel-") as folder:
        file = Path(folder) / "config.json"
        file.write_text(_config_text(config), encoding="utf-8")
        try:
            _run_file(file, options, show)
        except ConfigError as error:
            raise ConfigError(str(error).replace(str(file), "config")) from None


def run(config: Config, folder: str | os.PathLike | None = None, *, jobs: int | None = None, resume: bool = False,
        overwrite: bool = False, settings: Mapping[str, Any] | None = None,
        filters: Mapping[str, Patterns] | None = None, progress: bool = True) -> Results:
    """Runs an experiment and reads its results. A cell whose method fails is a row with a status, not an error.

    folder     where the results go; by default a temporary folder, which lives as long as the results
    jobs       cells computed at the same time; by default one per processor
    resume     keeps the cells that this build has done; overwrite: removes them first
    settings   values of the config to change, by JSON pointer: {"/time/end": 2}
    filters    what is left of an axis, by pattern: {"methods": "rkmk/*", "formulations": ["SE3", "SO3xR3"]}
    progress   shows on stderr what the program says

    Raises ConfigError with the program's own text where the config is refused: nothing was run then. Raises
    ProgramNotFound, ProgramFailed and what `load` raises.
    """
    keep = tempfile.TemporaryDirectory(prefix="kreisel-results-") if folder is None else None
    target = Path(folder if keep is None else keep.name)
    options = ["-o", os.fspath(target), *(["-j", str(jobs)] if jobs is not None else []),
               *(["--resume"] if resume else []), *(["--overwrite"] if overwrite else []),
               *_changes(settings or {}, filters or {})]
    (_run_object if isinstance(config, Mapping) else _run_file)(config, options, progress)
    return read_results(target, keep=keep)
