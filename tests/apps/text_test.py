# SPDX-License-Identifier: GPL-3.0-or-later
"""What the commands print for people against the JSON of the same run: each printed midpoint and radius, read as decimals, encloses the
double and the radius that JSON has, and each printed bound is no smaller than the one there. Fractions compare, nothing rounds."""
import csv
import json
import math
import os
import random
import re
import shutil
import struct
import subprocess
import unittest
from fractions import Fraction

from program import ProgramTest, small

WEB = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../verification/report/web/src")

# Two triangles of the bottom make an edge: no face is cut.
PYRAMID = "OFF\n5 6 0\n0 0 0\n1 0 0\n1 1 1\n0 1 0\n0.5 0.5 3\n3 0 3 2\n3 0 2 1\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n"


def tetrahedron(rng):
    """A closed mesh whose areas and factors are no short decimals."""
    while True:
        at = [[rng.random() for _ in range(3)] for _ in range(4)]
        a, b, c = ([p - q for p, q in zip(at[i], at[0])] for i in (1, 2, 3))
        volume = sum(a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3]) for i in range(3))
        if volume < -0.02:
            return "OFF\n4 4 0\n" + "".join(" ".join(map(repr, p)) + "\n" for p in at) + \
                "3 0 1 2\n3 0 3 1\n3 1 3 2\n3 0 2 3\n"


def cells(line):
    return re.split(r" {2,}", line.strip())


class Text(ProgramTest):
    def encloses(self, text, around, value, radius):
        """[value - radius, value + radius] lies in what is printed."""
        needed = abs(Fraction(value) - Fraction(text)) + Fraction(radius)
        self.assertLessEqual(needed, Fraction(around), f"{text} +- {around} of {value!r} +- {radius!r}")

    def is_above(self, text, bound):
        self.assertLessEqual(Fraction(bound), Fraction(text), f"{text} of {bound!r}")

    def pair(self, head, row, column, figure):
        """A cell and its radius beside it, against {"value": ..., "radius": ...} or null."""
        place = head.index(column)
        has_radius = head[place + 1:place + 2] == ["+-"]
        if figure is None:
            self.assertEqual(row[place], "-")
        elif figure["radius"] is None:
            self.assertIn(row[place + 1] if has_radius else "-", ["-"], column)
        else:
            self.assertTrue(has_radius, column)
            self.encloses(row[place], row[place + 1], figure["value"], figure["radius"])

    def both(self, *words):
        """The text and the JSON of one run."""
        text = self.expect(0, *words, "--json", "out.json")
        with open(self.path("out.json"), encoding="utf-8") as file:
            return text, json.load(file)

    def test_the_tables_of_solve(self):
        problems = [small(), small(solver={"name": "gmres"}), small(solver={"name": "neumann"}, reflectivity="0.3"),
                    small(surface={"name": "cube"}, reflectivity="0.8", solution="2 + x*y/10 - z^2/5", solver={"name": "verified"}),
                    small(surface={"name": "cube"}, reflectivity={"floor": "0.1", "*": "1/3"}, triangulation={"levels": [0, 1, 2]}),
                    small(surface={"name": "cube"}, reflectivity="0.7", solution=None, emission="1")]
        for problem in problems:
            with self.subTest(json.dumps(problem)):
                text, result = self.both("solve", self.write("problem.json", problem))
                lines = text.splitlines()
                head = cells(lines[0])
                for line, level in zip(lines[1:], result["levels"]):
                    row = cells(line)
                    if "solution" in problem:
                        self.pair(head, row, "|K(I-P_n)u|", level["discretisation_error"])
                        self.pair(head, row, "|u-u_n| nodes", level["node_error"])
                        self.pair(head, row, "|u-u_n| sample", level["uniform_error"])
                    self.pair(head, row, "norm K", level["norm_K"])
                    self.assertEqual(level["norm_K"]["radius"] is not None, level["norm_K"]["guaranteed"])
                    if level["verified"]:
                        bound = re.search(rf"([0-9.e-]+) \(level {level['level']}\)", text).group(1)
                        self.is_above(bound, level["verified"]["solution_radius"])
                iterated = [level["iteration"] for level in result["levels"] if level["iteration"]]
                if iterated:
                    said = re.search(r"contraction at most (\S+), error of the linear system at most (\S+)\n", text)
                    self.is_above(said.group(1), max(each["contraction"] for each in iterated))
                    self.is_above(said.group(2), max(each["error_bound"] for each in iterated))
                for quantity, words in [("node_error", r"\|u-u_n\| at the nodes"), ("discretisation_error", r"\|K\(I-P_n\)u\|")]:
                    said = re.search(rf"Order of {words} in h: (\S+) \+- (\S+) ", text)
                    if said:
                        fit = result["orders"][quantity]
                        self.encloses(said.group(1), said.group(2), fit["order"], fit["halfwidth"])

    def factors(self, *words):
        text, report = self.both("factors", *words, "--out", "out.csv")
        lines = text.splitlines()
        head = cells(lines[1])
        for line, row in zip(lines[2:], report["surfaces"][:20]):
            shown = cells(line)
            self.pair(head, shown, "area", {"value": row["area"], "radius": row["area_radius"]})
            self.pair(head, shown, "row sum", {"value": row["row_sum"], "radius": row["row_radius"]})
            if report["open"]:
                self.pair(head, shown, "to space", {"value": row["to_space"], "radius": row["to_space_radius"]})
        self.is_above(re.search(r"largest radius of a factor: (\S+), (\w+)", text).group(1),
                      max(Fraction(entry["radius"]) for entry in report["factors"]))
        # The doubles as published, by the definitions.
        area = {row["name"]: Fraction(row["area"]) for row in report["surfaces"]}
        factor = {(entry["from"], entry["to"]): Fraction(entry["factor"]) for entry in report["factors"]}
        said = Fraction(re.search(r"A_j F_ji\| <= (\S+) sqrt", text).group(1))
        for (a, b), value in factor.items():
            defect = area[a] * value - area[b] * factor.get((b, a), 0)
            self.assertLessEqual(defect**2, said**2 * area[a] * area[b], (a, b))
        if not report["open"]:
            self.is_above(re.search(r"as given are within (\S+) of 1", text).group(1),
                          max(abs(Fraction(row["row_sum"]) - 1) for row in report["surfaces"]))
        # CSV has the doubles of JSON.
        with open(self.path("out.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(float(row["factor"]), float(row["radius"])) for row in rows],
                         [(entry["factor"], entry["radius"]) for entry in report["factors"]])
        return text, report

    def test_the_tables_of_factors(self):
        self.write("pyramid.off", PYRAMID)
        for words in [["cube"], ["cube", "--by", "piece", "--certified"], ["two_squares", "--space"],
                      ["two_squares", "--space", "--certified"], ["tetrahedron", "--level", "1"], ["octahedron", "--certified"],
                      ["pyramid.off", "--certified", "--accuracy", "1e-2"], ["pyramid.off"]]:
            with self.subTest(" ".join(words)):
                text, report = self.factors(*words)
                self.assertIn("guaranteed" if report["guaranteed"] else "estimated", text)

    def test_the_factors_of_scenes_with_long_decimals(self):
        rng = random.Random(5)
        for _ in range(4):
            self.write("scene.off", tetrahedron(rng))
            self.factors("scene.off", "--certified")
            self.factors("scene.off")

    def test_a_comparison_of_factors(self):
        self.expect(0, "factors", "cube", "--by", "piece", "--out", "theirs.csv")
        with open(self.path("theirs.csv"), encoding="utf-8") as file:
            content = file.read()
        self.write("theirs.csv", re.sub(r"(0\.[0-9]{6})[0-9]*,[^,]*,", r"\1,1e-6,", content))
        text, report = self.both("factors", "cube", "--by", "piece", "--compare", "theirs.csv")
        lines = text.splitlines()
        start = next(i for i, line in enumerate(lines) if line.startswith("compared"))
        head = cells(lines[start + 1])
        self.assertEqual(head, ["from", "to", "ours", "+-", "theirs", "+-", "apart at most", "verdict", "cause"])
        for line, pair in zip(lines[start + 2:], report["comparison"]["worst"]):
            row = cells(line)
            self.pair(head, row, "ours", {"value": pair["ours"], "radius": pair["radius"]})
            self.pair(head, row, "theirs", {"value": pair["theirs"], "radius": pair["halfwidth"]})
            self.is_above(row[6], abs(Fraction(pair["ours"]) - Fraction(pair["theirs"])))

    def test_the_norm_of_a_basis(self):
        for words in [["inset", "--degree", "0-3", "--alpha", "0.1"], ["symmetric", "--degree", "1-3"]]:
            text, found = self.both("basis", *words)
            lines = text.splitlines()
            head = cells(lines[1])
            for line, basis in zip(lines[2:], found["bases"]):
                row = cells(line)
                place = head.index("norm of P_n")
                middle, around = Fraction(row[place]), Fraction(row[place + 1])
                # JSON is rounded outwards to doubles.
                for bound, sign in [("lower", -1), ("upper", 1)]:
                    inwards = Fraction(math.nextafter(basis["norm"][bound], -sign * math.inf))
                    self.assertLessEqual(sign * inwards, sign * middle + around)
                one, _ = self.both("basis", words[0], "--degree", str(basis["degree"]), *words[3:])
                said = re.search(r"norm of P_n +(\S+)(?: \+- (\S+))? \(proved\)", one)
                self.assertLessEqual(abs(Fraction(said.group(1)) - middle), around + Fraction(said.group(2) or 0))
                condition = row[head.index("condition")].replace("<= ", "")
                self.is_above(condition, math.nextafter(basis["condition"], 0))

    def test_a_reference_value(self):
        for name in ["cube_opposite_faces", "coaxial_disks_1_1_1", "squares_common_edge_60_degrees"]:
            for digits in ["3", "20", "50"]:
                text, found = self.both("reference", name, "--digits", digits)
                value = re.search(r"^value +(\S+)$", text, re.MULTILINE).group(1)
                radius = re.search(r"^radius +(\S+) \(proved\)$", text, re.MULTILINE).group(1)
                exact = [Fraction(int(found[key]["mantissa"])) * Fraction(2)**int(found[key]["exponent"])
                         for key in ("midpoint_binary", "radius_binary")]
                self.encloses(value, radius, *exact)
                self.encloses(found["midpoint"], found["radius"], *exact)

    def test_the_table_of_verify_and_its_report(self):
        what = ["verify", "ac98/equation_37", "ac98/table_4.n48"]
        text, report = self.both(*what, "--out", "report")
        with open(self.path("report/report.md"), encoding="utf-8") as file:
            page = file.read()
        shown = 0
        for claim in report["claims"]:
            if not claim["ours"]:
                continue
            shown += 1
            for source in (text, page):
                line = next(line for line in source.splitlines() if claim["label"] + " " in line and "±" in line)
                value, radius = re.search(r"(\S+) ± (\S+)", line).groups()
                self.encloses(value, radius, claim["ours"]["value"], claim["ours"]["radius"])
        self.assertGreater(shown, 3)

    @unittest.skipUnless(shutil.which("node"), "no Node here")
    def test_the_page_rounds_outwards_as_well(self):
        rng = random.Random(11)

        def nasty():
            kind = rng.randrange(4)
            if kind == 0:
                x = struct.unpack("<d", rng.randbytes(8))[0]
            elif kind == 1:
                x = math.nextafter(10.0**rng.randrange(-300, 300), rng.choice([0, math.inf]))
            elif kind == 2:
                x = rng.randrange(1 << rng.randrange(1, 53)) * 5e-324
            else:
                x = rng.random() * 10.0**rng.randrange(-9, 6)
            return x if math.isfinite(x) else 1.0

        pairs = [(nasty(), abs(nasty()) if rng.random() < 0.5 else 0) for _ in range(600)]
        pairs += [(value, abs(value) * 10**-rng.uniform(0, 16)) for value, _ in pairs]
        pairs = [(value, radius) for value, radius in pairs if math.isfinite(radius)]
        self.write("pairs.json", json.dumps(pairs))
        self.write("text.mjs", f"""import {{ readFileSync }} from "node:fs";
import {{ enclosing }} from "{os.path.abspath(WEB)}/number_text.js";
const pairs = JSON.parse(readFileSync("{self.path('pairs.json')}", "utf8"));
console.log(JSON.stringify(pairs.map(([value, radius]) =>
  enclosing(value, radius))));
""")
        done = subprocess.run(["node", self.path("text.mjs")], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        for (value, radius), text in zip(pairs, json.loads(done.stdout)):
            shown, _, around = text.partition(" ± ")  # an exact number stands alone
            self.encloses(shown, around or "0", value, radius)


if __name__ == "__main__":
    unittest.main()
