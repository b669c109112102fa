# SPDX-License-Identifier: BSD-3-Clause
"""What is damaged in a results folder, beside lines of results and samples, in the words of the program."""
from __future__ import annotations

import hashlib
import re
import stat
from pathlib import Path, PurePosixPath
from typing import Any, Iterator

from .sums import SumState, hash_text, sum_state

_UNFINISHED = "0" * 64  # the sum of a file that is being written
_ENTRY = re.compile(rb"([0-9a-f]{64})  (.+)", re.DOTALL)


def refusal(file: Path) -> str:
    """What is at the name of a file and is none, such as a pipe, which keeps a reader waiting; empty for a file."""
    mode = file.stat().st_mode
    if stat.S_ISREG(mode):
        return ""
    kinds = ((stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a named pipe"), (stat.S_ISSOCK, "a socket"))
    return f"{file}: expected a file, got {next((kind for test, kind in kinds if test(mode)), 'a device')}"


def journal_damage(manifest_file: Path, manifest: dict[str, Any]) -> Iterator[str]:
    """A journal that is shorter or longer than its manifest says, ends within a line, or is gone."""
    expected = manifest.get("journal", {}).get("bytes")
    journal = manifest_file.with_name(manifest_file.name.replace("manifest", "journal", 1) + "l")
    if expected is None:
        return
    if not journal.is_file():
        yield f"{journal}: damaged: it is not there"
        return
    text = journal.read_bytes()
    if len(text) != expected or (text and text[-1:] != b"\n"):
        fault = ("its end is missing" if len(text) < expected else
                 "something has been added" if len(text) > expected else "its last line is torn")
        yield (f"{journal}:{text.count(10, 0, expected) + 1}: damaged: expected {expected} bytes, got {len(text)}: "
               f"{fault}")


def reference_damage(folder: Path) -> Iterator[str]:
    """References whose sum does not hold."""
    for file in sorted((folder / "references").glob("*.json")):
        if refused := refusal(file):
            yield refused
        elif sum_state(file.read_bytes(), after=b'"}\n') is not SumState.HOLDS:
            yield f"{file}:1: damaged: its sum does not hold"


def _is_path_below(path: str) -> bool:
    parts = PurePosixPath(path)
    return "\0" not in path and not parts.is_absolute() and ".." not in parts.parts and str(parts) == path


def listed_damage(folder: Path) -> Iterator[str]:
    """Of sums.sha256 and the files that it lists. Those that are not there are no damage."""
    file = folder / "sums.sha256"
    if not file.is_file():
        return
    text = file.read_bytes()
    entries, bad, last = {}, 0, 0
    for last, line in enumerate(text.removesuffix(b"\n").split(b"\n"), 1):
        entry = _ENTRY.fullmatch(line)
        if entry and _is_path_below(entry[2].decode(errors="replace")):
            entries[entry[2]] = entry[1]
        elif not line.startswith(b"#"):
            bad = bad or last
    listed = b"".join(digest + b"  " + path + b"\n" for path, digest in sorted(entries.items()))
    if text != listed + f"# sum {hash_text(listed)}\n".encode():
        yield f"{file}:{bad or last}: damaged: its own sum does not hold"
        return
    for path, digest in sorted(entries.items()):
        one = folder / path.decode()
        if digest.decode() == _UNFINISHED or not one.is_file():
            continue
        if hashlib.sha256(one.read_bytes()).hexdigest() != digest.decode():
            yield f"{one}: damaged: it is not what sums.sha256 says"
