# SPDX-License-Identifier: BSD-3-Clause
"""A results folder as it lies on the disk, every sum checked. Damage is described as the program does."""
from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .damage import journal_damage, listed_damage, reference_damage, refusal
from .errors import FormatError, MissingResults
from .numbers import parse_json
from .sums import SumState, hash_text, line_sum_holds, sum_state

FORMAT = 2
"""What the manifests of folders say that this package reads."""

_SHARD = re.compile(r"(manifest|journal)(\.[0-9]+-of-[0-9]+)?\.jsonl?")
_CELL = re.compile(r"[0-9a-f]{16}")  # becomes part of a path


@dataclass
class FolderContents:
    """What a folder holds: `records` are the lines of results.jsonl, a dictionary each, in the order of the plan."""

    folder: Path
    manifest: dict[str, Any] = field(default_factory=dict)
    records: list[dict[str, Any]] = field(default_factory=list)
    damage: list[str] = field(default_factory=list)


def _read_manifest(file: Path) -> dict[str, Any] | str:
    """The manifest, or what is wrong with it."""
    if refused := refusal(file):
        return refused
    text = file.read_bytes()
    state = sum_state(text, b',\n  "sum": "', b'"\n}\n')
    if state is SumState.WRONG:
        return f"{file}: damaged: its sum does not hold"
    try:
        manifest = parse_json(text)
    except ValueError as error:
        return f"{file}: damaged: {error}"
    said = manifest.get("format", 1) if isinstance(manifest, dict) and "files" in manifest else 1
    if said == FORMAT and state is SumState.ABSENT:
        return f"{file}: damaged: it has no sum"
    if said != FORMAT:
        raise FormatError(f"{file}: expected a results folder of format {FORMAT}, got format {said}; please use the "
                          "package that came with its program, or run the config again")
    return manifest


def _files_of_runs(folder: Path, stem: str) -> list[Path]:
    return sorted(file for file in folder.glob(stem + "*") if _SHARD.fullmatch(file.name))


def _read_manifests(contents: FolderContents) -> None:
    for file in _files_of_runs(contents.folder, "manifest"):
        manifest = _read_manifest(file)
        if isinstance(manifest, str):
            contents.damage.append(manifest)
            continue
        contents.damage.extend(journal_damage(file, manifest))
        if file.name == "manifest.json":
            contents.manifest = manifest
    if not contents.manifest and not contents.damage:
        raise FormatError(f"{contents.folder}: expected a results folder of format {FORMAT}, got one without "
                          "manifest.json")


def _read_lines(contents: FolderContents) -> None:
    file = contents.folder / "results.jsonl"
    try:
        lines = file.read_bytes().split(b"\n")
    except FileNotFoundError:
        raise MissingResults(f"{file}: cannot be read: there is no such file") from None
    if lines[-1] == b"":
        lines.pop()
    known: set[str] = set()
    for number, line in enumerate(lines, 1):
        if not line:
            continue
        if not line_sum_holds(line):
            contents.damage.append(f"{file}:{number}: not a result line: damaged: its sum does not hold")
            continue
        record = parse_json(line)
        if not _CELL.fullmatch(record["cell"]):
            contents.damage.append(f"{file}:{number}: not a result line: the cell's name is not a hash")
        elif record["cell"] in known:
            contents.damage.append(f"{file}:{number}: not a result line: damaged: an earlier line is about the same "
                                   "cell")
        else:
            known.add(record["cell"])
            contents.records.append(record)
    cells = contents.manifest.get("cells", {})
    expected = cells.get("total", 0) - cells.get("missing", 0)
    if contents.manifest.get("ended") and len(lines) < expected:
        contents.damage.append(f"{file}:{len(lines) + 1}: damaged: expected {expected} lines, got {len(lines)}")


def read_folder(folder: Path) -> FolderContents:
    """Reads DIR/manifest.json and DIR/results.jsonl and checks all sums but those of the samples, which are checked
    when they are read. Raises MissingResults, FormatError and OSError."""
    contents = FolderContents(folder)
    if not (folder / "results.jsonl").is_file():
        raise MissingResults(f"{folder / 'results.jsonl'}: cannot be read: there is no such file")
    _read_manifests(contents)
    _read_lines(contents)
    contents.damage.extend(reference_damage(folder))
    contents.damage.extend(listed_damage(folder))
    return contents


def read_samples(folder: Path, record: dict[str, Any]) -> bytes | str:
    """The text of the trajectory of a record, or what is wrong with it."""
    file = folder / "trajectories" / f"{record['cell']}.csv"
    if not file.is_file():
        return f"{file}: damaged: it is not there"
    text = file.read_bytes()
    if hash_text(text) != record["trajectory_sum"]:
        return f"{file}: damaged: its sum is not the one of its cell"
    return text


def read_times(folder: Path, build: str) -> tuple[dict[str, dict[str, float]], list[str]]:
    """The costs, by cell, in the journals of a folder that this build has written, and what is damaged in them."""
    times: dict[str, dict[str, float]] = {}
    damage = []
    for file in _files_of_runs(folder, "journal"):
        lines = file.read_bytes().split(b"\n")
        if lines.pop() != b"":
            damage.append(f"{file}:{len(lines) + 1}: torn last line left out")
        for number, line in enumerate(lines, 1):
            if not line_sum_holds(line):
                damage.append(f"{file}:{number}: damaged line left out")
                continue
            record = parse_json(line)
            if record.get("build") == build and record.get("status") != "interrupted":
                times[record["cell"]] = record.get("cost", {})
    return times, damage
