#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pages with one fault each, which the checks of the guide must find, and one without."""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import check_links
import check_site
import run_blocks

FAULTS = {
    "fails with exit code 3": "```sh\nexit 3\n```\n",
    "fails with exit code 4": "```sh\n(exit 4)\ntrue\n```\n\n```sh\ntrue\n```\n",
    "fails with exit code 0": "```sh\nexit 0\n```\n\n```sh\ntrue\n```\n",
    "fails with exit code 1": "```sh\nfalse | cat\n```\n",
    "fails with exit code 127": "```sh\n./reproduce\n```\n",
    "expected 'two'": "```sh\necho one\n```\n\n```text\ntwo\n```\n",
    "expected 'first'": "```sh\nprintf 'second\\nfirst\\nsecond\\n'\n```\n\n```text\nsecond\nsecond\nfirst\n```\n",
    "which is no file": "<!-- run by tools/none -->\n```sh\nfalse\n```\n",
    "which does not run apt-get": "<!-- run by check -->\n```sh\napt-get update\n```\n",
    "differs from methods/rkmk/rk4.cpp": "The file `methods/rkmk/rk4.cpp`:\n\n```cpp\n.order = 5\n```\n",
    "does not compile": "The file `methods/rkmk/own.cpp`:\n\n```cpp\nint x = \"\";\n```\n",
    "files of the reader": "The file `python/own.py`:\n\n```python\nx = 1\n```\n",
    "does not end in the name of a file": "Some numbers.\n\n```json\n{}\n```\n",
    "expected a block of": "```console\n$ true\n```\n",
}
SOUND = ("Save `own.json`:\n\n```json\n{}\n```\n\n```sh\ncat own.json; echo 1.5 s, done; echo more\n```\n\n"
         "```text\n{}\n... s, done\n```\n\n<!-- run by check -->\n```sh\ntools/setup none\n```\n")
LINKS = {"[a](none.md)": 1, "[a](page.md#none)": 1, "[a](#none)": 1, "[a](../outside.md)": 1,
         '<img src="none.png">': 1, "[a](page.md#a-heading-of-c)": 0, "`[a](none.md)`": 0,
         "```\n[a](none.md)\n```": 0, "[a](https://b.example)": 0}
SITE = {'<a href="none.html">': "no such page",
        '<a href="page.html#none">': "no such heading",
        '<script src="https://a.example/x.js">': "loads https://a.example/x.js",
        '<img src="//a.example/x.png">': "loads",
        '<link rel="stylesheet" href="http://a.example/x.css">': "loads",
        "@import 'https://a.example/x.css'": "loads",
        "a { background: url(https://a.example/x.png) }": "loads",
        '<script src="js/none.js">': "which is not there",
        "<p>drift\x0295\x03heavy": "control character",
        '<a href="https://a.example">': "",
        '<a href="page.html#here">': "",
        '<img src="page.png">': "",
        "a { background: url(data:image/png;base64,AA) }": ""}


class Controls(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name).resolve() / "root"
        (self.root / "docs").mkdir(parents=True)

    def page(self, text):
        page = self.root / "docs/page.md"
        page.write_text("# A heading, of `C`\n\n" + text + "\n")
        return page

    def findings(self, text):
        findings = run_blocks.Findings()
        with contextlib.redirect_stdout(io.StringIO()):
            run_blocks.run_page(self.page(text), "/bin/true", [], findings)
        return "\n".join(findings)

    def test_faults_of_blocks_are_found(self):
        for expected, text in FAULTS.items():
            with self.subTest(expected):
                self.assertIn(expected, self.findings(text))

    def test_sound_blocks_pass(self):
        self.assertEqual(self.findings(SOUND), "")

    def test_faults_of_links_are_found(self):
        (self.root.parent / "outside.md").write_text("")
        for text, count in LINKS.items():
            with self.subTest(text):
                self.assertEqual(len(list(check_links.broken_links(self.page(text), self.root))), count)

    def test_faults_of_sites_are_found(self):
        (self.root / "page.png").write_bytes(b"")
        for text, expected in SITE.items():
            check_site.read.cache_clear()
            (self.root / "page.html").write_text('<p id="here">' + (text if text[0] == "<" else ""))
            (self.root / "page.css").write_text("" if text[0] == "<" else text)
            found = list(check_site.findings(self.root))
            with self.subTest(text):
                self.assertEqual(len(found), bool(expected))
                self.assertIn(expected, "".join(found))


if __name__ == "__main__":
    unittest.main()
