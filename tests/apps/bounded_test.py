# SPDX-License-Identifier: GPL-3.0-or-later
"""Inputs that ask for too much: each ends with a word that says why, or shows progress and stops at the first signal."""
import json
import random
import signal
import subprocess
import unittest

from program import RADCERT, ProgramTest

CUBE = {
    "schema": "radcert/problem/1",
    "surface": {"name": "cube"},
    "triangulation": {"levels": [0]},
    "basis": {"family": "inset", "degree": 1, "alpha": "1/6"},
    "reflectivity": "1/2",
    "solution": "x",
}
LONG = "+".join(f"sin(x*{k})" for k in range(250))


def cube(**changes):
    problem = {**CUBE, **changes}
    return {key: value for key, value in problem.items() if value is not None}


def of_emission(**changes):
    return cube(solution=None, **{"emission": "1", **changes})


def box(a, **changes):
    return cube(surface={"name": "box", "a": a, "b": 1, "c": 1}, **changes)


def many_groups(count):
    return "".join(f"v {k} 0 0\nv {k} 1 0\nv {k} 0 1\ng g{k}\nf {3 * k + 1} {3 * k + 2} {3 * k + 3}\n" for k in range(count))


def tetrahedron(scale):
    return (f"v 0 0 0\nv 1{scale} 0 0\nv 0 1{scale} 0\nv 0 0 1{scale}\n"
            "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")


def random_nodes(degree):
    """Nodes of thirty digits, whose Lagrange functions have coefficients of thousands."""
    chance = random.Random(degree)
    nodes = []
    for _ in range((degree + 1) * (degree + 2) // 2):
        a, b = chance.randrange(1, 10**30 // 3), chance.randrange(1, 10**30 // 3)
        nodes.append([f"0.{a:030d}", f"0.{b:030d}", f"0.{10**30 - a - b:030d}"])
    return {"schema": "radcert/nodes/1", "degree": degree, "nodes": nodes}


# Towers of powers: what they stand for has more digits than there is memory.
TOWER = "((((((1e400)^12)^12)^12)^12)^12)"
TOWERS = {"schema": "radcert/nodes/1", "space": [f"x1*{TOWER}/{TOWER}", "x2", "x3"],
          "nodes": [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]}


class Bounded(ProgramTest):
    def ended(self, *words):
        """The code with which a command ends; it never calls an input a defect of its own."""
        done = self.run_program(*words)
        self.assertIn(done.returncode, (0, 1, 2), done.stderr)
        self.assertNotIn(b"defect", done.stderr)
        return done.returncode

    def ends_at_the_first_signal(self, *words):
        with subprocess.Popen([RADCERT, *words, "--threads", "1"], cwd=self.folder, env=self.environment(),
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as program:
            try:
                self.assertTrue(program.stderr.readline(), "no progress")
                program.send_signal(signal.SIGTERM)
                _, said = program.communicate(timeout=60)
            finally:
                program.kill()
        self.assertEqual(program.returncode, 130, said)
        self.assertIn(b"interrupted", said)

    def test_what_is_asked_for_in_vain_is_refused(self):
        for name, (code, problem) in {
                "a pole": (2, cube(solution="1/(x-0.3)")),
                "a pole of order 20, proved": (1, cube(solution="1/(x-0.3)^20", solver={"name": "verified"})),
                "values near the end of double": (0, cube(solution="x*1e300")),
                "grading without end": (2, cube(triangulation={"levels": [3], "grading": 50})),
                "a thin box": (2, box("1e-400")),
                "10^12 steps": (1, cube(reflectivity="0.999999999999", solver={"name": "neumann"})),
                "alpha nearer to 0 than every double": (2, cube(basis={"family": "inset", "degree": 2, "alpha": "1e-400"})),
        }.items():
            with self.subTest(name):
                self.assertEqual(self.ended("solve", self.write("problem.json", problem)), code)

    def test_numbers_beyond_double_are_refused_or_meant(self):
        for text in ("1e-400", "1e400", "1e-99999", "0." + "3" * 990, "1/" + "3" * 990):
            for words in (["reference", "opposed_rectangles", "--set", "distance=" + text],
                          ["factors", "cube", "--accuracy", text], ["basis", "inset", "--degree", "2", "--alpha", text],
                          ["solve", self.write("e.json", of_emission()), "--guarantee", text, "--quiet"],
                          ["solve", "e.json", "--guarantee", "1", "--at", f"{text},1/2,0"],
                          ["check", "e.json", "--part", text]):
                if text.startswith("0.") and words[0] == "solve":
                    continue  # a third is a width like any other
                with self.subTest(words=words):
                    self.ended(*words)

    def test_many_keys_and_groups_are_read(self):
        keys = {f"k{k}": k for k in range(100000)}
        for document, words in (({"schema": "radcert/problem/1", **keys}, ["solve"]),
                                (cube(reflectivity=keys), ["solve"]),
                                ({"schema": "radcert/experiment/1", "name": "a", "base": {}, "vary": keys}, ["experiment"]),
                                ({"schema": "radcert/nodes/1", **keys}, ["basis"])):
            self.assertEqual(self.ended(*words, self.write("keys.json", document)), 2)
        self.write("groups.obj", many_groups(20000))
        self.ended("surface", "groups.obj")

    def test_scales_beyond_what_doubles_carry_are_refused(self):
        for scale in ("e-100", "e-200", "e-300", "e60"):
            self.write("mesh.obj", tetrahedron(scale))
            self.write("problem.json", of_emission(surface={"file": "mesh.obj"}))
            for words in (["surface", "mesh.obj"], ["factors", "mesh.obj"], ["factors", "mesh.obj", "--certified"],
                          ["factors", "mesh.obj", "--rays", "--by", "group"], ["solve", "problem.json"],
                          ["solve", "problem.json", "--guarantee", "1"]):
                with self.subTest(scale=scale, words=words):
                    self.ended(*words)

    def test_what_takes_long_shows_progress_and_stops(self):
        ellipsoid = {"name": "ellipsoid", "a": 100, "b": 1, "c": 1}
        for name, words in {
                "constants of a space": ["basis", self.write("towers.json", TOWERS)],
                "Lagrange functions of long coordinates": ["basis", self.write("nodes.json", random_nodes(12))],
                "an angle nearer to 0 than every double": ["reference", "inclined_rectangles", "--set", "half_turns=1e-400"],
                "a thousand digits": ["reference", "edge_exponent_90", "--digits", "1000"],
                "all to a thousand digits": ["reference", "--all", "--digits", "1000", "--out", "out"],
                "the sphere over the disk": ["reference", "sphere_over_disk", "--curve", "c.csv", "--points", "2000"],
                "a long formula": ["solve", self.write("long.json", of_emission(emission=LONG)), "--guarantee", "1e-3"],
                "a long box": ["solve", self.write("box.json", box("1e6", triangulation={"levels": [3]}))],
                "a long box, u itself": ["solve", self.write("boxe.json", box("1e6", solution=None, emission="1")),
                                         "--guarantee", "1e-3"],
                "a thin ellipsoid, proved": ["solve", self.write("ver.json", cube(surface=ellipsoid, triangulation={"levels": [2]},
                                                                                 solver={"name": "verified"}))],
                "h2": ["solve", self.write("h2.json", of_emission(operator={"name": "h2"}, triangulation={"levels": [6]}))],
                "rays": ["factors", "cube", "--level", "6", "--rays", "--accuracy", "1e-6", "--by", "piece"],
        }.items():
            with self.subTest(name):
                self.ends_at_the_first_signal(*words)
        self.assertNotIn("out", self.entries())


if __name__ == "__main__":
    unittest.main()
