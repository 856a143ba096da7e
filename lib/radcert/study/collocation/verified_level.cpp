// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/verified_level.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "radcert/clusters/certified/enclosed_clusters.h"
#include "radcert/clusters/cluster_operator.h"
#include "radcert/collocation/certified/certified_chart_entries.h"
#include "radcert/collocation/certified/certified_operator.h"
#include "radcert/collocation/certified/certified_visible_entries.h"
#include "radcert/collocation/certified/plane_chart.h"
#include "radcert/collocation/certified/plane_entries.h"
#include "radcert/core/errors.h"
#include "radcert/core/memory_plan.h"
#include "radcert/core/parallel.h"
#include "radcert/core/work_limit.h"
#include "radcert/hypotheses/convex_containment.h"
#include "radcert/quadrature/certified/bounded_chart.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/solve/contracting_system.h"
#include "radcert/solve/contraction.h"
#include "radcert/solve/linear_solver.h"
#include "radcert/solve/verified_system.h"
#include "radcert/study/collocation/exact_interpolant.h"
#include "radcert/study/collocation/graded_levels.h"
#include "radcert/study/collocation/iterated_solution.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/collocation/matrix_form.h"
#include "radcert/study/collocation/nodal_description.h"
#include "radcert/study/collocation/node_data.h"
#include "radcert/study/collocation/operator_norm.h"
#include "radcert/study/stopwatch.h"

namespace radcert {
namespace {

/// Of balls: the values at the nodes are then exact beside the radii of the matrix.
const WorkLimit ball_bits("study/verified_level: bits of balls", 128, BallPrecision::smallest_bits,
                          "wider radii, or refused");
const WorkLimit boxes_of_size("study/verified_level: boxes in search of the largest value", 2000, 0,
                              "a demand relative to the largest value found: tighter than need be");
/// Of the polynomials that the closed form takes.
constexpr int largest_degree = 8;
constexpr double unit = unit_roundoff<double>();
/// Enough for a handful of roundings.
constexpr double upward = 1 + 8 * unit;
constexpr double underflow = std::numeric_limits<double>::denorm_min();

[[noreturn]] void refuse(int level, const std::string& reason) {
  throw AccuracyNotReached("level " + std::to_string(level) + ", solver verified", "no guarantee: " + reason);
}

/// What can be seen before the level is built.
void require_provable(const Problem& problem, int level) {
  if (problem.geometry && problem.geometry->data == DataPoints::interpolant)
    refuse(level,
           "the problem is posed on an interpolant, which is not proved to lie in the boundary of a convex "
           "body");
  const Surface surface = surface_of(problem);
  require_known_layers(problem, surface, level);
  if (!surface.unoccluded && problem.solution)
    refuse(level,
           "parts of the surface hide each other, and Ku over the visible parts is not enclosed; with "
           "`emission` in place of `solution` the system is proved");
  // That of a mesh has been decided when it was read.
  if (surface.mesh) return;
  const ConvexContainment containment = convex_containment(surface);
  if (containment.verdict != Containment::certified)
    refuse(level, "the surface is not proved to lie in the boundary of a convex body: " + containment.reason);
}

/// A square of a chart's parameters with corners at multiples of 2^-depth, and a bound of |u| over it.
struct SizeBox {
  double most = 0;
  std::size_t chart = 0;
  long s = 0;
  long t = 0;
  int depth = 0;
  friend bool operator<(const SizeBox& a, const SizeBox& b) { return a.most < b.most; }
};

/// A value of |u| that no other is twice as large as, or the largest that was found: at least `at_nodes`.
/// Maths     the box with the largest bound is quartered, and |u| taken at its corner, until no bound exceeds
///           twice the largest value
double found_size(const PiecewiseExpression& u, const Surface& surface, double at_nodes) {
  const auto range = [&](std::size_t chart, const Ball& s, const Ball& t) {
    const Vector<Ball> q = surface.charts[chart].in<Ball>().frame({s, t}).point;
    return abs(u.on(surface.charts[chart].facts().piece).evaluate<Ball>({q.x, q.y, q.z}));
  };
  const auto place = [](long k, int depth) { return Ball(std::ldexp(static_cast<double>(k), -depth)); };
  constexpr int deepest = 50;
  double found = at_nodes;
  std::priority_queue<SizeBox> boxes;
  const auto add = [&](SizeBox box) {
    const bool triangle = surface.charts[box.chart].facts().domain == ChartDomain::unit_triangle;
    if (triangle && box.s + box.t >= 1L << box.depth) return;
    const Ball s = place(box.s, box.depth);
    const Ball t = place(box.t, box.depth);
    const double value = range(box.chart, s, t).lower_double();
    if (std::isfinite(value)) found = std::max(found, value);
    box.most = range(box.chart, hull(s, place(box.s + 1, box.depth)), hull(t, place(box.t + 1, box.depth)))
                   .upper_double();
    boxes.push(box);
  };
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart) add({.chart = chart});
  for (long seen = 0; seen < boxes_of_size.value() && !boxes.empty(); ++seen) {
    const SizeBox box = boxes.top();
    if (!(box.most > 2 * found) || box.depth >= deepest) break;
    boxes.pop();
    for (const long s : {2 * box.s, 2 * box.s + 1})
      for (const long t : {2 * box.t, 2 * box.t + 1})
        add({.chart = box.chart, .s = s, .t = t, .depth = box.depth + 1});
  }
  return found;
}

/// A piecewise expression as a density.
struct PiecewiseDensity {
  std::vector<Expression> by_chart;
  template <class R>
  R operator()(const DensityPoint<R>& q) const {
    return by_chart[q.chart].template evaluate<R>({q.point.x, q.point.y, q.point.z});
  }
};

/// rho_i times row i, for all numbers within the radii.
void scale_row_entries(CertifiedEntries& matrix, std::span<const Ball> rho) {
  std::vector<Approximation> factors;
  for (const Ball& value : rho) factors.push_back(enclosing(value));
  parallel_for(matrix.entries.columns(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      const std::span<double> entries = matrix.entries.column(j);
      const std::span<double> radii = matrix.radius.column(j);
      for (std::size_t i = 0; i < factors.size(); ++i) {
        const double factor = factors[i].value;
        const double inexact = factors[i].radius;
        const double entry = factor * entries[i];
        const double moved = std::abs(factor) * radii[i] + inexact * (std::abs(entries[i]) + radii[i]);
        radii[i] = (moved + unit * std::abs(entry)) * upward + 4 * underflow;
        entries[i] = entry;
      }
    }
  });
}

/// sum_j k_ij u_j for all matrices within the radii.
std::vector<Ball> enclosed_product(const CertifiedEntries& k, std::span<const Ball> u) {
  const std::size_t n = u.size();
  constexpr std::size_t rows_at_a_time = 64;
  std::vector<Ball> result(n);
  std::vector<double> sizes;
  for (const Ball& value : u) sizes.push_back(abs(value).upper_double());
  parallel_for(n, rows_at_a_time, [&](std::size_t begin, std::size_t end) {
    const BallPrecision inside(ball_bits.value());
    std::vector<double> moved(end - begin);
    for (std::size_t j = 0; j < n; ++j) {
      const std::span<const double> entries = k.entries.column(j);
      const std::span<const double> radii = k.radius.column(j);
      for (std::size_t i = begin; i < end; ++i) {
        result[i] += Ball(entries[i]) * u[j];
        moved[i - begin] += radii[i] * sizes[j];
      }
    }
    const auto terms = static_cast<double>(n);
    for (std::size_t i = begin; i < end; ++i)
      result[i] = widened(result[i], Ball(moved[i - begin] * (1 + (terms + 8) * unit) + terms * underflow));
  });
  return result;
}

std::vector<Approximation> enclosed_numbers(std::span<const Ball> balls) {
  std::vector<Approximation> numbers;
  for (const Ball& ball : balls) numbers.push_back(enclosing(ball));
  return numbers;
}

std::vector<double> midpoints(std::span<const Ball> balls) {
  std::vector<double> values;
  for (const Ball& ball : balls) values.push_back(ball.to_double());
  return values;
}

/// The finished pieces of one level, in the order in which they are computed.
class VerifiedLevel {
public:
  VerifiedLevel(const Problem& problem, int level)
      : problem_(problem),
        basis_(triangle_basis(triangle_basis_of(problem.method))),
        functions_(exact_functions(triangle_basis_of(problem.method))),
        geometry_(problem, level, basis_),
        nodes_(exact_collocation_nodes(geometry_.data().triangulation, functions_)) {
    outcome_.result = level_header(problem, level,
                                   {.elements = geometry_.data().triangulation.triangles.size(),
                                    .unknowns = nodes_.size(),
                                    .mesh_size = geometry_.mesh_size()});
    for (std::size_t j = 0; j < surface_.chart_count(); ++j) planes_.push_back(plane_chart(surface_, j));
    all_plane_ = !problem.geometry && std::all_of(planes_.begin(), planes_.end(),
                                                  [](const auto& plane) { return plane.has_value(); });
  }

  VerifiedLevel(const VerifiedLevel&) = delete;
  VerifiedLevel& operator=(const VerifiedLevel&) = delete;

  LevelOutcome compute(const OperatorRoute& route) && {
    require_exact_geometry();
    find_data();
    if (takes_clusters(problem_, nodes_.size())) {
      solve_by_clusters(route);
      describe(route);
      return std::move(outcome_);
    }
    const Stopwatch assembly;
    CertifiedEntries matrix =
        problem_.solution && !all_plane_ && !problem_.geometry ? entries_and_integrals() : entries();
    require_rows_of_one(matrix);
    outcome_.result.norm_K = norm(matrix);
    scale_row_entries(matrix, rho_);
    outcome_.timing.assembly_seconds = assembly.seconds();
    std::vector<Ball> defect;
    if (problem_.solution) defect = discretisation([&] { return enclosed_product(matrix, u_); }, route);
    const Stopwatch solution;
    solve(std::move(matrix), defect);
    outcome_.timing.solve_seconds = solution.seconds();
    describe(route);
    return std::move(outcome_);
  }

private:
  [[noreturn]] void refuse(const std::string& reason) const {
    radcert::refuse(outcome_.result.level, reason);
  }

  void require_exact_geometry() const {
    if (!problem_.geometry) return;
    const Outcome<void> exact =
        is_exact_interpolant(geometry_.data(), geometry_.integrals(), problem_.geometry->degree);
    if (!exact) refuse("the interpolated geometry is not known exactly: " + exact.reason());
  }

  /// Int_S G dS = pi at every point of the boundary of a convex body [ac98, section 2]: where the functions
  /// have the sum 1, so has each row of the matrix for the reflectivity 1. A row that is proved to have
  /// another sum would be a false proof.
  void require_rows_of_one(const CertifiedEntries& matrix) const {
    if (!surface_.closed || problem_.geometry || functions_.reproduced_degree() < 0) return;
    require_sums_of_one(enclosed_product(matrix, std::vector<Ball>(nodes_.size(), Ball(1))));
  }

  void require_sums_of_one(const std::vector<Ball>& sums) const {
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (!overlaps(sums[i], Ball(1)))
        refuse("row " + std::to_string(i) + " of the collocation matrix is enclosed by " + sums[i].to_text() +
               " where it must be 1");
  }

  const std::string& piece_of(std::size_t i) const { return surface_.charts[nodes_[i].chart].facts().piece; }

  /// The value at a node: exactly rounded where it is rational by + - * /.
  Ball value_at_node(const Expression& f, std::size_t i) const {
    if (const std::optional<PlaneChart>& plane = planes_[nodes_[i].chart]) {
      const Vector<Rational> zero;
      if (const auto exact = polynomial_on_plane(f, plane->point(nodes_[i].at), zero, zero, 0))
        return Ball((*exact)(0, 0));
    }
    const Vector<Ball> q =
        surface_.charts[nodes_[i].chart].in<Ball>().frame({Ball(nodes_[i].at.s), Ball(nodes_[i].at.t)}).point;
    return f.evaluate<Ball>({q.x, q.y, q.z});
  }

  std::vector<Ball> values(const PiecewiseExpression& function, const std::string& pointer) const {
    static_cast<void>(values_at_nodes(function, pointer, surface_, geometry_.data().nodes));
    std::vector<Ball> result;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const Expression& f = function.on(piece_of(i));
      result.push_back(value_at_node(f, i));
      if (!result.back().is_finite())
        refuse(f.text() + " is not proved to have a value at node " + std::to_string(i) + " on piece " +
               piece_of(i) + ": " + std::string(result.back().failure()));
    }
    return result;
  }

  void find_data() {
    const std::vector<double> rounded =
        reflectivity_at_nodes(problem_.reflectivity, surface_, geometry_.data().nodes);
    rho_ = values(problem_.reflectivity, "/reflectivity");
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (!certainly_at_most(Ball(0), rho_[i]) || !certainly_at_most(rho_[i], Ball(1)))
        refuse("the reflectivity " + problem_.reflectivity.on(piece_of(i)).text() +
               " is not proved to lie in [0, 1] at node " + std::to_string(i) + " on piece " + piece_of(i));
    if (surface_.closed) refuse_norm_from_one(norm_of_K(surface_, problem_.reflectivity, rounded, {}));
    if (surface_.closed || problem_.emission) {
      const Outcome<void> below = reflectivity_below_one(surface_, problem_.reflectivity);
      if (!below) refuse("the norm of K is not proved to be below 1: " + below.reason());
    }
    if (problem_.solution) u_ = values(*problem_.solution, "/solution");
    if (problem_.emission) emission_ = values(*problem_.emission, "/emission");
  }

  /// The matrix for the reflectivity 1.
  CertifiedEntries entries() const {
    Outcome<CertifiedEntries> found =
        !surface_.unoccluded ? certified_mesh_entries(surface_, geometry_.data().triangulation, functions_)
        : all_plane_         ? plane_entries()
                             : chart_entries();
    if (!found) refuse("the entries of the collocation matrix are not enclosed: " + found.reason());
    return std::move(found).value();
  }

  /// With it Int_S G u dS at the nodes.
  CertifiedEntries entries_and_integrals() {
    Outcome<CertifiedCollocation> found = within_tolerance<CertifiedCollocation>([&](double tolerance) {
      return certified_collocation(geometry_.data().surface, geometry_.data().triangulation, functions_,
                                   density_of_u(), size_of_u(), tolerance);
    });
    // Which of the two it was is known when they are asked for one by one.
    if (!found) return entries();
    integrals_ = balls_of(found->integrals);
    return std::move(found->matrix);
  }

  Outcome<CertifiedEntries> plane_entries() const {
    std::vector<PlaneChart> elements;
    for (const ParameterTriangle& triangle : geometry_.data().triangulation.triangles) {
      std::array<ParameterPoint<Rational>, 3> corners;
      for (std::size_t c = 0; c < 3; ++c)
        corners[c] = {Rational::exactly(triangle.vertices[c].s), Rational::exactly(triangle.vertices[c].t)};
      elements.push_back(planes_[triangle.chart]->over(corners));
    }
    return certified_plane_entries(elements, functions_);
  }

  Outcome<CertifiedEntries> chart_entries() const {
    const std::vector<double> ones(nodes_.size(), 1.0);
    return within_tolerance<CertifiedEntries>([&](double tolerance) {
      return certified_chart_entries(geometry_.integrals().surface, geometry_.integrals().triangulation,
                                     functions_, ones, tolerance);
    });
  }

  /// With the tolerance of the problem; where the roundings of double are wider, with one that they may
  /// reach.
  template <class T, class Attempt>
  Outcome<T> within_tolerance(const Attempt& attempt) const {
    const double tolerance = problem_.quadrature.tolerance.to_double();
    Outcome<T> found = attempt(tolerance);
    for (const double wider : {8.0, 64.0})
      if (!found) found = attempt(wider * tolerance);
    return found;
  }

  Approximation norm(const CertifiedEntries& matrix) const {
    std::vector<double> integrals(nodes_.size());
    for (std::size_t j = 0; j < nodes_.size(); ++j)
      for (std::size_t i = 0; i < nodes_.size(); ++i) integrals[i] += pi<double>() * matrix.entries(i, j);
    return norm_of_K(surface_, problem_.reflectivity, midpoints(rho_), integrals);
  }

  /// Int_S G u dS at the nodes.
  std::vector<Ball> operator_at_nodes() const {
    const PiecewiseExpression& u = *problem_.solution;
    if (all_plane_) {
      std::vector<PlaneChart> charts;
      std::vector<ChartDomain> domains;
      std::vector<PlanePolynomial<Rational>> density;
      for (std::size_t j = 0; j < surface_.chart_count(); ++j) {
        const PlaneChart& plane = *planes_[j];
        auto polynomial = polynomial_on_plane(u.on(surface_.charts[j].facts().piece), plane.origin,
                                              plane.first, plane.second, largest_degree);
        if (!polynomial) break;
        charts.push_back(plane);
        domains.push_back(surface_.charts[j].facts().domain);
        density.push_back(std::move(*polynomial));
      }
      if (charts.size() == surface_.chart_count()) {
        std::vector<PlaneNode> points;
        for (const SurfacePoint<Rational>& node : nodes_)
          points.push_back({planes_[node.chart]->point(node.at), planes_[node.chart]->normal()});
        return plane_operator(charts, domains, density, points);
      }
    }
    // Int |G| is at most pi.
    const double scale = pi<double>() * size_of_u();
    const auto found = within_tolerance<CertifiedValues>([&](double tolerance) {
      return certified_operator(surface_, geometry_.data().triangulation, density_of_u(), nodes_,
                                tolerance * scale);
    });
    if (!found) refuse("Ku is not enclosed: " + found.reason());
    return balls_of(*found);
  }

  DensityFormula density_of_u() const {
    PiecewiseDensity piecewise;
    for (const Chart& chart : surface_.charts)
      piecewise.by_chart.push_back(problem_.solution->on(chart.facts().piece));
    return density(std::move(piecewise));
  }
  /// About the largest |u|, not at the nodes alone: a peak between them is what Ku comes from, and a demand
  /// relative to less would not be met. 1 where u vanishes, or nearly so: a part of it is still a number to
  /// be demanded.
  double size_of_u() const {
    constexpr double least = 1e-250;
    constexpr double largest = 1e250;
    const double size = found_size(*problem_.solution, surface_, max_abs(enclosed_numbers(u_)).value);
    if (!(size <= largest))
      refuse("|u| has no bound that a double holds, with room for sums, on the surface");
    return size > least ? size : 1;
  }
  static std::vector<Ball> balls_of(const CertifiedValues& found) {
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < found.values.size(); ++i)
      balls.push_back(ball_of(Approximation::proved(found.values[i], found.radius[i])));
    return balls;
  }

  /// On curved charts the entries of the matrix and Int_S G u dS come from the same sums, where a fault would
  /// pass unseen. The route shares nothing with them, as the build sees to: at nodes that are spread over the
  /// surface it has to find the same, to half of the digits of double, as it takes the nodes as rounded and
  /// its radius is an estimate.
  void require_second_route(const std::vector<Ball>& integrals, const OperatorRoute& route) const {
    constexpr std::size_t most_compared = 8;
    const std::size_t count = std::min(most_compared, nodes_.size());
    const SurfaceFunction u(*problem_.solution, surface_);
    const AppliedOperator second = route(surface_, u);
    const double apart = std::sqrt(std::numeric_limits<double>::epsilon()) * pi<double>() * size_of_u();
    std::vector<std::string> faults(count);
    parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const std::size_t i = count > 1 ? k * (nodes_.size() - 1) / (count - 1) : 0;
        const Approximation found = second(geometry_.data().nodes[i].at);
        if (found.has_radius() &&
            !overlaps(integrals[i], ball_of(Approximation::proved(found.value, found.radius + apart))))
          faults[k] = "the integral of G u at node " + std::to_string(i) + " is enclosed by " +
                      integrals[i].to_text() + ", and by the second route it is " +
                      nearest_text(found.value, DecimalForm::general(17));
      }
    });
    for (const std::string& fault : faults)
      if (!fault.empty()) refuse(fault);
  }

  /// K(I - P_n)u at the nodes; E = u - Ku is found with it. `k_pn_u`: rho times the matrix times u.
  template <class Product>
  std::vector<Ball> discretisation(const Product& k_pn_u, const OperatorRoute& route) {
    const Stopwatch watch;
    const std::vector<Ball> integrals = integrals_ ? *integrals_ : operator_at_nodes();
    require_second_route(integrals, route);
    outcome_.timing.operator_seconds = watch.seconds();
    std::vector<Ball> difference = k_pn_u();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const Ball ku = rho_[i] * integrals[i] / Ball::pi();
      if (!ku.is_finite()) refuse("Ku is not enclosed at node " + std::to_string(i));
      emission_.push_back(u_[i] - ku);
      difference[i] = ku - difference[i];
    }
    outcome_.result.discretisation_error = max_abs(enclosed_numbers(difference));
    return difference;
  }

  void solve(CertifiedEntries matrix, std::span<const Ball> defect) {
    Outcome<VerifiedSystem> system = verified_system(std::move(matrix.entries), std::move(matrix.radius));
    if (!system) refuse("the collocation system is not proved to have one solution: " + system.reason());
    std::vector<double> right_hand_side;
    std::vector<double> radius;
    for (const Approximation& number : enclosed_numbers(problem_.solution ? defect : emission_)) {
      right_hand_side.push_back(number.value);
      radius.push_back(number.radius);
    }
    const Outcome<VerifiedSolution> solved = system->solve(right_hand_side, radius);
    if (!solved) refuse("the collocation system is not solved: " + solved.reason());
    take_solution(*solved, system->theta());
  }

  /// u_n from the solution of the system: u - u_n at the nodes, or u_n.
  void take_solution(const VerifiedSolution& solved, double theta) {
    std::vector<Approximation> found;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      found.push_back(Approximation::proved(solved.values[i], solved.radius[i]));
    if (problem_.solution) {
      outcome_.result.node_error = max_abs(found);
      for (std::size_t i = 0; i < nodes_.size(); ++i) found[i] = enclosing(u_[i] - ball_of(found[i]));
    }
    for (const Approximation& value : found)
      if (!value.has_radius()) refuse("u_n or its radius runs over the range of double");
    u_n_ = std::move(found);
    outcome_.result.verified = {.theta = theta};
  }

  /// The same with the matrix as clusters: a solution of the operator in doubles, whose residual and
  /// contraction the enclosed products prove.
  void solve_by_clusters(const OperatorRoute& route) {
    const Stopwatch assembly;
    const std::size_t n = nodes_.size();
    const double far = problem_.matrix.tolerance.to_double();
    const Tolerance near(problem_.quadrature.tolerance.to_double());
    const Outcome<EnclosedClusters> clusters =
        enclosed_clusters({.surface = surface_,
                           .triangulation = geometry_.data().triangulation,
                           .level = outcome_.result.level,
                           .functions = functions_,
                           .far = ClusterTolerance(far),
                           .near = near,
                           .memory_limit = available_memory()});
    if (!clusters) refuse("the entries of the collocation matrix are not enclosed: " + clusters.reason());
    const std::vector<double> ones(n, 1.0);
    std::vector<Ball> sums;
    std::vector<double> integrals;
    for (const BoundedDouble& sum : clusters->product(ones)) {
      sums.push_back(ball_around(sum));
      integrals.push_back(pi<double>() * sum.value());
    }
    if (surface_.closed && functions_.reproduced_degree() >= 0) require_sums_of_one(sums);
    const std::vector<double> rho = midpoints(rho_);
    outcome_.result.norm_K = norm_of_K(surface_, problem_.reflectivity, rho, integrals);
    const LevelClusters tree = clusters_of_level(problem_, outcome_.result.level, one_rank()).value();
    const ClusterOperator rounded({.surface = surface_,
                                   .tree = tree.tree,
                                   .part = tree.part,
                                   .basis = basis_,
                                   .nodes = geometry_.data().nodes,
                                   .reflectivity = rho,
                                   .integrals = near,
                                   .far = ClusterTolerance(far),
                                   .memory_limit = available_memory()});
    outcome_.timing.assembly_seconds = assembly.seconds();

    std::vector<Ball> defect;
    if (problem_.solution) defect = discretisation([&] { return times_reflectivity(*clusters, u_); }, route);
    const Stopwatch solution;
    const std::span<const Ball> e = problem_.solution ? std::span<const Ball>(defect) : emission_;
    const std::vector<double> rounded_e = midpoints(e);
    const Outcome<Contraction, NoContraction> contraction =
        find_contraction(SystemMatrix(rounded), rounded.row_radius());
    if (!contraction)
      refuse("the collocation matrix contracts by " +
             upper_text(contraction.reason().theta, DecimalForm::general(6)) +
             " at best, which is not below 1: with the operator dense more may be proved");
    const auto found =
        find_linear_solver("gmres")->iterate(SystemMatrix(rounded), *contraction, rounded_e, {}, nullptr);
    const std::vector<double> x = found ? found->values : std::vector<double>(n);
    if (!found) refuse("the collocation system is not solved: gmres does not come to rest");
    std::vector<Ball> exact_x;
    for (const double value : x) exact_x.emplace_back(value);
    const std::vector<Ball> kx = times_reflectivity(*clusters, exact_x);
    const std::vector<double> weighted = clusters->sizes(contraction->weights());
    std::vector<double> residual;
    std::vector<double> sizes;
    for (std::size_t i = 0; i < n; ++i) {
      residual.push_back(abs(e[i] - exact_x[i] + kx[i]).upper_double());
      sizes.push_back((rho_[i] * Ball(weighted[i])).upper_double());
    }
    const Outcome<ContractingSolution> proved =
        contracting_solution(x, residual, contraction->weights(), sizes);
    if (!proved) refuse("the collocation system is not proved to have one solution: " + proved.reason());
    take_solution(proved->solution, proved->theta);
    outcome_.timing.solve_seconds = solution.seconds();
  }

  /// rho_i sum_j k_ij u_j for all u within the balls.
  std::vector<Ball> times_reflectivity(const EnclosedClusters& clusters, std::span<const Ball> u) const {
    double moved = 0;
    std::vector<double> middle;
    for (const Approximation& value : enclosed_numbers(u)) {
      middle.push_back(value.value);
      moved = std::max(moved, value.radius);
    }
    std::vector<double> sizes(u.size(), 0.0);
    if (moved > 0) sizes = clusters.sizes(std::vector<double>(u.size(), 1.0));
    std::vector<Ball> result;
    const std::vector<BoundedDouble> product = clusters.product(middle);
    for (std::size_t i = 0; i < u.size(); ++i)
      result.push_back(rho_[i] * widened(ball_around(product[i]), Ball(sizes[i]) * Ball(moved)));
    return result;
  }

  void describe(const OperatorRoute& route) {
    const std::vector<double> emission = midpoints(emission_);
    const std::vector<double> u = midpoints(u_);
    describe_collocation(problem_, geometry_.data(), basis_, {.u_n = u_n_, .emission = emission, .u = u},
                         outcome_);
    if (!problem_.iterated) return;
    EmissionAtPoints at_nodes{.values = emission, .radii = {}};
    for (const Ball& e : emission_) at_nodes.radii.push_back(e.radius());
    describe_iterated(problem_, geometry_.data(), basis_, at_nodes, route, outcome_);
  }

  const BallPrecision precision_{ball_bits.value()};
  const Problem& problem_;
  TriangleBasis<double> basis_;
  LagrangeFunctions functions_;
  LevelGeometry geometry_;
  const Surface& surface_ = geometry_.data().surface;
  std::vector<SurfacePoint<Rational>> nodes_;
  std::vector<std::optional<PlaneChart>> planes_;  ///< by chart
  bool all_plane_ = false;
  std::vector<Ball> rho_;
  std::vector<Ball> u_;
  std::vector<Ball> emission_;
  std::optional<std::vector<Ball>> integrals_;  ///< Int_S G u dS, where it was found with the matrix
  std::vector<Approximation> u_n_;
  LevelOutcome outcome_;
};

}  // namespace

LevelOutcome verified_level(const Problem& problem, int level, const OperatorRoute& route) {
  require_provable(problem, level);
  return VerifiedLevel(problem, level).compute(route);
}

}  // namespace radcert
