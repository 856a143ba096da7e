#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Kills the program at random moments and holds what is left, and what the same command makes of it, against a run
that nobody disturbed.

    python3 tests/robust/kills.py build/release/bin/radcert --count 300
    python3 tests/robust/kills.py build/release/bin/radcert --count 20 --only experiment --seed 7

A kill is a signal (KILL, TERM, INT), at a moment of the time that the command takes by itself. After it no file of the
output may be there in part: each is the undisturbed one's or is not there. A signal that can be caught leaves no
temporary file, and a store that every record of can be read. The same command, run again in the same folder with the
same store, must end with the exit code and the bits of the undisturbed run. What depends on the clock stands apart and
is left out: timing.csv, the keys `timing` and `seconds` of JSON files and of the document in a page. Exit code 0 where
all of that holds, else 1.
"""
import argparse
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

PROBLEM = {
    "schema": "radcert/problem/1",
    "surface": {"name": "two_piece", "p": 2},
    "triangulation": {"levels": [0, 1, 2, 3]},
    "basis": {"family": "inset", "degree": 1, "alpha": "1/6"},
    "reflectivity": "1",
    "solution": "1/sqrt(x^2 + y^2 + (z-1/2)^2)",
}
GUARANTEE = {
    "schema": "radcert/problem/1",
    "surface": {"name": "ellipsoid", "a": 1, "b": "1.3", "c": "1.7"},
    "triangulation": {"levels": [0]},
    "basis": {"family": "inset", "degree": 1, "alpha": "1/6"},
    "reflectivity": "1/2",
    "emission": "1 + x",
    "guarantee": {"width": "1e-7", "of": "values"},
}
EXPERIMENT = {
    "schema": "radcert/experiment/1",
    "name": "kills",
    "base": {key: PROBLEM[key] for key in ("surface", "reflectivity", "solution")} | {"triangulation": {"levels": [0, 1, 2]}},
    "vary": {"basis": [{"family": "inset", "degree": 1, "alpha": "1/6"}, {"family": "inset", "degree": 2, "alpha": "1/10"}],
             "solver": [{"name": "direct"}, {"name": "gmres"}]},
}
INPUTS = {"problem.json": PROBLEM, "guarantee.json": GUARANTEE, "experiment.json": EXPERIMENT}
COMMANDS = {
    "solve": ["solve", "problem.json", "--out", "out", "--json", "result.json", "--nodes", "nodes.csv"],
    "experiment": ["experiment", "experiment.json", "--out", "out"],
    "factors": ["factors", "octahedron", "--certified", "--out", "factors.csv"],
    "reference": ["reference", "--all", "--digits", "8", "--out", "out"],
    "verify": ["verify", "m06/equation_14", "--out", "out"],
    "picture": ["picture", "figure_3", "--size", "160x120", "--out", "picture.svg", "--json", "picture.json"],
    "guarantee": ["solve", "guarantee.json", "--vtu", "u.vtu", "--nodes", "u.csv", "--json", "result.json"],
}
SIGNALS = [signal.SIGKILL, signal.SIGTERM, signal.SIGINT]
# A temporary of a process that was killed by SIGKILL.
TEMPORARY = ".tmp"
# Kills between two words of progress.
PROGRESS = 25


class Failure(Exception):
    """What a kill should not have left."""


def without_clock(name, data):
    if name.endswith("timing.csv"):
        return b""
    # The page of a report has the document in one script element.
    page = re.fullmatch(rb'(.*<script type="application/json" id="data">)(.*?)(</script>.*)', data, re.DOTALL)
    if not page and not name.endswith(".json"):
        return data
    document = json.loads(page[2] if page else data)

    def stripped(value):
        if isinstance(value, dict):
            return {key: stripped(each) for key, each in value.items() if key not in ("timing", "seconds")}
        return [stripped(each) for each in value] if isinstance(value, list) else value
    rest = json.dumps(stripped(document)).encode()
    return page[1] + rest + page[3] if page else rest


class Place:
    """A folder with the inputs and a store, both of one command alone."""

    def __init__(self, scratch, name):
        self.folder = scratch / name
        self.store = scratch / (name + "-store")
        self.folder.mkdir()
        self.store.mkdir()
        for file, content in INPUTS.items():
            (self.folder / file).write_text(json.dumps(content), encoding="utf-8")

    def start(self, program, command):
        return subprocess.Popen([program, *command, "--quiet"], cwd=self.folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                env={**os.environ, "RADCERT_STORE": str(self.store)})

    def files(self):
        return {str(path.relative_to(self.folder)): path.read_bytes()
                for path in sorted(self.folder.rglob("*")) if path.is_file() and path.name not in INPUTS}

    def temporaries(self):
        return [path for root in (self.folder, self.store) for path in root.rglob("*") if path.name.endswith(TEMPORARY)]

    def remove(self):
        shutil.rmtree(self.folder)
        shutil.rmtree(self.store)


def undisturbed(program, scratch, name):
    """Seconds, exit code, stdout and files of a command."""
    place = Place(scratch, "undisturbed-" + name)
    begin = time.monotonic()
    running = place.start(program, COMMANDS[name])
    out, said = running.communicate(timeout=600)
    seconds = time.monotonic() - begin
    if running.returncode not in (0, 1):
        raise SystemExit(f"{name}: undisturbed it ends with {running.returncode}: {said.decode(errors='replace')}")
    files = {file: without_clock(file, data) for file, data in place.files().items()}
    place.remove()
    return seconds, running.returncode, out, files


def compare(when, files, expected, whole):
    for file, data in files.items():
        if file.endswith(TEMPORARY):
            continue
        if file not in expected:
            raise Failure(f"{when}: {file} is of no undisturbed run")
        try:
            same = without_clock(file, data) == expected[file]
        except ValueError:
            raise Failure(f"{when}: {file} is there in part") from None
        if not same:
            raise Failure(f"{when}: {file} has other bits")
    if whole and set(expected) - set(files):
        raise Failure(f"{when}: {sorted(set(expected) - set(files))} are missing")


def kill(program, scratch, name, sent, moment, expected):
    """One kill; whether the signal came before the end."""
    _, code, out, files = expected
    place = Place(scratch, "killed")
    try:
        running = place.start(program, COMMANDS[name])
        time.sleep(moment)
        early = running.poll() is None
        if early:
            running.send_signal(sent)
        _, said = running.communicate(timeout=60)
        if early and running.returncode not in (-sent, 130, code):
            raise Failure(f"exit code {running.returncode}: {said.decode(errors='replace')}")
        compare("after the kill", place.files(), files, False)
        if sent != signal.SIGKILL and place.temporaries():
            raise Failure(f"left {[path.name for path in place.temporaries()]}")
        again = place.start(program, COMMANDS[name])
        out_again, said = again.communicate(timeout=600)
        if again.returncode != code:
            raise Failure(f"run again it ends with {again.returncode}: {said.decode(errors='replace')}")
        compare("run again", place.files(), files, True)
        if name not in ("solve", "experiment", "verify", "guarantee") and out_again != out:
            raise Failure("run again it prints other words")
        return early
    finally:
        place.remove()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--only", choices=sorted(COMMANDS), action="append")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    program = str(arguments.program.resolve())
    names = arguments.only or sorted(COMMANDS)
    chance = random.Random(arguments.seed)
    scratch = pathlib.Path(tempfile.mkdtemp(prefix="radcert-kills-"))
    failures = 0
    counts = {}
    try:
        expected = {}
        for number in range(arguments.count):
            # Every command meets every signal, whatever the count.
            name = names[number % len(names)]
            sent = SIGNALS[(number // len(names)) % len(SIGNALS)]
            if name not in expected:
                expected[name] = undisturbed(program, scratch, name)
            moment = chance.uniform(0, expected[name][0])
            counts.setdefault((name, sent.name), [0, 0])[0] += 1
            try:
                counts[name, sent.name][1] += kill(program, scratch, name, sent, moment, expected[name])
            except Failure as failure:
                failures += 1
                print(f"{name}, {sent.name} after {moment:.3f} s: {failure}", flush=True)
            if (number + 1) % PROGRESS == 0:
                print(f"{number + 1} of {arguments.count}", file=sys.stderr, flush=True)
    finally:
        shutil.rmtree(scratch)
    for (name, sent), (kills, early) in sorted(counts.items()):
        print(f"{name:10} {sent:8} {kills:4} kills, {early:4} before the end")
    print(f"{arguments.count} kills, {failures} with losses")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
