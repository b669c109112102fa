# SPDX-License-Identifier: BSD-3-Clause
"""Folders that two programs want, and names that lead out of them."""
import json
import shutil
import signal
import time

from attack import attack, emptied
from kills import LONG, undisturbed
from kreisel import TINY, differences

BUSY = "another run is writing to this folder"


def writers(config, folder):
    return [("run", config, "-o", folder, "--resume"), ("run", config, "-o", folder, "--overwrite"),
            ("run", config, "-o", folder, "--shard", "1/2", "--resume"), ("merge", folder), ("table", folder),
            ("plot", folder), ("report", folder)]


def resumed_run(kreisel, config, whole):
    """A run at work in a folder with the results of an earlier one, of which the journal has lost all but a cell."""
    folder = kreisel.folder / "wanted"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(whole, folder)
    journal = folder / "journal.jsonl"
    first = journal.read_bytes().split(b"\n")[0] + b"\n"
    journal.write_bytes(first)
    process = kreisel.start("run", config, "-o", folder, "-j", "1", "--resume")
    while journal.stat().st_size <= len(first) and process.poll() is None:
        time.sleep(0.002)
    process.send_signal(signal.SIGSTOP)  # it holds its lock, however long the others take
    return process, folder


@attack("R9")
def lock(kreisel, cases, random, measured):
    """Whatever writes into the folder of a run that is at work is refused; a killed run leaves no lock."""
    config = kreisel.write("long", LONG)
    whole, _ = undisturbed(kreisel, config)
    while measured.cases < cases:
        process, folder = resumed_run(kreisel, config, whole)
        for words in writers(config, folder):
            ended = kreisel(*words)
            held = ended.returncode == 3 and BUSY in ended.stderr
            measured.case(words, *([] if held else [f"exit code {ended.returncode}: {ended.stderr}"]))
        process.kill()
        process.communicate()
        ended = kreisel("run", config, "-o", folder, "--resume")
        measured.case("stale lock", *([] if ended.returncode == 0 else [ended.stderr]), *differences(folder, whole))


LEAVING = ["", ".", "..", "/", "//", "../out", "../../out", "a/../../out", "./out", "/tmp/out", "~/out", "a/b", "a\\b",
           "..\\out", "a/", "/a", ".hidden", "-o", "--help", "a b", " a", "a ", "a\tb", "a\nb", "a\rb", "a\0b", "\x01",
           "\x7f", "\x85", "\u2028", "\u2029", "\ufeff", "a:b", "a*b", "a?b", "a|b", "a<b", "a>b", 'a"b', "a'b", "a`b",
           "$(id)", "$HOME", "${HOME}", "%s", "%2e%2e%2fout", "..%2fout", "a;b", "a&b", "a#b", "!a", "@a", "+a", "=a",
           "a,b", "a{b}", "[a]", "(a)", "a^b", "ä", "\u4e2d", "\U0001f600", "e\u0301", "\u202eout", "\u00a0", "con:",
           "a" * 101, "a" * 300, "a" * 5000, "../" * 40 + "out", "/" * 300, ".." * 50, "....//out", "..;/out",
           "\\\\host\\out", "file:///out", "..\u2215out", "..\uff0fout", "a\u200bb/../x", "/dev/null", "/proc/self/cwd"]


def files_of(folder):
    return {str(file.relative_to(folder)) for file in folder.rglob("*") if "inner" not in file.parts}


@attack("R23")
def leave(kreisel, cases, random, measured):
    """As the name of an experiment, of a figure, and of a new file: refused, or what is written stays inside."""
    for number, name in enumerate(LEAVING):
        outer = emptied(kreisel.folder / f"names{number}")
        inner = outer / "a" / "b" / "inner"
        inner.mkdir(parents=True)
        before = files_of(outer)
        faults = []
        figure = {"kind": "drift", "name": name}
        samples = {"kind": "drift", "output": {"samples": 2}, "metrics": ["defect.orthogonality"]}
        for part, config in (("name", {**TINY, "name": name}), ("figure", {**TINY, **samples, "figure": figure})):
            file = inner / f"{part}.json"
            file.write_text(json.dumps(config))
            ended = kreisel("run", file, cwd=inner)
            if ended.returncode != 2:
                faults.append(f"{part}: exit code {ended.returncode}: {ended.stderr}")
        if "\0" not in name:  # no word of a command has one
            ended = kreisel("new", "experiment", f"./{name}" if name.startswith("-") else name, cwd=inner)
            if ended.returncode not in (0, 2):
                faults.append(f"new: exit code {ended.returncode}: {ended.stderr}")
        measured.case(repr(name)[:40], *faults, *(f"wrote {file}" for file in files_of(outer) - before))
    measured.require(cases)
