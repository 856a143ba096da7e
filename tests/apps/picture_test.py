# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures: files that can be looked at, the same for any number of threads, and what is refused."""
import base64
import json
import math
import os
import struct
import unittest
import xml.etree.ElementTree as xml
import zlib

import jsonschema

from program import ProgramTest

NAMES = ["figure_3", "figure_5", "figure_6", "figure_7", "figure_8", "figure_8_direct", "figure_8_shepard",
         "figure_8_gaussian", "figure_8_lehtinen", "figure_9"]
RASTERS = [name for name in NAMES if name != "figure_6"]
# Few rays and few sites: seconds for all.
SMALL = ["--size", "96x64", "--quiet"]
COARSE = ["--separation", "0.35"]
SVG = "{http://www.w3.org/2000/svg}"
XLINK = "{http://www.w3.org/1999/xlink}"


def chunks(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at = 8
    while at < len(data):
        length, = struct.unpack(">I", data[at:at + 4])
        kind, body = data[at + 4:at + 8], data[at + 8:at + 8 + length]
        assert zlib.crc32(kind + body) == struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0]
        yield kind.decode(), body
        at += 12 + length


def pixels(data):
    """Width, height and rows of (red, green, blue), by the five filters of the standard."""
    body = b"".join(part for kind, part in chunks(data) if kind == "IDAT")
    width, height, depth, colour = struct.unpack(">IIBB", next(chunks(data))[1][:10])
    assert (depth, colour) == (8, 2)
    raw, stride, before, rows = zlib.decompress(body), 3 * width, bytes(3 * width), []
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a, b = line[i - 3] if i >= 3 else 0, before[i]
            c = before[i - 3] if i >= 3 else 0
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            line[i] = (line[i] + [0, a, b, (a + b) // 2, paeth][kind]) % 256
        before = bytes(line)
        rows.append([tuple(line[3 * x:3 * x + 3]) for x in range(width)])
    return width, height, rows


class Picture(ProgramTest):
    def picture(self, name, *words):
        self.expect(0, "picture", name, "--out", "picture.png", *words)
        return self.content("picture.png")

    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def sheet(self, name, *words):
        self.expect(0, "picture", name, "--out", "picture.svg", *words)
        return xml.fromstring(self.content("picture.svg"))

    def words_for(self, name):
        return [*SMALL, "--samples", "1", *(COARSE if name.startswith("figure_8") else [])]

    def test_every_raster_is_a_png_that_says_what_it_shows(self):
        schema = json.loads(self.expect(0, "schema", "picture"))
        jsonschema.Draft202012Validator.check_schema(schema)
        for name in RASTERS:
            with self.subTest(name):
                data = self.picture(name, *self.words_for(name), "--json", "about.json")
                with open(self.path("about.json"), encoding="utf-8") as file:
                    about = json.load(file)
                jsonschema.validate(about, schema)
                self.assertEqual(about["picture"], name)
                texts = dict(body.split(b"\0", 1) for kind, body in chunks(data) if kind == "tEXt")
                self.assertTrue(texts[b"Software"].startswith(b"radcert "))
                self.assertEqual(texts[b"Description"].decode(), about["shows"])
                self.assertNotIn("tIME", [kind for kind, _ in chunks(data)])
                width, height, rows = pixels(data)
                self.assertEqual((width, height), (96, 64))
                self.assertGreater(len({pixel for row in rows for pixel in row}), 10)
                for fact in about["facts"]:
                    if fact["name"].endswith("without a value"):
                        # Sites so coarse leave gaps in a corner.
                        self.assertLess(fact["value"], 0.01 if "0.35" in self.words_for(name) else 1e-300)

    def test_a_sheet_has_the_raster_and_the_titles_as_text(self):
        for name in ["figure_5", "figure_8_direct", "figure_9"]:
            with self.subTest(name):
                words = [word if word != "96x64" else "400x200" for word in self.words_for(name)]
                root = self.sheet(name, *words, "--json", "about.json")
                about = json.loads(self.content("about.json"))
                self.assertEqual(root.find(SVG + "title").text, about["shows"])
                image, = root.iter(SVG + "image")
                kind, data = image.get(XLINK + "href").split(",")
                self.assertEqual(kind, "data:image/png;base64")
                width, height, rows = pixels(base64.b64decode(data))
                self.assertEqual((width, height), (400, 200))
                self.assertEqual((about["width"], about["height"]), (400, 200))
                self.assertGreater(len({pixel for row in rows for pixel in row}), 10)
                shown = [text.text for text in root.iter(SVG + "text")]
                self.expect(0, "picture", name, "--out", "raster.png", *words, "--json", "raster.json")
                titles = [fact["value"] for fact in json.loads(self.content("raster.json"))["facts"]
                          if fact["name"].startswith("panel, without its title")]
                self.assertEqual(shown[:len(titles)], titles)
                # The ticks of a scale from 0 to 1, where there is one.
                self.assertEqual(shown[len(titles):], ["0", "0.2", "0.4", "0.6", "0.8", "1"] if name == "figure_5" else [])

    def test_figure_6_is_plots(self):
        root = self.sheet("figure_6", "--quiet")
        shown = [text.text for text in root.iter(SVG + "text")]
        for words in ["Shepard", "Gauss", "Lehtinen"]:
            self.assertIn(words, shown)
        self.assertEqual(shown.count("f"), 3)
        # Three frames; in each four elements and f, and four values as dots, beside one in the legend.
        self.assertEqual(len([rect for rect in root.iter(SVG + "rect") if rect.get("class") == "axis"]), 3)
        self.assertEqual(len(list(root.iter(SVG + "circle"))), 3 * 5)

    def test_threads_change_nothing(self):
        for name in ["figure_5", "figure_8_lehtinen", "figure_9"]:
            words = self.words_for(name)
            self.assertEqual(self.picture(name, *words, "--threads", "1"), self.picture(name, *words, "--threads", "2"))

    def test_walls_at_right_angles_are_black_by_the_distance_15(self):
        width, height, rows = pixels(self.picture("figure_5", "--size", "400x160", "--samples", "2", "--quiet"))
        # The floor in the middle below: bright enough to see by the Euclidean distance, black by (15).
        self.assertEqual(rows[height - 12][int(0.7 * width)], (0, 0, 0))
        self.assertGreater(max(rows[height - 12][int(0.25 * width)]), 20)

    def test_figure_6_interpolates_by_the_formulas(self):
        about = json.loads(self.expect(0, "picture", "figure_6", "--out", "a.svg", "--quiet", "--json", "-"))
        facts = {fact["name"]: fact["value"] for fact in about["facts"]}

        def spline(r):
            return 2 * r**3 - 3 * r**2 + 1 if r < 1 else 0

        def bell(r):
            return math.exp(-r * r / 2)

        for name, mother, normalised in [("Gauss", bell, False), ("Lehtinen", spline, True)]:
            coefficients = [float(text) for text in facts[f"coefficients, {name}"].split(", ")]
            for site, wanted in enumerate([1, 3, 2, 4]):
                elements = [mother(abs(site - other) / facts["radii"]) for other in range(4)]
                value = sum(c * e for c, e in zip(coefficients, elements))
                self.assertAlmostEqual(value / (sum(elements) if normalised else 1), wanted, 9)
        self.assertEqual(facts["coefficients, Shepard"], "1, 3, 2, 4")

    def test_the_help_and_the_refusal_name_all_pictures(self):
        text = self.expect(0, "picture", "--help")
        refusal = self.refused(2, "picture", "figure_88", "--out", "a.png")
        for name in NAMES:
            self.assertIn(name, text)
            self.assertIn(name, refusal)
        self.assertIn("did you mean figure_8?", refusal)

    def refused(self, code, *words):
        done = self.run_program(*words)
        self.assertEqual(done.returncode, code, done.stderr.decode())
        self.assertEqual(done.stdout, b"")
        self.assertEqual(self.entries(), [])
        return done.stderr.decode()

    def test_bad_input_is_refused_and_leaves_no_file(self):
        for words, text in [
                ((), "NAME"),
                (("figure_5",), "--out FILE.svg"),
                (("figure_6", "--out", "a.png"), "is plots, not a raster"),
                (("figure_6", "--out", "a.svg", "--size", "100x100"), "means nothing for figure_6"),
                (("figure_5", "--out", "no/such/a.png"), "a folder that exists"),
                (("figure_5", "--out", "."), "is a folder"),
                (("figure_5", "--out", "a.png", "--size", "0x0"), "from 64 to 4096"),
                (("figure_5", "--out", "a.png", "--size", "100"), "WIDTHxHEIGHT"),
                (("figure_5", "--out", "a.png", "--size", "100x"), "WIDTHxHEIGHT"),
                (("figure_5", "--out", "a.png", "--size", "100x-5"), "WIDTHxHEIGHT"),
                (("figure_5", "--out", "a.png", "--size", "100x99999999999999999999"), "WIDTHxHEIGHT"),
                (("figure_5", "--out", "a.png", "--samples", "0"), "from 1 to 8"),
                (("figure_5", "--out", "a.png", "--samples", "9"), "from 1 to 8"),
                (("figure_5", "--out", "a.png", "--samples", "two"), "from 1 to 8"),
                (("figure_5", "--out", "a.png", "--threads", "0"), "--threads"),
                (("figure_6", "--out", "a.svg", "--samples", "2"), "means nothing for figure_6"),
                (("figure_5", "--out", "a.png", "--white", "2"), "means nothing for figure_5"),
                (("figure_3", "--out", "a.png", "--separation", "2"), "means nothing for figure_3"),
                (("figure_9", "--out", "a.png", "--direct", "exact"), "means nothing for figure_9"),
                (("figure_8", "--out", "a.png", "--direct", "both"), "basis, exact"),
                (("figure_8", "--out", "a.png", "--white", "0"), "a positive number"),
                (("figure_8", "--out", "a.png", "--white", "nan"), "a positive number"),
                (("figure_8", "--out", "a.png", "--separation", "-1"), "a positive number"),
                (("figure_8", "--out", "a.png", "--separation", "1e-9"), "--separation"),
                (("figure_8_lehtinen", "--out", "a.png", "--separation", "50"), "sites"),
                (("figure_8_gaussian", "--out", "a.png", "--separation", "0.5", *SMALL), "may diverge"),
                (("figure_8", "--out", "a.png", "--seed", "1.5"), "a whole number")]:
            with self.subTest(words):
                self.assertIn(text, self.refused(2, "picture", *words))

    def test_a_disk_that_is_full_is_no_fault_of_the_input(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        self.assertIn("/dev/full", self.refused(3, "picture", "figure_5", "--out", "/dev/full", *SMALL))

    def test_more_memory_than_there_is_is_refused(self):
        for name in ["figure_7", "figure_8_lehtinen", "figure_9"]:
            self.assertIn("memory", self.refused(2, "picture", name, "--out", "a.png", *SMALL, "--max-memory", "1M"))

    def test_an_old_file_stays_where_a_picture_is_refused(self):
        self.write("a.png", "old")
        self.expect(2, "picture", "figure_8_lehtinen", "--out", "a.png", *SMALL, "--separation", "50")
        with open(self.path("a.png"), "rb") as file:
            self.assertEqual(file.read(), b"old")


if __name__ == "__main__":
    unittest.main()
