# SPDX-License-Identifier: BSD-3-Clause
"""The notebook of docs/ runs from its first cell to its last."""
import os
import tempfile
import unittest

import nbformat
from nbclient import NotebookClient

from small import ROOT

FILE = ROOT / "docs/from_config_to_figure.ipynb"


class Notebook(unittest.TestCase):
    def test_it_leads_from_a_config_to_figures(self):
        notebook = nbformat.read(FILE, as_version=4)
        environment = {name: value for name, value in os.environ.items() if name != "MPLBACKEND"}  # inline, as by hand
        with tempfile.TemporaryDirectory() as folder:
            NotebookClient(notebook, timeout=300, kernel_name="python3",
                           resources={"metadata": {"path": folder}}).execute(env=environment)
        outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
        self.assertFalse([output for output in outputs if output.output_type == "error"])
        pictures = [output for output in outputs if "image/png" in output.get("data", {})]
        self.assertEqual(len(pictures), 3)
        self.assertTrue(any("did you mean" in output.get("text", "") for output in outputs))

    def test_it_is_kept_without_outputs(self):
        for cell in nbformat.read(FILE, as_version=4).cells:
            if cell.cell_type == "code":
                self.assertEqual((cell.outputs, cell.execution_count), ([], None))
