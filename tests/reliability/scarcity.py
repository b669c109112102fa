# SPDX-License-Identifier: BSD-3-Clause
"""What a run may have to do without: a home, descriptors, standard streams, a terminal, memory, a folder."""
import os
import resource
import tempfile

from attack import attack, emptied
from kreisel import SMALL, differences


def limited(which, value):
    return lambda: resource.setrlimit(which, (value, value))


def without(*descriptors):
    def close():
        for descriptor in descriptors:
            os.close(descriptor)
    return close


def to_full(descriptor):
    return lambda: os.dup2(os.open("/dev/full", os.O_WRONLY), descriptor)


def gone_folder():
    folder = tempfile.mkdtemp()
    os.chdir(folder)
    os.rmdir(folder)


def terminal():
    _, follower = os.openpty()
    os.dup2(follower, 2)


# name: environment (None: without), what happens before the program starts, the exit codes that are right.
SCARCITIES = {
    "no HOME": ({"HOME": None, "XDG_CACHE_HOME": None, "KREISEL_CACHE": None}, None, {0}),
    "HOME that is a device": ({"HOME": "/dev/null", "XDG_CACHE_HOME": None, "KREISEL_CACHE": None}, None, {0}),
    "a cache in a folder of the kernel": ({"KREISEL_CACHE": "/proc/kreisel"}, None, {0}),
    "no PATH": ({"PATH": ""}, None, {0}),
    "no TMPDIR": ({"TMPDIR": "/nowhere"}, None, {0}),
    "64 descriptors": ({}, limited(resource.RLIMIT_NOFILE, 64), {0}),
    "16 descriptors": ({}, limited(resource.RLIMIT_NOFILE, 16), {0}),
    "8 descriptors": ({}, limited(resource.RLIMIT_NOFILE, 8), {0, 3}),
    "files of 4 kB": ({}, limited(resource.RLIMIT_FSIZE, 4096), {3}),
    "no standard input": ({}, without(0), {0}),
    "no standard output": ({}, without(1), {0}),
    "no standard error": ({}, without(2), {0}),
    "no standard streams": ({}, without(0, 1, 2), {0}),
    "a full disk under standard output": ({}, to_full(1), {0}),
    "a full disk under standard error": ({}, to_full(2), {0}),
    "no TERM": ({"TERM": None}, None, {0}),
    "a dumb terminal": ({"TERM": "dumb"}, terminal, {0}),
    "an unknown terminal": ({"TERM": "none"}, terminal, {0}),
    "a working folder that is gone": ({}, gone_folder, {0}),
}


def environment_of(kreisel, changes):
    return {name: value for name, value in {**kreisel.environment, **changes}.items() if value is not None}


@attack("R7")
def scarce(kreisel, cases, random, measured):
    """Every case ends with its code; what could be done is whole, and what could not is done by a resume."""
    config = kreisel.write("small", SMALL)
    whole = kreisel.folder / "whole"
    kreisel.done(config, whole)

    def scarcity(name):
        changes, prepare, codes = SCARCITIES[name]
        folder = emptied(kreisel.folder / name.replace(" ", "_"))
        ended = kreisel("run", config, "-o", folder, "-j", 2, env=environment_of(kreisel, changes), preexec_fn=prepare)
        if ended.returncode not in codes:
            yield f"exit code {ended.returncode}: {ended.stderr}"
        if ended.returncode != 0 and kreisel("run", config, "-o", folder, "--resume").returncode != 0:
            yield "cannot be resumed"
        yield from differences(folder, whole)

    def no_folder(place):
        ended = kreisel("run", config, "-o", place)
        if ended.returncode != 3 or str(place) not in ended.stderr:
            yield f"exit code {ended.returncode}: {ended.stderr}"

    measured.each(kreisel, scarcity, SCARCITIES)
    # Folders that take no files, whoever asks: permissions do not stop root.
    measured.each(kreisel, no_folder, ["/proc/kreisel", "/sys/kreisel", config / "results"])
    measured.require(cases)
