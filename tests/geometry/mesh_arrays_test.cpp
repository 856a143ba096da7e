// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_file/mesh_arrays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "tests/core/refusal.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

using test::refusal_of;
using testing::AllOf;
using testing::HasSubstr;

/// A tetrahedron as arrays.
struct Sample {
  std::vector<double> points{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::vector<std::int64_t> triangles{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  std::vector<std::string> groups{};

  [[nodiscard]] MeshFile mesh() const { return mesh_of_arrays({points, triangles, groups}, "sample"); }
};

TEST(MeshOfArrays, IsTheMeshOfAFileWithTheseNumbers) {
  const MeshFile of_file = parse_mesh_file(sample::off_text(sample::tetrahedron()), "sample.off");
  const MeshFile of_arrays = Sample{}.mesh();
  EXPECT_EQ(of_arrays.corner, of_file.corner);
  EXPECT_EQ(of_arrays.face_begin, of_file.face_begin);
  EXPECT_EQ(of_arrays.group_names, of_file.group_names);
  ASSERT_EQ(of_arrays.vertices.size(), of_file.vertices.size());
  for (std::size_t i = 0; i < of_file.vertices.size(); ++i) {
    EXPECT_EQ(of_arrays.vertices[i].x, of_file.vertices[i].x);
    EXPECT_EQ(of_arrays.vertices[i].y, of_file.vertices[i].y);
    EXPECT_EQ(of_arrays.vertices[i].z, of_file.vertices[i].z);
  }
  EXPECT_EQ(of_arrays.precision.words, "doubles");
}

TEST(MeshOfArrays, GroupsAreInTheOrderOfTheirFirstTriangles) {
  Sample sample;
  sample.groups = {"b", "a", "b", "c"};
  const MeshFile mesh = sample.mesh();
  EXPECT_EQ(mesh.group_names, (std::vector<std::string>{"b", "a", "c"}));
  EXPECT_EQ(mesh.group, (std::vector<std::size_t>{0, 1, 0, 2}));
}

TEST(MeshOfArrays, DigestChangesWithAnyNumberAndAnyName) {
  const std::string digest = Sample{}.mesh().digest;
  EXPECT_EQ(Sample{}.mesh().digest, digest);
  Sample other;
  other.points[11] = std::nextafter(1.0, 2.0);
  EXPECT_NE(other.mesh().digest, digest);
  other = {};
  std::swap(other.triangles[0], other.triangles[1]);
  EXPECT_NE(other.mesh().digest, digest);
  other = {};
  other.groups = {"ab", "c", "", ""};
  const std::string named = other.mesh().digest;
  EXPECT_NE(named, digest);
  other.groups = {"a", "bc", "", ""};
  EXPECT_NE(other.mesh().digest, named);
}

TEST(MeshOfArrays, RefusesWithNamePlaceAndValue) {
  Sample sample;
  sample.points[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal_of([&] { return sample.mesh(); }),
              AllOf(HasSubstr("sample: point 1"), HasSubstr("nan")));
  sample = {};
  sample.points[0] = 1e61;
  EXPECT_THAT(refusal_of([&] { return sample.mesh(); }), HasSubstr("point 0"));
  sample = {};
  sample.triangles[7] = 4;
  EXPECT_THAT(refusal_of([&] { return sample.mesh(); }), AllOf(HasSubstr("triangle 2"), HasSubstr("\"4\"")));
  sample.triangles[7] = -1;
  EXPECT_THAT(refusal_of([&] { return sample.mesh(); }), AllOf(HasSubstr("triangle 2"), HasSubstr("\"-1\"")));
  sample.triangles[7] = sample.triangles[6];
  EXPECT_THAT(refusal_of([&] { return sample.mesh(); }),
              AllOf(HasSubstr("triangle 2"), HasSubstr("two corners")));
  sample = {};
  sample.triangles.clear();
  EXPECT_THAT(refusal_of([&] { return sample.mesh(); }), HasSubstr("no faces"));
}

TEST(MeshOfArrays, RequiresWholeRows) {
  Sample sample;
  sample.points.pop_back();
  EXPECT_THROW(static_cast<void>(sample.mesh()), ContractViolation);
  sample = {};
  sample.triangles.pop_back();
  EXPECT_THROW(static_cast<void>(sample.mesh()), ContractViolation);
  sample = {};
  sample.groups = {"a"};
  EXPECT_THROW(static_cast<void>(sample.mesh()), ContractViolation);
}

}  // namespace
}  // namespace radcert
