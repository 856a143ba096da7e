# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces and meshes: what is said of them, what is refused, and that meshes can be solved on."""
import json
import math
import os
import shutil
import struct
import unittest
from fractions import Fraction

import jsonschema

from program import EXAMPLES, ProgramTest, small

# Faces run counterclockwise as seen from outside.
TETRAHEDRON = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
CUBE = ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
        [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])


def octahedron(top=1):
    return ([(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, top), (0, 0, -1)],
            [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (1, 0, 5), (2, 1, 5), (3, 2, 5), (0, 3, 5)])


def column(base, height=1):
    n = len(base)
    vertices = [(x, y, z) for z in (0, height) for x, y in base]
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    return vertices, sides + [tuple(reversed(range(n))), tuple(range(n, 2 * n))]


L_SHAPED_ROOM = column([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)])
CYLINDER = column([(math.cos(2 * math.pi * i / 40), math.sin(2 * math.pi * i / 40)) for i in range(40)])


def sphere(level):
    vertices, faces = octahedron()
    for _ in range(level):
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(vertices)
                point = [p + q for p, q in zip(vertices[a], vertices[b])]
                size = math.sqrt(sum(x * x for x in point))
                vertices.append(tuple(x / size for x in point))
            return middles[key]

        finer = []
        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = finer
    return vertices, faces


def klein_bottle(n=7, m=6):
    vertices = []
    for i in range(n):
        for j in range(m):
            u, v = 2 * math.pi * i / n, 2 * math.pi * j / m
            vertices.append(((2 + math.cos(v)) * math.cos(u), (2 + math.cos(v)) * math.sin(u), math.sin(v)))

    def at(i, j):
        row = j % m
        return (i % n) * m + ((m - row) % m if i == n else row)

    faces = []
    for i in range(n):
        for j in range(m):
            faces += [(at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1))]
    return vertices, faces


def off(solid):
    vertices, faces = solid
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(repr(float(x)) for x in v) for v in vertices]
    lines += [" ".join(str(x) for x in (len(f), *f)) for f in faces]
    return "\n".join(lines) + "\n"


def binary_stl(solid):
    vertices, faces = solid
    triangles = [(f[0], f[i], f[i + 1]) for f in faces for i in range(1, len(f) - 1)]
    out = bytes(80) + struct.pack("<I", len(triangles))
    for triangle in triangles:
        out += bytes(12) + b"".join(struct.pack("<3f", *vertices[v]) for v in triangle) + bytes(2)
    return out


def moved(solid, turn):
    return [turn(*v) for v in solid[0]], solid[1]


def scaled(solid, factor, shift):
    return moved(solid, lambda *v: [shift + factor * x for x in v])


def turned(solid):
    return solid[0], [tuple(reversed(f)) for f in solid[1]]


def together(first, second):
    more = [tuple(v + len(first[0]) for v in f) for f in second[1]]
    return list(first[0]) + list(second[0]), list(first[1]) + more


class SurfaceCommand(ProgramTest):
    def report(self, solid, *words):
        name = self.write("mesh.off", off(solid))
        return self.report_of(name, *words)

    def report_of(self, *words):
        json_text = self.expect(0, "surface", *words, "--json", "-")
        report = json.loads(json_text)
        schema = json.loads(self.expect(0, "schema", "surface"))
        jsonschema.Draft202012Validator.check_schema(schema)
        jsonschema.validate(report, schema)
        self.assertTrue(self.expect(0, "surface", *words))
        return report

    def test_solids_fall_into_their_smooth_components(self):
        for solid, components, edges, corners in [(CYLINDER, 3, 2, 0), (CUBE, 6, 12, 8), (L_SHAPED_ROOM, 8, 18, 12),
                                                  (sphere(3), 1, 0, 0), (TETRAHEDRON, 4, 6, 4)]:
            report = self.report(solid)
            self.assertEqual(report["smooth_components"], components)
            self.assertEqual(len(report["pieces"]), components)
            self.assertEqual(report["edges"], edges)
            self.assertEqual(report["corners"]["count"], corners)
            self.assertTrue(report["closed"])
            self.assertEqual(report["euler_characteristic"], 2)
            self.assertEqual(report["orientation"],
                             {"consistent": True, "counterclockwise_from": "outside", "known_by": "volume", "front": "left-hand",
                              "encloses": True, "undecided": None})

    def test_convex_solids_are_certified(self):
        for solid in (CUBE, TETRAHEDRON, octahedron()):
            report = self.report(solid)
            self.assertEqual(report["containment"]["verdict"], "certified")
            self.assertIs(report["unoccluded"], True)
            self.assertIsNone(report["obstacle"])

    def test_others_are_refuted_by_a_witness_that_checks(self):
        for solid in (L_SHAPED_ROOM, octahedron(-0.5)):
            containment = self.report(solid)["containment"]
            self.assertEqual(containment["verdict"], "refuted")
            self.assertFalse(containment["within_precision"])
            witness = containment["witness"]
            p, q, n = ([Fraction(x) for x in witness[key]] for key in ("p", "q", "inner_normal"))
            product = sum((b - a) * c for a, b, c in zip(p, q, n))
            self.assertEqual(product, Fraction(witness["product"]))
            self.assertLess(product, 0)
            self.assertIn(tuple(float(x) for x in q), [tuple(map(float, v)) for v in solid[0]])

    def test_rounding_is_told_from_dents(self):
        turned = moved(CUBE, lambda x, y, z: (0.6 * x - 0.8 * y + 1 / 3, 0.8 * x + 0.6 * y, z + x / 7))
        self.write("turned.stl", binary_stl(turned))
        # The corners of its squares are rounded, too: they are not plane any more, and are cut only where that is asked for.
        self.write("turned.off", off(turned))
        self.assertIn("as rounding to double leaves of a plane face",
                      self.run_program("surface", "turned.off").stderr.decode())
        for words in (["turned.off", "--repair", "triangulate"], ["turned.stl"]):
            name = words[0]
            containment = self.report_of(*words)["containment"]
            self.assertEqual(containment["verdict"], "refuted", name)
            self.assertTrue(containment["within_precision"], name)
        self.assertGreater(containment["relative_depth"], 1e-10)  # of the floats
        text = self.expect(0, "surface", "turned.off", "--repair", "triangulate")
        self.assertIn("below the file's precision", text)

    def test_stl_corners_are_joined(self):
        self.write("cube.stl", binary_stl(CUBE))
        report = self.report_of("cube.stl")
        self.assertEqual(report["vertices"], 8)
        self.assertEqual(report["file"]["joined_corners"], 28)
        self.assertTrue(report["closed"])
        self.assertEqual(report["containment"]["verdict"], "certified")

    def test_an_open_room_names_its_open_edges(self):
        report = self.report((CUBE[0], CUBE[1][:1] + CUBE[1][2:]))
        self.assertFalse(report["closed"])
        self.assertEqual(report["open_edges"]["count"], 4)
        self.assertEqual(report["open_lines"], 1)
        self.assertIn([[0, 0, 1], [1, 0, 1]], report["open_edges"]["first"])
        text = self.expect(0, "surface", "mesh.off")
        self.assertIn("(0, 0, 1) to (1, 0, 1)", text)

    def test_an_open_mesh_is_read_as_its_file_has_it(self):
        open_cube = (CUBE[0], CUBE[1][:1] + CUBE[1][2:])
        self.write("mesh.off", off(open_cube))
        problem = {"schema": "radcert/problem/1", "surface": {"file": "mesh.off"}, "triangulation": {"levels": [0]},
                   "basis": {"family": "inset", "degree": 0}, "reflectivity": "1/2", "emission": "1"}
        self.write("problem.json", problem)
        said = self.run_program("solve", "problem.json")
        self.assertEqual(said.returncode, 2)
        for word in (b"right-hand", b"left-hand", b"/surface/file"):
            self.assertIn(word, said.stderr)
        self.write("problem.json", dict(problem, surface={"file": "mesh.off", "front": "left-hand"}))
        result = json.loads(self.expect(0, "solve", "problem.json", "--json", "-"))
        self.assertEqual(result["problem"]["surface"]["front"], "left-hand")
        self.assertGreater(result["levels"][0]["norm_K"]["value"], 0.1)
        self.write("problem.json", dict(problem, surface={"file": "mesh.off", "front": "up"}))
        self.assertIn(b"/surface/front", self.run_program("solve", "problem.json").stderr)
        report = self.report_of("mesh.off", "--front", "left-hand")
        self.assertEqual(report["orientation"]["known_by"], "choice")
        self.assertEqual(report["containment"]["verdict"], "certified")

    def test_pieces_have_area_normal_centroid_and_box(self):
        long = moved(CUBE, lambda x, y, z: (4 * x + 1, 3 * y, 2 * z))
        for inwards in (False, True):
            solid = (long[0], [tuple(reversed(face)) if inwards else face for face in long[1]])
            report = self.report(solid)
            floor = next(piece for piece in report["pieces"] if piece["box"] == [[1, 0, 0], [5, 3, 0]])
            self.assertEqual(floor["area"], 12)
            self.assertEqual(floor["normal"], [0, 0, 1])  # into the room, either way
            self.assertEqual(floor["centroid"], [3, 1.5, 0])
            self.assertEqual(sorted(piece["area"] for piece in report["pieces"]), [6, 6, 8, 8, 12, 12])
            self.assertIsNone(report["unit"])
        text = self.expect(0, "surface", "mesh.off", "--unit", "mm")
        self.assertRegex(text, r"piece +triangles +area \(mm\^2\)")
        self.assertRegex(text, r"12 +0 +\(0, 0, 1\) +\(3, 1.5, 0\) +\(1, 0, 0\) to \(5, 3, 0\)")
        self.assertEqual(self.report_of("mesh.off", "--unit", "cm")["unit"], "cm")
        self.expect(2, "surface", "mesh.off", "--unit", "ft")
        ball = self.report_of("mesh.off", "--angle", "180")["pieces"]
        self.assertEqual(len(ball), 1)
        self.assertIsNone(ball[0]["normal"])
        self.assertEqual(self.report_of("cube")["pieces"][0]["area"], 1)
        self.assertIsNone(self.report_of("sphere")["pieces"][0]["area"])
        out = self.expect(0, "factors", "mesh.off", "--unit", "m", "--by", "piece", "--out", "f.csv")
        self.assertIn("area (m^2)", out)
        with open(self.path("f.surfaces.csv"), newline="") as file:
            self.assertEqual({row.rsplit(",", 1)[1] for row in file.read().splitlines()[1:]}, {"m^2"})

    def test_nothing_is_mended_unless_asked(self):
        faces = [tuple(reversed(f)) if i == 3 else f for i, f in enumerate(CUBE[1])]
        broken = (CUBE[0] + [(0, 0, 0), (5, 5, 5)], [tuple(8 if v == 0 and i == 2 else v for v in f)
                                                     for i, f in enumerate(faces)])
        report = self.report(broken)
        defects = report["defects"]
        self.assertEqual(defects["duplicate_vertices"]["count"], 1)
        self.assertEqual(defects["unreferenced_vertices"]["count"], 1)
        self.assertGreater(defects["disagreeing_edges"]["count"], 0)
        self.assertFalse(report["closed"])
        self.assertEqual(report["file"]["mended"], [])
        mended = self.report_of("mesh.off", "--repair", "vertices,orientation", "--write", "mended.off")
        self.assertEqual(len(mended["file"]["mended"]), 3)
        self.assertTrue(mended["closed"])
        self.assertEqual(mended["containment"]["verdict"], "certified")
        again = self.report_of("mended.off")
        self.assertEqual(again["vertices"], 8)
        self.assertIsNone(again["obstacle"])

    def test_surfaces_of_the_catalogue_say_what_is_known(self):
        for entry in json.loads(self.expect(0, "list", "surfaces", "--json", "-"))["entries"]:
            report = self.report_of(entry["name"])
            self.assertEqual(report["kind"], "catalogue")
            self.assertIn(report["containment"]["verdict"], ("certified", "refuted", "undecided"))
            self.assertIsInstance(report["unoccluded"], bool)
            self.assertEqual(sum(piece["charts"] > 0 for piece in report["pieces"]), report["smooth_components"])

    def test_bad_files_are_refused_with_place_value_and_what_is_allowed(self):
        cut = binary_stl(CUBE)[:300]
        for name, content, place, text in [
                ("a.off", off(CUBE).replace("1.0 1.0 1.0", "nan 1.0 1.0"), "line 9", "not finite"),
                ("a.off", off(CUBE).replace("1.0 1.0 1.0", "1e99 1.0 1.0"), "line 9", "too large"),
                ("a.off", off((CUBE[0], [(0, 1, 8)])), "line 11", '"8"'),
                ("a.off", off((CUBE[0], [(0, 1, 1)])), "line 11", "two corners"),
                ("a.off", off((CUBE[0], [])), "", "has no faces"),
                ("a.stl", "a text that is no STL\n", "line 1", "no STL file"),
                ("a.stl", cut, "byte 300", "cut off"),
                ("a.off", off(klein_bottle()), "edge from (", "not orientable"),
                ("a.off", b"", "", "is empty"),
                ("a.off", bytes(range(256)) * 20, "line 1", "OFF"),
                ("a.ply", bytes(range(256)) * 20, "line 1", "PLY"),
                ("a.obj", bytes(range(256)) * 20, "", "no statement of an OBJ file")]:
            self.write(name, content)
            done = self.run_program("surface", name)
            said = done.stderr.decode()
            self.assertEqual(done.returncode, 2, said)
            self.assertEqual(done.stdout, b"")
            self.assertIn(f"{name}: {place}", said)
            self.assertIn(text, said)
            self.assertIn("; allowed: ", said)

    def test_bad_words_are_refused(self):
        self.write("cube.off", off(CUBE))
        for words, text in [(["cibe"], "did you mean cube?"), (["missing.off"], "missing.off"),
                            (["cube.off", "--angle", "190"], "--angle"), (["cube.off", "--repair", "all"], "--repair"),
                            (["cube", "--angle", "10"], "--angle"), (["cube.mesh"], ".off, .obj, .ply, .stl")]:
            done = self.run_program("surface", *words)
            self.assertEqual(done.returncode, 2, words)
            self.assertIn(text, done.stderr.decode())


class SolveOnMeshes(ProgramTest):
    def furnace(self, solid, levels, **surface):
        """The error at the nodes of u = 1, for which E = 1 - rho."""
        self.write("mesh.off", off(solid))
        problem = small(surface={"file": "mesh.off", **surface}, reflectivity="1/2", solution="1",
                        triangulation={"levels": levels})
        self.write("problem.json", problem)
        solution = json.loads(self.expect(0, "solve", "problem.json", "--json", "-"))
        return [level["node_error"]["value"] for level in solution["levels"]], solution

    def test_the_furnace_holds_on_meshes(self):
        for solid, levels in [(CUBE, [0, 1]), (TETRAHEDRON, [0, 1]), (octahedron(), [0, 1]), (sphere(1), [0])]:
            errors, solution = self.furnace(solid, levels)
            for error in errors:
                self.assertLess(error, 1e-12)
            self.assertEqual(solution["levels"][0]["norm_K"], {"value": 0.5, "radius": 0, "guaranteed": True})

    def test_the_furnace_holds_where_parts_hide_each_other(self):
        for solid, levels in [(L_SHAPED_ROOM, [0, 1]), (octahedron(-0.5), [0]),
                              (together(CUBE, turned(scaled(CUBE, 0.5, 0.25))), [0])]:
            errors, solution = self.furnace(solid, levels)
            for error in errors:
                self.assertLess(error, 1e-12)
            self.assertEqual(solution["levels"][0]["norm_K"], {"value": 0.5, "radius": 0, "guaranteed": True})

    def test_the_example_with_hidden_parts_can_be_solved(self):
        folder = os.path.join(EXAMPLES, "07_occluded_room")
        with open(os.path.join(folder, "problem.json"), encoding="utf-8") as file:
            problem = json.load(file)
        problem["triangulation"] = {"levels": [0]}
        shutil.copy(os.path.join(folder, "room.obj"), self.path("room.obj"))
        self.write("problem.json", problem)
        level = json.loads(self.expect(0, "solve", "problem.json", "--json", "-"))["levels"][0]
        norm = level["norm_K"]
        self.assertTrue(norm["guaranteed"])
        # The double 0.8 is not 4/5.
        self.assertLessEqual(abs(Fraction(norm["value"]) - Fraction(4, 5)), Fraction(norm["radius"]))
        self.assertLess(norm["radius"], 6e-17)
        self.assertEqual({name.split("_")[0] for name in level["piece_means"]},
                         {"floor", "ceiling", "wall", "window", "box"})
        self.assertGreater(level["piece_means"]["window"], 1)

    def test_concentric_spheres_as_meshes_approach_the_round_ones(self):
        # Radii 2 and 1, E = 1 on the inner one, rho = 1/2: with the factors 3/4, 1/4 and 1 of the spheres the radiosities
        # are constant, 2/9 on the outer and 10/9 on the inner.
        errors = []
        for level in (1, 2):
            outer, inner = scaled(sphere(level), 2, 0), turned(sphere(level))
            vertices, faces = together(outer, inner)
            lines = ["v {!r} {!r} {!r}".format(*map(float, v)) for v in vertices]
            for name, part in [("outer", faces[:len(outer[1])]), ("inner", faces[len(outer[1]):])]:
                lines += ["g " + name] + ["f " + " ".join(str(v + 1) for v in f) for f in part]
            self.write("spheres.obj", "\n".join(lines) + "\n")
            self.write("problem.json", small(
                surface={"file": "spheres.obj", "angle": 120}, basis={"family": "inset", "degree": 0},
                reflectivity="1/2", solution=None, emission={"inner": "1", "*": "0"}, triangulation={"levels": [0]}))
            means = json.loads(self.expect(0, "solve", "problem.json", "--json", "-"))["levels"][0]["piece_means"]
            errors.append((means["outer"] - 2 / 9, means["inner"] - 10 / 9))
        for coarse, fine in zip(*errors):
            self.assertGreater(fine, 0)
            self.assertLess(fine, coarse / 3)  # chords: of second order
            self.assertLess(fine, 0.01)

    def test_an_interpolant_of_a_room_with_hidden_parts_is_refused(self):
        self.write("mesh.off", off(L_SHAPED_ROOM))
        self.write("problem.json", small(surface={"file": "mesh.off"}, reflectivity="1/2", solution="1",
                                         geometry={"interpolated": 2}, triangulation={"levels": [0]}))
        done = self.run_program("solve", "problem.json")
        self.assertEqual(done.returncode, 2)
        self.assertIn("/geometry/interpolated", done.stderr.decode())

    def test_a_level_refines_each_triangle(self):
        _, solution = self.furnace(octahedron(), [0, 1])
        self.assertEqual([level["elements"] for level in solution["levels"]], [8, 32])

    def test_the_problem_that_was_solved_can_be_read_again_while_the_file_is_the_same(self):
        _, solution = self.furnace(TETRAHEDRON, [0])
        schema = json.loads(self.expect(0, "schema", "problem"))
        jsonschema.validate(solution["problem"], schema)
        self.write("again.json", solution["problem"])
        self.expect(0, "solve", "again.json")
        self.write("mesh.off", off(octahedron()))
        done = self.run_program("solve", "again.json")
        self.assertEqual(done.returncode, 2)
        self.assertIn("/surface/digest", done.stderr.decode())
        self.assertIn("has changed", done.stderr.decode())

    def test_another_mesh_with_an_old_digest_does_not_get_its_numbers(self):
        # Two boxes, 1 and 9 high, with one 64-bit FNV-1a value.
        faces = ("3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n"
                 "3 3 0 4\n3 3 4 7\n# ")
        ends = {1: b"ujzde8gxd6ncf10epf91dhod",
                9: bytes([0, 2, 2, 0, 2, 0, 0, 7, 14, 3, 2, 0, 3, 6, 3, 6, 0, 1, 2, 0, 6, 0, 6, 4])}
        problem = {"schema": "radcert/problem/1", "surface": {"file": "m.off"}, "triangulation": {"levels": [0]},
                   "basis": {"family": "inset", "degree": 0}, "reflectivity": "1/2", "emission": "z"}
        means, digests = {}, set()
        for height, end in ends.items():
            corners = "".join(f"{x} {y} {z}\n" for z in (0, height) for x, y in [(0, 0), (1, 0), (1, 1), (0, 1)])
            self.write("m.off", ("OFF\n8 12 0\n" + corners + faces).encode() + end + b"\n")
            self.write("p.json", problem)
            solution = json.loads(self.expect(0, "solve", "p.json", "--json", "-"))
            means[height] = solution["levels"][0]["piece_means"]
            digests.add(solution["problem"]["surface"]["digest"])
        self.assertEqual(len(digests), 2)
        self.assertNotEqual(means[1], means[9])
        self.write("p.json", dict(problem, surface={"file": "m.off", "digest": "fnv1a-0123456789abcdef-100"}))
        done = self.run_program("solve", "p.json")
        self.assertEqual(done.returncode, 2)
        self.assertIn("/surface/digest", done.stderr.decode())

    def bent_pyramid(self):
        return ([(0, 0, 0), (1, 0, 0), (1, 1, 1), (0, 1, 0), (0.5, 0.5, 3)],
                [(0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)])

    def test_faces_that_are_not_plane_are_refused_by_every_command(self):
        self.write("bent.off", off(self.bent_pyramid()))
        problem = {"schema": "radcert/problem/1", "surface": {"file": "bent.off"}, "triangulation": {"levels": [0]},
                   "basis": {"family": "inset", "degree": 0}, "reflectivity": "1/2", "emission": "1"}
        self.write("problem.json", problem)
        for words in (["surface", "bent.off"], ["solve", "problem.json"], ["factors", "bent.off"]):
            done = self.run_program(*words)
            message = done.stderr.decode()
            self.assertEqual(done.returncode, 2, message)
            for part in ("bent.off", "face 1 (line 8)", "do not lie in one plane", "0.205", "--repair triangulate"):
                self.assertIn(part, message)
        told = "face 1 (line 8), bent up to 0.205"
        self.assertIn(told, self.expect(0, "surface", "bent.off", "--repair", "triangulate"))
        report = json.loads(self.expect(0, "surface", "bent.off", "--repair", "triangulate", "--json", "-"))
        self.assertEqual(report["file"]["bent_faces"], 1)
        self.assertRegex(report["file"]["mended"][0], "cut from vertex [0-3] to [0-3]$")
        self.assertIn(told, self.expect(0, "factors", "bent.off", "--repair", "triangulate"))
        self.write("problem.json", dict(problem, surface={"file": "bent.off", "repair": ["triangulate"]}))
        self.assertIn(told, self.expect(0, "solve", "problem.json"))

    def test_pieces_are_named_by_groups(self):
        vertices, faces = CUBE
        lines = ["v {} {} {}".format(*v) for v in vertices] + ["g floor", "f 1 4 3 2", "g rest"]
        lines += ["f " + " ".join(str(v + 1) for v in f) for f in faces[1:]]
        self.write("room.obj", "\n".join(lines) + "\n")
        problem = small(surface={"file": "room.obj"}, reflectivity={"floor": "0", "*": "1/2"}, solution=None,
                        emission={"floor": "1", "*": "0"}, triangulation={"levels": [0]})
        self.write("problem.json", problem)
        solution = json.loads(self.expect(0, "solve", "problem.json", "--json", "-"))
        self.assertEqual(set(solution["levels"][0]["piece_means"]), {"floor", *(f"rest_{i}" for i in range(1, 6))})

    def test_the_file_lies_beside_the_problem(self):
        self.write("mesh.off", off(CUBE))
        self.write("problem.json", small(surface={"file": "mesh.off"}, reflectivity="1/2", solution="1",
                                         triangulation={"levels": [0]}))
        self.expect(0, "solve", self.path("problem.json"), cwd="/")

    def test_meshes_that_need_more_are_refused_by_name(self):
        for surface, solid, pointer, text in [
                ({}, together(CUBE, scaled(CUBE, 0.5, 0.25)), "/surface/file", "not the inside of the body"),
                ({}, together(CUBE, scaled(CUBE, 1, 0.5)), "/surface/file", "cross or overlap"),
                ({}, (CUBE[0], [tuple(reversed(CUBE[1][0])), *CUBE[1][1:]]), "/surface/file", "against each other"),
                ({"angle": 200}, CUBE, "/surface/angle", "from 0 to 180"),
                ({"repair": ["everything"]}, CUBE, "/surface/repair/0", "vertices, faces"),
                ({"name": "cube"}, CUBE, "/surface/name", "unknown key")]:
            self.write("mesh.off", off(solid))
            self.write("problem.json", small(surface={"file": "mesh.off", **surface}, reflectivity="1/2"))
            done = self.run_program("solve", "problem.json")
            said = done.stderr.decode()
            self.assertEqual(done.returncode, 2, said)
            self.assertIn(pointer, said)
            self.assertIn(text, said)
        self.write("problem.json", small(surface={"file": "missing.off"}, reflectivity="1/2"))
        done = self.run_program("solve", "problem.json")
        self.assertEqual(done.returncode, 2)
        self.assertIn("missing.off", done.stderr.decode())


if __name__ == "__main__":
    unittest.main()
