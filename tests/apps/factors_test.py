# SPDX-License-Identifier: GPL-3.0-or-later
"""Configuration factors: known values, closure, what is refused, what a stopped run keeps."""
import csv
import json
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


# Counterclockwise as seen from below and from above: open meshes are taken to be seen from outside.
OBSTRUCTED = [[(0.0, 0.0, 0.0), (0.0, 1.0, 0.0), (1.0, 1.0, 0.0), (1.0, 0.0, 0.0)],
              [(0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (1.0, 1.0, 1.0), (0.0, 1.0, 1.0)],
              [(0.0, 0.0, 0.5), (0.5, 0.0, 0.5), (0.5, 0.5, 0.5), (0.0, 0.5, 0.5)]]
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
        # What two bodies hide together is known within bounds alone.
        plates = [[(0.25, 0.25, z), (0.5, 0.25, z), (0.5, 0.5, z), (0.25, 0.5, z)] for z in (0.5, 0.625)]
        self.write("plates.off", off(OBSTRUCTED[:2] + plates))
        words = ("factors", "plates.off", "--space", "--by", "piece")
        done = self.run_program(*words, "--certified", "--accuracy", "1e-6")
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"incomplete: the row sums' radius is above the accuracy asked for, 1e-06, in 2 of 4 rows: ",
                      done.stderr)
        self.expect(0, *words, "--accuracy", "1e-6")

    def test_a_wall_of_a_body_hides_what_is_in_it(self):
        cube = box((0.0, 0.0, 0.0), (4.0, 4.0, 4.0), inwards=True)
        inner = [(2.0, 3.0, 1.0), (3.0, 2.0, 1.0), (2.5, 2.5, 2.0)]
        outer = [(4.0, 8.0, 1.0), (6.0, 6.0, 3.0), (8.0, 4.0, 1.0)]
        for words in ([], ["--certified"]):
            for faces, seen in (([inner, outer], 2), (cube + [inner, outer], None)):
                self.write("body.off", off(faces))
                self.expect(0, "factors", "body.off", "--space", "--out", "body.csv", *words)
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
        # Its lower face lies within the floor.
        self.write("standing.off", off(box(*UNIT) + box((0.25, 0.25, 0.0), (0.75, 0.75, 0.5), inwards=True)))
        for name in ("reversed.off", "crossing.off", "doubled.off", "standing.off"):
            done = self.run_program("factors", name)
            self.assertEqual(done.returncode, 2, name)
            self.assertRegex(done.stderr.decode(), r"\([-0-9.e]+, [-0-9.e]+, [-0-9.e]+\)", name)

    def test_a_piece_that_sees_nothing_is_warned_of(self):
        # The upper square looks up, as the lower one does.
        self.write("back.off", off([OBSTRUCTED[0], OBSTRUCTED[1][::-1]]))
        done = self.run_program("factors", "back.off", "--space", "--by", "piece")
        self.assertEqual(done.returncode, 0)
        for piece in (b"piece_1", b"piece_2"):
            self.assertIn(piece + b" sees nothing: its normals are probably reversed", done.stderr)

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
