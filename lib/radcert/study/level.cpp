// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>

#include "radcert/collocation/assembly.h"
#include "radcert/collocation/nodes.h"
#include "radcert/core/errors.h"
#include "radcert/core/parallel.h"
#include "radcert/core/text.h"
#include "radcert/solve/accurate_dot.h"
#include "radcert/solve/direct.h"
#include "radcert/study/level_errors.h"
#include "radcert/study/node_data.h"
#include "radcert/study/plan.h"
#include "radcert/study/study.h"
#include "radcert/study/surface_function.h"

namespace radcert {
namespace {

class Stopwatch {
public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

TriangulationOptions options_of(const Problem& problem, const Surface& surface) {
  TriangulationOptions options;
  options.grading = problem.triangulation.grading.to_double();
  if (problem.triangulation.pattern.empty()) return options;
  std::vector<Diagonal> diagonals = surface.diagonals;
  for (std::size_t j = 0; j < surface.charts.size(); ++j) {
    const auto assign = [&](const std::string& piece) {
      for (const auto& [name, diagonal] : problem.triangulation.pattern)
        if (name == piece) diagonals[j] = diagonal;
    };
    assign("*");
    assign(surface.charts[j].facts().piece);
  }
  options.diagonals = std::move(diagonals);
  return options;
}

double largest(std::span<const double> values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

double largest_size(std::span<const double> values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

/// sup rho where it is a constant on every piece.
std::optional<Rational> constant_bound(const PiecewiseExpression& reflectivity, const Surface& surface) {
  Rational bound = 0;
  for (const std::string& piece : surface.piece_names()) {
    const std::optional<Rational> value = reflectivity.on(piece).is_constant();
    if (!value) return std::nullopt;
    bound = std::max(bound, *value);
  }
  return bound;
}

/// ||K|| on C(S) or L^infinity(S): on a closed unoccluded surface Int G = pi makes it sup rho exactly; on an open one the
/// largest rho/pi Int G seen at the nodes estimates it from below.
NormOfK norm_of_K(const Surface& surface, const PiecewiseExpression& reflectivity,
                  std::span<const double> rho_at_nodes, std::span<const double> kernel_integral) {
  if (surface.closed) {
    const std::optional<Rational> bound = constant_bound(reflectivity, surface);
    if (bound) return {.value = bound->to_double(), .guaranteed = true};
    return {.value = largest(rho_at_nodes), .guaranteed = false};
  }
  double norm = 0;
  for (std::size_t i = 0; i < rho_at_nodes.size(); ++i)
    norm = std::max(norm, rho_at_nodes[i] * kernel_integral[i] / pi<double>());
  return {.value = norm, .guaranteed = false};
}

void refuse_norm_from_one(const NormOfK& norm) {
  if (norm.value < 1) return;
  throw InputError({.pointer = "/reflectivity",
                    .value = shortest(norm.value),
                    .problem = "is the norm of K: the equation need not have one solution",
                    .allowed = "reflectivities for which the norm of K is below 1"});
}

/// rho/pi Int G u at the nodes by the second route, and its radius.
struct OperatorAtNodes {
  std::vector<double> value;
  std::vector<double> radius;
};

OperatorAtNodes apply_operator(const Problem& problem, const Surface& surface, const OperatorRoute& route,
                               std::span<const Observer<double>> nodes, std::span<const double> rho) {
  const SurfaceFunction u(*problem.solution, surface);
  const auto density = [&u](std::size_t chart, const Vector<double>& q) { return u(chart, q); };
  OperatorAtNodes result{std::vector<double>(nodes.size()), std::vector<double>(nodes.size())};
  constexpr std::size_t grain = 8;
  parallel_for(nodes.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const OperatorValue integral = route(surface, density, nodes[i].at);
      result.value[i] = rho[i] / pi<double>() * integral.value;
      result.radius[i] = rho[i] / pi<double>() * integral.radius;
    }
  });
  return result;
}

/// max_i |a_i - b_i| with what is known of each difference.
Figure largest_difference(std::span<const double> a, std::span<const double> b,
                          std::span<const double> radius) {
  Figure figure{.value = 0, .radius = 0.0, .guaranteed = false};
  for (std::size_t i = 0; i < a.size(); ++i) {
    figure.value = std::max(figure.value, std::abs(a[i] - b[i]));
    figure.radius = std::max(*figure.radius, radius[i]);
  }
  return figure;
}

/// The finished pieces of one level, in the order in which they are computed.
class Level {
public:
  Level(const Problem& problem, int level)
      : problem_(problem),
        surface_(surface_of(problem)),
        basis_(problem.basis.degree, problem.basis.alpha.value_or(Rational(0)).to_double()),
        triangulation_(triangulate(surface_, level, options_of(problem, surface_))),
        nodes_(collocation_nodes(surface_, triangulation_, basis_)),
        rho_(reflectivity_at_nodes(problem.reflectivity, surface_, nodes_)) {
    outcome_.result.level = level;
    outcome_.result.elements = triangulation_.triangles.size();
    outcome_.result.unknowns = nodes_.size();
    outcome_.result.mesh_size = mesh_size(triangulation_);
    outcome_.result.planned_bytes = level_plan(triangulation_.triangles.size(), basis_.size()).total();
  }

  LevelOutcome compute(const OperatorRoute& route) && {
    if (surface_.closed) refuse_norm_from_one(norm_of_K(surface_, problem_.reflectivity, rho_, {}));
    if (problem_.solution) u_ = values_at_nodes(*problem_.solution, "/solution", surface_, nodes_);
    if (problem_.emission) emission_ = values_at_nodes(*problem_.emission, "/emission", surface_, nodes_);
    assemble_matrix();
    if (problem_.solution) manufacture_emission(route);
    solve();
    describe();
    return std::move(outcome_);
  }

private:
  void assemble_matrix() {
    const Stopwatch watch;
    matrix_ = assemble<double>(surface_, triangulation_, basis_, nodes_, rho_);
    outcome_.timing.assembly_seconds = watch.seconds();
    outcome_.result.norm_K = norm_of_K(surface_, problem_.reflectivity, rho_, matrix_.kernel_integral);
    refuse_norm_from_one(outcome_.result.norm_K);
  }

  /// E = u - Ku by the second route; K(I-P_n)u is the difference of the two.
  void manufacture_emission(const OperatorRoute& route) {
    const Stopwatch watch;
    const OperatorAtNodes ku = apply_operator(problem_, surface_, route, nodes_, rho_);
    outcome_.timing.operator_seconds = watch.seconds();
    const std::vector<double> k_pn_u = accurate_product(matrix_.entries, u_);
    const double u_size = largest_size(u_);
    std::vector<double> radius(nodes_.size());
    emission_.resize(nodes_.size());
    emission_radius_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double rounded = unit * (std::abs(u_[i]) + 4 * std::abs(ku.value[i]));
      radius[i] = ku.radius[i] + matrix_.row_radius[i] * u_size + rounded;
      emission_[i] = u_[i] - ku.value[i];
      emission_radius_[i] = ku.radius[i] + rounded;
    }
    outcome_.result.discretisation_error = largest_difference(ku.value, k_pn_u, radius);
  }

  void solve() {
    const Stopwatch watch;
    const DirectSolver solver(matrix_.entries);
    u_n_ = solver.solve(emission_);
    if (problem_.solution) {
      outcome_.result.node_error = largest_difference(
          u_, u_n_, std::vector<double>(u_.size(), node_radius(solver.inverse_norm_estimate())));
    }
    outcome_.timing.solve_seconds = watch.seconds();
  }

  /// (I - K_n)(u_n - exact u_n) = residual + errors of matrix and right-hand side, in the maximum norm.
  double node_radius(double inverse_norm) const {
    const std::vector<double> k_u_n = accurate_product(matrix_.entries, u_n_);
    const double u_n_size = largest_size(u_n_);
    double defect = 0;
    for (std::size_t i = 0; i < u_n_.size(); ++i) {
      const double residual = std::abs(emission_[i] - (u_n_[i] - k_u_n[i]));
      const double rounded = unit * (std::abs(u_n_[i]) + 4 * std::abs(k_u_n[i]));
      defect = std::max(defect, residual + rounded + matrix_.row_radius[i] * u_n_size + emission_radius_[i]);
    }
    return inverse_norm * defect;
  }

  void describe() {
    const NodalFunction function(surface_, triangulation_, basis_, u_n_);
    if (problem_.solution) outcome_.result.uniform_error = uniform_error(function, *problem_.solution);
    outcome_.result.piece_means = piece_means(function);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      outcome_.nodes.push_back({.piece = surface_.charts[nodes_[i].at.chart].facts().piece,
                                .element = i / basis_.size(),
                                .index_in_element = i % basis_.size(),
                                .point = nodes_[i].point,
                                .normal = nodes_[i].normal,
                                .u_n = u_n_[i],
                                .emission = emission_[i],
                                .u = problem_.solution ? std::optional(u_[i]) : std::nullopt});
    for (std::size_t k = 0; k < triangulation_.triangles.size(); ++k) {
      const ParameterTriangle& triangle = triangulation_.triangles[k];
      const Chart& chart = surface_.charts[triangle.chart];
      ElementValue element{.piece = chart.facts().piece, .corners = {}, .corner_values = {}};
      for (std::size_t c = 0; c < 3; ++c) {
        Barycentric<double> corner{{0, 0, 0}};
        corner.x[c] = 1;
        element.corners[c] = chart.in<double>().frame(triangle.vertices[c]).point;
        element.corner_values[c] = function.at(k, corner);
      }
      outcome_.elements.push_back(std::move(element));
    }
  }

  static constexpr double unit = unit_roundoff<double>();
  const Problem& problem_;
  Surface surface_;
  InsetBasis<double> basis_;
  Triangulation triangulation_;
  std::vector<Observer<double>> nodes_;
  std::vector<double> rho_;
  std::vector<double> u_;
  std::vector<double> emission_;
  std::vector<double> emission_radius_ = std::vector<double>(nodes_.size());
  CollocationMatrix<double> matrix_;
  std::vector<double> u_n_;
  LevelOutcome outcome_;
};

}  // namespace

LevelOutcome solve_level(const Problem& problem, int level, const OperatorRoute& route) {
  return Level(problem, level).compute(route);
}

}  // namespace radcert
