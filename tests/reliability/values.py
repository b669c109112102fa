# SPDX-License-Identifier: BSD-3-Clause
"""Numbers at the ends of what a config takes, in every parameter of every problem."""
import json
import re

from attack import attack, emptied

HUGE = (1e100, -1e100, 1e-100)


def numbers_at(value, path=()):
    """The paths of the numbers in a parameter."""
    if isinstance(value, list):
        for key, part in enumerate(value):
            yield from numbers_at(part, (*path, key))
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path


def replaced(value, path, number):
    if not path:
        return number
    return [replaced(part, path[1:], number) if key == path[0] else part for key, part in enumerate(value)]


def lines(kreisel, folder, problem):
    """Of every method on a problem, in ten steps; nothing where the problem is refused."""
    config = kreisel.write(folder.name, {
        "name": "huge", "kind": "drift", "problems": [problem], "methods": ["*"],
        "metrics": ["defect.*", "invariant.*"], "time": {"end": 0.01, "steps": 10}})
    ended = kreisel("run", config, "-o", folder, "--timeout", 5, "-j", 1)
    if ended.returncode not in (0, 1, 2):
        raise ValueError(f"exit code {ended.returncode}: {ended.stderr[:300]}")
    if ended.returncode == 2:
        return []
    return [json.loads(line) for line in (folder / "results.jsonl").read_text().splitlines()]


def key(line):
    return line["method"], json.dumps(line["options"], sort_keys=True)


def defects_in(line):
    """What every motion has: first integrals depend on the parameters."""
    return {name for name in line["metrics"] if name.startswith("defect.")}


@attack("R10")
def huge(kreisel, cases, random, measured):
    """A cell that is ok has every number that it has with usual data, and no cell ends in words of the inside."""
    problems = re.findall(r"^  ?(\w+)", kreisel("list", "problems").stdout, re.M)
    usual, every = {}, []
    for problem in problems:
        found = lines(kreisel, emptied(kreisel.folder / f"usual_{problem}"), problem)
        if not found:  # it has parameters without a default
            continue
        usual[problem] = {key(line): defects_in(line) for line in found if line["status"] == "ok"}
        for name, value in found[0]["parameters"].items():
            every += [(problem, name, path, value, number) for path in numbers_at(value) for number in HUGE]
    tried = []

    def extreme(case):
        problem, name, path, value, number = case
        folder = emptied(kreisel.folder / re.sub(r"\W", "_", f"{problem}_{name}_{path}_{number}"))
        try:
            found = lines(kreisel, folder, {"name": problem, "parameters": {name: replaced(value, path, number)}})
        except ValueError as unexpected:
            yield str(unexpected)
            return
        tried.append(len(found))
        for line in found:
            if line["status"] == "ok":
                missing = usual[problem].get(key(line), set()) - defects_in(line)
                yield from (f"{line['method']} is ok without {name}" for name in sorted(missing))
            if "finite" in line.get("detail", "") and line["status"] == "exception":
                yield f"{line['method']}: {line['detail']}"

    measured.each(kreisel, extreme, every if cases >= len(every) else random.sample(every, cases))
    measured.remark = f"{sum(tried):,} cells of {len(usual)} problems"
