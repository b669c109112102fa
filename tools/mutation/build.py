# SPDX-License-Identifier: BSD-3-Clause
"""Suites built from changed sources: only the objects that depend on a changed file are compiled again, beside a build that
stays as it is. A changed file shadows the original by standing first in the include path."""

import concurrent.futures
import json
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from .mutants import ROOT, tracked_files

HOME = ROOT / "build" / "mutation"
STANDING_ALONE = {"lie", "series"}  # suites without helpers in source files of their own
TIMEOUT = 300  # s for one suite: a mutant that loops for ever is one that a test has seen


def copy_tree(tree):
    """Brings the copy up to date; unchanged files keep their times, so they are not rebuilt."""
    wanted = tracked_files()
    for name in wanted:
        source, target = ROOT / name, tree / name
        if target.is_file() and target.read_bytes() == source.read_bytes():
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, target)
    for path in list(tree.rglob("*")):
        if path.is_file() and str(path.relative_to(tree)) not in set(wanted):
            path.unlink()


def run_suite(program, environment=None):
    """(whether the suite is red, what it wrote to stderr)."""
    try:
        run = subprocess.run([str(program), "--abort"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                             errors="replace", timeout=TIMEOUT, env={**os.environ, **(environment or {})})
    except subprocess.TimeoutExpired:
        return True, ""
    return run.returncode != 0, run.stderr


class Build:
    """A build in double precision with the release flags: that of a copy of the working tree, which one may go on
    editing, or the one in `folder`, which is complete."""

    def __init__(self, folder, jobs):
        self.jobs, self.links, self.deps = jobs, {}, {}
        HOME.mkdir(parents=True, exist_ok=True)
        self.scratch = tempfile.TemporaryDirectory(prefix="work-", dir=HOME)
        self.folder = Path(folder or HOME / "build").resolve()
        if not folder:
            copy_tree(HOME / "tree")
            subprocess.run(["cmake", "-S", str(HOME / "tree"), "-B", str(self.folder), "-G", "Ninja",
                            "-D", "CMAKE_BUILD_TYPE=Release", "-D", "KREISEL_BINARY128=OFF"],
                           check=True, stdout=subprocess.DEVNULL)
        self.source = ROOT if folder else HOME / "tree"
        entries = json.loads((self.folder / "compile_commands.json").read_text())
        self.compile = {}
        for entry in entries:
            argv = shlex.split(entry["command"])
            self.compile[argv[argv.index("-o") + 1]] = argv

    def ninja(self, *arguments):
        return subprocess.run(["ninja", "-C", str(self.folder), "--quiet", *arguments], capture_output=True, text=True)

    def link(self, suite):
        """The command that links a suite; builds it first, and ends the program unless it passes unchanged."""
        if suite not in self.links:
            target = f"test_{suite}_binary64"
            built = self.ninja("-j", str(self.jobs), target)
            if built.returncode != 0:
                sys.exit(f"the suite {suite} does not build without any mutation\n{built.stdout}")
            if run_suite(self.folder / target)[0]:
                sys.exit(f"the suite {suite} is red without any mutation")
            command = self.ninja("-t", "commands", target).stdout.strip().split("\n")[-1]
            self.links[suite] = shlex.split(command.removeprefix(": && ").removesuffix(" && :"))
            self.read_dependencies()
        return self.links[suite]

    def read_dependencies(self):
        for block in self.ninja("-t", "deps").stdout.split("\n\n"):
            head, *files = block.strip().split("\n")
            paths = (self.folder / name.strip() for name in files)
            self.deps[head.split(":")[0]] = {os.path.normpath(path) for path in paths}

    def seeing(self, suite, file):
        """The objects of a suite that depend on a file."""
        path = os.path.normpath(self.source / file)
        return [name for name in self.link(suite) if name.endswith(".o") and path in self.deps.get(name, ())]


class Overlay:
    """The suites with one file replaced."""

    def __init__(self, build, file, text, name="line"):
        self.build, self.file, self.objects, self.linked = build, file, {}, {}
        self.folder = Path(build.scratch.name) / name
        shutil.rmtree(self.folder, ignore_errors=True)
        (self.folder / file).parent.mkdir(parents=True)
        (self.folder / file).write_text(text)

    def replaced(self, source, target):
        """The changed file in place of a source; of several in one (cmake/unity.cmake), in place of its own only."""
        changed = self.folder / self.file
        if Path(source).parent.name != "Unity":
            return changed
        several = Path(f"{target}.cpp")
        several.parent.mkdir(exist_ok=True)
        several.write_text(Path(source).read_text().replace(str(self.build.source / self.file), str(changed)))
        return several

    def compiled(self, name):
        """Compiles one object; returns its path, or None if that fails."""
        if name not in self.objects:
            argv = list(self.build.compile[name])
            target = self.folder / "objects" / name.replace("/", "_")
            argv[argv.index("-o") + 1] = str(target)
            if self.file.endswith(".cpp"):
                argv[argv.index("-c") + 1] = str(self.replaced(argv[argv.index("-c") + 1], target))
            argv.insert(next(i for i, word in enumerate(argv) if word.startswith("-I")), f"-I{self.folder}")
            target.parent.mkdir(exist_ok=True)
            done = subprocess.run(argv, cwd=self.build.folder, capture_output=True)
            self.objects[name] = target if done.returncode == 0 else None
        return self.objects[name]

    def programs(self, suite):
        """The suite's program; or where a header has changed and each test file of the suite stands alone, one program
        for each of these, the cheapest ones first: most mutants do not outlive them. None where the compiler refuses."""
        tests = [name for name in self.build.link(suite) if name.startswith(f"CMakeFiles/test_{suite}_")]
        if suite not in STANDING_ALONE or not set(tests) & set(self.build.seeing(suite, self.file)):
            yield self.program(suite, [])
            return
        for test in sorted(tests, key=lambda name: (self.build.folder / name).stat().st_size):
            yield self.program(suite, [name for name in tests if name != test])

    def program(self, suite, without):
        key = (suite, *without)
        if key not in self.linked:
            self.linked[key] = self.link(suite, without)
        return self.linked[key]

    def link(self, suite, without):
        seeing = [name for name in self.build.seeing(suite, self.file) if name not in without]
        with concurrent.futures.ThreadPoolExecutor(self.build.jobs) as pool:
            objects = dict(zip(seeing, pool.map(self.compiled, seeing)))
        if None in objects.values():
            return None
        program = self.folder / f"test_{suite}_{len(self.linked)}"
        argv = [str(objects.get(word, word)) for word in self.build.link(suite) if word not in without]
        argv[argv.index("-o") + 1] = str(program)
        subprocess.run(argv, cwd=self.build.folder, check=True)
        return program
