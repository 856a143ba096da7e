# SPDX-License-Identifier: GPL-3.0-or-later
"""The page "Try your own basis", followed as it is written."""
import json
import os
import shutil
import unittest

from program import EXAMPLES, ProgramTest

PAGE = os.path.join(EXAMPLES, "04_own_basis")


class OwnBasis(ProgramTest):
    def setUp(self):
        super().setUp()
        shutil.copytree(PAGE, self.folder, dirs_exist_ok=True)

    def edit(self, name, old, new):
        with open(self.path(name), encoding="utf-8") as file:
            text = file.read()
        self.assertIn(old, text)
        self.write(name, text.replace(old, new, 1))

    def refused(self, *said, words=("basis", "enriched.json")):
        done = self.run_program(*words)
        self.assertEqual(done.returncode, 2, done.stderr)
        for words in said:
            self.assertIn(words, done.stderr.decode())

    def orders(self, problem):
        orders = json.loads(self.expect(0, "solve", problem, "--json", "-"))["orders"]
        return orders["node_error"]["order"]

    def test_every_command_of_the_page_works(self):
        self.expect_commands_of(PAGE, 8)

    def test_the_bubble_has_the_predicted_order_and_the_linear_functions_have_theirs(self):
        self.assertGreater(self.orders("problem.json"), 3.5)
        self.edit("problem.json", "enriched.json", "nodes.json")
        self.assertLess(abs(self.orders("problem.json") - 2), 0.5)

    def test_what_is_wrong_is_said_with_its_place_and_size(self):
        self.edit("enriched.json", '"3/5", "1/5", "1/5"', '"-1/5", "3/5", "3/5"')
        self.refused("/nodes/0/0", "outside the triangle")
        self.edit("enriched.json", '"-1/5", "3/5", "3/5"', '"1/5", "3/5", "1/5"')
        self.refused("/nodes/1", "is the same point as node 0")
        self.edit("enriched.json", '"1/5", "3/5", "1/5"', '"3/5", "1/5", "1/5"')
        self.edit("enriched.json", "27*x1*x2*x3", "sqrt(x1)")
        self.refused("/space/3", "has sqrt and is no polynomial")
        self.edit("enriched.json", "sqrt(x1)", "x1 - x2")
        self.refused("/nodes", "linearly dependent")
        self.edit("enriched.json", "x1 - x2", "x1*(x1 - x2")
        self.refused("/space/3", "column")
        self.edit("enriched.json", '"x1", "x2", "x3", "x1*(x1 - x2"', '"x1", "x2", "x3^2", "x1*x2*x3"')
        self.refused("/space", "does not contain the constants", "the interpolant of 1 at the nodes is", "(0, 0, 1)")

    def test_a_file_that_changes_is_read_again(self):
        self.edit("experiment.json", '"levels": [0, 1, 2, 3]', '"levels": [0, 1]')
        first = json.loads(self.expect(0, "experiment", "experiment.json", "--json", "-"))["combinations"]
        self.write("nodes.json", json.dumps({
            "schema": "radcert/nodes/1", "degree": 1,
            "nodes": [["2/3", "1/6", "1/6"], ["1/6", "2/3", "1/6"], ["1/6", "1/6", "2/3"]]}))
        second = json.loads(self.expect(0, "experiment", "experiment.json", "--json", "-"))["combinations"]
        errors = [[level["node_error"]["value"] for level in result[0]["levels"]] for result in (first, second)]
        self.assertLess(errors[1][1], 0.8 * errors[0][1])
        self.assertEqual([c["levels"] for c in first[1:]], [c["levels"] for c in second[1:]])

    def test_a_file_that_changed_since_its_digest_is_refused(self):
        problem = json.loads(self.expect(0, "solve", "problem.json", "--json", "-"))["problem"]
        self.assertRegex(problem["basis"]["digest"], "^sha256-[0-9a-f]{64}$")
        self.write("again.json", problem)
        self.edit("enriched.json", "27*", "28*")
        self.refused("/basis/digest", "it has changed", words=("solve", "again.json"))

    def test_a_changed_digit_of_the_table_is_noticed(self):
        with open(self.path("claims/table.csv"), encoding="utf-8") as file:
            lines = file.read().splitlines()
        n, error, ratio = lines[-1].split(",")
        digit = "8" if error[2] != "8" else "3"
        self.write("claims/table.csv", "\n".join(lines[:-1] + [f"{n},{error[:2]}{digit}{error[3:]},{ratio}"]) + "\n")
        done = self.run_program("verify", "./claims")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(b"contradicted", done.stdout)

    def test_a_control_that_is_no_control_is_noticed(self):
        self.edit("claims/claims.toml", 'control = "linear.json"', 'control = "bubble.json"')
        self.assertEqual(self.run_program("verify", "./claims").returncode, 1)


if __name__ == "__main__":
    unittest.main()
