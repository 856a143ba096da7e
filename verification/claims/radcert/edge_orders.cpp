// SPDX-License-Identifier: GPL-3.0-or-later

// What the exponents at edges do to collocation, seen on solutions.
//
// Checked      edge_exponent_seen: E = 1 on two squares that meet at 90 or 60 degrees, where u on their edge
//              is 1/(1 - rho k(0)) exactly: u_n is off there by h^b, b that of angle and reflectivity.
//              Rejected: a u that is smooth.
//              edge_exponent_on_the_cube: the same in the middles of the edges of the cube's floor, which
//              emits, by what the symmetric part of u_n differs there from that of the next level. Rejected
//              likewise.
//              edge_grading_order: the same on two squares at a right angle, graded as the edge and the
//              degrees 0, 1 and 2 ask for. Rejected: the uniform mesh. Beyond quick also the errors of
//              degrees 3 and 4, as remarks: their radii leave their order open.
//              edge_grading_order_on_the_cube: the largest difference of u_n from that of the next level over
//              all vertices of the cube's mesh, corners and edges among them, each element's own value there
//              against the mean of the finer elements of the face. E = 1 + x(1-x) + y(1-y) + z(1-z), for
//              which u has a limit at each corner, degree 1, and at full degree 2. Levels at quick: all whose
//              matrix has at most 4608 rows; else from level 2 on, where the grading begins to act, to 50,000
//              rows, at full to 80,000, by the operator of clusters. Rejected: the uniform mesh.
//              corner_grading_order: on levels to 4608 rows what u_n is off at the corner (0,0,0) from the
//              value that the equation has there, (E + rho s)/(1 - 3 rho/4) with the light s of u_n from the
//              three faces opposite: s is an integral of a smooth function, and nearer to the truth than u_n.
//              The uniform mesh shows the corner's exponent. Rejected: E = 1 + x, with which u has no limit
//              there, for degree 1; for degree 0 the differences from that value change their sign.
// Not checked  other angles, finer levels; on the cube rho = 9/10 and degrees from 3 on, whose gradings act
//              on later levels; over the vertices degree 0, whose orders still rise; on two squares the ends
//              of the edge.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "radcert/closed_form/edge/corner_exponent.h"
#include "radcert/closed_form/edge/edge_exponents.h"
#include "radcert/core/contract.h"
#include "radcert/expression/parse.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "radcert/study/edge_grading.h"
#include "radcert/study/study.h"
#include "verification/claims/radcert/mesh_choice.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::radcert {
namespace {

PiecewiseExpression everywhere(const std::string& text) {
  return {.cases = {{"*", parse_expression(text).value()}}};
}

double exponent(long degrees, const Rational& rho) {
  return smallest_edge_exponent(edge_of_degrees(degrees, rho, rho), Rational(1) / power(Rational(10), 12))
      .value()
      .to_double();
}

/// Two unit squares with the common side from (0,0,0) to (1,0,0), each of two triangles, as a mesh.
SurfaceChoice groove(long degrees) {
  const double angle = static_cast<double>(degrees) * std::acos(-1.0) / 180;
  const double y = std::cos(angle);
  const double z = std::sin(angle);
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, y, z}, {0, y, z}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {0, 5, 4}};
  const std::vector<std::size_t> pieces{0, 0, 1, 1};
  const std::vector<std::string> names{"floor", "wall"};
  return mesh_choice(
      "two squares at " + std::to_string(degrees) + " degrees", mesh, pieces, names,
      {.orientation = Orientation::along_the_cross_product, .closed = false, .unoccluded = true});
}

Problem linear_problem(SurfaceChoice surface, const Rational& rho) {
  Problem problem;
  problem.surface = std::move(surface);
  problem.triangulation.levels = {0};
  problem.method = Collocation{{.degree = 1, .alpha = Rational(1, 6)}};
  problem.reflectivity = everywhere(rho.to_text());
  return problem;
}

/// |u_n| at a vertex is at most so many times its largest value at the nodes: sum |l_j| = 39.70 there for
/// degree 4 and alpha = 1/10.
constexpr double vertex_amplification = 40;

bool is_near(double a, double b) { return std::abs(a - b) < 1e-12; }

/// Of two squares at a right angle, E = 1.
Problem square_problem(int degree, const Rational& rho) {
  Problem problem = linear_problem({.name = "two_squares", .parameters = {}}, rho);
  problem.method = Collocation{{.degree = degree, .alpha = Rational(1, 10)}};
  problem.emission = everywhere("1");
  return problem;
}

/// |u_n - u| on the middle of the edge of two squares.
LevelErrors edge_errors(const Bench& bench, const Problem& problem, double exact, int first = 2,
                        int last = 4) {
  return over_levels(levels_from(first, last), [&](int number) {
    const LevelOutcome level = bench.levels.level(problem, number);
    Approximation error{.value = 0, .radius = vertex_amplification * level.result.solution_radius.value()};
    for (const ElementValue& element : level.elements)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector<double>& p = element.corners.at(i);
        if (is_near(p.x, 0.5) && is_near(p.y, 0) && is_near(p.z, 0))
          error.value = std::max(error.value, std::abs(element.corner_values.at(i) - exact));
      }
    return error;
  });
}

/// The symmetric part of u_n in the middles of the floor's edges: on each of the two faces the mean of the
/// values of the elements there, and the mean of both. What the antisymmetric exponents add, r^1.28 for rho =
/// 1/2, has opposite signs on the faces.
using EdgeValues = std::map<std::string, double>;
EdgeValues middles_of_edges(const LevelOutcome& level) {
  struct Sum {
    double value = 0;
    int count = 0;
  };
  std::map<std::string, std::map<std::string, Sum>> sums;  // by place and piece
  for (const ElementValue& element : level.elements)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector<double>& p = element.corners.at(i);
      const bool along_x = is_near(p.x, 0.5) && (is_near(p.y, 0) || is_near(p.y, 1));
      const bool along_y = is_near(p.y, 0.5) && (is_near(p.x, 0) || is_near(p.x, 1));
      if (!is_near(p.z, 0) || !(along_x || along_y)) continue;
      const std::string place = along_x ? (p.y < 0.5 ? "south" : "north") : (p.x < 0.5 ? "west" : "east");
      Sum& sum = sums[place][element.piece];
      sum.value += element.corner_values.at(i);
      ++sum.count;
    }
  EdgeValues values;
  for (const auto& [place, by_piece] : sums) {
    expects(by_piece.size() == 2, "two faces at an edge", named("place", place));
    for (const auto& [piece, sum] : by_piece) values[place] += sum.value / sum.count / 2;
  }
  return values;
}

LevelErrors edge_differences(const Bench& bench, const Problem& problem, int last) {
  return over_levels(levels_from(1, last - 1), [&](int level) {
    const EdgeValues coarse = middles_of_edges(bench.levels.level(problem, level));
    const EdgeValues fine = middles_of_edges(bench.levels.level(problem, level + 1));
    Approximation largest{.value = 0, .radius = 1e-10};
    for (const auto& [place, value] : coarse)
      largest.value = std::max(largest.value, std::abs(value - fine.at(place)));
    return largest;
  });
}

/// A vertex of a face.
using FaceVertex = std::pair<std::string, std::array<double, 3>>;
FaceVertex face_vertex(const ElementValue& element, std::size_t corner) {
  const Vector<double>& p = element.corners.at(corner);
  return {element.piece, {p.x, p.y, p.z}};
}

/// max over the vertices of |u_n - the mean of that of the next level there|. A graded vertex is a function
/// of its place in the uniform mesh: those of a level are among those of the next, to the bit.
LevelErrors vertex_differences(const Bench& bench, const Problem& problem, int first, int last) {
  return over_levels(levels_from(first, last - 1), [&](int level) {
    std::map<FaceVertex, std::pair<double, int>> fine;
    const LevelOutcome finer = bench.levels.level(problem, level + 1);
    const LevelOutcome coarser = bench.levels.level(problem, level);
    for (const ElementValue& element : finer.elements)
      for (std::size_t i = 0; i < 3; ++i) {
        auto& [sum, count] = fine[face_vertex(element, i)];
        sum += element.corner_values.at(i);
        ++count;
      }
    Approximation largest{.value = 0,
                          .radius = vertex_amplification * (finer.result.solution_radius.value() +
                                                            coarser.result.solution_radius.value())};
    for (const ElementValue& element : coarser.elements)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& [sum, count] = fine.at(face_vertex(element, i));
        largest.value = std::max(largest.value, std::abs(element.corner_values.at(i) - sum / count));
      }
    return largest;
  });
}

/// The light at (0, 0, 0) that u_n sends from the three faces opposite to the face x = 0.
/// Maths     1/pi Int G u_n by the interpolatory rule of the nodes, over x = 1, y = 1 and z = 1, where G is
///           smooth seen from there
double light_at_the_corner(const LevelOutcome& level, const TriangleRule<Rational>& rule) {
  const Vector<double> normal{1, 0, 0};
  double sum = 0;
  for (const NodeValue& node : level.nodes) {
    const Vector<double>& q = node.point;
    if (!is_near(q.x, 1) && !is_near(q.y, 1) && !is_near(q.z, 1)) continue;
    const auto& [a, b, c] = level.elements.at(node.element).corners;
    const double parallelogram = norm(cross(b - a, c - a));
    const double g = -dot(q, normal) * dot(q, node.normal) / power(norm(q), 4);
    sum += rule.weights.at(node.index_in_element).to_double() * parallelogram * g * node.u_n.value;
  }
  return sum / std::acos(-1.0);
}

/// How far u_n is off at the corner (0, 0, 0) from what the equation says of it.
LevelErrors corner_errors(const Bench& bench, const Problem& problem, double rho, int degree, int last) {
  const TriangleRule<Rational> rule =
      interpolatory_rule(lagrange_functions(inset_nodes(degree, Rational(1, 10))).value());
  return over_levels(levels_from(0, last), [&](int number) {
    const LevelOutcome level = bench.levels.level(problem, number);
    const double there = (1 + rho * light_at_the_corner(level, rule)) / (1 - 3 * rho / 4);
    // Entries to 1e-13 of their row, the inverse at most 10, a vertex at most 100 from nodes at alpha = 1/10.
    Approximation largest{.value = 0, .radius = 1e-9};
    for (const ElementValue& element : level.elements)
      for (std::size_t i = 0; i < 3; ++i)
        if (const Vector<double>& p = element.corners.at(i); is_near(norm(p), 0))
          largest.value = std::max(largest.value, std::abs(element.corner_values.at(i) - there));
    return largest;
  });
}

/// Of the cube with an emission that its symmetries leave as it is: 1 at the corners.
Problem symmetric_cube_problem(int degree, const Rational& rho) {
  Problem problem = linear_problem({.name = "cube", .parameters = {}}, rho);
  problem.method = Collocation{{.degree = degree, .alpha = Rational(1, 10)}};
  problem.emission = everywhere("1 + x*(1-x) + y*(1-y) + z*(1-z)");
  return problem;
}

/// The finest level of the cube whose matrix has at most so many rows.
int finest_level(int degree, int most_unknowns) {
  int level = 0;
  for (int unknowns = 24 * (degree + 1) * (degree + 2); unknowns <= most_unknowns; unknowns *= 4) ++level;
  return level;
}

}  // namespace

Finding edge_exponent_seen(const Bench& bench) {
  Finding finding;
  const Rational half(1, 2);
  const Rational nine_tenths(9, 10);
  const double b_90 = exponent(90, nine_tenths);
  const double b_60 = exponent(60, nine_tenths);
  const auto edge_order = [&](long degrees, const Rational& rho) {
    Problem problem = linear_problem(groove(degrees), rho);
    problem.emission = everywhere("1");
    const double sees = (1 + std::cos(static_cast<double>(degrees) * std::acos(-1.0) / 180)) / 2;
    return observed_order(edge_errors(bench, problem, 1 / (1 - rho.to_double() * sees)));
  };
  const Order at_60 = Order::is(b_60, 0, b_90);
  const ObservedOrder seen = edge_order(60, nine_tenths);
  finding.require("order in the middle of the edge, 60 degrees, rho = 9/10, against b", at_60, seen);
  finding.require("order in the middle of the edge, 90 degrees, rho = 9/10, against b",
                  Order::is(b_90, b_60, exponent(90, half)), edge_order(90, nine_tenths));
  finding.require("order in the middle of the edge, 90 degrees, rho = 1/2, against b",
                  Order::is(exponent(90, half), b_90, 1), edge_order(90, half));
  finding.remark("order in the middle of the edge, 60 degrees, rho = 1/2, b = 0.7596",
                 edge_order(60, half).exponent);
  Problem smooth = linear_problem(groove(60), nine_tenths);
  smooth.solution = everywhere("x^2");
  finding.control("order there for u = x^2, against b of 60 degrees, rho = 9/10", at_60,
                  observed_order(edge_errors(bench, smooth, 0.25)));
  finding.show(seen.exponent);
  return finding;
}

Finding edge_exponent_on_the_cube(const Bench& bench) {
  Finding finding;
  // One level more where b is nearer to the exponents of smooth parts.
  const Rational half(1, 2);
  const Rational nine_tenths(9, 10);
  const auto order = [&](const Rational& rho, bool is_smooth, int last) {
    Problem problem = linear_problem({.name = "cube", .parameters = {}}, rho);
    if (is_smooth) {
      problem.solution = everywhere("x^2 + y^2 + z^2");
    } else {
      problem.emission = PiecewiseExpression{
          .cases = {{"floor", parse_expression("1").value()}, {"*", parse_expression("0").value()}}};
    }
    return observed_order(edge_differences(bench, problem, last));
  };
  const Order of_half = Order::is(exponent(90, half), exponent(90, nine_tenths), 1);
  const Order of_nine_tenths = Order::is(exponent(90, nine_tenths), 0, exponent(90, half));
  const ObservedOrder seen = order(half, false, 5);
  finding.require("order in the middles of the edges, uniform, rho = 1/2, against b", of_half, seen);
  finding.require("order in the middles of the edges, uniform, rho = 9/10, against b", of_nine_tenths,
                  order(nine_tenths, false, 4));
  finding.control("the same for u = x^2 + y^2 + z^2, rho = 1/2", of_half, order(half, true, 4));
  finding.show(seen.exponent);
  return finding;
}

Finding edge_grading_order(const Bench& bench) {
  Finding finding;
  struct Run {
    int degree;
    int first;
    int last;
  };
  const std::vector<Run> runs{{0, 2, 5}, {1, 2, 4}, {2, 2, 4}};
  for (const Rational& rho : {Rational(1, 2), Rational(9, 10)})
    for (const Run& run : runs) {
      Problem problem = square_problem(run.degree, rho);
      const double exact = 1 / (1 - rho.to_double() / 2);
      // What is told from it is the order without grading.
      const Order smooth = Order::at_least(run.degree + 1, exponent(90, rho));
      const std::string with = ", degree " + std::to_string(run.degree) + ", rho = " + rho.to_text();
      if (run.degree > 0)
        finding.control("order in the middle of the edge, uniform" + with, smooth,
                        observed_order(edge_errors(bench, problem, exact, run.first, run.last)));
      problem.triangulation.grading = edge_grading(problem, surface_of(problem)).grading;
      const ObservedOrder order = observed_order(edge_errors(bench, problem, exact, run.first, run.last));
      finding.require(
          "order in the middle of the edge, graded by " + problem.triangulation.grading.to_text() + with,
          smooth, order);
    }
  if (bench.budget == Budget::quick) return finding;
  for (const Rational& rho : {Rational(1, 2), Rational(9, 10)})
    for (const int degree : {3, 4}) {
      Problem problem = square_problem(degree, rho);
      problem.triangulation.grading = edge_grading(problem, surface_of(problem)).grading;
      const LevelErrors errors = edge_errors(bench, problem, 1 / (1 - rho.to_double() / 2));
      for (std::size_t k = 0; k < errors.errors.size(); ++k)
        finding.remark("the error in the middle of the edge, graded by " +
                           problem.triangulation.grading.to_text() + ", degree " + std::to_string(degree) +
                           ", rho = " + rho.to_text() + ", level " + std::to_string(k + 2),
                       errors.errors[k]);
    }
  return finding;
}

Finding edge_grading_order_on_the_cube(const Bench& bench) {
  Finding finding;
  const Rational rho(1, 2);
  const bool is_quick = bench.budget == Budget::quick;
  const int first = is_quick ? 0 : 2;
  const bool is_full = bench.budget == Budget::full;
  for (const int degree : {0, 1, 2}) {
    const int last = finest_level(degree, is_quick ? 4608 : is_full ? 80'000 : 50'000);
    // For degree 0 the orders of these levels still rise, and degree 2 needs level 5.
    const bool is_told = degree == 1 || (degree == 2 && is_full);
    Problem problem = symmetric_cube_problem(degree, rho);
    problem.matrix.tolerance = Rational(1) / power(Rational(10), 10);
    // What is told from it is the order without grading.
    const Order smooth = Order::at_least(degree + 1, exponent(90, rho));
    const std::string with = ", degree " + std::to_string(degree) + ", levels " + std::to_string(first) +
                             " to " + std::to_string(last);
    if (is_told)
      finding.control("order over the vertices, uniform" + with, smooth,
                      observed_order(vertex_differences(bench, problem, first, last)));
    problem.triangulation.grading = edge_grading(problem, surface_of(problem)).grading;
    const LevelErrors differences = vertex_differences(bench, problem, first, last);
    const std::string graded = ", graded by " + problem.triangulation.grading.to_text() + with;
    if (is_told) finding.require("order over the vertices" + graded, smooth, observed_order(differences));
    if (degree == 0) finding.remark("order over the vertices" + graded, observed_order(differences).exponent);
    for (std::size_t k = 0; k < differences.errors.size(); ++k) {
      const int level = first + static_cast<int>(k);
      finding.remark(
          "the difference of levels " + std::to_string(level) + " and " + std::to_string(level + 1) + graded,
          differences.errors[k]);
    }
  }
  return finding;
}

Finding corner_grading_order(const Bench& bench) {
  Finding finding;
  const Rational rho(1, 2);
  const double corner = octant_exponent({0.5, 0.5, 0.5}).value;
  const double of_larger_reflectivity = octant_exponent({0.9, 0.9, 0.9}).value;
  for (const int degree : {0, 1}) {
    const int last = finest_level(degree, 4608);
    Problem problem = symmetric_cube_problem(degree, rho);
    const Order smooth = Order::at_least(degree + 1, corner);
    const std::string with = ", degree " + std::to_string(degree) + ", levels to " + std::to_string(last);
    const ObservedOrder uniform =
        observed_order(corner_errors(bench, problem, rho.to_double(), degree, last));
    finding.require("order at the corner, uniform, against its exponent" + with,
                    Order::is(corner, of_larger_reflectivity, degree + 1), uniform);
    problem.triangulation.grading = edge_grading(problem, surface_of(problem)).grading;
    const ObservedOrder graded = observed_order(corner_errors(bench, problem, rho.to_double(), degree, last));
    finding.require("order at the corner, graded by " + problem.triangulation.grading.to_text() + with,
                    smooth, graded);
    finding.show(graded.exponent);
    // The light from elsewhere differs between the faces then.
    problem.emission = everywhere("1 + x");
    const ObservedOrder of_no_limit =
        observed_order(corner_errors(bench, problem, rho.to_double(), degree, last));
    const std::string without = "the same for E = 1 + x, with which u has no limit there" + with;
    if (degree == 1) finding.control(without, smooth, of_no_limit);
    if (degree != 1) finding.remark(without, of_no_limit.exponent);
  }
  return finding;
}

}  // namespace radcert::verification::radcert
