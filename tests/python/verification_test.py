# SPDX-License-Identifier: GPL-3.0-or-later
"""Claims from Python, as somebody's own tests would hold them."""
import shutil
import unittest

import radcert as rc

from module import EXAMPLES, ModuleTest, without


class Verification(ModuleTest):
    def setUp(self):
        super().setUp()
        self.claims = self.folder / "claims"
        shutil.copytree(EXAMPLES / "05_own_claim", self.claims)

    def test_claims_of_ones_own_are_as_recorded(self):
        report = rc.verify(self.claims)
        report.assert_as_recorded()
        self.assertTrue(report.as_recorded)
        self.assertGreater(len(report.statements), 2)
        theirs = self.program("verify", self.claims)
        ours = report.to_json()
        self.assertEqual(without(ours, "command", "timing"), without(theirs, "command", "timing"))

    def test_all_claims_of_the_papers_are_listed(self):
        listed = rc.claims()
        self.assertEqual([claim["name"] for claim in listed],
                         [entry["name"] for entry in self.program("list", "claims")["entries"]])
        table = next(claim for claim in listed if claim["name"] == "ac98/table_1")
        self.assertIn("ac98/table_1.alpha_1_6.n4.discretisation_error", table["cells"])
        self.assertEqual([len(rc.verify(name).statements) for name in (table["cells"][0], listed[0]["name"])], [1, 1])

    def test_another_verdict_fails_a_test(self):
        file = self.claims / "claims.toml"
        text = file.read_text(encoding="utf-8")
        self.assertIn('verdict = "supported"', text)
        file.write_text(text.replace('verdict = "supported"', 'verdict = "undecided"', 1), encoding="utf-8")
        report = rc.verify(self.claims)
        self.assertFalse(report.as_recorded)
        (statement,) = report.differing
        self.assertEqual((statement.verdict, statement.recorded), ("supported", "undecided"))
        with self.assertRaises(AssertionError) as caught:
            report.assert_as_recorded()
        self.assertIn(statement.name.split("/")[1], str(caught.exception))

    def test_a_statement_of_a_paper(self):
        heard = []
        report = rc.verify("ac98/table_1.alpha_1_6.n4", progress=lambda fraction, words: heard.append(words))
        (statement,) = report.statements
        self.assertEqual(statement.name, "ac98/table_1.alpha_1_6.n4.discretisation_error")
        self.assertEqual(statement.verdict, "certified")
        value, radius, guaranteed = statement.value
        self.assertTrue(guaranteed)
        self.assertLessEqual(abs(value - float(statement.printed)), 0.5e-5 + radius)
        self.assertTrue(heard)

    def test_wrong_input_is_named(self):
        self.refused(lambda: rc.verify("ac99"), "ac99")
        self.refused(lambda: rc.verify("ac98/no_such"), "no_such")
        self.refused(lambda: rc.verify(self.claims, budget="much"), "quick, standard, full")
        (self.claims / "claims.toml").write_text("[claim", encoding="utf-8")
        self.refused(lambda: rc.verify(self.claims), "claims.toml")


if __name__ == "__main__":
    unittest.main()
