#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives the program inputs that ask for too much, and says which it neither ends soon nor stops at a signal.

    python3 tests/robust/bombs.py build/release/bin/radcert                 some six hundred commands, a quarter of an hour
    python3 tests/robust/bombs.py build/release/bin/radcert --only "nodes"  those whose name contains the word

Each command has two seconds of a processor. One that is at work then must have said something on stderr, and end within
a second and a fifth of a SIGINT; run as root, the script lets it do so before all other work of a busy machine. A
signal that ends it, and exit code 3, are no answers to an input. Prints a line a command that did otherwise, and the
counts; exit code 0 where there is none, else 1.
"""
import argparse
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SECONDS = 2.0
SECONDS_TO_STOP = 1.2
CUBE = {
    "schema": "radcert/problem/1",
    "surface": {"name": "cube"},
    "triangulation": {"levels": [0]},
    "basis": {"family": "inset", "degree": 1, "alpha": "1/6"},
    "reflectivity": "1/2",
    "solution": "x",
}
EMISSION = {"solution": None, "emission": "1"}
FORMULAS = ["1/(x-0.3)", "1/x", "x*1e300", "x*1e-400", "1/(x-0.3)^20", "log(x)", "sqrt(x-1/2)", "exp(exp(exp(9*x)))", "x^999999",
            "(x+y+z)^999999", "sin(1e300*x)", "1e-400*x", "abs(x-0.3)", "1/(x-0.30000000000000001)", "(((x^99)^99)^99)",
            "x^(1/3)", "+".join(f"sin(x*{k})" for k in range(250))]
NUMBERS = ["1e-400", "1e400", "1e-99999", "0." + "3" * 990, "1/" + "3" * 990, "1e-30"]
SOLVERS = ["neumann", "gmres", "auto", "direct", "verified"]
TOWER = "((((((1e400)^12)^12)^12)^12)^12)"


class Folder:
    """Writes inputs, and gives their names."""

    def __init__(self, path):
        self.path = path
        self.count = 0

    def put(self, content, ending="json"):
        self.count += 1
        name = f"{self.count}.{ending}"
        text = content if isinstance(content, str) else json.dumps(content)
        (self.path / name).write_text(text, encoding="utf-8")
        return name

    def problem(self, **changes):
        return self.put({key: value for key, value in {**CUBE, **changes}.items() if value is not None})


def random_nodes(chance, degree, digits):
    nodes = []
    for _ in range((degree + 1) * (degree + 2) // 2):
        a, b = (chance.randrange(1, 10**digits // 3) for _ in range(2))
        nodes.append([f"0.{x:0{digits}d}" for x in (a, b, 10**digits - a - b)])
    return {"schema": "radcert/nodes/1", "degree": degree, "nodes": nodes}


def formulas(folder):
    for number, formula in enumerate(FORMULAS):
        ellipsoid = {"name": "ellipsoid", "a": 1, "b": "1.3", "c": "1.7"}
        yield f"formula {number} as u", ["solve", folder.problem(solution=formula)]
        yield f"formula {number} as E", ["solve", folder.problem(solution=None, emission=formula)]
        yield f"formula {number} as rho", ["solve", folder.problem(**EMISSION, reflectivity=formula)]
        yield f"formula {number}, verified", ["solve", folder.problem(solution=formula, solver={"name": "verified"})]
        yield f"formula {number}, guarantee", ["solve", folder.problem(solution=None, emission=formula), "--guarantee", "1e-3"]
        yield (f"formula {number} as rho, guarantee",
               ["solve", folder.problem(surface=ellipsoid, **EMISSION, reflectivity=formula), "--guarantee", "1e-3"])


def problems(folder):
    for grading in (5, 10, 50, "1e6", 1000000000):
        for level in (0, 3, 8, 30):
            yield (f"grading {grading}, level {level}",
                   ["solve", folder.problem(triangulation={"levels": [level], "grading": grading})])
    for rho in ("0.999999999999", "0.99", "1"):
        for solver in SOLVERS:
            yield f"{solver}, rho {rho}", ["solve", folder.problem(reflectivity=rho, solver={"name": solver})]
    thin = [{"name": "box", "a": a, "b": 1, "c": 1} for a in (1e6, 1e9, "1e-6", "1e-12", "1e-30", 100)]
    thin += [{"name": "ellipsoid", "a": a, "b": 1, "c": c}
             for a, c in ((100, 1), (1000, 1), (10, 1), ("1e9", 1), (1, 100))]
    kinds = {"u": {}, "E": EMISSION, "verified": {"solver": {"name": "verified"}}, "h2": {**EMISSION, "operator": {"name": "h2"}},
             "interpolated": {"geometry": {"interpolated": 2}}}
    for surface in thin:
        of = f"{surface['name']} {surface['a']} {surface['c']}"
        for kind, changes in kinds.items():
            for level in (0, 3):
                yield f"{of}, {kind}, level {level}", ["solve", folder.problem(surface=surface, triangulation={"levels": [level]}, **changes)]
        for quantity, width in (("means", "1e-3"), ("function", "1e-12"), ("values", "1e-6")):
            yield f"{of}, guarantee of {quantity}", ["solve", folder.problem(surface=surface, **EMISSION), "--guarantee", width, "--of", quantity]
    for surface in ("sphere", "two_piece", "ellipsoid", "cone", "cylinder", "paraboloid_cap", "spherical_cap", "torus"):
        for level in (0, 1, 3):
            yield (f"verified {surface}, level {level}",
                   ["solve", folder.problem(surface={"name": surface}, triangulation={"levels": [level]}, solver={"name": "verified"})])
    for surface in ("cube", "sphere"):
        yield f"h2 {surface}", ["solve", folder.problem(surface={"name": surface}, **EMISSION, operator={"name": "h2"},
                                                        triangulation={"levels": [7]})]
    for quantity in ("means", "values", "function"):
        yield f"guarantee of {quantity}", ["solve", folder.problem(**EMISSION), "--guarantee", "1e-9", "--of", quantity]
    yield "all levels", ["solve", folder.problem(triangulation={"levels": list(range(31))})]
    base = {key: CUBE[key] for key in ("surface", "triangulation", "solution")}
    yield "a million combinations", ["experiment", folder.put({
        "schema": "radcert/experiment/1", "name": "many", "base": base,
        "vary": {"reflectivity": [f"1/{k + 2}" for k in range(999)], "basis": [{"family": "inset", "degree": 1, "alpha": f"1/{k + 4}"}
                                                                               for k in range(999)]}})]


def scales(folder):
    faces = "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n"
    for scale in (-320, -300, -200, -100, -60, 60, 100, 200, 300):
        corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        mesh = folder.put("".join("v " + " ".join(f"{c}e{scale}" if c else "0" for c in corner) + "\n" for corner in corners) + faces, "obj")
        yield f"scale {scale}, surface", ["surface", mesh]
        for options in ([], ["--certified"], ["--rays", "--by", "group"]):
            yield f"scale {scale}, factors {options}", ["factors", mesh, *options]
        yield f"scale {scale}, solve", ["solve", folder.problem(surface={"file": mesh}, **EMISSION)]
        yield f"scale {scale}, guarantee", ["solve", folder.problem(surface={"file": mesh}, **EMISSION), "--guarantee", "1e-2"]


def sizes(folder):
    keys = {f"k{k}": k for k in range(100000)}
    yield "keys of a problem", ["solve", folder.put({"schema": "radcert/problem/1", **keys})]
    yield "keys of pieces", ["solve", folder.problem(reflectivity=keys)]
    yield "keys of an experiment", ["experiment", folder.put({"schema": "radcert/experiment/1", "name": "a", "base": {}, "vary": keys})]
    yield "keys of nodes", ["basis", folder.put({"schema": "radcert/nodes/1", **keys})]
    yield "a key again and again", ["solve", folder.put("{" + ",".join('"a":1' for _ in range(100000)) + "}")]
    yield "deep brackets", ["solve", folder.put("[" * 10000000)]
    yield "a long text", ["solve", folder.put('{"schema":"' + "x" * 60000000 + '"}')]
    long_list = folder.put("[" + "1," * 30000000 + "1]")
    for command in ("solve", "check", "basis", "experiment"):
        yield f"a long list, {command}", [command, long_list]
    groups = folder.put("".join(f"v {k} 0 0\nv {k} 1 0\nv {k} 0 1\ng g{k}\nf {3 * k + 1} {3 * k + 2} {3 * k + 3}\n" for k in range(100000)), "obj")
    fan = folder.put("".join(f"v {k} {k * k} 0\n" for k in range(100000)) + "f " + " ".join(str(k + 1) for k in range(100000)) + "\n", "obj")
    star = folder.put("v 0 0 0\n" + "".join(f"v {k} {k * k} 1\n" for k in range(1, 20001)) +
                      "".join(f"f 1 {k} {k + 1}\n" for k in range(2, 20000)), "obj")
    edge = folder.put("v 0 0 0\nv 0 0 1\n" + "".join(f"v {k + 1} {(k + 1) ** 2} 0\n" for k in range(3000)) +
                      "".join(f"f 1 2 {k + 3}\n" for k in range(3000)), "obj")
    chance = random.Random(1)
    soup = folder.put("".join(f"v {chance.random()} {chance.random()} {chance.random()}\n" for _ in range(6000)) +
                      "".join(f"f {3 * k + 1} {3 * k + 2} {3 * k + 3}\n" for k in range(2000)), "obj")
    everything = "triangulate,vertices,faces,orientation,manifold,crossings,holes"
    for name, mesh in (("groups", groups), ("a polygon", fan), ("a star", star), ("an edge", edge), ("a soup", soup)):
        yield f"{name}, surface", ["surface", mesh]
        yield f"{name}, mended", ["surface", mesh, "--repair", everything]
        yield f"{name}, factors", ["factors", mesh, "--by", "group"]
        yield f"{name}, rays", ["factors", mesh, "--by", "group", "--rays"]
        yield f"{name}, solve", ["solve", folder.problem(surface={"file": mesh}, **EMISSION)]
    for options in (["--level", "8"], ["--level", "8", "--certified"], ["--level", "6", "--rays", "--by", "piece", "--accuracy", "1e-6"]):
        yield f"factors {options}", ["factors", "cube", *options]
    yield "a large picture", ["picture", "figure_8", "--size", "4096x4096", "--samples", "8", "--out", "p.png"]


def numbers(folder):
    for text in NUMBERS:
        short = text[:20]
        for degree in ("2", "8"):
            yield f"alpha {short}, degree {degree}", ["basis", "inset", "--degree", degree, "--alpha", text]
        yield f"alpha {short}, solve", ["solve", folder.problem(basis={"family": "inset", "degree": 2, "alpha": text})]
        yield f"p {short}", ["solve", folder.problem(surface={"name": "two_piece", "p": text})]
        yield f"a {short}", ["solve", folder.problem(surface={"name": "box", "a": text, "b": 1, "c": 1})]
        yield f"accuracy {short}", ["factors", "cube", "--accuracy", text]
        yield f"width {short}", ["solve", folder.problem(**EMISSION), "--guarantee", text]
        yield f"at {short}", ["solve", folder.problem(**EMISSION), "--guarantee", "1e-3", "--at", f"{text},{text},0"]
        yield f"part {short}", ["check", folder.problem(), "--part", text]
        yield f"half_turns {short}", ["reference", "inclined_rectangles", "--set", f"half_turns={text}"]
        yield f"distance {short}", ["reference", "coaxial_disks", "--set", f"distance={text}"]
    chance = random.Random(2)
    for degree in (1, 4, 8, 12):
        for digits in (10, 100, 900):
            nodes = folder.put(random_nodes(chance, degree, digits))
            yield f"nodes of degree {degree}, {digits} digits", ["basis", nodes]
            for solver in ("auto", "verified"):
                yield (f"nodes of degree {degree}, {digits} digits, {solver}",
                       ["solve", folder.problem(basis={"file": nodes}, solver={"name": solver})])
    for space in (f"x1*{TOWER}/{TOWER}", "x1*(1e400)^999999", "(x1+x2*1e-300)^99"):
        yield f"nodes of a space with {space[:20]}", ["basis", folder.put({
            "schema": "radcert/nodes/1", "space": [space, "x2", "x3"], "nodes": [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]})]


def names(folder):
    long = "n" * 300
    problem = folder.problem()
    for words in (["solve", long], ["solve", "/tmp/" + "y" * 5000], ["factors", long + ".obj"], ["surface", long + ".obj"], ["check", long],
                  ["basis", long], ["verify", long], ["experiment", long], ["solve", problem, "--json", long],
                  ["solve", problem, "--out", long], ["solve", problem, "--out", "/".join(["d" * 200] * 30)],
                  ["solve", problem, "--nodes", "y" * 5000], ["factors", "cube", "--out", long],
                  ["picture", "figure_3", "--out", long + ".png"], ["reference", "--all", "--out", long]):
        yield f"long name {words[0]} {words[-2][:10]}", words


def references(program):
    done = subprocess.run([program, "list", "references"], capture_output=True, text=True, check=True)
    for line in done.stdout.splitlines():
        yield f"digits of {line.split()[0]}", ["reference", line.split()[0], "--digits", "1000"]
    yield "all digits", ["reference", "--all", "--digits", "1000", "--out", "all"]
    yield "the sphere over the disk", ["reference", "sphere_over_disk", "--at", "B:0.3", "--digits", "24"]
    yield "curves", ["reference", "sphere_over_disk", "--curve", "c.csv", "--points", "100000"]


def processor_seconds(process):
    """What its threads have taken; all there is where it has ended."""
    try:
        fields = pathlib.Path(f"/proc/{process}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    except OSError:
        return SECONDS
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def verdict(program, words, folder):
    """What is wrong with how a command ends, if anything, and whether it met the signal."""
    with open(folder / "stderr", "wb") as errors:
        running = subprocess.Popen([program, *words], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=errors,
                                   env={**os.environ, "RADCERT_STORE": str(folder / "store")})
        met = False
        try:
            while running.poll() is None and processor_seconds(running.pid) < SECONDS:
                time.sleep(0.05)
            running.wait(0)
        except subprocess.TimeoutExpired:
            met = True
            silent = (folder / "stderr").stat().st_size == 0
            if os.geteuid() == 0:
                os.setpriority(os.PRIO_PROCESS, running.pid, -10)
            running.send_signal(signal.SIGINT)
            begin = time.monotonic()
            running.wait(60)
            if silent:
                return "is at work and says nothing", met
            if time.monotonic() - begin > SECONDS_TO_STOP:
                return f"stops {time.monotonic() - begin:.1f} s after the signal", met
        finally:
            running.kill()
    if running.returncode not in (0, 1, 2, 130):
        return f"ends with {running.returncode}: {(folder / 'stderr').read_text(errors='replace').strip()[-300:]}", met
    return None, met


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    program = str(arguments.program.resolve())
    path = pathlib.Path(tempfile.mkdtemp(prefix="radcert-bombs-"))
    tried, met, wrong = 0, 0, 0
    try:
        folder = Folder(path)
        for part in (formulas(folder), problems(folder), scales(folder), sizes(folder), numbers(folder), names(folder), references(program)):
            for name, words in part:
                if arguments.only not in name:
                    continue
                fault, stopped = verdict(program, words, path)
                tried, met, wrong = tried + 1, met + stopped, wrong + bool(fault)
                if fault:
                    print(f"{name}: {fault}", flush=True)
    finally:
        shutil.rmtree(path)
    print(f"{tried} commands, {met} met the signal, {wrong} did otherwise")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
