# SPDX-License-Identifier: BSD-3-Clause
"""What is read is what was written: to the last bit, under the names and with the units of results.csv."""
import csv
import unittest
from fractions import Fraction

import numpy as np
import pandas as pd

import kreisel
from kreisel.columns import split_title
from kreisel.samples import sample_table
from small import bits, results_of


def table_of(results):
    with (results.folder / "results.csv").open(newline="") as file:
        titles, *rows = csv.reader(file)
    return titles, rows


def assert_nearest(case, number, text, what):
    """The text has more digits than 113 bits need: the nearest number is the one that was written."""
    sign, mantissa, exponent, _ = number._mpf_
    value = (-1) ** sign * Fraction(int(mantissa)) * Fraction(2) ** exponent
    case.assertLessEqual(abs(value - Fraction(text)), abs(value) / 2 ** 113, what)


class Cells(unittest.TestCase):
    def assert_same(self, value, text, what):
        if text == "":
            self.assertTrue(pd.isna(value) or value == "", what)
        elif isinstance(value, (float, np.floating)):
            self.assertEqual(bits(value), bits(text), what)
        elif isinstance(value, (bool, np.bool_)):
            self.assertEqual(str(value).lower(), text, what)
        else:
            self.assertEqual(str(value), text, what)

    def test_every_field_is_the_one_of_the_table(self):
        for name in ("orders", "pins", "timed"):
            results = results_of(name)
            titles, rows = table_of(results)
            cells = results.cells.reset_index()
            self.assertEqual(len(cells), len(rows))
            self.assertGreater(len(rows), 1)
            for place, row in enumerate(rows):
                for column, title, text in zip(cells.columns, titles, row):
                    self.assert_same(cells[column].iloc[place], text, (name, place, title))

    def test_columns_have_the_names_and_units_of_the_table(self):
        for name in ("orders", "pins", "timed"):
            cells = results_of(name).cells
            titles = table_of(results_of(name))[0]
            self.assertEqual([split_title(column)[0] for column in ["cell", *cells.columns]],
                             [split_title(title)[0] for title in titles])
            units = dict(zip(cells.columns, (split_title(title)[1] for title in titles[1:])))
            self.assertEqual(cells.attrs["units"], {column: unit for column, unit in units.items() if unit})
        units = results_of("orders").cells.attrs["units"]
        self.assertEqual((units["h"], units["error.omega"], units["parameter.omega.2"]), ("s", "rad/s", "rad/s"))

    def test_one_name_with_two_units_makes_two_columns(self):
        cells = results_of("pins").cells
        force, torque = cells["final.lambda.pin.2 [N]"], cells["final.lambda.pin.2 [N m]"]
        self.assertEqual(list(force.notna()), [True, False])
        self.assertEqual(list(torque.notna()), [False, True])
        self.assertEqual(cells.attrs["units"]["final.lambda.pin.2 [N m]"], "N m")
        self.assertEqual(cells.attrs["units"]["final.lambda.pin.1"], "N")

    def test_types_are_those_of_the_quantities(self):
        cells = results_of("orders").cells
        self.assertEqual(str(cells["steps"].dtype), "Int64")  # none where steps are chosen
        self.assertEqual(str(cells["h"].dtype), "float64")
        self.assertEqual(str(cells["parameter.mass"].dtype), "float64")
        double = cells[cells["precision"] == "double"]["error.position"].dropna()
        quad = cells[cells["precision"] == "quad"]["error.position"].dropna()
        self.assertEqual({type(value) for value in double}, {float})
        self.assertEqual({type(value) for value in quad}, {str})

    def test_negative_zero_keeps_its_sign(self):
        written = [text for row in table_of(results_of("orders"))[1] for text in row if text == "-0"]
        self.assertTrue(written)
        zeros = results_of("orders").cells_as("double").select_dtypes("float64").to_numpy()
        self.assertGreaterEqual(int(np.sum((zeros == 0) & np.signbit(zeros))), len(written))

    def test_failed_cells_say_why(self):
        failed = results_of("orders").failed
        self.assertTrue(len(failed))
        self.assertFalse(set(failed["status"]) & {"ok", "skipped"})
        self.assertTrue(failed["detail"].notna().all() and failed["t_reached"].notna().all())
        self.assertIn("skipped", set(results_of("orders").cells["status"]))


class QuadNumbers(unittest.TestCase):
    def test_mpmath_keeps_every_digit(self):
        results = results_of("orders")
        text, exact = results.cells, results.cells_as("mpmath")
        quad = text.index[text["precision"] == "quad"]
        count = 0
        for name in [name for name in text if name.startswith(("error.", "final.", "defect."))]:
            for cell in quad:
                if pd.isna(text.at[cell, name]):
                    continue
                assert_nearest(self, exact.at[cell, name], text.at[cell, name], (cell, name))
                count += 1
        self.assertGreater(count, 500)

    def test_the_precision_of_others_does_not_matter(self):
        import mpmath

        with mpmath.workdps(5):
            number = results_of("orders").final(self.quad_cell(), "mpmath").bodies["top"].x[0]
        self.assertEqual(number.context.prec, 113)
        assert_nearest(self, number, results_of("orders").final(self.quad_cell()).bodies["top"].x[0], "x")

    def test_doubles_are_the_nearest(self):
        results = results_of("orders")
        self.assertEqual(bits(results.cells_as("double").at[self.quad_cell(), "error.position"]),
                         bits(float(results.cells.at[self.quad_cell(), "error.position"])))

    def test_another_choice_is_refused(self):
        with self.assertRaisesRegex(ValueError, 'expected "text", "mpmath" or "double", got \'exact\''):
            results_of("orders").cells_as("exact")

    @staticmethod
    def quad_cell():
        cells = results_of("orders").cells
        return cells.index[(cells["precision"] == "quad") & (cells["status"] == "ok")][0]


class States(unittest.TestCase):
    def test_the_final_state_is_the_one_of_the_table(self):
        for name in ("orders", "pins"):
            results = results_of(name)
            titles, rows = table_of(results)
            for row in rows:
                named = {split_title(title)[0]: text for title, text in zip(titles, row) if text}
                if "final.t" not in named:
                    with self.assertRaisesRegex(kreisel.MissingResults, "has no final state; its status is"):
                        results.final(row[0])
                    continue
                state = results.final(row[0])
                self.assert_numbers(state, named)

    def assert_numbers(self, state, named):
        same, drives = self.assertEqual, 0
        for body, part in state.bodies.items():
            for i in range(3):
                for quantity in ("x", "v", "omega"):
                    text = named[f"final.{body}.{quantity}.{i + 1}"]
                    same(bits(getattr(part, quantity)[i]), bits(text))
                for j in range(3):
                    same(bits(part.R[i, j]), bits(named[f"final.{body}.R.{i + 1}.{j + 1}"]))
        for multiplier, value in state.multipliers.items():
            same(bits(value), bits(named[f"final.{multiplier}"]))
        for joint, reaction in state.reactions.items():
            for i in range(3):
                same(bits(reaction.torque[i]), bits(named[f"final.reaction.{joint}.torque.{i + 1}"]))
            for quantity, value in (("force", reaction.driving_force), ("torque", reaction.driving_torque)):
                same(value is not None, f"final.drive.{joint}.{quantity}" in named)
                if value is not None:
                    drives += 1
                    same(bits(value), bits(named[f"final.drive.{joint}.{quantity}"]))
        for i, theta in enumerate(state.theta):
            same(bits(theta), bits(named[f"final.theta.{i + 1}"]))
            same(str(state.turns[i]), named[f"final.turns.{i + 1}"])
        expected = [name for name in named if name.startswith("final.")]
        same(1 + 18 * len(state.bodies) + len(state.multipliers) + 6 * len(state.reactions) + 2 * len(state.theta) + drives,
             len(expected))

    def test_units_of_multipliers(self):
        self.assertEqual(results_of("pins").final(1).units["lambda.pin.2"], "N m")

    def test_a_cell_is_a_row_a_place_or_a_hash(self):
        results = results_of("pins")
        cells = results.cells
        by_hash = results.record(cells.index[1])
        self.assertIs(results.record(1), by_hash)
        self.assertIs(results.record(-1), by_hash)
        self.assertIs(results.record(np.int64(1)), by_hash)
        self.assertIs(results.record(cells.iloc[1]), by_hash)
        with self.assertRaisesRegex(KeyError, "expected a cell of .*pins.*, got 'top'"):
            results.record("top")
        with self.assertRaises(IndexError):
            results.record(2)


class Samples(unittest.TestCase):
    def test_every_sample_is_the_one_of_the_file(self):
        results = results_of("orders")
        cells = results.cells
        for cell in cells.index[cells["trajectory"].notna()]:
            with (results.folder / cells.at[cell, "trajectory"]).open(newline="") as file:
                titles, *rows = list(csv.reader(file))
            samples = results.trajectory(cell)
            self.assertEqual(samples.attrs["units"], dict(map(split_title, titles)))
            quad = cells.at[cell, "precision"] == "quad"
            for row, (t, values) in zip(rows, samples.iterrows()):
                read = [t, *values]
                for title, value, text in zip(titles, read, row):
                    if text == "":
                        self.assertTrue(pd.isna(value), title)
                    elif quad:
                        self.assertEqual(value, text, title)
                    else:
                        self.assertEqual(bits(value), bits(text), title)
            self.assertEqual(len(samples), len(rows))

    def test_samples_of_quad_cells_are_converted(self):
        results, cell = results_of("orders"), QuadNumbers.quad_cell()
        text = results.trajectory(cell)
        exact, double = results.trajectory(cell, "mpmath"), results.trajectory(cell, "double")
        for name in ("top.x1", "defect.orthogonality.max"):
            for t in range(len(text)):
                assert_nearest(self, exact[name].iloc[t], text[name].iloc[t], name)
                self.assertEqual(bits(double[name].iloc[t]), bits(text[name].iloc[t]))
        self.assertEqual(double.index[-1], results.record(cell)["t_end"])

    def test_what_was_not_measured_is_missing(self):
        written = b"t [s],theta [rad]\n0,\n1,-0\n"
        for quad_cell, quad in ((False, "text"), (True, "text"), (True, "mpmath"), (True, "double")):
            theta = sample_table(written, quad_cell, quad)["theta"]
            self.assertEqual(list(theta.isna()), [True, False])
            self.assertEqual(float(theta.iloc[1]), 0)
        self.assertEqual(bits(sample_table(written, False, "text")["theta"].iloc[1]), bits(-0.0))

    def test_rotations_and_vectors_are_those_of_the_final_state(self):
        results = results_of("pins")
        samples, state = results.trajectory(1), results.final(1)
        np.testing.assert_array_equal(kreisel.rotations(samples, "rod")[-1], state.bodies["rod"].R)
        np.testing.assert_array_equal(kreisel.vectors(samples, "rod", "omega")[-1], state.bodies["rod"].omega)

    def test_a_cell_without_samples_says_so(self):
        with self.assertRaisesRegex(kreisel.MissingResults, "has no samples"):
            results_of("timed").trajectory(0)


class Times(unittest.TestCase):
    def test_times_are_those_of_the_journal(self):
        results = results_of("timed")
        self.assertEqual(list(results.times.index), list(results.cells.index))
        journal = (results.folder / "journal.jsonl").read_text()
        for value in results.times["run_s"]:
            self.assertGreater(value, 0)
            self.assertIn(f'"run_s":{value!r}', journal)
        self.assertEqual(results.times.attrs["units"]["run_s"], "s")
        self.assertNotIn("run_s", results_of("orders").times)
