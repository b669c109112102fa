# SPDX-License-Identifier: BSD-3-Clause
"""The installed program finds its experiments and scripts beside itself, and the package finds the program."""
import json
import os
import pathlib
import subprocess
import sys

from places import PREFIX, PROGRAM, SHARE, Scratch, needs, say

TINY = ("--set", "/time/steps=[8,16]", "--set", "/time/end=0.01", "--filter", "methods=rkmk/rk4")


class Program(Scratch):
    def replaced(self, file, text):
        """Changes an installed file for the time of a test."""
        before = file.read_text() if file.exists() else None
        file.write_text(text)
        self.addCleanup(file.unlink if before is None else lambda: file.write_text(before))

    def test_a_shipped_experiment_runs_by_name(self):
        self.kreisel("run", "orders_heavy_top", *TINY)
        self.assertIn("rkmk/rk4", self.kreisel("table", "results/orders_heavy_top"))
        self.assertTrue((self.scratch / "results/orders_heavy_top/results.csv").is_file())

    def test_experiments_are_those_beside_the_program(self):
        config = json.loads((SHARE / "experiments/orders/orders_heavy_top.json").read_text())
        self.replaced(SHARE / "experiments/only_here.json", json.dumps({**config, "name": "only_here"}))
        self.kreisel("run", "only_here", *TINY)

    def test_figures_are_drawn_with_the_scripts_beside_the_program(self):
        needs("gnuplot", "figures")
        self.kreisel("run", "orders_heavy_top", *TINY)
        self.kreisel("plot", "results/orders_heavy_top")
        figure = self.scratch / "results/orders_heavy_top/figures/orders_heavy_top.svg"
        self.assertGreater(figure.stat().st_size, 1000)
        self.replaced(SHARE / "plots/style.gp", "this is no gnuplot\n")
        done = subprocess.run([PROGRAM, "plot", "results/orders_heavy_top"], cwd=self.scratch, capture_output=True)
        self.assertEqual(done.returncode, 3)
        self.assertIn(f"{SHARE}/plots/style.gp".encode(), done.stderr)

    def test_sources_of_a_config_are_cited(self):
        self.assertIn("@article{munthekaas", self.kreisel("cite", "orders_heavy_top"))

    def test_published_numbers_are_there(self):
        self.assertTrue((SHARE / "experiments/published/published.csv").is_file())

    def test_the_schema_is_the_program_s(self):
        self.assertEqual((SHARE / "schema.json").read_text(), self.kreisel("schema"))
        json.loads((SHARE / "schema.json").read_text())

    def test_references_are_kept_in_the_home(self):
        self.kreisel("run", "orders_heavy_top", *TINY)
        self.assertTrue((pathlib.Path(os.environ["HOME"]) / ".cache/kreisel").is_dir())

    def test_the_package_finds_the_program(self):
        imported = subprocess.run([sys.executable, "-c", "import pandas, matplotlib"], capture_output=True)
        if imported.returncode != 0 and "python" not in os.environ.get("KREISEL_REQUIRE", "").split():
            self.skipTest("there is no pandas or matplotlib; tools/setup python installs them")
        script = ("import kreisel; print(kreisel.find_program()); "
                  "print(len(kreisel.run('orders_heavy_top', settings={'/time/steps': [8, 16], '/time/end': 0.01}, "
                  "filters={'methods': ['rkmk/rk4']}, progress=False).cells))")
        environment = {**os.environ, "PYTHONPATH": str(SHARE / "python"), "PATH": "/usr/bin:/bin",
                       "PYTHONDONTWRITEBYTECODE": "1", "MPLCONFIGDIR": str(self.scratch)}
        found, cells = say(sys.executable, "-c", script, cwd=self.scratch, env=environment).split()
        self.assertEqual(found, str(PROGRAM))
        self.assertGreater(int(cells), 0)

    def test_a_root_of_its_own(self):
        root = self.scratch / "root"
        say("cmake", "--install", os.environ["BUILD"], "--prefix", "/usr", env={**os.environ, "DESTDIR": str(root)})
        files = {file.relative_to(root / "usr") for file in root.rglob("*") if file.is_file()}
        self.assertEqual(files, {file.relative_to(PREFIX) for file in PREFIX.rglob("*") if file.is_file()})
        say(root / "usr/bin/kreisel", "check", "orders_heavy_top", cwd=self.scratch)
