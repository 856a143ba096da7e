# SPDX-License-Identifier: GPL-3.0-or-later
"""The types and the docstrings of the package are of what is there."""
import ast
import inspect
import pathlib
import unittest

import radcert
from radcert import _core

from module import ModuleTest


def public(names):
    return {name for name in names if not name.startswith("_")}


class Stubs(ModuleTest):
    def setUp(self):
        super().setUp()
        file = pathlib.Path(radcert.__file__).with_name("_core.pyi")
        self.tree = ast.parse(file.read_text(encoding="utf-8"))

    def test_the_compiled_part_has_what_its_stubs_say_and_nothing_else(self):
        stated = {node.name: node for node in self.tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        found = {name: value for name, value in vars(_core).items() if not name.startswith("_") and name != "version"}
        self.assertEqual(set(stated), set(found))
        for name, node in stated.items():
            if not isinstance(node, ast.ClassDef):
                self.assertFalse(inspect.isclass(found[name]), name)
            elif not issubclass(found[name], BaseException):
                members = public(member.name for member in node.body if isinstance(member, ast.FunctionDef))
                self.assertEqual(members, public(vars(found[name])), name)
            else:
                self.assertIn(ast.unparse(node.bases[0]), [base.__name__ for base in found[name].__mro__])

    def test_every_public_name_says_what_it_is(self):
        for name in public(vars(radcert)):
            value = getattr(radcert, name)
            if inspect.ismodule(value) or not callable(value):
                continue
            self.assertTrue(inspect.getdoc(value), name)
            if inspect.isclass(value) and value.__module__.startswith("radcert.") and not issubclass(value, Exception):
                for member, function in vars(value).items():
                    if inspect.isfunction(function) and not member.startswith("_"):
                        self.assertTrue(inspect.getdoc(function), f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
