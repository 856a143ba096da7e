// SPDX-License-Identifier: GPL-3.0-or-later

// The blocks of (24).
//
// Checked      (24): the right sides of (22) and (23) with unknowns b_1..b_m, d_1..d_n, their F, weights and
//              radii, all of them symbols, m = 2, n = 3, k = 2. They are affine: the columns of R are what
//              they give for unit vectors less what they give for 0, which is epsilon; then epsilon + R
//              lambda is what they give for lambda. The blocks of R that take b to b and d to d are 0. For
//              any m, n and k by induction on the unknowns: a right side with one more unknown of the other
//              surface, whose coefficient is any number, as the sum over s is, or of the same one, of which
//              it does not depend. As m and n differ, no block is square. Rejected: a sphere with a dent,
//              which lights itself; an albedo that grows with the light. section_8_blocks: R as in (24) with
//              symbols for the entries of M and N, and its transpose, applied to unit vectors. By (24) and
//              lambda = epsilon + R lambda band j of the disk changes b_i by M_ij, and ring i of the sphere
//              changes d_j by N_ji: the sentence is wrong. By the transpose it is right: that is (24) with
//              lambda as a row, or with its blocks exchanged, which the letters of (25) ask for, N_ji having
//              the F_isj of (22), or with d before b in lambda. What the sentence says is open between the
//              two. Rejected: the entry beside N_ji.
// Not checked  what (25) gives for M and N: equation_25.

#include <algorithm>
#include <string>
#include <vector>

#include "verification/claims/induction.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

using Function = RationalFunction;
using Row = std::vector<Function>;

constexpr std::size_t latitudes = 2;  ///< m
constexpr std::size_t rings = 3;      ///< n
constexpr std::size_t azimuths = 2;   ///< k
constexpr std::size_t unknowns = latitudes + rings;

template <class... Indices>
Function symbol(const std::string& name, Indices... indices) {
  return Function::variable((name + ... + ("_" + std::to_string(indices))));
}

/// b_1, ..., b_m, d_1, ..., d_n.
Row unknown_lambda() {
  Row lambda;
  for (std::size_t k = 0; k < unknowns; ++k) lambda.push_back(symbol("lambda", k));
  return lambda;
}
Row unit_vector(std::size_t place) {
  Row unit(unknowns, Function(0));
  unit[place] = 1;
  return unit;
}

/// The right sides of (22) and (23).
Row right_sides(const Row& lambda) {
  const Function beta = symbol("beta");
  Row right;
  for (std::size_t i = 0; i < latitudes; ++i) {
    Function sum(0);
    for (std::size_t j = 0; j < rings; ++j)
      for (std::size_t s = 0; s < azimuths; ++s)
        sum += lambda[latitudes + j] * symbol("2pi/k") * symbol("F", i, s, j) * symbol("u", j);
    right.push_back(symbol("b*", i) + beta * symbol("R/n") * sum);
  }
  for (std::size_t j = 0; j < rings; ++j) {
    Function sum(0);
    for (std::size_t i = 0; i < latitudes; ++i)
      for (std::size_t s = 0; s < azimuths; ++s)
        sum +=
            lambda[i] * symbol("2pi/k") * symbol("G", j, s, i) * symbol("r") * symbol("r") * symbol("cos", i);
    right.push_back(symbol("d*", j) + beta * symbol("pi/m") * sum);
  }
  return right;
}
/// The same for a sphere whose first parallel sees itself.
Row with_a_dent(const Row& lambda) {
  Row right = right_sides(lambda);
  right[0] += symbol("beta") * symbol("self") * lambda[0];
  return right;
}
/// The same with an albedo of the first parallel that grows with its radiance.
Row with_growing_albedo(const Row& lambda) {
  Row right = right_sides(lambda);
  right[0] += lambda[0] * right[0];
  return right;
}

/// R by columns: what unit vectors change.
template <class RightSides>
std::vector<Row> columns_of(const RightSides& right) {
  const Row emission = right(Row(unknowns, Function(0)));
  std::vector<Row> columns;
  for (std::size_t k = 0; k < unknowns; ++k) {
    columns.push_back(right(unit_vector(k)));
    for (std::size_t i = 0; i < unknowns; ++i) columns[k][i] = columns[k][i] - emission[i];
  }
  return columns;
}

bool is_of_sphere(std::size_t place) { return place < latitudes; }

/// Terms of the entries of R that take b to b and d to d.
template <class RightSides>
Rational terms_of_diagonal_blocks(const RightSides& right) {
  const std::vector<Row> columns = columns_of(right);
  Rational terms(0);
  for (std::size_t k = 0; k < unknowns; ++k)
    for (std::size_t i = 0; i < unknowns; ++i)
      if (is_of_sphere(i) == is_of_sphere(k)) terms += differing_terms(columns[k][i], 0);
  return terms;
}

/// Terms in which the right sides differ from epsilon + R lambda.
template <class RightSides>
Rational terms_not_affine(const RightSides& right) {
  const Row lambda = unknown_lambda();
  const std::vector<Row> columns = columns_of(right);
  Row affine = right(Row(unknowns, Function(0)));
  for (std::size_t k = 0; k < unknowns; ++k)
    for (std::size_t i = 0; i < unknowns; ++i) affine[i] += columns[k][i] * lambda[k];
  const Row given = right(lambda);
  Rational terms(0);
  for (std::size_t i = 0; i < unknowns; ++i) terms += differing_terms(given[i], affine[i]);
  return terms;
}

/// A right side with any number of unknowns: what it gives for lambda, and epsilon + R lambda, whose columns
/// are what it gives for unit vectors less what it gives for 0.
struct RightSide {
  Function given;
  Function affine;
};
/// Terms in which the two differ for any number of unknowns, one more adding `added(x)` for its value x.
template <class Added>
Rational terms_not_affine_for_any_number(const Added& added) {
  const Function emission = symbol("epsilon");
  const Function so_far = symbol("so far");
  const Function x = symbol("x");
  return left_over_by_induction(
      RightSide{emission, emission}, RightSide{so_far, so_far},
      [&](const RightSide& before) {
        const Function column = (emission + added(1)) - emission;
        return RightSide{before.given + added(x), before.affine + column * x};
      },
      [](const RightSide& side) { return differing_terms(side.given, side.affine); });
}

Function entry_of_m(std::size_t i, std::size_t j) { return symbol("M", i, j); }
Function entry_of_n(std::size_t j, std::size_t i) { return symbol("N", j, i); }

/// R lambda, R = (0 M; N 0), or its transpose.
Row by_blocks(const Row& lambda, bool is_transposed) {
  Row result(unknowns, Function(0));
  for (std::size_t i = 0; i < latitudes; ++i)
    for (std::size_t j = 0; j < rings; ++j) {
      const Function to_sphere = is_transposed ? entry_of_n(j, i) : entry_of_m(i, j);
      const Function to_disk = is_transposed ? entry_of_m(i, j) : entry_of_n(j, i);
      result[i] += to_sphere * lambda[latitudes + j];
      result[latitudes + j] += to_disk * lambda[i];
    }
  return result;
}

/// Terms in which the influence of band j of the disk on ring i of the sphere differs from an entry.
template <class Entry>
Rational influence_of_disk(const Entry& entry, bool is_transposed) {
  Rational terms(0);
  for (std::size_t i = 0; i < latitudes; ++i)
    for (std::size_t j = 0; j < rings; ++j)
      terms += differing_terms(by_blocks(unit_vector(latitudes + j), is_transposed)[i], entry(i, j));
  return terms;
}
/// The same of ring i of the sphere on band j of the disk.
template <class Entry>
Rational influence_of_sphere(const Entry& entry, bool is_transposed) {
  Rational terms(0);
  for (std::size_t i = 0; i < latitudes; ++i)
    for (std::size_t j = 0; j < rings; ++j)
      terms += differing_terms(by_blocks(unit_vector(i), is_transposed)[latitudes + j], entry(i, j));
  return terms;
}

/// What both readings of R leave possible, as one interval.
Approximation by_either_reading(const Rational& as_printed, const Rational& transposed) {
  const double low = std::min(as_printed, transposed).to_double();
  const double high = std::max(as_printed, transposed).to_double();
  return Approximation::proved((low + high) / 2, (high - low) / 2);
}

}  // namespace

Finding equation_24(const Bench&) {
  Finding finding;
  finding.require("terms of the blocks of R on the diagonal", IsExactly{0},
                  terms_of_diagonal_blocks(right_sides));
  finding.control("the same for a sphere that lights itself", IsExactly{0},
                  terms_of_diagonal_blocks(with_a_dent));
  finding.require("terms in which (22) and (23) differ from epsilon + R lambda", IsExactly{0},
                  terms_not_affine(right_sides));
  finding.control("the same for an albedo that grows with the light", IsExactly{0},
                  terms_not_affine(with_growing_albedo));
  const Function coefficient = symbol("coefficient");
  finding.require("the same for any number of unknowns, one more of the other surface", IsExactly{0},
                  terms_not_affine_for_any_number([&](const Function& x) { return coefficient * x; }));
  finding.require("the same, one more of the same surface", IsExactly{0},
                  terms_not_affine_for_any_number([](const Function&) { return Function(0); }));
  finding.control("the same for any number of unknowns, the square of one", IsExactly{0},
                  terms_not_affine_for_any_number([&](const Function& x) { return coefficient * x * x; }));
  return finding;
}

Finding section_8_blocks(const Bench&) {
  const auto n_of = [](std::size_t i, std::size_t j) { return entry_of_n(j, i); };
  const auto next_of_n = [](std::size_t i, std::size_t j) { return entry_of_n((j + 1) % rings, i); };
  const Equals none{.value = 0, .slack = 0, .why = "R of (24), or its transpose"};
  const auto on_sphere = [](const auto& entry) {
    return by_either_reading(influence_of_disk(entry, false), influence_of_disk(entry, true));
  };
  const auto on_disk = [](const auto& entry) {
    return by_either_reading(influence_of_sphere(entry, false), influence_of_sphere(entry, true));
  };
  Finding finding;
  finding.require("terms in which the influence of band j of the disk on ring i of the sphere is not N_ji",
                  none, on_sphere(n_of));
  finding.require("terms in which the influence of ring i of the sphere on band j of the disk is not M_ij",
                  none, on_disk(entry_of_m));
  finding.control(
      "terms in which the influence of band j of the disk on ring i of the sphere is not N_(j+1)i", none,
      on_sphere(next_of_n));
  finding.instead("terms in which the influence of band j on ring i is not M_ij, R of (24)", IsExactly{0},
                  influence_of_disk(entry_of_m, false));
  finding.instead("terms in which the influence of ring i on band j is not N_ji, R of (24)", IsExactly{0},
                  influence_of_sphere(n_of, false));
  finding.instead("terms in which the influence of band j on ring i is not N_ji, the transpose", IsExactly{0},
                  influence_of_disk(n_of, true));
  finding.instead("terms in which the influence of ring i on band j is not M_ij, the transpose", IsExactly{0},
                  influence_of_sphere(entry_of_m, true));
  finding.control("terms in which the influence of band j on ring i is not M_ij, the transpose", IsExactly{0},
                  influence_of_disk(entry_of_m, true));
  return finding;
}

}  // namespace radcert::verification::psg10
