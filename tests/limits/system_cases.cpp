// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include "radcert/collocation/certified/certified_chart_entries.h"
#include "radcert/collocation/certified/certified_operator.h"
#include "radcert/collocation/certified/plane_entries.h"
#include "radcert/core/errors.h"
#include "radcert/expression/parse.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/quadrature/element_integrator.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/solve/direct.h"
#include "radcert/solve/gmres.h"
#include "radcert/solve/power_series.h"
#include "radcert/solve/verified_system.h"
#include "radcert/study/collocation/operator_norm.h"
#include "radcert/study/study.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "tests/limits/limits.h"
#include "tests/solve/systems.h"
#include "tests/study/problems.h"

namespace radcert::limits {
namespace {

using testing::everywhere;

/// Int G over a closed convex surface as the sum of a row: pi, whatever the functions that sum to 1.
Case row(const std::string& limit, const std::function<Surface()>& make,
         const std::vector<SurfacePoint<double>>& points, int level, int degree, const std::string& about) {
  return {.limit = limit,
          .answer =
              [=] {
                const Surface surface = make();
                const InsetBasis<double> basis(degree, 0.1);
                std::vector<Ball> sums;
                for (const SurfacePoint<double>& at : points) {
                  const CollocationPoint<double> p = collocation_point<double>(surface, at);
                  double sum = 0;
                  double radius = 1e-15;
                  for (const ParameterTriangle& triangle : triangulate(surface, level).triangles) {
                    const ElementIntegral<double> integral =
                        ElementIntegrator<double>(surface, triangle, basis).integrate(p);
                    for (std::size_t j = 0; j < basis.size(); ++j) {
                      sum += integral.value[j];
                      radius += integral.radius[j];
                    }
                  }
                  sums.push_back(number(sum, radius));
                }
                return numbers(sums);
              },
          .truth = [=] { return std::vector<Ball>(points.size(), Ball::pi()); },
          .about = about};
}

/// Rows of an assembled matrix, by blocks of observers.
Case rows(const std::string& limit, const std::string& surface, int level, int degree) {
  return {.limit = limit,
          .answer =
              [=] {
                const CollocationMatrix<double> matrix = test::collocation_matrix(surface, level, degree, 1);
                std::vector<Ball> all;
                for (std::size_t i = 0; i < matrix.entries.rows(); i += 7) {
                  double sum = 0;
                  for (std::size_t j = 0; j < matrix.entries.columns(); ++j) sum += matrix.entries(i, j);
                  all.push_back(number(sum, matrix.row_radius[i] + 1e-15));
                }
                return numbers(all);
              },
          .truth = [] { return std::vector<Ball>(); },
          .about = surface,
          .is_long = true};
}

/// Int G over the sphere from points of it, proved.
Case certified_integrals(const std::string& limit, const std::string& about) {
  return {.limit = limit,
          .answer =
              [] {
                const Surface surface = ellipsoid(1, 1, 1);
                const DensityFormula unit = unit_density();
                const std::vector<SurfacePoint<Rational>> points{{0, {Rational(1, 3), Rational(1, 3)}},
                                                                 {5, {Rational(1, 5), Rational(1, 7)}}};
                const auto found = certified_operator(surface, triangulate(surface, 0), unit, points, 1e-5);
                if (!found) return refusal(found.reason());
                std::vector<Ball> all;
                for (std::size_t i = 0; i < points.size(); ++i)
                  all.push_back(number(found->values[i], found->radius[i]));
                return numbers(all);
              },
          .truth = [] { return std::vector<Ball>(2, Ball::pi()); },
          .about = about,
          .is_long = true};
}

Matrix<double> contracting(std::size_t n, double row_sum, bool positive) {
  std::mt19937_64 random(5);
  return test::random_matrix(random, n, row_sum, positive);
}

test::Values right_hand_side(std::size_t n) {
  std::mt19937_64 random(6);
  return test::random_values(random, n);
}

std::vector<Ball> exactly_solved(const Matrix<double>& k, const test::Values& e) {
  std::vector<Ball> all;
  const std::vector<Rational> solution = test::exact_solution(k, e).value();
  for (const Rational& x : solution) all.emplace_back(x);
  return all;
}

std::vector<Ball> around(const test::Values& values, double radius) {
  std::vector<Ball> all;
  for (const double value : values) all.push_back(number(value, radius));
  return all;
}

Case by_gmres() {
  const std::size_t n = 24;
  return {.limit = "solve/gmres: vectors",
          .answer =
              [n] {
                const Matrix<double> k = contracting(n, 0.9, false);
                const auto found =
                    solve_by_gmres(k, find_contraction(k).value(), right_hand_side(n), std::nullopt);
                if (!found) return refusal("not reached");
                return numbers(around(found->values, found->error_bound), std::to_string(found->iterations));
              },
          .truth = [n] { return exactly_solved(contracting(n, 0.9, false), right_hand_side(n)); }};
}

/// A triangular matrix with large entries, of spectral radius 1/2.
Matrix<double> nilpotent_and_more(std::size_t n, double sign) {
  return test::matrix(n, [&](std::size_t i, std::size_t j) {
    return i == j ? 0.25 : j == i + 1 ? 1.5 : (i > j ? sign * 1e-3 : 0);
  });
}

Case contraction() {
  return {.limit = "solve/contraction: steps of the power method", .answer = [] {
            const auto found = find_contraction(nilpotent_and_more(6, 1));
            if (!found) return refusal("no contraction");
            // Its spectral radius lies below every theta.
            return numbers({hull(Ball(0.25), Ball(found->theta()))}, "theta < 1");
          }};
}

Case squarings() {
  const std::size_t n = 6;
  // Its square is 18/25 of the identity.
  const auto k = [] {
    return test::matrix(n, [](std::size_t i, std::size_t j) {
      return i / 2 != j / 2 ? 0.0 : (i == j && i % 2 == 1 ? -0.6 : 0.6);
    });
  };
  return {.limit = "solve/power_series: squarings",
          .answer =
              [k] {
                const auto series = NeumannSeries::make(k());
                if (!series) return refusal("no power contracts");
                const auto found = series->solve(right_hand_side(n), std::nullopt);
                if (!found) return refusal("not reached");
                return numbers(around(found->values, found->error_bound), std::to_string(series->power()));
              },
          .truth = [k] { return exactly_solved(k(), right_hand_side(n)); }};
}

Case verified(const std::string& limit, const std::function<Matrix<double>()>& k, double radius) {
  return {.limit = limit,
          .answer =
              [=] {
                const std::size_t n = k().rows();
                Matrix<double> radii = test::matrix(n, [&](std::size_t, std::size_t) { return radius; });
                const auto system = verified_system(k(), std::move(radii));
                if (!system) return refusal(system.reason());
                const auto found = system->solve(right_hand_side(n));
                if (!found) return refusal(found.reason());
                std::vector<Ball> all;
                for (std::size_t i = 0; i < n; ++i) all.push_back(number(found->values[i], found->radius[i]));
                return numbers(all);
              },
          .truth = [=] { return exactly_solved(k(), right_hand_side(k().rows())); }};
}

Case below_one(const std::string& limit) {
  return {.limit = limit, .answer = [] {
            const auto found =
                reflectivity_below_one(sphere(), everywhere("0.9 + 0.09*x*y*z + 0.05*(x - y)"));
            return found ? verdict("below 1") : refusal(found.reason());
          }};
}

std::vector<Ball> balls_of(const CertifiedEntries& found, std::size_t step) {
  std::vector<Ball> all;
  for (std::size_t j = 0; j < found.entries.columns(); j += step)
    for (std::size_t i = 0; i < found.entries.rows(); i += step)
      all.push_back(number(found.entries(i, j), found.radius(i, j)));
  return all;
}

Case plane_entries() {
  return {.limit = "collocation/plane_entries: bits of an entry", .answer = [] {
            const Surface surface = cube();
            std::vector<PlaneChart> elements;
            for (std::size_t j = 0; j < 3; ++j)
              elements.push_back(plane_chart(surface, j).value().over({{{0, 0}, {1, 0}, {0, 1}}}));
            const LagrangeFunctions functions =
                lagrange_functions(inset_nodes(1, Rational(1, 1000000000))).value();
            const auto found = plane_entries_in_balls(elements, functions);
            return found ? numbers(balls_of(*found, 1)) : refusal(found.reason());
          }};
}

/// u_n of a whole level at its nodes.
Case level(const std::string& limit, const Problem& problem, int number_of_level, const std::string& about) {
  return {.limit = limit,
          .answer =
              [=] {
                const LevelOutcome outcome =
                    solve_level(problem, number_of_level, reference::applied_operator);
                std::vector<Ball> all;
                const std::optional<Approximation>& error = outcome.result.node_error;
                const double radius = outcome.result.verified        ? outcome.result.solution_radius.value()
                                      : error && error->has_radius() ? error->radius
                                                                     : 0;
                for (std::size_t i = 0; i < outcome.nodes.size(); i += 5)
                  all.push_back(number(outcome.nodes[i].u_n.value, radius + 1e-15));
                return numbers(all);
              },
          .truth = [] { return std::vector<Ball>(); },
          .about = about,
          .is_long = true};
}

Problem with_solver(Problem problem, const std::string& solver) {
  problem.solver.name = solver;
  return problem;
}

/// By the ellipsoid's verified interpolant: its points are doubles.
Problem verified_interpolant() {
  Problem problem = with_solver(
      testing::with_emission(testing::sample_problem("two_piece", {{"p", 2}}), "1 + x*y/8"), "verified");
  problem.geometry = InterpolatedGeometry{.degree = 2, .data = DataPoints::surface};
  return problem;
}

Problem meshless_problem() {
  Problem problem = testing::sample_problem("sphere");
  Meshless basis = basis_of(MeshlessFamily::lehtinen);
  basis.sites = PoissonDiskLevels{.separation = Rational(1, 2)};
  basis.weights = WeightRule::integrated;
  problem.method = basis;
  return problem;
}

}  // namespace

std::vector<Case> system_cases() {
  const auto unit_sphere = [] { return sphere(); };
  const auto long_ellipsoid = [] { return ellipsoid(1, 2, 5); };
  const auto thin = [] { return box(1, 1, Rational(1, 10000)); };
  const std::vector<SurfacePoint<double>> on_octants{{0, {0.3, 0.4}}, {0, {1e-4, 0.4}}, {5, {0.2, 0.7999}}};
  const std::vector<SurfacePoint<double>> on_box{{4, {0.375, 0.25}}, {4, {1e-6, 0.4}}, {0, {0.5, 0.999}}};
  const auto nearly_singular = [] {
    return test::matrix(
        12, [](std::size_t i, std::size_t j) { return (i == j ? 0.0 : 0.09) + (i + 1 == j ? 0.4 : 0); });
  };
  const Problem peaked = with_solver(
      testing::with_solution(testing::sample_problem("cube"), "exp(-100*((x-0.3)^2 + (y-0.4)^2 + z^2))"),
      "verified");
  const Problem plane =
      with_solver(testing::with_emission(testing::sample_problem("cube"), "1 + x"), "verified");
  return {
      row("quadrature/element_integrator: bisections", thin, on_box, 1, 1, "a thin box"),
      row("quadrature/element_integrator: bisections", cube, on_box, 1, 1, "the cube"),
      rows("quadrature/element_integrator: bisections of a far piece", "paraboloid_cap", 1, 4),
      row("quadrature/element_integrator: pieces", thin, on_box, 1, 1, "a thin box"),
      row("quadrature/element_integrator: pieces", cube, on_box, 1, 1, "the cube"),
      rows("quadrature/element_integrator: tries with finer rules", "sphere", 2, 4),
      row("quadrature/apex_rule: bisections of a side", long_ellipsoid, on_octants, 0, 2, "an ellipsoid"),
      row("quadrature/apex_rule: halvings of a rectangle", long_ellipsoid, on_octants, 0, 2, "an ellipsoid"),
      row("quadrature/apex_rule: rectangles", long_ellipsoid, on_octants, 0, 2, "an ellipsoid"),
      row("quadrature/chart_inverse: steps", unit_sphere, {{0, {0.0, 0.4}}, {0, {1e-9, 0.4}}}, 1, 1,
          "a seam"),
      certified_integrals("quadrature/certified_kernel_sums: quarterings of an element", "the sphere"),
      certified_integrals("quadrature/integral_from_within: halvings of a square", "the sphere"),
      by_gmres(),
      contraction(),
      squarings(),
      verified("solve/verified_system: steps to weights", nearly_singular, 1e-3),
      verified("solve/verified_system: refinements", nearly_singular, 1e-14),
      verified("solve/verified_system: steps of a bound", nearly_singular, 1e-4),
      below_one("study/operator_norm: halvings of a parameter"),
      below_one("study/operator_norm: boxes"),
      plane_entries(),
      level("study/exact_interpolant: bits", verified_interpolant(), 0, "two_piece"),
      level("study/verified_level: bits of balls", plane, 0, "the cube"),
      level("study/verified_level: boxes in search of the largest value", peaked, 0, "the cube"),
      level("study/meshless_level: points of the weights' integrals", meshless_problem(), 0, "the sphere")};
}

}  // namespace radcert::limits
