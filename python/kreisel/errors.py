# SPDX-License-Identifier: BSD-3-Clause
"""What can go wrong, as exceptions. A cell whose method failed is none of these: it is a row with a status."""
from __future__ import annotations

import re
from typing import Sequence


class KreiselError(Exception):
    """The base of all errors of this package."""


class ConfigError(KreiselError):
    """The program refused a config or its arguments; nothing was run. The text is the program's own."""

    @property
    def suggestions(self) -> tuple[str, ...]:
        """The nearest valid name of each misspelt one."""
        return tuple(re.findall(r'did you mean "([^"]*)"\?', str(self)))


class DamagedResults(KreiselError):
    """Files of a results folder are not what was written. `damage` names each, where possible with its line."""

    def __init__(self, damage: Sequence[str]):
        super().__init__("\n".join(damage))
        self.damage = tuple(damage)


class DamagedResultsWarning(UserWarning):
    """Damaged results are left out, as the caller wished."""


class FormatError(KreiselError):
    """A results folder of a format that this package does not read."""


class MissingResults(KreiselError, FileNotFoundError):
    """A folder without results, or a cell without samples."""


class ProgramNotFound(KreiselError, FileNotFoundError):
    """There is no kreisel where it was looked for."""


class ProgramFailed(KreiselError):
    """The program could not read or write (code 3), or has a fault (any other code)."""

    def __init__(self, code: int, message: str):
        super().__init__(message or f"kreisel ended with exit code {code}")
        self.code = code
