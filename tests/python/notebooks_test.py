# SPDX-License-Identifier: GPL-3.0-or-later
"""Every notebook runs from an empty folder, teaches in text and formulas, and asserts what it says."""
import ast
import json
import subprocess
import sys
import unittest

from module import EXAMPLES, MOST_SECONDS, SOURCE, ModuleTest

RUNNER = SOURCE / "apps" / "site" / "notebook.py"
NOTEBOOKS = sorted((EXAMPLES / "notebooks").glob("*.py"))


def run(notebook, *words):
    return subprocess.run([sys.executable, "-B", RUNNER, notebook, *words], capture_output=True, text=True,
                          timeout=MOST_SECONDS, check=False)


class Notebooks(ModuleTest):
    def test_every_notebook_runs_and_what_it_asserts_holds(self):
        self.assertGreaterEqual(len(NOTEBOOKS), 5)
        for notebook in NOTEBOOKS:
            with self.subTest(notebook.name):
                out = self.folder / "cells.json"
                done = run(notebook, out)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                cells = json.loads(out.read_text(encoding="utf-8"))
                texts = [cell["text"] for cell in cells if cell["kind"] == "text"]
                codes = [cell for cell in cells if cell["kind"] == "code"]
                self.assertTrue(texts[0].startswith("# "))
                self.assertIn("## Try next", texts[-1])
                self.assertTrue(any("$$" in text for text in texts) or "$" in "".join(texts))
                self.assertGreater(sum(bool(cell["printed"]) for cell in codes), 3)
                trees = [ast.parse(cell["code"]) for cell in codes]
                asserts = [node for tree in trees for node in ast.walk(tree) if isinstance(node, ast.Assert)]
                self.assertGreater(len(asserts), 3)

    def test_a_notebook_shows_the_same_in_every_run(self):
        first, second = self.folder / "1.json", self.folder / "2.json"
        for out in (first, second):
            self.assertEqual(run(NOTEBOOKS[4], out).returncode, 0)
        self.assertEqual(first.read_bytes(), second.read_bytes())
        self.assertIn("<svg", first.read_text(encoding="utf-8"))

    def test_a_cell_that_fails_fails_the_run(self):
        notebook = self.folder / "wrong.py"
        notebook.write_text("# %% [markdown]\n# # A title\n\n# %%\nassert 1 == 2\n", encoding="utf-8")
        done = run(notebook)
        self.assertEqual(done.returncode, 1)
        self.assertIn("wrong.py, cell 2", done.stderr)


if __name__ == "__main__":
    unittest.main()
