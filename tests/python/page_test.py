# SPDX-License-Identifier: GPL-3.0-or-later
"""Every block of the page runs, in its order, and prints what the page says."""
import contextlib
import io
import os
import re
import unittest

from module import EXAMPLES, SOURCE, ModuleTest

BLOCK = re.compile(r"^```python\n(.*?)^```\n(?:\n^```\n(.*?)^```\n)?", re.MULTILINE | re.DOTALL)


class Page(ModuleTest):
    def test_every_block_prints_what_the_page_says(self):
        text = (SOURCE / "apps" / "python" / "README.md").read_text(encoding="utf-8")
        blocks = BLOCK.findall(text)
        self.assertEqual(len(blocks), text.count("```python"))
        self.assertGreater(len(blocks), 8)
        names = {"__name__": "page"}
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        for code, expected in blocks:
            printed = io.StringIO()
            with self.subTest(code=code), contextlib.redirect_stdout(printed):
                exec(compile(code, "README.md", "exec"), names)  # noqa: S102
            self.assertEqual(printed.getvalue(), expected, code)

    def test_every_block_of_the_start_pages_runs(self):
        pages = sorted((SOURCE / "apps" / "site" / "pages").glob("*.md"))
        blocks = [code for page in pages for code, _ in BLOCK.findall(page.read_text(encoding="utf-8"))]
        self.assertGreater(len(blocks), 5)
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        (self.folder / "apps").mkdir()
        (self.folder / "apps" / "examples").symlink_to(EXAMPLES)
        for code in blocks:
            with self.subTest(code=code), contextlib.redirect_stdout(io.StringIO()), \
                    contextlib.redirect_stderr(io.StringIO()):
                exec(compile(code, "start page", "exec"), {"__name__": "page"})  # noqa: S102


if __name__ == "__main__":
    unittest.main()
