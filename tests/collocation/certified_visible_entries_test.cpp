// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified/certified_visible_entries.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "radcert/closed_form/plane_element.h"
#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/collocation/assembly.h"
#include "radcert/collocation/nodes.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/smooth_components.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/scalar/ball.h"
#include "radcert/surface/mesh_surface.h"
#include "tests/collocation/certified_samples.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/visibility/sample_scenes.h"

namespace radcert {
namespace {

using Elements = std::vector<SceneElement>;
using Corners = std::array<ParameterPoint<Rational>, 3>;

/// Every triangle of the scene, as it is or cut into four.
Elements elements_of(const Scene& scene, bool in_four = false) {
  const Rational half(1, 2);
  const std::vector<Corners> quarters{{{{0, 0}, {half, 0}, {0, half}}},
                                      {{{half, 0}, {1, 0}, {half, half}}},
                                      {{{0, half}, {half, half}, {0, 1}}},
                                      {{{half, half}, {0, half}, {half, 0}}}};
  Elements elements;
  for (std::size_t k = 0; k < scene.triangle_count(); ++k) {
    if (in_four) {
      for (const Corners& corners : quarters) elements.push_back({k, corners});
    } else {
      elements.push_back({.triangle = k});
    }
  }
  return elements;
}

std::vector<double> ones(const Elements& elements, const LagrangeFunctions& functions) {
  return std::vector<double>(elements.size() * functions.size(), 1.0);
}

CertifiedEntries entries_of(const Scene& scene, const Elements& elements,
                            const LagrangeFunctions& functions) {
  return certified_visible_entries(scene, elements, functions, ones(elements, functions)).value();
}

Scene room_of(const sample::Polyhedron& room) { return Scene(sample::mesh_of(sample::turned(room))); }

TEST(CertifiedVisibleEntries, RowsOfEnclosuresContainOne) {
  // In a closed room every node sees the whole of its half space, whatever hides what.
  for (const int degree : {0, 1}) {
    const LagrangeFunctions functions = inset_functions(degree, Rational(1, 6));
    for (const auto& [room, what] :
         {std::pair{sample::l_shaped_room(), "an L"}, std::pair{sample::octahedron(-0.5), "a dent"},
          std::pair{sample::cube_in_cube(0.5, {0.25, 0.125, 0.0625}), "cubes"},
          std::pair{sample::cube_in_cube(0.5, {0.25, 0.25, 0x1p-30}), "a gap"}}) {
      const Scene scene = room_of(room);
      const CertifiedEntries matrix = entries_of(scene, elements_of(scene), functions);
      for (std::size_t i = 0; i < matrix.entries.rows(); ++i) {
        Rational sum = 0;
        Rational radius = 0;
        for (std::size_t j = 0; j < matrix.entries.columns(); ++j) {
          sum += Rational::exactly(matrix.entries(i, j));
          radius += Rational::exactly(matrix.radius(i, j));
        }
        EXPECT_LE(abs(sum - Rational(1)), radius)
            << what << ", degree " << degree << ", row " << i << ": " << (sum - Rational(1)).to_double();
        EXPECT_LE(radius.to_double(), 1e-13) << what << ", degree " << degree << ", row " << i;
      }
    }
  }
}

/// A triangle on the floor, one on the ceiling, and a square of two triangles between that hides a square of
/// the latter from every point of the former.
Scene screened_triangles() {
  const sample::Polyhedron bodies{{{0, 0, 0},
                                   {1, 0, 0},
                                   {0, 1, 0},
                                   {-4, -4, 1},
                                   {-4, 8, 1},
                                   {8, -4, 1},
                                   {0.25, 0.25, 0.5},
                                   {0.625, 0.25, 0.5},
                                   {0.625, 0.625, 0.5},
                                   {0.25, 0.625, 0.5}},
                                  {{0, 1, 2}, {3, 4, 5}, {6, 7, 8, 9}}};
  return Scene(sample::fans_of(bodies));
}

TEST(CertifiedVisibleEntries, EncloseTheClosedFormLessThatOfAShadow) {
  // Seen from (x, y, 0) the square [1/4, 5/8]^2 at half the height covers [1/2 - x, 5/4 - x] x [1/2 - y, 5/4
  // - y] of the ceiling, which lies inside the triangle: the integral is that over the triangle less that
  // over this square.
  const BallPrecision scope(128);
  const Scene scene = screened_triangles();
  for (const int degree : {0, 1, 2, 3})
    for (const bool in_four : {false, true}) {
      const LagrangeFunctions functions = inset_functions(degree, Rational(1, 7));
      const std::size_t p = functions.size();
      Elements elements;
      for (const SceneElement& element : elements_of(scene, in_four))
        if (element.triangle < 2) elements.push_back(element);
      std::vector<double> reflectivity = ones(elements, functions);
      for (std::size_t i = 0; i < reflectivity.size(); ++i)
        reflectivity[i] = 1.0 / static_cast<double>(i + 2);
      const CertifiedEntries matrix =
          certified_visible_entries(scene, elements, functions, reflectivity).value();
      const auto parameters = [&](std::size_t place) {
        const Corners& c = elements[place / p].corners;
        const Barycentric<Rational>& x = functions.nodes()[place % p];
        return x.x[0] * c[0] + x.x[1] * c[1] + x.x[2] * c[2];
      };
      const Vector<Rational> origin{-4, -4, 1};
      const Vector<Rational> first{0, 12, 0};
      const Vector<Rational> second{12, 0, 0};
      for (std::size_t row = 0; row < matrix.entries.rows(); row += 2) {
        if (elements[row / p].triangle != 0) continue;
        const ParameterPoint<Rational> at = parameters(row);
        const Vector<Rational> node{at.s, at.t, 0};
        const auto moments_over = [&](const PolygonLoop& loop) {
          return point_to_polygon_moments<Ball>(node, {0, 0, 1},
                                                plane_polygon(origin, first, second, {loop}).value(), degree);
        };
        // s runs along y and t along x.
        const auto place = [&](const Rational& x, const Rational& y) {
          return ParameterPoint<Rational>{(y + 4) / 12, (x + 4) / 12};
        };
        const Rational left = Rational(1, 2) - at.s;
        const Rational right = Rational(5, 4) - at.s;
        const Rational low = Rational(1, 2) - at.t;
        const Rational high = Rational(5, 4) - at.t;
        const std::vector<Ball> all = moments_over({{0, 0}, {1, 0}, {0, 1}});
        const std::vector<Ball> hidden =
            moments_over({place(left, low), place(right, low), place(right, high), place(left, high)});
        // The l_j of all elements reproduce each monomial: sum_j q_j^m entry_j is its integral.
        for (int a = 0; a <= degree; ++a)
          for (int b = 0; a + b <= degree; ++b) {
            Ball sum = 0;
            Ball allowed = 0;
            for (std::size_t column = 0; column < matrix.entries.columns(); ++column) {
              if (elements[column / p].triangle != 1) continue;
              const ParameterPoint<Rational> q = parameters(column);
              const Ball weight(power(q.s, a) * power(q.t, b));
              sum += weight * Ball(matrix.entries(row, column));
              allowed += abs(weight) * Ball(matrix.radius(row, column));
            }
            const std::size_t moment = PlanePolynomial<Rational>::place(a, b);
            const Ball truth = Ball(reflectivity[row]) / Ball::pi() * (all[moment] - hidden[moment]);
            EXPECT_TRUE(certainly_at_most(abs(sum - truth), allowed))
                << "degree " << degree << ", row " << row << ", s^" << a << " t^" << b << ": "
                << (sum - truth).to_text() << " beyond " << allowed.to_text();
            EXPECT_GT(allowed.to_double(), 1e-14 * std::abs(truth.to_double()));
            EXPECT_LT(allowed.to_double(), degree < 3 ? 2e-13 : 2e-12);
          }
      }
    }
}

TEST(CertifiedVisibleEntries, CountTheRoundingsOfSumsOverManyParts) {
  // Two dozen slats leave strips of the ceiling that are about as large as each other: the sum over them is
  // rounded once a strip, by a unit of what is reached of it, which makes half as many units of the whole as
  // there are strips. Without them the accuracy of the integrals and five units for the entry would be all.
  sample::Polyhedron bodies{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-4, -4, 1}, {-4, 8, 1}, {8, -4, 1}},
                            {{0, 1, 2}, {3, 4, 5}}};
  for (int k = -12; k < 12; ++k) {
    const double low = 0.09375 * k;
    const std::size_t first = bodies.vertices.size();
    for (const auto& [x, y] :
         {std::pair{-8.0, low}, {8.0, low}, {8.0, low + 0.046875}, {-8.0, low + 0.046875}})
      bodies.vertices.push_back({x, y, 0.5});
    bodies.faces.push_back({first, first + 1, first + 2, first + 3});
  }
  const Scene scene(sample::fans_of(bodies));
  const Elements elements{{.triangle = 0}, {.triangle = 1}};
  const CertifiedEntries matrix = entries_of(scene, elements, inset_functions(0, 0));
  constexpr double unit = unit_roundoff<double>();
  EXPECT_GT(matrix.entries(0, 1), 0.2);
  EXPECT_GE(matrix.radius(0, 1), matrix.entries(0, 1) * (PlaneElement::usual_accuracy + 9 * unit));
  EXPECT_LE(matrix.radius(0, 1), matrix.entries(0, 1) * (PlaneElement::usual_accuracy + 30 * unit));
}

TEST(CertifiedVisibleEntries, AgreeWithTheRoundedMatrix) {
  // The same nodes in doubles: collocation that knows its parts' corners to 2^-51.
  const LagrangeFunctions functions = inset_functions(1, Rational(1, 8));
  const InsetBasis<double> basis(1, 0.125);
  for (const sample::Polyhedron& room :
       {sample::l_shaped_room(), sample::cube_in_cube(0.5, {0.25, 0.125, 0.0625})}) {
    const TriangleMesh mesh = sample::mesh_of(sample::turned(room));
    const SmoothComponents components = smooth_components(mesh, mesh_topology(mesh), 30);
    const Surface surface = mesh_surface(
        "mesh", mesh, components.of_piece, piece_names(mesh, components),
        {.orientation = Orientation::along_the_cross_product, .closed = true, .unoccluded = false});
    const Triangulation triangulation = triangulate(surface, 0);
    const auto nodes = collocation_nodes<double>(surface, triangulation, basis);
    const auto rounded =
        assemble<double>(surface, triangulation, basis, nodes, std::vector<double>(nodes.size(), 1.0));
    Elements elements;
    for (const ParameterTriangle& triangle : triangulation.triangles) {
      SceneElement element{.triangle = triangle.chart};
      for (std::size_t k = 0; k < 3; ++k)
        element.corners[k] = {Rational::exactly(triangle.vertices[k].s),
                              Rational::exactly(triangle.vertices[k].t)};
      elements.push_back(element);
    }
    const CertifiedEntries matrix = entries_of(Scene(mesh), elements, functions);
    ASSERT_EQ(matrix.entries.rows(), nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j < nodes.size(); ++j)
        EXPECT_NEAR(matrix.entries(i, j), rounded.entries(i, j), rounded.row_radius[i] + matrix.radius(i, j))
            << i << " " << j;
  }
}

TEST(CertifiedVisibleEntries, OfAMeshWhoseChartsAreReversedAskForSymmetricFunctions) {
  const TriangleMesh mesh = sample::mesh_of(sample::l_shaped_room());
  const SmoothComponents components = smooth_components(mesh, mesh_topology(mesh), 30);
  const Surface reversed = mesh_surface(
      "mesh", mesh, components.of_piece, piece_names(mesh, components),
      {.orientation = Orientation::against_the_cross_product, .closed = true, .unoccluded = false});
  const auto refused = certified_mesh_entries(reversed, triangulate(reversed, 0), lopsided_functions());
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.reason().find("their functions"), std::string::npos);
}

TEST(CertifiedVisibleEntries, AreTheUnoccludedOnesWhereNothingHides) {
  const Scene scene = sample::cube_room();
  const LagrangeFunctions functions = inset_functions(2, Rational(1, 6));
  const Elements elements = elements_of(scene);
  std::vector<ExactTriangle> triangles;
  for (std::size_t k = 0; k < scene.triangle_count(); ++k) {
    const auto corners = scene.corners(k);
    triangles.push_back({exactly(corners[0]), exactly(corners[1]), exactly(corners[2])});
  }
  const CertifiedEntries seen = entries_of(scene, elements, functions);
  const CertifiedEntries assumed = certified_entries(triangles, functions, ones(elements, functions)).value();
  for (std::size_t i = 0; i < seen.entries.rows(); ++i)
    for (std::size_t j = 0; j < seen.entries.columns(); ++j) {
      EXPECT_LE(std::abs(seen.entries(i, j) - assumed.entries(i, j)),
                (seen.radius(i, j) + assumed.radius(i, j)) * (1 + 1e-12))
          << i << " " << j;
      EXPECT_GE(seen.radius(i, j), assumed.radius(i, j) / 2) << i << " " << j;
      EXPECT_LE(seen.radius(i, j), 2 * assumed.radius(i, j)) << i << " " << j;
    }
}

TEST(CertifiedVisibleEntries, VanishWhereNothingIsSeen) {
  // The inner cube hides walls from each other near its faces, and turns its own faces away from each other.
  const Scene scene = sample::cube_in_cube(0.25);
  const LagrangeFunctions functions = inset_functions(1, Rational(1, 6));
  const CertifiedEntries matrix = entries_of(scene, elements_of(scene), functions);
  for (std::size_t i = 36; i < 72; ++i)
    for (std::size_t j = 36; j < 72; ++j) {
      EXPECT_EQ(matrix.entries(i, j), 0) << i << " " << j;
      EXPECT_LE(matrix.radius(i, j), 1e-300) << i << " " << j;
    }
}

TEST(CertifiedVisibleEntries, AreTheSameForEveryNumberOfThreads) {
  const Scene scene = room_of(sample::cube_in_cube(0.5, {0.25, 0.125, 0.0625}));
  const LagrangeFunctions functions = inset_functions(0, 0);
  const auto with_threads = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return numbers_of(entries_of(scene, elements_of(scene), functions));
  };
  EXPECT_EQ(with_threads(1), with_threads(3));
}

TEST(CertifiedVisibleEntries, RefuseNodesThatAreDoublesInNoUnit) {
  sample::Polyhedron room = sample::l_shaped_room();
  for (Vector<double>& v : room.vertices) v = (1.0 / 3) * v;
  const Scene scene = room_of(room);
  const Elements elements = elements_of(scene);
  const LagrangeFunctions functions = inset_functions(1, Rational(1, 7));
  EXPECT_FALSE(certified_visible_entries(scene, elements, functions, ones(elements, functions)).has_value());
}

TEST(CertifiedVisibleEntries, RefuseElementsThatAreNone) {
  const Scene scene = sample::cube_room();
  const LagrangeFunctions functions = inset_functions(0, 0);
  const auto refused = [&](const SceneElement& element) {
    const std::vector<double> one(1, 1.0);
    EXPECT_THROW(static_cast<void>(certified_visible_entries(scene, std::span(&element, 1), functions, one)),
                 ContractViolation);
  };
  refused({.triangle = 12});
  refused({.triangle = 0, .corners = {{{0, 0}, {0, 1}, {1, 0}}}});
  refused({.triangle = 0, .corners = {{{0, 0}, {Rational(1, 2), Rational(1, 2)}, {1, 1}}}});
  refused({.triangle = 0, .corners = {{{0, 0}, {1, 0}, {Rational(1, 2), 1}}}});
  const Elements elements = elements_of(scene);
  EXPECT_THROW(
      static_cast<void>(certified_visible_entries(scene, elements, functions, std::vector<double>(3, 1.0))),
      ContractViolation);
  std::vector<double> reflectivity = ones(elements, functions);
  reflectivity[1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(certified_visible_entries(scene, elements, functions, reflectivity)),
               ContractViolation);
}

}  // namespace
}  // namespace radcert
