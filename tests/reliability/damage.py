# SPDX-License-Identifier: BSD-3-Clause
"""Results that are damaged, and the proof of those that are not."""
import hashlib
import json
import re
import shutil

from attack import attack, emptied
from equal_bytes import MIXED
from kreisel import TINY, differences, outputs


@attack("R26")
def damage(kreisel, cases, random, measured):
    """The journal of two cells, cut at every byte and with a bit changed in every byte: the resume that follows names
    the damage and ends with the results of an undisturbed run; a cut between lines leaves a good journal."""
    config = kreisel.write("tiny", {**TINY, "time": {"end": 0.1, "steps": [10, 20]}})
    whole = emptied(kreisel.folder / "whole")
    kreisel.done(config, whole)
    journal = (whole / "journal.jsonl").read_bytes()

    def damaged(case):
        kind, at = case
        folder = kreisel.folder / f"{kind}{at}"
        shutil.copytree(whole, folder)
        changed = journal[:at] if kind == "cut" else b"".join(
            (journal[:at], bytes([journal[at] ^ 1 << at % 8]), journal[at + 1:]))
        (folder / "journal.jsonl").write_bytes(changed)
        ended = kreisel("run", config, "-o", folder, "--resume", "-j", 1)
        if ended.returncode != 0:
            yield f"exit code {ended.returncode}: {ended.stderr}"
        good = kind == "cut" and (at == 0 or journal[at - 1:at] == b"\n" or journal[at:at + 1] == b"\n")
        if not good and "journal.jsonl:" not in ended.stderr:
            yield f"no word of the damage: {ended.stderr}"
        yield from differences(folder, whole)
        shutil.rmtree(folder)

    every = [(kind, at) for at in range(len(journal)) for kind in ("cut", "flip")]
    measured.each(kreisel, damaged, every if cases >= len(every) else sorted(random.sample(every, cases)))
    measured.remark = f"a journal of {len(journal)} bytes"


def fnv1a(text):
    """The sum of a line, as the program makes it."""
    value = 0xcbf29ce484222325
    for byte in text.encode():
        value = (value ^ byte) * 0x100000001b3 % 2**64
    return f"{value:016x}"


def forged(line):
    """Another last digit of the first metric, under a sum that holds."""
    start = line.rpartition(',"sum":')[0]
    changed = re.sub(r'("metrics":\{"[a-z._]+":"?[-0-9.e]*)(\d)',
                     lambda found: found[1] + str((int(found[2]) + 1) % 10), start, count=1)
    assert changed != start
    return f'{changed},"sum":"{fnv1a(changed)}"}}'


def listed(folder):
    """Lets sums.sha256 say what results.jsonl is."""
    file = folder / "sums.sha256"
    digest = hashlib.sha256((folder / "results.jsonl").read_bytes()).hexdigest()
    entries = re.sub(r"(?m)^[0-9a-f]{64}(?=  results\.jsonl$)", digest, file.read_text()).rpartition("# sum ")[0]
    file.write_text(f"{entries}# sum {fnv1a(entries)}\n")


PROVENANCE = [("program", name) for name in ("version", "commit", "build", "compiler", "flags", "libraries", "loaded")]
PROVENANCE += [("machine", name) for name in ("cpu", "instructions", "threads")]
PROVENANCE += [("started",), ("ended",), ("config",)]


def missing_provenance(manifest):
    for path in PROVENANCE:
        value = manifest
        for key in path:
            value = value.get(key, {})
        if not value:
            yield "the manifest lacks " + ".".join(path)


@attack("R25")
def verify(kreisel, cases, random, measured):
    """Cells are computed again; each of as many forged results is found by them."""
    config, folder = kreisel.write("mixed", MIXED), emptied(kreisel.folder / "whole")
    kreisel("run", config, "-o", folder)
    ended = kreisel("verify", folder, "--cells", cases)
    count = re.search(r"(\d+) of \d+ cells computed again \(seed 1\), 0 differ", ended.stdout)
    measured.case("whole", *missing_provenance(json.loads((folder / "manifest.json").read_text())),
                  *([] if ended.returncode == 0 and count else [f"exit code {ended.returncode}: {ended.stdout}"]))
    measured.cases = int(count[1]) if count else 0
    lines = (folder / "results.jsonl").read_text().splitlines()
    ok = [number for number, line in enumerate(lines) if json.loads(line)["status"] == "ok"]
    places = random.sample(ok, min(len(ok), max(1, cases // 10)))
    for place in places:
        (folder / "results.jsonl").write_text(
            "\n".join(forged(line) if number == place else line for number, line in enumerate(lines)) + "\n")
        listed(folder)
        ended = kreisel("verify", folder, "--cells", len(lines))
        if ended.returncode != 1 or "1 differ" not in ended.stdout:
            measured.faults.append(f"forged cell {place}: exit code {ended.returncode}: {ended.stdout}")
    measured.remark = f"and {len(places)} forged lines found among {len(outputs(folder)['results.jsonl'].splitlines())}"
