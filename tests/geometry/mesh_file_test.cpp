// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>

#include "radcert/core/errors.h"
#include "tests/geometry/sample_meshes.h"

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
  try {
    (void)parse_mesh_file(bytes, name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
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
           {changed("3 1 0", "4000000000 1 0"), "a.off", "line 6", "ends too early"},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "a.obj", "line 4", "\"0\""},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "a.obj", "line 4", "not there"},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "a.obj", "line 4", "\"-4\""},
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

TEST(FaceTriangulation, SaysWhichFacesAreBentAndRefusesThoseThatAreNotSimple) {
  sample::Polyhedron solid = sample::cube();
  EXPECT_TRUE(triangulate_faces(parse_mesh_file(sample::off_text(solid), "a.off")).bent_faces.empty());
  solid.vertices[6].z = 1 + 0x1p-50;
  const TriangulatedFaces bent = triangulate_faces(parse_mesh_file(sample::off_text(solid), "a.off"));
  EXPECT_THAT(bent.bent_faces, ElementsAre(1));
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
