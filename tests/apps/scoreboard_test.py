# SPDX-License-Identifier: GPL-3.0-or-later
"""radcert experiment scoreboard, run once to its first level: every cell, the frontiers anew, and what stands where."""
import csv
import io
import json
import os
import re
import unittest
from html.parser import HTMLParser

import jsonschema

from page import PageTest, read
from program import EXAMPLES

ERRORS = ["max_error", "l2_error", "mean_error"]


class Scoreboard(PageTest):
    def content(self, name):
        with open(self.path(name), newline="", encoding="utf-8") as file:
            return file.read()

    def test_it_is_whole_and_marks_what_nothing_beats(self):
        self.follow(read(os.path.join(EXAMPLES, "15_scoreboard", "README.md")))
        # From what the page's run has kept.
        table = self.expect(0, "experiment", "scoreboard", "--finest", "1", "--out", "board")
        board = json.loads(self.content("board/scoreboard.json"))
        jsonschema.validate(board, json.loads(self.expect(0, "schema", "scoreboard")))
        problems = [problem["name"] for problem in board["problems"]]
        self.assertEqual(problems, ["sphere", "ellipsoid", "cube", "l_room", "sphere_over_disk"])
        methods = {problem: [cell["method"] for cell in board["cells"] if cell["problem"] == problem] for problem in problems}
        for problem in problems:
            self.assertEqual(methods[problem], methods["sphere"], "no cell is missing")
        self.assertGreaterEqual(len(methods["sphere"]), 11)
        for cell in board["cells"]:
            # Either levels, or a reason.
            self.assertEqual(cell["refused"] is None, bool(cell["levels"]), cell)
        served = [cell for cell in board["cells"] if cell["levels"]]
        self.assertGreaterEqual(len(served), 5 * (len(methods["sphere"]) - 2))

        timing = {(cell["problem"], cell["method"]): cell["levels"] for cell in board["timing"]["cells"]}
        for problem in problems:
            points = []
            for cell in (cell for cell in board["cells"] if cell["problem"] == problem):
                for level, timed in zip(cell["levels"], timing[problem, cell["method"]]):
                    points.append({**level, "seconds": timed["seconds"],
                                   "frontier": {e: {**level["frontier"][e], **timed["frontier"][e]} for e in ERRORS}})
            for error in ERRORS:
                for cost in ["unknowns", "bytes", "seconds"]:
                    known = [p for p in points if p[error] is not None]
                    for p in points:
                        beaten = p[error] is None or any(
                            q[cost] <= p[cost] and q[error] <= p[error] and (q[cost], q[error]) != (p[cost], p[error])
                            for q in known)
                        self.assertEqual(p["frontier"][error][cost], not beaten, (problem, error, cost, p))
                    # Of the cube the means alone are known.
                    self.assertEqual(bool(known), problem != "cube" or error == "mean_error")
        radius = {problem["name"]: problem["truth_radius"] for problem in board["problems"]}
        self.assertLess(radius["cube"], 1e-5)
        self.assertIsNone(radius["sphere"])

        # Iterated solutions are nearer than what they are made of, where the solution is smooth.
        for problem in ("sphere", "ellipsoid"):
            own, iterated = ([cell["levels"][-1]["max_error"] for cell in board["cells"]
                              if (cell["problem"], cell["method"]) == (problem, method)][0]
                             for method in ("linear, alpha 1/6", "iterated linear, alpha 1/6"))
            self.assertLess(iterated, own / 20)

        rows = list(csv.DictReader(io.StringIO(self.content("board/scoreboard.csv"))))
        levels = [(cell, level) for cell in board["cells"] for level in cell["levels"]]
        self.assertEqual(len([row for row in rows if row["refused"]]), len(board["cells"]) - len(served))
        self.assertFalse([name for name in rows[0] if "seconds" in name])
        for row, (cell, level) in zip((row for row in rows if not row["refused"]), levels):
            self.assertEqual((row["problem"], row["method"], int(row["unknowns"])),
                             (cell["problem"], cell["method"], level["unknowns"]))
            for error in ERRORS:
                self.assertEqual(row[error] and float(row[error]), "" if level[error] is None else level[error])
                self.assertEqual(row[f"{error}_bytes_frontier"], str(level["frontier"][error]["bytes"]).lower())
        self.assertEqual(len(list(csv.DictReader(io.StringIO(self.content("board/timing.csv"))))), len(levels))

        page = self.content("board/scoreboard.html")
        HTMLParser().feed(page)
        self.assertEqual(page.count("<svg"), 5)
        self.assertFalse([link for link in re.findall(r"https?://[^\"]*", page) if "www.w3.org" not in link])
        for cell in board["cells"]:
            if cell["refused"]:
                self.assertIn("not served", page)
                self.assertIn(cell["method"] + ": ", table)
        names = os.listdir(self.path("board"))
        self.assertEqual(len([name for name in names if name.endswith(".svg")]), 10)
        self.assertIn("cube_mean_error_against_unknowns.svg", names)

        # From the store, on one thread: all but the seconds is the same.
        self.expect(0, "experiment", "scoreboard", "--finest", "1", "--out", "again", "--threads", "1")
        self.assertEqual(self.content("again/scoreboard.csv"), self.content("board/scoreboard.csv"))

    def test_other_levels_are_refused_by_name(self):
        for words in (["scoreboard", "--finest", "0"], ["scoreboard", "--finest", "7"], ["scoreboard", "--finest", "x"],
                      ["file.json", "--finest", "1"]):
            done = self.run_program("experiment", *words)
            self.assertEqual(done.returncode, 2)
            self.assertIn("--finest", done.stderr.decode())


if __name__ == "__main__":
    unittest.main()
