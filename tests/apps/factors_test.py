# SPDX-License-Identifier: GPL-3.0-or-later
"""Configuration factors: known values, closure, what is refused, what a stopped run keeps."""
import csv
import json
import math
import os
import unittest

import jsonschema

from program import ProgramTest

OPPOSITE = 0.19982489569838738304
ADJACENT = 0.20004377607540315424
OBSTRUCTION = 0.14986867177379053728


def off(quadrangles):
    """Faces of four corners as an OFF file; equal points are one vertex."""
    numbers = {}
    faces = [[numbers.setdefault(corner, len(numbers)) for corner in face] for face in quadrangles]
    lines = ["OFF", f"{len(numbers)} {len(faces)} 0"]
    lines += [" ".join(repr(x) for x in corner) for corner in numbers]
    lines += [" ".join(str(n) for n in [len(face), *face]) for face in faces]
    return "\n".join(lines) + "\n"


def box(low, high, parts=1, inwards=False):
    """The faces of a box, counterclockwise as seen from outside unless inwards."""
    faces = []
    for axis in range(3):
        first, second = (axis + 1) % 3, (axis + 2) % 3
        for upper in (False, True):
            def corner(i, j):
                p = [0.0, 0.0, 0.0]
                p[axis] = float((high if upper else low)[axis])
                p[first] = low[first] + (high[first] - low[first]) * i / parts
                p[second] = low[second] + (high[second] - low[second]) * j / parts
                return tuple(p)
            for i in range(parts):
                for j in range(parts):
                    face = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)]
                    faces.append(face if upper != inwards else face[::-1])
    return faces


# Counterclockwise as seen from where their light is: below and above face each other.
OBSTRUCTED = [[(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)],
              [(0.0, 0.0, 1.0), (0.0, 1.0, 1.0), (1.0, 1.0, 1.0), (1.0, 0.0, 1.0)],
              [(0.0, 0.0, 0.5), (0.0, 0.5, 0.5), (0.5, 0.5, 0.5), (0.5, 0.0, 0.5)]]
UNIT = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)
INNER = (0.25, 0.25, 0.25), (0.75, 0.75, 0.75)


class Factors(ProgramTest):
    def rows(self, name):
        with open(self.path(name), newline="") as file:
            return list(csv.DictReader(file))

    def test_the_cube_by_pieces_is_the_closed_form(self):
        for words in ([], ["--certified"]):
            out = self.expect(0, "factors", "cube", "--by", "piece", "--out", "cube.csv", *words)
            self.assertIn("row sums", out)
            rows = self.rows("cube.csv")
            self.assertEqual(len(rows), 30)
            values = [float(row["factor"]) for row in rows]
            self.assertLess(max(min(abs(v - OPPOSITE), abs(v - ADJACENT)) for v in values), 1e-14)
            self.assertEqual({row["guaranteed"] for row in rows}, {"true" if words else "false"})
            surfaces = self.rows("cube.surfaces.csv")
            self.assertEqual(len(surfaces), 6)
            self.assertTrue(all(abs(float(s["row_sum"]) - 1) < 1e-14 and s["to_space"] == "" for s in surfaces))

    def test_the_report_in_json_satisfies_its_schema(self):
        schema = json.loads(self.expect(0, "schema", "factors"))
        for words in (["cube"], ["two_squares", "--space"]):
            report = json.loads(self.expect(0, "factors", *words, "--json", "-"))
            jsonschema.validate(report, schema)

    def test_an_open_scene_must_be_asked_for(self):
        self.write("open.off", off(OBSTRUCTED))
        done = self.run_program("factors", "open.off")
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"is open: 12 edges", done.stderr)
        self.assertIn(b"(0, 0, 0) to (", done.stderr)
        self.expect(0, "factors", "open.off", "--space", "--certified", "--out", "open.csv")
        total = sum(float(row["factor"]) / 2 for row in self.rows("open.csv")
                    if row["from"][:7] == "piece_1" and row["to"][:7] == "piece_2")
        self.assertAlmostEqual(total, OBSTRUCTION, delta=1e-9)
        done = self.run_program("factors", "cube", "--space")
        self.assertEqual(done.returncode, 2)

    def test_an_aperture_and_its_complement_add_up(self):
        x, y = (0.0, 0.25, 0.625, 1.0), (0.0, 0.375, 0.75, 1.0)
        cells = [[(x[i], y[j], 0.5), (x[i + 1], y[j], 0.5), (x[i + 1], y[j + 1], 0.5), (x[i], y[j + 1], 0.5)]
                 for i in range(3) for j in range(3)]
        total = 0
        for wall in (cells[:4] + cells[5:], cells[4:5]):
            self.write("wall.off", off(OBSTRUCTED[:2] + wall))
            self.expect(0, "factors", "wall.off", "--space", "--by", "piece", "--certified", "--accuracy", "1e-6",
                        "--out", "wall.csv")
            factors = {(row["from"], row["to"]): row for row in self.rows("wall.csv")}
            self.assertEqual(factors["piece_1", "piece_2"]["guaranteed"], "true")
            self.assertLess(float(factors["piece_1", "piece_2"]["radius"]), 1e-5)
            total += float(factors["piece_1", "piece_2"]["factor"])
        self.assertAlmostEqual(total, OPPOSITE, delta=2e-5)

    def test_an_accuracy_that_is_not_reached_is_an_error(self):
        # What two bodies hide together is certified; cells of the adaptive integration are used up at 1e-12.
        plates = [[(0.25, 0.25, z), (0.5, 0.25, z), (0.5, 0.5, z), (0.25, 0.5, z)] for z in (0.5, 0.625)]
        self.write("plates.off", off(OBSTRUCTED[:2] + plates))
        words = ("factors", "plates.off", "--space", "--by", "piece")
        done = self.run_program(*words, "--accuracy", "1e-12")
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"incomplete: the row sums' radius is above the accuracy asked for, 1e-12, in ", done.stderr)
        self.assertIn(b"; with few triangles --certified goes further, with thousands --rays", done.stderr)
        self.expect(0, *words, "--accuracy", "1e-6")
        self.expect(0, *words, "--certified", "--accuracy", "1e-6")

    def test_a_wall_of_a_body_hides_what_is_in_it(self):
        cube = box((0.0, 0.0, 0.0), (4.0, 4.0, 4.0), inwards=True)
        inner = [(2.0, 3.0, 1.0), (3.0, 2.0, 1.0), (2.5, 2.5, 2.0)]
        outer = [(4.0, 8.0, 1.0), (6.0, 6.0, 3.0), (8.0, 4.0, 1.0)]
        for words in ([], ["--certified"]):
            for faces, seen in (([inner, outer], 2), (cube + [inner, outer], None)):
                self.write("body.off", off(faces))
                self.expect(0, "factors", "body.off", "--space", "--front", "left-hand", "--out", "body.csv",
                            *words)
                last = f"piece_{len(faces) - 1}/1", f"piece_{len(faces)}/1"
                found = [row for row in self.rows("body.csv") if {row["from"], row["to"]} == set(last)]
                self.assertEqual(len(found), seen or 0)

    def test_slivers_and_scales_have_a_value_or_a_refusal(self):
        sliver = [(-1.1695644156503835, -0.7950591661281423, 0.0), (-0.9823117908892629, 0.18725262476112056, 0.0),
                  (-0.7950591661281423, 1.1695644156503835, 0.0)]
        other = [(2.0, 1.0, 3.0), (0.0, 2.0, 3.0), (-1.0, -2.0, 4.0)]
        for scale, code in ((1.0, 0), (1e-25, 0), (1e-200, 2), (1e-310, 2)):
            self.write("sliver.off", off([[tuple(scale * x for x in p) for p in face] for face in (sliver, other)]))
            for words in ([], ["--certified"]):
                done = self.run_program("factors", "sliver.off", "--space", *words)
                self.assertEqual(done.returncode, code, (scale, done.stderr))

    def test_bad_scenes_are_named_with_coordinates(self):
        self.write("reversed.off", off(box(*UNIT) + box(*INNER)))
        self.write("crossing.off", off(box(*UNIT) + box((0.5, 0.25, 0.25), (1.5, 0.75, 0.75), inwards=True)))
        face = [(0.25, 0.25, 0.5), (0.75, 0.25, 0.5), (0.75, 0.75, 0.5), (0.25, 0.75, 0.5)]
        self.write("doubled.off", off(box(*UNIT) + [face, face[::-1]]))
        for name in ("reversed.off", "crossing.off", "doubled.off"):
            done = self.run_program("factors", name)
            self.assertEqual(done.returncode, 2, name)
            self.assertRegex(done.stderr.decode(), r"\([-0-9.e]+, [-0-9.e]+, [-0-9.e]+\)", name)

    def test_a_piece_that_sees_nothing_is_warned_of(self):
        # The upper square looks up, as the lower one does.
        self.write("back.off", off([OBSTRUCTED[0], OBSTRUCTED[1][::-1]]))
        done = self.run_program("factors", "back.off", "--space", "--by", "piece")
        self.assertEqual(done.returncode, 0)
        for piece in (b"piece_1", b"piece_2"):
            self.assertIn(piece + b" sees nothing but space: as it should, or its normals are reversed", done.stderr)

    def factors_by_piece(self, name, *words):
        self.expect(0, "factors", name, "--by", "piece", "--out", "out.csv", *words)
        return {(row["from"], row["to"]): float(row["factor"]) for row in self.rows("out.csv")}

    def test_open_scenes_are_read_as_the_file_has_them(self):
        # Ground with its normal up and a box with normals outward, as in ordinary CAD; in a room the same faces
        # exchange the same.
        ground = [(-2.0, -2.0, 0.0), (2.0, -2.0, 0.0), (2.0, 2.0, 0.0), (-2.0, 2.0, 0.0)]
        body = box((-0.5, -0.5, 0.25), (0.5, 0.5, 1.25))
        self.write("site.off", off([ground] + body))
        site = self.factors_by_piece("site.off", "--space")
        self.write("room.off", off([ground] + body + box((-9.0, -9.0, -1.0), (9.0, 9.0, 9.0), inwards=True)))
        room = self.factors_by_piece("room.off", "--space")
        boxes = [f"piece_{k}" for k in range(2, 8)]
        self.assertGreater(sum(site.get(("piece_1", b), 0) for b in boxes), 0.05)
        for a in ["piece_1", *boxes]:
            for b in ["piece_1", *boxes]:
                self.assertAlmostEqual(site.get((a, b), 0), room.get((a, b), 0), delta=1e-4)
                if a in boxes and b in boxes:
                    self.assertNotIn((a, b), site)

    def test_plates_exchange_where_their_fronts_face(self):
        fin = [(2.0, 0.0, 0.0), (2.0, 0.0, 1.0), (2.0, 1.0, 1.0), (2.0, 1.0, 0.0)]
        facing = OBSTRUCTED[:2]
        back_to_back = [face[::-1] for face in facing]
        for faces, option, expected in ((facing, "auto", OPPOSITE), (facing + [fin], "auto", OPPOSITE),
                                        (back_to_back, "auto", 0), (back_to_back + [fin], "right-hand", 0),
                                        (back_to_back, "left-hand", OPPOSITE), (facing + [fin], "left-hand", 0)):
            self.write("plates.off", off(faces))
            factors = self.factors_by_piece("plates.off", "--space", "--front", option)
            self.assertAlmostEqual(factors.get(("piece_1", "piece_2"), 0), expected, delta=1e-12)

    def test_bodies_that_can_be_read_both_ways_are_refused(self):
        self.write("bodies.off", off(box(*UNIT) + box((2.0, 0.0, 0.0), (3.0, 1.0, 1.0))))
        for words in ([], ["--space"]):
            done = self.run_program("factors", "bodies.off", *words)
            self.assertEqual(done.returncode, 2)
            for word in (b"front right-hand", b"front left-hand", b"2 closed bodies"):
                self.assertIn(word, done.stderr)
        outside = self.factors_by_piece("bodies.off", "--space", "--front", "right-hand")
        east = [pair for pair, value in outside.items() if abs(value - OPPOSITE) < 1e-12]
        self.assertEqual(len(east), 2)
        self.assertEqual(len(outside), 2)
        inside = self.factors_by_piece("bodies.off", "--front", "left-hand")
        self.assertEqual(len(inside), 60)
        for words in (["--front", "right-hand"], ["--front", "left-hand", "--space"], ["--front", "up"]):
            self.expect(2, "factors", "bodies.off", *words)
        # The right-hand rule has the light inside, as a closed scene would: two rooms.
        self.write("rooms.off", off(box(*UNIT, inwards=True) +
                                    box((2.0, 0.0, 0.0), (3.0, 1.0, 1.0), inwards=True)))
        self.assertEqual(len(self.factors_by_piece("rooms.off")), 60)
        self.expect(2, "factors", "cube", "--front", "left-hand")

    def test_the_front_of_a_closed_room_need_not_be_given(self):
        for inwards in (False, True):
            self.write("room.off", off(box(*UNIT, inwards=inwards)))
            self.assertEqual(len(self.factors_by_piece("room.off")), 30)
            report = json.loads(self.expect(0, "factors", "room.off", "--json", "-"))
            self.assertEqual(report["front"], "right-hand" if inwards else "left-hand")

    def test_wrong_words_are_refused(self):
        for words in (["cubes"], ["cube", "--by", "side"], ["cube", "--level", "x"], ["cube", "--accuracy", "2"],
                      ["sphere"], ["cube", "--out", "no/folder.csv"], ["cube", "--compare", "missing.csv"]):
            self.expect(2, "factors", *words)

    def test_memory_is_planned_first(self):
        done = self.run_program("factors", "cube", "--level", "2", "--max-memory", "1k")
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"18336 pairs of triangles: about ", done.stderr)

    def test_a_comparison_ranks_the_worst_and_fails_where_a_pair_differs(self):
        self.expect(0, "factors", "cube", "--by", "piece", "--certified", "--out", "exact.csv")
        good = self.write("good.csv", "from,to,factor\r\n" + "".join(
            f"{row['from']},{row['to']},{float(row['factor']):.6f}\r\n" for row in self.rows("exact.csv")))
        out = self.expect(0, "factors", "cube", "--by", "piece", "--compare", good)
        self.assertIn("compared: 30 agree, 0 differ, 0 undecided", out)
        with open(self.path("good.csv")) as file:
            text = file.read()
        self.write("bad.csv", text.replace("0.199825", "0.199925", 1))
        out = self.expect(1, "factors", "cube", "--by", "piece", "--compare", "bad.csv")
        self.assertIn("compared: 29 agree, 1 differ, 0 undecided", out)
        # With the mark that some programs set before a text; radii below 0 are none.
        self.write("marked.csv", "\ufeff" + text)
        self.expect(1, "factors", "cube", "--by", "piece", "--compare", "bad.csv")
        self.expect(0, "factors", "cube", "--by", "piece", "--compare", "marked.csv")
        self.write("below.csv", "from,to,factor,radius\nfloor,ceiling,0.2,-1e-300\n")
        done = self.run_program("factors", "cube", "--by", "piece", "--compare", "below.csv")
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"below.csv: line 2: \"-1e-300\" is a radius below 0", done.stderr)

    def test_a_comparison_takes_a_matrix_and_a_tolerance_and_says_why(self):
        self.expect(0, "factors", "cube", "--by", "piece", "--out", "exact.csv")
        exact = {(row["from"], row["to"]): float(row["factor"]) for row in self.rows("exact.csv")}
        names = [row["name"] for row in self.rows("exact.surfaces.csv")]

        def matrix(change):
            lines = ["," + ",".join(names)]
            lines += [",".join([a, *(f"{change(a, b, exact.get((a, b), 0.0)):.9f}" for b in names)]) for a in names]
            return "\r\n".join(lines) + "\r\n"

        self.write("good.csv", matrix(lambda a, b, x: x))
        compare = ("factors", "cube", "--by", "piece", "--compare")
        self.assertIn("36 agree, 0 differ", self.expect(0, *compare, "good.csv"))
        self.write("bad.csv", matrix(lambda a, b, x: 1.001 * x if (a, b) == (names[0], names[1]) else x))
        self.assertIn("35 agree, 1 differ", self.expect(1, *compare, "bad.csv", "--differences", "d.csv"))
        worst = self.rows("d.csv")[0]
        self.assertEqual((worst["from"], worst["to"], worst["verdict"]), (names[0], names[1], "differs"))
        self.assertAlmostEqual(float(worst["difference"]), 0.001 * OPPOSITE, delta=1e-8)
        self.assertEqual(worst["cause"], "reciprocity broken")
        self.assertEqual(len(self.rows("d.csv")), 36)
        with open(self.path("d.svg")) as file:
            self.assertEqual(file.read().count('class="differs"'), 1)
        for tolerance, code in (("1e-4", 1), ("3e-4", 0), ("0.05%", 1), ("0.2%", 0), ("1e-4,0.2%", 0)):
            self.expect(code, *compare, "bad.csv", "--tolerance", tolerance)
        report = json.loads(self.expect(1, *compare, "bad.csv", "--json", "-"))
        jsonschema.validate(report, json.loads(self.expect(0, "schema", "factors")))
        self.assertEqual(report["comparison"]["worst"][0]["cause"], "reciprocity broken")
        for words in (["--tolerance", "1e-3"], ["--compare", "good.csv", "--tolerance", "x"],
                      ["--compare", "good.csv", "--tolerance", "1e-3,1e-4"], ["--differences", "d.csv"]):
            self.expect(2, "factors", "cube", "--by", "piece", *words)

    def test_an_occlusion_that_was_missed_is_named(self):
        self.write("open.off", off(OBSTRUCTED))
        self.write("unoccluded.csv", f"from,to,factor\npiece_1,piece_2,{OPPOSITE:.9f}\n")
        out = self.expect(1, "factors", "open.off", "--space", "--by", "piece", "--compare", "unoccluded.csv",
                          "--differences", "d.csv")
        self.assertIn("occlusion missed", out)
        causes = {(row["from"], row["to"]): row["cause"] for row in self.rows("d.csv")}
        self.assertEqual(causes["piece_1", "piece_2"], "occlusion missed")

    def test_rays_agree_with_pairs(self):
        self.write("cubes.off", off(box(*UNIT) + box(*INNER, inwards=True)))
        words = ("factors", "cubes.off", "--by", "piece")
        self.expect(0, *words, "--accuracy", "1e-4", "--out", "pairs.csv")
        out = self.expect(0, *words, "--rays", "--accuracy", "5e-3", "--out", "rays.csv")
        self.assertRegex(out, r"[0-9]+ rays\n")
        pairs = {(row["from"], row["to"]): float(row["factor"]) for row in self.rows("pairs.csv")}
        rays = {(row["from"], row["to"]): row for row in self.rows("rays.csv")}
        self.assertTrue(set(pairs) <= set(rays))
        for pair, row in rays.items():
            self.assertLess(abs(float(row["factor"]) - pairs.get(pair, 0)), float(row["radius"]) + 1e-4, pair)
            self.assertLess(float(row["radius"]), 5.1e-3)
            self.assertEqual(row["guaranteed"], "false")
        self.expect(2, *words, "--rays", "--certified")
        self.expect(2, *words, "--rays", "--accuracy", "1e-8")

    def test_plates_alone_need_no_front(self):
        self.obj("plates.obj", {"low": OBSTRUCTED[:1], "high": OBSTRUCTED[1:2]})
        ask = ["factors", "plates.obj", "--space", "--by", "group", "--out", "f.csv"]
        self.expect(0, *ask, "--two-sided", "low,high")
        found = {(row["from"], row["to"]): float(row["factor"]) for row in self.rows("f.csv")}
        self.assertAlmostEqual(found["low", "high"], OPPOSITE, delta=1e-12)
        self.assertNotIn(("low back", "high"), found)
        done = self.run_program("factors", "plates.obj", "--by", "group")
        self.assertIn(b"--two-sided for plates without thickness", done.stderr)

    def test_a_turned_room_is_aligned_where_that_is_asked(self):
        """A cupboard on the floor and at a wall, turned by 30 degrees and printed with six decimals."""
        walls = box((0, 0, 0), (4, 3, 2.5), inwards=True)
        groups = {"west": walls[:1], "floor": walls[4:5], "rest": walls[1:4] + walls[5:],
                  "cupboard": box((0, 0.2, 0), (0.6, 1.4, 2))}
        self.obj("plain.obj", groups)
        c, s = math.cos(math.pi / 6), math.sin(math.pi / 6)
        turned = {name: [[(round(c * x - s * y, 6), round(s * x + c * y, 6), z) for x, y, z in face] for face in faces]
                  for name, faces in groups.items()}
        self.obj("turned.obj", turned)
        ask = ["--by", "group", "--out", "f.csv", "--accuracy", "1e-3"]
        self.expect(0, "factors", "plain.obj", *ask)
        plain = self.rows("f.csv")
        done = self.run_program("factors", "turned.obj", *ask, "--repair", "align")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(b"mended: turned by 30 degrees", done.stderr)
        self.assertEqual(done.stderr.count(b"mended: contact of"), 2)
        for one, other in zip(plain, self.rows("f.csv"), strict=True):
            self.assertEqual((one["from"], one["to"]), (other["from"], other["to"]))
            self.assertAlmostEqual(float(one["factor"]), float(other["factor"]),
                                   delta=float(one["radius"]) + float(other["radius"]) + 1e-5)
        # Without it there is a gap or a refusal, and both name the way out.
        triangles = {name: [[face[0], face[k], face[k + 1]] for face in faces for k in (1, 2)]
                     for name, faces in turned.items()}
        self.obj("triangles.obj", triangles)
        done = self.run_program("surface", "triangles.obj")
        self.assertIn(b"repair align", done.stdout + done.stderr)
        # x, y, z of a problem are those of its file.
        self.write("problem.json", {"schema": "radcert/problem/1", "surface": {"file": "turned.obj", "repair": ["align"]},
                                    "triangulation": {"levels": [0]}, "basis": {"family": "inset", "degree": 0},
                                    "reflectivity": "1/2", "emission": "1"})
        refused = self.run_program("solve", "problem.json")
        self.assertEqual(refused.returncode, 2)
        self.assertIn(b"was turned by 30 degrees by repair align", refused.stderr)
        self.expect(0, "surface", "turned.obj", "--repair", "align", "--write", "aligned.obj")
        self.expect(0, "factors", "aligned.obj", *ask)
        again = self.rows("f.csv")
        self.assertEqual([row["to"] for row in again], [row["to"] for row in plain])
        self.assertEqual(self.run_program("surface", "turned.obj", "--repair", "align", "--write", "a.jpg").returncode, 2)

    def obj(self, name, groups):
        """A mesh with these groups of quadrangles; equal points are one vertex."""
        numbers = {}
        faces = []
        for group, quadrangles in groups.items():
            faces.append(f"g {group}")
            faces += ["f " + " ".join(str(numbers.setdefault(corner, len(numbers) + 1)) for corner in face)
                      for face in quadrangles]
        lines = ["v " + " ".join(repr(x) for x in corner) for corner in numbers] + faces
        return self.write(name, "\n".join(lines) + "\n")

    def test_what_bodies_cover_of_faces_takes_no_part(self):
        # A cupboard on the floor of a room and against a wall: by itself, and with the floor and the wall cut by hand.
        room, cupboard = ((0, 0, 0), (4, 3, 2.5)), ((1, 2.5, 0), (1.75, 3, 2))
        walls = box(*room, inwards=True)
        body = box(*cupboard)
        self.obj("contact.obj", {"floor": walls[4:5], "rest": walls[:4] + walls[5:], "cupboard": body})
        lines = [(0, 1, 1.75, 4), (0, 2.5, 3), (0, 2, 2.5)]
        cut = {"floor": [], "rest": [], "cupboard": []}
        for face in walls:
            axis = next(k for k in range(3) if len({corner[k] for corner in face}) == 1)
            first, second = (axis + 1) % 3, (axis + 2) % 3
            for low, high in zip(lines[first], lines[first][1:]):
                for left, right in zip(lines[second], lines[second][1:]):
                    at = lambda k, face=face, axis=axis, low=low, high=high, left=left, right=right: tuple(
                        float(face[0][axis] if i == axis else
                              (low, high)[face[k][i] > 0] if i == (axis + 1) % 3 else (left, right)[face[k][i] > 0])
                        for i in range(3))
                    cell = [at(k) for k in range(4)]
                    middle = [sum(corner[k] for corner in cell) / 4 for k in range(3)]
                    is_floor = axis == 2 and face[0][2] == 0
                    if all(cupboard[0][k] <= middle[k] <= cupboard[1][k] for k in range(3)):
                        continue
                    cut["floor" if is_floor else "rest"].append(cell)
        for face in body:
            if {corner[2] for corner in face} != {0.0} and {corner[1] for corner in face} != {3.0}:
                cut["cupboard"].append(face)
        self.obj("cut.obj", cut)
        tables = []
        for name in ("contact.obj", "cut.obj"):
            done = self.run_program("factors", name, "--by", "group", "--out", "f.csv", "--accuracy", "1e-6")
            self.assertEqual(done.returncode, 0, done.stderr)
            if name == "contact.obj":
                self.assertIn(b"contact of ", done.stderr)
            with open(self.path("f.surfaces.csv"), newline="", encoding="utf-8") as file:
                areas = {row["name"]: float(row["area"]) for row in csv.DictReader(file)}
            tables.append((areas, {(row["from"], row["to"]): float(row["factor"]) for row in self.rows("f.csv")}))
        (areas, factors), (cut_areas, cut_factors) = tables
        self.assertAlmostEqual(areas["floor"], 12 - 0.375, delta=1e-12)
        for name, area in cut_areas.items():
            self.assertAlmostEqual(areas[name], area, delta=1e-12)
        for pair, factor in cut_factors.items():
            self.assertAlmostEqual(factors[pair], factor, delta=5e-6, msg=pair)
        # The same a rounding above the floor is no contact, and that is said.
        above = [[(x, y, z + 2.0 ** -52) for x, y, z in face] for face in body]
        self.obj("above.obj", {"floor": walls[4:5], "rest": walls[:4] + walls[5:], "cupboard": above})
        done = self.run_program("factors", "above.obj", "--by", "group", "--out", "f.csv", "--accuracy", "1e-3")
        self.assertIn(b"floor and cupboard face each other across a gap of 2.2e-16 at (", done.stderr)
        told = json.loads(self.expect(0, "surface", "above.obj", "--json", "-"))
        self.assertRegex(told["file"]["remarks"][0], "^floor and cupboard face each other")
        pieces = json.loads(self.expect(0, "surface", "contact.obj", "--json", "-"))
        self.assertTrue(pieces["closed"])

    def test_bodies_that_share_faces_and_parts_of_edges_are_taken_as_they_are(self):
        room = box((0, 0, 0), (4, 4, 4), inwards=True)
        small = box((1, 1, 1), (2, 2, 2))

        def factors_of(name, groups):
            self.obj(name, groups)
            done = self.run_program("factors", name, "--by", "group", "--out", "f.csv", "--accuracy", "1e-4")
            self.assertEqual(done.returncode, 0, done.stderr)
            return done.stderr.decode(), {(row["from"], row["to"]): (float(row["factor"]), float(row["radius"]))
                                          for row in self.rows("f.csv")}

        # Two of one group side by side, all vertices in common, are the box that they make up.
        said, two = factors_of("two.obj", {"room": room, "boxes": small + box((2, 1, 1), (3, 2, 2))})
        self.assertIn("contact of boxes and boxes: an area of 1 of each", said)
        _, one = factors_of("one.obj", {"room": room, "boxes": box((1, 1, 1), (3, 2, 2))})
        self.assertEqual(two.keys(), one.keys())
        for pair, (factor, radius) in one.items():
            self.assertLessEqual(abs(two[pair][0] - factor), radius + two[pair][1], pair)
        # Two that have a part of an edge in common are what they are next to nothing apart.
        said, touching = factors_of("part.obj", {"room": room, "a": small, "b": box((2, 2, 1.5), (3, 3, 3))})
        self.assertIn("mended: 4 triangles cut where corners of others lie on their sides", said)
        _, apart = factors_of("apart.obj", {"room": room, "a": small, "b": box((2 + 1e-6, 2, 1.5), (3 + 1e-6, 3, 3))})
        self.assertEqual(touching.keys(), apart.keys())
        for pair, (factor, radius) in apart.items():
            self.assertLessEqual(abs(touching[pair][0] - factor), radius + touching[pair][1] + 1e-5, pair)

    def test_plates_have_two_sides_where_that_is_asked_for(self):
        # A plate in the middle of a room: both sides see the room alone, and the room sees what they leave.
        plate = [(0.25, 0.25, 0.5), (0.75, 0.25, 0.5), (0.75, 0.75, 0.5), (0.25, 0.75, 0.5)]
        self.obj("room.obj", {"room": box(*UNIT, inwards=True), "plate": [plate]})
        for more in (["--accuracy", "1e-5"], ["--rays", "--accuracy", "5e-3"]):
            self.expect(0, "factors", "room.obj", "--front", "right-hand", "--two-sided", "plate", "--by", "group",
                        "--out", "room.csv", *more)
            factors = {(row["from"], row["to"]): float(row["factor"]) for row in self.rows("room.csv")}
            delta = 5e-3 if "--rays" in more else 2e-5
            for side in ("plate", "plate back"):
                self.assertAlmostEqual(factors[side, "room"], 1, delta=delta)
                self.assertAlmostEqual(factors["room", side], 0.25 / 6, delta=delta)
            self.assertAlmostEqual(factors["room", "room"], 1 - 0.5 / 6, delta=delta)
            self.assertNotIn(("plate", "plate back"), factors)
        # Between two squares it hides what it did before, and its back sees what lies behind it.
        self.obj("open.obj", {"low": OBSTRUCTED[:1], "high": OBSTRUCTED[1:2], "plate": OBSTRUCTED[2:]})
        self.expect(0, "factors", "open.obj", "--space", "--two-sided", "plate", "--by", "group", "--out", "open.csv")
        factors = {(row["from"], row["to"]): float(row["factor"]) for row in self.rows("open.csv")}
        self.assertAlmostEqual(factors["low", "high"], OBSTRUCTION, delta=1e-5)
        self.assertAlmostEqual(factors["plate", "low"], factors["plate back", "high"], delta=1e-12)
        self.assertNotIn(("plate", "high"), factors)
        self.assertNotIn(("plate back", "low"), factors)
        for words in (["--two-sided", "wall"], ["--two-sided", "plate", "--certified"], ["--two-sided", "plate,plate"]):
            self.expect(2, "factors", "open.obj", "--space", *words)
        # What stands on one side would leave the other as it is.
        self.obj("shelf.obj", {"low": OBSTRUCTED[:1], "plate": [plate], "box": box((0.4, 0.4, 0.5), (0.6, 0.6, 0.7))})
        done = self.run_program("factors", "shelf.obj", "--front", "right-hand", "--space", "--two-sided", "plate")
        self.assertEqual(done.returncode, 2)
        self.assertIn(b'--two-sided: "plate" touches box', done.stderr)

    def test_groups_are_rows(self):
        corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        numbers = {tuple(map(float, corner)): k + 1 for k, corner in enumerate(corners)}
        lines = [f"v {x} {y} {z}" for x, y, z in corners]
        for k, face in enumerate(box(*UNIT)):
            # Faces in the order x = 0, x = 1, y = 0, ...
            lines += {0: ["g ends"], 2: ["g mantle"]}.get(k, [])
            lines.append("f " + " ".join(str(numbers[corner]) for corner in face))
        self.write("cube.obj", "\n".join(lines) + "\n")
        self.expect(0, "factors", "cube.obj", "--by", "group", "--out", "groups.csv")
        factors = {(row["from"], row["to"]): float(row["factor"]) for row in self.rows("groups.csv")}
        expected = {("ends", "ends"): OPPOSITE, ("ends", "mantle"): 4 * ADJACENT,
                    ("mantle", "ends"): 2 * ADJACENT, ("mantle", "mantle"): OPPOSITE + 2 * ADJACENT}
        self.assertEqual(factors.keys(), expected.keys())
        for pair, value in expected.items():
            self.assertAlmostEqual(factors[pair], value, delta=1e-14)
        areas = {s["name"]: float(s["area"]) for s in self.rows("groups.surfaces.csv")}
        self.assertEqual(areas, {"ends": 2, "mantle": 4})

    def test_threads_change_nothing(self):
        self.write("cubes.off", off(box(*UNIT) + box(*INNER, inwards=True)))
        self.expect(0, "factors", "cubes.off", "--accuracy", "1e-3", "--out", "one.csv", "--threads", "1")
        for file in os.listdir(self.store):
            os.remove(os.path.join(self.store, file))
        self.expect(0, "factors", "cubes.off", "--accuracy", "1e-3", "--out", "two.csv", "--threads", "2")
        self.assertEqual(self.rows("one.csv"), self.rows("two.csv"))

    def test_an_interrupted_run_keeps_finished_rows(self):
        self.write("room.off", off(box(*UNIT, parts=6) + box(*INNER, parts=3, inwards=True)))
        said = self.interrupted_after(b"pairs of triangles", "factors", "room.off", "--accuracy", "1e-9", "--out", "room.csv")
        self.assertIn(b"the same command goes on from there", said)
        self.assertEqual(self.entries(), ["room.off"])


if __name__ == "__main__":
    unittest.main()
