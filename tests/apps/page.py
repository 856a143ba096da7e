# SPDX-License-Identifier: GPL-3.0-or-later
"""Follows a page as a reader would: its files are saved, its commands run, and what it shows of their output must be there."""
import os
import re
import shutil
import subprocess
import sys

from program import EXAMPLES, ProgramTest

ROOT = os.path.dirname(os.path.dirname(EXAMPLES))


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def commands(page):
    """The words of each command of radcert, with the indented lines of output that follow it."""
    found = []
    for match in re.finditer(r"^    (?:build/release/bin/)?radcert (.*)\n((?:\n?    (?!\S*radcert |cmake |ctest |Python ).*\n)*)",
                             page, re.MULTILINE):
        shown = [line[4:].rstrip() for line in match.group(2).splitlines() if line.strip()]
        found.append((match.group(1).split("  # ")[0].split(), shown))
    return found


def files(page):
    """The files that a page asks to be saved: a block after "save this as `NAME`:", and its name."""
    return re.findall(r"(?i:save this)[^`]*`([\w.]+)`:\n\n```\w+\n(.*?)^```", page, re.MULTILINE | re.DOTALL)


def python_lines(page):
    """The lines that a page gives for Python, by block."""
    blocks = re.findall(r"^    Python      (.*\n(?:                .*\n)*)", page, re.MULTILINE)
    return ["\n".join(line.strip() for line in block.splitlines()) for block in blocks]


class PageTest(ProgramTest):
    def setUp(self):
        super().setUp()
        shutil.copytree(EXAMPLES, self.path("apps/examples"))

    def follow(self, page):
        for words, shown in commands(page):
            file = None
            if ">" in words:
                words, file = words[:words.index(">")], words[-1]
            with self.subTest(" ".join(words)):
                text = self.expect(0, *words)
                if file:
                    self.write(file, text)
                lines = [line.rstrip() for line in text.splitlines()]
                for line in shown:
                    self.assertIn(line, lines)
        for block in python_lines(page):
            done = subprocess.run([sys.executable, "-c", block], cwd=self.folder, capture_output=True, text=True,
                                  check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""), block)
