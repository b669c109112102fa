# SPDX-License-Identifier: BSD-3-Clause
"""The program is found in a fixed order, and what it says and answers becomes results and exceptions."""
import gc
import json
import os
import shutil
import signal
import tempfile
import threading
import time
import unittest
from contextlib import redirect_stderr
from fractions import Fraction
from io import StringIO
from pathlib import Path
from unittest import mock

import numpy as np

import kreisel
from kreisel import program

TOP = {"name": "top", "kind": "convergence", "problems": ["free_top"], "formulations": ["SO3"],
       "methods": ["rkmk/rk4"], "time": {"end": 0.1, "steps": [4, 8]}, "metrics": []}


def script(file, text):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("#!/bin/sh\n" + text)
    file.chmod(0o755)
    return file


class Scratch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.scratch = Path(scratch.name)

    def environment(self, **variables):
        changed = mock.patch.dict(os.environ, {name: str(value) for name, value in variables.items()})
        changed.start()
        self.addCleanup(changed.stop)
        for name in {"KREISEL"} - set(variables):
            os.environ.pop(name, None)


class Search(Scratch):
    def setUp(self):
        super().setUp()
        self.package = self.scratch / "prefix/share/kreisel/python/kreisel"
        beside = mock.patch.object(program.beside_package, "__defaults__", (self.package,))
        beside.start()
        self.addCleanup(beside.stop)
        self.in_path = script(self.scratch / "path/kreisel", "")

    def test_the_variable_comes_first(self):
        script(self.scratch / "prefix/bin/kreisel", "")
        chosen = script(self.scratch / "chosen", "")
        self.environment(KREISEL=chosen, PATH=self.in_path.parent)
        self.assertEqual(kreisel.find_program(), chosen)

    def test_then_what_lies_beside_the_package(self):
        installed = script(self.scratch / "prefix/bin/kreisel", "")
        self.environment(PATH=self.in_path.parent)
        self.assertEqual(kreisel.find_program(), installed)

    def test_then_the_path(self):
        self.environment(PATH=self.in_path.parent)
        self.assertEqual(kreisel.find_program(), self.in_path)

    def test_a_build_of_the_sources_lies_beside_them(self):
        sources = self.scratch / "sources"
        self.assertEqual(program.beside_package(sources / "python/kreisel"), (sources / "build/release/kreisel",))

    def test_a_variable_that_names_no_program_is_an_error(self):
        self.environment(KREISEL=self.scratch, PATH=self.in_path.parent)
        with self.assertRaisesRegex(kreisel.ProgramNotFound, "KREISEL: expected the path of the program"):
            kreisel.find_program()

    def test_nowhere_is_an_error_that_names_the_places(self):
        self.environment(PATH=self.scratch)
        with self.assertRaisesRegex(kreisel.ProgramNotFound, "KREISEL is not set.*prefix/bin/kreisel"):
            kreisel.find_program()


class Running(Scratch):
    def run_top(self, folder=None, **options):
        return kreisel.run(TOP, folder, jobs=1, progress=False, **options)

    def test_a_misspelt_method_is_refused_with_the_nearest(self):
        with self.assertRaises(kreisel.ConfigError) as caught:
            kreisel.run({**TOP, "methods": ["rkmk/rk5"]}, self.scratch / "out", progress=False)
        self.assertIn('did you mean "rkmk/rk4"?', str(caught.exception))
        self.assertEqual(caught.exception.suggestions, ("rkmk/rk4",))
        self.assertRegex(str(caught.exception), r"\Aconfig:\d+:\d+: /methods/0: expected a method")
        self.assertFalse((self.scratch / "out").exists())

    def test_a_misspelt_experiment_too(self):
        with self.assertRaises(kreisel.ConfigError) as caught:
            kreisel.run("orders_hevy_top", self.scratch / "out", progress=False)
        self.assertEqual(caught.exception.suggestions, ("orders_heavy_top",))

    def test_a_failed_cell_is_a_row(self):
        results = kreisel.run({**TOP, "problems": ["heavy_top"], "formulations": ["SO3xR3"],
                               "time": {"end": 1, "steps": [2, 4096]}}, progress=False)
        self.assertEqual(list(results.cells["status"] == "ok"), [False, True])
        self.assertEqual(len(results.failed), 1)

    def test_a_config_is_a_dictionary_a_path_or_a_name(self):
        (self.scratch / "top.json").write_text(json.dumps(TOP))
        by_path = kreisel.run(self.scratch / "top.json", progress=False)
        self.assertEqual(list(by_path.cells.index), list(self.run_top().cells.index))
        with mock.patch.dict(os.environ, KREISEL_EXPERIMENTS=str(self.scratch)):
            self.assertEqual(list(kreisel.run("top", progress=False).cells.index), list(by_path.cells.index))

    def test_settings_and_filters(self):
        results = kreisel.run({**TOP, "methods": ["rkmk/rk4", "rkmk/heun"]}, progress=False,
                              settings={"/time/end": 0.25, "/time/steps": np.array([2])},
                              filters={"methods": ["rkmk/he*", "none/*"]})
        self.assertEqual(list(results.cells["method"]), ["rkmk/heun"])
        self.assertEqual(list(results.cells["t_end"]), [0.25])

    def test_a_dictionary_may_hold_arrays_and_fractions(self):
        tableau = {"name": "rkmk/tableau", "order": 2, "a": [[Fraction(1, 2)]], "b": [0, Fraction(1)]}
        problem = {"name": "free_top", "parameters": {"omega": np.array([0.1, 0.2, 1 / 3])}}
        results = kreisel.run({**TOP, "methods": [tableau], "problems": [problem]}, progress=False)
        self.assertEqual(results.cells["parameter.omega.3"].iloc[0], 1 / 3)
        self.assertTrue((results.cells["status"] == "ok").all())
        with self.assertRaisesRegex(TypeError, "a config cannot hold a set"):
            kreisel.run({**TOP, "methods": {"rkmk/rk4"}}, progress=False)

    def test_a_dictionary_extends_a_config_of_the_working_folder(self):
        (self.scratch / "base.json").write_text(json.dumps(TOP))
        before = os.getcwd()
        os.chdir(self.scratch)
        self.addCleanup(os.chdir, before)
        results = kreisel.run({"extends": "base.json", "name": "longer", "time": {"end": 0.2}}, progress=False)
        self.assertEqual(set(results.cells["t_end"]), {0.2})

    def test_results_are_not_overwritten_unasked(self):
        first = self.run_top(self.scratch / "out")
        with self.assertRaisesRegex(kreisel.ConfigError, "holds results already"):
            self.run_top(self.scratch / "out")
        for options in ({"resume": True}, {"overwrite": True}):
            self.assertEqual(list(self.run_top(self.scratch / "out", **options).cells.index), list(first.cells.index))

    def test_a_temporary_folder_lives_as_long_as_the_results(self):
        results = self.run_top()
        folder = results.folder
        gc.collect()
        self.assertTrue((folder / "results.jsonl").is_file())
        del results
        gc.collect()
        self.assertFalse(folder.exists())

    def test_progress_goes_to_stderr(self):
        for progress in (True, False):
            with redirect_stderr(StringIO()) as said:
                kreisel.run(TOP, progress=progress)
            self.assertEqual("top: 2 ok" in said.getvalue(), progress)


class Answers(Scratch):
    """Exit codes, of a program that is not kreisel."""

    def call(self, text):
        self.environment(KREISEL=script(self.scratch / "program", text))
        return program.call_program(["run"])

    def test_codes(self):
        self.assertEqual(self.call("exit 0"), 0)
        self.assertEqual(self.call("exit 1"), 1)
        with self.assertRaisesRegex(kreisel.ConfigError, r"\Aexpected this, got that\Z"):
            self.call("echo expected this, got that >&2; exit 2")
        for code in (3, 4, 9):
            with self.assertRaisesRegex(kreisel.ProgramFailed, r"\Aout of disk\Z") as caught:
                self.call(f"echo out of disk >&2; exit {code}")
            self.assertEqual(caught.exception.code, code)
        with self.assertRaisesRegex(kreisel.ProgramFailed, "ended with exit code -9"):
            self.call("kill -9 $$")
        with self.assertRaises(KeyboardInterrupt):
            self.call("exit 130")

    def test_an_interrupt_reaches_the_program_once(self):
        log = self.scratch / "log"
        ready = self.scratch / "ready"
        text = (f"trap 'echo interrupted >> {log}; exit 130' INT\n"
                "sleep 0.5  # until the call has returned that starts this program\n"
                f"cut -d' ' -f5 /proc/$$/stat > {ready}.new; echo $$ >> {ready}.new; mv {ready}.new {ready}\n"
                "for i in $(seq 200); do sleep 0.05; done\n")
        # A test that is run in the background may have been told to ignore interrupts.
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))

        def interrupt():
            while not ready.exists():
                time.sleep(0.01)
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt)
        thread.start()
        with self.assertRaises(KeyboardInterrupt):
            self.call(text)
        thread.join()
        self.assertEqual(log.read_text(), "interrupted\n")
        group, process = ready.read_text().split()
        self.assertEqual(group, process)  # so that an interrupt of the terminal's group does not reach it too


class Installed(Scratch):
    def test_the_package_needs_nothing_of_the_sources(self):
        package = self.scratch / "share/kreisel/python/kreisel"
        shutil.copytree(Path(kreisel.__file__).parent, package, ignore=shutil.ignore_patterns("__pycache__"))
        installed = script(self.scratch / "bin/kreisel", "")
        self.environment(PYTHONPATH=package.parent)
        said = os.popen("/usr/bin/python3 -c 'import kreisel; print(kreisel.find_program())'").read()
        self.assertEqual(said.strip(), str(installed))
