# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs problems of every kind and keeps what they print, without seconds.

A change that moves, unifies or deletes code must not move a number:

    python3 tests/structure/every_number.py build/release/bin/radcert before
    ... the change ...
    python3 tests/structure/every_number.py build/release/bin/radcert after
    diff -r before after

With --verify the claims of all papers at quick run too, some minutes more.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "apps" / "examples"

# What differs from run to run, or says which radcert ran.
TRANSIENT = {"timing", "seconds", "radcert", "provenance", "command", "date", "planned_bytes", "circumstances"}


def problem(surface, basis, levels, solver="direct", **more):
    return {"schema": "radcert/problem/1", "surface": surface, "triangulation": {"levels": levels},
            "basis": basis, "solver": {"name": solver}, **more}


def inset(degree, alpha="1/6"):
    return {"family": "inset", "degree": degree, "alpha": alpha}


SMOOTH = "exp(x/2 + y/3 - z/4)"
PROBLEMS = {
    "two_squares": problem({"name": "two_squares"}, inset(0), [0, 1, 2], reflectivity="1/2", solution="1 + x*y"),
    "two_piece": problem({"name": "two_piece", "p": 2}, inset(1), [0, 1, 2], reflectivity="1",
                         solution="1/sqrt(x^2 + y^2 + (z-1/2)^2)"),
    "cube_gmres": problem({"name": "cube"}, inset(2, "1/10"), [0, 1], "gmres", reflectivity="9/10", solution=SMOOTH),
    "cube_neumann": problem({"name": "cube"}, inset(1), [0, 1], "neumann", reflectivity="1/2", solution=SMOOTH),
    "cube_verified": problem({"name": "cube"}, inset(1), [0, 1], "verified", reflectivity="1/2", solution=SMOOTH),
    "cube_emission": problem({"name": "cube"}, inset(1), [0, 1], "verified", reflectivity="3/4", emission="1 + z"),
    "cube_peak": problem({"name": "cube"}, inset(1), [0], reflectivity="1/2",
                         solution="1 + exp(-1e4*((x-3/10)^2 + (y-2/5)^2 + z^2))"),
    "box_by_piece": problem({"name": "box", "a": 1, "b": 2, "c": 3}, {"family": "symmetric", "degree": 2}, [0, 1],
                            reflectivity="1/3", emission="1"),
    "sphere": problem({"name": "sphere"}, inset(2), [0, 1], reflectivity="1/2", solution=SMOOTH),
    "sphere_verified": problem({"name": "sphere"}, inset(1), [0], "verified", reflectivity="1/2", emission="1 + z"),
    "ellipsoid": problem({"name": "ellipsoid", "a": 1, "b": "3/4", "c": "1/2"}, inset(1, "superconvergent"), [0, 1],
                         reflectivity="1/2", solution=SMOOTH),
    "interpolated": problem({"name": "ellipsoid", "a": 1, "b": "3/4", "c": "1/2"}, inset(2), [0, 1],
                            reflectivity="1/2", solution=SMOOTH, geometry={"interpolated": 2}),
    "cylinder": problem({"name": "cylinder"}, inset(1), [0, 1], reflectivity="1/2", solution=SMOOTH),
    "cone": problem({"name": "cone"}, inset(0), [0, 1], reflectivity="1/2", solution=SMOOTH),
    "paraboloid": problem({"name": "paraboloid_cap"}, inset(3), [0], reflectivity="1/2", solution=SMOOTH),
    "spherical_cap": problem({"name": "spherical_cap"}, inset(1), [0, 1], reflectivity="1/2", solution=SMOOTH),
    "graded_cube": dict(problem({"name": "cube"}, inset(1), [1], reflectivity="1/2", solution=SMOOTH),
                        triangulation={"levels": [1], "grading": 2}),
    "file_basis": problem({"name": "tetrahedron"}, {"file": str(EXAMPLES / "nodes" / "symmetric_3.json")}, [0, 1],
                          reflectivity="1/2", solution=SMOOTH),
    "shepard": problem({"name": "sphere"}, {"family": "shepard", "sites": {"poisson_disk": "1/2", "seed": 1}}, [0, 1],
                       reflectivity="1/2", solution=SMOOTH),
}
EXAMPLE_PROBLEMS = ["01_solve/2_lamp_in_a_box.json", "01_solve/4_own_diagonals.json", "03_own_surface/problem.json",
                    "04_own_basis/problem.json", "05_own_claim/room_proved.json", "06_meshless/problem.json",
                    "07_occluded_room/problem.json"]
EXPERIMENTS = ["grading_on_the_cube", "meshless_against_collocation"]
COMMANDS = {
    "factors_cube": ["factors", "cube", "--level", "1"],
    "factors_cube_certified": ["factors", "cube", "--certified"],
    "factors_room": ["factors", str(EXAMPLES / "07_occluded_room" / "room.obj"), "--by", "piece"],
    "factors_attic": ["factors", str(EXAMPLES / "08_factors_of_an_stl" / "attic.stl"), "--by", "group"],
    "surface_house": ["surface", str(EXAMPLES / "03_own_surface" / "house.obj")],
    "surface_room": ["surface", str(EXAMPLES / "07_occluded_room" / "room.obj")],
    "surface_attic": ["surface", str(EXAMPLES / "08_factors_of_an_stl" / "attic.stl")],
    "surface_torus": ["surface", "torus"],
    "basis_inset": ["basis", "inset", "--degree", "2", "--alpha", "1/10"],
    "basis_superconvergent": ["basis", "inset", "--degree", "1", "--alpha", "superconvergent"],
    "basis_symmetric": ["basis", "symmetric", "--degree", "3"],
    "basis_file": ["basis", str(EXAMPLES / "04_own_basis" / "nodes.json")],
    "reference_cube": ["reference", "cube_opposite_faces", "--digits", "40"],
    "reference_sphere_over_disk": ["reference", "sphere_over_disk", "--at", "B:0.25", "--at", "D:10"],
    "list_surfaces": ["list", "surfaces"],
    "list_bases": ["list", "bases"],
    "list_claims": ["list", "claims"],
    "list_references": ["list", "references"],
}
SCHEMAS = ["problem", "solution", "experiment", "experiment_result", "verification", "provenance", "reference",
           "references", "manifest", "surface", "factors", "nodes", "basis", "picture", "list"]


def lasting(value):
    if isinstance(value, dict):
        return {key: lasting(part) for key, part in value.items() if key not in TRANSIENT}
    if isinstance(value, list):
        return [lasting(part) for part in value]
    return value


def keep(out, name, program, arguments, store, folder):
    """One command: its JSON without what is transient, its exit code, and digests of other files that it wrote."""
    result = folder / "result.json"
    environment = dict(os.environ, RADCERT_STORE=str(store))
    ran = subprocess.run([program, *arguments, "--quiet", "--json", str(result)], capture_output=True, text=True,
                         env=environment, cwd=folder)
    lines = [f"exit code {ran.returncode}"]
    if result.exists():
        lines.append(json.dumps(lasting(json.loads(result.read_text())), indent=1, ensure_ascii=False))
    else:
        lines += [ran.stdout, ran.stderr]
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.suffix in {".csv", ".vtu", ".ply", ".png", ".off"} and "timing" not in path.name:
            lines.append(f"{path.relative_to(folder)} {hashlib.sha256(path.read_bytes()).hexdigest()}")
    (out / f"{name}.txt").write_text("\n".join(lines).replace(str(ROOT), "").replace(str(folder.parent), "") + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--verify", action="store_true", help="run the claims of all papers too")
    arguments = parser.parse_args()
    program = str(arguments.program.resolve())
    out = arguments.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        work = dict(COMMANDS)
        work.update({f"schema_{name}": ["schema", name] for name in SCHEMAS})
        for name, content in PROBLEMS.items():
            path = scratch / f"{name}.json"
            path.write_text(json.dumps(content))
            work[f"solve_{name}"] = ["solve", str(path), "--nodes", "nodes.csv", "--vtu", "field.vtu"]
        for name in EXAMPLE_PROBLEMS:
            work["solve_" + re.sub(r"\W", "_", name[:-5])] = ["solve", str(EXAMPLES / name), "--ply", "field.ply"]
        for name in EXPERIMENTS:
            work[f"experiment_{name}"] = ["experiment", str(EXAMPLES / "experiments" / f"{name}.json"), "--out", "."]
        for name in ["figure_3", "figure_6", "figure_9"]:
            work[f"picture_{name}"] = ["picture", name, "--size", "160x120", "--out", "figure.png"]
        if arguments.verify:
            for paper in ["ac98", "m06", "psg10", "radcert"]:
                work[f"verify_{paper}"] = ["verify", paper]
        # The longest first.
        order = sorted(work, key=lambda name: not name.startswith(("verify", "experiment", "solve")))
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            done = []
            for name in order:
                folder = scratch / ("run_" + name)
                folder.mkdir()
                done.append(pool.submit(keep, out, name, program, work[name], scratch / "store" / name, folder))
            for each in done:
                each.result()
    print(f"{len(work)} commands kept in {arguments.out}")


if __name__ == "__main__":
    main()
