# SPDX-License-Identifier: GPL-3.0-or-later
"""The README and the pages on commands, files and verdicts, followed as they are written."""
import glob
import json
import os
import re
import unittest

from page import ROOT, PageTest, commands, files, read

PAGES = ["README.md", "apps/radcert/README.md", "lib/radcert/formats/README.md", "verification/README.md",
         "apps/examples/pictures/README.md"]


class Pages(PageTest):
    def test_the_readme_and_the_pages_beside_the_code_are_true(self):
        for name in PAGES:
            with self.subTest(name):
                page = read(os.path.join(ROOT, name))
                self.assertTrue(commands(page))
                self.assertEqual(len(files(page)), page.count("```json") + page.count("```text"))
                for file, text in files(page):
                    self.write(file, text)
                self.follow(page)

    def test_the_start_pages_and_the_theory_of_the_site_are_true(self):
        pages = glob.glob(os.path.join(ROOT, "apps/site/pages/**/*.md"), recursive=True)
        self.assertGreater(len(pages), 8)
        for name in pages:
            with self.subTest(name):
                page = read(name)
                self.assertTrue(commands(page))
                for file, text in files(page):
                    self.write(file, text)
                self.follow(page)

    def test_the_page_on_commands_names_every_command_and_option(self):
        page = read(os.path.join(ROOT, "apps/radcert/README.md"))
        names = re.findall(r"^  (\w+)  ", self.expect(0, "--help").split("Subcommands:")[1], re.MULTILINE)
        self.assertIn("solve", names)
        for name in names:
            self.assertRegex(page, rf"`{name}\b")
            for option in re.findall(r"^  (--[\w-]+)", self.expect(0, name, "--help"), re.MULTILINE):
                with self.subTest(name + " " + option):
                    self.assertIn("`" + option, page)

    def test_the_page_on_files_names_every_file_type_and_every_key_of_a_problem(self):
        page = read(os.path.join(ROOT, "lib/radcert/formats/README.md"))
        refusal = self.run_program("schema", "nothing").stderr.decode()
        names = refusal.split("allowed: ")[1].strip().split(", ")
        self.assertIn("problem", names)
        for name in names:
            self.assertRegex(page, rf"`{name}`|^\| {name}\b", name)
        problem = json.loads(self.expect(0, "schema", "problem"))
        for key in problem["properties"]:
            self.assertRegex(page, rf"[`\"]{key}\b", key)


if __name__ == "__main__":
    unittest.main()
