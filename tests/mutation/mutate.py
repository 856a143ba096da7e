#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plants faults in the mathematics, one at a time, and says whether the tests see them.

    python3 tests/mutation/mutate.py build/release                      all faults; takes an hour or more
    python3 tests/mutation/mutate.py build/release --page solve         those of faults/solve.toml
    python3 tests/mutation/mutate.py build/release --only contraction   those whose file or words contain it
    python3 tests/mutation/mutate.py build/release --count 5 --turn commit
                                                                        five of them, others for another commit
    python3 tests/mutation/mutate.py . --list                           what is recorded, as tables

A fault is an entry of faults/<layer>.toml: the file, what is wrong, the text that stands there once, what takes its
place, and the tests that must fail, "<program>:<filter of GoogleTest>", of which the first program that sees the fault
is enough. `sources` names those that are compiled where a header is changed that many read: a test that uses it alone
need not rebuild the library. `missed` gives the reason why no test fails; `equivalent` the proof that none can, since all
that is stated still holds. `judged = false` is said of one that has not been planted yet: --unjudged plants those alone,
and nothing else counts them. The checkout and the build are not touched: the sources that see the changed file are
compiled into a scratch folder, and the test program is linked with them. Exit code 0 where every fault is as recorded, 1
where one is not, 2 where an entry is wrong.
"""
import argparse
import json
import os
import pathlib
import re
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
# A fault may make a loop endless; the slowest tests of a program take less than a minute. What waits for others of a
# busy machine has no time of the processor, and may take longer by the clock.
MOST_SECONDS = 300
MOST_SECONDS_BY_THE_CLOCK = 3600
KEYS = {"file", "what", "find", "put", "tests", "sources", "missed", "equivalent", "judged"}


class WrongEntry(Exception):
    """An entry that can't be planted."""


def read_faults(name):
    faults = []
    for page in sorted((HERE / "faults").glob(f"{name or '*'}.toml")):
        for number, fault in enumerate(tomllib.loads(page.read_text(encoding="utf-8"))["fault"], 1):
            fault["place"] = f"{page.name}, fault {number}"
            wrong = set(fault) - KEYS - {"place"}
            if wrong or not {"file", "what", "find", "put", "tests"} <= set(fault):
                raise WrongEntry(f"{fault['place']}: its keys are {sorted(set(fault) - {'place'})}, not {sorted(KEYS)}")
            if "missed" in fault and "equivalent" in fault:
                raise WrongEntry(f"{fault['place']}: is missed, or equivalent")
            faults.append(fault)
    return faults


def is_seen(fault):
    """Whether a test is said to fail with it."""
    return "missed" not in fault and "equivalent" not in fault


def changed_text(fault):
    text = (ROOT / fault["file"]).read_text(encoding="utf-8")
    if text.count(fault["find"]) != 1:
        raise WrongEntry(f"{fault['place']}: its text stands {text.count(fault['find'])} times in {fault['file']}, not once")
    return text.replace(fault["find"], fault["put"])


class Build:
    """What ninja knows of a build folder."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder).resolve()
        self.compile = {}
        for entry in json.loads((self.folder / "compile_commands.json").read_text(encoding="utf-8")):
            words = shlex.split(entry["command"])
            self.compile[words[words.index("-o") + 1]] = (words, entry["file"])
        self.known_dependents = None
        self.links = {}

    def ninja(self, *words):
        done = subprocess.run(["ninja", "-C", str(self.folder), "-t", *words], capture_output=True, text=True, check=True)
        return done.stdout

    def link(self, program):
        """The words that link a program."""
        if program not in self.links:
            lines = [line for line in self.ninja("commands", program).splitlines() if f"-o bin/{program} " in line]
            if not lines:
                raise WrongEntry(f"no command links {program}")
            command = re.sub(r"^: && ", "", lines[-1]).split(" && ")[0]
            self.links[program] = shlex.split(command)
        return self.links[program]

    def dependents(self, file):
        """The objects that read a file."""
        if self.known_dependents is None:
            self.known_dependents = {}
            target = None
            for line in self.ninja("deps").splitlines():
                if line and not line[0].isspace():
                    target = line.split(":")[0]
                elif line.strip():
                    path = os.path.normpath(self.folder / line.strip())
                    self.known_dependents.setdefault(path, set()).add(target)
        return self.known_dependents.get(str(ROOT / file), set())


def without_precompiled_header(words):
    out = []
    skip = False
    for word, after in zip(words, words[1:] + [""]):
        if skip:
            skip = False
        elif word == "-include" and after.endswith("cmake_pch.hxx"):
            skip = True
        elif word not in ("-Winvalid-pch", "-Werror"):
            out.append(word)
    # The same bits in about half the time; warnings are about the fault.
    return out + ["-O1", "-w"]


def compiled(build, fault, objects, scratch):
    """Compiles the objects with the fault; their new places."""
    scratch.mkdir()
    overlay = scratch / "overlay"
    changed = overlay / fault["file"]
    changed.parent.mkdir(parents=True)
    changed.write_text(changed_text(fault), encoding="utf-8")
    new = {}
    for number, name in enumerate(sorted(objects)):
        words, source = build.compile[name]
        words = without_precompiled_header(words)
        output = scratch / f"{number}.o"
        words[words.index("-o") + 1] = str(output)
        if pathlib.Path(source).resolve() == ROOT / fault["file"]:
            words[words.index(source)] = str(changed)
        # One include folder a part of the checkout, before those of the build; the folder of the source for its own.
        words[1:1] = ["-I", str(overlay / "lib"), "-I", str(overlay), "-iquote", str(pathlib.Path(source).parent)]
        done = subprocess.run(words, cwd=build.folder, capture_output=True, text=True, check=False)
        if done.returncode:
            raise WrongEntry(f"{fault['place']}: does not compile:\n{done.stderr[:2000]}")
        new[name] = output
    return new


def affected(build, fault, program):
    """The objects of a program that see the changed file."""
    words = build.link(program)
    inside = {word for word in words if word.endswith(".o")}
    # Of a library only what is in the program's archives can matter.
    archives = {pathlib.Path(word).stem.removeprefix("lib") for word in words if word.endswith(".a")}
    in_program = {name for name in build.compile if name in inside or any(f"/{a}.dir/" in name for a in archives)}
    if fault["file"].endswith(".h"):
        objects = build.dependents(fault["file"]) & in_program
        if "sources" in fault:
            objects = {name for name in objects if pathlib.Path(build.compile[name][1]).name in fault["sources"]}
    else:
        objects = {name for name in in_program if pathlib.Path(build.compile[name][1]).resolve() == ROOT / fault["file"]}
    if not objects:
        raise WrongEntry(f"{fault['place']}: nothing in {program} reads {fault['file']}")
    return objects, inside


def limit_processor():
    resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS, MOST_SECONDS + 10))


def failing(build, fault, scratch):
    """The tests that fail with the fault, of the first program of those that are named in which one does."""
    new = {}
    for number, test in enumerate(fault["tests"]):
        program, _, pattern = test.partition(":")
        objects, inside = affected(build, fault, program)
        new |= compiled(build, fault, objects - set(new), scratch / str(number))
        words = [str(new[word]) if word in new else word for word in build.link(program)]
        binary = scratch / str(number) / program
        words[words.index("-o") + 1] = str(binary)
        # Before the archives, which then have nothing to add for what these define.
        first = next(k for k, word in enumerate(words) if word.endswith(".o"))
        words[first:first] = [str(new[name]) for name in sorted(objects - inside)]
        done = subprocess.run(words, cwd=build.folder, capture_output=True, text=True, check=False)
        if done.returncode:
            raise WrongEntry(f"{fault['place']}: does not link:\n{done.stderr[:2000]}")
        environment = {**os.environ, "RADCERT_STORE": str(scratch / "store")}
        try:
            done = subprocess.run([str(binary), f"--gtest_filter={pattern or '*'}", "--gtest_brief=1",
                                   "--gtest_fail_fast"], cwd=scratch, env=environment, capture_output=True, text=True,
                                  errors="replace", check=False, timeout=MOST_SECONDS_BY_THE_CLOCK,
                                  preexec_fn=limit_processor)
        except subprocess.TimeoutExpired:
            return [f"{program}: waits without an end"]
        finally:
            binary.unlink(missing_ok=True)
        if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
            return [f"{program}: no end"]
        if "No test" in done.stdout + done.stderr or "0 tests from 0 test suites ran" in done.stdout:
            raise WrongEntry(f"{fault['place']}: no test fits {test}")
        if done.returncode:
            names = re.findall(r"^\[  FAILED  \] ([A-Za-z0-9_./]+?),? ", done.stdout, re.MULTILINE)
            return [f"{program}:{name}" for name in dict.fromkeys(names)] or [f"{program}: ended with {done.returncode}"]
    return []


def report(fault, failed):
    """A line on a fault, and whether it is as recorded."""
    caught = bool(failed)
    as_recorded = caught == is_seen(fault)
    state = "caught" if caught else "missed"
    why = fault.get("missed") or fault.get("equivalent") or ""
    line = f"{state:7}{'' if as_recorded else 'NOT AS RECORDED  '}{fault['file']}: {fault['what']}"
    detail = ", ".join(failed[:3]) + (f" and {len(failed) - 3} more" if len(failed) > 3 else "")
    return line + (f"  [{detail or why}]" if detail or why else ""), as_recorded


def percentage(part, whole):
    """Rounded down to a tenth, so that no part is said to be larger than it is."""
    tenths = 1000 * part // whole if whole else 1000
    return f"{tenths // 10}.{tenths % 10} %"


def reasons(faults, kind):
    lines = []
    for fault in faults:
        if kind in fault:
            file = str(pathlib.PurePath(fault["file"]).relative_to("lib/radcert"))
            lines.append(f"| {file} | {fault['what']} | {fault[kind]} |")
    return lines


def tables(faults):
    """By layer what is planted, caught, missed and equivalent, and why each is that is not caught."""
    lines = ["| layer | planted | equivalent | caught | missed | caught of those that are not equivalent |",
             "|---|---|---|---|---|---|"]
    layers = {}
    for fault in faults:
        layers.setdefault("/".join(pathlib.PurePath(fault["file"]).parts[2:3]), []).append(fault)
    for layer, some in [*sorted(layers.items()), ("all", faults)]:
        missed = sum("missed" in fault for fault in some)
        equivalent = sum("equivalent" in fault for fault in some)
        caught = sum(is_seen(fault) for fault in some)
        lines.append(f"| {layer} | {len(some)} | {equivalent} | {caught} | {missed} | {percentage(caught, caught + missed)} |")
    lines += ["", "| file | fault that is missed | why |", "|---|---|---|", *reasons(faults, "missed")]
    lines += ["", "| file | change after which all that is stated holds | why |", "|---|---|---|",
              *reasons(faults, "equivalent")]
    return "\n".join(lines)


def turn(text):
    if text != "commit":
        return text
    try:
        done = subprocess.run(["git", "-C", str(ROOT), "rev-parse", "HEAD"], capture_output=True, text=True, check=False)
    except OSError:
        return "0"
    return done.stdout.strip() or "0" if done.returncode == 0 else "0"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build")
    parser.add_argument("--only", default="", help="those whose file or words contain this")
    parser.add_argument("--page", default="", help="those of faults/<page>.toml alone")
    parser.add_argument("--count", type=int, help="so many of them, of those that are recorded as caught")
    parser.add_argument("--turn", default="0",
                        help="which: a number in hexadecimal, or `commit`: that of the checkout, 0 where there is none")
    parser.add_argument("--unjudged", action="store_true", help="those alone of which nothing is recorded yet")
    parser.add_argument("--list", action="store_true", help="print what is recorded as tables, and plant nothing")
    options = parser.parse_args()
    faults = [fault for fault in read_faults(options.page) if options.only in fault["file"] or options.only in fault["what"]]
    for fault in faults:
        changed_text(fault)
    unjudged = [fault for fault in faults if not fault.get("judged", True)]
    faults = unjudged if options.unjudged else [fault for fault in faults if fault.get("judged", True)]
    if options.list:
        print(tables(faults))
        return 0
    if options.count is not None:
        # Those which tests see: that they still do.
        faults = [fault for fault in faults if is_seen(fault)]
    if options.count is not None and faults:
        # A prime number of steps apart, so that neighbours in a file are of different turns.
        first = int(turn(options.turn)[:12], 16) * options.count
        chosen = [(first + 7 * k) % len(faults) for k in range(min(options.count, len(faults)))]
        faults = [faults[k] for k in dict.fromkeys(chosen)]
    build = Build(options.build)
    good = 0
    wrong = 0
    for fault in faults:
        with tempfile.TemporaryDirectory(prefix="radcert-mutation-") as scratch:
            try:
                line, as_recorded = report(fault, failing(build, fault, pathlib.Path(scratch)))
            except WrongEntry as reason:
                line, as_recorded = f"WRONG ENTRY  {reason}", False
                wrong += 1
        print(line, flush=True)
        good += as_recorded
    print(f"{good} of {len(faults)} as recorded")
    return 2 if wrong else 0 if good == len(faults) else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except WrongEntry as wrong:
        print(wrong, file=sys.stderr)
        sys.exit(2)
