# SPDX-License-Identifier: GPL-3.0-or-later
"""Experiments from Python are those of the program."""
import json
import unittest

import radcert as rc

from module import ModuleTest, without

TWO_INSETS = {
    "schema": "radcert/experiment/1",
    "name": "two_insets",
    "base": {"surface": {"name": "cube"}, "triangulation": {"levels": [0, 1]}, "reflectivity": "1/2",
             "solution": "x*y + z"},
    "vary": {"basis": [{"family": "inset", "degree": 1, "alpha": "1/6"}, {"family": "inset", "degree": 1, "alpha": "1/10"}]},
}


class Experiments(ModuleTest):
    def test_the_numbers_are_those_of_the_program(self):
        found = rc.experiment(TWO_INSETS)
        file = self.folder / "two_insets.json"
        file.write_text(json.dumps(TWO_INSETS), encoding="utf-8")
        theirs = self.program("experiment", file)
        for ours in (found.to_json(), rc.experiment(file).to_json()):
            self.assertEqual(without(ours, "command", "timing"), without(theirs, "command", "timing"))
        self.assertEqual(len(found.names), 2)
        alone = rc.Problem("cube", reflectivity="1/2", solution="x*y + z", levels=[0, 1], basis=rc.inset(1, "1/6")).solve()
        self.assertEqual(found.solutions[0].errors["node_error"].value.tolist(), alone.errors["node_error"].value.tolist())
        found.to_csv(self.folder / "errors.csv")
        found.to_latex(self.folder / "table.tex")
        self.assertIn("tabular", (self.folder / "table.tex").read_text(encoding="utf-8"))

    def test_a_key_may_hold_numbers_of_python(self):
        x, y, z = rc.xyz()
        document = {**TWO_INSETS, "base": {**TWO_INSETS["base"], "solution": x * y + z, "reflectivity": rc.Q(1, 2)}}
        self.assertEqual(rc.experiment(document).to_json()["combinations"], rc.experiment(TWO_INSETS).to_json()["combinations"])

    def test_wrong_input_is_named_with_its_place(self):
        wrong = {**TWO_INSETS, "vary": {"basis": [{"family": "inset", "degree": 1, "alpha": "1/3"}]}}
        self.assertEqual(self.refused(lambda: rc.experiment(wrong)).place, "/vary/basis/0/alpha")
        self.refused(lambda: rc.experiment({**TWO_INSETS, "vary": {}}), "/vary")
        self.refused(lambda: rc.experiment({**TWO_INSETS, "name": float("nan")}), "/name")


if __name__ == "__main__":
    unittest.main()
