# SPDX-License-Identifier: GPL-3.0-or-later
"""What a person at a terminal sees: width, colour, the first line, completion, the manual page."""
import fcntl
import os
import pty
import re
import shutil
import signal
import struct
import subprocess
import termios
import unittest

from program import RADCERT, ProgramTest, small


class Terminal(ProgramTest):
    def at_terminal(self, *words, columns=80, **environment):
        """The program at a terminal of so many columns: its exit code and all that it shows there."""
        leader, follower = pty.openpty()
        fcntl.ioctl(follower, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        with subprocess.Popen([RADCERT, *words], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=follower,
                              stderr=follower, env=self.environment(TERM="xterm", **environment)) as program:
            os.close(follower)
            shown = b""
            while True:
                try:
                    part = os.read(leader, 65536)
                except OSError:
                    break
                if not part:
                    break
                shown += part
        os.close(leader)
        return program.returncode, shown.decode().replace("\r\n", "\n")

    def test_tables_and_help_fit_the_width_and_lose_no_cell(self):
        self.write("problem.json", small())
        cells = self.expect(0, "solve", "problem.json").split()
        for columns in [40, 60, 80, 200]:
            for words in [["solve", "problem.json", "--quiet"], ["--help"], ["solve", "--help"], ["list", "surfaces"]]:
                _, shown = self.at_terminal(*words, columns=columns)
                words_too_long = [line for line in shown.splitlines() if len(line) > columns and " " in line.strip()]
                self.assertEqual(words_too_long, [], (words, columns))
                if words[0] == "solve" and "--quiet" in words:
                    self.assertLessEqual(set(cells), set(shown.split()), columns)

    def test_a_radius_stays_with_its_error(self):
        self.write("problem.json", small())
        for columns in [60, 80]:
            _, shown = self.at_terminal("solve", "problem.json", "--quiet", columns=columns)
            self.assertRegex(shown, r"(?m)^level .*\|u-u_n\| nodes +\+- +ratio")
            self.assertNotRegex(shown, r"(?m)^level +(\+-|ratio)")

    def test_verdicts_fit_the_width(self):
        what = ["verify", "ac98/equation_37", "ac98/table_4.n48", "--quiet"]
        _, whole = self.at_terminal(*what, columns=200)
        self.assertRegex(whole, r"(?m)^  ac98/table_4.n48.discretisation_error +contradicted +contradicted +1.035")
        for columns in [60, 80]:
            _, shown = self.at_terminal(*what, columns=columns)
            self.assertEqual([line for line in shown.splitlines() if len(line) > columns], [])
            self.assertRegex(shown, r"(?m)^  ac98/table_4.n48.discretisation_error\n    contradicted +1.035[0-9e±. -]+1.04E-4 ")
            self.assertEqual(self.words_of(whole), self.words_of(shown) | {"recorded"})

    def words_of(self, text):
        """The words of a table but for the seconds, which differ, and commas, which stand elsewhere in a narrow one."""
        return {word.rstrip(",") for word in text.split() if not re.match(r"^[0-9]+\.[0-9]$", word)}

    def test_json_stays_json_at_a_terminal(self):
        _, shown = self.at_terminal("schema", "problem", columns=40)
        self.assertEqual(shown, self.expect(0, "schema", "problem"))

    def test_a_pipe_gets_whole_lines(self):
        self.write("problem.json", small())
        self.assertEqual(self.expect(0, "solve", "problem.json"), self.expect(0, "solve", "problem.json", COLUMNS="40"))

    def test_colour_is_for_terminals_and_not_where_it_is_refused(self):
        self.assertIn("\x1b[", self.at_terminal("solve", "missing.json", NO_COLOR="")[1])
        self.assertNotIn("\x1b[", self.at_terminal("solve", "missing.json", NO_COLOR="1")[1])
        self.assertNotIn(b"\x1b[", self.run_program("solve", "missing.json", NO_COLOR="").stderr)

    def test_a_first_line_comes_before_the_work_is_done(self):
        # The signal is sent at the first line: a run that says nothing before its end would not end with 130.
        self.write("slow.json", small(basis={"family": "inset", "degree": 2, "alpha": "0.1"},
                                      triangulation={"levels": [4]}))
        with subprocess.Popen([RADCERT, "solve", "slow.json"], cwd=self.folder, env=self.environment(),
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as program:
            self.assertIn(b"level 4", program.stderr.readline())
            program.send_signal(signal.SIGINT)
            program.communicate(timeout=300)
        self.assertEqual(program.returncode, 130)

    def test_the_manual_page_names_every_command_and_option(self):
        page = self.expect(0, "man")
        plain = page.replace("\\-", "-")
        helps = self.expect(0, "--help")
        for command in re.findall(r"^  ([a-z]+) ", helps.split("Subcommands:")[1], re.MULTILINE):
            self.assertIn(f".SS {command}\n", plain)
            for option in re.findall(r"--[a-z-]+", self.expect(0, command, "--help").split("Options:")[1]):
                self.assertIn(option, plain, command)
        self.assertFalse([line for line in page.splitlines() if line.startswith("'")])
        if shutil.which("groff"):
            done = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z"], input=page.encode(), capture_output=True,
                                  check=False)
            self.assertEqual((done.returncode, done.stderr), (0, b""))

    def completions(self, *words):
        script = self.expect(0, "completion", "bash")
        line = (script + "COMP_WORDS=(" + " ".join(f"'{word}'" for word in words) + ")\n"
                f"COMP_CWORD={len(words) - 1}\ncompopt() {{ :; }}\n_radcert\n" + "printf '%s\\n' \"${COMPREPLY[@]}\"\n")
        done = subprocess.run(["bash", "-c", line], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.split()

    def test_bash_completes_commands_options_choices_and_files(self):
        self.write("problem.json", small())
        os.mkdir(self.path("folder"))
        self.assertEqual(self.completions("radcert", "exp"), ["experiment"])
        self.assertIn("--vtu", self.completions("radcert", "solve", "--"))
        self.assertEqual(self.completions("radcert", "verify", "--budget", "s"), ["standard"])
        self.assertEqual(self.completions("radcert", "schema", "prob"), ["problem"])
        self.assertEqual(self.completions("radcert", "solve", "prob"), ["problem.json"])
        self.assertEqual(self.completions("radcert", "solve", "--out", ""), ["folder"])
        self.assertEqual(self.completions("radcert", "verify", "ac98/equation_37"), ["ac98/equation_37"])
        self.assertIn("ac98", self.completions("radcert", "verify", "ac9"))
        self.assertIn("ac98/table_1.alpha_1_6.n4.discretisation_error",
                      self.completions("radcert", "verify", "ac98/table_1.al"))
        self.assertEqual(self.completions("radcert", "basis", "se"), ["search"])
        self.assertEqual(self.completions("radcert", "list", "so"), ["solvers"])
        self.assertEqual(self.completions("radcert", "solve", "--of", "m"), ["means"])
        self.assertIn("cube_opposite_faces", self.completions("radcert", "reference", "cube_"))
        self.assertIn("two_piece", self.completions("radcert", "surface", "two_"))
        self.assertEqual(self.completions("radcert", "basis", "symm"), ["symmetric"])
        self.assertEqual(self.run_program("completion", "fish").returncode, 2)


    def test_bash_completes_the_claims_of_a_folder(self):
        os.mkdir(self.path("own"))
        with open(self.path("own/claims.toml"), "w", encoding="utf-8") as file:
            file.write("# two\n[node_error]\nsays = 'a [b]'\n[node_order]\n")
        self.assertIn("own/node_order", self.completions("radcert", "verify", "own/node_o"))
        self.assertEqual(self.completions("radcert", "verify", "own/node_"), ["own/node_error", "own/node_order"])
        self.assertEqual(self.completions("radcert", "verify", "elsewhere/no"), [])

    def test_warnings_are_said_once(self):
        with open(self.path("fin.obj"), "w", encoding="utf-8") as file:
            file.write("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 2 1 0\nv 2 0 1\nf 1 2 3\nf 1 3 4\nf 2 6 5\n")
        what = ["factors", "fin.obj", "--space", "--front", "right-hand", "--accuracy", "0.1", "--quiet"]
        self.assertEqual(self.at_terminal(*what, columns=200)[1].count("warning: mended: 1 triangle cut"), 1)
        done = self.run_program(*what)
        self.assertIn(b"warning: mended: 1 triangle cut", done.stdout)
        self.assertIn(b"warning: mended: 1 triangle cut", done.stderr)


if __name__ == "__main__":
    unittest.main()
