# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of apps/examples, followed as they are written, and what they say of claims of one's own."""
import csv
import json
import os
import re
import shutil
import unittest

from page import ROOT, PageTest, commands, read
from program import EXAMPLES

# 02, 04, 06 and 15 have tests of their own.
EXAMPLE_PAGES = ["01_solve", "03_own_surface", "05_own_claim", "07_occluded_room", "08_factors_of_an_stl",
                 "09_other_languages", "10_edges", "11_anywhere", "12_events", "13_galerkin", "14_new_nodes"]


class Examples(PageTest):
    def test_every_command_of_every_page_works_and_shows_what_is_printed(self):
        for name in EXAMPLE_PAGES:
            with self.subTest(name):
                page = read(os.path.join(EXAMPLES, name, "README.md"))
                self.assertTrue(commands(page))
                for file in os.listdir(os.path.join(EXAMPLES, name)):  # of pages for a copy of their folder
                    if file.endswith(".json"):
                        shutil.copy(os.path.join(EXAMPLES, name, file), self.path(file))
                self.follow(page)

    def test_the_first_page_solves_every_problem_of_its_folder(self):
        folder = os.path.join(EXAMPLES, "01_solve")
        solved = [words[1] for words, _ in commands(read(os.path.join(folder, "README.md"))) if words[0] == "solve"]
        self.assertEqual(sorted(map(os.path.basename, solved)),
                         sorted(name for name in os.listdir(folder) if name.endswith(".json")))

    def test_the_list_of_examples_and_the_readme_name_them_all_in_order(self):
        numbered = sorted(name for name in os.listdir(EXAMPLES) if re.match("[0-9]{2}_", name))
        self.assertEqual([name[:2] for name in numbered], [f"{i:02}" for i in range(1, len(numbered) + 1)])
        self.assertEqual(re.findall(r"\]\(([0-9]{2}_\w+)/README\.md\)", read(os.path.join(EXAMPLES, "README.md"))),
                         numbered)
        self.assertEqual(re.findall(r"^[0-9]+\. \[.*?\]\(apps/examples/([0-9]{2}_\w+)/README\.md\)",
                                    read(os.path.join(ROOT, "README.md")), re.MULTILINE), numbered)

    def own_claim(self):
        shutil.copytree(os.path.join(EXAMPLES, "05_own_claim"), self.path("own"))

    def edit(self, name, old, new):
        text = read(self.path(name))
        self.assertIn(old, text)
        self.write(name, text.replace(old, new, 1))

    def verdicts(self, code=0):
        report = json.loads(self.expect(code, "verify", "./own", "--json", "-"))
        return {claim["label"]: claim["verdict"] for claim in report["claims"]}

    def test_a_proved_number_is_certified_contradicted_or_undecided(self):
        self.own_claim()
        self.assertEqual(self.verdicts()["error_of_48_elements"], "certified")
        self.assertEqual(self.verdicts()["light_on_the_long_wall"], "certified")
        # 0.20352467630385183314673... is known to 160 digits: the edge of the interval settles it, and 0.0022666405... has a radius.
        self.edit("own/claims.toml", '"0.20345", "0.20355"', '"0.2035", "0.20352467630385183"')
        self.edit("own/claims.toml", '"2.265e-3", "2.275e-3"', '"2.26664059429637e-3", "1"')
        found = self.verdicts(1)
        self.assertEqual(found["light_on_the_long_wall"], "contradicted")
        self.assertEqual(found["error_of_48_elements"], "failed")  # the control lies inside as well
        self.edit("own/claims.toml", '"2.26664059429637e-3", "1"', '"2.26664059429637e-3", "2.275e-3"')
        self.assertEqual(self.verdicts(1)["error_of_48_elements"], "undecided")

    def test_a_value_of_u_n_can_be_proved(self):
        # Constant functions in the control: their least value at a node is another one.
        self.own_claim()
        with open(self.path("own/claims.toml"), encoding="utf-8") as file:
            claims = file.read()
        values = {}
        for name in ["room_proved", "room_constant_proved"]:
            self.expect(0, "solve", f"own/{name}.json", "--nodes", "nodes.csv")
            with open(self.path("nodes.csv"), newline="", encoding="utf-8") as file:
                values[name] = min(float(row["u_n"]) for row in csv.DictReader(file) if row["level"] == "1")
        own, other = values["room_proved"], values["room_constant_proved"]
        width = abs(own - other) / 2
        for middle, verdict in [(own, "certified"), (own + 4 * width, "contradicted")]:
            self.write("own/claims.toml", claims.replace(
                'quantity = "node_error"\ninterval = ["2.265e-3", "2.275e-3"]',
                f'quantity = "least_u_n"\ninterval = ["{middle - width / 2!r}", "{middle + width / 2!r}"]'))
            self.assertEqual(self.verdicts(0 if verdict == "certified" else 1)["error_of_48_elements"], verdict)

    def refused(self, *said):
        done = self.run_program("verify", "./own")
        self.assertEqual(done.returncode, 2, done.stderr)
        for words in said:
            self.assertIn(words, done.stderr.decode())

    def test_what_does_not_fit_an_enclosure_is_refused_with_its_place(self):
        for old, new, said in [
                ('interval = ["0.20345", "0.20355"]', 'interval = ["1", "0"]', "/light_on_the_long_wall/interval"),
                ('interval = ["0.20345", "0.20355"]', "interval = [0.2, 1]", "/light_on_the_long_wall/interval/0"),
                ("edge = 4,", "edges = 4,", "/light_on_the_long_wall/values"),
                ("edge = 4,", "edge = -4,", "/light_on_the_long_wall/values/edge"),
                ('reference = "perp', 'reference = "perpen', "/light_on_the_long_wall/reference"),
                ('verdict = "certified"', 'verdict = "supported"', "/light_on_the_long_wall/verdict"),
                ('"room_proved.json"', '"room.json"', "/solver/name"),
                ('"room_proved.json"', '"nothing.json"', "nothing.json")]:
            with self.subTest(new):
                shutil.rmtree(self.path("own"), ignore_errors=True)
                self.own_claim()
                self.edit("own/claims.toml", old, new)
                self.refused(said)

    def test_an_erratum_that_is_not_there_is_refused_with_its_place(self):
        self.own_claim()
        self.expect(0, "verify", "./own", "--out", "out")
        self.assertIn("two digits are exchanged; the printed ratio", read(self.path("out/report.html")))
        self.edit("own/claims.toml", 'erratum = "n = 192, error"', 'erratum = "n = 193, error"')
        self.refused("claims.toml, line", "/table/erratum", "n = 193, error", "is in no row of")
        os.remove(self.path("own/errata.md"))
        self.refused("claims.toml, line", "/table/erratum", "errata.md, which is not there")


if __name__ == "__main__":
    unittest.main()
