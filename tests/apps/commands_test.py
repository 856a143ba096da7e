# SPDX-License-Identifier: GPL-3.0-or-later
"""What there is to ask besides solving."""
import json
import os
import re
import unittest

import jsonschema

from program import EXAMPLES, ProgramTest

PROBLEMS = os.path.join(EXAMPLES, "01_solve")


class Commands(ProgramTest):
    def schema(self, name):
        schema = json.loads(self.expect(0, "schema", name))
        jsonschema.Draft202012Validator.check_schema(schema)
        return schema

    def examples(self):
        """The names of the examples with their files."""
        return {re.sub(r"^[0-9]+_", "", file[:-5]): file
                for file in sorted(os.listdir(PROBLEMS)) if file.endswith(".json")}

    def test_alone_it_names_three_commands_that_work(self):
        text = self.expect(0)
        commands = re.findall(r"^  radcert (.*)$", text, re.MULTILINE)
        self.assertEqual(len(commands), 3)
        for command in commands:
            words, _, file = command.partition(" > ")
            output = self.expect(0, *words.split())
            if file:
                self.write(file, output)

    def test_it_says_its_version(self):
        self.assertRegex(self.expect(0, "--version"), r"^radcert [0-9]+\.[0-9]+\.[0-9]+\n$")

    def test_every_command_has_help_and_the_common_options(self):
        for command in ["solve", "verify", "list", "schema", "example"]:
            text = self.expect(0, command, "--help")
            for option in ["--help", "--json", "--threads", "--max-memory", "--quiet"]:
                self.assertIn(option, text, command)

    def test_every_schema_is_a_schema(self):
        for name in ["problem", "solution", "verification", "list"]:
            self.assertEqual(self.schema(name)["properties"]["schema"]["const"], f"radcert/{name}/1")

    def test_every_example_is_the_file_and_is_valid(self):
        schema = self.schema("problem")
        names = self.examples()
        self.assertTrue(names)
        for name, file in names.items():
            text = self.expect(0, "example", name)
            with open(os.path.join(PROBLEMS, file), encoding="utf-8") as there:
                self.assertEqual(text, there.read())
            jsonschema.validate(json.loads(text), schema)
        self.assertIn(self.expect(0, "example", "problem"), [self.expect(0, "example", name) for name in names])

    def test_the_schema_refuses_what_the_program_refuses(self):
        schema = self.schema("problem")
        validator = jsonschema.Draft202012Validator(schema)
        problem = json.loads(self.expect(0, "example", "problem"))
        for change in [{"albedo": 1}, {"surface": {"name": "cube", "p": 2}}, {"emission": "1"},
                       {"triangulation": {"levels": []}}, {"basis": {"family": "inset", "degree": 1}},
                       {"reflectivity": None}]:
            self.assertFalse(validator.is_valid({**problem, **change}), change)

    def test_every_list_is_valid_json_and_a_line_an_entry(self):
        schema = self.schema("list")
        for what in ["surfaces", "bases", "solvers", "claims", "references"]:
            listed = json.loads(self.expect(0, "list", what, "--json", "-"))
            jsonschema.validate(listed, schema)
            text = self.expect(0, "list", what)
            for entry in listed["entries"]:
                self.assertIn(entry["name"], text)
            if listed["entries"]:
                self.assertEqual(len(text.splitlines()), len(listed["entries"]))

    def test_every_parameter_of_a_surface_has_a_meaning(self):
        for entry in json.loads(self.expect(0, "list", "surfaces", "--json", "-"))["entries"]:
            for parameter in entry["parameters"]:
                self.assertTrue(parameter["meaning"], (entry["name"], parameter["name"]))
        self.assertIn("c = 5 (the half axis along z, ", self.expect(0, "list", "surfaces"))

    def test_every_solver_listed_can_be_asked_for(self):
        names = [entry["name"] for entry in json.loads(self.expect(0, "list", "solvers", "--json", "-"))["entries"]]
        self.assertTrue({"auto", "direct", "verified"} <= set(names))
        problem = json.loads(self.expect(0, "example", "problem"))
        for name in names:
            self.write("problem.json", {**problem, "solver": {"name": name}, "triangulation": {"levels": [0]}})
            # That of ranks needs some.
            done = self.run_program("solve", "problem.json")
            self.assertEqual(done.returncode, 2 if name == "petsc" else 0, done.stderr)

    def test_view_factors_are_found_by_their_other_names(self):
        self.assertIn("view factors", " ".join(self.expect(0, "--help").split()))

    def test_every_surface_listed_can_be_used_with_its_defaults(self):
        problem = json.loads(self.expect(0, "example", "problem"))
        for entry in json.loads(self.expect(0, "list", "surfaces", "--json", "-"))["entries"]:
            with self.subTest(entry["name"]):
                surface = {"name": entry["name"], **{p["name"]: p["default"] for p in entry["parameters"]}}
                changed = {**problem, "surface": surface, "reflectivity": "1/2", "triangulation": {"levels": [0]},
                           "basis": {"family": "inset", "degree": 0}, "solution": "x + 2"}
                self.write("problem.json", changed)
                # Of a surface whose parts hide others the list says so.
                solvable = "not for solve" not in entry["summary"]
                done = self.run_program("solve", "problem.json")
                self.assertEqual(done.returncode, 0 if solvable else 2, done.stderr.decode())

    def test_output_that_cannot_be_written_is_the_environments_failure(self):
        if os.path.exists("/dev/full"):
            self.expect(3, "list", "surfaces", "--json", "/dev/full")


if __name__ == "__main__":
    unittest.main()
