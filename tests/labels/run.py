#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Hostile labels come out of every sink as they went in, and nothing in them is executed: run.py PROGRAM runs one
experiment whose problems have them, and reads each label back from results and tables (CSV, Markdown, LaTeX), figures
(SVG) and the report (HTML). As names of folders they are read back from a shell.

LaTeX and SVG are left out by name where pdflatex and pdftotext, or gnuplot, are missing.
"""
import csv
import html
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from payloads import ALL as LABELS, CANARY, HOSTILE  # noqa: E402

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
BEYOND_GLYPHS = {"中文", "😀"}  # pdfTeX names what it has no glyph for by its number
PUNCTUATION = re.escape("!\"#$%&'()*+,-./:;<=>?@[\\]^_`{|}~")


def run(*words, **options):
    return subprocess.run(words, capture_output=True, text=True, **options)


def cells_of_markdown(line):
    """The texts of a row, as CommonMark reads them."""
    inner = line.strip().removeprefix("|").removesuffix("|")
    return [unescaped(cell.strip(" ")) for cell in split_at_bars(inner)]


def split_at_bars(text):
    cells, at = [""], 0
    while at < len(text):
        if text[at] == "\\" and at + 1 < len(text):
            cells[-1] += text[at:at + 2]
            at += 2
        elif text[at] == "|":
            cells.append("")
            at += 1
        else:
            cells[-1] += text[at]
            at += 1
    return cells


def unescaped(text):
    """Inline text without markup: an unescaped special character is an error."""
    parts = re.split(rf"(\\[{PUNCTUATION}]|&#?[a-z0-9]+;)", text)
    for plain in parts[::2]:
        if re.search(r"[`*_\[\]<~$]", plain):
            raise ValueError(f"markup in {text!r}")
    return "".join(html.unescape(part) if part.startswith("&") else part[1:] if part.startswith("\\") else part
                   for part in parts)


class Sinks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        problems = [{"name": "heavy_top", "label": label, "parameters": {"mass": 15 + i / 16}}
                    for i, label in enumerate(LABELS)]
        config = cls.folder / "labels.json"
        config.write_text(json.dumps({
            "name": "labels", "kind": "drift", "problems": problems, "methods": ["rkmk/euler"],
            "time": {"end": 0.01, "steps": 4}, "output": {"samples": 2}, "metrics": ["defect.position"],
            "figure": {"kind": "drift", "metric": "defect.position"}}))
        cls.results = cls.folder / "results"
        for words in (["run", config, "-o", cls.results], ["table", cls.results], ["report", cls.results]):
            done = run(PROGRAM, *words, cwd=cls.folder)
            if done.returncode != 0:
                raise RuntimeError(done.stderr)

    def tearDown(self):
        self.assertEqual(list(self.folder.rglob(CANARY)), [], "a label was executed")

    def each(self, found):
        for label in LABELS:
            with self.subTest(label=label):
                self.assertIn(label, found)

    def table(self, ending):
        return (self.results / "tables" / f"drift.{ending}").read_text(encoding="utf-8")

    def test_csv(self):
        with open(self.results / "results.csv", newline="", encoding="utf-8") as file:
            self.assertEqual([row["label"] for row in csv.DictReader(file)], LABELS)
        rows = list(csv.reader(self.table("csv").splitlines()))
        self.each([row[rows[0].index("problem")] for row in rows[1:]])

    def test_markdown(self):
        rows = [cells_of_markdown(line) for line in self.table("md").splitlines() if line.startswith("|")]
        self.assertEqual({len(row) for row in rows}, {len(rows[0])})
        self.each([row[rows[0].index("problem")] for row in rows[2:]])

    def test_markdown_of_the_site(self):
        try:
            import markdown
        except ImportError:
            self.skipTest("no python3-markdown")
        page = markdown.markdown(self.table("md"), extensions=["tables"])
        self.each([html.unescape(re.sub(r"<[^>]*>", "", cell)) for cell in re.findall(r"<td>(.*?)</td>", page, re.S)])

    def test_html(self):
        page = (self.results / "report.html").read_text(encoding="utf-8")
        data = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.S).group(1)
        self.assertNotIn("<", data)
        found = []

        def collect(value):
            if isinstance(value, str):
                found.append(value)
            elif isinstance(value, (list, dict)):
                for part in value.values() if isinstance(value, dict) else value:
                    collect(part)

        collect(json.loads(data)["tables"])
        self.each(found)

    @unittest.skipUnless(shutil.which("gnuplot"), "no gnuplot")
    def test_svg(self):
        done = run(PROGRAM, "plot", self.results, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        root = xml.etree.ElementTree.parse(self.results / "figures" / "labels.svg").getroot()
        texts = ["".join(element.itertext()).strip("\n") for element in root.iter("{http://www.w3.org/2000/svg}text")]
        self.each([text.removesuffix(": no growth law") for text in texts])

    @unittest.skipUnless(shutil.which("pdflatex") and shutil.which("pdftotext"), "no pdflatex or pdftotext")
    def test_latex(self):
        (self.folder / "t.tex").write_text(
            "\\documentclass{article}\\usepackage[a0paper]{geometry}\\usepackage{booktabs,textcomp}\n"
            "\\usepackage[T1]{fontenc}\\begin{document}\\noindent\n" + self.table("tex") + "\\end{document}\n",
            encoding="utf-8")
        # With -shell-escape a \write18 that came through would run its command.
        done = run("pdflatex", "-shell-escape", "-interaction=nonstopmode", "-halt-on-error", "t.tex", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        text = run("pdftotext", "-layout", "t.pdf", "-", cwd=self.folder).stdout
        lines = [re.sub(r"\s+", " ", line).strip() for line in text.splitlines()]
        # pdftotext does not tell letters with accents, Greek and typographic signs of all fonts.
        shown = {label: label for label in LABELS if label.isascii()}
        shown.update({label: "".join(f"[U+{ord(c):04X}]" for c in label) for label in BEYOND_GLYPHS})
        for label, text in shown.items():
            with self.subTest(label=label):
                self.assertTrue(any(line.startswith(re.sub(r"\s+", " ", text) + " ") for line in lines), lines)

    @unittest.skipUnless(shutil.which("pdflatex"), "no pdflatex")
    def test_wide_latex(self):
        """A table is no wider than the text; as it is without its choice of sizes, it would be."""
        fitting = self.table("tex")
        plain = re.search(r"\\begin\{tabular\}.*\\end\{tabular\}", fitting, re.DOTALL)[0]
        for text, is_overfull in (fitting, False), (plain, True):
            (self.folder / "w.tex").write_text(
                "\\documentclass{article}\\usepackage{booktabs,textcomp,graphicx}\\begin{document}\\noindent\n" + text +
                "\n\\end{document}\n", encoding="utf-8")
            done = run("pdflatex", "-interaction=nonstopmode", "-halt-on-error", "w.tex", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stdout[-2000:])
            self.assertEqual("Overfull \\hbox" in done.stdout, is_overfull)

    def test_shell(self):
        """As names of folders, in the command that computes what is missing."""
        half = self.folder / "half"
        config = self.folder / "half.json"
        config.write_text(json.dumps({"name": "half", "kind": "drift", "problems": ["free_top"], "metrics": [],
                                      "methods": ["rkmk/euler"], "time": {"end": 0.01, "steps": [1, 2]}}))
        done = run(PROGRAM, "run", config, "-o", half, "--shard", "1/2")
        self.assertEqual(done.returncode, 0, done.stderr)
        names = [label for label in LABELS if "/" not in label]
        self.assertGreaterEqual(len(names), 150)
        for name in names:
            with self.subTest(name=name):
                folder = self.folder / "folders" / name
                shutil.copytree(half, folder)
                done = run(PROGRAM, "merge", folder, cwd=self.folder)
                self.assertEqual(done.returncode, 3, done.stderr)
                command = done.stderr.rpartition("compute what is missing with: ")[2]
                said = run("sh", "-c", "kreisel() { printf '%s\\0' \"$@\"; }\n" + command, cwd=self.folder)
                self.assertEqual(said.stdout.split("\0")[:-1],
                                 ["run", f"{folder}/manifest.json", "-o", str(folder), "--resume"], command)


class Reading(unittest.TestCase):
    """What a sink must not do would be seen."""

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_payloads_are_many_and_different(self):
        self.assertGreaterEqual(len(set(HOSTILE)), 150)
        self.assertEqual(len(set(LABELS)), len(LABELS))

    def executed(self, *words, **options):
        run(*words, cwd=self.folder, **options)
        return (self.folder / CANARY).exists()

    @unittest.skipUnless(shutil.which("gnuplot"), "no gnuplot")
    def test_a_command_in_gnuplot_is_seen(self):
        self.assertTrue(self.executed("gnuplot", "-e", "set title \"`touch canary`\"; print 1"))

    @unittest.skipUnless(shutil.which("pdflatex"), "no pdflatex")
    def test_a_command_in_latex_is_seen(self):
        (self.folder / "t.tex").write_text("\\documentclass{article}\\begin{document}"
                                           "\\immediate\\write18{touch canary}\\end{document}\n")
        self.assertTrue(self.executed("pdflatex", "-shell-escape", "-interaction=nonstopmode", "t.tex"))

    def test_a_command_in_a_shell_is_seen(self):
        self.assertTrue(self.executed("sh", "-c", "echo a$(touch canary)b"))

    def test_markup_is_found(self):
        for text in ("*a*", "<b>", "[t](u)", "`x`", "~~s~~"):
            with self.assertRaises(ValueError):
                unescaped(text)
        self.assertEqual(cells_of_markdown(r"| a\|b | \\ | &lt; |"), ["a|b", "\\", "<"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
