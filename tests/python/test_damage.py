# SPDX-License-Identifier: BSD-3-Clause
"""No damage is read in silence: files that were changed or cut are named, with the line where there is one."""
import json
import os
import subprocess
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np

import kreisel
from kreisel.folder import read_folder
from kreisel.sums import hash64, hash_text
from small import copy_of, results_of


def first_of(folder, pattern):
    return sorted(folder.glob(pattern))[0]


def changed(text, at):
    return text[:at] + bytes([text[at] ^ (1 << (at % 8))]) + text[at + 1:]


def damage_of(folder):
    """What reading everything finds: lines, listed files, samples and journals."""
    try:
        results = kreisel.load(folder)
        results.cells, results.times
        for cell in results.cells.index[results.cells["trajectory"].notna()]:
            results.trajectory(cell)
    except kreisel.DamagedResults as error:
        return error.damage
    return ()


def with_sum(manifest):
    text = json.dumps(manifest, indent=2).encode()[:-2]
    return text + b',\n  "sum": "' + hash_text(text).encode() + b'"\n}\n'


class Sums(unittest.TestCase):
    def test_published_vectors(self):
        for text, expected in ((b"", 0xCBF29CE484222325), (b"a", 0xAF63DC4C8601EC8C), (b"foobar", 0x85944171F73967E8)):
            self.assertEqual(hash64(text), expected)

    def test_every_length_up_to_and_beyond_a_block(self):
        text = np.random.default_rng(1).integers(0, 256, 200000, dtype=np.uint8).tobytes()
        for length in (*range(40), 65535, 65536, 65537, 131072, 200000):
            value = 0xCBF29CE484222325
            for byte in text[:length]:
                value = (value ^ byte) * 0x100000001B3 % 2 ** 64
            self.assertEqual(hash64(text[:length]), value, length)


class Damage(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = copy_of("pins", scratch.name)

    def files(self):
        below = [first_of(self.folder, "trajectories/*.csv")]
        return [self.folder / name for name in ("results.jsonl", "journal.jsonl", "manifest.json", "results.csv",
                                                "sums.sha256", "geometry.json")] + below

    def assert_noticed(self, file, text, whole):
        file.write_bytes(text)
        damage = damage_of(self.folder)
        self.assertTrue(any(file.name in said for said in damage), (file.name, len(text), damage))
        file.write_bytes(whole)

    def test_an_intact_folder_has_none(self):
        self.assertEqual(damage_of(self.folder), ())

    def test_every_changed_byte_is_noticed(self):
        for file in self.files():
            whole = file.read_bytes()
            for at in range(0, len(whole), max(len(whole) // 40, 1)):
                self.assert_noticed(file, changed(whole, at), whole)
            self.assert_noticed(file, changed(whole, len(whole) - 1), whole)

    def test_every_cut_is_noticed(self):
        for file in self.files():
            whole = file.read_bytes()
            for length in range(0, len(whole), max(len(whole) // 40, 1)):
                self.assert_noticed(file, whole[:length], whole)
            self.assert_noticed(file, whole[:-1], whole)

    def test_references(self):
        folder = copy_of("orders", self.folder.parent)
        file = first_of(folder, "references/*.json")
        whole = file.read_bytes()
        for at in range(0, len(whole), len(whole) // 20):
            for text in (changed(whole, at), whole[:at]):
                file.write_bytes(text)
                self.assertEqual(read_folder(folder).damage, [f"{file}:1: damaged: its sum does not hold"])

    def test_a_pipe_is_named_and_not_waited_for(self):
        folder = copy_of("orders", self.folder.parent)
        for file in (folder / "manifest.json", first_of(folder, "references/*.json")):
            whole = file.read_bytes()
            file.unlink()
            os.mkfifo(file)
            self.assertIn(f"{file}: expected a file, got a named pipe", read_folder(folder).damage)
            file.unlink()
            file.write_bytes(whole)
        self.assertEqual(read_folder(folder).damage, [])

    def test_what_the_journal_has_more_is_named(self):
        file = self.folder / "journal.jsonl"
        whole = file.read_bytes()
        for text, fault in ((whole + whole.split(b"\n")[0] + b"\n", "something has been added"),
                            (bytes(len(whole)), "its last line is torn")):
            file.write_bytes(text)
            ran = subprocess.run([os.environ["KREISEL"], "table", self.folder], capture_output=True, text=True)
            said = [line for line in damage_of(self.folder) if fault in line]
            self.assertEqual(len(said), 1)
            self.assertIn(said[0], ran.stderr)

    def test_the_line_is_named(self):
        file = self.folder / "results.jsonl"
        lines = file.read_bytes().split(b"\n")
        file.write_bytes(b"\n".join([lines[0], changed(lines[1], 100), b""]))
        with self.assertRaises(kreisel.DamagedResults) as caught:
            kreisel.load(self.folder)
        self.assertEqual(caught.exception.damage,
                         (f"{file}:2: not a result line: damaged: its sum does not hold",
                          f"{file}: damaged: it is not what sums.sha256 says"))

    def test_a_cell_counts_once(self):
        file = self.folder / "results.jsonl"
        lines = file.read_bytes().split(b"\n")
        file.write_bytes(b"\n".join([*lines[:-1], lines[0], b""]))
        contents = read_folder(self.folder)
        self.assertEqual(contents.damage, [f"{file}:{len(lines)}: not a result line: damaged: an earlier line is about "
                                           "the same cell", f"{file}: damaged: it is not what sums.sha256 says"])
        self.assertEqual(len(contents.records), len(lines) - 1)

    def test_the_order_of_the_lines_counts(self):
        file = self.folder / "results.jsonl"
        first, second, *rest = file.read_bytes().split(b"\n")
        file.write_bytes(b"\n".join([second, first, *rest]))
        self.assertEqual(damage_of(self.folder), (f"{file}: damaged: it is not what sums.sha256 says",))

    def test_what_is_not_there_is_named(self):
        (self.folder / "journal.jsonl").unlink()
        first_of(self.folder, "trajectories/*.csv").unlink()
        with self.assertRaisesRegex(kreisel.DamagedResults, "journal.jsonl: damaged: it is not there"):
            kreisel.load(self.folder)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            results = kreisel.load(self.folder, leave_out_damage=True)
        with self.assertRaisesRegex(kreisel.DamagedResults, "csv: damaged: it is not there"):
            [results.trajectory(place) for place in range(2)]

    def test_the_rest_is_read_where_that_is_asked_for(self):
        file = self.folder / "results.jsonl"
        file.write_bytes(changed(file.read_bytes(), 30))
        with self.assertWarnsRegex(kreisel.DamagedResultsWarning, "results.jsonl:1:"):
            results = kreisel.load(self.folder, leave_out_damage=True)
        self.assertEqual(list(results.cells.index), list(results_of("pins").cells.index[1:]))
        self.assertEqual(len(results.damage), 2)  # the line, and the file

    def test_a_table_that_is_not_there_is_no_damage_but_said(self):
        (self.folder / "results.csv").unlink()
        with self.assertWarnsRegex(UserWarning, "results.csv: there is no such file: columns have no units"):
            cells = kreisel.load(self.folder).cells
        self.assertEqual(cells["final.t"].iloc[0], 0.5)

    def test_the_program_says_the_same(self):
        """All but samples, which the program reads at once."""
        folder = copy_of("orders", self.folder.parent)
        for name, at in (("results.jsonl", 5000), ("results.csv", 300), ("geometry.json", 20)):
            (folder / name).write_bytes(changed((folder / name).read_bytes(), at))
        reference, journal = first_of(folder, "references/*.json"), folder / "journal.jsonl"
        reference.write_bytes(reference.read_bytes()[:-5])
        journal.write_bytes(journal.read_bytes()[:-700])
        lines = folder / "results.jsonl"
        lines.write_bytes(lines.read_bytes()[:-1].rpartition(b"\n")[0] + b"\n")
        ran = subprocess.run([os.environ["KREISEL"], "table", folder], capture_output=True, text=True)
        self.assertEqual(ran.returncode, 3)
        with self.assertRaises(kreisel.DamagedResults) as caught:
            kreisel.load(folder)
        said = [line for line in ran.stderr.splitlines() if "damaged" in line]
        self.assertEqual(sorted(line.replace(f"{folder}/", "") for line in said),
                         sorted(line.replace(f"{folder}/", "") for line in caught.exception.damage))
        self.assertEqual(len(said), 7, ran.stderr)


class Formats(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = copy_of("timed", scratch.name)
        self.file = self.folder / "manifest.json"
        self.manifest = json.loads(self.file.read_text())
        del self.manifest["sum"]

    def test_this_format_is_read(self):
        self.file.write_bytes(with_sum(self.manifest))
        self.assertEqual(len(kreisel.load(self.folder).cells), 2)

    def test_a_later_one_is_refused(self):
        self.file.write_bytes(with_sum({**self.manifest, "format": 3}))
        with self.assertRaisesRegex(kreisel.FormatError, "expected a results folder of format 2, got format 3"):
            kreisel.load(self.folder)

    def test_an_earlier_one_is_refused(self):
        del self.manifest["files"]
        self.file.write_text(json.dumps(self.manifest))
        with self.assertRaisesRegex(kreisel.FormatError, "got format 1"):
            kreisel.load(self.folder)

    def test_a_folder_without_a_manifest_is_refused(self):
        self.file.unlink()
        with self.assertRaisesRegex(kreisel.FormatError, "without manifest.json"):
            kreisel.load(self.folder)

    def test_a_manifest_without_its_sum_is_damaged(self):
        self.file.write_text(json.dumps(self.manifest))
        with self.assertRaisesRegex(kreisel.DamagedResults, "manifest.json: damaged: it has no sum"):
            kreisel.load(self.folder)

    def test_a_folder_without_results_is_told_apart(self):
        (self.folder / "results.jsonl").unlink()
        for folder in (self.folder, Path("nowhere")):
            with self.assertRaisesRegex(kreisel.MissingResults, "results.jsonl: cannot be read"):
                kreisel.load(folder)
