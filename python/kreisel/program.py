# SPDX-License-Identifier: BSD-3-Clause
"""The kreisel program: where it is, and how it is called."""
from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from typing import Sequence

from .errors import ConfigError, KreiselError, ProgramFailed, ProgramNotFound

_PACKAGE = Path(__file__).resolve().parent
_REFUSED, _INTERRUPTED = 2, 130


def beside_package(package: Path = _PACKAGE) -> tuple[Path, ...]:
    """Where the program of this package may lie: PREFIX/bin for PREFIX/share/kreisel/python/kreisel, and build/release
    of the sources."""
    root = package.parent.parent
    installed = (root.parent.parent / "bin" / "kreisel",) if root.parts[-2:] == ("share", "kreisel") else ()
    return installed + (root / "build" / "release" / "kreisel",)


def _is_program(file: Path) -> bool:
    return file.is_file() and os.access(file, os.X_OK)


def find_program() -> Path:
    """The file that KREISEL names, else the one beside this package, else the one in PATH. Raises ProgramNotFound."""
    chosen = os.environ.get("KREISEL")
    if chosen:
        if not _is_program(Path(chosen)):
            raise ProgramNotFound(f"KREISEL: expected the path of the program, got {chosen!r}")
        return Path(chosen)
    candidates = beside_package()
    for file in candidates:
        if _is_program(file):
            return file
    found = shutil.which("kreisel")
    if found is None:
        places = ", ".join(map(str, candidates))
        raise ProgramNotFound(f"kreisel was not found: KREISEL is not set, and it is neither in PATH nor at {places}")
    return Path(found)


def _error_of(code: int, message: str) -> KreiselError:
    return ConfigError(message) if code == _REFUSED else ProgramFailed(code, message)


def _follow(process: subprocess.Popen, show: bool) -> str:
    """What the program says on stderr, shown as it comes; an interrupt is passed on, once."""
    said = []

    def follow() -> None:
        for line in process.stderr:
            said.append(line)
            if show:
                sys.stderr.write(line)
                sys.stderr.flush()

    try:
        follow()
    except KeyboardInterrupt:
        process.send_signal(signal.SIGINT)
        follow()
        process.wait()
        raise
    process.wait()
    return "".join(said).strip()


def call_program(arguments: Sequence[str | os.PathLike], *, show: bool = False) -> int:
    """Runs the program; the exit code, 0 or 1, which says whether all cells are ok.

    `show` passes its stderr, where progress is, on to that of Python. Raises ConfigError where the program refuses what
    it is asked, ProgramFailed where it cannot go on, KeyboardInterrupt where it was interrupted.
    """
    command = [os.fspath(part) for part in (find_program(), *arguments)]
    # A session of its own: an interrupt of the terminal reaches the program once, through this process.
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                          encoding="utf-8", errors="replace", start_new_session=True) as process:
        message = _follow(process, show)
    if process.returncode == _INTERRUPTED:
        raise KeyboardInterrupt
    if process.returncode not in (0, 1):
        raise _error_of(process.returncode, message)
    return process.returncode
