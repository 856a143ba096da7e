# SPDX-License-Identifier: GPL-3.0-or-later
"""The files that solve writes."""
import csv
import json
import os
import unittest
import xml.etree.ElementTree as xml

from program import ProgramTest, small


class Files(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("problem.json", small())

    def rows(self, name):
        with open(self.path(name), newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file, strict=True))

    def test_a_folder_gets_its_files_and_nothing_else(self):
        self.expect(0, "solve", "problem.json", "--out", "a/b")
        names = ["cite.bib", "errors.csv", "errors_against_h.svg", "errors_against_h.tex", "nodes.csv", "plot.tex", "provenance.json",
                 "solution.json", "solution.ply", "solution.vtu", "table.tex"]
        self.assertEqual(self.entries(), ["a", "a/b"] + ["a/b/" + name for name in names] + ["problem.json"])

    def test_the_tables_say_what_the_json_says(self):
        self.expect(0, "solve", "problem.json", "--out", "out", "--json", "result.json", "--nodes", "nodes.csv")
        with open(self.path("result.json"), encoding="utf-8") as file:
            levels = json.load(file)["levels"]
        rows = self.rows("out/errors.csv")
        self.assertEqual(len(rows), len(levels))
        for row, level in zip(rows, levels):
            self.assertEqual(float(row["node_error"]), level["node_error"]["value"])
            self.assertEqual(float(row["mesh_size"]), level["mesh_size"])
        nodes = self.rows("nodes.csv")
        self.assertEqual(nodes, self.rows("out/nodes.csv"))
        for level in levels:
            of_level = [row for row in nodes if int(row["level"]) == level["level"]]
            self.assertEqual(len(of_level), level["unknowns"])
            largest = max(abs(float(row["u_n"]) - float(row["u"])) for row in of_level)
            self.assertAlmostEqual(largest, level["node_error"]["value"], delta=1e-12)
            for row in of_level:
                normal = sum(float(row["normal_" + axis]) ** 2 for axis in "xyz")
                self.assertAlmostEqual(normal, 1, delta=1e-12)

    def test_the_picture_is_xml_with_as_many_cells_as_elements(self):
        self.expect(0, "solve", "problem.json", "--vtu", "u.vtu", "--json", "result.json")
        with open(self.path("result.json"), encoding="utf-8") as file:
            elements = json.load(file)["levels"][-1]["elements"]
        piece = xml.parse(self.path("u.vtu")).getroot().find("UnstructuredGrid/Piece")
        self.assertEqual(int(piece.get("NumberOfCells")), elements)
        self.assertEqual(int(piece.get("NumberOfPoints")), 3 * elements)
        for name, count in [("PointData", 3 * elements), ("CellData", elements), ("Points", 9 * elements)]:
            self.assertEqual(len(piece.find(name + "/DataArray").text.split()), count)
        self.assertEqual([array.get("Name") for array in piece.findall("PointData/DataArray")], ["radiosity", "error"])
        self.assertEqual([array.get("Name") for array in piece.findall("CellData/DataArray")], ["piece"])

    def test_an_old_file_is_replaced_as_a_whole(self):
        self.write("result.json", "x" * 100000)
        self.expect(0, "solve", "problem.json", "--json", "result.json")
        with open(self.path("result.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["schema"], "radcert/solution/1")

    def test_an_old_file_is_kept_when_the_input_is_wrong(self):
        self.write("result.json", "old")
        self.write("problem.json", small(solution="1/(z-z)"))
        self.expect(2, "solve", "problem.json", "--json", "result.json")
        with open(self.path("result.json"), encoding="utf-8") as file:
            self.assertEqual(file.read(), "old")

    def test_a_folder_that_cannot_be_written_is_the_environments_failure(self):
        if os.geteuid() == 0:
            self.skipTest("root writes everywhere")
        os.mkdir(self.path("closed"), mode=0o500)
        self.expect(3, "solve", "problem.json", "--json", "closed/result.json")


if __name__ == "__main__":
    unittest.main()
