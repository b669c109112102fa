# SPDX-License-Identifier: BSD-3-Clause
"""Figures show the numbers of the results, in the style of the gnuplot figures."""
import os
import re
import shutil
import subprocess
import tempfile
import unittest

import numpy as np

import kreisel
from kreisel import style
from kreisel.curves import Curve, FigureData, Panel
from kreisel.labels import matplotlib_text, plain_text
from kreisel.places import HeatFigure, HeatMap, SpaceFigure
from kreisel.plots import draw_figure
from small import ROOT, copy_of, results_of

STYLE = (ROOT / "plots/gnuplot/style.gp").read_text()
# Point types of gnuplot.
MARKS = {6: "o", 4: "s", 8: "^", 10: "v", 12: "D", 2: "x", 1: "+", 14: "p", 3: (8, 2, 0)}


def array_of(name):
    return re.search(rf"^array {name}\[\d+\] = \[(.*)\]$", STYLE, re.MULTILINE)[1].split(", ")


class Style(unittest.TestCase):
    def test_colours_marks_and_dashes_are_those_of_gnuplot(self):
        self.assertEqual(style.COLOURS, tuple(colour.strip("'") for colour in array_of("colour")))
        self.assertEqual(style.MARKS, tuple(MARKS[int(mark)] for mark in array_of("mark")))
        types = dict(re.findall(r"^set dashtype (\d+) \((.*)\)$", STYLE, re.MULTILINE))
        lengths = [tuple(map(int, types[number].split(", "))) if number in types else ()
                   for number in array_of("dashes")]
        self.assertEqual(style.DASHES, tuple(lengths))

    def test_curves_take_them_in_the_same_order(self):
        rule = ("lc rgb colour[1 + (i - 1) % 7] pt mark[1 + (i - 1) % 9] ps 0.65 lw 1.3 "
                "dt dashes[1 + ((i - 1) + (i - 1) / 7) % 5]")
        self.assertIn(rule, STYLE)
        for i in range(1, 64):
            drawn = style.line_style(i, True)
            dashes = style.DASHES[((i - 1) + (i - 1) // 7) % 5]
            self.assertEqual((drawn["color"], drawn["marker"], drawn["linestyle"]),
                             (style.COLOURS[(i - 1) % 7], style.MARKS[(i - 1) % 9], (0, dashes) if dashes else "-"))
        self.assertNotIn("marker", style.line_style(1, False))

    def test_colours_of_places_and_times_are_those_of_gnuplot_and_of_the_page(self):
        for script in ("heat_map.gp", "space.gp"):
            text = (ROOT / "plots/gnuplot" / script).read_text()
            palette = re.search(r"^ *set palette defined \((.*)\)$", text, re.MULTILINE)[1]
            self.assertEqual(style.PALETTE, tuple(re.findall(r"#\w{6}", palette)))
        page = re.search(r"const viridis = \[(.*?)\];", (ROOT / "plots/report/web/heat.js").read_text(), re.DOTALL)[1]
        colours = ["#%02x%02x%02x" % tuple(map(int, one.split(","))) for one in re.findall(r"\[([\d, ]+)\]", page)]
        self.assertEqual(style.PALETTE, tuple(colours))

    def test_guides_are_those_of_gnuplot(self):
        for number, ours in ((100000, style.GUIDE), (100001, style.GRID)):
            self.assertIn(f"set style line {number} lc rgb '{ours['color']}'", STYLE)

    def test_lines_of_one_colour_bear_marks_where_the_program_says(self):
        import matplotlib.pyplot as plt

        self.addCleanup(plt.close, "all")
        x = np.linspace(1, 2, 9)
        curves = Curve("a", 1, x, x, (), (1, 5)), Curve("b", 8, x, x, (), (3, 7)), Curve("c", 2, x, x)
        lines = draw_figure(FigureData("f", "", "", 1, False,
                                       (Panel("", "", "", False, False, False, curves, (), ()),))).axes[0].get_lines()
        self.assertEqual([(line.get_marker(), line.get_markevery()) for line in lines],
                         [("o", [1, 5]), ("p", [3, 7]), ("None", None)])

    def test_titles_of_panels_do_not_meet(self):
        import matplotlib.pyplot as plt

        self.addCleanup(plt.close, "all")
        title = ", ".join(f"rkmk/method{i}" for i in range(6))
        curve = Curve("a", 1, np.ones(2), np.ones(2)),
        panel = Panel(title, "", "", True, True, False, curve, (), ())
        figure = draw_figure(FigureData("f", "", "", 2, True, (panel, panel)))
        figure.canvas.draw()
        first, second = (ax.title.get_window_extent() for ax in figure.axes)
        self.assertTrue(first.x0 >= 0 and first.x1 < second.x0 and second.x1 <= figure.bbox.x1)

    def test_labels(self):
        for label, text in (("|x − x_{ref}| [m]", r"|x − x$_{\mathrm{ref}}$| [m]"),
                            (r"heavy\_top: 4.02 ± 0.02", "heavy_top: 4.02 ± 0.02"),
                            ("∝ t^{0.50 ± 0.01}", r"∝ t$^{\mathrm{0.50\ ±\ 0.01}}$"),
                            ("|A^T ω_1 A|", r"|A$^{\mathrm{T}}$ ω$_{\mathrm{1}}$ A|"),
                            ("5 $ a", r"5 \$ a"), ("a_", "a_"), ("{x}", "x"), (r"\_a", r"$\_$a")):
            self.assertEqual(matplotlib_text(label), text)

    def test_names_are_shown_as_they_are(self):
        import matplotlib.pyplot as plt

        self.addCleanup(plt.close, "all")
        name = "a_b^c $x_1$ {d}"
        ax = plt.figure().add_subplot()
        ax.plot([1, 2], label=plain_text("_" + name))
        ax.legend()
        text = ax.text(0, 0, plain_text(name))
        as_mathematics = ax.text(0, 0, name)
        letters = ax.text(0, 0, name.replace("$", "S"))
        ax.figure.canvas.draw()
        self.assertEqual(len(ax.get_legend().get_texts()), 1)
        wide, as_read, as_letters = (one.get_window_extent().width for one in (text, as_mathematics, letters))
        self.assertLess(abs(wide - as_letters), 0.1 * as_letters)
        self.assertGreater(abs(as_read - as_letters), 0.1 * as_letters)

    def test_places_and_space_have_the_sizes_of_the_config(self):
        one = HeatMap("error", np.array([[1e-3, 1e-4]]))
        sizes = {"width": 12.0, "font_size": 9.0}
        heat = draw_figure(HeatFigure("map", "", "", "h [s]", "method", ("1", "2"), ("rkmk/rk4",), True, (one,),
                                      axes_height=3.5, **sizes))
        line = np.linspace(0, 1, 9)
        space = draw_figure(SpaceFigure("path", "", "", (0,) * 3, (1,) * 3, (60, 30), line,
                                        np.stack([line, line, line], axis=1), (), **sizes))
        for figure in (heat, space):
            self.assertAlmostEqual(figure.get_figwidth() * 2.54, 12)
            self.assertEqual({text.get_fontsize() for text in figure.axes[0].get_xticklabels()}, {9})
        page, axes = heat.get_size_inches()[1] * 2.54, heat.axes[0].get_position()
        self.assertAlmostEqual(axes.height * page, 3.5)

    def test_texts_of_places_do_not_meet(self):
        import matplotlib.pyplot as plt

        self.addCleanup(plt.close, "all")
        values = tuple(f"rkmk/implicit_midpoint, number {i}" for i in range(4))
        one = HeatMap("m", np.arange(1.0, 9).reshape(2, 4))
        maps = draw_figure(HeatFigure("map", "title $ of_x", "", "method", "h [s]", values, ("1", "2"), True, (one, one)))
        line = np.linspace(0, 1, 9)
        space = draw_figure(SpaceFigure("path", "", "", (-0.002,) * 3, (0.002,) * 3, (60, 30), line,
                                        0.002 * np.outer(line, [1, -1, 1]), ()))
        for figure in (maps, space):
            figure.canvas.draw()
            page, axes = figure.bbox, figure.axes
            boxes = [ax.get_tightbbox() for ax in axes]
            for box in boxes:
                self.assertTrue(box.x0 >= 0 and box.y0 >= 0 and box.x1 <= page.x1 and box.y1 <= page.y1, box)
            self.assertFalse([(i, k) for i, a in enumerate(boxes) for k, b in enumerate(boxes) if i < k and a.overlaps(b)])
        self.assertEqual(maps._suptitle.get_text(), r"title \$ of_x")
        self.assertEqual({text.get_rotation() for text in maps.axes[0].get_xticklabels()}, {40})
        for axis in (getattr(space.axes[0], f"{name}axis") for name in "xyz"):
            label = axis.label.get_window_extent()
            others = [text.get_window_extent() for text in axis.get_ticklabels()] + [space.axes[1].get_tightbbox()]
            self.assertFalse(any(label.overlaps(other) for other in others), axis.label.get_text())
        short = draw_figure(HeatFigure("map", "", "", "steps", "h [s]", ("64", "128"), ("1",), False,
                                       (HeatMap("m", np.array([[0.0, 1.0]])),)))
        short.canvas.draw()
        first, second = (text.get_window_extent() for text in short.axes[0].get_xticklabels())
        self.assertLess(first.x1, second.x0)


class Curves(unittest.TestCase):
    def setUp(self):
        import matplotlib.pyplot as plt

        self.addCleanup(plt.close, "all")
        self.results = results_of("orders")
        self.figures = kreisel.read_figures(self.results)

    def test_points_of_the_program_are_numbers_of_the_cells(self):
        cells = self.results.cells_as("double")
        cells = cells[(cells["status"] == "ok") & cells["error.position"].notna()]
        known = {(x, y) for name in ("h", "tolerance") for x, y in zip(cells[name], cells["error.position"])}
        points = [point for panel in self.figures["errors"].panels for curve in panel.curves
                  for point in zip(curve.x, curve.y)]
        self.assertGreater(len(points), 20)
        self.assertLessEqual(set(points), known)

    def test_a_figure_draws_the_curves_of_the_program(self):
        for name in ("errors", "defects"):
            data = self.figures[name]
            drawn = draw_figure(data)
            drawn.canvas.draw()
            self.assertEqual(len(drawn.axes), len(data.panels))
            for ax, panel in zip(drawn.axes, data.panels):
                lines = ax.get_lines()[len(panel.guides):]
                self.assertEqual(len(lines), len(panel.curves))
                for line, curve in zip(lines, panel.curves):
                    drawable = np.where(curve.y > 0, curve.y, np.nan)
                    np.testing.assert_array_equal(line.get_ydata(), drawable)
                    np.testing.assert_array_equal(line.get_xdata(), np.where(curve.x > 0, curve.x, np.nan))
                    self.assertEqual(line.get_color(), style.line_style(curve.style, False)["color"])
                self.assertEqual((ax.get_xscale(), ax.get_yscale()), ("log", "log"))
                self.assertEqual([text.get_text() for text in ax.get_legend().get_texts()],
                                 [matplotlib_text(curve.label) for curve in panel.curves])

    def test_legends_lie_on_the_page(self):
        line = np.array([1.0, 2.0])
        long = tuple(Curve(f"baumgarte alpha=5 beta=5, SO3xR3, {i}: ∝ t^{{0.03 ± 0.08}}", i, line, line)
                     for i in range(1, 16))
        raised = FigureData("raised", "", "", 2, False, (Panel("", "", "", True, True, False, long, (), ()),) * 3)
        for data in (self.figures["errors"], self.figures["defects"], raised):
            drawn = draw_figure(data)
            drawn.canvas.draw()
            for ax in drawn.axes:
                box = ax.get_legend().get_window_extent()
                self.assertGreaterEqual(box.x0, 0)
                self.assertGreaterEqual(box.y0, 0)
                self.assertLessEqual(box.x1, drawn.bbox.x1)
                others = [other.get_window_extent() for other in drawn.axes]
                self.assertFalse([other for other in others if box.overlaps(other)])

    @unittest.skipUnless(shutil.which("gnuplot"), "there is no gnuplot; tools/setup figures installs it")
    def test_the_curves_are_those_that_gnuplot_draws(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = copy_of("orders", scratch)
            ran = subprocess.run([os.environ["KREISEL"], "plot", folder], capture_output=True, text=True)
            self.assertEqual(re.findall(r"^not drawn: (\w+)", ran.stderr, re.MULTILINE), ["path"])
            for name in ("errors", "defects"):
                data = self.figures[name]
                curves = [curve for panel in data.panels for curve in panel.curves]
                for number, curve in enumerate(curves, 1):
                    text = (folder / f"plotdata/{data.name}.{number}.dat").read_text()
                    points = np.array([line.split() for line in text.splitlines() if line], dtype=float)
                    drawn = np.column_stack([curve.x, curve.y])
                    drawn = drawn[(drawn > 0).all(axis=1)] if len(drawn) else np.full((1, 2), np.nan)
                    np.testing.assert_array_equal(points, drawn if len(drawn) else np.full((1, 2), np.nan))

    def test_a_heat_map_has_the_metrics_of_the_cells_in_its_places(self):
        data = self.figures["map"]
        cells = self.results.cells_as("double")
        cells = cells[(cells["precision"] == "double") & (cells["label"] == "slow")
                      & (cells["formulation"] == "SO3xR3")]
        self.assertEqual(data.x_values, ("64", "128", "256", "512"))
        self.assertEqual(len(data.maps), 2)
        for one, metric in zip(data.maps, ("error.position", "error.omega")):
            for steps, column in zip(data.x_values, one.values.T):
                known = set(cells.loc[(cells["steps"] == int(steps)) & cells[metric].notna(), metric])
                self.assertEqual(set(column[np.isfinite(column)]), known)
        drawn = draw_figure(data)
        drawn.canvas.draw()
        self.assertEqual(len(drawn.axes), 4)  # each with its scale
        np.testing.assert_array_equal(drawn.axes[0].get_images()[0].get_array().filled(np.nan), data.maps[0].values)
        shown = [text.get_text() for text in drawn.axes[0].texts]
        self.assertEqual(shown, [f"{value:.1e}" for value in data.maps[0].values.flat if np.isfinite(value)])

    def test_a_path_in_space_is_that_of_the_samples(self):
        data = self.figures["one_path"]
        cells = self.results.cells
        cell = cells.index[(cells["steps"] == 64) & (cells["precision"] == "double") & (cells["label"] == "slow")
                           & (cells["formulation"] == "SO3xR3") & (cells["method"] == "rkmk/dopri5")]
        samples = self.results.trajectory(cell[0])
        x = samples[[f"top.x{k}" for k in (1, 2, 3)]].to_numpy()
        at = np.searchsorted(data.t, samples.index.to_numpy() - 1e-6)
        self.assertGreater(len(data.t), len(samples))  # smooth between samples
        np.testing.assert_allclose(data.t[at], samples.index, rtol=1e-5)
        np.testing.assert_allclose(data.path[at], x, rtol=1e-5, atol=1e-8)
        drawn = draw_figure(data)
        drawn.canvas.draw()
        self.assertEqual((drawn.axes[0].elev, drawn.axes[0].azim), (20, -70))
        self.assertEqual(len(drawn.axes[0].collections[0].get_array()), len(data.t) - 1)

    def test_a_figure_that_is_not_drawn_says_why(self):
        with self.assertRaisesRegex(kreisel.NotDrawn, "path: .*select"):
            kreisel.plot_figure(self.results, "path")
        with self.assertRaisesRegex(KeyError, "expected a figure of the experiment .*, got 'none'"):
            kreisel.plot_figure(self.results, "none")
        with self.assertRaisesRegex(kreisel.NotDrawn, "the config asks for no figure"):
            kreisel.plot_figure(results_of("pins"))


class OfCells(unittest.TestCase):
    def setUp(self):
        import matplotlib.pyplot as plt

        self.addCleanup(plt.close, "all")
        self.results = results_of("orders")

    def test_convergence_draws_each_combination(self):
        cells = self.results.cells
        cells = cells[(cells["method"] == "rkmk/kutta3") & (cells["formulation"] == "SO3xR3")]
        ax = kreisel.plot_convergence(cells, "error.omega")
        ax.figure.canvas.draw()
        self.assertEqual((ax.get_xlabel(), ax.get_ylabel()), ("h [s]", "error.omega [rad/s]"))
        lines = {line.get_label(): line for line in ax.get_lines()}
        self.assertEqual(len(lines), 8)  # precisions, problems, coordinates
        one = cells[(cells["label"] == "slow") & (cells["precision"] == "quad") & (cells["status"] == "ok")
                    & (cells["option.coordinates"] == "cayley")].dropna(subset=["error.omega"]).sort_values("h")
        np.testing.assert_array_equal(lines["slow, cayley, quad"].get_xdata(), one["h"])
        np.testing.assert_array_equal(lines["slow, cayley, quad"].get_ydata(), one["error.omega"].astype(float))

    def test_convergence_names_failures_and_leaves_out_what_was_skipped(self):
        cells = self.results.cells
        failed = cells[(cells["steps"] == 2) & (cells["label"] == "heavy_top") & (cells["precision"] == "double")]
        ax = kreisel.plot_convergence(failed)
        status = failed[failed["status"] != "skipped"]["status"]
        self.assertEqual(len(ax.get_lines()), len(status))
        for line, word in zip(ax.get_lines(), status):
            self.assertEqual(line.get_label().endswith(f": {word}"), word != "ok")

    def test_convergence_over_cost_and_tolerance(self):
        ok = self.results.cells[self.results.cells["status"] == "ok"]
        self.assertEqual(kreisel.plot_convergence(ok, x="cost.evaluations").get_xlabel(), "cost.evaluations")
        chosen = ok[ok["tolerance"].notna()]
        self.assertEqual(kreisel.plot_convergence(chosen).get_xlabel(), "tolerance")
        with self.assertRaisesRegex(KeyError, "expected a column of the cells, got 'error.posiiton'"):
            kreisel.plot_convergence(ok, "error.posiiton")

    def test_drift_draws_running_maxima(self):
        cells = self.results.cells
        chosen = cells.index[(cells["steps"] == 64) & (cells["method"] == "rkmk/kutta3") & (cells["status"] == "ok")
                             & (cells["formulation"] == "SO3xR3")]
        ax = kreisel.plot_drift(self.results, "defect.velocity", chosen)
        ax.figure.canvas.draw()
        self.assertEqual(ax.get_ylabel(), "max defect.velocity [m/s]")
        self.assertEqual(len(ax.get_lines()), len(chosen))
        for line, cell in zip(ax.get_lines(), chosen):
            values = self.results.trajectory(cell, "double")["defect.velocity.max"].to_numpy()
            np.testing.assert_array_equal(line.get_ydata(), np.where(values > 0, values, np.nan))
        self.assertGreater(len(kreisel.plot_drift(self.results).get_lines()), len(chosen))
        with self.assertRaisesRegex(KeyError, "expected a sampled metric, got 'defect.velocitty'"):
            kreisel.plot_drift(self.results, "defect.velocitty")

    def test_trajectory_draws_columns_of_one_unit(self):
        results = results_of("pins")
        ax = kreisel.plot_trajectory(results, 1)
        self.assertEqual([line.get_label() for line in ax.get_lines()], ["rod.x1", "rod.x2", "rod.x3"])
        np.testing.assert_array_equal(ax.get_lines()[1].get_ydata(), results.trajectory(1)["rod.x2"])
        self.assertEqual(ax.get_ylabel(), "[m]")
        with self.assertRaisesRegex(ValueError, "expected columns of one unit, got m, m/s"):
            kreisel.plot_trajectory(results, 1, ["rod.x1", "rod.v1"])

    def test_legends_name_what_differs(self):
        cells = self.results.cells
        cells = cells[(cells["status"] == "ok") & (cells["label"] == "slow") & (cells["precision"] == "double")
                      & (cells["formulation"] == "SO3xR3")]
        self.assertEqual([line.get_label() for line in kreisel.plot_convergence(cells).get_lines()],
                         ["rkmk/kutta3, exp", "rkmk/kutta3, cayley", "rkmk/dopri5", "rkmk/dopri5, pi"])
        one = cells[cells["method"] == "rkmk/kutta3"].drop_duplicates("method")
        self.assertEqual([line.get_label() for line in kreisel.plot_convergence(one).get_lines()], ["rkmk/kutta3"])

    def test_axes_of_the_caller_are_drawn_into(self):
        import matplotlib.pyplot as plt

        ax = plt.subplots()[1]
        self.assertIs(kreisel.plot_trajectory(results_of("pins"), 0, ax=ax), ax)
