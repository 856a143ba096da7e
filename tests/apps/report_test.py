# SPDX-License-Identifier: GPL-3.0-or-later
"""The page that verify writes, opened from disk in a browser."""
import os
import shutil
import subprocess
import unittest

from program import ProgramTest

STATEMENTS = ["ac98/table_4.n12", "ac98/table_4.n48", "ac98/section_4_not_compact", "ac98/equation_37", "ac98/equation_80_table_4",
              "m06/equation_13"]


def chromium():
    return shutil.which("chromium") or shutil.which("chromium-browser")


class Report(ProgramTest):
    def write_report(self):
        done = self.run_program("verify", *STATEMENTS, "--out", "report")
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return self.path("report/report.html")

    def test_the_page_is_one_small_file(self):
        page = self.write_report()
        self.assertLess(os.path.getsize(page), 8 << 20)
        with open(page, encoding="utf-8") as file:
            self.assertIn("section_4_not_compact", file.read())

    @unittest.skipUnless(os.environ.get("RADCERT_PAGE_TOOLS"), "built without Node: the page is plain")
    @unittest.skipUnless(chromium(), "no chromium here")
    def test_a_browser_shows_every_statement_and_asks_for_nothing(self):
        page = self.write_report()
        node = [shutil.which("node"), os.path.join(os.path.dirname(__file__), "browser", "report_browser.mjs")]
        pictures = os.environ.get("RADCERT_PICTURES", self.folder)
        os.makedirs(pictures, exist_ok=True)
        done = subprocess.run([*node, page, pictures, os.environ["RADCERT_PAGE_TOOLS"], chromium()],
                              capture_output=True, timeout=300, check=False)
        self.assertEqual(done.returncode, 0, (done.stdout + done.stderr).decode(errors="replace"))


if __name__ == "__main__":
    unittest.main()
