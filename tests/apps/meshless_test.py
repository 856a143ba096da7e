# SPDX-License-Identifier: GPL-3.0-or-later
"""Problems with meshless bases: the page of the example, what is refused, what is written."""
import json
import os
import shutil
import unittest

import jsonschema

from program import EXAMPLES, ProgramTest

PAGE = os.path.join(EXAMPLES, "06_meshless")


class Meshless(ProgramTest):
    def setUp(self):
        super().setUp()
        shutil.copytree(PAGE, self.folder, dirs_exist_ok=True)
        with open(self.path("problem.json"), encoding="utf-8") as file:
            self.problem = json.load(file)

    def problem_with(self, basis=None, **changes):
        problem = {**self.problem, "triangulation": {"levels": [0]}, **changes}
        if basis is not None:
            problem["basis"] = basis
        return self.write("changed.json", problem)

    def result_of(self, name):
        return json.loads(self.expect(0, "solve", name, "--json", "-"))

    def refused(self, code, *said, **changes):
        done = self.run_program("solve", self.problem_with(**changes))
        self.assertEqual(done.returncode, code, done.stderr)
        for words in said:
            self.assertIn(words, done.stderr.decode())
        self.assertNotIn("nan", done.stdout.decode().lower())

    def test_every_command_of_the_page_works_and_errors_fall_from_level_to_level(self):
        self.expect_commands_of(PAGE, 5)
        result = self.result_of("problem.json")
        sites = [level["unknowns"] for level in result["levels"]]
        self.assertGreater(sites[1], 3 * sites[0])
        self.assertEqual([level["elements"] for level in result["levels"]], sites)
        self.assertEqual([level["mesh_size"] for level in result["levels"]], [0.5, 0.25, 0.125])
        for level in result["levels"]:
            self.assertIsNone(level["discretisation_error"])
        uniform = [level["uniform_error"]["value"] for level in result["levels"]]
        self.assertLess(uniform[2], uniform[0] / 4)
        self.assertGreater(result["orders"]["node_error"]["order"], 0.5)

    def test_defaults_are_written_back_and_read_again(self):
        first = self.result_of(self.problem_with("shepard"))
        self.assertEqual(first["problem"]["basis"], {
            "family": "shepard", "sites": {"uniform": 400, "seed": 1}, "weights": "integrated",
            "coefficients": "as_values"})
        self.write("again.json", first["problem"])
        self.assertEqual(self.result_of("again.json")["levels"], first["levels"])

    def test_the_schema_takes_what_the_program_takes(self):
        schema = json.loads(self.expect(0, "schema", "problem"))
        validator = jsonschema.Draft202012Validator(schema)
        for basis in ("lehtinen", {"family": "shepard"}, {"family": "gaussian", "radius": {"neighbour": 5}},
                      {"family": "meshless", "mother": "exp(-r)", "radius": "absolute", "support": "none"},
                      self.problem["basis"]):
            self.assertTrue(validator.is_valid({**self.problem, "basis": basis}), basis)
        for basis in ("meshless", {"family": "shepard", "radius": {"neighbour": 5}}, {"family": "meshless"},
                      {"family": "meshless", "mother": "spline", "support": 2},
                      {"family": "shepard", "sites": {"seed": 1}}, {"family": "shepard", "weights": "exact"}):
            self.assertFalse(validator.is_valid({**self.problem, "basis": basis}), basis)
            self.assertEqual(self.run_program("solve", self.problem_with(basis)).returncode, 2, basis)

    def test_another_seed_gives_other_sites_and_the_same_seed_the_same(self):
        def error(seed):
            sites = {"poisson_disk": "1/2", "seed": seed}
            return self.result_of(self.problem_with({"family": "shepard", "sites": sites}))["levels"][0]["node_error"]
        self.assertEqual(error(1), error(1))
        self.assertNotEqual(error(1), error(2))

    def test_bad_input_is_refused_by_name(self):
        few = {"family": "lehtinen", "sites": {"uniform": 10}}
        self.refused(2, "/basis", "needs at least 11 sites; there are 10", basis=few)
        self.refused(2, "/basis", "there are 1", basis={"family": "gaussian", "sites": {"poisson_disk": 9}})
        self.refused(2, "/triangulation/levels/0", "219422998235 sites", basis={"family": "shepard", "sites": {"poisson_disk": "1e-5"}})
        self.refused(2, "/basis", "no site is in reach", basis={**self.problem["basis"], "support": "1/10",
                                                                "coefficients": "as_values"})
        self.refused(2, "/reflectivity", "is not below 1", surface={"name": "two_squares"}, reflectivity="1",
                     basis="shepard")
        self.refused(2, "/basis/weights", "allowed: integrated", basis={"family": "shepard", "weights": "exact"})
        self.refused(2, "/solver/name", "is not for meshless bases", solver={"name": "verified"})
        self.refused(2, "/geometry/interpolated", "allowed: exact", geometry={"interpolated": 2})
        self.refused(2, "/basis/separation", "unknown key", basis={"family": "shepard", "separation": 1})

    def test_reflections_that_grow_end_with_1_and_the_reason(self):
        self.refused(1, "the iteration diverges", "spectral radius",
                     basis={"family": "gaussian", "sites": {"poisson_disk": "1/4"}})

    def test_all_files_of_a_solution_are_written_and_cite_the_paper(self):
        self.expect(0, "solve", self.problem_with(), "--out", "out")
        with open(self.path("out/cite.bib"), encoding="utf-8") as file:
            self.assertIn("{psg10,", file.read())
        with open(self.path("out/provenance.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["seed"], self.problem["basis"]["sites"]["seed"])
        with open(self.path("out/nodes.csv"), encoding="utf-8") as file:
            self.assertEqual(len(file.read().splitlines()), 1 + self.result_of("changed.json")["levels"][0]["unknowns"])

    def test_bases_are_listed_and_the_example_runs(self):
        listed = self.expect(0, "list", "bases")
        for name in ("shepard", "gaussian", "lehtinen", "meshless", "poisson_disk", "too_few"):
            self.assertIn(name, listed)
        self.write("example.json", self.expect(0, "example", "meshless"))
        self.expect(0, "solve", "example.json")


if __name__ == "__main__":
    unittest.main()
