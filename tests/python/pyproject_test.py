# SPDX-License-Identifier: GPL-3.0-or-later
"""pyproject.toml says what CMake has: version, target, component, options. Building a wheel takes scikit-build-core."""
import re
import tomllib
import unittest

import radcert as rc

from module import SOURCE, ModuleTest


class PyProject(ModuleTest):
    def setUp(self):
        super().setUp()
        folder = SOURCE / "apps" / "python"
        self.project = tomllib.loads((folder / "pyproject.toml").read_text(encoding="utf-8"))
        self.cmake = (folder / "CMakeLists.txt").read_text(encoding="utf-8")
        self.build = self.project["tool"]["scikit-build"]

    def test_the_version_is_that_of_the_library(self):
        self.assertEqual(self.project["project"]["version"], rc.__version__)
        least = self.project["project"]["requires-python"].removeprefix(">=")
        self.assertIn(f"find_package(Python {least} ", self.cmake)

    def test_the_sources_are_those_of_the_checkout(self):
        self.assertTrue((SOURCE / "apps" / "python" / self.build["cmake"]["source-dir"] / "CMakeLists.txt").samefile(
            SOURCE / "CMakeLists.txt"))
        self.assertTrue((SOURCE / "apps" / "python" / self.project["project"]["readme"]).is_file())

    def test_targets_components_and_options_are_there(self):
        for target in self.build["build"]["targets"]:
            self.assertIn(f"Python_add_library({target} ", self.cmake)
        installed = re.findall(r"install\([^)]*COMPONENT (\w+)\)", self.cmake)
        self.assertEqual(set(self.build["install"]["components"]), set(installed))
        for option in self.build["cmake"]["define"]:
            self.assertIn(f"set({option} ", self.cmake)


if __name__ == "__main__":
    unittest.main()
