# SPDX-License-Identifier: GPL-3.0-or-later
"""What verify says and writes; whether a verdict is right is the verification's own business."""
import json
import os
import unittest
import xml.etree.ElementTree

import jsonschema

from program import ProgramTest

CLAIM = "ac98/equation_37"


def order_claim(label, order):
    """A claim on two_piece.json, which is its own control."""
    return f"""
[{label}]
covers  = []
says    = "the error at the nodes has the order {order}"
needs   = []
check   = "order"
verdict = "supported"
problem = "two_piece.json"
control = "two_piece.json"
quantity = "node_error"
order   = {order}.0
"""


class Verify(ProgramTest):
    def test_the_report_is_valid_and_the_exit_code_says_whether_all_is_as_recorded(self):
        schema = json.loads(self.expect(0, "schema", "verification"))
        done = self.run_program("verify", CLAIM, "--json", "-", "--out", "report")
        report = json.loads(done.stdout)
        jsonschema.validate(report, schema)
        self.assertEqual(done.returncode, 0 if report["as_recorded"] else 1)
        self.assertEqual([claim["label"] for claim in report["claims"]], ["equation_37"])
        with open(self.path("report/report.json"), encoding="utf-8") as file:
            jsonschema.validate(json.load(file), schema)

    def test_a_folder_of_ones_own_that_differs_from_its_record_ends_with_1(self):
        os.mkdir(self.path("own"))
        self.write("own/two_piece.json", self.expect(0, "example", "two_piece"))
        # Far more than the method can give, recorded as supported.
        self.write("own/claims.toml", order_claim("order_of_the_node_error", 9))
        done = self.run_program("verify", "./own")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(b"order_of_the_node_error", done.stdout)

    def junit(self, code, *words):
        """The cases of JUnit's file by name, after its counts were held against them."""
        self.expect(code, "verify", *words, "--junit", "claims.xml", "--json", "report.json")
        root = xml.etree.ElementTree.parse(self.path("claims.xml")).getroot()
        self.assertEqual(root.tag, "testsuites")
        cases = {}
        for suite in root:
            found = suite.findall("testcase")
            self.assertEqual(len(found), len(suite), "a suite has cases alone")
            self.assertEqual(int(suite.get("tests")), len(found))
            for kind in ("failure", "error"):
                self.assertEqual(int(suite.get(kind + "s")), sum(case.find(kind) is not None for case in found))
            self.assertAlmostEqual(float(suite.get("time")), sum(float(case.get("time")) for case in found), places=1)
            for case in found:
                self.assertEqual(case.get("classname"), suite.get("name"))
                cases[suite.get("name") + "/" + case.get("name")] = case
        for name in ("tests", "failures", "errors"):
            self.assertEqual(int(root.get(name)), sum(int(suite.get(name)) for suite in root))
        with open(self.path("report.json"), encoding="utf-8") as file:
            report = json.load(file)
        self.assertEqual(set(cases), {claim["paper"] + "/" + claim["label"] for claim in report["claims"]})
        for claim in report["claims"]:
            case = cases[claim["paper"] + "/" + claim["label"]]
            bad = case.find("failure") is not None or case.find("error") is not None
            self.assertEqual(bad, not claim["as_recorded"], claim["label"])
            self.assertIn("verdict: " + claim["verdict"], case.find("system-out").text)
        return cases

    def test_verdicts_as_test_results(self):
        cases = self.junit(0, CLAIM, "m06/lemma_1_d")
        self.assertEqual({case.split("/")[0] for case in cases}, {"ac98", "m06"})
        os.mkdir(self.path("own"))
        self.write("own/two_piece.json", self.expect(0, "example", "two_piece"))
        # One holds what the method gives and is its own control: failed. One is recorded as what it is not.
        self.write("own/claims.toml", order_claim("its_own_control", 1)
                   + order_claim("far_too_much", 9).replace("says    = \"", "says    = \"<&> \u00e4, "))
        cases = self.junit(1, "./own")
        by_label = {name.rsplit("/", 1)[1]: case for name, case in cases.items()}
        self.assertIsNotNone(by_label["its_own_control"].find("error"))
        self.assertIn("recorded is supported", by_label["its_own_control"].find("error").get("message"))
        self.assertIn("<&> \u00e4, the error", by_label["far_too_much"].find("system-out").text)
        # Refused before any work: a folder that is not there, and two outputs into one file.
        for words in (["--junit", "no/such/folder/claims.xml"], ["--junit", "both", "--json", "both"]):
            done = self.run_program("verify", "./own", *words)
            self.assertEqual(done.returncode, 2)
            self.assertIn(b"--junit", done.stderr)

    def test_a_statement_of_a_folder_of_ones_own_is_verified_alone(self):
        os.mkdir(self.path("own"))
        self.write("own/two_piece.json", self.expect(0, "example", "two_piece"))
        self.write("own/claims.toml", order_claim("first", 1) + order_claim("second", 1))
        for word in ["./own/second", "own/second", self.path("own/second")]:
            done = self.run_program("verify", word, "--json", "-", "--out", "report")
            self.assertIn(done.returncode, (0, 1), done.stderr)
            self.assertEqual([each["label"] for each in json.loads(done.stdout)["claims"]], ["second"])
            self.assertNotIn(b" left", done.stderr, "how long statements take differs too much to foresee it")
            with open(self.path("report/provenance.json"), encoding="utf-8") as file:
                self.assertEqual([os.path.basename(each["name"]) for each in json.load(file)["inputs"]], ["claims.toml"])
        for word in ["./own/third", "./own/first/more"]:
            done = self.run_program("verify", word)
            self.assertEqual(done.returncode, 2, word)

    def test_what_a_run_has_found_is_kept_for_the_next_one(self):
        # A finding that is kept brings along how long it took when it was computed.
        runs = [json.loads(self.run_program("verify", CLAIM, *words, "--json", "-").stdout)
                for words in ([], [], ["--fresh"])]
        first, second, fresh = [run["timing"]["claims"] for run in runs]
        self.assertEqual(first, second)
        self.assertNotEqual(first, fresh)
        self.assertEqual(runs[0]["claims"], runs[2]["claims"])

    def test_what_is_not_there_is_refused(self):
        for word in ["no_such_paper", "ac98/no_such_claim", "./no_such_folder"]:
            done = self.run_program("verify", word, "--out", "report")
            self.assertEqual(done.returncode, 2, word)
            self.assertIn(word.split("/")[-1].encode(), done.stderr)
        self.assertEqual(self.entries(), [])


if __name__ == "__main__":
    unittest.main()
