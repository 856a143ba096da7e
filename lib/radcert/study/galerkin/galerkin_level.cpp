// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/galerkin/galerkin_matrix.h"
#include "radcert/polynomial/basis_limits.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/triangle_modes.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/solve/conjugate_gradients.h"
#include "radcert/solve/rounding/euclidean_norm.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/collocation/nodal_description.h"
#include "radcert/study/collocation/nodal_function.h"
#include "radcert/study/collocation/node_data.h"
#include "radcert/study/collocation/operator_norm.h"
#include "radcert/study/errors/mean_errors.h"
#include "radcert/study/galerkin/galerkin.h"
#include "radcert/study/operator_at_nodes.h"
#include "radcert/study/stopwatch.h"
#include "radcert/study/study.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();

/// The lattice by which the polynomials are given and told: inside the element.
InsetBasis<double> lattice_basis(int degree) { return {degree, 0.5 / (degree + 2)}; }

/// The square root of sum measures_i values_i^2, the values scaled so that their squares do not underflow.
double weighted_norm(std::span<const double> measures, std::span<const double> values) {
  const int exponent = binary_exponent(values);
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double scaled = std::ldexp(values[i], -exponent);
    sum += measures[i] * scaled * scaled;
  }
  return std::ldexp(std::sqrt(sum), exponent);
}

double largest(std::span<const double> values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

bool all_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// Int w E psi_a dS over all elements, with what is known of the errors of E.
struct Load {
  std::vector<double> values;
  /// Of the errors of E in the norm of L2 with the weight w, which bounds what they do to the values: those
  /// are coefficients of a projection. Absent where they are not known
  std::optional<double> radius;
  double size = 0;  ///< the norm of E
};

/// The finished pieces of one level, in the order in which they are computed.
class GalerkinLevel {
public:
  GalerkinLevel(const Problem& problem, const Galerkin& method, int level)
      : problem_(problem),
        degree_(method.degree),
        basis_(lattice_basis(method.degree)),
        geometry_(problem, level, basis_),
        lower_(1 - reflectivity_bound(problem, surface_)) {
    for (const ParameterTriangle& triangle : triangulation_.triangles)
      reflects_.push_back(!is_black(surface_.charts[triangle.chart].facts().piece));
    rho_ = reflectivity_at_nodes(problem.reflectivity, surface_, nodes_);
    LevelResult& result = outcome_.result;
    result.level = level;
    result.elements = triangulation_.triangles.size();
    result.unknowns = nodes_.size();
    result.mesh_size = geometry_.mesh_size();
    result.planned_bytes = galerkin_plan(method, result.elements).total();
    result.solver = "conjugate_gradients";
  }

  GalerkinLevel(const GalerkinLevel&) = delete;
  GalerkinLevel& operator=(const GalerkinLevel&) = delete;

  LevelOutcome compute(const OperatorRoute& route) && {
    assemble();
    require_rows_of_one();
    find_norm();
    find_load(route);
    solve();
    describe(route);
    return std::move(outcome_);
  }

private:
  [[nodiscard]] bool is_black(const std::string& piece) const {
    const std::optional<Rational> constant = problem_.reflectivity.on(piece).is_constant();
    return constant && constant->sign() == 0;
  }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw AccuracyNotReached("level " + std::to_string(outcome_.result.level) + ", Galerkin's method",
                             reason);
  }

  void assemble() {
    const Stopwatch watch;
    const SurfaceFunction rho(problem_.reflectivity, surface_);
    functions_.emplace(surface_, triangulation_, basis_, [&](std::size_t chart, const Vector<double>& point) {
      if (is_black(surface_.charts[chart].facts().piece)) return 1.0;
      const double value = rho(chart, point);
      if (!(value > 0 && value <= 1))
        refuse_input("/reflectivity", nearest_text(value, DecimalForm::general(6)),
                     "is not in (0, 1] at a point", "values in (0, 1) where it is not the constant 0");
      return 1 / value;
    });
    const PairIntegrals pairs(surface_, triangulation_, *functions_,
                              problem_.quadrature.tolerance.to_double());
    matrix_ = galerkin_matrix(pairs, functions_->functions(), reflects_);
    outcome_.timing.assembly_seconds = watch.seconds();
    if (!all_finite(matrix_.row_radius))
      refuse("the integrals are not found: numbers run over the range of double");
  }

  [[nodiscard]] std::size_t element_of(std::size_t unknown) const {
    return unknown / functions_->functions();
  }
  [[nodiscard]] bool is_active(std::size_t unknown) const { return reflects_[element_of(unknown)]; }

  /// What entries are off by in the 2-norm.
  [[nodiscard]] double entry_radius() const {
    double rows = 0;
    for (std::size_t i = 0; i < matrix_.row_radius.size(); ++i)
      if (is_active(i)) rows = std::max(rows, matrix_.row_radius[i]);
    return rows;
  }

  /// What masses are off by in the 2-norm.
  [[nodiscard]] double mass_defect() const {
    double masses = 0;
    for (std::size_t k = 0; k < functions_->elements(); ++k) masses = std::max(masses, functions_->defect(k));
    return masses;
  }

  [[nodiscard]] double eta() const { return entry_radius() + mass_defect(); }

  /// Of the system as stored. Without one the radius of u_n would be larger than u_n.
  [[nodiscard]] double definiteness() const {
    const double bound = definiteness_as_stored(lower_, entry_radius(), mass_defect());
    if (!(bound > 0))
      refuse("the integrals are known within about " + upper_text(eta()) +
             " in the 2-norm, which does not tell the system from a singular one where the reflectivity is "
             "up to " +
             upper_text_below_one(1 - lower_, 3) + ": take a smaller tolerance of /quadrature");
    return bound;
  }

  /// Int_S G(P,Q) dS_Q = pi on a closed surface. The coefficients of 1 are t_b = Int w psi_b dS, so that
  /// sum_b A_ab t_b = Int psi_a dS.
  void require_rows_of_one() const {
    if (!surface_.closed) return;
    const std::vector<double> moments =
        load_of([](std::size_t, const Vector<double>&) { return 1.0; }, false);
    const std::vector<double> weighted =
        load_of([](std::size_t, const Vector<double>&) { return 1.0; }, true);
    const double size = largest(weighted);
    const double masses = eta();
    for (std::size_t i = 0; i < moments.size(); ++i) {
      if (!is_active(i)) continue;
      double sum = 0;
      double terms = 0;
      for (std::size_t j = 0; j < weighted.size(); ++j) {
        sum += matrix_.entries(i, j) * weighted[j];
        terms += std::abs(matrix_.entries(i, j) * weighted[j]);
      }
      const double radius = matrix_.row_radius[i] * size + masses * (std::abs(moments[i]) + terms) +
                            unit * static_cast<double>(moments.size() + 64) * (terms + std::abs(moments[i]));
      if (std::abs(sum - moments[i]) <= radius) continue;
      refuse("over the closed surface the integrals of G against the function " + std::to_string(i) +
             " sum to " + nearest_text(sum, DecimalForm::general(10)) + ", and not to its integral " +
             nearest_text(moments[i], DecimalForm::general(10)) + ", within " + upper_text(radius));
    }
  }

  void find_norm() {
    std::vector<double> kernel_integral;
    Approximation& norm = outcome_.result.norm_K;
    // On open surfaces the largest reflectivity bounds it.
    norm = surface_.closed ? norm_of_K(surface_, problem_.reflectivity, rho_, kernel_integral)
                           : Approximation::without_radius(largest(rho_));
  }

  /// Int f psi_a dS, with the weight of the functions if so wanted.
  template <class Function>
  [[nodiscard]] std::vector<double> load_of(const Function& f, bool weighted) const {
    constexpr int higher = 12;
    std::vector<double> out;
    for_points(degree_ + higher, [&](std::size_t, const auto& at) {
      accumulate(at, f(at.chart, at.point) * (weighted ? at.weight : 1.0), out);
    });
    return out;
  }

  struct LoadPoint {
    std::size_t element;
    std::size_t chart;
    ParameterPoint<double> at;
    Vector<double> point;
    double dS;
    double weight;
    Barycentric<double> x;
  };

  /// Runs over the points of a conical rule on all elements.
  template <class Body>
  void for_points(int order, const Body& body) const {
    const TriangleRule<double> rule = conical_rule<double>(order, Grading::none);
    const SurfaceFunction rho(problem_.reflectivity, surface_);
    std::size_t place = 0;
    for (std::size_t k = 0; k < triangulation_.triangles.size(); ++k) {
      const ParameterTriangle& triangle = triangulation_.triangles[k];
      const double parallelogram = triangle.doubled_area();
      const ChartIn<double>& chart = surface_.charts[triangle.chart].in<double>();
      for (std::size_t q = 0; q < rule.weights.size(); ++q) {
        const ParameterPoint<double> at = triangle.at(rule.points[q].x);
        const Frame<double> frame = chart.frame(at);
        body(place++, LoadPoint{.element = k,
                                .chart = triangle.chart,
                                .at = at,
                                .point = frame.point,
                                .dS = rule.weights[q] * parallelogram * area_element(frame),
                                .weight = reflects_[k] ? 1 / rho(triangle.chart, frame.point) : 1.0,
                                .x = rule.points[q]});
      }
    }
  }

  /// Adds f dS psi_a at a point.
  void accumulate(const LoadPoint& at, double f, std::vector<double>& out) const {
    const std::size_t p = functions_->functions();
    out.resize(functions_->elements() * p);
    std::array<double, most_basis_functions> l{};
    basis_.values(at.x, std::span<double>(l).first(p));
    const Matrix<double>& psi = functions_->coefficients(at.element);
    for (std::size_t a = 0; a < p; ++a) {
      double value = 0;
      for (std::size_t c = 0; c < p; ++c) value += psi(a, c) * l[c];
      out[at.element * p + a] += at.dS * f * value;
    }
  }

  /// Values at points, with radii where they are known.
  struct Values {
    std::vector<double> value;
    std::optional<std::vector<double>> radius;
  };

  [[nodiscard]] Values values_of(const PiecewiseExpression& f, const std::string& pointer,
                                 std::span<const CollocationPoint<double>> points) const {
    Values out{values_at_nodes(f, pointer, surface_, points), std::nullopt};
    out.radius = value_radii(f, surface_, points, out.value);
    return out;
  }

  /// Ku by the second route.
  [[nodiscard]] Values operator_at(std::span<const CollocationPoint<double>> points,
                                   const OperatorRoute& route) const {
    const std::vector<double> rho = reflectivity_at_nodes(problem_.reflectivity, surface_, points);
    OperatorAtNodes ku = apply_operator(problem_, surface_, route, points, rho);
    Values out{std::move(ku.value), std::nullopt};
    if (all_finite(ku.radius)) out.radius = std::move(ku.radius);
    return out;
  }

  /// Ku/rho = 1/pi Int G u, which is smoother than rho; 0 where rho is, which is not asked for.
  [[nodiscard]] Values scattered_at(std::span<const CollocationPoint<double>> points,
                                    const OperatorRoute& route) const {
    const std::vector<double> rho = reflectivity_at_nodes(problem_.reflectivity, surface_, points);
    Values out = operator_at(points, route);
    for (std::size_t i = 0; i < rho.size(); ++i) {
      if (rho[i] == 0) continue;
      out.value[i] /= rho[i];
      if (out.radius) (*out.radius)[i] = (*out.radius)[i] / rho[i] + 2 * unit * std::abs(out.value[i]);
    }
    return out;
  }

  /// E at the nodes, which is told and not used.
  [[nodiscard]] std::vector<double> emission_at_nodes(const OperatorRoute& route,
                                                      std::span<const double> u) const {
    if (problem_.emission) return values_at_nodes(*problem_.emission, "/emission", surface_, nodes_);
    std::vector<double> e = operator_at(nodes_, route).value;
    for (std::size_t i = 0; i < e.size(); ++i) e[i] = u[i] - e[i];
    return e;
  }

  [[nodiscard]] std::vector<CollocationPoint<double>> points_of(int order) const {
    std::vector<CollocationPoint<double>> points;
    for_points(order, [&](std::size_t, const LoadPoint& at) {
      points.push_back(collocation_point<double>(surface_, {at.chart, at.at}));
    });
    return points;
  }

  /// The load of values at the points of a rule.
  [[nodiscard]] Load load_by_rule(int order, const Values& f, bool weighted = true) const {
    Load load;
    std::vector<double> measures;
    for_points(order, [&](std::size_t i, const LoadPoint& at) {
      const double weight = weighted ? at.weight : 1.0;
      accumulate(at, f.value[i] * weight, load.values);
      measures.push_back(at.dS * weight);
    });
    if (f.radius) load.radius = weighted_norm(measures, *f.radius);
    load.size = weighted_norm(measures, f.value);
    return load;
  }

  /// The load of f, without the weight, given at the points of a conical rule of order n, by a finer one: f
  /// is replaced by the polynomial of degree n - 1 in the parameters whose modes are those of f by the rule,
  /// which is exact for their products. So what the rule leaves out does not depend on the area element.
  [[nodiscard]] Load load_of_interpolant(int n, const Values& f) const {
    const TriangleRule<double> coarse = conical_rule<double>(n, Grading::none);
    const TriangleRule<double> fine = conical_rule<double>(degree_ + load_order, Grading::none);
    const std::size_t modes = mode_count(n - 1);
    const auto values_of_modes = [&](const TriangleRule<double>& rule) {
      Matrix<double> out(modes, rule.points.size());
      for (std::size_t q = 0; q < rule.points.size(); ++q)
        triangle_modes<double>(n - 1, rule.points[q], out.column(q));
      return out;
    };
    const Matrix<double> at_coarse = values_of_modes(coarse);
    const Matrix<double> at_fine = values_of_modes(fine);
    const std::size_t given = coarse.points.size();
    const std::size_t wanted = fine.points.size();
    Values out;
    if (f.radius) out.radius.emplace();
    std::vector<double> coefficients(modes);
    for (std::size_t k = 0; k < triangulation_.triangles.size(); ++k) {
      std::fill(coefficients.begin(), coefficients.end(), 0.0);
      double radius = 0;
      for (std::size_t q = 0; q < given; ++q) {
        for (std::size_t m = 0; m < modes; ++m)
          coefficients[m] += 2 * coarse.weights[q] * at_coarse(m, q) * f.value[k * given + q];
        if (f.radius) radius = std::max(radius, (*f.radius)[k * given + q]);
      }
      for (std::size_t q = 0; q < wanted; ++q) {
        double value = 0;
        for (std::size_t m = 0; m < modes; ++m) value += coefficients[m] * at_fine(m, q);
        out.value.push_back(value);
        // Bessel: the projection enlarges no mean square; the area element differs little over an element.
        if (f.radius) out.radius->push_back(2 * radius);
      }
    }
    return load_by_rule(degree_ + load_order, out, false);
  }

  static std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> out(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) out[i] = a[i] - b[i];
    return out;
  }

  /// The right-hand side, and by what two rules for it differ. Where u is given it is that of u less that of
  /// Ku, which is smoother and costs more.
  void find_load(const OperatorRoute& route) {
    const PiecewiseExpression& data = problem_.solution ? *problem_.solution : *problem_.emission;
    const std::string pointer = problem_.solution ? "/solution" : "/emission";
    const auto of_data = [&](int order) {
      return load_by_rule(order, values_of(data, pointer, points_of(order)));
    };
    const int order = degree_ + load_order;
    load_ = of_data(order);
    double left_out = euclidean_norm(difference(load_.values, of_data(order - 1).values));
    if (problem_.solution) {
      const Stopwatch watch;
      const auto of_operator = [&](int n) {
        return load_of_interpolant(n, scattered_at(points_of(n), route));
      };
      const int n = degree_ + operator_order;
      const Load ku = of_operator(n);
      left_out += euclidean_norm(difference(ku.values, of_operator(n - 1).values));
      outcome_.timing.operator_seconds += watch.seconds();
      load_.values = difference(load_.values, ku.values);
      load_.radius = load_.radius && ku.radius ? std::optional(*load_.radius + *ku.radius) : std::nullopt;
      load_.size += ku.size;
    }
    if (load_.radius) *load_.radius += left_out + unit * static_cast<double>(order * order + 16) * load_.size;
  }

  void solve() {
    const Stopwatch watch;
    const std::size_t n = load_.values.size();
    std::vector<std::size_t> active;
    for (std::size_t i = 0; i < n; ++i)
      if (is_active(i)) active.push_back(i);
    // On pieces that reflect nothing the coefficients are those of E.
    x_ = load_.values;
    std::vector<double> b;
    for (const std::size_t i : active) {
      double sum = load_.values[i];
      for (std::size_t j = 0; j < n; ++j)
        if (!is_active(j)) sum += matrix_.entries(i, j) * load_.values[j];
      b.push_back(sum);
    }
    const bool all_active = active.size() == n;
    if (!all_active) {
      Matrix<double> part(active.size(), active.size());
      for (std::size_t j = 0; j < active.size(); ++j)
        for (std::size_t i = 0; i < active.size(); ++i) part(i, j) = matrix_.entries(active[i], active[j]);
      matrix_.entries = std::move(part);
    }
    const std::optional<double> tolerance =
        problem_.solver.tolerance ? std::optional(problem_.solver.tolerance->to_double()) : std::nullopt;
    const Outcome<DefiniteSolution> found =
        solve_by_conjugate_gradients(matrix_.entries, b, definiteness(), tolerance);
    if (!found) refuse(found.reason());
    for (std::size_t i = 0; i < active.size(); ++i) x_[active[i]] = found->values[i];
    outcome_.result.iteration = {
        .iterations = found->iterations, .contraction = 1 - lower_, .error_bound = found->error_bound};
    if (load_.radius) {
      const double off = eta();
      const double size = euclidean_norm(x_);
      const double rounding = unit * static_cast<double>(n + 64) * (size + load_.size);
      const double left = lower_ * (1 - off);
      // On the black pieces the error is that of the load.
      if (left > 0)
        l2_radius_ = (found->residual + off * size + *load_.radius + rounding) / left + *load_.radius;
    }
    outcome_.timing.solve_seconds = watch.seconds();
  }

  void describe(const OperatorRoute& route) {
    const std::size_t p = functions_->functions();
    std::vector<double> values(x_.size());
    double radius = 0;
    for (std::size_t k = 0; k < functions_->elements(); ++k) {
      const Matrix<double>& psi = functions_->coefficients(k);
      for (std::size_t c = 0; c < p; ++c) {
        double square = 0;
        for (std::size_t a = 0; a < p; ++a) {
          values[k * p + c] += x_[k * p + a] * psi(a, c);
          square += psi(a, c) * psi(a, c);
        }
        radius = std::max(radius, l2_radius_.value_or(0) * std::sqrt(square));
      }
    }
    if (!all_finite(values) || !std::isfinite(radius))
      refuse("u_n or its radius runs over the range of double");
    const std::optional<double> known = l2_radius_ ? std::optional(radius) : std::nullopt;
    std::vector<double> u;
    if (problem_.solution) u = values_at_nodes(*problem_.solution, "/solution", surface_, nodes_);
    const std::vector<double> emission = emission_at_nodes(route, u);
    if (problem_.solution) {
      double error = 0;
      for (std::size_t i = 0; i < u.size(); ++i) error = std::max(error, std::abs(u[i] - values[i]));
      outcome_.result.node_error = known ? Approximation::estimated(error, *known + 4 * unit * largest(u))
                                         : Approximation::without_radius(error);
    }
    describe_collocation(problem_, geometry_.data(), basis_,
                         {.u_n = with_radius(values, known), .emission = emission, .u = u}, outcome_);
    describe_means(values);
  }

  /// By Cauchy's inequality |Int e dS| <= ||e|| area^(1/2): sharper than by the largest value of e.
  void describe_means(const std::vector<double>& values) {
    const NodalFunction u_n(surface_, triangulation_, basis_, values);
    constexpr int higher = 6;
    if (problem_.solution) {
      const auto errors = mean_errors(u_n.computed(), *problem_.solution, degree_ + higher, l2_radius_);
      if (errors) {
        outcome_.result.l2_error = errors->l2;
        outcome_.result.mean_error = errors->mean;
      }
    }
    if (!l2_radius_) return;
    const double of_rules = radius_of_means(u_n, 0);
    std::vector<double> areas(surface_.piece_names().size());
    for_points(degree_ + higher,
               [&](std::size_t, const LoadPoint& at) { areas[surface_.piece_of(at.chart)] += at.dS; });
    for (std::size_t i = 0; i < areas.size(); ++i) {
      Approximation& mean = outcome_.result.piece_means[i].second;
      mean = Approximation::estimated(mean.value, of_rules + *l2_radius_ / std::sqrt(areas[i]) * (1 + 1e-10));
    }
  }

  /// By how much the order of the rules exceeds the degree: of what is known as a formula, and of Ku, for
  /// which the error of functionals of smooth solutions, h^(2r+2), is still larger than that of the rule.
  static constexpr int load_order = 12;
  static constexpr int operator_order = 3;
  const Problem& problem_;
  int degree_;
  TriangleBasis<double> basis_;
  LevelGeometry geometry_;
  const Surface& surface_ = geometry_.data().surface;
  const Triangulation& triangulation_ = geometry_.data().triangulation;
  const std::vector<CollocationPoint<double>>& nodes_ = geometry_.data().nodes;
  double lower_;                ///< of v^T (W - A) v over v^T W v, A and the masses W exact
  std::vector<bool> reflects_;  ///< by element: rho > 0
  std::vector<double> rho_;
  std::optional<LocalFunctions> functions_;
  GalerkinMatrix matrix_;
  Load load_;
  std::vector<double> x_;
  std::optional<double> l2_radius_;  ///< of u_n in L2 against the exact Galerkin solution
  LevelOutcome outcome_;
};

}  // namespace

LevelOutcome solve(const Problem& problem, const Galerkin& method, int level, const OperatorRoute& route) {
  return GalerkinLevel(problem, method, level).compute(route);
}

}  // namespace radcert
