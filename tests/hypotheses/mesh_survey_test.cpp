// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/mesh_survey.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "radcert/core/errors.h"
#include "radcert/geometry/orientation.h"
#include "radcert/hypotheses/nesting.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

using testing::HasSubstr;

MeshSurvey survey_of(const sample::Polyhedron& solid, const MeshRepair& repair = {},
                     FrontRule rule = FrontRule::automatic) {
  return survey_mesh(parse_mesh_file(sample::off_text(solid), "sample.off"), default_sharp_degrees, repair,
                     rule);
}

sample::Polyhedron reversed(sample::Polyhedron solid) {
  for (auto& face : solid.faces) std::reverse(face.begin(), face.end());
  return solid;
}

TEST(MeshSurvey, FindsTheInnerSideWhicheverWayTheFacesRun) {
  for (const sample::Polyhedron& solid : {sample::cube(), sample::octahedron(), sample::sphere(2)}) {
    const MeshSurvey outside = survey_of(solid);
    EXPECT_EQ(outside.front.orientation, Orientation::against_the_cross_product);
    const MeshSurvey inside = survey_of(reversed(solid));
    EXPECT_EQ(inside.front.orientation, Orientation::along_the_cross_product);
    for (const MeshSurvey& survey : {outside, inside}) {
      EXPECT_EQ(survey.front.known_by, InnerSide::by_volume);
      EXPECT_EQ(survey.containment.verdict, Containment::certified);
      EXPECT_FALSE(survey.obstacle().has_value());
    }
  }
}

TEST(MeshSurvey, TrustsTheFileOfAnOpenMesh) {
  sample::Polyhedron open = sample::cube();
  open.faces.pop_back();
  for (const bool inwards : {false, true}) {
    const MeshSurvey survey = survey_of(inwards ? reversed(open) : open);
    EXPECT_EQ(survey.front.orientation, Orientation::along_the_cross_product);
    EXPECT_EQ(survey.front.known_by, InnerSide::by_file);
    EXPECT_FALSE(survey.topology.closed());
    EXPECT_FALSE(survey.front.encloses);
    EXPECT_EQ(survey.looks_away, !inwards);
    EXPECT_EQ(survey.containment.verdict == Containment::certified, inwards);
    EXPECT_EQ(survey.obstacle().has_value(), !inwards);
  }
  EXPECT_THAT(*survey_of(open).obstacle(), testing::AllOf(HasSubstr("right-hand"), HasSubstr("left-hand")));
  const MeshSurvey chosen = survey_of(open, {}, FrontRule::left_hand);
  EXPECT_EQ(chosen.front.orientation, Orientation::against_the_cross_product);
  EXPECT_EQ(chosen.front.known_by, InnerSide::by_choice);
  EXPECT_FALSE(chosen.obstacle().has_value());
  EXPECT_EQ(chosen.containment.verdict, Containment::certified);
}

TEST(MeshSurvey, ReadsClosedBodiesBothWaysOnlyWhereToldTo) {
  const sample::Polyhedron two =
      sample::together(sample::cube(), sample::column({{3, 3}, {4, 3}, {3, 4}}, 1), false);
  EXPECT_THAT(*survey_of(two).obstacle(), HasSubstr("2 closed bodies beside each other"));
  EXPECT_FALSE(survey_of(reversed(two)).obstacle().has_value());
  EXPECT_TRUE(survey_of(reversed(two)).front.encloses);
  for (const bool inwards : {false, true})
    for (const FrontRule rule : {FrontRule::right_hand, FrontRule::left_hand}) {
      const MeshSurvey survey = survey_of(inwards ? reversed(two) : two, {}, rule);
      EXPECT_TRUE(survey.front.misoriented.empty());
      EXPECT_FALSE(survey.front.undecided.has_value());
      EXPECT_EQ(survey.front.encloses, inwards == (rule == FrontRule::right_hand));
      EXPECT_EQ(survey.surface("two").closed, survey.front.encloses);
    }
  // A room with a box in it: as a room without being asked; else outside of the room, and in the box.
  const sample::Polyhedron room = sample::cube_in_cube(0.5, {0.25, 0.25, 0.25});
  EXPECT_TRUE(survey_of(room, {}, FrontRule::left_hand).front.encloses);
  EXPECT_TRUE(survey_of(room, {}, FrontRule::right_hand).front.misoriented.empty());
  EXPECT_FALSE(survey_of(room, {}, FrontRule::right_hand).front.encloses);
  for (const FrontRule rule : {FrontRule::right_hand, FrontRule::left_hand})
    EXPECT_FALSE(
        survey_of(sample::cube_in_cube(0.5, {0.25, 0.25, 0.25}, false), {}, rule).front.misoriented.empty());
  // Corners given once for each face are one corner.
  sample::Polyhedron apart = sample::cube();
  apart.vertices.insert(apart.vertices.end(), apart.vertices.begin(), apart.vertices.end());
  for (std::size_t& v : apart.faces[2]) v += 8;
  EXPECT_EQ(survey_of(apart).front.known_by, InnerSide::by_volume);
  EXPECT_EQ(survey_of(apart).front.orientation, Orientation::against_the_cross_product);
}

TEST(MeshSurvey, RefusesToGuessAtEdgesOfManyTriangles) {
  // Two cubes with an edge in common, and a cube with a fin at one of its edges.
  sample::Polyhedron two = sample::cube();
  const sample::Polyhedron other = sample::cube();
  std::vector<std::size_t> number;
  for (const Vector<double>& v : other.vertices) {
    const Vector<double> moved{v.x + 1, v.y + 1, v.z};
    const auto found = std::find(two.vertices.begin(), two.vertices.end(), moved);
    number.push_back(static_cast<std::size_t>(found - two.vertices.begin()));
    if (found == two.vertices.end()) two.vertices.push_back(moved);
  }
  for (auto face : other.faces) {
    for (std::size_t& v : face) v = number[v];
    two.faces.push_back(face);
  }
  EXPECT_TRUE(survey_of(two).front.undecided.has_value());
  EXPECT_FALSE(survey_of(reversed(two)).front.undecided.has_value());
  EXPECT_TRUE(survey_of(reversed(two)).front.encloses);
  EXPECT_FALSE(survey_of(two, {}, FrontRule::right_hand).front.encloses);
  EXPECT_TRUE(survey_of(two, {}, FrontRule::left_hand).front.encloses);
}

TEST(MeshSurvey, KnowsWhetherARoomAndWhatIsInItHaveOneInside) {
  const Vector<double> middle{0.25, 0.25, 0.25};
  const sample::Polyhedron room = sample::cube_in_cube(0.5, middle);
  EXPECT_TRUE(survey_of(room).front.misoriented.empty());
  EXPECT_FALSE(survey_of(room).obstacle().has_value());
  EXPECT_TRUE(survey_of(reversed(room)).front.misoriented.empty());
  // The box in the room runs the same way as the room: its inner normals point into the box.
  const MeshSurvey faulty = survey_of(sample::cube_in_cube(0.5, middle, false));
  EXPECT_EQ(faulty.front.misoriented, (std::vector<std::size_t>{12}));
  EXPECT_THAT(*faulty.obstacle(),
              testing::ContainsRegex("first with a corner at \\(0.[27]5, 0.[27]5, 0.[27]5\\)"));
  EXPECT_EQ(survey_of(reversed(sample::cube_in_cube(0.5, middle, false))).front.misoriented,
            (std::vector<std::size_t>{12}));
  // Two rooms side by side, and a room in a box in a room.
  EXPECT_TRUE(survey_of(sample::together(sample::cube(), sample::column({{3, 3}, {4, 3}, {3, 4}}, 1), false))
                  .front.misoriented.empty());
  sample::Polyhedron within = sample::cube();
  for (Vector<double>& v : within.vertices) v = Vector<double>{0.375, 0.375, 0.375} + 0.25 * v;
  EXPECT_TRUE(survey_of(sample::together(room, within, false)).front.misoriented.empty());
  EXPECT_EQ(survey_of(sample::together(room, within, true)).front.misoriented,
            (std::vector<std::size_t>{24}));
}

/// A tetrahedron with its faces counterclockwise as seen from outside.
sample::Polyhedron tetrahedron_of(const std::array<Vector<double>, 4>& corners) {
  sample::Polyhedron out{{corners.begin(), corners.end()}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  return orientation(corners[0], corners[1], corners[2], corners[3]) > 0 ? out : reversed(out);
}

TEST(MeshSurvey, KnowsTheInnerSideOfWhatTouchesARoomInAVertex) {
  // A tetrahedron with a vertex in a corner of a cube: there the cube winds an eighth of a time.
  const sample::Polyhedron room = sample::cube();
  const sample::Polyhedron inner =
      tetrahedron_of({{{0, 0, 0}, {0.5, 0.25, 0.25}, {0.25, 0.5, 0.25}, {0.25, 0.25, 0.5}}});
  const sample::Polyhedron outer =
      tetrahedron_of({{{0, 0, 0}, {-0.5, -0.25, -0.25}, {-0.25, -0.5, -0.25}, {-0.25, -0.25, -0.5}}});
  for (const bool inwards : {false, true}) {
    const auto survey = [&](const sample::Polyhedron& other, bool turned) {
      const sample::Polyhedron both = sample::together(room, other, turned);
      return survey_of(inwards ? reversed(both) : both, {.vertices = true});
    };
    EXPECT_EQ(survey(inner, true).topology.pinched_vertices.size(), 1U);
    EXPECT_FALSE(survey(inner, true).obstacle().has_value());
    EXPECT_EQ(survey(inner, false).front.misoriented, (std::vector<std::size_t>{12}));
    // Beside the cube it is a room of its own, or refused.
    EXPECT_EQ(survey(outer, false).obstacle().has_value(), !inwards);
    EXPECT_EQ(survey(outer, true).front.misoriented, (std::vector<std::size_t>{12}));
  }
}

TEST(MeshSurvey, KnowsTheInnerSideOfWhatNearlyTouchesAnEdge) {
  // Solid angles about the first vertex of the inner one are noise: it lies within rounding of an edge.
  const std::array<Vector<double>, 4> room{
      {{0.26618386837884622, 0.73288701824019775, 0.20985588003338332},
       {0.49011091916642946, 0.04577871662507231, 0.68814085067398756},
       {0.30287529614405156, 0.10818637931189366, 0.28247665517977882},
       {0.85383231960077544, 0.081249035715686715, 0.055921440906334316}}};
  const std::array<Vector<double>, 4> inner{{{0.35866070252239052, 0.44912674799312607, 0.40737681262154957},
                                             {0.4375, 0.34375, 0.34375},
                                             {0.4375, 0.3125, 0.34375},
                                             {0.421875, 0.3125, 0.3125}}};
  for (const Vector<double>& corner : inner)
    for (const VertexTriple& t : {VertexTriple{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}})
      ASSERT_EQ(orientation(room[t[0]], room[t[1]], room[t[2]], corner),
                -orientation(room[0], room[1], room[2], room[3]));
  const sample::Polyhedron large = tetrahedron_of(room);
  const sample::Polyhedron small = tetrahedron_of(inner);
  for (const bool inwards : {false, true}) {
    const auto survey = [&](bool turned) {
      const sample::Polyhedron both = sample::together(large, small, turned);
      return survey_of(inwards ? reversed(both) : both);
    };
    EXPECT_FALSE(survey(true).obstacle().has_value());
    EXPECT_EQ(survey(false).front.misoriented, (std::vector<std::size_t>{4}));
  }
}

TEST(MeshSurvey, KnowsTheInnerSideOfWhatTouchesARoomAlongAnEdge) {
  const sample::Polyhedron room = reversed(sample::cube());
  const sample::Polyhedron inner =
      tetrahedron_of({{{0, 0, 0}, {0, 0, 1}, {0.5, 0.25, 0.5}, {0.25, 0.5, 0.5}}});
  for (const FrontRule rule : {FrontRule::automatic, FrontRule::right_hand}) {
    const auto survey = [&](bool turned) {
      return survey_of(sample::together(room, inner, turned), {.vertices = true}, rule);
    };
    EXPECT_EQ(survey(false).topology.crowded_edges.size(), 1U);
    EXPECT_TRUE(survey(false).front.misoriented.empty());
    EXPECT_TRUE(survey(false).front.encloses);
    EXPECT_EQ(survey(true).front.misoriented, (std::vector<std::size_t>{12}));
  }
}

TEST(MisorientedComponents, RefusesWhatItCannotDecide) {
  // The second has its corners at those points of the first's faces from which rays begin.
  const TriangleMesh mesh =
      sample::mesh_of(sample::together(tetrahedron_of({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}}),
                                       tetrahedron_of({{{1, 1, 0}, {1, 0, 1}, {2, 1, 1}, {0, 1, 1}}}), true));
  const MeshTopology topology = mesh_topology(mesh);
  const auto found =
      misoriented_components(mesh, topology, Orientation::against_the_cross_product, LightOf::rooms);
  ASSERT_FALSE(found);
  EXPECT_THAT(found.reason(), HasSubstr("lies on another"));
  EXPECT_FALSE(outermost_components(mesh, topology));
}

TEST(MeshSurvey, RoundsUpHowFarCornersWereMoved) {
  sample::Polyhedron nearly = sample::cube();
  const auto corner = std::find(nearly.vertices.begin(), nearly.vertices.end(), Vector<double>{1, 1, 1});
  ASSERT_NE(corner, nearly.vertices.end());
  *corner = {1.000001, 1.000001, 1};
  // The root of 2 times 1e-6.
  EXPECT_THAT(survey_of(nearly, {.align = true}).mended.front(), HasSubstr("moved by 1.42e-6 at most"));
}

TEST(MeshSurvey, RemarksDecimalsThatDoublesDoNotHold) {
  const auto remarks = [](double far) {
    sample::Polyhedron box = sample::cube();
    for (Vector<double>& v : box.vertices) v = {3 * v.x + far, v.y, v.z};
    return survey_of(box).remarks;
  };
  for (const double near : {0.0, 0.1, 10.3, 4500000.0, 4500000.5}) EXPECT_TRUE(remarks(near).empty()) << near;
  ASSERT_EQ(remarks(4500000.1).size(), 1U);
  EXPECT_THAT(remarks(4500000.1).front(),
              HasSubstr("within 4.7e-10 of the decimals of this file, 1.5e-10 of"));
}

TEST(MeshSurvey, NamesTheObstacle) {
  for (const sample::Polyhedron& occluded :
       {sample::l_shaped_room(), sample::octahedron(-0.5), sample::glued_grid(9, 8, false)}) {
    EXPECT_FALSE(survey_of(occluded).obstacle().has_value());
    EXPECT_FALSE(survey_of(occluded).surface("mesh").unoccluded);
  }

  sample::Polyhedron turned = sample::cube();
  std::reverse(turned.faces[2].begin(), turned.faces[2].end());
  EXPECT_THAT(*survey_of(turned).obstacle(), HasSubstr("run against each other"));
  EXPECT_FALSE(survey_of(turned, {.orientation = true}).obstacle().has_value());

  sample::Polyhedron twice = sample::cube();
  twice.vertices.push_back(twice.vertices[0]);
  twice.faces[2][0] = 8;
  EXPECT_THAT(*survey_of(twice).obstacle(), HasSubstr("coordinates of another"));
  EXPECT_FALSE(survey_of(twice, {.vertices = true}).obstacle().has_value());

  sample::Polyhedron overlapping = sample::cube();
  overlapping.faces.push_back({4, 5, 6});
  EXPECT_TRUE(survey_of(overlapping).obstacle().has_value());

  // A triangle in the middle of the floor: everything lies in the boundary of the cube, some of it twice.
  sample::Polyhedron doubled = sample::cube();
  for (const Vector<double>& v :
       std::vector<Vector<double>>{{0.25, 0.125, 0}, {0.25, 0.5, 0}, {0.5, 0.125, 0}})
    doubled.vertices.push_back(v);
  doubled.faces.push_back({8, 9, 10});
  EXPECT_EQ(survey_of(doubled, {}, FrontRule::left_hand).containment.verdict, Containment::certified);
  EXPECT_THAT(*survey_of(doubled).obstacle(), HasSubstr("overlap"));

  sample::Polyhedron needle = sample::tetrahedron();
  needle.vertices.push_back({0.5, 0, 0});
  needle.faces.push_back({0, 4, 1});
  const MeshSurvey degenerate = survey_of(needle);
  EXPECT_THAT(*degenerate.obstacle(), HasSubstr("degenerate"));
  EXPECT_EQ(degenerate.containment.verdict, Containment::undecided);
  EXPECT_FALSE(survey_of(needle, {.vertices = true, .faces = true}).obstacle().has_value());
}

TEST(MeshSurvey, RefusesARoomThatABodyFills) {
  // Its faces and those of the body cover each other, whichever of the two is the first.
  for (const bool turned : {false, true})
    for (const FrontRule rule : {FrontRule::right_hand, FrontRule::left_hand}) {
      const sample::Polyhedron filled = sample::cube_in_cube(1, {0, 0, 0}, true);
      try {
        const MeshSurvey survey = survey_of(turned ? reversed(filled) : filled, {}, rule);
        EXPECT_FALSE(survey.mesh.triangles.empty());
      } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("nothing is left"));
      }
    }
  EXPECT_THROW((void)survey_of(sample::cube_in_cube(1, {0, 0, 0}, true)), InputError);
}

TEST(MeshSurvey, RefusesASurfaceWithoutSides) {
  try {
    (void)survey_of(sample::glued_grid(7, 6, true));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("edge from ("));
    EXPECT_THAT(error.what(), HasSubstr("not orientable"));
  }
}

TEST(MeshSurvey, MakesASurfaceOfWhatItFound) {
  const MeshSurvey survey = survey_of(sample::cube());
  const Surface surface = survey.surface("cube.off");
  EXPECT_EQ(surface.chart_count(), 12U);
  EXPECT_EQ(surface.piece_names().size(), 6U);
  EXPECT_TRUE(surface.closed);
  EXPECT_TRUE(surface.unoccluded);
}

}  // namespace
}  // namespace radcert
