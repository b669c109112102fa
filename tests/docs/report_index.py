#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The page that links the reports of all experiments: what is there, in the order of the program, as text."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CONFIGS = """Configs, which `run` finds by name
  first    Errors of <script>alert(1)</script> & others
  second   Has no report
  third    No figures
"""


class ReportIndex(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.results = Path(folder.name) / "results"
        self.program = Path(folder.name) / "kreisel"
        self.program.write_text(f"#!/bin/sh\ncat <<'EOT'\n{CONFIGS}EOT\n", encoding="utf-8")
        self.program.chmod(0o755)
        for name in ("first", "third", "unknown"):
            (self.results / name).mkdir(parents=True)
            (self.results / name / "report.html").touch()
        (self.results / "second").mkdir()
        (self.results / "first" / "figures").mkdir()
        (self.results / "first" / "figures" / "errors.svg").touch()

    def index(self, results):
        return subprocess.run([ROOT / "tools/report-index", "-k", self.program, results], capture_output=True, text=True)

    def test_page(self):
        self.assertEqual(self.index(self.results).returncode, 0)
        page = (self.results / "index.html").read_text(encoding="utf-8")
        self.assertLess(page.index('href="first/report.html"'), page.index('href="third/report.html"'))
        self.assertIn('src="first/figures/errors.svg"', page)
        self.assertIn("&lt;script&gt;alert(1)&lt;/script&gt; &amp; others", page)
        for absent in ("second", "unknown", "<script"):
            self.assertNotIn(absent, page)

    def test_no_folder(self):
        answer = self.index(self.results / "nowhere")
        self.assertEqual(answer.returncode, 3)
        self.assertIn("nowhere: there is no such folder", answer.stderr)


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=1))
