# SPDX-License-Identifier: GPL-3.0-or-later
"""A run that is stopped keeps what it finished."""
import os
import unittest

from program import ProgramTest, small


class Interruption(ProgramTest):
    def test_finished_levels_are_kept_and_no_file_is_written(self):
        # Level 4 of degree 2 has 6144 unknowns: the signal, sent when level 0 is reported, comes long before its end.
        self.write("problem.json", small(triangulation={"levels": [0, 4]},
                                         basis={"family": "inset", "degree": 2, "alpha": "0.1"}))
        said = self.interrupted_after(b"level 0: ", "solve", "problem.json", "--out", "out", "--json", "result.json")
        self.assertIn(b"interrupted; 1 of 2 levels are finished and kept", said)
        self.assertEqual(self.entries(), ["problem.json"])
        self.assertEqual(len(os.listdir(self.store)), 1)

        self.write("problem.json", small(triangulation={"levels": [0]},
                                         basis={"family": "inset", "degree": 2, "alpha": "0.1"}))
        done = self.run_program("solve", "problem.json")
        self.assertIn(b"level 0: 4 elements, 24 unknowns, found in the store", done.stderr)


if __name__ == "__main__":
    unittest.main()
