# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program as a user would, each test in a folder of its own."""
import copy
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import unittest

RADCERT = os.environ["RADCERT"]
EXAMPLES = os.environ["RADCERT_EXAMPLES"]
# What runs longer hangs, also under sanitizers on a busy machine.
MOST_SECONDS = 1400

SMALL = {
    "schema": "radcert/problem/1",
    "surface": {"name": "two_piece", "p": 2},
    "triangulation": {"levels": [0, 1]},
    "basis": {"family": "inset", "degree": 1, "alpha": "1/6"},
    "reflectivity": "1",
    "solution": "1/sqrt(x^2 + y^2 + (z-1/2)^2)",
}


def small(**changes):
    """The small problem with some keys changed; a key that is None is left out."""
    problem = copy.deepcopy(SMALL)
    problem.update(changes)
    return {key: value for key, value in problem.items() if value is not None}


class ProgramTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="radcert-test-")
        self.store = tempfile.mkdtemp(prefix="radcert-store-")
        self.addCleanup(shutil.rmtree, self.folder)
        self.addCleanup(shutil.rmtree, self.store)

    def environment(self, **changes):
        return {**os.environ, "RADCERT_STORE": self.store, **changes}

    def run_program(self, *words, cwd=None, **environment):
        return subprocess.run([RADCERT, *words], cwd=cwd or self.folder, env=self.environment(**environment),
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=MOST_SECONDS)

    def expect(self, code, *words, **options):
        """Runs the program, which must end with this code; gives stdout as text."""
        done = self.run_program(*words, **options)
        self.assertEqual(done.returncode, code, done.stderr.decode(errors="replace"))
        return done.stdout.decode()

    def interrupted_after(self, report, *words):
        """Stops the program as soon as it has reported this: exit code 130, and no result; gives what else it said."""
        with subprocess.Popen([RADCERT, *words], cwd=self.folder, env=self.environment(), stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as program:
            said = b""
            while report not in said:
                said = program.stderr.readline()
                self.assertTrue(said)
            program.send_signal(signal.SIGINT)
            output, said = program.communicate(timeout=MOST_SECONDS)
        self.assertEqual(program.returncode, 130, said)
        self.assertEqual(output, b"")
        return said

    def expect_commands_of(self, page, count):
        """Runs the commands of a page's README.md, so many, each of which must succeed."""
        with open(os.path.join(page, "README.md"), encoding="utf-8") as file:
            commands = re.findall(r"^    radcert (.*)$", file.read(), re.MULTILINE)
        self.assertEqual(len(commands), count)
        for command in commands:
            with self.subTest(command=command):
                self.expect(0, *command.split())

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        if isinstance(content, dict):
            content = json.dumps(content)
        if isinstance(content, str):
            content = content.encode()
        with open(self.path(name), "wb") as file:
            file.write(content)
        return name

    def entries(self):
        return sorted(os.path.relpath(os.path.join(at, name), self.folder)
                      for at, folders, files in os.walk(self.folder) for name in folders + files)
