// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/search/symmetric_search.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/basis_facts.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/nodes/orbit_structure.h"
#include "radcert/polynomial/nodes/search/damped_least_squares.h"
#include "radcert/polynomial/nodes/search/lattice_norm.h"
#include "radcert/polynomial/nodes/search/random_starts.h"
#include "radcert/polynomial/nodes/symmetric_system.h"
#include "radcert/polynomial/triangle_modes.h"
#include "radcert/scalar/dual.h"

namespace radcert {

namespace {

constexpr double least_distance = 1e-3;  // of nodes from the border, in barycentric coordinates
constexpr double least_weight = 1e-3;    // of the mean, where weights have to be positive
constexpr double solved = 1e-24;         // the sum of the squares of what is missed
constexpr int most_iterations = 80;
constexpr std::size_t kept = 24;  // solutions from which small steps go on
constexpr int lattice = 40;
// Newton's method works with as many bits as certify, of which 60 digits are kept.
constexpr long bits = 512;
constexpr int digits = 62;
constexpr int digits_of_free_nodes = 12;

using Vector = Eigen::VectorXd;
using EigenMatrix = Eigen::MatrixXd;

/// Of candidates x are the weights, one an orbit, then a for each orbit of three, a and b for each of six.
class Search {
public:
  explicit Search(const SymmetricGoal& goal) : goal_(goal), structure_(orbit_structure(goal.degree)) {
    sizes_.insert(sizes_.end(), static_cast<std::size_t>(structure_.ones), 1);
    sizes_.insert(sizes_.end(), static_cast<std::size_t>(structure_.threes), 3);
    sizes_.insert(sizes_.end(), static_cast<std::size_t>(structure_.sixes), 6);
    for (const auto& [i, j, k] : lattice_indices(lattice))
      if (i >= j && j >= k)  // one of six
        lattice_.push_back({{1.0 * i / lattice, 1.0 * j / lattice, 1.0 * k / lattice}});
  }

  /// The solution to which the iteration comes from a random start, if it comes to one.
  [[nodiscard]] std::optional<Candidate> from_start(std::uint64_t seed) const {
    std::mt19937_64 random(seed);
    Candidate start;
    start.x.assign(sizes_.size(), 1.0 / node_count());
    for (int k = 0; k < structure_.threes; ++k) start.x.push_back(0.5 * uniform_number(random));
    for (int k = 0; k < structure_.sixes; ++k) {
      // The lengths of the parts of (0, 1) at two random points are uniform on the triangle.
      const auto [low, high] = std::minmax({uniform_number(random), uniform_number(random)});
      start.x.push_back(low);
      start.x.push_back(high - low);
    }
    return solution(std::move(start));
  }

  /// A solution as the goal wants it, with its norm.
  [[nodiscard]] std::optional<Candidate> solution(Candidate at) const {
    const auto functions = [this](const std::vector<double>& x) { return evaluate(x); };
    if (!damped_least_squares(at.x, functions, solved, most_iterations)) return std::nullopt;
    const auto weights_end = at.x.begin() + static_cast<std::ptrdiff_t>(sizes_.size());
    if (goal_.positive && *std::min_element(at.x.begin(), weights_end) < least_weight / node_count())
      return std::nullopt;
    std::vector<Barycentric<double>> points;
    for (const Node& node : nodes(at.x)) {
      points.push_back({{node.x[0].value, node.x[1].value, node.x[2].value}});
      if (*std::min_element(points.back().x.begin(), points.back().x.end()) < least_distance)
        return std::nullopt;
    }
    at.norm = norm_at(lattice_, goal_.degree, points);
    if (!std::isfinite(at.norm)) return std::nullopt;
    return at;
  }

  /// How many weights stand in front of a candidate's coordinates.
  [[nodiscard]] std::size_t weights() const { return sizes_.size(); }

  /// With the free numbers held, to 60 digits; nothing where Newton's method does not come to them.
  [[nodiscard]] std::optional<SymmetricNodes> sharpened(const Candidate& candidate) const {
    SymmetricNodes out{.degree = goal_.degree, .precision = goal_.precision, .orbits = {}};
    const std::vector<bool> held = numbers_to_hold(candidate);
    SymmetricBox box;
    const BallPrecision scope(bits);
    std::size_t place = sizes_.size();
    for (std::size_t k = 0; k < sizes_.size(); ++k) {
      OrbitBox orbit{.size = sizes_[k],
                     .is_held = held[k],
                     // Of a rule for integrals, not means: the triangle has the area 1/2.
                     .weight = Ball(candidate.x[k] / 2),
                     .a = Ball(0),
                     .b = Ball(0)};
      if (sizes_[k] >= 3) orbit.a = Ball(candidate.x[place++]);
      if (sizes_[k] == 6) orbit.b = Ball(candidate.x[place++]);
      if (held[k]) orbit.a = Ball(Rational::exactly(std::round(orbit.a.to_double() * 1e6)) / 1'000'000);
      box.push_back(orbit);
    }
    if (goal_.precision > goal_.degree && !refine(box)) return std::nullopt;
    for (const OrbitBox& orbit : box)
      out.orbits.push_back({.size = orbit.size,
                            .a = orbit.size >= 3 ? decimal(orbit.a) : Rational(),
                            .b = orbit.size == 6 ? decimal(orbit.b) : Rational(),
                            .is_held = orbit.is_held});
    return out;
  }

  /// The largest sum |l_j| on a lattice.
  [[nodiscard]] double norm(const SymmetricNodes& symmetric) const {
    std::vector<Barycentric<double>> nodes;
    for (const Barycentric<Rational>& q : symmetric.nodes())
      nodes.push_back({{q.x[0].to_double(), q.x[1].to_double(), q.x[2].to_double()}});
    return norm_at(lattice_, goal_.degree, nodes);
  }

private:
  using Node = Barycentric<Dual<double>>;

  [[nodiscard]] double node_count() const {
    return structure_.ones + 3 * structure_.threes + 6 * structure_.sixes;
  }

  /// The nodes, with their derivatives by the coordinates of their orbits.
  [[nodiscard]] std::vector<Node> nodes(const std::vector<double>& x_of_orbits) const {
    std::vector<Node> out;
    std::size_t place = sizes_.size();
    for (const int size : sizes_) {
      Dual<double> a(1.0 / 3, 0.0, 0.0);
      Dual<double> b = a;
      if (size >= 3) a = b = Dual<double>(x_of_orbits[place++], 1.0, 0.0);
      if (size == 6) b = Dual<double>(x_of_orbits[place++], 0.0, 1.0);
      const std::array<Dual<double>, 3> x = size == 6 ? std::array{a, b, Dual<double>(1.0) - a - b}
                                                      : std::array{Dual<double>(1.0) - a - b, a, b};
      for (const auto& p : symmetric_places(size)) out.push_back({{x[p[0]], x[p[1]], x[p[2]]}});
    }
    return out;
  }

  /// What is missed, and its derivatives by weights and coordinates. Polynomials that change their sign when
  /// x_1 and x_2 are exchanged are integrated exactly by every symmetric rule, and left out.
  [[nodiscard]] FunctionsThere evaluate(const std::vector<double>& x) const {
    const int precision = goal_.precision;
    std::vector<std::size_t> rows;
    for (int m = 0; m <= precision; ++m)
      for (int i = 0; i <= m; i += 2) rows.push_back(static_cast<std::size_t>(m * (m + 1) / 2 + i));
    FunctionsThere out{.values = std::vector<double>(rows.size()),
                       .derivatives = Matrix<double>(rows.size(), x.size())};
    out.values[0] = -1;
    std::vector<Dual<double>> modes(mode_count(precision));
    const std::vector<Node> all = nodes(x);
    std::size_t node = 0;
    std::size_t place = sizes_.size();
    for (std::size_t orbit = 0; orbit < sizes_.size(); ++orbit) {
      for (int i = 0; i < sizes_[orbit]; ++i) {
        triangle_modes<Dual<double>>(precision, all[node++], modes);
        for (std::size_t row = 0; row < rows.size(); ++row) {
          const Dual<double>& mode = modes[rows[row]];
          out.values[row] += x[orbit] * mode.value;
          out.derivatives(row, orbit) += mode.value;
          if (sizes_[orbit] >= 3) out.derivatives(row, place) += x[orbit] * mode.by_s;
          if (sizes_[orbit] == 6) out.derivatives(row, place + 1) += x[orbit] * mode.by_t;
        }
      }
      place += sizes_[orbit] == 1 ? 0 : sizes_[orbit] == 3 ? 1 : 2;
    }
    return out;
  }

  /// For each orbit whether its a is held: what remains is to determine the others as well as can be.
  [[nodiscard]] std::vector<bool> numbers_to_hold(const Candidate& at) const {
    std::vector<bool> held(sizes_.size(), false);
    if (goal_.precision == goal_.degree) return held;
    const FunctionsThere there = evaluate(at.x);
    const Eigen::Map<const EigenMatrix> derivatives(there.derivatives.column(0).data(),
                                                    static_cast<Eigen::Index>(there.derivatives.rows()),
                                                    static_cast<Eigen::Index>(there.derivatives.columns()));
    std::vector<Eigen::Index> columns;
    for (Eigen::Index k = 0; k < derivatives.cols(); ++k) columns.push_back(k);
    const auto equations = static_cast<std::size_t>(invariant_count(goal_.precision));
    while (columns.size() > equations) {
      double best = -1;
      std::size_t chosen = 0;
      Eigen::Index place = structure_.orbits();
      for (std::size_t k = 0; k < sizes_.size(); ++k) {
        if (sizes_[k] == 1) continue;
        if (!held[k]) {
          std::vector<Eigen::Index> rest = columns;
          rest.erase(std::find(rest.begin(), rest.end(), place));
          const Vector singular =
              Eigen::JacobiSVD<EigenMatrix>(derivatives(Eigen::all, rest)).singularValues();
          const double least =
              singular[std::min<Eigen::Index>(singular.size(), static_cast<Eigen::Index>(equations)) - 1];
          if (least > best) {
            best = least;
            chosen = k;
          }
        }
        place += sizes_[k] == 3 ? 1 : 2;
      }
      held[chosen] = true;
      Eigen::Index column = structure_.orbits();
      for (std::size_t k = 0; k < chosen; ++k) column += sizes_[k] == 1 ? 0 : sizes_[k] == 3 ? 1 : 2;
      columns.erase(std::find(columns.begin(), columns.end(), column));
    }
    return held;
  }

  [[nodiscard]] bool refine(SymmetricBox& box) const {
    const std::vector<Ball*> unknowns = unknowns_of(box);
    return newton(unknowns, [&] { return symmetric_residuals(box, goal_.precision, unknowns.size()); });
  }

  /// The nearest decimal.
  [[nodiscard]] Rational decimal(const Ball& x) const {
    const int places = goal_.precision == goal_.degree ? digits_of_free_nodes : digits;
    const BallDecimal nearest = x.decimal(places);
    return Rational::parse(nearest.midpoint).value();
  }

  SymmetricGoal goal_;
  OrbitStructure structure_;
  std::vector<int> sizes_;
  std::vector<Barycentric<double>> lattice_;
};

}  // namespace

std::optional<std::string> hindrance(const SymmetricGoal& goal) {
  expects(goal.degree >= 1 && goal.precision >= goal.degree, "1 <= degree <= precision",
          named("degree", goal.degree), named("precision", goal.precision));
  if (goal.precision == goal.degree) return std::nullopt;
  const OrbitStructure structure = orbit_structure(goal.degree);
  const int numbers = structure.orbits() + structure.coordinates();
  const int equations = invariant_count(goal.precision);
  const std::string counts = "a rule at symmetric nodes of degree " + std::to_string(goal.degree) + " has " +
                             std::to_string(numbers) + " numbers, weights and coordinates, for " +
                             std::to_string(equations) + " equations";
  if (equations > numbers)
    return counts + ": solutions, if there are any, are no zeros that Krawczyk's test proves";
  if (numbers - equations > structure.threes + structure.sixes)
    return counts + ": more numbers would have to be held than there are orbits";
  return std::nullopt;
}

namespace {

/// The first of the precisions without a hindrance whose worth is the largest.
template <class Worth>
int first_best_precision(int degree, const Worth& worth) {
  int best = degree;
  for (int precision = degree + 1; precision <= largest_regular_precision(degree); ++precision)
    if (!hindrance({.degree = degree, .precision = precision}) && worth(precision) > worth(best))
      best = precision;
  return best;
}

}  // namespace

int precision_for_orders(int degree) {
  return first_best_precision(degree, [degree](int precision) {
    const PredictedOrders orders = predicted_orders(degree, precision, parallelogram_precision(precision));
    return 2 * orders.curved - (orders.curved_has_logarithm ? 1 : 0);
  });
}

int precision_for_parallelogram(int degree) { return first_best_precision(degree, parallelogram_precision); }

SearchResult search_symmetric_nodes(const SymmetricGoal& goal, const SearchEffort& effort,
                                    const std::function<bool(const SearchResult&)>& goes_on) {
  const std::optional<std::string> why_not = hindrance(goal);
  expects(!why_not, "a goal that can be looked for", named("precision", goal.precision));
  expects(effort.starts >= 1 && effort.starts <= most_search_starts, "a number of starts that is admitted",
          named("starts", effort.starts));
  expects(effort.steps >= 0, "a number of steps", named("steps", effort.steps));
  const Search search(goal);
  SearchResult result;
  const auto look_at_best = [&](const std::vector<Candidate>& best) {
    for (const Candidate& candidate : best)
      if (std::optional<SymmetricNodes> nodes = search.sharpened(candidate)) {
        const double norm = search.norm(*nodes);
        if (!result.best || norm < result.best->norm)
          result.best = SoughtNodes{.nodes = *std::move(nodes), .norm = norm};
        return;
      }
  };
  search_from_starts(search, effort, kept, result, look_at_best, goes_on);
  return result;
}

}  // namespace radcert
