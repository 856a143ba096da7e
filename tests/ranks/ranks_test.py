# SPDX-License-Identifier: GPL-3.0-or-later
"""Under mpirun radcert says what it says by itself, to the bit, and everything once."""
import json
import os
import signal
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "apps"))
from program import MOST_SECONDS, RADCERT, ProgramTest, small  # noqa: E402

MPIRUN = os.environ["RADCERT_MPIRUN"]


def shared(**changes):
    """A problem whose levels ranks share; level 1 of the two is too coarse for clusters far apart."""
    return small(**{"surface": {"name": "ellipsoid", "a": 1, "b": "3/2", "c": 2}, "triangulation": {"levels": [2, 3]},
                    "reflectivity": "1/2 + x/8", "solution": "exp(x/2) + y*z",
                    "operator": {"name": "h2", "tolerance": "1e-6"}, **changes})


def numbers(text):
    """A result without what may differ from run to run."""
    result = json.loads(text)
    for key in ("timing", "command", "problem"):
        result.pop(key, None)
    return result


class Ranks(ProgramTest):
    def run_ranks(self, count, *words, before=(), **options):
        own = ["--allow-run-as-root"] if os.geteuid() == 0 else []
        return subprocess.run([MPIRUN, *own, "--oversubscribe", "-n", str(count), *before, RADCERT, *words],
                              cwd=self.folder, env=self.environment(OMPI_MCA_rmaps_base_oversubscribe="1"),
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=MOST_SECONDS, **options)

    def expect_ranks(self, count, code, *words):
        done = self.run_ranks(count, *words)
        self.assertEqual(done.returncode, code, done.stderr.decode(errors="replace"))
        return done

    def solved(self, count, *words):
        self.expect_ranks(count, 0, "solve", "problem.json", "--fresh", "--quiet", "--json", "shared.json",
                          "--nodes", "shared.csv", *words)
        with open(self.path("shared.json"), encoding="utf-8") as file:
            result = numbers(file.read())
        with open(self.path("shared.csv"), encoding="utf-8") as file:
            return result, file.read()

    def test_any_number_of_ranks_gives_the_bits_of_one_process(self):
        self.write("problem.json", shared())
        self.expect(0, "solve", "problem.json", "--json", "alone.json", "--nodes", "alone.csv")
        with open(self.path("alone.json"), encoding="utf-8") as file:
            result = numbers(file.read())
        with open(self.path("alone.csv"), encoding="utf-8") as file:
            nodes = file.read()
        self.assertEqual([level["operator"] for level in result["levels"]], ["h2", "h2"])
        for count in (1, 2, 3, 5, 8):
            with self.subTest(ranks=count):
                self.assertEqual(self.solved(count), (result, nodes))

    def test_the_solvers_of_petsc_give_the_same_bits_on_any_number_of_ranks(self):
        # One level: the way from one to the next knows no solver.
        self.write("problem.json", {**shared(), "triangulation": {"levels": [2]}})
        for options in ([], ["-ksp_type", "bcgs"], ["-ksp_type", "tfqmr"]):
            options = ["-ksp_monitor", *options]
            one, nodes = self.solved(1, "--petsc", *options)
            self.assertEqual([(level["solver"], level["operator"]) for level in one["levels"]], [("petsc", "h2")])
            for count in (2, 3):
                with self.subTest(ranks=count, options=options):
                    self.assertEqual(self.solved(count, "--petsc", *options), (one, nodes))

    def test_what_one_solver_of_petsc_has_found_is_not_taken_for_another_ones(self):
        self.write("problem.json", {**shared(), "triangulation": {"levels": [2]}})
        iterations = []
        for method in ("gmres", "bcgs", "gmres"):
            text = self.expect_ranks(2, 0, "solve", "problem.json", "--json", "-", "--petsc", "-ksp_type", method).stdout
            iterations.append(json.loads(text)["levels"][0]["iteration"]["iterations"])
        self.assertNotEqual(iterations[0], iterations[1])
        self.assertEqual(iterations[0], iterations[2])
        self.expect_ranks(2, 2, "solve", "problem.json", "--petsc", "-ksp_type", "pipecg")

    def test_levels_that_are_not_shared_are_the_first_ranks(self):
        self.write("problem.json", small())
        alone = numbers(self.expect(0, "solve", "problem.json", "--json", "-"))
        done = self.expect_ranks(3, 0, "solve", "problem.json", "--fresh", "--json", "-")
        self.assertEqual(numbers(done.stdout), alone)

    def test_what_one_rank_finds_wrong_is_said_once(self):
        # At the end of the last chart alone.
        self.write("bright.json", shared(solution=None, emission="1", reflectivity="1/2 + sqrt((z + 1)^2) - (z + 1)"))
        alone = self.run_program("solve", "bright.json")
        self.assertEqual(alone.returncode, 2)
        for count in (2, 5):
            done = self.expect_ranks(count, 2, "solve", "bright.json")
            said = [line for line in done.stderr.decode().splitlines() if line.startswith("radcert:")]
            self.assertEqual(said, [alone.stderr.decode().strip()])

    def test_wrong_uses_are_refused_once_and_by_name(self):
        self.write("problem.json", shared())
        for count, words, name in (
                (2, ["solve", "problem.json", "--petsc", "-ksp_nonsense", "1"], "-ksp_nonsense"),
                (2, ["solve", "problem.json", "--petsc"], "--petsc"),
                (12, ["solve", "problem.json"], "the number of ranks"),
                (2, ["verify"], "mpirun"),
                (2, ["solve", "nowhere.json"], "nowhere.json")):
            with self.subTest(words=words):
                done = self.expect_ranks(count, 2, *words)
                said = [line for line in done.stderr.decode().splitlines() if line.startswith("radcert:")]
                self.assertEqual(len(said), 1, said)
                self.assertIn(name, said[0])
        self.write("direct.json", shared(solver={"name": "neumann"}))
        done = self.expect_ranks(2, 2, "solve", "direct.json", "--petsc", "-ksp_monitor")
        self.assertIn(b"neumann", done.stderr)
        for options in (["-ksp_type", "pgmres"], ["-pc_type", "jacobi"]):
            done = self.expect_ranks(2, 2, "solve", "problem.json", "--petsc", *options)
            self.assertIn(b"radcert: --petsc: ", done.stderr)
        self.assertIn("mpirun", self.run_program("solve", "problem.json", "--petsc", "-x").stderr.decode())

    def test_ranks_with_different_files_are_refused(self):
        for folder, reflectivity in (("a", "1/2"), ("b", "1/3")):
            os.mkdir(self.path(folder))
            problem = shared()
            problem["reflectivity"] = reflectivity
            self.write(os.path.join(folder, "problem.json"), problem)
        own = ["--allow-run-as-root"] if os.geteuid() == 0 else []
        part = lambda folder: ["-n", "1", "--wdir", self.path(folder), RADCERT, "solve", "problem.json"]
        done = subprocess.run([MPIRUN, *own, "--oversubscribe", *part("a"), ":", *part("b")], cwd=self.folder,
                              env=self.environment(), capture_output=True, timeout=MOST_SECONDS, check=False)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(b"is another file on rank 1", done.stderr)
        # A rank that does not see the file is told what it says.
        os.remove(self.path("b/problem.json"))
        done = subprocess.run([MPIRUN, *own, "--oversubscribe", *part("a"), ":", *part("b")], cwd=self.folder,
                              env=self.environment(), capture_output=True, timeout=MOST_SECONDS, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_factors_are_shared_by_blocks(self):
        words = ["factors", "cube", "--level", "2", "--json", "-"]
        alone = json.loads(self.expect(0, *words, "--fresh"))
        for count in (2, 3, 5):
            done = json.loads(self.expect_ranks(count, 0, *words, "--fresh").stdout)
            for key in ("timing", "command"):
                done.pop(key, None), alone.pop(key, None)
            self.assertEqual(done, alone)

    @staticmethod
    def children(process):
        with open(f"/proc/{process}/task/{process}/children", encoding="ascii") as file:
            return [int(word) for word in file.read().split()]

    def job_with_a_signal(self, rank, signum, watched=True):
        """Begins a job of three ranks and sends one of them, or what watches it, a signal once level 3 is done; gives the
        code and what was said."""
        self.write("problem.json", {**shared(), "triangulation": {"levels": [2, 3, 4]}})
        own = ["--allow-run-as-root"] if os.geteuid() == 0 else []
        with subprocess.Popen([MPIRUN, *own, "--oversubscribe", "-n", "3", RADCERT, "solve", "problem.json", "--fresh"],
                              cwd=self.folder, env=self.environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              start_new_session=True) as job:
            said = b""
            while b"level 3:" not in said:
                said = job.stderr.readline()
                self.assertTrue(said)
            watching = self.children(job.pid)[rank]
            os.kill(self.children(watching)[0] if watched else watching, signum)
            said = job.communicate(timeout=60)[1]
        return job.returncode, said

    def test_an_interruption_of_one_rank_ends_all_with_one_message(self):
        for watched in (True, False):
            code, said = self.job_with_a_signal(2, signal.SIGINT, watched)
            self.assertEqual(code, 130)
            self.assertEqual(said.count(b"radcert: interrupted"), 1, said)

    def test_a_job_that_loses_a_rank_ends_and_goes_on_when_begun_again(self):
        code, said = self.job_with_a_signal(1, signal.SIGKILL)
        self.assertEqual(code, 3)
        self.assertEqual(said.count(b"radcert: rank 1 was ended by signal 9 (Killed)"), 1, said)
        done = self.expect_ranks(2, 0, "solve", "problem.json", "--json", "again.json")
        self.assertIn(b"found in the store", done.stderr)
        self.expect(0, "solve", "problem.json", "--fresh", "--json", "alone.json")
        results = []
        for name in ("again.json", "alone.json"):
            with open(self.path(name), encoding="utf-8") as file:
                results.append(numbers(file.read()))
        self.assertEqual(results[0], results[1])


if __name__ == "__main__":
    unittest.main()
