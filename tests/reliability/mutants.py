# SPDX-License-Identifier: BSD-3-Clause
"""Configs that are wrong: those that come with kreisel, changed at random places."""
import json
import pathlib
import re

from attack import attack

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLACE = re.compile(r"^[^\n]*?:\d+:\d+: \S*", re.M)
DEEP, LARGE = 100_000, 10_000_000


def places(value, path=()):
    """The paths of all values in a config."""
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, part in inner:
        yield (*path, key)
        yield from places(part, (*path, key))


def parent_of(config, path):
    for key in path[:-1]:
        config = config[key]
    return config


class Raw(str):
    """A text that stands in the file as it is."""


def text_of(value):
    """As JSON, which need not be any."""
    if isinstance(value, Raw):
        return value
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(key)}: {text_of(part)}" for key, part in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(text_of, value)) + "]"
    return json.dumps(value)


VALUES = [Raw("NaN"), Raw("1e999"), Raw("-1e999"), -1, 2.5, 5_000_000_000, Raw("01"), None, True, "", "rk4 ", {}, [],
          [[[]]], "\0", "a" * 10_000, Raw("1" * 400), {"a": {"b": []}}, Raw("Infinity"), Raw("0x10")]


def mutant(text, random):
    """The bytes of a changed config, and what was done."""
    config = json.loads(text)
    path = random.choice(list(places(config)))
    parent, key = parent_of(config, path), path[-1]
    kind = random.choice(["drop", "rename", "value", "value", "value", "twice", "cut", "deep", "bytes"])
    if kind == "drop":
        del parent[key]
    elif kind == "rename" and isinstance(parent, dict):
        parent[key + random.choice("xyz")] = parent.pop(key)
    elif kind in ("rename", "value"):
        parent[key] = random.choice(VALUES)
    elif kind == "deep":
        parent[key] = Raw(random.choice(["[" * DEEP + "]" * DEEP, '{"a":' * DEEP + "1" + "}" * DEEP, "[" * DEEP]))
    changed = text_of(config).encode()
    if kind == "twice":
        changed = changed.replace(b'"kind": ', b'"kind": "drift", "kind": ', 1)
    if kind == "cut":
        changed = changed[:random.randrange(len(changed))]
    if kind == "bytes":
        changed = random.choice([
            lambda: b"\xef\xbb\xbf" + changed, lambda: changed.decode().encode("utf-16"), lambda: changed + b"\0",
            lambda: changed.replace(b" ", b"\xff", 1), lambda: changed.replace(b'"', b"'"), lambda: changed + changed,
            lambda: changed + b" " * LARGE, lambda: b"", lambda: b"\x80", lambda: bytes(1000)])()
    return changed, f"{kind} at /{'/'.join(map(str, path))}"


@attack("R1")
def mutate(kreisel, cases, random, measured):
    """A changed config is refused with exit code 2 and a place, or is still a good one; nothing else happens."""
    files = sorted(file for file in ROOT.glob("experiments/*/*.json"))
    configs = [file.read_text() for file in files if isinstance(json.loads(file.read_text()).get("kind"), str)]
    good = []

    def judged(case):
        number, (changed, _) = case
        # Beside the shipped mechanisms, whose paths are relative.
        file = kreisel.folder / f"{number}.json"
        file.write_bytes(changed)
        ended = kreisel("check", file)
        if ended.returncode == 0:
            good.append(number)
        elif ended.returncode != 2:
            yield f"exit code {ended.returncode}: {ended.stderr[:300]}"
        elif not PLACE.search(ended.stderr) and "bytes" not in case[1][1]:
            yield f"no place in: {ended.stderr[:300]}"
        file.unlink()

    # A few mutants mean what the config meant, or something else that is good.
    measured.each(kreisel, judged, [(number, mutant(random.choice(configs), random))
                                    for number in range(cases + cases // 10)])
    wrong = measured.cases - len(good)
    if wrong < cases:
        measured.faults.append(f"only {wrong} configs are refused")
    measured.remark = f"{wrong} refused, {len(good)} still good"
