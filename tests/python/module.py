# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the module share: a folder of their own, and errors with their parts."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import radcert as rc

# What runs longer hangs, also under sanitizers on a busy machine.
MOST_SECONDS = 1400

SOURCE = pathlib.Path(os.environ["RADCERT_SOURCE"])
EXAMPLES = SOURCE / "apps" / "examples"


def unit_cube():
    """The six faces of [0,1]^3 as twelve triangles whose corners run counterclockwise as seen from inside, by name."""
    points = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    faces = {"west": (0, 2, 3, 1), "east": (4, 5, 7, 6), "south": (0, 1, 5, 4), "north": (2, 6, 7, 3),
             "floor": (0, 4, 6, 2), "ceiling": (1, 3, 7, 5)}
    triangles, groups = [], []
    for name, (a, b, c, d) in faces.items():
        triangles += [(a, b, c), (a, c, d)]
        groups += [name, name]
    return points, triangles, groups


class ModuleTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="radcert-python-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def refused(self, action, *parts, error=rc.InputError):
        """The action raises this error, whose words have these parts; gives the error."""
        with self.assertRaises(error) as caught:
            action()
        for part in parts:
            self.assertIn(part, str(caught.exception))
        return caught.exception

    def program(self, *words):
        """What the program writes as JSON."""
        done = subprocess.run([os.environ["RADCERT"], *map(str, words), "--json", "-", "--quiet"], cwd=self.folder,
                              env={**os.environ, "RADCERT_STORE": str(self.folder / "store")}, capture_output=True,
                              timeout=MOST_SECONDS, check=True)
        return json.loads(done.stdout)


def without(document, *keys):
    """A document without what differs from run to run."""
    return {key: value for key, value in document.items() if key not in keys}
