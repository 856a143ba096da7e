# SPDX-License-Identifier: GPL-3.0-or-later
"""What radcert basis says of bases, and which files of nodes it refuses."""
import csv
import json
import os
import re
import unittest
from decimal import Decimal, localcontext
from fractions import Fraction

import jsonschema

from program import EXAMPLES, ProgramTest

MIDPOINTS = [["0", "1/2", "1/2"], ["1/2", "0", "1/2"], ["1/2", "1/2", "0"]]
# Six points of the circle x1^2 + x2^2 + x3^2 = 1/2.
CONIC = [["2/3", "1/6", "1/6"], ["1/6", "2/3", "1/6"], ["1/6", "1/6", "2/3"],
         ["0", "1/2", "1/2"], ["1/2", "0", "1/2"], ["1/2", "1/2", "0"]]


class Basis(ProgramTest):
    def schema(self, name):
        return json.loads(self.expect(0, "schema", name))

    def bases(self, *words):
        result = json.loads(self.expect(0, "basis", *words, "--json", "-"))
        jsonschema.validate(result, self.schema("basis"))
        return result["bases"]

    def basis(self, *words):
        bases = self.bases(*words)
        self.assertEqual(len(bases), 1)
        return bases[0]

    def precision(self, basis):
        return tuple(basis["precision"][region]["degree"] for region in ["triangle", "parallelogram"])

    def nodes(self, degree, nodes, **more):
        return {"schema": "radcert/nodes/1", "degree": degree, "nodes": nodes, **more}

    def refuse(self, content, *said):
        self.write("bad.json", content)
        done = self.run_program("basis", "bad.json")
        self.assertEqual(done.returncode, 2, done.stderr)
        message = done.stderr.decode()
        self.assertEqual(message.count("\n"), 1, message)
        for words in ["bad.json", *said]:
            self.assertIn(words, message)

    def test_linear_interpolation_is_known_exactly(self):
        basis = self.basis("inset", "--degree", "1", "--alpha", "1/6")
        self.assertEqual([node["weight"] for node in basis["nodes"]], ["1/6"] * 3)
        self.assertEqual(basis["nodes"][0]["barycentric"], ["2/3", "1/6", "1/6"])
        self.assertEqual(self.precision(basis), (2, 3))
        self.assertEqual(basis["precision"]["triangle"]["first_failure"], "s^3")
        self.assertEqual(basis["determinant"], "1/4")
        self.assertLessEqual(basis["norm"]["lower"], 7 / 3)
        self.assertGreaterEqual(basis["norm"]["upper"], 7 / 3)
        self.assertEqual(basis["orders"], {"everywhere": 2, "nodes_smooth": 4, "nodes_smooth_logarithm": True,
                                           "nodes_smooth_kernel": 4, "nodes_at_edges": 2})

    def test_algebraic_nodes_have_the_precision_of_the_exact_rule(self):
        number = {"polynomial": ["3888/5", "-15552", "93312", "-186624", "104976"]}
        nodes = [[f"1-2*{v}" if k == i else v for k in range(3)] for v in "xy" for i in range(3)]
        self.write("six.json", self.nodes(2, nodes, numbers={"x": dict(number, between=["0.09", "0.1"]),
                                                             "y": dict(number, between=["0.44", "0.45"])}))
        basis = self.basis("six.json")
        self.assertEqual(self.precision(basis), (4, 5))
        self.assertEqual(basis["precision"]["triangle"]["proof"], "algebraic")
        self.assertEqual(basis["orders"]["nodes_smooth"], 5)
        self.assertIn("4 (exact, for the algebraic nodes)", self.expect(0, "basis", "six.json"))

    def test_weights_sum_to_the_area_and_signs_are_counted(self):
        for basis in self.bases("inset", "--degree", "0-6", "--alpha", "0.1"):
            weights = [Fraction(node["weight"]) for node in basis["nodes"]]
            self.assertAlmostEqual(float(sum(weights)), 0.5, 15)
            signs = {"positive": sum(w > 0 for w in weights), "zero": sum(w == 0 for w in weights),
                     "negative": sum(w < 0 for w in weights)}
            self.assertEqual(basis["weight_signs"], signs)
            self.assertLessEqual(basis["norm"]["lower"], basis["condition"])
            parity = 1 if basis["degree"] % 2 == 0 else 0
            self.assertEqual(basis["precision"]["parallelogram"]["degree"], basis["degree"] + parity)

    def test_the_superconvergent_alpha_is_found_or_proved_to_be_missing(self):
        self.assertEqual(self.precision(self.basis("inset", "--degree", "1", "--alpha", "superconvergent")), (2, 3))
        three = self.basis("inset", "--degree", "3", "--alpha", "superconvergent")
        self.assertEqual(self.precision(three), (4, 5))
        self.assertEqual(three["precision"]["triangle"]["proof"], "algebraic")
        # (7 - sqrt 34)/15
        alpha = Fraction(three["nodes"][0]["barycentric"][1])
        self.assertLess(abs((7 - 15 * alpha) ** 2 - 34), Fraction(1, 10**57))
        for degree in ["2", "4", "5", "6", "7"]:
            done = self.run_program("basis", "inset", "--degree", degree, "--alpha", "superconvergent")
            self.assertEqual(done.returncode, 2)
            self.assertIn(b"it is proven that no alpha", done.stderr)

    def test_symmetric_sets_have_their_precision_and_positive_weights(self):
        expected = {1: (2, 3), 2: (4, 5), 3: (5, 5), 4: (7, 7), 5: (9, 9), 6: (10, 11)}
        bases = self.bases("symmetric", "--degree", "1-6")
        self.assertEqual([basis["degree"] for basis in bases], sorted(expected))
        for basis in bases:
            self.assertEqual(self.precision(basis), expected[basis["degree"]])
            self.assertEqual(basis["weight_signs"]["positive"], len(basis["nodes"]))
        self.assertEqual([basis["orders"]["nodes_smooth"] for basis in bases], [4, 5, 6, 7, 8, 9])

    def test_a_file_of_nodes_is_read_as_it_was_written(self):
        for words in [("symmetric", "--degree", "3"), ("inset", "--degree", "2", "--alpha", "0.07")]:
            there = self.basis(*words, "--nodes", "nodes.json")
            with open(self.path("nodes.json"), encoding="utf-8") as file:
                nodes = json.load(file)
            jsonschema.validate(nodes, self.schema("nodes"))
            again = self.basis("nodes.json")
            for key in ["nodes", "precision", "norm", "condition", "determinant", "orders"]:
                self.assertEqual(there[key], again[key], key)

    def test_symmetric_nodes_are_searched_and_proved(self):
        # Degree 5, where no inset has the precision that superconvergence needs; the file solves and is proved again.
        result = json.loads(self.expect(0, "basis", "search", "--degree", "5", "--starts", "64", "--nodes", "n.json",
                                        "--json", "-"))
        jsonschema.validate(result, self.schema("basis"))
        self.assertEqual({key: result["search"][key] for key in ("precision", "positive", "starts", "seed")},
                         {"precision": 8, "positive": False, "starts": 64, "seed": 1})
        found = result["bases"][0]
        self.assertEqual(self.precision(found), (8, 9))
        self.assertEqual(found["orders"]["nodes_smooth"], 8)
        self.assertFalse(found["orders"]["nodes_smooth_logarithm"])
        self.assertLess(found["norm"]["upper"], 7)
        again = self.basis("n.json")
        for key in ["nodes", "precision", "norm", "condition", "determinant", "orders"]:
            self.assertEqual(found[key], again[key], key)
        # The largest precision is that of the set that comes with radcert; without one the norm is less.
        self.assertEqual(self.precision(self.basis("search", "--degree", "5", "--goal", "precision")), (9, 9))
        free = self.basis("search", "--degree", "3", "--goal", "norm", "--nodes", "free.json")
        self.assertEqual(free["precision"]["triangle"]["proof"], "exact")
        self.assertLess(free["norm"]["upper"], self.basis("symmetric", "--degree", "3")["norm"]["lower"])
        self.assertEqual(self.basis("free.json")["norm"], free["norm"])
        positive = self.basis("search", "--degree", "4", "--positive", "--starts", "64")
        self.assertEqual(positive["weight_signs"]["positive"], 15)
        self.assertIn("orbits, of which no other numbers are unisolvent: 2 of three",
                      self.expect(0, "basis", "search", "--degree", "2", "--starts", "8"))

    def test_nodes_without_symmetry_are_proved_again_where_they_are_read(self):
        found = self.basis("search", "--degree", "3", "--symmetric", "off", "--starts", "8", "--nodes", "n.json")
        with open(self.path("n.json"), encoding="utf-8") as file:
            jsonschema.validate(json.load(file), self.schema("nodes"))
        again = self.basis("n.json")
        self.assertEqual(again["precision"]["triangle"]["proof"], "certificate")
        for key in ["nodes", "precision", "product_precision", "norm", "condition", "determinant", "orders"]:
            self.assertEqual(found[key], again[key], key)
        # On either triangle of a parallelogram P p is another polynomial: products gain less than the rule.
        self.assertEqual(self.precision(again), (4, 7))
        self.assertEqual(again["product_precision"], {"triangle": 4, "parallelogram": 5})
        self.assertTrue(again["orders"]["nodes_smooth_logarithm"])
        self.assertIn("4, parallelogram 5 (proved, for the true nodes beside these)", self.expect(0, "basis", "n.json"))
        even = self.basis("search", "--degree", "2", "--symmetric", "off", "--starts", "16")
        self.assertEqual(self.precision(even), (4, 5))

    def test_searches_that_find_nothing_or_are_none_say_so(self):
        done = self.run_program("basis", "search", "--degree", "9", "--goal", "precision", "--starts", "1",
                                "--nodes", "none.json")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("that there are none is not said", done.stderr.decode())
        for words, said in [(["--degree", "11"], "from 1 to 10"), (["--degree", "2-3"], "the degree of one search"),
                            ([], "--degree"), (["--degree", "5", "--precision", "10"], "from 5 to 9"),
                            (["--degree", "7", "--precision", "8"], "more numbers would have to be held"),
                            (["--degree", "5", "--goal", "best"], "orders, precision, parallelogram, norm"),
                            (["--degree", "5", "--goal", "norm", "--precision", "7"], "--goal"),
                            (["--degree", "5", "--starts", "0"], "--starts"),
                            (["--degree", "5", "--seed", "-1"], "--seed"),
                            (["--degree", "5", "--seconds", "1.5"], "--seconds"),
                            (["--degree", "5", "--alpha", "0.1"], "has no meaning")]:
            done = self.run_program("basis", "search", *words)
            self.assertEqual(done.returncode, 2, (words, done.stderr))
            self.assertIn(said, done.stderr.decode())
        for words in (["symmetric", "--degree", "2", "--goal", "norm"], ["inset", "--degree", "0", "--positive"]):
            done = self.run_program("basis", *words)
            self.assertEqual(done.returncode, 2, (words, done.stderr))
            self.assertIn("has no meaning", done.stderr.decode())
        self.assertEqual(self.entries(), [])

    def test_a_parallelogram_asks_for_less_than_the_triangle(self):
        # Of symmetric nodes an even degree on the triangle has one more on the parallelogram: 4 is as good as 5 there.
        found = self.basis("search", "--degree", "3", "--goal", "parallelogram", "--starts", "32")
        precise = self.basis("search", "--degree", "3", "--goal", "precision", "--starts", "32")
        self.assertEqual((self.precision(found), self.precision(precise)), ((4, 5), (5, 5)))
        self.assertLess(found["norm"]["upper"], precise["norm"]["lower"])
        for words, said in [(["table"], "--out"), (["table", "--out", "d", "--degree", "11"], "from 1 to 10"),
                            (["table", "--out", "d", "--degree", "5", "--symmetric", "off"], "from 1 to 4"),
                            (["table", "--out", "d", "--symmetric", "no"], "on, off"),
                            (["table", "--out", "d", "--nodes", "n.json"], "has no meaning"),
                            (["search", "--degree", "3", "--out", "d"], "has no meaning")]:
            done = self.run_program("basis", *words)
            self.assertEqual(done.returncode, 2, (words, done.stderr))
            self.assertIn(said, done.stderr.decode())

    def test_the_published_table_is_what_the_program_says(self):
        folder = os.path.join(EXAMPLES, "..", "..", "papers", "radcert", "tables")
        tables = []
        for name in ("nodes.csv", "free.csv"):
            with open(os.path.join(folder, name), newline="", encoding="utf-8") as file:
                tables.append(list(csv.DictReader(file)))
        rows, without_symmetry = tables
        self.assertEqual([int(row["degree"]) for row in rows], list(range(1, 11)))
        self.assertEqual([int(row["degree"]) for row in without_symmetry], [3])
        for row in rows + without_symmetry:
            path = os.path.join(folder, row["file"])
            with open(path, encoding="utf-8") as file:
                nodes = json.load(file)
            self.assertEqual(len(nodes["nodes"]), int(row["nodes"]))
            self.assertEqual(nodes["certificate"]["precision"], int(row["precision_triangle"]))
            if int(row["degree"]) > 5:  # a proof takes seconds
                continue
            basis = self.basis(path)
            self.assertEqual(self.precision(basis), (int(row["precision_triangle"]), int(row["precision_parallelogram"])))
            self.assertEqual(basis["precision"]["triangle"]["proof"], "certificate")
            self.assertEqual([basis["norm"]["lower"], basis["norm"]["upper"]],
                             [float(row["norm_lower"]), float(row["norm_upper"])])
            orders = basis["orders"]
            self.assertEqual([orders["everywhere"], orders["nodes_smooth"], orders["nodes_smooth_kernel"]],
                             [int(row[key]) for key in ("order_everywhere", "order_nodes", "order_smooth_kernel")])
            self.assertEqual(orders["nodes_smooth_logarithm"], row["logarithm"] == "true")
        # A measured order again, by solve.
        self.write("two.json", {"schema": "radcert/problem/1", "surface": {"name": "two_piece", "p": 2},
                                "triangulation": {"levels": [0, 1, 2, 3]}, "reflectivity": "1/2",
                                "solution": "exp(2*(x/2 + y/4 - z/8))", "basis": {"file": os.path.join(folder, "nodes_2.json")}})
        fit = json.loads(self.expect(0, "solve", "two.json", "--json", "-"))["orders"]["node_error"]
        self.assertEqual(" ".join(map(str, fit["levels"])), rows[1]["two_piece_levels"])
        self.assertAlmostEqual(fit["order"], float(rows[1]["two_piece_order"]), places=9)

    def test_csv_and_latex_have_a_row_each(self):
        self.expect(0, "basis", "inset", "--degree", "1-3", "--alpha", "1/10", "--csv", "b.csv", "--latex", "b.tex")
        with open(self.path("b.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 3 + 6 + 10)
        self.assertEqual(rows[0], {"degree": "1", "node": "0", "x1": "4/5", "x2": "1/10", "x3": "1/10",
                                   "weight": "1/6"})
        with open(self.path("b.tex"), encoding="utf-8") as file:
            self.assertEqual(file.read().count(r" \\"), 4)

    def test_nodes_of_ones_own(self):
        self.write("mine.json", self.nodes(1, MIDPOINTS))
        basis = self.basis("mine.json")
        self.assertEqual(self.precision(basis), (2, 3))
        self.assertEqual(basis["condition"], 3)
        self.assertEqual(basis["file"], "mine.json")

    def test_files_of_nodes_that_are_none_are_refused_with_the_reason(self):
        self.refuse(self.nodes(1, MIDPOINTS[:2]), "/nodes", "has 2 nodes: too few", "3 nodes for degree 1")
        self.refuse(self.nodes(1, MIDPOINTS + MIDPOINTS[:1]), "has 4 nodes: too many")
        self.refuse(self.nodes(1, MIDPOINTS[:2] + MIDPOINTS[:1]), "/nodes/2", "is the same point as node 0")
        self.refuse(self.nodes(1, [["-0.1", "0.6", "0.5"]] + MIDPOINTS[1:]), "/nodes/0/0", "outside the triangle")
        self.refuse(self.nodes(1, [["0.1", "0.6", "0.5"]] + MIDPOINTS[1:]), "/nodes/0", "has the sum 1.2")
        self.refuse(self.nodes(1, [["0.5", "0.5"]] + MIDPOINTS[1:]), "/nodes/0", "has 2 coordinates")
        self.refuse(self.nodes(2, CONIC), "/nodes", "not unisolvent",
                    "a polynomial of degree 2 other than zero vanishes at all 6 nodes", "Bernstein coefficients")
        self.refuse(self.nodes(1, [["0", "1/2", "1/2"], ["1/4", "1/4", "1/2"], ["1/2", "0", "1/2"]]), "not unisolvent")
        self.refuse(self.nodes(1, MIDPOINTS, weight=[]), "/weight", "unknown key")
        self.refuse(self.nodes(13, MIDPOINTS), "/degree", "from 0 to 12")
        self.refuse(self.nodes(1.5, MIDPOINTS), "/degree", "not a whole number")
        self.refuse(self.nodes(1, [["a", "b", "c"]] + MIDPOINTS[1:]), "/nodes/0/0", "is not a number")
        self.refuse(self.nodes(1, 3), "/nodes", "is a number")
        self.refuse({"degree": 1, "nodes": MIDPOINTS}, "/schema", "is missing")
        self.refuse("[]", "is an array")
        self.refuse("{", "line 1")

    def test_coordinates_may_be_zeros_of_polynomials(self):
        coordinates = [["1 - 2*x", "x", "x"], ["x", "1 - 2*x", "x"], ["x", "x", "1 - 2*x"]]

        def with_number(between):
            return self.nodes(1, coordinates, numbers={"x": {"polynomial": ["1", "-14", "15"], "between": between}})

        content = with_number(["0.07", "0.08"])
        jsonschema.validate(content, self.schema("nodes"))
        self.write("good.json", content)
        x = Fraction(self.basis("good.json")["nodes"][0]["barycentric"][1])
        self.assertLess(abs(15 * x * x - 14 * x + 1), Fraction(1, 10**57))
        self.refuse(with_number(["0.2", "0.3"]), "/numbers/x/between", "holds no zero of 15 x^2 - 14 x + 1")
        self.refuse(with_number(["0", "1"]), "/numbers/x/between", "holds 2 zeros")

    def test_radons_seven_points_have_precision_five(self):
        # a, b = (6 -+ sqrt 15)/21, the zeros of 21 x^2 - 12 x + 1; the space is that of degree 2 and a bubble.
        space = ["1", "x1", "x2", "x1*x2", "x2*x3", "x1*x3", "x1*x2*x3"]
        orbit = [["1-2*{0}", "{0}", "{0}"], ["{0}", "1-2*{0}", "{0}"], ["{0}", "{0}", "1-2*{0}"]]
        nodes = [["1/3"] * 3] + [[x.format(n) for x in node] for n in ("x", "y") for node in orbit]
        polynomial = ["1", "-12", "21"]
        self.write("radon.json", {"schema": "radcert/nodes/1", "space": space, "nodes": nodes,
                                  "numbers": {"x": {"polynomial": polynomial, "between": ["0.1", "0.11"]},
                                              "y": {"polynomial": polynomial, "between": ["0.46", "0.48"]}}})
        out = self.expect(0, "basis", "radon.json")
        self.assertRegex(out, r"precision, triangle +5 \(exact, for the algebraic nodes\); misses s\^6 by")
        self.assertNotIn("rounding of the nodes", out)
        # The same in 16 decimals.
        with localcontext() as context:
            context.prec = 40
            places = Decimal(10) ** -16
            values = [((6 + sign * Decimal(15).sqrt()) / 21).quantize(places) for sign in (-1, 1)]
            rounded = [["1/3"] * 3]
            for t in values:
                rounded += [[str(1 - 2 * t if k == at else t) for k in range(3)] for at in range(3)]
        self.write("rounded.json", {"schema": "radcert/nodes/1", "space": space, "nodes": rounded})
        # The same decimals with a certificate: the precision is that of the true nodes beside them.
        certificate = {"method": "krawczyk", "precision": 5, "radius": "1e-15",
                       "orbits": [{"size": 1, "held": False}, {"size": 3, "held": False}, {"size": 3, "held": False}]}
        self.write("certified.json", {"schema": "radcert/nodes/1", "space": space, "nodes": rounded,
                                      "certificate": certificate})
        certified = self.expect(0, "basis", "certified.json")
        self.assertRegex(certified, r"precision, triangle +5 \(proved, for the true nodes beside these\); misses s\^6 by")
        pattern = r"(?m)^order .*$"
        self.assertEqual(re.findall(pattern, certified), re.findall(pattern, out))
        for wrong in ({**certificate, "precision": 6}, {**certificate, "radius": "1e-18"},
                      {**certificate, "orbits": certificate["orbits"][:2]}):
            self.write("wrong.json", {"schema": "radcert/nodes/1", "space": space, "nodes": rounded,
                                      "certificate": wrong})
            self.assertEqual(self.run_program("basis", "wrong.json").returncode, 2)
        out = self.expect(0, "basis", "rounded.json")
        self.assertRegex(out, r"precision, triangle +3 \(exact\); misses s\^4 by .*, likely the rounding of the nodes' "
                              r"decimals")

    def test_the_symmetric_sets_are_shipped_as_the_program_writes_them(self):
        for degree in range(1, 7):
            name = f"symmetric_{degree}.json"
            self.expect(0, "basis", "symmetric", "--degree", str(degree), "--nodes", name)
            files = []
            for folder in (self.folder, os.path.join(EXAMPLES, "nodes")):
                with open(os.path.join(folder, name), encoding="utf-8") as file:
                    files.append({key: value for key, value in json.load(file).items()
                                  if key not in ("radcert", "command")})
            self.assertEqual(files[0], files[1], name)

    def test_the_searched_sets_that_are_shipped_are_proved(self):
        for degree, precision, norm in ((5, (8, 9), 5.055), (6, (9, 9), 4.193), (7, (10, 11), 4.803)):
            basis = self.basis(os.path.join(EXAMPLES, "nodes", f"superconvergent_{degree}.json"))
            self.assertEqual((self.precision(basis), basis["degree"]), (precision, degree))
            self.assertEqual(basis["precision"]["triangle"]["proof"], "certificate")
            self.assertEqual(basis["orders"]["nodes_smooth"], degree + 3)
            self.assertFalse(basis["orders"]["nodes_smooth_logarithm"])
            self.assertLess(basis["norm"]["upper"], norm)
        # Reading the file proves its certificate.
        self.write("eight.json", {"schema": "radcert/problem/1", "surface": {"name": "two_squares"},
                                  "triangulation": {"levels": [0]}, "reflectivity": "1/2", "emission": "1/2",
                                  "basis": {"file": os.path.join(EXAMPLES, "nodes", "superconvergent_8.json")}})
        self.assertEqual(json.loads(self.expect(0, "solve", "eight.json", "--json", "-"))["levels"][0]["unknowns"], 180)

    def test_certificates_that_prove_nothing_are_refused(self):
        self.expect(0, "basis", "symmetric", "--degree", "2", "--nodes", "good.json")
        with open(self.path("good.json"), encoding="utf-8") as file:
            good = json.load(file)

        def changed(**changes):
            return {**good, "certificate": {**good["certificate"], **changes}}

        self.refuse(changed(precision=5), "/certificate", "proves nothing")
        self.refuse(changed(radius="1e-70"), "/certificate", "does not lie inside")
        self.refuse(changed(radius="0"), "/certificate/radius", "a positive number")
        self.refuse(changed(orbits=[{"size": 6, "held": False}]), "/certificate/orbits", "does not make the nodes")
        self.refuse(changed(orbits=[{"size": 2, "held": False}]), "/certificate/orbits/0/size", "1, 3 or 6")
        self.refuse(changed(method="newton"), "/certificate/method", "krawczyk")
        moved = json.loads(json.dumps(good))
        for node in moved["nodes"][:3]:
            for i, x in enumerate(node):
                node[i] = "1/12" if x.startswith("0.09") else "5/6"
        self.refuse(moved, "/certificate", "proves nothing")

    def test_bad_words_are_refused(self):
        for words, said in [(["inset"], "--degree"), (["inset", "--degree", "2"], "--alpha"),
                            (["inset", "--degree", "13", "--alpha", "0.1"], "from 0 to 12"),
                            (["inset", "--degree", "3-1", "--alpha", "0.1"], "the smaller one first"),
                            (["inset", "--degree", "2", "--alpha", "1/3"], "[0, 1/3)"),
                            (["inset", "--degree", "2", "--alpha", "x"], "[0, 1/3)"),
                            (["symmetric", "--degree", "7"], "from 1 to 6"),
                            (["symmetric", "--degree", "2", "--alpha", "0.1"], "has no meaning"),
                            (["insett", "--degree", "2"], "did you mean inset?"),
                            (["missing.json"], "missing.json"),
                            (["inset", "--degree", "1-2", "--alpha", "0.1", "--nodes", "n.json"], "one degree")]:
            done = self.run_program("basis", *words)
            self.assertEqual(done.returncode, 2, (words, done.stderr))
            self.assertIn(said, done.stderr.decode())
        self.assertEqual(self.entries(), [])

    def test_symmetric_nodes_solve_and_their_file_solves_alike(self):
        problem = {"schema": "radcert/problem/1", "surface": {"name": "sphere"},
                   "triangulation": {"levels": [0, 1]}, "basis": {"family": "symmetric", "degree": 2},
                   "reflectivity": "1/2", "solution": "exp(z)"}
        self.expect(0, "basis", "symmetric", "--degree", "2", "--nodes", "nodes.json")
        self.write("family.json", problem)
        self.write("file.json", {**problem, "basis": {"file": "nodes.json"}})
        levels = [json.loads(self.expect(0, "solve", name, "--json", "-"))["levels"]
                  for name in ("family.json", "file.json")]
        self.assertEqual(levels[0], levels[1])
        # Six nodes of precision 5 on the parallelogram: the error falls by more than 2^4.
        self.assertGreater(levels[0][1]["node_ratio"], 16)

if __name__ == "__main__":
    unittest.main()
