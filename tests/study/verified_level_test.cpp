// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/verified_level.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "problems.h"
#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/core/parallel.h"
#include "radcert/geometry/orientation.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/surface/mesh_surface.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

using testing::by_piece;
using testing::everywhere;
using ::testing::HasSubstr;
using testing::sample_problem;
using testing::with_basis;
using testing::with_emission;
using testing::with_solution;

/// Of the truth: more than 100 decimal digits.
constexpr long digits_in_bits = 400;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

Problem verified(Problem problem) {
  problem.solver.name = "verified";
  return problem;
}

LevelOutcome proved_level(const Problem& problem, int level) {
  return verified_level(problem, level, reference::applied_operator);
}

std::string refusal(const Problem& problem, int level = 0) {
  try {
    static_cast<void>(proved_level(problem, level));
  } catch (const AccuracyNotReached& error) {
    return error.what();
  }
  return "(none)";
}

/// a + b x + c y z with a function of its own a piece.
struct Data {
  Rational constant;
  Rational by_x;
  Rational by_yz;

  Rational at(const Vector<Rational>& q) const { return constant + by_x * q.x + by_yz * (q.y * q.z); }
  std::string text() const {
    return "(" + constant.to_text() + ") + (" + by_x.to_text() + ")*x + (" + by_yz.to_text() + ")*y*z";
  }
};

/// A tetrahedron of triangles, each a piece of its own.
struct Tetrahedron {
  TriangleMesh mesh;
  std::array<Rational, 4> reflectivity;
  Data data;
  bool has_solution = false;
  int degree = 0;
  Rational alpha;

  std::vector<std::string> names() const { return {"a", "b", "c", "d"}; }

  Problem problem() const {
    const std::array<std::size_t, 4> pieces{0, 1, 2, 3};
    std::vector<std::pair<std::string, std::string>> rho;
    for (std::size_t k = 0; k < 4; ++k) rho.emplace_back(names()[k], reflectivity[k].to_text());
    Problem problem = with_basis(sample_problem("tetrahedron"), degree, alpha);
    problem.surface = {.name = "random", .parameters = {}, .mesh = MeshChoice{}};
    problem.surface.mesh->surface = std::make_shared<const Surface>(mesh_surface(
        "random", mesh, pieces, names(),
        {.orientation = Orientation::against_the_cross_product, .closed = true, .unoccluded = true}));
    problem.reflectivity = by_piece(rho);
    return verified(has_solution ? with_solution(problem, data.text()) : with_emission(problem, data.text()));
  }

  /// Corners counterclockwise as seen from outside, in the order of the mesh.
  std::array<Vector<Rational>, 3> corners(std::size_t k) const {
    const auto c = mesh.corners(k);
    return {exactly(c[0]), exactly(c[1]), exactly(c[2])};
  }
};

Rational fraction(std::mt19937_64& random, long largest, long denominator) {
  const long range = 2 * largest + 1;
  return Rational(static_cast<long>(random() % static_cast<unsigned long>(range)) - largest) /
         Rational(denominator);
}

/// Coordinates of few digits, or of all that a double has; some of the tetrahedra are flat.
Tetrahedron random_tetrahedron(std::mt19937_64& random) {
  Tetrahedron t;
  const bool short_coordinates = random() % 4 != 0;
  const double flat = random() % 4 == 0 ? 1.0 / 64 : 1;
  const auto coordinate = [&] {
    return short_coordinates ? static_cast<double>(random() % 17) / 8 - 1
                             : static_cast<double>(random() >> 11U) * 0x1p-52 - 1;
  };
  int side = 0;
  while (side == 0) {
    t.mesh.vertices.clear();
    for (int i = 0; i < 4; ++i) t.mesh.vertices.push_back({coordinate(), coordinate(), flat * coordinate()});
    const Vector<Rational> origin = exactly(t.mesh.vertices[0]);
    const auto from_origin = [&](std::size_t i) { return exactly(t.mesh.vertices[i]) - origin; };
    const Rational volume = dot(cross(from_origin(1), from_origin(2)), from_origin(3));
    side = abs(volume) > Rational(1, 1000) ? volume.sign() : 0;
  }
  if (side < 0) std::swap(t.mesh.vertices[0], t.mesh.vertices[1]);
  t.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  t.mesh.group = {0, 0, 0, 0};
  t.mesh.group_names = {""};
  t.mesh.face = {0, 1, 2, 3};
  const std::array<Rational, 5> reflectivities{Rational(0), Rational(1, 3), Rational(1, 2), Rational(9, 10),
                                               Rational(99, 100)};
  for (Rational& rho : t.reflectivity) rho = reflectivities[random() % reflectivities.size()];
  t.data = {fraction(random, 30, 7), fraction(random, 30, 10),
            random() % 2 == 0 ? 0 : fraction(random, 9, 4)};
  t.has_solution = random() % 2 == 0;
  t.degree = static_cast<int>(random() % 2);
  t.alpha = std::array<Rational, 3>{Rational(1, 6), Rational(1, 10), Rational(3, 20)}[random() % 3];
  return t;
}

using Monomials = std::array<Ball, 6>;

/// A function l_j of degree at most 2 from its values at the lattice of degree 2, in monomials of s = x_3 and
/// t = x_2.
Monomials monomials(const LagrangeFunctions& functions, std::size_t j) {
  std::vector<Rational> at(functions.size());
  const auto value = [&](const Rational& s, const Rational& t) {
    functions.values({{Rational(1) - s - t, t, s}}, at);
    return at[j];
  };
  const Rational half(1, 2);
  const Rational f = value(0, 0);
  const Rational ss = Rational(2) * (f + value(1, 0) - Rational(2) * value(half, 0));
  const Rational tt = Rational(2) * (f + value(0, 1) - Rational(2) * value(0, half));
  const Rational s = value(1, 0) - f - ss;
  const Rational t = value(0, 1) - f - tt;
  const Rational st = Rational(4) * (value(half, half) - f - half * (s + t) - Rational(1, 4) * (ss + tt));
  return {Ball(f), Ball(s), Ball(t), Ball(ss), Ball(st), Ball(tt)};
}

/// (I - K) and what it is solved for, in balls of many digits, by code that the level does not run: moments
/// element by element, against coefficients that interpolate.
struct Digits {
  std::vector<std::vector<Ball>> matrix;
  std::vector<Ball> u;  ///< with a solution
  std::vector<Ball> emission;
  std::vector<Ball> difference;  ///< K(I - P_n)u

  explicit Digits(const Tetrahedron& t) {
    const LagrangeFunctions functions = lagrange_functions(inset_nodes(t.degree, t.alpha)).value();
    const LagrangeFunctions quadratic = lagrange_functions(inset_nodes(2, Rational(0))).value();
    std::vector<Monomials> linear_monomials;
    std::vector<Monomials> quadratic_monomials;
    for (std::size_t j = 0; j < functions.size(); ++j) linear_monomials.push_back(monomials(functions, j));
    for (std::size_t j = 0; j < quadratic.size(); ++j) quadratic_monomials.push_back(monomials(quadratic, j));
    const std::size_t p = functions.size();
    const std::size_t n = 4 * p;
    matrix.assign(n, std::vector<Ball>(n));
    std::vector<Vector<Rational>> nodes;
    std::vector<Ball> values;
    for (std::size_t k = 0; k < 4; ++k)
      for (const Barycentric<Rational>& q : functions.nodes()) {
        const auto c = t.corners(k);
        nodes.push_back(q.x[0] * c[0] + q.x[1] * c[1] + q.x[2] * c[2]);
        values.emplace_back(t.data.at(nodes.back()));
      }
    for (std::size_t i = 0; i < n; ++i) {
      const auto from = t.corners(i / p);
      const Vector<Rational> inwards = cross(from[2] - from[0], from[1] - from[0]);
      const Ball factor = Ball(t.reflectivity[i / p]) / Ball::pi();
      Ball ku = 0;
      Ball k_pn_u = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        // Seen from inside: the first parameter goes along the second side.
        const auto c = t.corners(k);
        const PlanePolygon polygon =
            plane_polygon(c[0], c[2] - c[0], c[1] - c[0], {{{0, 0}, {1, 0}, {0, 1}}}).value();
        const std::vector<Ball> moments = point_to_polygon_moments<Ball>(nodes[i], inwards, polygon, 2);
        const auto integral = [&](const Monomials& f) {
          Ball sum = 0;
          for (std::size_t m = 0; m < f.size(); ++m) sum += f[m] * moments[m];
          return sum;
        };
        for (std::size_t j = 0; j < p; ++j) {
          const Ball entry = factor * integral(linear_monomials[j]);
          matrix[i][k * p + j] = Ball(i == k * p + j ? 1 : 0) - entry;
          k_pn_u += entry * values[k * p + j];
        }
        for (std::size_t j = 0; j < quadratic.size(); ++j) {
          const Barycentric<Rational>& q = quadratic.nodes()[j];
          ku += factor * integral(quadratic_monomials[j]) *
                Ball(t.data.at(q.x[0] * c[0] + q.x[1] * c[1] + q.x[2] * c[2]));
        }
      }
      if (t.has_solution) {
        u.push_back(values[i]);
        emission.push_back(values[i] - ku);
        difference.push_back(ku - k_pn_u);
      } else {
        emission.push_back(values[i]);
      }
    }
  }
};

double size(const Ball& x) { return abs(x).upper_double(); }

/// The solutions for several right-hand sides, by elimination with pivots of the largest midpoint.
std::vector<std::vector<Ball>> eliminated(std::vector<std::vector<Ball>> a,
                                          std::vector<std::vector<Ball>> b) {
  const std::size_t n = a.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t i = c; i < n; ++i)
      if (size(a[i][c]) > size(a[pivot][c])) pivot = i;
    std::swap(a[c], a[pivot]);
    for (std::vector<Ball>& side : b) std::swap(side[c], side[pivot]);
    for (std::size_t i = c + 1; i < n; ++i) {
      const Ball factor = a[i][c] / a[c][c];
      for (std::size_t j = c; j < n; ++j) a[i][j] -= factor * a[c][j];
      for (std::vector<Ball>& side : b) side[i] -= factor * side[c];
    }
  }
  for (std::vector<Ball>& side : b)
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t j = i + 1; j < n; ++j) side[i] -= a[i][j] * side[j];
      side[i] /= a[i][i];
    }
  return b;
}

double condition(const std::vector<std::vector<Ball>>& a) {
  const std::size_t n = a.size();
  std::vector<std::vector<Ball>> identity(n, std::vector<Ball>(n));
  for (std::size_t i = 0; i < n; ++i) identity[i][i] = 1;
  const std::vector<std::vector<Ball>> columns = eliminated(a, identity);
  double norm = 0;
  double inverse_norm = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double row = 0;
    double inverse_row = 0;
    for (std::size_t j = 0; j < n; ++j) {
      row += size(a[i][j]);
      inverse_row += size(columns[j][i]);
    }
    norm = std::max(norm, row);
    inverse_norm = std::max(inverse_norm, inverse_row);
  }
  return norm * inverse_norm;
}

Ball largest(const std::vector<Ball>& values) {
  Ball most = 0;
  for (const Ball& value : values) most = max(most, abs(value));
  return most;
}

void expect_contains(const Approximation& figure, const Ball& truth, const std::string& what) {
  EXPECT_TRUE(figure.guaranteed) << what;
  ASSERT_TRUE(figure.has_radius()) << what;
  EXPECT_TRUE(overlaps(truth, widened(Ball(figure.value), Ball(figure.radius))))
      << what << ": " << truth.to_text() << " is not in " << figure.value << " +- " << figure.radius;
}

TEST(VerifiedLevel, EnclosesTheSolutionInHundredDigitsAndLittleElse) {
  std::mt19937_64 random(2026);
  std::vector<double> widths;
  for (int trial = 0; trial < 200; ++trial) {
    const Tetrahedron t = random_tetrahedron(random);
    const LevelOutcome level = proved_level(t.problem(), 0);
    const std::string what = "trial " + std::to_string(trial);
    const BallPrecision scope(digits_in_bits);
    const Digits truth(t);
    const std::vector<Ball> u_n = eliminated(truth.matrix, {truth.emission}).front();
    ASSERT_EQ(level.nodes.size(), u_n.size());
    const double size_of_u_n = size(largest(u_n));
    const double cond = condition(truth.matrix);
    std::vector<Ball> errors;
    for (std::size_t i = 0; i < u_n.size(); ++i) {
      EXPECT_LT(u_n[i].radius(), 1e-100 * (1 + size_of_u_n)) << "the truth has its digits";
      const double radius = level.nodes[i].u_n.radius;
      EXPECT_TRUE(certainly_at_most(abs(u_n[i] - Ball(level.nodes[i].u_n.value)), Ball(radius)))
          << what << ", node " << i << ": " << u_n[i].to_text() << " is not in " << level.nodes[i].u_n.value
          << " +- " << radius;
      EXPECT_LE(radius, level.result.solution_radius);
      if (size_of_u_n > 0) widths.push_back(radius / (epsilon * cond * size_of_u_n));
      if (t.has_solution) errors.push_back(truth.u[i] - u_n[i]);
    }
    EXPECT_LT(level.result.verified->theta, 1);
    EXPECT_EQ(level.result.norm_K.value,
              std::max_element(t.reflectivity.begin(), t.reflectivity.end())->to_double());
    ASSERT_EQ(level.result.node_error.has_value(), t.has_solution);
    if (!t.has_solution) continue;
    expect_contains(*level.result.node_error, largest(errors), what + ", |u - u_n|");
    expect_contains(*level.result.discretisation_error, largest(truth.difference), what + ", |K(I-P_n)u|");
    ASSERT_TRUE(level.result.uniform_error.has_value());
    EXPECT_FALSE(level.result.uniform_error->guaranteed);
  }
  std::nth_element(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2),
                   widths.end());
  EXPECT_LT(widths[widths.size() / 2], 1000);
}

TEST(VerifiedLevel, ContainsTheCellsOfTheCube) {
  // The figures of the cube at two levels, to more digits than printed, by solvers whose radii are estimates.
  Problem cube = verified(with_solution(sample_problem("cube"), "x^2 + y^2 + z^2"));
  const LevelResult result = proved_level(cube, 1).result;
  EXPECT_NEAR(result.discretisation_error->value, 1.03521011e-3, 1e-10);
  EXPECT_LT(result.discretisation_error->radius, 1e-13);
  EXPECT_LT(result.node_error->radius, 1e-12);
  EXPECT_TRUE(result.norm_K.guaranteed);
}

TEST(VerifiedLevel, IsExactForPolynomialsOfTheBasis) {
  // P_n u = u: there is no discretisation error, and the enclosure must say so.
  for (const char* name : {"cube", "two_squares", "tetrahedron"}) {
    const Problem problem =
        verified(with_solution(with_basis(sample_problem(name), 1, Rational(1, 10)), "1 + x - 2*y/3 + z"));
    const LevelResult result = proved_level(problem, 0).result;
    for (const Approximation& figure : {*result.discretisation_error, *result.node_error}) {
      EXPECT_LE(figure.value, figure.radius) << name;
      EXPECT_LT(figure.radius, 1e-11) << name;
    }
  }
}

Problem on_roof(int power, int degree_of_geometry) {
  Problem problem = with_solution(sample_problem("two_piece", {{"p", Rational(power)}}), "1/(1 + x^2 + z)");
  problem.quadrature.tolerance = Rational(1, 10000000000L);
  if (degree_of_geometry > 0) {
    problem.geometry = InterpolatedGeometry{};
    problem.geometry->degree = degree_of_geometry;
  }
  return verified(problem);
}

TEST(VerifiedLevel, IsThatOfTheSurfaceWhereTheInterpolantIs) {
  const LevelResult exact = proved_level(on_roof(2, 0), 0).result;
  const LevelResult quadratic = proved_level(on_roof(2, 2), 0).result;
  const LevelResult cubic_roof = proved_level(on_roof(3, 0), 0).result;
  const LevelResult its_interpolant = proved_level(on_roof(3, 2), 0).result;
  for (const auto figure : {&LevelResult::discretisation_error, &LevelResult::node_error}) {
    const auto distance = [figure](const LevelResult& a, const LevelResult& b) {
      return std::abs((a.*figure)->value - (b.*figure)->value);
    };
    double radii = 0;
    for (const LevelResult* result : {&exact, &quadratic, &cubic_roof, &its_interpolant}) {
      EXPECT_TRUE((result->*figure)->guaranteed);
      radii += (result->*figure)->radius;
    }
    EXPECT_LT(radii, 1e-8);
    EXPECT_LE(distance(exact, quadratic), radii);
    EXPECT_GT(distance(cubic_roof, its_interpolant), 1e-3);
  }
  // Thirds are no doubles.
  EXPECT_THAT(refusal(on_roof(3, 3)), ::testing::HasSubstr("rounded to double"));
}

TEST(VerifiedLevel, HasTheSameBitsForEveryNumberOfThreads) {
  const Problem problem =
      verified(with_solution(with_basis(sample_problem("cube"), 2, Rational(1, 10)), "x*y + z^3"));
  const auto with_threads = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    std::vector<double> numbers;
    for (const NodeValue& node : proved_level(problem, 0).nodes) {
      numbers.push_back(node.u_n.value);
      numbers.push_back(node.u_n.radius);
    }
    return numbers;
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
}

TEST(VerifiedLevel, RefusesWhatHasNoGuarantee) {
  Problem interpolated = verified(sample_problem("sphere"));
  interpolated.geometry = InterpolatedGeometry{};
  EXPECT_THAT(refusal(interpolated), HasSubstr("interpolated geometry is not known exactly"));
  interpolated.geometry->data = DataPoints::interpolant;
  EXPECT_THAT(refusal(interpolated), HasSubstr("posed on an interpolant"));

  Tetrahedron t;
  std::mt19937_64 random(7);
  t = random_tetrahedron(random);
  Problem occluded = with_solution(t.problem(), "1 + x");
  Surface hidden = *occluded.surface.mesh->surface;
  hidden.unoccluded = false;
  occluded.surface.mesh->surface = std::make_shared<const Surface>(std::move(hidden));
  EXPECT_THAT(refusal(occluded), HasSubstr("hide each other"));

  // Finite at every node, and without a value between them.
  EXPECT_THAT(refusal(verified(with_solution(sample_problem("two_squares"), "sqrt((x - 1/2)^2 - 1/10000)"))),
              ::testing::AllOf(HasSubstr("Ku is not enclosed"), HasSubstr("not shown to be analytic")));
  // 1 as far as any number of digits shows.
  Problem nearly = verified(sample_problem("two_squares"));
  nearly.reflectivity = everywhere("sin(x)^2 + cos(x)^2");
  EXPECT_THAT(refusal(nearly), HasSubstr("is not proved to lie in [0, 1]"));
  // Below 1 at every node, and 1 at a corner.
  Problem up_to_one = verified(sample_problem("cube"));
  up_to_one.reflectivity = everywhere("1 - (x^2 + y^2 + z^2)/10");
  EXPECT_THAT(refusal(up_to_one), HasSubstr("norm of K is not proved to be below 1"));
  up_to_one.reflectivity = everywhere("9/10 - x*y/2");
  EXPECT_EQ(refusal(up_to_one), "(none)");
  // On an open surface with u given the norm is not needed; with E given it is.
  Problem open = verified(sample_problem("two_squares"));
  open.reflectivity = everywhere("1");
  EXPECT_EQ(refusal(open), "(none)");
  EXPECT_THAT(refusal(with_emission(open, "1")), HasSubstr("norm of K is not proved to be below 1"));
}

TEST(VerifiedLevel, RefusesRowsThatAreProvedNotToBeOneOnAClosedSurface) {
  // A tetrahedron of which a face is missing, and which is said to be closed: from where it is missing
  // nothing comes, so that rows are less than 1.
  std::mt19937_64 random(7);
  Tetrahedron t = random_tetrahedron(random);
  for (const bool has_solution : {false, true}) {
    t.has_solution = has_solution;
    Problem problem = t.problem();
    EXPECT_EQ(refusal(problem), "(none)");
    TriangleMesh open = t.mesh;
    open.triangles.pop_back();
    open.group.pop_back();
    open.face.pop_back();
    problem.surface.mesh->surface = std::make_shared<const Surface>(mesh_surface(
        "open", open, std::vector<std::size_t>{0, 1, 2}, std::vector<std::string>{"a", "b", "c"},
        {.orientation = Orientation::against_the_cross_product, .closed = true, .unoccluded = true}));
    problem.reflectivity = everywhere("1/2");
    EXPECT_THAT(refusal(problem), HasSubstr("where it must be 1"));
  }
}

TEST(VerifiedLevel, HoldsPeaksBetweenTheNodes) {
  // At the nodes the second is 0 as far as doubles show; both are large where complex numbers enter the
  // bounds.
  for (const std::string peak :
       {"exp(-1000*((x-0.3)^2+(y-0.4)^2+z^2))", "exp(-10000*((x-0.3)^2+(y-0.4)^2+z^2))",
        "1+exp(-100*((x-0.3)^2+(y-0.4)^2+z^2))"})
    EXPECT_EQ(refusal(verified(with_solution(sample_problem("cube"), peak))), "(none)") << peak;
}

/// A closed room of one piece, its normals against or along the charts' cross products.
Problem room_problem(const sample::Polyhedron& room, Orientation orientation) {
  const TriangleMesh mesh = sample::mesh_of(room);
  const std::vector<std::size_t> pieces(mesh.triangles.size(), 0);
  Problem problem = with_basis(sample_problem("cube"), 1, Rational(1, 6));
  problem.surface = {.name = "room", .parameters = {}, .mesh = MeshChoice{}};
  problem.surface.mesh->surface = std::make_shared<const Surface>(
      mesh_surface("room", mesh, pieces, std::vector<std::string>{"wall"},
                   {.orientation = orientation, .closed = true, .unoccluded = false}));
  return problem;
}

TEST(VerifiedLevel, IsRefusedWhereTheSecondRouteContradictsIt) {
  // A route that is off by a millionth at the last node alone.
  const auto no_route = [](const Surface&, const SurfaceFunction&) -> AppliedOperator { return {}; };
  for (const Problem& surface :
       {sample_problem("cube"), with_basis(sample_problem("sphere", {{"radius", 1}}), 0, Rational(1, 6))}) {
    const Problem problem = with_solution(surface, "1 + x*y");
    const Vector<double> last = solve_level(with_emission(surface, "1"), 0, no_route).nodes.back().point;
    const auto off = [&](const Surface& s, const SurfaceFunction& u) -> AppliedOperator {
      return [&s, route = reference::applied_operator(s, u), last](const SurfacePoint<double>& p) {
        Approximation found = route(p);
        if (norm(s.charts[p.chart].in<double>().frame(p.at).point - last) < 1e-12) found.value += 1e-6;
        return found;
      };
    };
    try {
      static_cast<void>(verified_level(verified(problem), 0, off));
      ADD_FAILURE() << "no exception";
    } catch (const AccuracyNotReached& error) {
      EXPECT_THAT(error.what(), HasSubstr("second route"));
    }
  }
}

TEST(VerifiedLevel, HoldsWherePartsHideEachOther) {
  const auto no_route = [](const Surface&, const SurfaceFunction&) -> AppliedOperator { return {}; };
  const sample::Polyhedron outwards = sample::l_shaped_room();
  sample::Polyhedron inwards = outwards;
  for (std::vector<std::size_t>& face : inwards.faces) std::reverse(face.begin(), face.end());
  for (const Problem& room : {room_problem(outwards, Orientation::against_the_cross_product),
                              room_problem(inwards, Orientation::along_the_cross_product),
                              room_problem(sample::cube_in_cube(0.5, {0.25, 0.125, 0.0625}),
                                           Orientation::against_the_cross_product)}) {
    // Int G V = pi in a closed room: u = 1 for E = 1 - rho.
    const LevelOutcome one = proved_level(verified(with_emission(room, "1/2")), 0);
    for (const NodeValue& node : one.nodes) {
      EXPECT_LE(std::abs(node.u_n.value - 1), node.u_n.radius);
      EXPECT_LE(node.u_n.radius, 1e-11);
    }
    // The other matrix is integrated otherwise: point by point, over parts with rounded corners.
    const Problem lit = with_emission(room, "1 + x*y + z^2");
    const LevelOutcome proved = proved_level(verified(lit), 0);
    const LevelOutcome estimated = solve_level(lit, 0, no_route);
    double largest = 0;
    for (std::size_t i = 0; i < proved.nodes.size(); ++i) {
      EXPECT_LE(std::abs(proved.nodes[i].u_n.value - estimated.nodes[i].u_n.value),
                proved.nodes[i].u_n.radius + estimated.result.solution_radius.value());
      largest = std::max(largest, std::abs(proved.nodes[i].u_n.value));
    }
    EXPECT_GT(largest, 2);
  }
  // A basis whose nodes do not change places with the corners is refused where the corners do.
  const std::vector<Barycentric<Rational>> lopsided{{{Rational(1, 2), Rational(1, 4), Rational(1, 4)}},
                                                    {{Rational(1, 4), Rational(5, 8), Rational(1, 8)}},
                                                    {{Rational(1, 4), Rational(1, 4), Rational(1, 2)}}};
  Problem problem = with_emission(room_problem(outwards, Orientation::against_the_cross_product), "1/2");
  problem.method = Collocation{
      {.degree = 1,
       .family = NodeFamily::file,
       .functions = std::make_shared<const LagrangeFunctions>(lagrange_functions(lopsided).value())}};
  EXPECT_THAT(refusal(verified(problem)), ::testing::HasSubstr("not symmetric to an exchange"));
}

TEST(VerifiedLevel, RefusesInputThatIsWrongAsOtherSolversDo) {
  Problem problem = verified(sample_problem("cube"));
  problem.reflectivity = everywhere("2*x");
  EXPECT_EQ(testing::fault_of([&] { static_cast<void>(proved_level(problem, 0)); }).pointer, "/reflectivity");
  const Problem undefined = verified(with_solution(sample_problem("cube"), "log(x)"));
  EXPECT_EQ(testing::fault_of([&] { static_cast<void>(proved_level(undefined, 0)); }).pointer, "/solution");
}

}  // namespace
}  // namespace radcert
