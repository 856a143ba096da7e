# SPDX-License-Identifier: GPL-3.0-or-later
"""What solve, experiment and verify write for a paper."""
import csv
import hashlib
import json
import os
import re
import shutil
import subprocess
import unittest
import xml.etree.ElementTree as xml
from fractions import Fraction

import jsonschema

from program import SMALL, ProgramTest, small

DOCUMENT = r"""\documentclass{article}
\usepackage{array,booktabs,siunitx,longtable,pgfplots}
\pgfplotsset{compat=1.18}
\begin{document}
Some words before. \input{out/table} %s

Some words after.
%s
\nocite{*}
\bibliographystyle{plain}
\bibliography{out/cite}
\end{document}
"""

TRIAL = {"schema": "radcert/experiment/1", "name": "two_bases",
         "base": {key: value for key, value in SMALL.items() if key not in ("schema", "basis")},
         "vary": {"basis": [{"family": "inset", "degree": 0}, {"family": "inset", "degree": 1, "alpha": "1/6"}],
                  "quadrature": [{"tolerance": "1e-10"}, {"tolerance": "1e-12"}]},
         "labels": {"basis": ["P0", "P1"]}, "fit_from": 0}

CLAIMS = """
[order_of_the_node_error]
covers  = []
says    = "the error at the nodes falls faster than h^3"
needs   = []
check   = "order"
verdict = "supported"
problem = "two_piece.json"
control = "constant.json"
quantity = "node_error"
order   = 4.0
logarithm = true
"""


def digest(content):
    return "sha256-" + hashlib.sha256(content).hexdigest()


def parenthesised(cell):
    """1.484(21)e-3 is 1.484e-3 +- 0.021e-3."""
    digits, decimals, units, power = re.fullmatch(r"([0-9])(\.[0-9]*)?\(([0-9]+)\)(e-?[0-9]+)?", cell).groups("")
    scale = Fraction("1" + power)
    return Fraction(digits + decimals) * scale, Fraction(int(units), 10**max(0, len(decimals) - 1)) * scale


def has_latex():
    return shutil.which("pdflatex") and all(
        subprocess.run(["kpsewhich", name + ".sty"], capture_output=True, check=False).returncode == 0
        for name in ["booktabs", "siunitx", "longtable", "pgfplots"])


class Paper(ProgramTest):
    def solve(self, *words, **changes):
        self.write("problem.json", small(**changes))
        self.expect(0, "solve", "problem.json", "--out", "out", *words)

    def experiment(self):
        self.write("trial.json", TRIAL)
        self.expect(0, "experiment", "trial.json", "--out", "out")

    def verify(self):
        os.makedirs(self.path("own"))
        levels = {"levels": [1, 2, 3]}
        self.write("own/two_piece.json", small(triangulation=levels))
        self.write("own/constant.json", small(triangulation=levels, basis={"family": "inset", "degree": 0}))
        self.write("own/claims.toml", CLAIMS)
        self.expect(0, "verify", "./own", "--out", "out")

    def content(self, name):
        with open(self.path("out/" + name), "rb") as file:
            return file.read()

    def text(self, name):
        return self.content(name).decode()

    def test_provenance_is_valid_and_names_what_was_read(self):
        schema = json.loads(self.expect(0, "schema", "provenance"))
        for make, name in [(self.solve, "problem.json"), (self.experiment, "trial.json"),
                           (self.verify, "./own/claims.toml")]:
            make()
            provenance = json.loads(self.content("provenance.json"))
            jsonschema.validate(provenance, schema)
            with open(self.path(name), "rb") as file:
                self.assertEqual(provenance["inputs"], [{"name": name, "digest": digest(file.read())}])
            self.assertIn("--out out", provenance["command"])
            self.assertIn("mpfr", [library["name"] for library in provenance["libraries"]])

    def test_the_bibliography_has_the_method_and_radcert(self):
        keys = lambda: re.findall(r"^@[a-z]+\{([a-z0-9]+),", self.text("cite.bib"), re.MULTILINE)
        self.solve()
        self.assertEqual(keys(), ["ac98", "m06", "radcert"])
        version = self.expect(0, "--version").split()[1]
        self.assertIn("version " + version + "}", self.text("cite.bib"))
        self.solve(basis={"family": "symmetric", "degree": 1})
        self.assertEqual(keys(), ["ac98", "radcert"])
        self.verify()
        self.assertEqual(keys(), ["radcert"])

    def test_without_errors_there_is_a_table_and_nothing_to_plot(self):
        self.solve(solution=None, emission="1")
        self.assertIn("Means of", self.text("table.tex"))
        self.assertFalse({"plot.tex", "errors_against_h.svg"} & set(os.listdir(self.path("out"))))

    def test_the_table_of_solve_rounds_what_the_csv_says(self):
        self.solve()
        with open(self.path("out/errors.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file, strict=True))
        lines = [line.strip(" \\").split(" & ") for line in self.text("table.tex").splitlines()
                 if re.match(r" *[0-9]+ &", line)]
        self.assertEqual(len(lines), len(rows))
        for line, row in zip(lines, rows):
            for place, key in [(3, "discretisation_error"), (5, "node_error")]:
                if row[key[:-5] + "order"]:
                    self.assertAlmostEqual(float(line[place + 1].strip("$")), float(row[key[:-5] + "order"]), delta=0.006)
                midpoint, radius = parenthesised(line[place])
                self.assertLess(abs(Fraction(float(row[key])) - midpoint) + Fraction(float(row[key + "_radius"])),
                                radius)
                self.assertLess(radius, midpoint / 400)
        xml.fromstring(self.content("errors_against_h.svg"))

    def test_names_in_tables_have_no_commas(self):
        for make in (self.experiment, self.verify):
            shutil.rmtree(self.path("out"), ignore_errors=True)
            make()
            with open(self.path("out/errors.csv"), newline="", encoding="utf-8") as file:
                names = {row["name"] for row in csv.DictReader(file, strict=True)}
            self.assertTrue(names)
            for name in names:
                self.assertNotIn(",", name)

    def test_verify_writes_the_levels_that_its_checks_solved(self):
        self.verify()
        with open(self.path("out/errors.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file, strict=True))
        problems = json.loads(self.content("report.json"))["problems"]
        self.assertEqual([(int(row["problem"]), int(row["level"]), float(row["node_error"])) for row in rows],
                         [(i, level["level"], level["node_error"]["value"])
                          for i, problem in enumerate(problems) for level in problem["levels"]])
        for i in range(len(problems)):
            xml.fromstring(self.content(f"errors_of_problem_{i}.svg"))

    def test_the_vertices_of_the_ply_have_the_radiosity_and_the_error(self):
        self.solve("--ply", "u.ply", solution="x + 2*y + 1", reflectivity="1/2")
        with open(self.path("u.ply"), "rb") as file:
            self.assertEqual(self.content("solution.ply"), file.read())
        head, body = self.text("solution.ply").split("end_header\n")
        names = re.findall(r"property double (\w+)", head)
        self.assertEqual(names, ["x", "y", "z", "radiosity", "error"])
        count = int(re.search(r"element vertex (\d+)", head).group(1))
        for line in body.splitlines()[:count]:
            x, y, z, radiosity, error = map(float, line.split())
            self.assertAlmostEqual(abs(x + 2 * y + 1 - radiosity), error, delta=1e-12)

    @unittest.skipUnless(has_latex(), "pdflatex with booktabs, siunitx, longtable and pgfplots is not there")
    def test_latex_compiles_tables_plots_and_bibliography(self):
        pictures = os.environ.get("RADCERT_PICTURES")
        for name, make in [("solve", self.solve), ("experiment", self.experiment), ("verify", self.verify),
                           ("emission", lambda: self.solve(solution=None, emission="1"))]:
            with self.subTest(name):
                shutil.rmtree(self.path("out"), ignore_errors=True)
                make()
                plots = os.path.exists(self.path("out/plot.tex"))
                self.assertEqual(plots, name != "emission")
                each = sorted(entry[:-4] for entry in os.listdir(self.path("out"))
                              if entry.endswith(".tex") and entry not in ("plot.tex", "table.tex"))
                self.assertEqual(bool(each), plots)
                for alone in each:
                    self.assertIn(alone + ".svg", os.listdir(self.path("out")))
                figures = "\n".join(r"\begin{figure}\input{out/%s}\end{figure}" % alone for alone in each[:6])
                self.write("paper.tex", DOCUMENT % (r"\input{out/plot}" if plots else "", figures))
                for command in [["pdflatex"], ["bibtex"], ["pdflatex"]]:
                    options = ["-interaction=nonstopmode", "-halt-on-error"] if command == ["pdflatex"] else []
                    done = subprocess.run([*command, *options, "paper"], cwd=self.folder, timeout=300,
                                          stdin=subprocess.DEVNULL, capture_output=True, check=False)
                    self.assertEqual(done.returncode, 0, done.stdout.decode(errors="replace")[-3000:])
                with open(self.path("paper.log"), encoding="utf-8", errors="replace") as file:
                    log = file.read()
                # Nothing reaches over the right edge of the text, nor over the lower one.
                self.assertEqual(re.findall(r"Overfull.*", log), [])
                self.assertEqual(re.findall(r".*undefined.*|.*has no coordinates.*", log), [])
                with open(self.path("paper.pdf"), "rb") as file:
                    self.assertTrue(file.read().startswith(b"%PDF"))
                if pictures:
                    os.makedirs(pictures, exist_ok=True)
                    shutil.copy(self.path("paper.pdf"), os.path.join(pictures, f"paper_of_{name}.pdf"))


if __name__ == "__main__":
    unittest.main()
