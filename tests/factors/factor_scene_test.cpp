// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/input/factor_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "radcert/surface/catalogue.h"
#include "tests/core/refusal.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

using test::refusal_of;
using testing::AllOf;
using testing::HasSubstr;

constexpr OptionStyle words = OptionStyle::command_line;

MeshFile file_of(const sample::Polyhedron& polyhedron) {
  return parse_mesh_file(sample::off_text(polyhedron), "sample.off");
}

/// The cube without its last face.
sample::Polyhedron open_cube() {
  sample::Polyhedron cube = sample::cube();
  cube.faces.pop_back();
  return cube;
}

std::string refusal(const sample::Polyhedron& polyhedron, const FactorSceneChoice& choice = {},
                    OptionStyle style = words) {
  return refusal_of([&] { return factor_scene("sample", file_of(polyhedron), choice, style); });
}

TEST(FactorScene, OfAClosedMeshIsARoom) {
  const FactorScene scene = factor_scene("sample", file_of(sample::cube()), {}, words);
  EXPECT_FALSE(scene.open);
  EXPECT_EQ(scene.scene.facet_count(), 12U);
  EXPECT_EQ(scene.front, "left-hand");
}

TEST(FactorScene, OfAnOpenMeshSaysWhatLeavesOnlyWhereThatIsMeant) {
  EXPECT_THAT(refusal(open_cube()),
              AllOf(HasSubstr("is open: 4 edges"), HasSubstr("--space for what leaves it")));
  EXPECT_THAT(refusal(open_cube(), {}, OptionStyle::argument), HasSubstr("or space for what leaves it"));
  EXPECT_TRUE(factor_scene("sample", file_of(open_cube()), {.space = true}, words).open);
  EXPECT_THAT(refusal(sample::cube(), {.space = true}), HasSubstr("is for open scenes"));
  EXPECT_THAT(refusal(sample::cube(), {.front = FrontRule::right_hand}), HasSubstr("has closed bodies"));
}

TEST(FactorScene, RefusesWhatFactorsOfMeanNothing) {
  sample::Polyhedron turned = sample::cube();
  std::reverse(turned.faces.front().begin(), turned.faces.front().end());
  EXPECT_THAT(refusal(turned), HasSubstr("has reversed normals"));
  sample::Polyhedron thin = sample::cube();
  thin.vertices.insert(thin.vertices.end(), {{2, 0, 0}, {3, 0, 0}, {4, 0, 0}});
  thin.faces.push_back({8, 9, 10});
  EXPECT_THAT(refusal(thin), HasSubstr("corners on one line"));
  sample::Polyhedron crossing = sample::cube();
  crossing.vertices.insert(crossing.vertices.end(), {{0.5, 0.5, -1}, {0.5, 0.5, 2}, {0.6, 0.7, 0.5}});
  crossing.faces.push_back({8, 9, 10});
  EXPECT_THAT(refusal(crossing), HasSubstr("triangles that have a vertex or a side in common, or nothing"));
  sample::Polyhedron small = sample::cube();
  for (Vector<double>& v : small.vertices) v = 0x1p-110 * v;
  EXPECT_THAT(refusal(small), HasSubstr("a scene that doubles carry"));
  sample::Polyhedron bent = sample::cube();
  bent.vertices.front().z = -1;
  EXPECT_THAT(refusal(bent), AllOf(HasSubstr("sample: "), HasSubstr("do not lie in one plane")));
  EXPECT_THAT(refusal(sample::cube(), {.two_sided = {"", ""}}), HasSubstr("--two-sided"));
}

TEST(FactorScene, IdentityTellsReadingsApart) {
  const auto identity = [](const FactorSceneChoice& choice) {
    return factor_scene("sample", file_of(open_cube()), choice, words).identity;
  };
  const std::string plain = identity({.space = true});
  EXPECT_EQ(identity({.space = true}), plain);
  EXPECT_NE(identity({.front = FrontRule::left_hand, .space = true}), plain);
  EXPECT_NE(identity({.repair = {"vertices"}, .space = true}), plain);
  EXPECT_NE(identity({.space = true, .degrees = 10}), plain);
  // Lists of groups whose words in one line are the same.
  MeshFile file = file_of(open_cube());
  file.group_names = {"a", "b", "a, b", "rest"};
  for (std::size_t face = 0; face < file.group.size(); ++face)
    file.group[face] = std::min<std::size_t>(face, 3);
  const auto of_plates = [&](const std::vector<std::string>& two_sided) {
    return factor_scene("sample", file, {.two_sided = two_sided, .space = true}, words).identity;
  };
  EXPECT_NE(of_plates({"a", "b"}), of_plates({"a, b"}));
  // The same bytes may say something else in another format.
  MeshFile other = file;
  other.format = "another";
  EXPECT_NE(factor_scene("sample", other, {.space = true}, words).identity,
            factor_scene("sample", file, {.space = true}, words).identity);
}

TEST(FactorScene, PartsPiecesWhereNormalsMakeMoreThanTheAngle) {
  const auto pieces = [](double degrees) {
    return factor_scene("sample", file_of(sample::cube()), {.degrees = degrees}, words)
        .mesh.piece_names.size();
  };
  EXPECT_EQ(pieces(default_sharp_degrees), 6U);
  EXPECT_EQ(pieces(89), 6U);
  EXPECT_EQ(pieces(91), 1U);
}

TEST(FactorScene, OfACatalogueKnowsItsParameters) {
  const SurfaceDescription& box = *find_surface("box");
  const auto scene = [&](const std::vector<Rational>& values, int level) {
    return factor_scene("box", box.make(values), level, false, words);
  };
  EXPECT_NE(scene({1, 2, 3}, 0).identity, scene({1, 2, 4}, 0).identity);
  EXPECT_NE(scene({1, 2, 3}, 0).identity, scene({1, 2, 3}, 1).identity);
  // Sides whose common fraction doubles do not count.
  const Rational third(1, 3);
  const FactorScene rounded = scene({third, Rational::parse("0.12345678901234567890123").value(), 1}, 2);
  EXPECT_FALSE(rounded.mesh.exact);
  EXPECT_EQ(rounded.mesh.unit, Rational(1));
  EXPECT_THAT(rounded.remarks, testing::ElementsAre(HasSubstr("those of the rounded ones")));
  EXPECT_THAT(refusal_of([&] {
                require_exact_corners("box", rounded, OptionStyle::command_line);
                return rounded;
              }),
              HasSubstr("--certified"));
  for (const Rational& side : {third, Rational(3, 8), Rational(1)}) {
    const FactorScene exact = scene({side, 1, 2}, 2);
    EXPECT_TRUE(exact.mesh.exact);
    EXPECT_EQ(exact.mesh.unit, side == third ? Rational(2, 3) : Rational(1));
    EXPECT_TRUE(exact.remarks.empty());
    EXPECT_NO_THROW(require_exact_corners("box", exact, OptionStyle::command_line));
  }
  EXPECT_THAT(refusal_of([&] {
                return factor_scene("sphere", default_surface(*find_surface("sphere")), 0, false, words);
              }),
              HasSubstr("is curved"));
}

}  // namespace
}  // namespace radcert
