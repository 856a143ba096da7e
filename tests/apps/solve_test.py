# SPDX-License-Identifier: GPL-3.0-or-later
"""What solve says does not depend on how it is run."""
import csv
import hashlib
import json
import os
import subprocess
import unittest

import jsonschema

from program import EXAMPLES, RADCERT, ProgramTest, small


def without_circumstances(text):
    """A result without what may differ from run to run."""
    result = json.loads(text)
    del result["timing"], result["command"]
    return json.dumps(result)


class Solve(ProgramTest):
    def solvers(self):
        """All names of solvers, as the schema has them, but that of the one that is for ranks."""
        solver = json.loads(self.expect(0, "schema", "problem"))["properties"]["solver"]
        return [name for name in solver["properties"]["name"]["enum"] if name != "petsc"]

    def solution(self, *words, **options):
        return self.expect(0, "solve", *words, "--json", "-", **options)

    def test_results_are_valid_and_their_problem_can_be_solved_again(self):
        schema = json.loads(self.expect(0, "schema", "solution"))
        problems = json.loads(self.expect(0, "schema", "problem"))
        for problem in [small(), small(solution=None, emission={"upper": "1", "*": "0"}),
                        small(basis={"family": "inset", "degree": 0}, reflectivity=0.3),
                        small(geometry={"interpolated": 3}), small(geometry={"interpolated": 1, "data": "interpolant"}),
                        small(solver={"name": "gmres"}), small(solver={"name": "neumann", "tolerance": "1e-6"})]:
            result = json.loads(self.solution(self.write("problem.json", problem)))
            jsonschema.validate(result, schema)
            jsonschema.validate(result["problem"], problems)
            again = json.loads(self.solution(self.write("again.json", result["problem"])))
            self.assertEqual(again["levels"], result["levels"])
            self.assertEqual(again["problem"], result["problem"])

    def test_a_problem_is_read_from_the_standard_input(self):
        text = json.dumps(small()).encode()
        self.write("problem.json", text)
        self.expect(0, "solve", "problem.json", "--json", "file.json")
        run = lambda content: subprocess.run([RADCERT, "solve", "-", "--out", "out", "--json", "piped.json"], input=content,
                                             cwd=self.folder, env=self.environment(), capture_output=True, check=False)
        done = run(text)
        self.assertEqual(done.returncode, 0, done.stderr)
        results = []
        for name in ("file.json", "piped.json"):
            with open(self.path(name), encoding="utf-8") as file:
                results.append(json.load(file))
        self.assertEqual(results[0]["levels"], results[1]["levels"])
        with open(self.path("out/provenance.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["inputs"],
                             [{"name": "-", "digest": "sha256-" + hashlib.sha256(text).hexdigest()}])
        done = run(b'{"schema": "radcert/problem/1"}')
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"standard input: /surface", done.stderr)

    def test_a_guarantee_where_parts_hide_each_other_says_what_was_mended(self):
        lines = []
        for base, (name, low, high, inwards) in enumerate([("room", 0, (3, 3, 3), True), ("box", 1, (2, 2, 1), False)]):
            bottom = (low, low, 0)
            lines += ["v %d %d %d" % tuple((high if n >> k & 1 else bottom)[k] for k in range(3)) for n in range(8)]
            for face, quad in [("bottom", (0, 2, 3, 1)), ("top", (4, 5, 7, 6)), ("south", (0, 1, 5, 4)),
                               ("north", (2, 6, 7, 3)), ("west", (0, 4, 6, 2)), ("east", (1, 3, 7, 5))]:
                corners = [8 * base + n + 1 for n in (reversed(quad) if inwards else quad)]
                lines += [f"g {name}_{face}", "f " + " ".join(map(str, corners))]
        self.write("room.obj", "\n".join(lines).encode() + b"\n")
        problem = {"schema": "radcert/problem/1", "surface": {"file": "room.obj"}, "triangulation": {"levels": [0]},
                   "basis": {"family": "inset", "degree": 0}, "reflectivity": "0", "emission": "1/2"}
        said = self.expect(0, "solve", self.write("room.json", problem), "--guarantee", "0.1")
        self.assertIn("Mended: room.obj: contact of room_bottom and box_bottom: an area of 1", said)
        self.assertIn("box_top            0.5", said)
        values = ("solve", "room.json", "--guarantee", "0.1", "--of", "values")
        self.assertIn("box_top", self.expect(0, *values, "--at", "1.5,1.5,1"))
        # On the line between two parts of the floor, and on an edge.
        self.assertIn("room_bottom", self.expect(0, *values, "--at", "0.5,1,0"))
        # Beside that line, and beside an edge.
        self.assertIn("room_bottom", self.expect(0, *values, "--at", "0.5,1.0000001,0"))
        for more, says in [(("--at", "0.5,0.0001,0"), "is too near to an edge of its face"),
                           (("--at", "1,1,0"), "does not lie inside a face of the surface"),
                           ((), "are not given, and parts of the surface hide each other")]:
            done = self.run_program(*values, *more)
            self.assertEqual(done.returncode, 2)
            self.assertIn(says, done.stderr.decode())
        said = self.expect(0, "solve", "room.json", "--guarantee", "0.1", "--of", "function", "--json", "function.json")
        self.assertIn("the solution u of the equation itself is v within these bounds", said)
        with open(self.path("function.json"), encoding="utf-8") as file:
            function = json.load(file)["enclosure"]["function"]
        self.assertTrue(function["faces_are_cut"])
        self.assertIn("box_top", function["pieces"])
        # Of a value between two parts of the floor, and of the function, what proves them.
        self.expect(0, *values, "--at", "0.5,1,0", "--certificate", "value.certificate.json")
        self.assertIn("values of u  1/2,1,0", self.expect(0, "check", "value.certificate.json", "--part", "3"))
        self.expect(0, "solve", "room.json", "--guarantee", "0.1", "--of", "function", "--certificate",
                    "function.certificate.json")
        self.assertIn("within 0 of the function, everywhere",
                      self.expect(0, "check", "function.certificate.json", "--part", "3"))
        # A rounding above the floor is no contact: that is said beside every result.
        self.write("room.obj", "\n".join(line + ".000000000001" if line.startswith("v") and line[-2:] == " 0" and
                                         base >= 8 else line
                                         for base, line in enumerate(lines)).encode() + b"\n")
        said = self.expect(0, "solve", "room.json")
        self.assertIn("Remark: room.obj: room_bottom and box_bottom face each other across a gap of", said)

    def test_what_is_proved_around_a_corner_is_verified_again(self):
        with open(os.path.join(EXAMPLES, "07_occluded_room", "lit_room.json"), encoding="utf-8") as file:
            problem = json.load(file)
        problem["surface"]["file"] = os.path.join(EXAMPLES, "07_occluded_room", "l_room.obj")
        problem["reflectivity"] = {"floor": "1/2", "north": "1/4", "*": "0"}
        words = ("solve", self.write("lit.json", problem))
        self.expect(0, *words, "--guarantee", "0.4", "--of", "values", "--at", "0.75,1.2,0", "--certificate", "value.json")
        self.assertIn("values of u  3/4,6/5,0 0.0019 +-", self.expect(0, "check", "value.json", "--part", "30"))
        self.expect(0, *words, "--guarantee", "3", "--of", "function", "--outside", "0.3", "--certificate", "u.json")
        self.assertIn("of the function, 3/10 or more from every corner of a face",
                      self.expect(0, "check", "u.json", "--part", "30"))

    def test_a_function_is_enclosed_where_a_side_of_an_edge_is_two_faces(self):
        self.write("cube.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 0.5 0 0\n"
                               "v 0.5 1 0\ng lamp\nf 1 9 10 4\ng floor\nf 9 2 3 10\ng ceiling\nf 5 8 7 6\n"
                               "g west\nf 1 4 8 5\ng east\nf 2 6 7 3\ng south\nf 1 5 6 2 9\ng north\nf 4 10 3 7 8\n")
        problem = {"schema": "radcert/problem/1", "surface": {"file": "cube.obj"}, "triangulation": {"levels": [0]},
                   "basis": {"family": "inset", "degree": 0}, "reflectivity": {"south": "1/4", "*": "0"},
                   "emission": {"lamp": "1", "*": "0"}}
        words = ("solve", self.write("cube.json", problem), "--guarantee", "0.5", "--of", "function", "--outside", "0.1")
        self.assertIn("the solution u of the equation itself is v within these bounds",
                      self.expect(0, *words, "--certificate", "cube.certificate.json"))
        self.assertIn("from every corner of a face",
                      self.expect(0, "check", "cube.certificate.json", "--part", "10"))

    def test_a_guarantee_on_an_open_surface_is_that_beside_black_faces(self):
        self.write("open.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                               "g floor\nf 1 2 3 4\ng south\nf 1 5 6 2\ng east\nf 2 6 7 3\ng north\nf 3 7 8 4\n"
                               "g west\nf 4 8 5 1\n")
        problem = {"schema": "radcert/problem/1", "triangulation": {"levels": [0]},
                   "basis": {"family": "inset", "degree": 0}, "emission": {"floor": "1", "*": "0"},
                   "guarantee": {"width": "1/10"}}
        self.write("open.json", {**problem, "surface": {"file": "open.obj"}, "reflectivity": "1/2"})
        self.write("closed.json", {**problem, "surface": {"name": "cube"}, "reflectivity": {"ceiling": "0", "*": "1/2"}})
        means = {}
        for name in ("open", "closed"):
            result = json.loads(self.solution(name + ".json"))
            means[name] = {piece: (float(x["midpoint"]), float(x["radius"]))
                           for piece, x in result["enclosure"]["pieces"].items()}
        self.assertEqual(set(means["open"]), {"floor", "south", "east", "north", "west"})
        for piece, (midpoint, radius) in means["open"].items():
            other, other_radius = means["closed"][piece]
            self.assertLessEqual(abs(midpoint - other), radius + other_radius, piece)
        self.expect(0, "solve", "open.json", "--certificate", "open.certificate.json")
        self.assertIn("opening", self.expect(0, "check", "open.certificate.json"))

    def test_a_guarantee_is_kept_or_refused(self):
        cube = {"schema": "radcert/problem/1", "surface": {"name": "tetrahedron"}, "triangulation": {"levels": [0]},
                "basis": {"family": "inset", "degree": 0}, "reflectivity": "1/4", "emission": "3/4"}
        self.write("cube.json", cube)
        text = self.solution("cube.json", "--guarantee", "1/5")
        result = json.loads(text)
        jsonschema.validate(result, json.loads(self.expect(0, "schema", "solution")))
        jsonschema.validate(result["problem"], json.loads(self.expect(0, "schema", "problem")))
        enclosure = result["enclosure"]
        self.assertLessEqual(float(enclosure["width"]), 0.2)
        self.assertEqual(len(enclosure["pieces"]), 4)
        for piece, mean in enclosure["pieces"].items():
            self.assertLessEqual(abs(float(mean["midpoint"]) - 1), float(mean["radius"]), piece)
        self.write("own.json", {**cube, "guarantee": {"width": "0.2", "of": "means"}})
        own = self.solution("own.json", "--threads", "1")
        self.assertEqual(json.loads(own)["enclosure"], enclosure)
        table = self.expect(0, "solve", "own.json")
        self.assertIn("Proved: the means of the solution u", table)
        matrix = json.loads(self.solution("cube.json", "--guarantee", "1/4", "--emission-by", "piece"))
        jsonschema.validate(matrix, json.loads(self.expect(0, "schema", "solution")))
        jsonschema.validate(matrix["problem"], json.loads(self.expect(0, "schema", "problem")))
        by_piece = matrix["enclosure"]["emissions"]
        self.assertEqual(list(by_piece), list(matrix["enclosure"]["pieces"]))
        for piece in by_piece:
            # E = 3/4 everywhere is a furnace of 1.
            means = [of["pieces"][piece] for of in by_piece.values()]
            total = 0.75 * sum(float(mean["midpoint"]) for mean in means)
            self.assertLessEqual(abs(total - 1), 0.75 * sum(float(mean["radius"]) for mean in means))
        self.write("at.csv", "x,y,z\n1/3,1/3,-1/3\n")
        values = json.loads(self.solution("cube.json", "--guarantee", "1", "--at", "at.csv"))["enclosure"]
        self.assertIsNone(values["pieces"])
        [point] = values["points"]
        self.assertEqual(point["at"], ["1/3", "1/3", "-1/3"])
        self.assertLessEqual(abs(float(point["midpoint"]) - 1), float(point["radius"]))
        self.write("ball.json", {**cube, "surface": {"name": "sphere"}, "emission": "1/2 + x/4"})
        function = json.loads(self.solution("ball.json", "--guarantee", "1/20", "--of", "function", "--vtu", "u.vtu",
                                            "--nodes", "u.csv"))
        bound = function["enclosure"]["function"]
        self.assertLessEqual(2 * float(bound["sup"]), 0.05)
        for name in ["u.vtu", "u.csv"]:
            self.assertTrue(os.path.exists(self.path(name)), name)
        for words in [["own.json", "--guarantee", "0"], ["own.json", "--at", "1,1"], ["own.json", "--at", "9,9,9"],
                      ["own.json", "--of", "means", "--at", "1/3,1/3,-1/3"], ["own.json", "--outside", "1/10"],
                      ["own.json", "--of", "function", "--outside", "-1"],
                      ["own.json", "--of", "function", "--outside", "1e9"], ["own.json", "--of", "function", "--ply", "a.ply"],
                      ["own.json", "--guarantee", "1e-15"], ["own.json", "--of", "all"], ["cube.json", "--of", "means"],
                      ["own.json", "--vtu", "a.vtu"], ["own.json", "--out", "folder"],
                      ["own.json", "--emission-by", "face"], ["ball.json", "--guarantee", "1", "--emission-by", "piece"],
                      ["own.json", "--emission-by", "piece", "--certificate", "c.json"]]:
            self.expect(2, "solve", *words)
        for name in ["folder", "a.vtu", "a.ply"]:
            self.assertFalse(os.path.exists(self.path(name)), name)

    def test_a_certificate_is_verified_and_refused_where_it_was_changed(self):
        furnace = {"schema": "radcert/problem/1", "surface": {"name": "tetrahedron"}, "triangulation": {"levels": [0]},
                   "basis": {"family": "inset", "degree": 0}, "reflectivity": "1/4", "emission": "3/4"}
        self.write("furnace.json", furnace)
        self.expect(0, "solve", "furnace.json", "--guarantee", "1/5", "--certificate", "c.json")
        with open(self.path("c.json"), encoding="utf-8") as file:
            text = file.read()
        certificate = json.loads(text)
        jsonschema.validate(certificate, json.loads(self.expect(0, "schema", "certificate")))
        self.assertLessEqual(float(certificate["width"]), 0.2)
        for mean in certificate["means"]:
            self.assertLessEqual(abs(float(mean["midpoint"]) - 1), float(mean["radius"]), mean["piece"])
        report = json.loads(self.expect(0, "check", "c.json", "--part", "3", "--json", "-"))
        jsonschema.validate(report, json.loads(self.expect(0, "schema", "check")))
        self.assertTrue(report["verified"])
        self.assertEqual(len(report["looked_at"]), 3)
        other = json.loads(self.expect(0, "check", "c.json", "--part", "3", "--seed", "other", "--json", "-"))
        self.assertNotEqual(report["looked_at"], other["looked_at"])
        table = self.expect(0, "check", "c.json", "--part", "0.01")
        self.assertIn("verified", table)
        # Another number without the digest that belongs to it.
        certificate["means"][0]["midpoint"] = "0.5"
        self.write("changed.json", certificate)
        self.assertIn("/digest", self.expect(1, "check", "changed.json"))
        del certificate["digest"]
        self.write("changed.json", certificate)
        self.expect(2, "check", "changed.json")
        for name, wrong in [("half.json", text[:len(text) // 2]), ("empty.json", ""), ("other.json", "{}"),
                            ("version.json", text.replace("radcert/certificate/1", "radcert/certificate/2")),
                            ("nan.json", text.replace(certificate["coefficients"][0][:16], "7ff8000000000000", 1)),
                            ("large.json", text.replace('"radii": [', '"radii": [1e999, ', 1)),
                            ("short.json", text.replace('"radii": [', '"radii": [1, ', 1)),
                            ("problem.json", json.dumps(furnace))]:
            with open(self.path(name), "w", encoding="utf-8") as file:
                file.write(wrong)
            self.expect(2, "check", name)
        for words in [["c.json", "--part", "0"], ["c.json", "--part", "1.5"], ["c.json", "--part", "x"],
                      ["c.json", "--all", "--part", "3"], ["nothing.json"]]:
            self.expect(2, "check", *words)
        self.expect(0, "solve", "furnace.json", "--guarantee", "1", "--at", "1/3,1/3,-1/3", "--certificate", "v.json")
        with open(self.path("v.json"), encoding="utf-8") as file:
            values = json.load(file)
        jsonschema.validate(values, json.loads(self.expect(0, "schema", "certificate")))
        [value] = values["values"]
        self.assertEqual(value["at"], ["1/3", "1/3", "-1/3"])
        self.assertLessEqual(abs(float(value["midpoint"]) - 1), float(value["radius"]))
        self.assertIn("values of u", self.expect(0, "check", "v.json", "--part", "3"))
        values["values"][0]["at"] = ["1/3", "1/3", "1/3"]
        self.write("changed.json", values)
        self.expect(2, "check", "changed.json")
        self.expect(2, "solve", "furnace.json", "--certificate", "d.json")
        # Each condition that stands in the way.
        self.write("bent.json", {**furnace, "emission": "exp(x)"})
        done = self.run_program("solve", "bent.json", "--guarantee", "1/5", "--emission-by", "piece",
                                "--certificate", "d.json")
        self.assertEqual(done.returncode, 2)
        message = done.stderr.decode()
        for words in ["further emissions", "no polynomial"]:
            self.assertIn(words, message)
        self.assertFalse(os.path.exists(self.path("d.json")))

    def test_a_function_on_a_polyhedron_has_a_certificate(self):
        self.write("furnace.json",
                   {"schema": "radcert/problem/1", "surface": {"name": "tetrahedron"}, "triangulation": {"levels": [0]},
                    "basis": {"family": "inset", "degree": 0}, "reflectivity": "1/4", "emission": "3/4"})
        self.expect(0, "solve", "furnace.json", "--guarantee", "1", "--of", "function", "--outside", "1/7",
                    "--certificate", "f.json")
        with open(self.path("f.json"), encoding="utf-8") as file:
            certificate = json.load(file)
        jsonschema.validate(certificate, json.loads(self.expect(0, "schema", "certificate")))
        self.assertEqual(certificate["of"], "function")
        self.assertLessEqual(float(certificate["width"]), 1)
        bounds = certificate["function"]["by_distance"]
        self.assertEqual(bounds[-1]["outside"], "0")
        self.assertIn(certificate["function"]["outside"], [bound["outside"] for bound in bounds])
        self.assertIn("of the function", self.expect(0, "check", "f.json", "--part", "3"))
        del certificate["digest"]
        certificate["sums"] = {"norms": [0], "products": [], "radii": []}
        self.write("changed.json", certificate)
        self.expect(2, "check", "changed.json")

    def test_pointers_escape_the_names_of_emissions(self):
        self.write("named.json", {"schema": "radcert/problem/1", "surface": {"name": "cube"},
                                  "triangulation": {"levels": [0]}, "basis": {"family": "inset", "degree": 0},
                                  "reflectivity": "1/2", "emission": "1",
                                  "guarantee": {"width": "1/2", "emissions": {"a/b~c": "1/(x-1/2)"}}})
        done = self.run_program("solve", "named.json")
        self.assertEqual(done.returncode, 2)
        self.assertIn("/guarantee/emissions/a~1b~0c", done.stderr.decode())
        done = self.run_program("solve", "named.json", "--emission-by", "piece")
        self.assertEqual(done.returncode, 2)
        self.assertIn("stands beside /guarantee/emissions", done.stderr.decode())

    def test_values_of_further_emissions_are_written_beside_the_own(self):
        self.write("box.json", {"schema": "radcert/problem/1", "surface": {"name": "tetrahedron"},
                                "triangulation": {"levels": [0]}, "basis": {"family": "inset", "degree": 0},
                                "reflectivity": "1/8", "emission": "1"})
        result = json.loads(self.solution("box.json", "--guarantee", "1", "--at", "1/3,1/3,-1/3", "--emission-by", "piece",
                                          "--nodes", "u.csv", "--vtu", "u.vtu"))["enclosure"]
        with open(self.path("u.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["emission"] for row in rows], ["", *result["emissions"]])
        # All pieces together emit what the problem's own does.
        own, *others = [(float(row["radiosity"]), float(row["radius"])) for row in rows]
        self.assertLessEqual(abs(own[0] - sum(value for value, _ in others)), own[1] + sum(radius for _, radius in others))
        with open(self.path("u.vtu"), encoding="utf-8") as file:
            text = file.read()
        for name in result["emissions"]:
            self.assertIn(f'Name="radiosity, {name}"', text)

    def test_a_reflectivity_that_varies_has_a_certificate(self):
        self.write("bent.json", {"schema": "radcert/problem/1", "surface": {"name": "tetrahedron"},
                                 "triangulation": {"levels": [0]}, "basis": {"family": "inset", "degree": 0},
                                 "reflectivity": "1/4 + x/8", "emission": "3/4 - x/8"})
        self.expect(0, "solve", "bent.json", "--guarantee", "1/5", "--certificate", "c.json")
        with open(self.path("c.json"), encoding="utf-8") as file:
            certificate = json.load(file)
        jsonschema.validate(certificate, json.loads(self.expect(0, "schema", "certificate")))
        for mean in certificate["means"]:
            self.assertLessEqual(abs(float(mean["midpoint"]) - 1), float(mean["radius"]), mean["piece"])
        self.assertIn("verified", self.expect(0, "check", "c.json", "--part", "6"))
        certificate["problem"]["faces"][0]["reflectivity"]["polynomial"] = [["1/4"]] * 2
        self.write("changed.json", certificate)
        self.expect(2, "check", "changed.json")

    def test_an_ellipsoid_has_certificates_of_all_kinds(self):
        problem = {"schema": "radcert/problem/1", "surface": {"name": "ellipsoid", "a": 1, "b": "6/5", "c": "3/2"},
                   "triangulation": {"levels": [0]}, "basis": {"family": "inset", "degree": 0},
                   "reflectivity": "1/2 + x/8", "emission": "1/2 - x/8"}
        self.write("lit.json", problem)
        for of, words in [("means", ["means of u"]), ("values", ["values of u", "0,0,-3/2"]),
                          ("function", ["everywhere"])]:
            self.expect(0, "solve", "lit.json", "--guarantee", "1e-4", "--of", of, "--certificate", "c.json")
            with open(self.path("c.json"), encoding="utf-8") as file:
                certificate = json.load(file)
            jsonschema.validate(certificate, json.loads(self.expect(0, "schema", "certificate")))
            self.assertEqual(certificate["of"], of)
            self.assertLessEqual(float(certificate["width"]), 1e-4)
            # u = 1.
            for enclosed in certificate.get(of, []) if of != "function" else []:
                self.assertLessEqual(abs(float(enclosed["midpoint"]) - 1), float(enclosed["radius"]))
            report = self.expect(0, "check", "c.json", "--all")
            for word in ["verified", "all rows", *words]:
                self.assertIn(word, report)
            report = json.loads(self.expect(0, "check", "c.json", "--part", "4", "--json", "-"))
            jsonschema.validate(report, json.loads(self.expect(0, "schema", "check")))
            self.assertEqual(len(report["looked_at"]), 4)
            certificate["residual"] /= 2
            self.write("changed.json", certificate)
            self.assertIn("/digest", self.expect(1, "check", "changed.json"))
            for key, wrong in [("degree", 65), ("coefficients", ["0"]), ("residual", -1), ("bound", "x")]:
                self.write("changed.json", {**certificate, key: wrong})
                self.expect(2, "check", "changed.json")

    def test_degrees_to_10_reproduce_polynomials(self):
        # On plane faces a polynomial of the degree of the basis has no error but that of the integrals.
        def problem(degree, **changes):
            return self.write(f"p{degree}.json", {
                "schema": "radcert/problem/1", "surface": {"name": "two_squares"}, "triangulation": {"levels": [0]},
                "basis": {"family": "inset", "degree": degree, "alpha": "1/20"}, "reflectivity": "1/2",
                "solution": "(x + y/2 - z)^10 + x^8*y + (z - x)^9", **changes})

        def error(degree):
            return json.loads(self.solution(problem(degree)))["levels"][0]["node_error"]

        for degree in (8, 9):
            found = error(degree)
            self.assertGreater(found["value"], 1e3*found["radius"], degree)
        self.assertLess(error(10)["value"], 1e-11)
        for degree, changes, said in [(11, {}, "from 0 to 10"),
                                      (9, {"solver": {"name": "verified"}}, "a degree up to 8")]:
            done = self.run_program("solve", problem(degree, **changes))
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("/basis/degree", done.stderr.decode())
            self.assertIn(said, done.stderr.decode())

    def test_errors_are_null_without_a_solution_and_ratios_are_quotients_with_one(self):
        emitted = json.loads(self.solution(self.write("p.json", small(solution=None, emission="1"))))
        for level in emitted["levels"]:
            for key in ["discretisation_error", "node_error", "uniform_error", "discretisation_ratio", "node_ratio"]:
                self.assertIsNone(level[key])
        first, second = json.loads(self.solution(self.write("q.json", small())))["levels"]
        self.assertIsNone(first["node_ratio"])
        for name in ["node", "discretisation"]:
            quotient = first[name + "_error"]["value"] / second[name + "_error"]["value"]
            self.assertAlmostEqual(second[name + "_ratio"], quotient, delta=1e-12 * quotient)

    def test_results_are_the_same_for_every_number_of_threads(self):
        self.write("problem.json", small())
        results = set()
        for threads in ["1", "2", "3"]:
            results.add(without_circumstances(self.solution("problem.json", "--threads", threads,
                                                            RADCERT_STORE=os.path.join(self.store, threads))))
        self.assertEqual(len(results), 1)

    def test_results_are_the_same_from_every_folder_and_in_every_locale(self):
        self.write("problem.json", small())
        here = self.solution("problem.json")
        elsewhere = self.solution(self.path("problem.json"), cwd="/", RADCERT_STORE=os.path.join(self.store, "other"))
        self.assertEqual(without_circumstances(here), without_circumstances(elsewhere))
        available = subprocess.run(["locale", "-a"], capture_output=True, text=True, check=False).stdout.split()
        for name in ["C", *[n for n in available if n.startswith(("de_", "fr_"))][:2]]:
            there = self.solution("problem.json", LC_ALL=name, RADCERT_STORE=os.path.join(self.store, name))
            self.assertEqual(without_circumstances(here), without_circumstances(there), name)

    def test_a_second_run_recalls_the_levels_to_the_bit(self):
        self.write("problem.json", small())
        first = self.solution("problem.json")
        done = self.run_program("solve", "problem.json", "--json", "-")
        self.assertEqual(done.stdout.decode(), first, "seconds included")
        self.assertIn(b"found in the store", done.stderr)

    def test_a_damaged_store_is_computed_anew(self):
        self.write("problem.json", small())
        first = self.solution("problem.json")
        for name in os.listdir(self.store):
            with open(os.path.join(self.store, name), "r+b") as file:
                file.truncate(100)
        self.assertEqual(without_circumstances(self.solution("problem.json")), without_circumstances(first))

    def test_without_a_home_it_solves_all_the_same(self):
        self.write("problem.json", small())
        self.solution("problem.json", RADCERT_STORE="", XDG_CACHE_HOME="", HOME="")

    def test_the_solvers_agree_within_their_radii(self):
        levels = {}
        for name in self.solvers():
            levels[name] = json.loads(self.solution(self.write(name + ".json", small(solver={"name": name}))))["levels"]
        for name, of_solver in levels.items():
            for level, direct in zip(of_solver, levels["direct"]):
                apart = abs(level["node_error"]["value"] - direct["node_error"]["value"])
                self.assertLessEqual(apart, level["node_error"]["radius"] + direct["node_error"]["radius"], name)
                if level["iteration"] is not None:
                    self.assertLess(level["iteration"]["contraction"], 1)
        for direct, gmres, neumann in zip(levels["direct"], levels["gmres"], levels["neumann"]):
            self.assertIsNone(direct["iteration"])
            self.assertLess(neumann["planned_bytes"], direct["planned_bytes"])
            self.assertLess(gmres["iteration"]["iterations"], neumann["iteration"]["iterations"])

    def test_a_tolerance_that_is_not_reached_ends_with_1_and_no_result(self):
        for name in ["gmres", "neumann"]:
            problem = small(surface={"name": "cube"}, reflectivity="0.99", triangulation={"levels": [0]},
                            solver={"name": name, "tolerance": "5e-16"})
            self.write("problem.json", problem)
            done = self.run_program("solve", "problem.json", "--out", "out")
            said = done.stderr.decode()
            self.assertEqual(done.returncode, 1, said)
            self.assertEqual(done.stdout, b"")
            self.assertEqual(self.entries(), ["problem.json"])
            self.assertIn("level 0, solver " + name + ": the tolerance 5e-16 is not reached", said)

    def test_data_that_vanish_or_nearly_so_are_data(self):
        cube = dict(surface={"name": "cube"}, reflectivity="1/2", triangulation={"levels": [0]})
        for solver in self.solvers():
            for data in [{"emission": "0"}, {"emission": "1e-310"}, {"solution": "0"}, {"solution": "1e-320"},
                         {"solution": "1e-300*x"}]:
                problem = small(**cube, solver={"name": solver}, **{"solution": None, **data})
                done = self.run_program("solve", self.write("small.json", problem))
                self.assertIn(done.returncode, (0, 1), f"{solver} {data}: {done.stderr}")

    def test_progress_goes_to_stderr_and_quiet_silences_it(self):
        self.write("problem.json", small())
        self.assertIn(b"level 1: ", self.run_program("solve", "problem.json").stderr)
        self.assertEqual(self.run_program("solve", "problem.json", "--quiet").stderr, b"")


if __name__ == "__main__":
    unittest.main()
