// SPDX-License-Identifier: GPL-3.0-or-later

// MSH, VTK and VS3 files: what they have in common with OFF, and what each refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "radcert/core/errors.h"
#include "radcert/geometry/mesh_file/mesh_file.h"

namespace radcert {
namespace {

const std::string msh_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 7 \"rim\"\n2 9 \"lower "
    "part\"\n$EndPhysicalNames\n"
    "$Nodes\n5\n10 9 9 9\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
    "$Elements\n4\n1 15 2 7 1 10\n2 1 2 7 1 1 2\n3 3 2 9 1 1 2 3 4\n4 2 2 8 1 3 2 1\n$EndElements\n";
const std::string msh_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\nanything $EndNot\n$EndComments\n"
    "$PhysicalNames\n1\n2 9 \"lower part\"\n$EndPhysicalNames\n"
    "$Entities\n1 1 2 0\n1 0 0 0 0\n1 0 0 0 1 0 0 0 2 1 -2\n5 0 0 0 1 1 0 1 9 0\n6 0 0 0 1 1 0 0 "
    "0\n$EndEntities\n"
    "$Nodes\n2 5 1 10\n0 1 0 1\n10\n9 9 9\n2 5 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n"
    "$Elements\n3 3 1 3\n0 1 15 1\n1 10\n2 5 3 1\n2 1 2 3 4\n2 6 2 1\n3 3 2 1\n$EndElements\n";
const std::string vtk_points = "POINTS 4 double\n0 0 0 1 0 0\n1 1 0\n0 1 0\n";
const std::string vtk_head = "# vtk DataFile Version 3.0\na square\nASCII\n";
const std::string vtk_polygons = vtk_head + "DATASET POLYDATA\n" + vtk_points +
                                 "POLYGONS 2 9\n4 0 1 2 3\n3 2 1 0\nCELL_DATA 2\nanything\n";
const std::string vtk_offsets =
    vtk_head + "DATASET POLYDATA\n" + vtk_points +
    "METADATA\nINFORMATION 0\n\nPOLYGONS 3 7\nOFFSETS vtktypeint64\n0 4 7\nCONNECTIVITY "
    "vtktypeint64\n0 1 2 3 2 1 0\n";
const std::string vtk_grid = vtk_head + "DATASET UNSTRUCTURED_GRID\n" + vtk_points +
                             "CELLS 3 12\n4 0 1 2 3\n2 0 1\n3 2 1 0\nCELL_TYPES 3\n9\n3\n5\n";
const std::string vs3 =
    "T a square ! and a triangle\nC encl=0\nF 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\n"
    "S 1 1 2 3 4 0 0 0.5 lower\nS 2 3 2 1 0 0 0 0.5 upper\nS 3 4 3 1 0 0 2 0.5 more\nE\nafter the end\n";

TEST(MeshFormats, HaveTheFacesOfTheFile) {
  for (const auto& [text, name] : {std::pair(msh_2, "a.msh"),
                                   {msh_4, "a.msh"},
                                   {vtk_polygons, "a.vtk"},
                                   {vtk_offsets, "a.VTK"},
                                   {vtk_grid, "a.vtk"},
                                   {vs3, "a.vs3"}}) {
    const MeshFile file = parse_mesh_file(text, name);
    EXPECT_EQ(file.vertices.size(), 4U) << text;
    ASSERT_GE(file.face_count(), 2U) << text;
    EXPECT_EQ(file.face_begin[1], 4U) << text;
    EXPECT_EQ(file.face_begin[2], 7U) << text;
    const std::vector<Vector<double>> expected{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                               {1, 1, 0}, {1, 0, 0}, {0, 0, 0}};
    for (std::size_t k = 0; k < expected.size(); ++k)
      EXPECT_EQ(file.vertices[file.corner[k]], expected[k]) << text << k;
    EXPECT_EQ(file.precision.words, "printed with 1 digit");
  }
}

TEST(MeshFormats, KeepTheNamesOfGroups) {
  const auto group = [](const MeshFile& file, std::size_t face) {
    return file.group_names[file.group[face]];
  };
  for (const std::string& text : {msh_2, msh_4})
    EXPECT_EQ(group(parse_mesh_file(text, "a.msh"), 0), "lower part");
  EXPECT_EQ(group(parse_mesh_file(msh_2, "a.msh"), 1), "physical_8");
  EXPECT_EQ(group(parse_mesh_file(msh_4, "a.msh"), 1), "");
  const MeshFile view3d = parse_mesh_file(vs3, "a.vs3");
  EXPECT_EQ(group(view3d, 0), "lower");
  EXPECT_EQ(group(view3d, 1), "upper");
  EXPECT_EQ(group(view3d, 2), "upper");
}

TEST(MeshFormats, RefuseWithPlaceAndValue) {
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  struct Case {
    std::string text;
    std::string name;
    std::string place;
    std::string words;
  };
  for (const Case& c : std::vector<Case>{
           {changed(msh_2, "2.2", "2.0"), "a.msh", "line 2", "no version"},
           {changed(msh_2, "2.2 0", "2.2 1"), "a.msh", "line 2", "binary"},
           {changed(msh_2, "3 3 2 9 1 1 2 3 4", "3 3 2 9 1 1 2 3 5"), "a.msh", "line 21", "\"5\""},
           {changed(msh_2, "3 3 2 9 1 1 2 3 4", "3 3 2 9 1 1 2 3"), "a.msh", "line 21",
            "number of its nodes"},
           {changed(msh_2, "3 3 2 9 1 1 2 3 4", "3 9 2 9 1 1 2 3 4"), "a.msh", "line 21",
            "type of an element"},
           {changed(msh_2, "3 3 2 9", "3 3 2 -9"), "a.msh", "line 21", "reversed"},
           {changed(msh_2, "2 1 0 0", "1 1 0 0"), "a.msh", "line 13", "two nodes"},
           {changed(msh_2, "$EndElements\n", ""), "a.msh", "line 22", "ends too early"},
           {changed(msh_4, "1 9 0\n", "2 9 8 0\n"), "a.msh", "line 15", "one physical group"},
           {changed(msh_4, "$Nodes", "$Points"), "a.msh", "line", "$EndPoints"},
           {changed(vtk_polygons, "ASCII", "BINARY"), "a.vtk", "line 3", "BINARY"},
           {changed(vtk_polygons, "4 0 1 2 3", "4 0 1 2 4"), "a.vtk", "line 10", "\"4\""},
           {changed(vtk_polygons, "POLYDATA", "STRUCTURED_POINTS"), "a.vtk", "line 4", "no surface"},
           {changed(vtk_offsets, "0 4 7", "0 7 4"), "a.vtk", "line 16", "offset"},
           {changed(vtk_grid, "\n9\n", "\n10\n"), "a.vtk", "line 10", "type of a cell"},
           {changed(vtk_grid, "CELL_TYPES 3\n9\n", "CELL_TYPES 2\n"), "a.vtk", "line", "number of types"},
           {changed(vs3, "F 3", "F 2"), "a.vs3", "line 3", "three dimensions"},
           {changed(vs3, "S 2 3 2 1 0 0 0", "S 2 3 2 1 0 1 0"), "a.vs3", "line 9", "base"},
           {changed(vs3, "S 2 3 2 1 0 0 0", "S 2 3 2 1 0 0 9"), "a.vs3", "line 9", "\"9\""},
           {changed(vs3, "S 2", "O 2"), "a.vs3", "line 9", "obstruction"},
           {changed(vs3, "S 2 3 2 1", "S 2 3 2 8"), "a.vs3", "line 9", "\"8\""}})
    try {
      static_cast<void>(parse_mesh_file(c.text, c.name));
      ADD_FAILURE() << "accepted: " << c.text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(c.name + ": " + c.place));
      EXPECT_THAT(error.what(), testing::HasSubstr(c.words));
    }
}

}  // namespace
}  // namespace radcert
