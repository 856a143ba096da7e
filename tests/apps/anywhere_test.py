# SPDX-License-Identifier: GPL-3.0-or-later
"""radcert solve: the iterated solution in every file, and values at points."""
import csv
import io
import json
import math
import os
import shutil
import unittest

import jsonschema

from program import EXAMPLES, ProgramTest


def solution(at):
    return math.exp(at[0] / 2 + at[1] / 3 - at[2] / 4)


class Anywhere(ProgramTest):
    def problem(self, name="p.json", **changes):
        problem = {**{"schema": "radcert/problem/1", "surface": {"name": "box", "a": 1, "b": 2, "c": 3},
                                        "triangulation": {"levels": [0, 1]},
                                        "basis": {"family": "inset", "degree": 1, "alpha": "1/6"},
                                        "reflectivity": "1/2", "solution": "exp(x/2 + y/3 - z/4)"}, **changes}
        self.write(name, json.dumps({key: value for key, value in problem.items() if value is not None}))
        return name

    def result(self, *words, **changes):
        return json.loads(self.expect(0, "solve", self.problem(**changes), "--json", "-", *words))

    def content(self, name):
        with open(self.path(name), newline="", encoding="utf-8") as file:
            return file.read()

    def rows(self, name):
        return list(csv.DictReader(io.StringIO(self.content(name))))

    def refused(self, *words, **changes):
        done = self.run_program("solve", self.problem(**changes), *words)
        self.assertEqual((done.returncode, done.stdout), (2, b""), done.stderr)
        return done.stderr.decode()

    def test_the_levels_have_the_iterated_solution_in_every_file(self):
        found = self.result("--out", "out", "--points", "points.csv", "--sample", "7", iterated=True)
        jsonschema.validate(found, json.loads(self.expect(0, "schema", "solution")))
        self.assertTrue(found["problem"]["iterated"])
        jsonschema.validate(found["problem"], json.loads(self.expect(0, "schema", "problem")))
        rows = self.rows("out/errors.csv")
        for row, level in zip(rows, found["levels"]):
            of = level["iterated"]
            self.assertEqual(of["check_points"], 6 * level["elements"])
            self.assertEqual(float(row["iterated_error"]), of["error"]["value"])
            self.assertEqual(float(row["iterated_node_error"]), of["node_error"]["value"])
            self.assertEqual(float(row["u_n_error"]), of["u_n_error"]["value"])
            self.assertEqual(int(row["check_points"]), of["check_points"])
            self.assertEqual(float(row["l2_error"]), level["l2_error"]["value"])
            # At the nodes both are the same number.
            self.assertLessEqual(abs(of["node_error"]["value"] - level["node_error"]["value"]),
                                 of["node_error"]["radius"] + level["node_error"]["radius"])
            self.assertLess(of["error"]["value"], of["u_n_error"]["value"])
            self.assertLessEqual(of["difference"]["value"], of["error"]["value"] + of["u_n_error"]["value"] + 1e-9)
        last = found["levels"][1]["iterated"]
        self.assertAlmostEqual(last["ratio"], found["levels"][0]["iterated"]["error"]["value"] / last["error"]["value"], 12)
        self.assertAlmostEqual(last["order"], math.log2(last["ratio"]), 12)
        self.assertEqual(sorted(found["orders"]), ["discretisation_error", "iterated_error", "node_error", "u_n_error"])
        self.assertIn("E-Ku_n", self.content("out/table.tex"))
        self.assertIn("E - K u_n", self.content("out/errors_against_h.svg"))
        vtu = self.content("out/solution.vtu")
        self.assertIn('Name="iterated"', vtu)
        self.assertIn('Name="iterated_error"', vtu)
        ply = self.content("out/solution.ply")
        self.assertIn("property double iterated\nproperty double iterated_error\n", ply)
        vertices = [line.split() for line in ply.split("end_header\n")[1].splitlines()][:3 * found["levels"][1]["elements"]]
        for numbers in ([float(word) for word in line] for line in vertices):
            self.assertAlmostEqual(abs(numbers[5] - solution(numbers[:3])), numbers[6], 12)
        self.assertEqual(self.content("points.csv"), self.content("out/points.csv"))
        table = self.expect(0, "solve", "p.json")
        self.assertIn("Order of |u-v| at the check points in h", table)
        self.assertIsNone(self.result()["levels"][0]["iterated"])

    def test_points_by_parameters_and_in_space_are_the_same(self):
        self.write("parameters.csv", "piece,s,t\r\nfloor,0.25,0.5\r\nceiling,0.125,0.5\r\n")
        by_parameters = self.result("--at", "parameters.csv")["points"]
        self.write("space.csv", "z,x,y,words\n" + "".join(
            "%r,%r,%r,\"a, b\"\n" % (p["at"][2], p["at"][0], p["at"][1]) for p in by_parameters))
        in_space = self.result("--at", "space.csv")["points"]
        at = [word for p in by_parameters for word in ("--at", ",".join(map(repr, p["at"])))]
        in_words = self.result(*at)["points"]
        self.assertEqual(len(by_parameters), 2)
        for a, b, c in zip(by_parameters, in_space, in_words):
            self.assertEqual(b, c)
            self.assertEqual((a["piece"], a["at"]), (b["piece"], b["at"]))
            self.assertLess(abs(a["iterated"]["value"] - b["iterated"]["value"]),
                            a["iterated"]["radius"] + b["iterated"]["radius"])
            self.assertEqual(a["distance"], 0)
        # What is written is read again.
        self.expect(0, "solve", "p.json", "--at", "parameters.csv", "--points", "again.csv")
        self.assertEqual(self.result("--at", "again.csv")["points"], by_parameters)

    def test_every_number_at_a_point_is_what_it_says(self):
        for surface in ({"name": "ellipsoid", "a": 1, "b": "3/4", "c": "1/2"}, {"name": "box", "a": 1, "b": 2, "c": 3}):
            found = self.result("--sample", "40", surface=surface)
            for p in found["points"]:
                u = solution(p["at"])
                self.assertAlmostEqual(p["u"]["value"], u, 13)
                self.assertAlmostEqual(p["u_n_error"]["value"], abs(u - p["u_n"]["value"]), 13)
                difference = abs(u - p["iterated"]["value"])
                self.assertLessEqual(abs(p["iterated_error"]["value"] - difference), p["iterated_error"]["radius"])
                terms = p["iterated_terms"]
                self.assertAlmostEqual(sum(terms.values()) / p["iterated"]["radius"], 1, 12)
            worst = max(p["iterated_error"]["value"] for p in found["points"])
            self.assertLess(worst, max(p["u_n_error"]["value"] for p in found["points"]) / 2)

    def test_a_furnace_is_bright_around_a_corner(self):
        shutil.copy(os.path.join(EXAMPLES, "07_occluded_room", "l_room.obj"), self.path("l_room.obj"))
        self.write("room.json", json.dumps({
            "schema": "radcert/problem/1", "surface": {"file": "l_room.obj"}, "triangulation": {"levels": [1]},
            "basis": {"family": "inset", "degree": 1, "alpha": "1/6"}, "reflectivity": "3/4", "emission": "1/4"}))
        found = json.loads(self.expect(0, "solve", "room.json", "--sample", "60", "--json", "-"))["points"]
        for p in found:
            self.assertLessEqual(abs(p["iterated"]["value"] - 1), p["iterated"]["radius"])
            self.assertIsNone(p["u"])
            self.assertIsNone(p["iterated_error"])
        # Of the floor and the ceiling 3 each, the walls 8 in all.
        self.assertAlmostEqual(sum(p["piece"] == "floor" for p in found) / 60, 3 / 14, delta=2 / 60)

    def test_edges_have_no_iterated_value_and_say_so(self):
        found = self.result("--at", "1/2,0,0")["points"][0]
        self.assertIsNone(found["iterated"])
        self.assertIsNotNone(found["u_n"]["value"])
        self.assertIn("1 point lies on the border of a chart", self.expect(0, "solve", "p.json", "--at", "1/2,0,0"))

    def test_the_folder_names_the_file_of_points(self):
        self.write("at.csv", "x,y,z\n0.5,0.5,0\n")
        self.expect(0, "solve", self.problem(), "--at", "at.csv", "--out", "out")
        inputs = json.loads(self.content("out/provenance.json"))["inputs"]
        self.assertEqual([entry["name"] for entry in inputs], ["p.json", "at.csv"])
        self.assertEqual(len(self.rows("out/points.csv")), 1)

    def test_bits_do_not_depend_on_threads(self):
        texts = set()
        for threads in ("1", "2"):
            self.expect(0, "solve", self.problem(iterated=True), "--sample", "50", "--threads", threads, "--fresh",
                        "--points", f"{threads}.csv")
            texts.add(self.content(f"{threads}.csv"))
        self.assertEqual(len(texts), 1)

    def test_what_cannot_be_asked_for_is_refused_by_name(self):
        self.assertIn("is off the surface, by 0.25", self.refused("--at", "0.5,0.5,-0.25"))
        self.write("far.csv", "x,y,z\n0.5,0.5,0\n9,0.5,0\n")
        text = self.refused("--at", "far.csv")
        self.assertIn("far.csv, line 3", text)
        self.assertIn("is off the surface, by 8", text)
        for content, words in [("a,b\n1,2\n", "has not the columns"), ("x,y,z\n", "no point"), ("x,y,z\n1,2\n", "2 cells"),
                               ("x,y,z\n1,2,three\n", "three"), ("x,y,z\n1,2,1e999\n", "line 2"),
                               ("piece,s,t\nroof,0,0\n", "is no piece"), ("piece,s,t\nfloor,2,0\n", "outside the domain"),
                               ("chart,s,t\nroof,0,0\n", "is no chart")]:
            self.write("bad.csv", content)
            self.assertIn(words, self.refused("--at", "bad.csv"), content)
        self.write("piece.csv", "piece,s,t\nsphere,0.25,0.25\n")
        self.assertIn("is a piece of 8 charts", self.refused("--at", "piece.csv", surface={"name": "sphere"}))
        for words, say in [(["--sample", "0"], "1 to 1000000"), (["--sample", "2.5"], "--sample"),
                           (["--sample", "5", "--at", "0,0,0"], "stands beside"), (["--points", "q.csv"], "none are asked for"),
                           (["--within", "0.1"], "--at beside it"), (["--at", "0,0,0", "--within", "2"], "--within"),
                           (["--at", "1,2"], "is no point"), (["--at", "nofile.csv"], "nofile.csv"),
                           (["--sample", "3", "--guarantee", "1"], "--sample")]:
            self.assertIn(say, self.refused(*words), words)
        self.assertIn("/iterated", self.refused(iterated=True, basis="shepard"))
        self.assertIn("/iterated", self.refused(iterated=True, geometry={"interpolated": 2}))
        self.assertIn("/iterated", self.refused(iterated="yes"))
        self.assertIn("/iterated", self.refused("--guarantee", "1", iterated=True, solution=None, emission="1/2"))
        self.assertIn("--sample", self.refused("--sample", "3", basis="shepard"))
        self.assertIn("--at", self.refused("--at", "0,0,0", geometry={"interpolated": 2}))


if __name__ == "__main__":
    unittest.main()
