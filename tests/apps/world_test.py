# SPDX-License-Identifier: GPL-3.0-or-later
"""Faults of the world: pipes, full disks, no threads, no store, names, other processes."""
import hashlib
import json
import os
import re
import resource
import signal
import subprocess
import threading
import unittest
import xml.etree.ElementTree as xml

from program import RADCERT, ProgramTest, small

TRIANGLES = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"


def in_process(*limits):
    """What a child does before it becomes the program."""
    def prepare():
        for what, most in limits:
            resource.setrlimit(what, (most, most))
    return prepare


class WorldTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("problem.json", small())

    def start(self, *words, prepare=None, stdin=subprocess.DEVNULL, **environment):
        return subprocess.Popen([RADCERT, *words], cwd=self.folder, env=self.environment(**environment), stdin=stdin,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=prepare)

    def run_with(self, *words, input=None, **options):
        with self.start(*words, stdin=subprocess.PIPE, **options) as program:
            out, said = program.communicate(input, timeout=300)
        return program.returncode, out, said.decode(errors="replace")

    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()


class Inputs(WorldTest):
    def test_the_first_signal_ends_the_wait_for_a_pipe(self):
        os.mkfifo(self.path("pipe.json"))
        for words in (["solve", "pipe.json", "--json", "result.json"], ["check", "pipe.json"], ["basis", "pipe.json"]):
            for sent in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(words=words, sent=sent), self.start(*words) as program:
                    self.assertTrue(program.stderr.readline())  # that it waits
                    program.send_signal(sent)
                    _, said = program.communicate(timeout=300)
                    self.assertEqual(program.returncode, 130, said)
                    self.assertIn(b"interrupted", said)
        self.assertEqual(self.entries(), ["pipe.json", "problem.json"])

    def test_a_pipe_is_read_once_and_its_digest_is_that_of_what_was_read(self):
        text = json.dumps(small()).encode()
        os.mkfifo(self.path("pipe.json"))

        def feed():
            with open(self.path("pipe.json"), "wb") as pipe:
                pipe.write(text)
        writer = threading.Thread(target=feed)
        writer.start()
        self.expect(0, "solve", "pipe.json", "--out", "out")
        writer.join()
        inputs = json.loads(self.content("out/provenance.json"))["inputs"]
        self.assertIn(hashlib.sha256(text).hexdigest(), json.dumps(inputs))

    def test_standard_input_has_the_digest_of_what_was_read(self):
        text = json.dumps(small()).encode()
        code, _, said = self.run_with("solve", "/dev/stdin", "--out", "out", input=text)
        self.assertEqual(code, 0, said)
        inputs = json.loads(self.content("out/provenance.json"))["inputs"]
        self.assertIn(hashlib.sha256(text).hexdigest(), json.dumps(inputs))

    def test_nothing_is_written_over_an_input(self):
        self.write("mesh.obj", TRIANGLES)
        self.write("on_mesh.json", small(surface={"file": "mesh.obj"}, reflectivity="1/2", solution="x"))
        self.expect(0, "basis", "inset", "--degree", "1", "--alpha", "1/6", "--nodes", "nodes.json")
        experiment = self.expect(0, "example", "experiment")
        self.write("experiment.json", experiment)
        self.write("solution.json", small())
        os.symlink("problem.json", self.path("link.json"))
        os.link(self.path("problem.json"), self.path("hard.json"))
        before = {name: self.content(name) for name in self.entries()}
        for words in (["solve", "problem.json", "--json", "problem.json"],
                      ["solve", "problem.json", "--json", "./problem.json"],
                      ["solve", "problem.json", "--json", "link.json"],
                      ["solve", "problem.json", "--nodes", "hard.json"],
                      ["solve", "link.json", "--vtu", "problem.json"],
                      ["solve", "on_mesh.json", "--ply", "mesh.obj"],
                      ["solve", "solution.json", "--out", "."],
                      ["experiment", "experiment.json", "--out", "."],
                      ["experiment", "experiment.json", "--json", "experiment.json"],
                      ["basis", "nodes.json", "--nodes", "nodes.json"],
                      ["surface", "mesh.obj", "--write", "mesh.obj"],
                      ["factors", "mesh.obj", "--space", "--out", "mesh.obj"],
                      ["check", "problem.json", "--json", "problem.json"]):
            with self.subTest(words=words):
                self.assertIn("over the input", self.refusal(*words))
        self.assertEqual({name: self.content(name) for name in self.entries()}, before)

    def refusal(self, *words):
        done = self.run_program(*words)
        self.assertEqual(done.returncode, 2, done.stderr)
        return done.stderr.decode()

    def test_outputs_are_files_of_their_own(self):
        for words in (["solve", "problem.json", "--json", "a", "--nodes", "a"],
                      ["solve", "problem.json", "--vtu", "a", "--ply", "./a"],
                      ["solve", "problem.json", "--out", "out", "--json", "out/solution.json"],
                      ["factors", "cube", "--out", "a.csv", "--json", "a.surfaces.csv"]):
            with self.subTest(words=words):
                os.makedirs(self.path("out"), exist_ok=True)
                self.assertIn("too; allowed", self.refusal(*words))
        self.expect(0, "solve", "problem.json", "--nodes", "/dev/null", "--vtu", "/dev/null")

    def test_a_name_that_no_file_can_have_is_refused_before_the_work(self):
        long = "n" * 300
        for words in (["solve", "problem.json", "--json", long], ["solve", "problem.json", "--out", long],
                      ["solve", "problem.json", "--out", long + "/below"], ["factors", "cube", "--out", long + ".csv"],
                      ["solve", long], ["experiment", long], ["check", long], ["basis", long],
                      ["surface", long + ".obj"], ["factors", long + ".obj"], ["verify", long]):
            with self.subTest(words=words):
                self.refusal(*words)
        self.assertEqual(self.entries(), ["problem.json"])


class Outputs(WorldTest):
    def test_where_a_disk_is_full_all_files_stay_as_they_were(self):
        self.expect(0, "solve", "problem.json", "--out", "out")
        before = {name: self.content("out/" + name) for name in os.listdir(self.path("out"))}
        self.write("problem.json", small(reflectivity="1/2"))
        limit = in_process((resource.RLIMIT_FSIZE, 4000))
        code, _, said = self.run_with("solve", "problem.json", "--out", "out", prepare=limit)
        self.assertEqual(code, 3, said)
        self.assertIn("File too large", said)
        self.assertEqual({name: self.content("out/" + name) for name in os.listdir(self.path("out"))}, before)
        code, _, said = self.run_with("solve", "problem.json", "--out", "new/below", prepare=limit)
        self.assertEqual(code, 3, said)
        self.assertEqual(self.entries(), sorted(["out", "problem.json"] + ["out/" + name for name in before]))

    def test_what_only_the_store_cannot_take_is_a_warning(self):
        code, out, said = self.run_with("solve", "problem.json", prepare=in_process((resource.RLIMIT_FSIZE, 100)))
        self.assertEqual(code, 0, said)
        self.assertTrue(out)
        self.assertIn("finished work is not kept", said)
        self.assertEqual(os.listdir(self.store), [])

    def test_a_full_device_is_the_environments_failure(self):
        done = self.run_program("solve", "problem.json", "--json", "/dev/full")
        self.assertEqual(done.returncode, 3)
        self.assertIn(b"/dev/full", done.stderr)
        with open("/dev/full", "wb") as full:
            done = subprocess.run([RADCERT, "solve", "problem.json"], cwd=self.folder, env=self.environment(),
                                  stdout=full, stderr=subprocess.PIPE, timeout=300, check=False)
        self.assertEqual(done.returncode, 3)
        self.assertIn(b"stdout", done.stderr)

    def test_a_store_that_cannot_be_written_is_said(self):
        self.write("no folder", "x")
        self.write("experiment.json", {"schema": "radcert/experiment/1", "name": "two", "vary": {"reflectivity": ["1/2", "1/3"]},
                                       "base": {key: value for key, value in small().items()
                                                if key not in ("schema", "reflectivity")}})
        for words in (["solve", "problem.json"], ["experiment", "experiment.json"], ["factors", "cube"],
                      ["verify", "ac98/equation_5"]):
            for environment in ({"RADCERT_STORE": self.path("no folder")}, {"RADCERT_STORE": "/proc/none"},
                                {"RADCERT_STORE": "", "HOME": "", "XDG_CACHE_HOME": ""}):
                with self.subTest(words=words, environment=environment):
                    done = self.run_program(*words, **environment)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertIn(b"finished work is not kept", done.stderr)

    def test_files_of_two_processes_in_one_folder_are_of_one_of_them(self):
        self.write("other.json", small(reflectivity="1/2"))
        for _ in range(4):
            running = [self.start("solve", name, "--out", "out") for name in ("problem.json", "other.json")]
            for program in running:
                program.communicate(timeout=300)
                self.assertEqual(program.returncode, 0)
            problem = json.loads(self.content("out/provenance.json"))["inputs"][0]["name"]
            reflectivity = json.loads(self.content("out/solution.json"))["problem"]["reflectivity"]
            self.assertEqual(reflectivity, "1" if problem == "problem.json" else "1/2")

    def test_names_that_are_not_text_make_files_that_are(self):
        name = os.fsencode(self.folder) + b"/p\xff\xc3(.json"
        with open(name, "wb") as file:
            file.write(json.dumps(small()).encode())
        self.write(b"m\xfe.obj".decode(errors="surrogateescape"), "g \udcff\n".encode(errors="surrogateescape") + TRIANGLES.encode())
        out, said = subprocess.Popen([os.fsencode(RADCERT), b"solve", name, b"--out", b"out"], cwd=self.folder,
                                     env=self.environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE).communicate()
        self.assertTrue(out, said)
        for entry in os.listdir(self.path("out")):
            with self.subTest(entry=entry):
                self.content("out/" + entry).decode("utf-8")
                if entry.endswith((".svg", ".vtu")):
                    xml.fromstring(self.content("out/" + entry))


class Limits(WorldTest):
    def prepare_without_threads(self):
        # The limit counts the processes of a user, and is not for root: as a user of its own the program has one.
        nobody = 54321
        if os.geteuid() != 0:
            self.skipTest("only root can become a user of no other process")
        for path in (self.folder, self.store):
            os.chmod(path, 0o777)

        def prepare():
            os.setgroups([])
            os.setgid(nobody)
            os.setuid(nobody)
            resource.setrlimit(resource.RLIMIT_NPROC, (1, 1))
        return prepare

    def test_without_further_threads_the_numbers_are_the_same(self):
        prepare = self.prepare_without_threads()
        if not os.access(os.path.dirname(RADCERT), os.X_OK):
            self.skipTest("the program is not for others")
        self.write("problem.json", small(triangulation={"levels": [0, 1, 2]}))
        alone, out, said = self.run_with("solve", "problem.json", "--json", "-", prepare=prepare)
        if alone == -1 or "Permission denied" in said:
            self.skipTest("the program is not for others")
        self.assertEqual(alone, 0, said)
        levels = json.loads(out)["levels"]
        self.assertEqual(levels, json.loads(self.expect(0, "solve", "problem.json", "--fresh", "--json", "-"))["levels"])

    def test_what_does_not_fit_into_the_addresses_is_refused_by_the_plan(self):
        self.write("problem.json", small(triangulation={"levels": [5]}, solver={"name": "direct"}))
        limit = in_process((resource.RLIMIT_AS, 1 << 30))
        code, _, said = self.run_with("solve", "problem.json", "--threads", "1", prepare=limit)
        self.assertEqual(code, 2, said)
        self.assertIn("a plan within", said)

    # What the program holds before it begins: code, libraries, tables.
    UNPLANNED = 48 << 20
    # What a command may take beside its plan or --max-memory; stacks of threads count by what they use.
    HELD = 256 << 20

    def peak_of(self, *words):
        """What the command, which succeeds, held at most, in bytes."""
        program = self.start(*words, "--quiet", "--threads", "2")
        program.stdout.close()
        with program.stderr as errors:
            said = errors.read()
        _, status, used = os.wait4(program.pid, 0)
        program.returncode = os.waitstatus_to_exitcode(status)
        self.assertIn(program.returncode, (0, -13), said)  # -13: nobody reads its table
        return used.ru_maxrss * 1024

    def test_memory_stays_within_the_plan(self):
        flat = {"surface": {"name": "cube"}, "reflectivity": "1/2", "solution": "x"}
        sweep = {"schema": "radcert/experiment/1", "name": "sweep",
                 "base": small(schema=None, basis=None, triangulation={"levels": [3]}, solver={"name": "direct"}),
                 "vary": {"basis": [{"family": "inset", "degree": 1, "alpha": alpha} for alpha in ("1/6", "1/7")]}}
        for words in (["solve", self.write("direct.json", small(triangulation={"levels": [4]}, solver={"name": "direct"}))],
                      ["solve", self.write("gmres.json", small(triangulation={"levels": [4]}, solver={"name": "gmres"}))],
                      ["solve", self.write("verified.json", small(**flat, triangulation={"levels": [1]}, solver={"name": "verified"}))],
                      ["solve", self.write("h2.json", small(**flat, triangulation={"levels": [3]}, operator={"name": "h2"}))],
                      ["experiment", self.write("sweep.json", sweep)],
                      ["factors", "cube", "--level", "3"], ["factors", "cube", "--level", "2", "--json", "/dev/null"],
                      ["factors", "cube", "--level", "1", "--certified"],
                      ["factors", "cube", "--level", "2", "--rays", "--by", "piece", "--accuracy", "1e-2"],
                      ["picture", "figure_8_lehtinen", "--size", "64x64", "--separation", "0.3", "--out", "room.png"]):
            with self.subTest(words=words):
                refused = self.run_program(*words, "--max-memory", "1k")
                self.assertEqual(refused.returncode, 2, refused.stderr)
                planned = int(re.search(rb"needs (?:[\d.]+ \w+ \()?(\d+) bytes", refused.stderr)[1])
                self.assertLessEqual(self.peak_of(*words), planned + self.UNPLANNED)

    def test_memory_that_no_plan_counts_is_held_too(self):
        # Everything else: with next to nothing for plans a command stays within what it may take beside them.
        room = {"surface": {"name": "cube"}, "reflectivity": "1/2", "solution": None, "emission": {"floor": "1", "*": "0"},
                "triangulation": {"levels": [0]}}
        commands = [["solve", self.write("room.json", small(**room)), "--guarantee", "0.1", "--certificate", "proof.json"],
                    ["check", "proof.json"],
                    ["edge", "--angle", "90", "--rho", "1/2"],
                    ["verify", "ac98/equation_20"],
                    ["reference", "two_squares_1", "--digits", "40"],
                    ["surface", "two_piece"],
                    ["basis", "inset", "--degree", "4", "--alpha", "1/10"],
                    ["list", "surfaces"], ["schema", "problem"], ["example", "problem"]]
        others = {"factors", "experiment", "picture", "completion", "man"}  # have plans, or but print themselves
        named = re.findall(r"^  (\w+)  ", self.expect(0, "--help").split("Subcommands:")[1], re.MULTILINE)
        self.assertEqual(sorted(named), sorted({words[0] for words in commands} | others))
        for words in commands:
            with self.subTest(words=words):
                self.assertLessEqual(self.peak_of(*words, "--max-memory", "1k"), self.HELD + self.UNPLANNED)
        # The same in little: this takes more.
        code, _, said = self.run_with("check", "/dev/zero", "--max-memory", "1k", input=b"")
        self.assertEqual(code, 2, said)

    def test_where_memory_ends_nothing_aborts(self):
        for mebibytes in (48, 64, 96):
            for words in (["reference", "two_squares_1", "--digits", "1000"], ["basis", "inset", "--degree", "6", "--alpha", "1/10"],
                          ["solve", "problem.json"], ["factors", "cube", "--certified"]):
                with self.subTest(words=words, mebibytes=mebibytes):
                    limit = in_process((resource.RLIMIT_AS, mebibytes << 20))
                    code, _, said = self.run_with(*words, "--threads", "1", prepare=limit)
                    self.assertIn(code, (0, 2, 3, 127), said)  # 127: not even the program's libraries fit
                    self.assertNotIn("defect", said)


if __name__ == "__main__":
    unittest.main()
