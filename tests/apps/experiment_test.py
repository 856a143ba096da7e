# SPDX-License-Identifier: GPL-3.0-or-later
"""An experiment is its problems, solved one by one and compared."""
import copy
import csv
import json
import math
import os
import unittest
import xml.etree.ElementTree as xml

import jsonschema

from program import EXAMPLES, SMALL, ProgramTest

INSET = [{"family": "inset", "degree": 0}, {"family": "inset", "degree": 1, "alpha": "0.1"},
         {"family": "inset", "degree": 1, "alpha": "1/6"}, {"family": "inset", "degree": 1, "alpha": "0.2"}]
SURFACES = [{"name": "two_piece", "p": 2}, {"name": "two_piece", "p": 3}]
SVG = "{http://www.w3.org/2000/svg}"


def trial(base=None, **vary):
    shared = {key: value for key, value in SMALL.items() if key != "schema" and key not in vary}
    return {"schema": "radcert/experiment/1", "name": "trial", "base": {**shared, **(base or {})}, "vary": vary}


def without_circumstances(text):
    result = json.loads(text)
    del result["timing"], result["command"]
    return json.dumps(result)


class Experiment(ProgramTest):
    def experiment(self, content, *words, **options):
        return self.expect(0, "experiment", self.write("trial.json", content), *words, **options)

    def rows(self, name):
        with open(self.path(name), newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file, strict=True))

    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def test_the_combinations_are_what_solve_says_of_them(self):
        result = json.loads(self.experiment(trial(basis=INSET, surface=SURFACES), "--json", "-"))
        self.assertEqual(len(result["combinations"]), 8)
        for i in [0, 3, 5]:
            entry = result["combinations"][i]
            self.assertEqual(entry["choice"], {"basis": i // 2, "surface": i % 2})
            problem = {**SMALL, "basis": INSET[i // 2], "surface": SURFACES[i % 2]}
            alone = json.loads(self.expect(0, "solve", self.write("alone.json", problem), "--json", "-",
                                           RADCERT_STORE=os.path.join(self.store, "alone")))
            for key in ["problem", "levels", "orders"]:
                self.assertEqual(entry[key], alone[key], key)

    def test_results_and_experiments_are_valid(self):
        schemas = {}
        for name in ["experiment", "experiment_result"]:
            schemas[name] = json.loads(self.expect(0, "schema", name))
            jsonschema.Draft202012Validator.check_schema(schemas[name])
        experiment = trial(basis=INSET[:3], surface=SURFACES)
        jsonschema.validate(experiment, schemas["experiment"])
        result = json.loads(self.experiment(experiment, "--json", "-"))
        jsonschema.validate(result, schemas["experiment_result"])
        validator = jsonschema.Draft202012Validator(schemas["experiment_result"])
        result["combinations"][0]["levels"][0]["level"] = -1
        self.assertFalse(validator.is_valid(result))
        for wrong in [trial(basis=[]), trial(), trial(bases=INSET), trial(basis=[{"family": "inset"}]),
                      trial(base={"emission": "1"}, basis=INSET), {**trial(basis=INSET), "name": "A b"}]:
            self.assertFalse(jsonschema.Draft202012Validator(schemas["experiment"]).is_valid(wrong), wrong)

    def test_the_folder_has_tables_and_plots_that_say_what_the_json_says(self):
        self.experiment(trial(basis=INSET, surface=SURFACES), "--out", "a/out")
        names = [f"{error}_error_against_{x}.{ending}" for error in ["discretisation", "node", "uniform"]
                 for x in ["alpha", "h", "unknowns"] for ending in ["svg", "tex"]]
        others = ["cite.bib", "errors.csv", "experiment.html", "experiment.json", "plot.tex", "provenance.json",
                  "table.tex", "timing.csv"]
        self.assertEqual(sorted(os.listdir(self.path("a/out"))), sorted(names + others))
        result = json.loads(self.content("a/out/experiment.json"))
        rows = self.rows("a/out/errors.csv")
        self.assertEqual(len(rows), 16)
        self.assertFalse([name for name in rows[0] if "seconds" in name])
        for row in rows:
            entry = result["combinations"][int(row["combination"])]
            level = entry["levels"][int(row["level"])]
            self.assertEqual(row["name"], entry["name"])
            self.assertEqual(int(row["degree"]), entry["problem"]["basis"]["degree"])
            self.assertEqual(row["solution"], SMALL["solution"])
            for key in ["node_error", "discretisation_error", "uniform_error"]:
                self.assertEqual(float(row[key]), level[key]["value"])
            self.assertEqual(int(row["unknowns"]), level["unknowns"])
            self.assertEqual(float(row["fitted_node_order"]), entry["orders"]["node_error"]["order"])
        self.assertEqual(len(self.rows("a/out/timing.csv")), 16)
        for name in (name for name in names if name.endswith(".svg")):
            picture = xml.fromstring(self.content("a/out/" + name))
            self.assertTrue(picture.find(SVG + "title").text.startswith("trial: "))
            self.assertTrue(picture.find(SVG + "desc").text)
            legend = [text.text for text in picture.iter(SVG + "text")]
            if not name.endswith("alpha.svg"):
                for entry in result["combinations"]:
                    self.assertTrue([text for text in legend if text.startswith(entry["name"] + ": order ")], name)

    def test_the_ranking_compares_at_the_largest_cost_that_all_pay(self):
        result = json.loads(self.experiment(trial(basis=INSET, surface=SURFACES), "--json", "-"))
        self.assertEqual([sorted(one["combinations"]) for one in result["at_equal_unknowns"]],
                         [[0, 2, 4, 6], [1, 3, 5, 7]], "two surfaces are two questions")
        for question in result["at_equal_unknowns"]:
            ranking = question["node_error"]
            levels = {i: result["combinations"][i]["levels"] for i in question["combinations"]}
            self.assertEqual(ranking["unknowns"], min(own[-1]["unknowns"] for own in levels.values()))
            errors = [place["error"] for place in ranking["ranking"]]
            self.assertEqual(errors, sorted(errors))
            for place in ranking["ranking"]:
                (n0, e0), (n1, e1) = [(level["unknowns"], level["node_error"]["value"])
                                      for level in levels[place["combination"]]]
                part = math.log(ranking["unknowns"] / n0) / math.log(n1 / n0)
                self.assertAlmostEqual(math.log(place["error"]), (1 - part) * math.log(e0) + part * math.log(e1), 12)

    def test_the_table_has_a_line_a_combination(self):
        experiment = trial(basis=INSET, surface=SURFACES)
        text = self.experiment(experiment, "--json", "result.json")
        for entry in json.loads(self.content("result.json"))["combinations"]:
            self.assertEqual(len([line for line in text.splitlines() if line.startswith(entry["name"] + " ")]), 1)

    def test_all_but_the_seconds_is_the_same_to_the_bit(self):
        files = {}
        for threads in ["1", "2"]:
            self.experiment(trial(basis=INSET), "--out", threads, "--threads", threads,
                            RADCERT_STORE=os.path.join(self.store, threads))
            for name in os.listdir(self.path(threads)):
                if name == "experiment.json":
                    files.setdefault(name, set()).add(without_circumstances(self.content(f"{threads}/{name}")))
                elif name not in ("timing.csv", "provenance.json", "experiment.html"):
                    files.setdefault(name, set()).add(self.content(f"{threads}/{name}"))
        for name, contents in files.items():
            self.assertEqual(len(contents), 1, name)

    def test_a_second_run_recalls_everything(self):
        self.experiment(trial(basis=INSET), "--out", "first")
        done = self.run_program("experiment", "trial.json", "--out", "second")
        self.assertEqual(done.stderr.count(b"found in the store"), len(INSET), done.stderr)
        self.assertEqual(self.content("first/timing.csv"), self.content("second/timing.csv"))

    def test_an_interrupted_run_keeps_what_it_finished(self):
        # The second combination has 6144 unknowns: the signal, sent when the first is reported, comes long before its end.
        slow = trial(base={"basis": {"family": "inset", "degree": 2, "alpha": "0.1"}},
                     triangulation=[{"levels": [0]}, {"levels": [4]}])
        self.write("slow.json", slow)
        said = self.interrupted_after(b"levels 0: 1 level", "experiment", "slow.json", "--out", "out")
        self.assertIn(b"interrupted; 1 of 2 levels are finished and kept", said)
        self.assertEqual(self.entries(), ["slow.json"])
        self.assertEqual(len(os.listdir(self.store)), 1)

    def test_wrong_experiments_are_refused_with_their_place(self):
        large = {"levels": [0, 15]}
        zero = {"family": "inset", "degree": 1, "alpha": 0}
        for content, pointer, said in [
                (trial(basis=[]), "/vary/basis", "is empty"),
                (trial(), "/vary", "is empty"),
                (trial(base={"albedo": "1"}, basis=INSET), "/base/albedo", "unknown key"),
                (trial(basis=INSET + INSET[:1]), "/vary/basis/4", "the same problem as /vary/basis/0"),
                (trial(basis=INSET, triangulation=[{"levels": [0]}, large]), "/vary/triangulation/1/levels/1",
                 "of memory"),
                (trial(base={"reflectivity": "1/2"}, surface=[SURFACES[0], {"name": "cube"}], basis=[INSET[0], zero]),
                 "/vary/basis/1/alpha", "(with /vary/surface/1)"),
                (trial(base={"solution": "1/(x-x)"}, basis=INSET), "/base/solution", "is infinite at node 0"),
                ({**trial(basis=INSET), "name": "../up"}, "/name", "is no name"),
                ({**trial(basis=INSET), "schema": "radcert/problem/1"}, "/schema", "radcert/experiment/1")]:
            with self.subTest(pointer):
                self.write("wrong.json", content)
                done = self.run_program("experiment", "wrong.json", "--out", "out", "--max-memory", "1G")
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertEqual(done.stdout, b"")
                said_there = done.stderr.decode().splitlines()[-1]
                self.assertTrue(said_there.startswith(f"radcert: wrong.json: {pointer}: "), said_there)
                self.assertIn(said, said_there)
                self.assertEqual(self.entries(), ["wrong.json"])

    def test_files_are_found_beside_the_experiment(self):
        os.mkdir(self.path("below"))
        cube = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"
        self.write("below/body.off", cube)
        content = trial(base={"surface": {"file": "body.off"}, "reflectivity": "1/2", "solution": "1 + x"},
                        basis=INSET[:2])
        self.write("below/trial.json", content)
        self.expect(0, "experiment", "below/trial.json")

    def test_the_shipped_experiments_are_experiments(self):
        schema = json.loads(self.expect(0, "schema", "experiment"))
        folder = os.path.join(EXAMPLES, "experiments")
        names = sorted(file[:-5] for file in os.listdir(folder))
        self.assertEqual(names, ["degree_sweep", "grading_on_the_cube", "inset_alpha_sweep", "meshless_against_collocation",
                                 "symmetric_against_inset"])
        for name in names:
            with open(os.path.join(folder, name + ".json"), encoding="utf-8") as file:
                text = file.read()
            self.assertEqual(self.expect(0, "example", name), text)
            experiment = json.loads(text)
            self.assertEqual(experiment["name"], name)
            jsonschema.validate(experiment, schema)
            # The coarsest level alone: the whole takes too long for a test.
            small = copy.deepcopy(experiment)
            for triangulation in [small["base"].get("triangulation")] + small["vary"].get("triangulation", []):
                if triangulation:
                    triangulation["levels"] = [1] if triangulation["levels"][0] == 1 else [0]
            text = self.experiment(small)
            self.assertTrue(text.startswith(name + ": "), text)
        self.assertIn(self.expect(0, "example", "experiment"), [self.expect(0, "example", name) for name in names])


if __name__ == "__main__":
    unittest.main()
