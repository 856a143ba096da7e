# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong input ends with 2, says where and what is allowed, and writes nothing."""
import unittest

from program import ProgramTest, small


def triangulation(levels, **more):
    return small(triangulation={"levels": levels, **more})


def basis(degree, alpha):
    return small(basis={"family": "inset", "degree": degree, "alpha": alpha})


CUBE = {"name": "cube"}
DUPLICATE = '{"schema": "radcert/problem/1", "surface": {"name": "cube", "name": "box"}}'

# name: (problem, pointer, what is said)
PROBLEMS = {
    "an unknown key": (small(albedo="1"), "/albedo", "unknown key"),
    "an unknown key below": (small(surface={"name": "cube", "p": 2}), "/surface/p", "unknown key"),
    "a missing key": (small(basis=None), "/basis", "is missing"),
    "a missing key below": (small(triangulation={}), "/triangulation/levels", "is missing"),
    "a duplicate key": (DUPLICATE, "/surface/name", "occurs twice"),
    "an unknown surface": (small(surface={"name": "two_peice"}), "/surface/name", "did you mean two_piece?"),
    "a surface of a later version": (small(surface={"name": "torus"}), "/surface/name", "not available"),
    "an unknown basis": (small(basis={"family": "outset"}), "/basis/family", "allowed: inset"),
    "an unknown solver": (small(solver={"name": "lu"}), "/solver/name", "allowed: auto, direct"),
    "a misspelt solver": (small(solver={"name": "gmers"}), "/solver/name", "allowed: auto, direct, gmres, neumann, "),
    "a tolerance of 0": (small(solver={"name": "gmres", "tolerance": 0}), "/solver/tolerance", "4.440892098500626e-16"),
    "a negative tolerance": (small(solver={"name": "neumann", "tolerance": "-1e-9"}), "/solver/tolerance", "below 1"),
    "a tolerance beyond double": (small(solver={"name": "gmres", "tolerance": "1e-16"}), "/solver/tolerance", "double"),
    "a tolerance of a word": (small(solver={"name": "gmres", "tolerance": "small"}), "/solver/tolerance", "rounding"),
    "a tolerance for elimination": (small(solver={"name": "direct", "tolerance": 1e-9}), "/solver/tolerance",
                                    "is not for direct"),
    "a quadrature tolerance of 0": (small(quadrature={"tolerance": 0}), "/quadrature/tolerance", "from 1e-13"),
    "a negative quadrature tolerance": (small(quadrature={"tolerance": "-1e-9"}), "/quadrature/tolerance", "outside"),
    "a quadrature finer than double": (small(quadrature={"tolerance": "1e-14"}), "/quadrature/tolerance",
                                       "what double can hold"),
    "a quadrature of no tolerance": (small(quadrature={}), "/quadrature/tolerance", "is missing"),
    "an interpolant of degree 0": (small(geometry={"interpolated": 0}), "/geometry/interpolated", "from 1 to 6"),
    "an interpolant of degree 7": (small(geometry={"interpolated": 7}), "/geometry/interpolated", "from 1 to 6"),
    "an interpolant of no degree": (small(geometry={"data": "surface"}), "/geometry/interpolated", "is missing"),
    "data of an unknown place": (small(geometry={"interpolated": 2, "data": "nodes"}), "/geometry/data",
                                 "surface, interpolant"),
    "an unknown geometry": (small(geometry="interpolated"), "/geometry", "exact"),
    "alpha = 0 on an interpolant": (
        small(surface={"name": "sphere"}, reflectivity="1/2", geometry={"interpolated": 2},
              basis={"family": "inset", "degree": 1, "alpha": 0}),
        "/basis/alpha", "sides where interpolated elements meet"),
    "an unknown piece": (small(reflectivity={"roof": "1", "*": "0"}), "/reflectivity/roof", "lower, upper"),
    "a wrong type": (small(surface="cube"), "/surface", "is a string"),
    "a wrong type below": (triangulation("0"), "/triangulation/levels", "is a string"),
    "a wrong schema": (small(schema="radcert/solution/1"), "/schema", "radcert/problem/1"),
    "alpha = 1/3": (basis(1, "1/3"), "/basis/alpha", "[0, 1/3)"),
    "alpha below 0": (basis(2, -0.1), "/basis/alpha", "[0, 1/3)"),
    "a malformed alpha": (basis(1, "one sixth"), "/basis/alpha", "decimal or fraction"),
    "alpha with denominator 0": (basis(1, "1/0"), "/basis/alpha", "decimal or fraction"),
    "alpha = 0 at an edge": (
        small(surface={"name": "two_squares"}, reflectivity="1/2", basis={"family": "inset", "degree": 1, "alpha": 0}),
        "/basis/alpha", "edge"),
    "alpha = 0 at the edges of a cube": (
        small(surface=CUBE, reflectivity="1/2", basis={"family": "inset", "degree": 2, "alpha": "0"}),
        "/basis/alpha", "edge"),
    "an absurd p": (small(surface={"name": "two_piece", "p": 1e300}), "/surface/p", "allowed"),
    "p below 1": (small(surface={"name": "two_piece", "p": "0.999"}), "/surface/p", "in [1, 1000]"),
    "a negative level": (triangulation([0, 1, -1]), "/triangulation/levels/2", "whole numbers"),
    "a fractional level": (triangulation([0, 0.5]), "/triangulation/levels/1", "whole numbers"),
    "no level": (triangulation([]), "/triangulation/levels", "not empty"),
    "an absurd level": (triangulation([0, 1, 1000000000]), "/triangulation/levels/2", "whole numbers"),
    "levels that descend": (triangulation([1, 0]), "/triangulation/levels/1", "ascending"),
    "solution and emission": (small(emission="1"), "/emission", "exactly one"),
    "neither solution nor emission": (small(solution=None), "/solution", "exactly one"),
    "a syntax error": (small(solution="1 + * x"), "/solution", "column 5"),
    "a syntax error at the end": (small(reflectivity="(1"), "/reflectivity", "column 3"),
    "a syntax error on a piece": (small(reflectivity={"lower": "1", "upper": "y + q"}), "/reflectivity/upper",
                                  "column 5"),
    "a solution that is infinite": (small(solution="1/(z-z)"), "/solution", "node"),
    "an emission that is no number": (small(solution=None, emission="sqrt(x-5)"), "/emission", "node"),
    "a reflectivity that is no number": (small(reflectivity="log(0-x)"), "/reflectivity", "node"),
    "a reflectivity above 1": (small(reflectivity="1.01"), "/reflectivity", "allowed"),
    "a reflectivity above 1 somewhere": (small(reflectivity="1/2 + x"), "/reflectivity", "allowed"),
    "a reflectivity below 0": (small(reflectivity={"upper": "0-x", "*": "0"}), "/reflectivity", "allowed"),
    "a norm of K that is 1": (small(surface=CUBE), "/reflectivity", "allowed"),
    "a plan beyond all memory": (triangulation([0, 20]), "/triangulation/levels/1", "of memory"),
    "a plan beyond 64 bits": (triangulation([30]), "/triangulation/levels/0", "allowed"),
}

# name: (bytes, what is said)
BYTES = {
    "an empty file": (b"", "is empty"),
    "a truncated file": (b'{"schema": "radcert/prob', "byte 25"),
    "a binary file": (bytes(range(256)) * 16, "is not JSON"),
    "a file that is not UTF-8": (b'{"schema": "radcert/problem/1\xff"}', "byte 30"),
    "100,000 nested arrays": (b"[" * 100000 + b"]" * 100000, "nested too deeply"),
    "100,000 nested objects": (b'{"a":' * 100000, "nested too deeply"),
    "no object": (b"[1]", "is an array"),
}


class BadInput(ProgramTest):
    def refused(self, name, *words):
        before = self.entries()
        done = self.run_program("solve", name, *words, "--out", "out", "--json", "result.json", "--nodes", "nodes.csv",
                                "--vtu", "u.vtu")
        said = done.stderr.decode()
        self.assertEqual(done.returncode, 2, said)
        self.assertEqual(done.stdout, b"")
        self.assertIn(name + ": ", said)
        self.assertEqual(self.entries(), before)
        return said.splitlines()[-1]

    def test_a_problem_is_refused_with_file_pointer_and_what_is_allowed(self):
        for name, (problem, pointer, text) in PROBLEMS.items():
            with self.subTest(name):
                said = self.refused(self.write("problem.json", problem))
                self.assertIn("problem.json: " + pointer, said)
                self.assertIn(text, said)
                self.assertIn("; allowed: ", said)

    def test_bytes_that_are_no_problem_are_refused(self):
        for name, (content, text) in BYTES.items():
            with self.subTest(name):
                self.assertIn(text, self.refused(self.write("problem.json", content)))

    def test_a_plan_above_max_memory_is_refused_before_any_work(self):
        said = self.refused(self.write("problem.json", small()), "--max-memory", "1000")
        self.assertIn("/triangulation/levels/0", said)
        self.assertIn("1000 bytes", said)

    def test_an_iteration_without_a_contraction_is_refused(self):
        problem = small(surface=CUBE, reflectivity="0.95", triangulation={"levels": [0]}, solver={"name": "neumann"},
                        basis={"family": "inset", "degree": 2, "alpha": "1/6"})
        said = self.refused(self.write("problem.json", problem))
        self.assertIn('problem.json: /solver/name: "neumann" has no error bound at level 0', said)
        self.assertTrue(said.endswith("; allowed: direct"), said)

    def test_a_plan_counts_the_second_matrix_of_direct_only(self):
        bytes_between = "150000000"  # a matrix of 3072 unknowns has 75 million bytes
        name = self.write("problem.json", {**triangulation([4]), "solver": {"name": "direct"}})
        self.assertIn("/triangulation/levels/0", self.refused(name, "--max-memory", bytes_between))
        # Within the limit: refused for what is looked at later.
        for solver in ["gmres", "auto"]:
            iterated = {**triangulation([4]), "solver": {"name": solver}, "solution": "1/(z-z)"}
            self.assertIn("/solution", self.refused(self.write("problem.json", iterated), "--max-memory", bytes_between))

    def test_a_file_that_is_not_there_is_refused(self):
        self.refused("missing.json")

    def test_the_last_level_is_checked_before_the_first_is_solved(self):
        said = self.refused(self.write("problem.json", triangulation([0, 1, 2, 25])))
        self.assertIn("/triangulation/levels/3", said)
        self.assertNotIn("level 0", said)


class BadCommandLine(ProgramTest):
    def refused(self, *words):
        done = self.run_program(*words)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, b"")
        return done.stderr.decode()

    def test_unknown_words_are_refused_with_what_there_is(self):
        self.write("problem.json", small())
        for words, text in [
                (["slove"], "did you mean solve?"),
                (["solve"], "PROBLEM"),
                (["solve", "problem.json", "again.json"], "again.json"),
                (["solve", "problem.json", "--levels", "3"], "--levels"),
                (["--json", "x"], "radcert --help"),
                (["list", "surface"], "did you mean surfaces?"),
                (["schema", "nothing"], "problem, solution"),
                (["example", "nothing"], "problem"),
                (["verify", "--budget", "huge"], "quick, standard, full"),
                (["verify", "no_such_paper"], "no_such_paper"),
                (["solve", "problem.json", "--threads", "0"], "--threads"),
                (["solve", "problem.json", "--threads", "two"], "--threads"),
                (["solve", "problem.json", "--max-memory", "-1"], "--max-memory"),
                (["solve", "problem.json", "--max-memory", "99999999999999999999"], "--max-memory"),
                (["solve", "problem.json", "--nodes", "no/such/folder.csv"], "--nodes"),
                (["solve", "problem.json", "--out", "problem.json"], "--out"),
                (["solve", "problem.json", "--vtu", "-"], "--vtu: \"-\" is the standard output"),
                (["solve", "problem.json", "--json", "-", "--out", "-"], "--out: \"-\" is the standard output"),
        ]:
            with self.subTest(words):
                self.assertIn(text, self.refused(*words))
        self.assertEqual(self.entries(), ["problem.json"])

    def test_an_empty_word_is_not_one_that_was_left_out(self):
        self.write("problem.json", small())
        for command, options in [
                (["solve", "problem.json"], ["--guarantee", "--of", "--at", "--certificate", "--out", "--json", "--vtu",
                                             "--nodes", "--threads", "--max-memory"]),
                (["factors", "cube"], ["--compare", "--tolerance", "--differences", "--accuracy", "--by", "--level",
                                       "--out"]),
                (["surface", "cube"], ["--unit", "--front", "--write"]),
                (["reference", "cube_floor_radiosity"], ["--digits", "--set"])]:
            for option in options:
                with self.subTest(command=command, option=option):
                    self.assertIn(f"radcert: {option}: \"\" is empty", self.refused(*command, option, ""))
        self.assertIn("PROBLEM", self.refused("solve", ""))


if __name__ == "__main__":
    unittest.main()
