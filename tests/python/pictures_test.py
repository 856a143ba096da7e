# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of a solution: a pixel has the colour of u_n where its ray arrives."""
import struct
import unittest
import zlib

import numpy as np
import radcert as rc

from module import ModuleTest

# From above the middle of the floor, so that rows and columns of pixels are parallel to its sides.
ABOVE = {"position": (0.5, 0.5, 3), "look_at": (0.5, 0.5, 0), "up": (0, 1, 0), "size": (120, 120), "scale": "light"}


def pixels(png):
    """The pixels of a PNG of eight bits, red, green, blue: (height, width, 3)."""
    at, data = 8, b""
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colours = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            data += body
        at += 12 + length
    assert (depth, colours) == (8, 2)
    rows = np.frombuffer(zlib.decompress(data), dtype=np.uint8).reshape(height, 1 + 3*width)
    out = np.zeros((height, 3*width), dtype=int)
    for y in range(height):
        kind, line = rows[y, 0], rows[y, 1:].astype(int)
        above = out[y - 1] if y else np.zeros(3*width, dtype=int)
        for x in range(3*width):
            left = out[y, x - 3] if x >= 3 else 0
            corner = above[x - 3] if x >= 3 and y else 0
            guess = left + above[x] - corner
            paeth = min((abs(guess - left), 0, left), (abs(guess - above[x]), 1, above[x]), (abs(guess - corner), 2, corner))[2]
            out[y, x] = (line[x] + (0, left, above[x], (left + above[x])//2, paeth)[kind]) % 256
    return out.reshape(height, width, 3)


def light(values):
    """The amount of light of screen values, by the curve of sRGB."""
    x = values / 255
    return np.where(x <= 0.04045, x / 12.92, ((x + 0.055) / 1.055)**2.4)


class Pictures(ModuleTest):
    def setUp(self):
        super().setUp()
        x, y, z = rc.xyz()
        self.solution = rc.Problem(rc.box(1, 1, 1), reflectivity="1/2", solution=x/2 + y/4 + z,
                                   levels=[0, 1]).solve()

    def drawn(self, **changes):
        file = self.folder / "picture.png"
        self.solution.picture(file, **{**ABOVE, "low": 0, "high": 1, **changes})
        return file.read_bytes()

    def test_a_pixel_shows_u_where_its_ray_arrives(self):
        shown = light(pixels(self.drawn(angle=0.3)))
        self.assertTrue((shown[..., 0] == shown[..., 1]).all() and (shown[..., 0] == shown[..., 2]).all())
        # The side of the picture is 2 * 3 * tan(0.15) at the floor, whose middle is in its middle.
        side = 6 * np.tan(0.15)
        places = (np.arange(120) + 0.5) / 120 - 0.5
        expected = (0.5 + side*places[None, :])/2 + (0.5 - side*places[:, None])/4
        # u is linear there, u_n near it, and a screen value is rounded.
        self.assertLess(np.abs(shown[..., 0] - expected).max(), 0.012)
        self.assertLess(np.abs(shown[..., 0] - expected).mean(), 0.004)

    def test_the_iterated_solution_is_smooth_where_u_n_jumps(self):
        x, y, z = rc.xyz()
        self.solution = rc.Problem(rc.box(1, 1, 1), reflectivity="1/2", solution=x/2 + y/4 + z, basis=rc.inset(0),
                                   levels=[3], iterated=True).solve()
        places = 6 * np.tan(0.15) * ((np.arange(120) + 0.5) / 120 - 0.5)
        expected = (0.5 + places[None, :])/2 + (0.5 - places[:, None])/4

        def error(of):
            return np.abs(light(pixels(self.drawn(angle=0.3, of=of)))[..., 0] - expected).mean()

        self.assertLess(4*error("iterated"), error("u_n"))
        self.assertIn("E + K u_n", self.solution.picture(**ABOVE, of="iterated").text)

    def test_the_same_bytes_for_any_number_of_threads(self):
        first = self.drawn(samples=3)
        before = rc.thread_count()
        self.addCleanup(rc.limit_threads, before)
        rc.limit_threads(1)
        self.assertEqual(self.drawn(samples=3), first)

    def test_a_curved_surface_and_a_scale_with_words(self):
        sphere = rc.Problem("sphere", reflectivity="1/2", solution="1", levels=[0, 1]).solve()
        text = sphere.picture(position=(3, 2, 2), look_at=(0, 0, 0)).text
        self.assertTrue(text.startswith("<svg") or text.startswith("<?xml"))
        self.assertIn("u_n", text)
        self.assertEqual(sphere.picture(position=(3, 2, 2), look_at=(0, 0, 0))._repr_svg_(), text)

    def test_wrong_input_is_named_with_its_place(self):
        def place(**changes):
            return self.refused(lambda: self.drawn(**changes)).place

        self.assertEqual(place(position=(0, 0, float("nan"))), "/position")
        self.assertEqual(place(position=(0, 0, 1e300)), "/position")
        self.assertEqual(place(look_at=ABOVE["position"]), "/look_at")
        self.assertEqual(place(up=(0, 0, 1)), "/up")
        self.assertEqual(place(angle=0), "/angle")
        self.assertEqual(place(angle=4), "/angle")
        self.assertEqual(place(size=(10, 100)), "/size")
        self.assertEqual(place(samples=9), "/samples")
        self.assertEqual(place(scale="red"), "/scale")
        self.assertEqual(place(low=1, high=1), "/high")
        self.assertEqual(place(of="v"), "/of")
        self.refused(lambda: self.drawn(of="iterated"), "or a problem with")
        self.refused(lambda: self.solution.picture("picture.jpg", **ABOVE), ".svg, .png")
        self.assertRaises(IndexError, self.drawn, level=2)
        self.assertRaises(TypeError, self.drawn, position=(0, 0))


if __name__ == "__main__":
    unittest.main()
