#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks with clang's libFuzzer for inputs at which a reader crashes, hangs or throws what is not the input's fault.

    python3 tests/fuzz/fuzz.py build/release --seconds 60               each reader for a minute
    python3 tests/fuzz/fuzz.py build/release --reader obj --runs 10000000
    python3 tests/fuzz/fuzz.py build/release --keep build/corpus        go on from the inputs that were found before

The readers are those of readers.cpp. Their sources, and those of readers.cpp and fuzz_reader.cpp, are compiled by clang
with libFuzzer's coverage and the address and undefined-behaviour sanitizers into a scratch folder, and linked with the
libraries of the build folder, which is not touched. An input that takes more than ten seconds or more than two
gigabytes is a finding too. What is found is written to --findings, one file each. Prints a line a reader: inputs,
coverage, findings; exit code 0 where there are none, 1 where there are some, 3 where clang is missing.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
# What reads: the objects whose source stands below one of these.
INSTRUMENTED = ["lib/radcert/formats/json", "lib/radcert/formats/problem", "lib/radcert/formats/result/certificate_json",
                "lib/radcert/formats/result/level_record", "lib/radcert/formats/table/factors_csv", "lib/radcert/geometry/mesh_file",
                "lib/radcert/expression", "lib/radcert/scalar/decimal", "lib/radcert/scalar/rational", "lib/radcert/scalar/ball_text",
                "lib/radcert/core/text", "lib/radcert/core/errors", "verification/framework/reading", "verification/framework/cell"]
SANITIZERS = "fuzzer-no-link,address,undefined"


def clang():
    for name in ("clang++", "clang++-16", "clang++-15", "clang++-14"):
        if shutil.which(name):
            return name
    return None


def compiled(build, scratch, jobs):
    """The objects that clang makes of the readers, and the program."""
    commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    tasks = []
    for entry in commands:
        source = os.path.relpath(entry["file"], ROOT)
        own = source in ("tests/fuzz/readers.cpp",)
        if not own and not any(source.startswith(part) for part in INSTRUMENTED):
            continue
        words = [word for word in shlex.split(entry["command"]) if not word.endswith("ccache")]
        words[0] = clang()
        words[words.index("-o") + 1] = str(scratch / (source.replace("/", "_") + ".o"))
        # GCC's words; and clang's own warnings are no matter here.
        words = [word for word in words if word not in ("-Werror", "-Wno-restrict", "-O3")]
        tasks.append(words + ["-w", "-O1", "-g1", f"-fsanitize={SANITIZERS}", "-fno-sanitize-recover=undefined"])
        if own:
            entry_point = list(tasks[-1])
            entry_point[entry_point.index(entry["file"])] = str(HERE / "fuzz_reader.cpp")
            entry_point[entry_point.index("-o") + 1] = str(scratch / "fuzz_reader.o")
            tasks.append(entry_point)

    def run(words):
        done = subprocess.run(words, cwd=build, capture_output=True, text=True, check=False)
        if done.returncode and "tests_fuzz" in words[words.index("-o") + 1]:
            raise SystemExit(f"{' '.join(words)}\n{done.stderr[:3000]}")
        if done.returncode:
            print(f"left to the build's compiler: {words[words.index('-c') + 1]}", flush=True)
            return None
        return words[words.index("-o") + 1]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return [name for name in pool.map(run, tasks) if name]


def linked(build, scratch, objects):
    lines = subprocess.run(["ninja", "-C", str(build), "-t", "commands", "test_fuzz"], capture_output=True, text=True,
                           check=True).stdout.splitlines()
    command = next(line for line in reversed(lines) if "-o bin/test_fuzz " in line)
    words = shlex.split(re.sub(r"^: && ", "", command).split(" && ")[0])
    libraries = [word for word in words if word.endswith((".a", ".so")) or word.startswith("-l")]
    libraries = [word for word in libraries if "gtest" not in word and "gmock" not in word]
    program = scratch / "fuzz_readers"
    done = subprocess.run([clang(), "-fsanitize=fuzzer,address,undefined", "-o", str(program), *objects, *libraries],
                          cwd=build, capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(done.stderr[:3000])
    return program


def fuzz(program, reader, arguments, scratch):
    """Inputs, coverage, and the files of what was found."""
    corpus = pathlib.Path(arguments.keep).resolve() / reader if arguments.keep else scratch / "corpus" / reader
    corpus.mkdir(parents=True, exist_ok=True)
    findings = pathlib.Path(arguments.findings).resolve() / reader
    findings.mkdir(parents=True, exist_ok=True)
    words = [str(program), str(corpus), str(HERE / "seeds" / reader), f"-artifact_prefix={findings}/", "-timeout=10",
             "-rss_limit_mb=2048", "-print_final_stats=1", "-max_len=16384", f"-dict={HERE / 'dictionaries' / (reader + '.dict')}"]
    words += [f"-runs={arguments.runs}"] if arguments.runs else []
    words += [f"-max_total_time={arguments.seconds}"] if arguments.seconds else []
    environment = {**os.environ, "RADCERT_FUZZ_READER": reader,
                   "ASAN_OPTIONS": "detect_leaks=0:allocator_may_return_null=1"}
    done = subprocess.run(words, env=environment, capture_output=True, text=True, errors="replace", check=False)
    inputs = re.findall(r"number_of_executed_units: (\d+)", done.stderr)
    coverage = re.findall(r"cov: (\d+)", done.stderr)
    if done.returncode and not list(findings.iterdir()):
        raise SystemExit(f"{reader}: {done.stderr[-3000:]}")
    (scratch / f"{reader}.log").write_text(done.stderr, encoding="utf-8")
    if done.returncode:
        print(done.stderr[-2500:], flush=True)
    return int(inputs[-1]) if inputs else 0, int(coverage[-1]) if coverage else 0, sorted(findings.iterdir())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--reader", action="append", help="one of them; all without it")
    parser.add_argument("--runs", type=int, default=0)
    parser.add_argument("--seconds", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=2, help="compilers at a time")
    parser.add_argument("--keep", help="a folder with the inputs that were found to reach something new")
    parser.add_argument("--findings", default="fuzz-findings")
    parser.add_argument("--program", type=pathlib.Path, help="use this one, which an earlier call left with --leave")
    parser.add_argument("--leave", type=pathlib.Path, help="leave the program here")
    arguments = parser.parse_args()
    if clang() is None:
        print("clang++ is missing: apt-get install clang", file=sys.stderr)
        return 3
    if not arguments.runs and not arguments.seconds:
        arguments.seconds = 10
    scratch = pathlib.Path(tempfile.mkdtemp(prefix="radcert-fuzz-"))
    try:
        program = arguments.program
        if program is None:
            program = linked(arguments.build.resolve(), scratch, compiled(arguments.build.resolve(), scratch, arguments.jobs))
            if arguments.leave:
                shutil.copy(program, arguments.leave)
        found = 0
        for reader in arguments.reader or sorted(path.name for path in (HERE / "seeds").iterdir()):
            inputs, coverage, files = fuzz(program, reader, arguments, scratch)
            found += len(files)
            print(f"{reader:14} {inputs:10} inputs  coverage {coverage:5}  findings {len(files)}", flush=True)
        return 1 if found else 0
    finally:
        shutil.rmtree(scratch)


if __name__ == "__main__":
    sys.exit(main())
