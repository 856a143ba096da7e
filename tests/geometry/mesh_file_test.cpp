// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_file/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "radcert/core/errors.h"
#include "radcert/scalar/rational.h"
#include "tests/core/refusal.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The bytes of a number, the least first.
template <class Unsigned>
std::string bytes_of(Unsigned number, bool big_endian = false) {
  std::string out;
  for (std::size_t i = 0; i < sizeof number; ++i)
    out += static_cast<char>(number >> (8 * (big_endian ? sizeof number - 1 - i : i)) & 255U);
  return out;
}

std::string float_bytes(float x, bool big_endian = false) {
  return bytes_of(std::bit_cast<std::uint32_t>(x), big_endian);
}

/// A binary STL of the triangles of a mesh.
std::string binary_stl(const TriangleMesh& mesh, const std::string& header = "") {
  std::string out = header + std::string(80 - header.size(), '\0');
  out += bytes_of(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    out += std::string(12, '\0');
    for (const Vector<double>& v : mesh.corners(k))
      for (const double x : {v.x, v.y, v.z}) out += float_bytes(static_cast<float>(x));
    out += std::string(2, '\0');
  }
  return out;
}

std::string ascii_stl(const TriangleMesh& mesh, const std::string& name) {
  std::string out = "solid " + name + "\n";
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    out += " facet normal 0 0 0\n  outer loop\n";
    for (const Vector<double>& v : mesh.corners(k))
      out += "   vertex " + shortest(v.x) + " " + shortest(v.y) + " " + shortest(v.z) + "\n";
    out += "  endloop\n endfacet\n";
  }
  return out + "endsolid " + name + "\n";
}

/// The corners of all faces as points: what does not depend on how vertices are numbered.
std::vector<Vector<double>> corner_points(const MeshFile& file) {
  std::vector<Vector<double>> out;
  for (const std::size_t c : file.corner) out.push_back(file.vertices[c]);
  return out;
}

std::string refusal(const std::string& bytes, const std::string& name) {
  return test::refusal_of([&] { return parse_mesh_file(bytes, name); });
}

const std::string tetrahedron_ply =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n";

std::string binary_ply(bool big_endian) {
  std::string out = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") + "_endian 1.0\n" +
                    "comment made here\n" + tetrahedron_ply;
  const sample::Polyhedron solid = sample::tetrahedron();
  for (const Vector<double>& v : solid.vertices) {
    for (const double x : {v.x, v.y, v.z}) out += float_bytes(static_cast<float>(x), big_endian);
    out += '\x7f';
  }
  for (const auto& face : solid.faces) {
    out += '\x03';
    for (const std::size_t v : face) out += bytes_of(static_cast<std::uint32_t>(v), big_endian);
  }
  return out;
}

TEST(MeshFile, IsTheSameFromEveryFormat) {
  const sample::Polyhedron solid = sample::tetrahedron();
  const TriangleMesh mesh = sample::mesh_of(solid);
  std::string obj;
  std::string ascii = "ply\nformat ascii 1.0\n" + tetrahedron_ply;
  for (const Vector<double>& v : solid.vertices) {
    const std::string point = shortest(v.x) + " " + shortest(v.y) + " " + shortest(v.z);
    obj += "v " + point + "\nvn 0 0 1\n";
    ascii += point + " 7\n";
  }
  for (const auto& f : solid.faces) {
    obj += "f " + std::to_string(f[0] + 1) + "//1 " + std::to_string(f[1] + 1) + "//1 " +
           std::to_string(static_cast<int>(f[2]) - 4) + "\n";
    ascii += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + "\n";
  }
  const std::vector<Vector<double>> wanted = corner_points(parse_mesh_file(sample::off_text(solid), "a.off"));
  ASSERT_EQ(wanted.size(), 12U);
  for (const auto& [bytes, name] : std::vector<std::pair<std::string, std::string>>{
           {obj, "a.obj"},
           {ascii, "a.ply"},
           {binary_ply(false), "A.PLY"},
           {binary_ply(true), "a.ply"},
           {binary_stl(mesh), "a.stl"},
           {binary_stl(mesh, "solid by its first word"), "a.stl"},
           {ascii_stl(mesh, "t"), "a.stl"}}) {
    const MeshFile file = parse_mesh_file(bytes, name);
    EXPECT_EQ(corner_points(file), wanted) << file.format;
    EXPECT_EQ(file.vertices.size(), 4U) << file.format;
    EXPECT_EQ(file.face_count(), 4U);
  }
}

TEST(MeshFile, ReadsIndicesOfOneByte) {
  std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 201\nproperty double x\nproperty double y\n"
      "property double z\nelement face 1\nproperty list uchar uchar vertex_index\nend_header\n";
  for (int i = 0; i <= 200; ++i)
    for (const double x : {1.0 * i, 0.25 * i * i, -1.5}) ply += bytes_of(std::bit_cast<std::uint64_t>(x));
  const MeshFile file = parse_mesh_file(ply + "\x03" + std::string(1, '\0') + "\x7f\xc8", "a.ply");
  EXPECT_THAT(file.corner, ElementsAre(0, 127, 200));
  EXPECT_EQ(file.vertices[200], (Vector<double>{200, 10000, -1.5}));
  EXPECT_EQ(file.precision.words, "doubles");
}

TEST(MeshFile, JoinsTheCornersOfStlWithEqualCoordinates) {
  TriangleMesh mesh = sample::mesh_of(sample::cube());
  const MeshFile file = parse_mesh_file(ascii_stl(mesh, "cube"), "a.stl");
  EXPECT_EQ(file.vertices.size(), 8U);
  EXPECT_EQ(file.joined_corners, 36U - 8U);
  // Zero has two signs and one place.
  std::string text = ascii_stl(mesh, "cube");
  const std::size_t at = text.find("vertex 0 0 0");
  text.replace(at, 12, "vertex -0 0 -0.0");
  EXPECT_EQ(parse_mesh_file(text, "a.stl").vertices.size(), 8U);
}

TEST(MeshFile, NamesGroups) {
  const MeshFile obj = parse_mesh_file(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\no room\ng wall\nf 1 2 4\nusemtl white paint\nf 2 3 4\ng "
      "wall\nf 3 1 4\n",
      "a.obj");
  EXPECT_THAT(obj.group_names, ElementsAre("", "room/wall", "room/wall/white paint"));
  EXPECT_THAT(obj.group, ElementsAre(0, 1, 2, 2));
  const TriangleMesh mesh = sample::mesh_of(sample::tetrahedron());
  const MeshFile stl = parse_mesh_file(ascii_stl(mesh, "one") + ascii_stl(mesh, "other part"), "a.stl");
  EXPECT_THAT(stl.group_names, ElementsAre("one", "other part"));
  EXPECT_THAT(stl.group, ElementsAre(0, 0, 0, 0, 1, 1, 1, 1));
}

TEST(MeshFile, KnowsHowFinelyItIsPrinted) {
  const auto unit = [](const std::string& x) {
    return parse_mesh_file("OFF\n3 1 0\n0 0 0\n" + x + " 0 0\n0 1 0\n3 0 1 2\n", "a.off").precision;
  };
  EXPECT_DOUBLE_EQ(unit("12.3456").unit, 0.5e-4);
  EXPECT_EQ(unit("12.3456").words, "printed with 6 digits");
  EXPECT_DOUBLE_EQ(unit("0.00123").unit, 0.5e-2);  // three digits of the largest, which is 1
  EXPECT_DOUBLE_EQ(unit("-1.50e+2").unit, 0.5);
  EXPECT_LT(unit("0.70710678118654757").unit, 1.2e-16);
  const MeshFile stl = parse_mesh_file(binary_stl(sample::mesh_of(sample::cube())), "a.stl");
  EXPECT_EQ(stl.precision.words, "32-bit floats");
  EXPECT_DOUBLE_EQ(stl.precision.unit, std::ldexp(1.0, -24));
}

TEST(MeshFile, KnowsHowFarDoublesAreFromItsDecimals) {
  const auto rounding = [](const std::string& x) {
    return parse_mesh_file("OFF\n3 1 0\n0 0.5 0\n" + x + " 0 -1024\n0 1 3\n3 0 1 2\n", "a.off")
        .precision.rounding;
  };
  for (const char* x : {"7", "4500000.5", "-4500000.25", "4.5e6", "9007199254740992", "0.0625"})
    EXPECT_EQ(rounding(x), 0) << x;
  EXPECT_EQ(rounding("4500000.1"), std::ldexp(1.0, 22 - 53));
  EXPECT_EQ(rounding("-0.1"), std::ldexp(1.0, -4 - 53));
  EXPECT_EQ(rounding("9007199254740993"), 1);
  for (const char* x : {"4500000.1", "-0.1", "9007199254740993", "0.70710678118654757"}) {
    const Rational decimal = Rational::parse(x).value();
    EXPECT_LE(abs(decimal - Rational::exactly(decimal.to_double())), Rational::exactly(rounding(x))) << x;
  }
  EXPECT_EQ(parse_mesh_file(binary_stl(sample::mesh_of(sample::cube())), "a.stl").precision.rounding, 0);
}

TEST(MeshFile, RefusesWithPlaceAndValue) {
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string out = off;
    return out.replace(out.find(from), from.size(), to);
  };
  struct Case {
    std::string bytes;
    std::string name;
    std::string place;
    std::string text;
  };
  std::string cut = binary_stl(sample::mesh_of(sample::tetrahedron()));
  cut.resize(200);
  std::string nan_stl = binary_stl(sample::mesh_of(sample::tetrahedron()));
  nan_stl.replace(84 + 50 + 12, 4, float_bytes(std::numeric_limits<float>::quiet_NaN()));
  for (const Case& c : std::vector<Case>{
           {"", "a.off", "", "is empty"},
           {off, "a.mesh", "", ".off, .obj, .ply, .stl"},
           {changed("1 0 0", "nan 0 0"), "a.off", "line 4", "\"nan\" is not finite"},
           {changed("1 0 0", "1e61 0 0"), "a.off", "line 4", "too large"},
           {changed("1 0 0", "1e999 0 0"), "a.off", "line 4", "1e999"},
           {changed("1 0 0", "1 0"), "a.off", "line 4", "three coordinates"},
           {changed("1 0 0", "1 O 0"), "a.off", "line 4", "\"O\""},
           {changed("3 0 1 2", "3 0 1 3"), "a.off", "line 6", "\"3\""},
           {changed("3 0 1 2", "3 0 1 -1"), "a.off", "line 6", "\"-1\""},
           {changed("3 0 1 2", "3 0 1 1"), "a.off", "line 6", "two corners"},
           {changed("3 0 1 2", "2 0 1"), "a.off", "line 6", "at least 3"},
           {changed("3 0 1 2", "4 0 1 2"), "a.off", "line 6", "number of corners"},
           {changed("3 0 1 2\n", ""), "a.off", "line 5", "ends too early"},
           {changed("3 1 0", "3 0 0"), "a.off", "line 6", "follows the last face"},
           {"OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "a.off", "", "has no faces"},
           {changed("OFF", "4OFF"), "a.off", "line 1", "4OFF"},
           {changed("3 1 0", "-3 1 0"), "a.off", "line 2", "negative"},
           {changed("3 1 0", "4000000000 1 0"), "a.off", "line 6", "how many numbers"},
           {changed("3 1 0\n", "4000000000 1 0\n").substr(0, 37), "a.off", "line 5", "ends too early"},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "a.obj", "line 4", "\"0\""},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "a.obj", "line 4", "not there"},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "a.obj", "line 4", "\"-4\""},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9223372036854775808\n", "a.obj", "line 4",
            "-9223372036854775808"},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\x1b[31m\nf 1 2 3\n", "a.obj", "line 5", "\\x1b[31m"},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "a.obj", "", "has no faces"},
           {"v 0 0 inf\n", "a.obj", "line 1", "not finite"},
           {"# nothing\n", "a.obj", "", "has no vertices"},
           {"a cube of side one\n", "a.stl", "line 1", "no STL file"},
           {"solid x\nfacet\nvertex 0 0 0\nendfacet\n", "a.stl", "line 4", "\"1\""},
           {"solid x\nendsolid x\n", "a.stl", "", "has no vertices"},
           {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "a.stl", "line 4", "within a solid"},
           {cut, "a.stl", "byte 200", "cut off"},
           {binary_stl(sample::mesh_of(sample::tetrahedron())) + "x", "a.stl", "byte 284", "should end"},
           {nan_stl, "a.stl", "byte 134", "not finite"},
           {std::string("\x01\x02", 2), "a.stl", "byte 2", "header"},
           {binary_ply(false).substr(0, 260), "a.ply", "byte 260", "cut off"},
           {binary_ply(false).substr(0, binary_ply(false).size() - 4) + "\xff\xff\xff\xff", "a.ply", "byte",
            "\"-1\" is negative"},
           {binary_ply(false) + "x", "a.ply", "byte", "beyond the last"},
           {"ply\nformat ascii 1.0\nelement face 0\nend_header\n", "a.ply", "", "no element vertex"},
           {"ply\nformat text\n", "a.ply", "line 2", "format text"},
           {"ply\n", "a.ply", "line 1", "within the header"},
       }) {
    const std::string said = refusal(c.bytes, c.name);
    EXPECT_THAT(said, HasSubstr(c.name)) << c.text;
    EXPECT_THAT(said, HasSubstr(c.place));
    EXPECT_THAT(said, HasSubstr(c.text));
    EXPECT_THAT(said, HasSubstr("; allowed: "));
  }
}

TEST(MeshFile, TheDigestIsThatOfTheBytes) {
  const std::string text = sample::off_text(sample::cube());
  const std::string digest = parse_mesh_file(text, "a.off").digest;
  EXPECT_EQ(parse_mesh_file(text, "b.off").digest, digest);
  EXPECT_NE(parse_mesh_file(text + "\n", "a.off").digest, digest);
}

TEST(FaceTriangulation, CutsWithoutChangingTheArea) {
  // A face with a notch and a corner on a straight side; every triangle must turn the same way.
  const sample::Polyhedron notched{{{0, 0, 1}, {2, 0, 1}, {4, 0, 1}, {4, 4, 1}, {2, 1, 1}, {0, 4, 1}},
                                   {{0, 1, 2, 3, 4, 5}}};
  for (const int axis : {0, 1, 2})
    for (const bool reversed : {false, true}) {
      sample::Polyhedron solid = notched;
      for (Vector<double>& v : solid.vertices)
        v = axis == 0 ? v : axis == 1 ? Vector<double>{v.z, v.x, v.y} : Vector<double>{v.y, v.z, v.x};
      if (reversed) std::reverse(solid.faces[0].begin(), solid.faces[0].end());
      const TriangulatedFaces cut = triangulate_faces(parse_mesh_file(sample::off_text(solid), "a.off"));
      ASSERT_EQ(cut.mesh.triangles.size(), 4U);
      EXPECT_EQ(cut.cut_faces, 1U);
      EXPECT_TRUE(cut.bent_faces.empty());
      double doubled = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const auto [a, b, c] = cut.mesh.corners(k);
        const Vector<double> normal = cross(b - a, c - a);
        const double along = axis == 0 ? normal.z : axis == 1 ? normal.x : normal.y;
        EXPECT_GT(reversed ? -along : along, 0);
        doubled += std::abs(along);
      }
      EXPECT_EQ(doubled, 2 * 10.0);
    }
}

TEST(FaceTriangulation, TakesTheDiagonalsThatKeepAnglesLarge) {
  // An L: two squares beside a third are cut without an obtuse angle, wherever the face begins.
  sample::Polyhedron floor{{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}, {2, 4, 0}, {0, 4, 0}},
                           {{0, 1, 2, 3, 4, 5}}};
  for (std::size_t turn = 0; turn < 6; ++turn) {
    const TriangleMesh mesh = sample::mesh_of(floor);
    ASSERT_EQ(mesh.triangles.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto corners = mesh.corners(k);
        const Vector<double>& at = corners[i];
        EXPECT_GE(dot(corners[(i + 1) % 3] - at, corners[(i + 2) % 3] - at), 0) << turn;
      }
    std::rotate(floor.faces[0].begin(), floor.faces[0].begin() + 1, floor.faces[0].end());
  }
}

TEST(FaceTriangulation, CutsFacesOfManyCorners) {
  // A comb: half of the teeth's corners on y = 0, half on y = 1, over a beam of height 1.
  constexpr std::size_t teeth = 10000;
  sample::Polyhedron comb{{}, {{}}};
  comb.vertices.push_back({2.0 * teeth, -1, 0});
  for (std::size_t k = 2 * teeth + 1; k-- > 0;)
    comb.vertices.push_back({static_cast<double>(k), static_cast<double>(k % 2), 0});
  comb.vertices.push_back({0, -1, 0});
  for (std::size_t k = 0; k < comb.vertices.size(); ++k) comb.faces[0].push_back(k);
  const TriangleMesh mesh = sample::mesh_of(comb);
  EXPECT_EQ(mesh.triangles.size(), comb.vertices.size() - 2);
  double doubled = 0;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto [a, b, c] = mesh.corners(k);
    const double area = cross(b - a, c - a).z;
    ASSERT_GT(area, 0);
    doubled += area;
  }
  EXPECT_EQ(doubled, 2.0 * (2 * teeth + teeth));
}

// Words that are no decimal number, or none that a double holds; in every text format the line and the word
// are named.
TEST(MeshFile, RefusesWordsThatAreNoNumbers) {
  const TriangleMesh mesh = sample::mesh_of(sample::tetrahedron());
  const std::string off = "OFF\n3 1 0\n0 0 0\nX 0 0\n0 1 0\n3 0 1 2\n";
  const std::string obj = "v 0 0 0\nv X 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\nX 0 0\n0 1 0\n3 0 1 2\n";
  const std::string stl =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex X 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
      "endsolid a\n";
  struct Format {
    std::string text, name, place;
  };
  for (const Format& f : {Format{off, "a.off", "line 4"}, Format{obj, "a.obj", "line 2"},
                          Format{ply, "a.ply", "line 11"}, Format{stl, "a.stl", "line 5"}}) {
    const auto with = [&](const std::string& word) {
      std::string out = f.text;
      return out.replace(out.find('X'), 1, word);
    };
    for (const std::string word : {"+1", "1", "1.", ".5e0", "+1e+0", "1e00", "4.9e-324", "1E0"})
      EXPECT_EQ(parse_mesh_file(with(word), f.name).vertices.size(), 3U) << word;
    for (const std::string word : {"+-1",
                                   "-+1",
                                   "++1",
                                   "--1",
                                   "+",
                                   "-",
                                   ".",
                                   "e5",
                                   "1e",
                                   "1e+",
                                   "1e+-1",
                                   "0x10",
                                   "0x1p3",
                                   "1_0",
                                   "1,0",
                                   "1.0f",
                                   "1/2",
                                   "nan",
                                   "-nan",
                                   "inf",
                                   "+inf",
                                   "infinity",
                                   "1e999",
                                   "-1e999",
                                   "1e-999",
                                   "-1e-400",
                                   "1..2",
                                   "1.2.3",
                                   "(1)",
                                   "1e1.5",
                                   "\xc2\xbd",
                                   "\xe2\x88\x92"
                                   "1"}) {
      const std::string said = refusal(with(word), f.name);
      EXPECT_THAT(said, HasSubstr(f.name + ": " + f.place)) << word;
      EXPECT_THAT(said, HasSubstr("; allowed: a decimal number")) << word;
    }
    EXPECT_EQ(refusal(with("0e-999"), f.name), "");
  }
}

// What stands on a line beside its numbers would be left out otherwise, and with it perhaps what was meant.
TEST(MeshFile, RefusesLinesWithMoreThanTheyMayHave) {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& [text, name, place] : std::vector<std::array<std::string, 3>>{
           {"OFF\n3 1 0\n0 0 0\n1 .5 0 0\n0 1 0\n3 0 1 2\n", "a.off", "line 4"},
           {"OFF\n3 1 0\n" + vertices + "3 0 1 2 5 5\n", "a.off", "line 6"},
           {"OFF\n3 1 0\n" + vertices + "3 0 1 2 red\n", "a.off", "line 6"},
           {"OFF\n3 1 0\n" + vertices + "3 0 1 2 0 0 0 0 0\n", "a.off", "line 6"},
           {"COFF\n3 1 0\n0 0 0 1 0\n", "a.off", "line 3"},
           {"NOFF\n3 1 0\n0 0 0 0 0 one\n", "a.off", "line 3"},
           {"v 0 0 0\nv 1 .5 0 0 0\n", "a.obj", "line 2"},
           {"v 0 0 0\nv 1 0 0 1 x 0\n", "a.obj", "line 2"},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2/x 3\n", "a.obj", "line 4"},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2/1/1/1 3\n", "a.obj", "line 4"},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2/ 3\n", "a.obj", "line 4"},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\nF 1 2 3\n", "a.obj", "line 4"},
           {ply + "0 0 0\n1 .5 0 0\n0 1 0\n3 0 1 2\n", "a.ply", "line 11"},
           {ply + vertices + "3 0 1 2 3\n", "a.ply", "line 13"},
           {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0 0\n", "a.stl", "line 4"}}) {
    EXPECT_THAT(refusal(text, name), HasSubstr(name + ": " + place)) << text;
  }
  for (const auto& [text, name] : std::vector<std::array<std::string, 2>>{
           {"OFF\n3 1 0\n" + vertices + "3 0 1 2 255 0 0 # red\n", "a.off"},
           {"CNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0\n1 0 0 0 0 1 1 0 0 1\n0 1 0 0 0 1 1 0 0\n3 0 1 2 .5 .5 .5 1\n",
            "a.off"},
           {"mtllib a.mtl\nv 0 0 0 1 0 0\nv 1 0 0 1.0\nv 0 1 0\nvt 0 0\nvn 0 0 1\ns off\nf 1/1/1 2//1 3/1\n",
            "a.obj"}})
    EXPECT_EQ(parse_mesh_file(text, name).face_count(), 1U) << text;
}

/// A quadrangle, the last corner lifted, within a pyramid.
sample::Polyhedron bent_pyramid(double lift, double scale = 1, const Vector<double>& shift = {}) {
  sample::Polyhedron solid{{{0, 0, 0}, {1, 0, 0}, {1, 1, lift}, {0, 1, 0}, {0.5, 0.5, 3}},
                           {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  for (Vector<double>& v : solid.vertices) v = scale * v + shift;
  return solid;
}

std::string bent_text(const sample::Polyhedron& solid, const std::string& name) {
  std::string vertices;
  std::string faces;
  const bool is_obj = name.ends_with(".obj");
  for (const Vector<double>& v : solid.vertices)
    vertices += (is_obj ? "v " : "") + shortest(v.x) + " " + shortest(v.y) + " " + shortest(v.z) + "\n";
  for (const auto& face : solid.faces) {
    faces += is_obj ? "f" : std::to_string(face.size());
    for (const std::size_t v : face) faces += " " + std::to_string(v + (is_obj ? 1 : 0));
    faces += "\n";
  }
  if (is_obj) return vertices + faces;
  const std::string v = std::to_string(solid.vertices.size());
  const std::string f = std::to_string(solid.faces.size());
  if (name.ends_with(".off")) return "OFF\n" + v + " " + f + " 0\n" + vertices + faces;
  return "ply\nformat ascii 1.0\nelement vertex " + v +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " + f +
         "\nproperty list uchar int vertex_indices\nend_header\n" + vertices + faces;
}

std::string bent_refusal(const std::string& text, const std::string& name) {
  return test::refusal_of([&] { return triangulate_faces(parse_mesh_file(text, name)); });
}

TEST(FaceTriangulation, RefusesFacesThatAreNotPlane) {
  // The corners lie 1/(2 sqrt 6) off the plane through their mean, for a lift of 1.
  for (const auto& [name, line] :
       std::vector<std::pair<std::string, std::string>>{{"a.off", "8"}, {"a.obj", "6"}, {"a.ply", "15"}}) {
    const std::string said = bent_refusal(bent_text(bent_pyramid(1), name), name);
    EXPECT_THAT(said, HasSubstr("face 1 (line " + line + ")"));
    EXPECT_THAT(said, HasSubstr("has 4 corners that do not lie in one plane, up to 0.205"));
    EXPECT_THAT(said, HasSubstr("which is 0.118 of the diagonal"));
    EXPECT_THAT(said, HasSubstr("--repair triangulate"));
    EXPECT_EQ(bent_refusal(bent_text(bent_pyramid(0), name), name), "");
  }
  // However little: by one unit in the last place, by a denormal number, at any scale and place.
  for (const double lift : {0x1p-52, -0x1p-53, 1e-300, 0x1p-1074, -1e-9, 0.5, 1e50})
    EXPECT_THAT(bent_refusal(bent_text(bent_pyramid(lift), "a.off"), "a.off"),
                HasSubstr("do not lie in one plane"))
        << lift;
  for (const double scale : {0x1p-1000, 0x1p-500, 1.0, 0x1p150})
    for (const double lift : {0x1p-40, 1.0}) {
      const std::string said = bent_refusal(bent_text(bent_pyramid(lift, scale), "a.off"), "a.off");
      EXPECT_THAT(said, HasSubstr(lift == 1 ? "which is 0.118 of the diagonal" : "e-13 of the diagonal"))
          << scale;
      EXPECT_EQ(bent_refusal(bent_text(bent_pyramid(0, scale), "a.off"), "a.off"), "");
    }
}

// A square turned by 30 degrees about an axis is plane, its corners rounded to double are not: the message
// tells one from the other.
TEST(FaceTriangulation, SaysWhereRoundingAccountsForABend) {
  sample::Polyhedron solid = sample::cube();
  const double c = std::cos(0.5235987755982988);
  const double s = std::sin(0.5235987755982988);
  for (Vector<double>& v : solid.vertices)
    v = {c * v.x - s * v.y, 0.6 * (s * v.x + c * v.y) - 0.8 * v.z, 0.8 * (s * v.x + c * v.y) + 0.6 * v.z};
  const std::string said = bent_refusal(sample::off_text(solid), "a.off");
  EXPECT_THAT(said, HasSubstr("as rounding to double leaves of a plane face"));
  EXPECT_THAT(said, HasSubstr("e-17"));
  EXPECT_EQ(bent_refusal(bent_text(bent_pyramid(1e-9), "a.off"), "a.off").find("as rounding"),
            std::string::npos);
}

TEST(FaceTriangulation, CutsBentFacesWhereAskedAndSaysHow) {
  const sample::Polyhedron solid = bent_pyramid(1);
  const TriangulatedFaces cut =
      triangulate_faces(parse_mesh_file(sample::off_text(solid), "a.off"), BentFaces::cut);
  EXPECT_EQ(cut.cut_faces, 1U);
  EXPECT_THAT(cut.bent_faces, ElementsAre(0));
  ASSERT_EQ(cut.diagonals.size(), 1U);
  // The diagonal that it tells is the side that two of the triangles of the face have and the face has not.
  const VertexTriple& first = cut.mesh.triangles[0];
  const VertexTriple& second = cut.mesh.triangles[1];
  ASSERT_EQ(cut.mesh.face[1], 0U);
  std::vector<std::size_t> shared;
  for (const std::size_t v : first)
    if (std::find(second.begin(), second.end(), v) != second.end()) shared.push_back(v);
  std::sort(shared.begin(), shared.end());
  ASSERT_EQ(shared.size(), 2U);
  EXPECT_TRUE((shared == std::vector<std::size_t>{0, 2}) || (shared == std::vector<std::size_t>{1, 3}));
  const std::string one = std::to_string(shared[0]);
  const std::string two = std::to_string(shared[1]);
  EXPECT_THAT(cut.diagonals[0],
              HasSubstr("face 1 (line 8), bent up to 0.205, which is 0.118 of the diagonal of its box: cut"));
  EXPECT_TRUE(cut.diagonals[0].ends_with("cut from vertex " + one + " to " + two) ||
              cut.diagonals[0].ends_with("cut from vertex " + two + " to " + one))
      << cut.diagonals[0];
  // Plane faces are not told of.
  EXPECT_TRUE(triangulate_faces(parse_mesh_file(sample::off_text(sample::cube()), "a.off"), BentFaces::cut)
                  .diagonals.empty());
}

// Whether four points lie in one plane, by a determinant in rational numbers.
TEST(FaceTriangulation, DecidesExactly) {
  Draw draw(5);
  std::size_t bent = 0;
  for (int k = 0; k < 2000; ++k) {
    const auto number = [&] {
      return std::ldexp(static_cast<double>(draw.below(9)) - 4, static_cast<int>(draw.below(3)));
    };
    const Vector<double> a{number(), number(), number()};
    const Vector<double> u{number(), number(), number()};
    const Vector<double> v{number(), number(), number()};
    // A quadrangle of which the third corner is a combination of the sides, now and then pushed by a little.
    Vector<double> c = a + u + v + (draw.below(2) == 0 ? 0.5 : 0.25) * u;
    if (draw.below(2) == 0) c.z = std::nextafter(c.z, draw.below(2) == 0 ? 100.0 : -100.0);
    const std::array<Vector<double>, 4> p{a, a + u, c, a + v};
    std::string text = "OFF\n4 1 0\n";
    for (const Vector<double>& q : p)
      text += shortest(q.x) + " " + shortest(q.y) + " " + shortest(q.z) + "\n";
    std::array<std::array<Rational, 3>, 3> d;
    for (std::size_t i = 0; i < 3; ++i)
      d[i] = {Rational::exactly(p[i + 1].x) - Rational::exactly(a.x),
              Rational::exactly(p[i + 1].y) - Rational::exactly(a.y),
              Rational::exactly(p[i + 1].z) - Rational::exactly(a.z)};
    const Rational volume = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                            d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                            d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    const std::string said = bent_refusal(text + "4 0 1 2 3\n", "a.off");
    EXPECT_EQ(said.find("do not lie in one plane") != std::string::npos, volume != 0) << text << said;
    bent += volume != 0 ? 1 : 0;
  }
  EXPECT_GT(bent, 300U);
  EXPECT_LT(bent, 1700U);
}

TEST(FaceTriangulation, RefusesFacesThatAreNotSimple) {
  sample::Polyhedron solid = sample::cube();
  std::swap(solid.faces[0][1], solid.faces[0][2]);
  EXPECT_THROW((void)triangulate_faces(parse_mesh_file(sample::off_text(solid), "a.off")), InputError);
  // A star of five points that is drawn in one line; a square with a spike that runs back over itself.
  const sample::Polyhedron star{{{0, 3, 0}, {2, -3, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -3, 0}},
                                {{0, 1, 2, 3, 4}}};
  const sample::Polyhedron spike{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {6, 4, 0}, {2, 4, 0}, {0, 4, 0}},
                                 {{0, 1, 2, 3, 4, 5}}};
  // Sides that cross although ears can be cut off one after the other.
  const sample::Polyhedron crossed{{{1, 2, 0}, {6, 1, 0}, {1, 4, 0}, {4, 2, 0}, {1, 6, 0}},
                                   {{0, 1, 2, 3, 4}}};
  for (const sample::Polyhedron& wrong : {star, spike, crossed})
    EXPECT_THROW((void)triangulate_faces(parse_mesh_file(sample::off_text(wrong), "a.off")), InputError);
}

}  // namespace
}  // namespace radcert
