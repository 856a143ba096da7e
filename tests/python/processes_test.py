# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C, exceptions in callbacks, threads, forks and the interpreter's end, each in a process of its own."""
import signal
import subprocess
import sys
import textwrap
import unittest

from module import MOST_SECONDS, ModuleTest

# Minutes of work, cut short by what is tried; `at_work` is set once it has begun.
LONG = """
import os, signal, sys, threading
import radcert as rc
at_work = threading.Event()
def begun(fraction, words):
    at_work.set()
long = rc.Problem(rc.ellipsoid(1, "3/4", "1/2"), reflectivity="1/2", solution="exp(x)", levels=[5], basis=rc.inset(2, "1/10"))
short = rc.Problem(rc.cube(), reflectivity="1/2", emission=1, levels=[0])
"""


class Processes(ModuleTest):
    def start(self, text):
        return subprocess.Popen([sys.executable, "-u", "-c", LONG + textwrap.dedent(text)], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def run_to_its_end(self, text, code=0):
        process = self.start(text)
        output, said = process.communicate(timeout=MOST_SECONDS)
        self.assertEqual(process.returncode, code, output + said)
        return output, said

    def test_ctrl_c_stops_a_computation_and_the_next_one_runs(self):
        process = self.start("""
            try:
                long.solve(progress=lambda fraction, words: print("begun"))
            except KeyboardInterrupt:
                print("stopped")
            print(short.solve()[0].values.value[0].round(9))
        """)
        self.assertEqual(process.stdout.readline(), "begun\n")
        process.send_signal(signal.SIGINT)
        output, said = process.communicate(timeout=MOST_SECONDS)
        self.assertEqual((output, process.returncode), ("stopped\n2.0\n", 0), said)

    def test_the_rounding_of_the_callers_thread_does_not_matter(self):
        output, _ = self.run_to_its_end("""
            import ctypes, ctypes.util
            libm = ctypes.CDLL(ctypes.util.find_library("m"))
            def numbers():
                factors = rc.box(3, "21/10", "7/5").factors(by="piece", certified=True)
                return [factors.value.tobytes(), factors.radius.tobytes(), short.solve()[0].values.value.tobytes()]
            usual = numbers()
            for mode in (0x400, 0x800, 0xc00):
                assert libm.fesetround(mode) == 0
                print(numbers() == usual, libm.fegetround() == mode)
                libm.fesetround(0)
        """)
        self.assertEqual(output, 3 * "True True\n")

    def test_a_handler_of_ones_own_decides(self):
        output, _ = self.run_to_its_end("""
            class Mine(Exception):
                pass
            def handler(*_):
                raise Mine
            signal.signal(signal.SIGUSR1, handler)
            def send():
                at_work.wait()
                os.kill(os.getpid(), signal.SIGUSR1)
            threading.Thread(target=send).start()
            try:
                long.solve(progress=begun)
            except Mine:
                print("stopped")
        """)
        self.assertEqual(output, "stopped\n")

    def test_an_exception_in_a_callback_stops_the_computation_and_is_raised(self):
        output, _ = self.run_to_its_end("""
            class Mine(Exception):
                pass
            def fail(fraction, words):
                raise Mine(words)
            try:
                long.solve(progress=fail)
            except Mine as error:
                print("raised", error)
            try:
                short.solve(progress=lambda: None)
            except TypeError:
                print("arguments")
            try:
                short.solve(progress=3)
            except rc.InputError as error:
                print(error.source)
            try:
                short.solve(progress=lambda fraction, words: sys.exit(7))
            except SystemExit:
                print("exit")
            print(len(short.solve()))
        """)
        self.assertEqual(output, "raised level 5\narguments\nprogress\nexit\n1\n")

    def test_ctrl_c_while_a_function_of_python_is_at_work(self):
        process = self.start("""
            import time
            import numpy as np
            def slow(points):
                print("begun")
                time.sleep(0.05)
                return np.ones(len(points))
            try:
                short.replace(emission=None, solution=slow, levels=[2]).solve()
            except KeyboardInterrupt:
                print("stopped")
            print(short.replace(emission=lambda points: np.ones(len(points))).solve()[0].values.value[0].round(9))
        """)
        self.assertEqual(process.stdout.readline(), "begun\n")
        process.send_signal(signal.SIGINT)
        output, said = process.communicate(timeout=MOST_SECONDS)
        self.assertEqual(process.returncode, 0, said)
        self.assertEqual(output.replace("begun\n", ""), "stopped\n2.0\n", said)
        # All calls would be some seven hundred.
        self.assertLess(output.count("begun\n"), 60)

    def test_python_ends_while_a_function_of_it_is_at_work(self):
        output, _ = self.run_to_its_end("""
            import time
            import numpy as np
            def slow(points):
                at_work.set()
                time.sleep(0.02)
                return np.ones(len(points))
            thread = threading.Thread(target=lambda: short.replace(emission=None, solution=slow, levels=[0]).solve(), daemon=True)
            thread.start()
            at_work.wait()
            print("end")
        """)
        self.assertEqual(output, "end\n")

    def test_a_fork_with_a_function_of_python(self):
        output, _ = self.run_to_its_end("""
            import numpy as np
            problem = short.replace(emission=lambda points: np.ones(len(points)))
            problem.solve()
            child = os.fork()
            if child == 0:
                try:
                    problem.solve()
                except rc.EnvironmentError:
                    del problem
                    os._exit(5)
            print(os.WEXITSTATUS(os.waitpid(child, 0)[1]))
        """)
        self.assertEqual(output, "5\n")

    def test_a_callback_may_compute(self):
        output, _ = self.run_to_its_end("""
            inner = []
            short.solve(progress=lambda fraction, words: inner.append(float(rc.reference("cube_opposite_faces", 5))))
            print(bool(inner), len(set(inner)))
        """)
        self.assertEqual(output, "True 1\n")

    def test_threads_compute_beside_each_other(self):
        output, _ = self.run_to_its_end("""
            results, errors = {}, []
            def work(name):
                try:
                    for _ in range(3):
                        problem = rc.Problem(rc.cube(), reflectivity="1/2", solution="x*y + z", levels=[0, 1])
                        results.setdefault(name, []).append(problem.solve().errors["node_error"].value.tolist())
                        rc.reference("cube_opposite_faces", 30)
                        rc.Mesh(([(0,0,0),(1,0,0),(0,1,0)], [(0,1,2)])).pieces
                except Exception as error:
                    errors.append(error)
            threads = [threading.Thread(target=work, args=(name,)) for name in range(4)]
            for thread in threads: thread.start()
            for thread in threads: thread.join()
            print(errors, len({str(each) for all in results.values() for each in all}))
        """)
        self.assertEqual(output, "[] 1\n")

    def test_the_interpreter_runs_while_the_library_computes(self):
        output, _ = self.run_to_its_end("""
            count = 0
            thread = threading.Thread(target=lambda: rc.Problem(rc.cube(), reflectivity="1/2", emission=1, levels=[2]).solve())
            thread.start()
            while thread.is_alive():
                count += 1
            print(count > 3)
        """)
        self.assertEqual(output, "True\n")

    def test_a_stop_ends_what_other_threads_compute(self):
        process = self.start("""
            def work():
                try:
                    long.solve(progress=begun)
                except rc.Interrupted as error:
                    print("other:", error)
            thread = threading.Thread(target=work)
            thread.start()
            at_work.wait()
            try:
                long.solve(progress=lambda fraction, words: print("begun"))
            except KeyboardInterrupt:
                pass
            thread.join()
            print(len(short.solve()))
        """)
        self.assertEqual(process.stdout.readline(), "begun\n")
        process.send_signal(signal.SIGINT)
        output, said = process.communicate(timeout=MOST_SECONDS)
        self.assertEqual(process.returncode, 0, said)
        self.assertTrue(output.startswith("other:"), output)
        self.assertTrue(output.endswith("1\n"), output)

    def test_a_daemon_thread_does_not_keep_the_interpreter_from_ending(self):
        self.run_to_its_end("""
            thread = threading.Thread(target=lambda: long.solve(progress=begun), daemon=True)
            thread.start()
            at_work.wait()
        """)

    def test_a_fork_before_the_first_computation_computes(self):
        done = subprocess.run([sys.executable, "-c", textwrap.dedent("""
            import os, radcert as rc
            child = os.fork()
            if child == 0:
                print(len(rc.reference("cube_opposite_faces", 10).routes), flush=True)
                os._exit(0)
            assert os.waitpid(child, 0)[1] == 0
        """)], capture_output=True, text=True, timeout=MOST_SECONDS, check=True)
        self.assertEqual(done.stdout, "2\n")

    def test_a_fork_after_it_is_refused_by_name(self):
        output, _ = self.run_to_its_end("""
            short.solve()
            child = os.fork()
            if child == 0:
                try:
                    short.solve()
                except rc.EnvironmentError as error:
                    print("spawn" in str(error), isinstance(error, OSError), flush=True)
                    os._exit(5)
                os._exit(0)
            print(os.WEXITSTATUS(os.waitpid(child, 0)[1]))
            print(len(short.solve()))
        """)
        self.assertEqual(output, "True True\n5\n1\n")

    def test_a_forked_child_ends_as_usual(self):
        output, _ = self.run_to_its_end("""
            thread = threading.Thread(target=lambda: long.solve(progress=begun), daemon=True)
            thread.start()
            at_work.wait()
            child = os.fork()
            if child == 0:
                sys.exit(3)
            print(os.WEXITSTATUS(os.waitpid(child, 0)[1]))
        """)
        self.assertEqual(output, "3\n")

    def test_the_number_of_threads_changes_no_bit(self):
        output, _ = self.run_to_its_end("""
            found = set()
            for count in (1, 2, None):
                rc.limit_threads(count)
                problem = rc.Problem(rc.ellipsoid(), reflectivity="1/2", solution="exp(x)", levels=[1])
                found.add(problem.solve().errors["node_error"].value.tobytes())
            for wrong in (0, -1, 5000):
                try:
                    rc.limit_threads(wrong)
                except rc.InputError as error:
                    print(error.source)
            print(len(found))
        """)
        self.assertEqual(output, "threads\nthreads\nthreads\n1\n")


if __name__ == "__main__":
    unittest.main()
