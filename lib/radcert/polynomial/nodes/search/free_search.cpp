// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/search/free_search.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/nodes/search/damped_least_squares.h"
#include "radcert/polynomial/nodes/search/lattice_norm.h"
#include "radcert/polynomial/nodes/search/random_starts.h"
#include "radcert/polynomial/triangle_modes.h"
#include "radcert/scalar/dual.h"

namespace radcert {
namespace {

constexpr double least_distance = 1e-3;  // of nodes from the border, in barycentric coordinates
constexpr double solved = 1e-26;         // the sum of the squares of what is missed
constexpr int most_iterations = 120;
constexpr std::size_t kept = 8;  // solutions from which small steps go on
constexpr int lattice = 40;

using Vector = Eigen::VectorXd;
using EigenMatrix = Eigen::MatrixXd;

/// Of candidates x are the weights of means, then s, then t.
class Search {
public:
  explicit Search(const FreeGoal& goal) : goal_(goal), count_(polynomial_dimension(goal.degree)) {
    for (const auto& [i, j, k] : lattice_indices(lattice))
      lattice_.push_back({{1.0 * i / lattice, 1.0 * j / lattice, 1.0 * k / lattice}});
  }

  [[nodiscard]] std::optional<Candidate> from_start(std::uint64_t seed) const {
    std::mt19937_64 random(seed);
    Candidate start{.x = std::vector<double>(3 * count_, 1.0 / static_cast<double>(count_))};
    for (std::size_t j = 0; j < count_; ++j) {
      // The lengths of the parts of (0, 1) at two random points are uniform on the triangle.
      const auto [low, high] = std::minmax({uniform_number(random), uniform_number(random)});
      start.x[count_ + j] = low;
      start.x[2 * count_ + j] = high - low;
    }
    return solution(std::move(start));
  }

  /// A solution with nodes inside, with its norm.
  [[nodiscard]] std::optional<Candidate> solution(Candidate at) const {
    const auto functions = [this](const std::vector<double>& x) { return evaluate(x); };
    if (!damped_least_squares(at.x, functions, solved, most_iterations)) return std::nullopt;
    std::vector<Barycentric<double>> points;
    for (std::size_t j = 0; j < count_; ++j) {
      const double s = at.x[count_ + j];
      const double t = at.x[2 * count_ + j];
      points.push_back({{1 - s - t, t, s}});
      if (std::min({1 - s - t, t, s}) < least_distance) return std::nullopt;
    }
    at.norm = norm_at(lattice_, goal_.degree, points);
    if (!std::isfinite(at.norm)) return std::nullopt;
    return at;
  }

  /// How many weights stand in front of a candidate's coordinates.
  [[nodiscard]] std::size_t weights() const { return count_; }

  /// To 60 digits; nothing where Newton's method does not come to them.
  [[nodiscard]] std::optional<FreeNodes> sharp(const Candidate& candidate) const {
    const std::vector<bool> held = numbers_to_hold(candidate);
    FreeNodes nodes{.degree = goal_.degree,
                    .triangle = goal_.triangle,
                    .parallelogram = goal_.parallelogram,
                    .nodes = {}};
    for (std::size_t j = 0; j < count_; ++j) {
      const auto number = [&](std::size_t i) {
        const double value = candidate.x[i];
        return held[i] ? Rational::exactly(std::round(value * 1e6)) / 1'000'000 : Rational::exactly(value);
      };
      nodes.nodes.push_back({.s = number(count_ + j),
                             .t = number(2 * count_ + j),
                             // Of a rule for integrals, not means: the triangle has the area 1/2.
                             .weight = number(j) / 2,
                             .holds_s = held[count_ + j],
                             .holds_t = held[2 * count_ + j]});
    }
    return sharpened(nodes);
  }

private:
  /// What is missed, and its derivatives: means of the orthonormal polynomials, which are 0 but for the
  /// first, and of the even ones about the middle of the side x_1 = 0 beyond.
  [[nodiscard]] FunctionsThere evaluate(const std::vector<double>& x) const {
    const std::size_t modes_used = mode_count(goal_.triangle);
    const auto rows = static_cast<std::size_t>(free_equations(goal_.triangle, goal_.parallelogram));
    FunctionsThere out{.values = std::vector<double>(rows), .derivatives = Matrix<double>(rows, 3 * count_)};
    std::vector<Dual<double>> modes(modes_used);
    for (std::size_t j = 0; j < count_; ++j) {
      const double weight = x[j];
      const Dual<double> s(x[count_ + j], 1.0, 0.0);
      const Dual<double> t(x[2 * count_ + j], 0.0, 1.0);
      triangle_modes<Dual<double>>(goal_.triangle, {{Dual<double>(1.0) - s - t, t, s}}, modes);
      std::size_t row = 0;
      const auto add = [&](const Dual<double>& value) {
        out.values[row] += weight * value.value;
        out.derivatives(row, j) = value.value;
        out.derivatives(row, count_ + j) = weight * value.by_s;
        out.derivatives(row, 2 * count_ + j) = weight * value.by_t;
        ++row;
      };
      for (const Dual<double>& mode : modes) add(mode);
      const Dual<double> u = s + s - Dual<double>(1.0);
      const Dual<double> v = t + t - Dual<double>(1.0);
      for (int k = goal_.triangle + 1; k <= goal_.parallelogram; ++k)
        for (int i = 0; k % 2 == 0 && i <= k; ++i) add(power(u, k - i) * power(v, i));
    }
    out.values[0] -= 1;
    std::size_t row = modes_used;
    for (int k = goal_.triangle + 1; k <= goal_.parallelogram; ++k)
      for (int i = 0; k % 2 == 0 && i <= k; ++i)
        // Half of the mean over the square [-1, 1]^2 is that over either triangle.
        out.values[row++] -= i % 2 == 0 ? 1.0 / ((k - i + 1) * (i + 1)) : 0.0;
    return out;
  }

  /// For each number whether it is held: coordinates alone, one after the other, so that what remains is
  /// determined as well as can be.
  [[nodiscard]] std::vector<bool> numbers_to_hold(const Candidate& at) const {
    const FunctionsThere there = evaluate(at.x);
    const Eigen::Map<const EigenMatrix> derivatives(there.derivatives.column(0).data(),
                                                    static_cast<Eigen::Index>(there.derivatives.rows()),
                                                    static_cast<Eigen::Index>(there.derivatives.columns()));
    std::vector<bool> held(3 * count_, false);
    std::vector<Eigen::Index> columns;
    for (Eigen::Index k = 0; k < derivatives.cols(); ++k) columns.push_back(k);
    while (static_cast<Eigen::Index>(columns.size()) > derivatives.rows()) {
      double best = -1;
      std::size_t chosen = 0;
      for (std::size_t place = 0; place < columns.size(); ++place) {
        if (columns[place] < static_cast<Eigen::Index>(count_)) continue;
        std::vector<Eigen::Index> rest = columns;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(place));
        const Vector singular = Eigen::JacobiSVD<EigenMatrix>(derivatives(Eigen::all, rest)).singularValues();
        const double least = singular[std::min(singular.size(), derivatives.rows()) - 1];
        if (least > best) {
          best = least;
          chosen = place;
        }
      }
      held[static_cast<std::size_t>(columns[chosen])] = true;
      columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(chosen));
    }
    return held;
  }

  FreeGoal goal_;
  std::size_t count_;
  std::vector<Barycentric<double>> lattice_;
};

}  // namespace

FreeGoal free_goal(int degree) {
  expects(degree >= 1, "degree >= 1", named("degree", degree));
  return {.degree = degree,
          .triangle = degree % 2 == 0 ? degree + 2 : degree + 1,
          .parallelogram = degree % 2 == 0 ? degree + 2 : degree + 3};
}

std::optional<std::string> hindrance(const FreeGoal& goal) {
  const int numbers = 3 * static_cast<int>(polynomial_dimension(goal.degree));
  const int equations = free_equations(goal.triangle, goal.parallelogram);
  if (equations <= numbers) return std::nullopt;
  return "a rule at " + std::to_string(numbers / 3) + " nodes has " + std::to_string(numbers) +
         " numbers, weights and coordinates, for " + std::to_string(equations) + " equations";
}

FreeSearchResult search_free_nodes(const FreeGoal& goal, const SearchEffort& effort,
                                   const std::function<bool(const FreeSearchResult&)>& goes_on) {
  expects(1 <= goal.degree && goal.degree <= largest_free_degree && goal.triangle >= goal.degree,
          "1 <= degree <= 4, triangle >= degree", named("degree", goal.degree),
          named("triangle", goal.triangle));
  expects(!hindrance(goal), "a goal that can be looked for", named("parallelogram", goal.parallelogram));
  expects(effort.starts >= 1 && effort.starts <= most_search_starts && effort.steps >= 0,
          "a number of starts that is admitted, and steps", named("starts", effort.starts));
  const Search search(goal);
  FreeSearchResult result;
  const auto look_at_best = [&](const std::vector<Candidate>& best) {
    for (const Candidate& candidate : best)
      if (std::optional<FreeNodes> nodes = search.sharp(candidate)) {
        if (!result.best || candidate.norm < result.best->norm)
          result.best = SoughtFreeNodes{.nodes = *std::move(nodes), .norm = candidate.norm};
        return;
      }
  };
  search_from_starts(search, effort, kept, result, look_at_best, goes_on);
  return result;
}

}  // namespace radcert
