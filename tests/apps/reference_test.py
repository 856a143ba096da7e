# SPDX-License-Identifier: GPL-3.0-or-later
"""Reference values from the command line."""
import csv
import hashlib
import json
import os
import subprocess
import tarfile
import unittest

import jsonschema
from mpmath import mp, mpf

from page import ROOT, PageTest, read
from program import EXAMPLES


def exactly(binary):
    """A number from its mantissa and exponent, as any program with whole numbers can."""
    return mp.ldexp(mpf(int(binary["mantissa"])), int(binary["exponent"]))


class Reference(PageTest):
    def setUp(self):
        super().setUp()
        mp.dps = 80

    def value(self, *words):
        return json.loads(self.expect(0, "reference", *words, "--json", "-"))

    def test_a_value_encloses_what_another_program_computes(self):
        # Howell C-11 for the unit cube.
        s = mp.sqrt(2)
        truth = 2 / mp.pi * (mp.log(mpf(4) / 3) / 2 + 2 * s * mp.atan(1 / s) - mp.pi / 2)
        self.assertEqual(self.value("cube_opposite_faces", "--digits", "1000")["digits"], 1000)
        for digits in (1, 10, 30, 60):
            found = self.value("cube_opposite_faces", "--digits", str(digits))
            self.assertLessEqual(mpf(found["radius"]), mpf(10) ** -digits)
            self.assertLessEqual(abs(mpf(found["midpoint"]) - truth), mpf(found["radius"]))
            self.assertLessEqual(abs(exactly(found["midpoint_binary"]) - truth),
                                 exactly(found["radius_binary"]))
            self.assertEqual(found["digits"], digits)
            self.assertEqual(len(found["routes"]), 2)

    def test_the_file_is_as_its_schema_says(self):
        schema = json.loads(self.expect(0, "schema", "reference"))
        for name in ("cube_opposite_faces", "corner_tetrahedron_leg_to_leg", "superconvergent_inset_1"):
            jsonschema.validate(self.value(name), schema)

    def test_what_is_printed_has_the_digits(self):
        text = self.expect(0, "reference", "coaxial_disks_1_1_1", "--digits", "20")
        self.assertIn("0.38196601125010515179", text)
        self.assertIn("(proved)", text)

    def test_a_family_takes_parameters(self):
        found = self.value("coaxial_disks", "--set", "to_radius=2", "--set", "distance=1/2", "--digits", "20")
        self.assertEqual(found["parameters"], {"from_radius": "1", "to_radius": "2", "distance": "1/2"})
        x = mpf(1) + 4 + mpf("0.25")
        truth = (x - mp.sqrt(x * x - 16)) / 2
        self.assertLess(abs(mpf(found["midpoint"]) - truth), mpf("1e-20"))

    def test_decimals_enter_exactly(self):
        found = self.value("linear_interpolation_norm", "--set", "alpha=0.1", "--digits", "9")
        self.assertEqual(found["parameters"]["alpha"], "1/10")
        self.assertLessEqual(abs(mpf(found["midpoint"]) - mpf(11) / 7), mpf(found["radius"]))

    def refused(self, code, *words):
        done = self.run_program("reference", *words)
        self.assertEqual(done.returncode, code, done.stderr.decode())
        self.assertEqual(done.stdout, b"")
        return done.stderr.decode()

    def test_wrong_input_is_named(self):
        for digits in ("0", "1001", "-3", "ten", "1.5"):
            self.assertIn("from 1 to 1000", self.refused(2, "cube_opposite_faces", "--digits", digits))
        self.assertIn("did you mean cube_opposite_faces?", self.refused(2, "cube_oposite_faces"))
        self.assertIn("neither a NAME nor --all", self.refused(2))
        self.assertIn("a number > 0", self.refused(2, "coaxial_disks", "--set", "distance=0"))
        self.assertIn("a number > 0", self.refused(2, "coaxial_disks", "--set", "distance=nan"))
        self.assertIn("from_radius, to_radius, distance", self.refused(2, "coaxial_disks", "--set", "height=1"))
        self.assertIn("twice", self.refused(2, "coaxial_disks", "--set", "distance=1", "--set", "distance=2"))
        self.assertIn("one value", self.refused(2, "coaxial_disks_1_1_1", "--set", "distance=1"))
        self.assertIn("--all --out DIR", self.refused(2, "--all"))

    def test_a_radius_that_is_not_reached_ends_with_1(self):
        # The second route of a norm is branch and bound, which ends at its limit of triangles.
        message = self.refused(1, "edge_exponent_90", "--set", "rho=1e-30", "--digits", "10")
        self.assertIn("was not reached", message)

    def test_parameters_beyond_double_are_not_reached(self):
        for name, value in [("coaxial_disks", "from_radius=1e-160"), ("sphere_to_coaxial_disk", "distance=1e320"),
                            ("element_to_parallel_disk", "distance=1e160"), ("cylinder_to_itself", "length=1e-320"),
                            ("sphere_radiosity_excess", "rho=0." + 310 * "9")]:
            with self.subTest(name):
                done = self.run_program("reference", name, "--set", value)
                self.assertIn(done.returncode, (0, 1), done.stderr)
                self.assertNotIn(b"defect", done.stderr)

    def test_the_page_is_true_and_its_data_set_complete(self):
        # All values are computed once, by the page.
        self.follow(read(os.path.join(EXAMPLES, "02_reference_value", "README.md")))
        os.rename(self.path("references"), self.path("data"))
        with open(self.path("data/manifest.json"), encoding="utf-8") as file:
            manifest = json.load(file)
        jsonschema.validate(manifest, json.loads(self.expect(0, "schema", "manifest")))
        with open(self.path("data/references.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file, strict=True))
        self.assertEqual([row["name"] for row in rows], [entry["name"] for entry in manifest["values"]])
        self.assertGreaterEqual(len(rows), 60)
        schema = json.loads(self.expect(0, "schema", "reference"))
        for row, entry in zip(rows, manifest["values"]):
            with open(self.path(os.path.join("data", entry["file"])), encoding="utf-8") as file:
                value = json.load(file)
            jsonschema.validate(value, schema)
            self.assertEqual(value["midpoint"], row["midpoint"])
            mantissa, exponent = row["midpoint_exact"].split("*2^")
            self.assertEqual({"mantissa": mantissa, "exponent": exponent}, value["midpoint_binary"])
            if "certificates" in entry:
                self.assertRegex(row["name"], "^continuous_(mean|value)_")
                # Where parts hide each other, less is known.
                most = "1e-3" if "l_room" in row["name"] else "5e-2" if "cube_in_a_cube" in row["name"] else "1e-4"
                self.assertLessEqual(mpf(row["radius"]), mpf(most))
                self.assertEqual([os.path.join("certificates", route["certificate"]) for route in value["route_values"]],
                                 entry["certificates"])
                for file in entry["certificates"]:
                    self.assertTrue(os.path.isfile(self.path(os.path.join("data", file))))
            else:
                self.assertLessEqual(mpf(row["radius"]), mpf("1e-20"))
        self.assertEqual(len(os.listdir(self.path("data"))), len(rows) + 3)
        here = {os.path.relpath(os.path.join(folder, name), self.path("data"))
                for folder, _, names in os.walk(self.path("data")) for name in names}
        self.assertEqual([entry["file"] for entry in manifest["files"]], sorted(here - {"manifest.json"}))
        for entry in manifest["files"]:
            with open(self.path(os.path.join("data", entry["file"])), "rb") as file:
                content = file.read()
            self.assertEqual((len(content), hashlib.sha256(content).hexdigest()), (entry["bytes"], entry["sha256"]))

        # The lumped value is another number, and its name says so.
        value = {row["name"]: mpf(row["midpoint"]) for row in rows}
        self.assertGreater(abs(value["cube_floor_radiosity"] - value["continuous_mean_cube_floor_rho_1/2"]), mpf("0.01"))
        self.assertIn("lumped", self.expect(0, "list", "references"))
        self.archive(manifest)

    def archive(self, manifest):
        """The archive of these files: the same bits each time, and all that its reader needs."""
        # In place of the program one that has computed them already.
        stub = self.path("stub")
        self.write("stub", f"""#!/bin/sh
case $1 in
  --version) exec {os.environ["RADCERT"]} --version ;;
  *) cp -r {self.path("data")} "$4" && echo "values, in $4" ;;
esac
""")
        os.chmod(stub, 0o755)
        script = os.path.join(ROOT, ".ci", "reference-archive")
        digests = []
        for place in ("one", "two"):
            os.mkdir(self.path(place))
            done = subprocess.run([script, self.path(place), "6"], env={**self.environment(), "RADCERT": stub},
                                  capture_output=True, timeout=300, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            (name,) = os.listdir(self.path(place))
            self.assertEqual(name, f"radcert-references-{manifest['radcert']}.tar.gz")
            with open(self.path(os.path.join(place, name)), "rb") as file:
                digests.append(hashlib.sha256(file.read()).hexdigest())
            self.assertIn(digests[-1], done.stdout.decode())
        self.assertEqual(digests[0], digests[1])
        with tarfile.open(self.path(os.path.join("two", name))) as archive:
            members = {member.name.partition("/")[2]: member for member in archive.getmembers() if member.isfile()}
            self.assertEqual(set(members), {entry["file"] for entry in manifest["files"]}
                             | {"README.md", "LICENSE", "CITATION.cff", "manifest.json"})
            for entry in manifest["files"]:
                content = archive.extractfile(members[entry["file"]]).read()
                self.assertEqual(hashlib.sha256(content).hexdigest(), entry["sha256"])
            self.assertIn("values.", archive.extractfile(members["README.md"]).read().decode())
            self.assertEqual({(member.uid, member.gid, member.mtime) for member in members.values()}, {(0, 0, 0)})

    def test_a_mean_of_a_continuous_solution_comes_with_its_certificates(self):
        name = "continuous_mean_two_squares_emitting_rho_1/2"
        found = self.value(name, "--out", "proof")
        jsonschema.validate(found, json.loads(self.expect(0, "schema", "reference")))
        self.assertTrue(found["guaranteed"])
        files = [route["certificate"] for route in found["route_values"]]
        self.assertEqual(sorted(os.listdir(self.path("proof"))), sorted(files))
        for route in found["route_values"]:
            with open(self.path(os.path.join("proof", route["certificate"])), encoding="utf-8") as file:
                mean = next(mean for mean in json.load(file)["means"] if mean["piece"] == "xz")
            self.assertLessEqual(abs(mpf(mean["midpoint"]) - mpf(route["midpoint"])) + mpf(mean["radius"]),
                                 mpf(route["radius"]))
        checked = self.expect(0, "check", os.path.join("proof", files[1]), "--part", "1")
        self.assertIn("verified", checked)
        self.assertIn("is not proved by its certificate", self.refused(1, name, "--digits", "15"))
        self.assertIn("is one value", self.refused(2, name, "--set", "rho=1/3"))

    def test_the_sphere_over_the_disk_by_its_points(self):
        found = self.value("sphere_over_disk", "--at", "B:0.25", "--at", "D:10", "--digits", "12")
        jsonschema.validate(found, json.loads(self.expect(0, "schema", "references")))
        on_sphere, on_disk = found["values"]
        self.assertEqual(on_sphere["parameters"]["latitude"], "1/4")
        self.assertEqual(on_disk["parameters"]["distance"], "10")
        schema = json.loads(self.expect(0, "schema", "reference"))
        for value in found["values"]:
            jsonschema.validate(value, schema)
            self.assertFalse(value["guaranteed"])
            self.assertLessEqual(mpf(value["radius"]), mpf("1e-12"))
            self.assertEqual(len(value["routes"]), 2)
        # Light from the disk comes to beta^2 mu at most; what the sphere gives to the disk at 10 is below its factor.
        self.assertGreater(mpf(on_sphere["midpoint"]), mpf("0.81") * mp.sin(mpf("0.25")))
        factor = 25 * 20 / mpf(500) ** mpf("1.5")
        excess = mpf(on_disk["midpoint"]) - mpf("0.81")
        self.assertTrue(0 < excess < mpf("0.9") * factor * mpf("0.81"))
        one = self.value("sphere_over_disk", "--at", "D:10", "--digits", "12")
        jsonschema.validate(one, schema)
        self.assertEqual({**one, "command": ""}, {**on_disk, "command": ""})

    def test_the_sphere_over_the_disk_where_its_value_is_known(self):
        text = self.expect(0, "reference", "sphere_over_disk", "--at", "B:pi/2", "--digits", "12", "--json", "value.json")
        self.assertIn("(estimated)", text)
        value = json.loads(read(self.path("value.json")))
        self.assertLessEqual(abs(mpf(value["midpoint"]) - mpf("0.81")), mpf("1e-12"))
        # Faint reflection: the lowest point sees the lit ring, 40 and 5 from the axis, 15 below.
        value = self.value("sphere_over_disk", "--at", "B:-pi/2", "--digits", "16", "--set", "albedo=1e-5")
        first = mpf("0.9e-10") * (mpf(1600) / 1825 - mpf(25) / 250)
        self.assertLess(abs(mpf(value["midpoint"]) / first - 1), mpf("1e-5"))

    def test_the_curves_of_the_sphere_over_the_disk(self):
        self.expect(0, "reference", "sphere_over_disk", "--curve", "curve.csv", "--points", "17")
        with open(self.path("curve.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file, strict=True))
        self.assertEqual([row["curve"] for row in rows], ["B"] * 17 + ["D"] * 18)
        self.assertEqual([float(row["place"]) for row in rows[17:]],
                         [0, 2.5, 5, 5] + [2.5 * k for k in range(3, 17)])
        self.assertEqual([row["lit"] for row in rows[17:21]], ["false", "false", "false", "true"])
        for row in rows:
            self.assertAlmostEqual(float(row["total"]), float(row["emission"]) + float(row["indirect"]), delta=1e-15)

    def test_wrong_points_of_the_sphere_over_the_disk_are_named(self):
        self.assertIn("B:LATITUDE", self.refused(2, "sphere_over_disk", "--at", "X:3"))
        for place in ("B:1.6", "B:-2", "B:north", "B:", "B:1.5707963267948967"):
            self.assertIn("[-pi/2, pi/2]", self.refused(2, "sphere_over_disk", "--at", place))
        for place in ("D:41", "D:-1", "D:40.000000001", "D:nan", "D:pi/2"):
            self.assertIn("[0, 40]", self.refused(2, "sphere_over_disk", "--at", place))
        self.assertIn("[0, 60]", self.refused(2, "sphere_over_disk", "--set", "disk_radius=60", "--at", "D:61"))
        at = ("sphere_over_disk", "--at", "D:1")
        self.assertIn("[0, 1)", self.refused(2, *at, "--set", "albedo=1"))
        self.assertIn("> radius", self.refused(2, *at, "--set", "height=5"))
        self.assertIn("> radius", self.refused(2, *at, "--set", "disk_radius=4"))
        self.assertIn("1 to 24", self.refused(2, *at, "--digits", "25"))
        self.assertIn("without a point", self.refused(2, "sphere_over_disk"))
        self.assertIn("from 2 to", self.refused(2, "sphere_over_disk", "--curve", "c.csv", "--points", "1"))
        for words in ((*at, "--points", "3"), ("cube_opposite_faces", "--points", "3"), ("--all", "--out", "all", "--points", "3")):
            self.assertIn("--curve FILE.csv", self.refused(2, *words))
        self.assertIn("is for sphere_over_disk", self.refused(2, "cube_opposite_faces", "--at", "D:1"))
        self.refused(2, "sphere_over_disk", "--curve", "c.csv", "--at", "D:99")
        self.assertFalse(os.path.exists(self.path("c.csv")))

    def test_the_list_has_them(self):
        names = {entry["name"] for entry in
                 json.loads(self.expect(0, "list", "references", "--json", "-"))["entries"]}
        self.assertTrue({"cube_opposite_faces", "coaxial_disks", "two_squares_eta", "sphere_over_disk"} <= names)


if __name__ == "__main__":
    unittest.main()
