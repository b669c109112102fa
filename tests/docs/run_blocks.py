#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands of the guide: run_blocks.py PROGRAM [-I FOLDER]... [PAGE...], by default of all pages in docs/.

Each page is run as one script in a folder of its own, which looks like a clone with a build in build/release. Files
that the text names are written there; those that the sources have must be a part of them; C++ that they lack is
compiled without making an object, with the include folders of -I. What follows a block as `text` must be what it
prints, in this order, `...` standing for anything.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
import pages
from pages import ROOT

COMPILE = ["-std=gnu++20", "-fsyntax-only", "-DKREISEL_PRECISION=binary64", "-DKREISEL_QUAD=0", "-I", str(ROOT)]
REQUIRED = os.environ.get("KREISEL_REQUIRE", "").split()


class Findings(list):
    def about(self, block, what):
        self.append(f"{block.place}: {what}")


def lay_out(folder, program):
    """Links to the sources, and the program where a build has it. Scripts are left out, which would work in the sources
    themselves: a block with one needs a mark."""
    for entry in ROOT.iterdir():
        if entry.name not in ("build", "results", ".git", ".ci", "tools", "check", "reproduce"):
            (folder / entry.name).symlink_to(entry)
    (folder / "build/release").mkdir(parents=True)
    (folder / "build/release/kreisel").symlink_to(program)


def write_file(block, folder, include, findings):
    """A block that is a file: of the user, of the sources, or C++ that would be added to them."""
    source = ROOT / block.name
    if source.is_file():
        if block.text not in source.read_text(encoding="utf-8"):
            findings.about(block, f"differs from {block.name}")
    elif block.name.endswith(".cpp"):
        options = COMPILE + [word for path in include for word in ("-I", path)]
        compiled = subprocess.run([os.environ.get("CXX", "g++"), *options, "-x", "c++", "-"], input=block.text,
                                  text=True, capture_output=True)
        if compiled.returncode != 0:
            findings.about(block, f"{block.name} does not compile:\n{compiled.stderr}")
    elif "/" in block.name:
        findings.about(block, f"{block.name}: files of the reader belong into the folder itself")
    else:
        (folder / block.name).write_text(block.text, encoding="utf-8")


def objections(block):
    """What is wrong with a block before anything runs."""
    if block.language not in ("sh", "text", "json", "python", "cpp"):
        yield f"expected a block of sh, text, json, python or cpp, got {block.language or 'none of them'}"
    if block.language in ("json", "python", "cpp") and not block.name:
        yield "the line before does not end in the name of a file, `NAME`:"
    if block.mark == "run by" and not (ROOT / block.argument).is_file():
        yield f"is marked as run by {block.argument}, which is no file"
    elif block.mark == "run by":
        script = (ROOT / block.argument).read_text(encoding="utf-8")
        for line in filter(str.strip, block.text.split("\n")):
            if os.path.basename(line.split()[0]) not in script:
                yield f"is marked as run by {block.argument}, which does not run {line.split()[0]}"


def is_there(purpose):
    return subprocess.run([ROOT / "tools/setup", "-n", purpose], capture_output=True).returncode == 0


def left_out(block, findings):
    """Whether another script runs these commands, or nothing can."""
    if block.mark == "run by":
        return True
    if block.mark == "needs" and not is_there(block.argument):
        print(f"docs: left out: {block.place} needs {block.argument}; tools/setup {block.argument} installs it")
        if block.argument in REQUIRED:
            findings.about(block, f"needs {block.argument}, which is required")
        return True
    return False


def differs(expected, output):
    """The first line that the output lacks after those before it."""
    rest = output.split("\n")
    for line in filter(lambda line: line.strip() not in ("", "..."), expected.split("\n")):
        pattern = re.compile(r"\s+".join(".*".join(map(re.escape, word.split("..."))) for word in line.split()))
        while rest and not pattern.search(rest[0]):
            rest.pop(0)
        if not rest:
            return line
        rest.pop(0)
    return None


def run_page(page, program, include, findings):
    found, began = pages.blocks(page), time.monotonic()
    with tempfile.TemporaryDirectory() as scratch:
        folder, log = pathlib.Path(scratch) / "clone", pathlib.Path(scratch) / "log"
        folder.mkdir()
        log.mkdir()
        lay_out(folder, program)
        script = ["set -euo pipefail", f"said() {{ exec > {log}/$1 2>&1; }}"]
        run = []
        for block in found:
            for objection in objections(block):
                findings.about(block, objection)
            if block.name:
                write_file(block, folder, include, findings)
            if block.language == "sh" and not left_out(block, findings):
                script += [f"said {len(run)}", block.text]
                run.append(block)
        environment = {**os.environ, "HOME": scratch, "KREISEL_CACHE": f"{scratch}/cache", "MPLBACKEND": "Agg",
                       "PATH": f"{os.path.dirname(program)}:{os.path.dirname(sys.executable)}:{os.environ['PATH']}",
                       "PYTHONDONTWRITEBYTECODE": "1"}
        code = subprocess.run(["bash", "-c", "\n".join(script)], cwd=folder, env=environment,
                              stdin=subprocess.DEVNULL).returncode
        said = [(log / str(i)).read_text() if (log / str(i)).exists() else None for i in range(len(run))]
    for block, output, after in zip(run, said, said[1:] + [None]):
        if output is not None and after is None and (code != 0 or block is not run[-1]):
            findings.about(block, f"fails with exit code {code}:\n{block.text}{output}")
        expected = found[found.index(block) + 1:][:1]
        if output is not None and expected and expected[0].language == "text":
            missing = differs(expected[0].text, output)
            if missing is not None:
                findings.about(expected[0], f"expected {missing!r} in\n{output}")
    print(f"{os.path.relpath(page, ROOT)}: {len(run)} blocks of commands run, {sum(bool(b.name) for b in found)} files "
          f"in {time.monotonic() - began:.1f} s")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("-I", dest="include", action="append", default=[])
    parser.add_argument("pages", nargs="*")
    given = parser.parse_args()
    findings = Findings()
    chosen = [pathlib.Path(page).resolve() for page in given.pages] or pages.pages()
    for page in chosen:
        run_page(page, os.path.abspath(given.program), given.include, findings)
    print("\n".join(findings))
    sys.exit(1 if findings or not chosen else 0)


if __name__ == "__main__":
    main()
