// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "radcert/core/lazy_table.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/triangle_basis.h"

namespace radcert {

/// How large the functions of a basis become on the triangle.
/// Maths     max |l_j|. The triangle is cut into n^2 equal ones, n = 8. On each l_j is a polynomial of degree
///           r whose values at the principal lattice determine its Bernstein coefficients, of which it is a
///           convex combination: the largest of their sizes, over all triangles, bounds |l_j|
/// Source    Farin, Curves and Surfaces for CAGD, chapter 17: the convex hull property
/// Requires  degree <= 10, as TriangleBasis
/// Result    upper bounds, above the maximum by a quarter at degree 8, by 2^-20 at degrees 0 and 1. Roundings
///           are less than the part 2^-20 that is added: values are right to 2^10 units in the last place,
///           and the sizes of the numbers that take them to coefficients sum to less than 2^13
/// Limits    for radii; lebesgue_constant encloses the norm of the interpolation
template <Real R>
std::vector<R> largest_values(const TriangleBasis<R>& basis) {
  using std::abs;
  constexpr int n = 8;
  const int r = basis.degree();
  const std::vector<std::array<int, 3>> lattice = lattice_indices(r);
  static LazyTable<std::vector<R>, LagrangeBasis<R>::largest_degree + 1> tables;
  /// The coefficient k of a function is the sum of its values at the points j times the number at (k, j).
  const std::vector<R>& coefficients = tables.at(static_cast<std::size_t>(r), [&] {
    const LagrangeFunctions functions = lagrange_functions(inset_nodes(r, Rational(0))).value();
    std::vector<R> table;
    for (std::size_t k = 0; k < functions.size(); ++k)
      for (std::size_t j = 0; j < functions.size(); ++j)
        table.push_back(from_rational<R>(functions.bernstein_coefficients(j)[k]));
    return table;
  });
  const std::size_t points = lattice.size();
  std::vector<R> largest(basis.size(), R(0));
  std::vector<R> values(basis.size() * points);
  std::vector<R> at_point(basis.size());
  // One with its corners in the directions of those of the whole (turn = 1), and one turned by half (-1), for
  // each (a, b, c).
  for (const int turn : {1, -1})
    for (const std::array<int, 3>& corner : lattice_indices(n - turn)) {
      if (turn < 0 && std::min({corner[0], corner[1], corner[2]}) == 0) continue;
      for (std::size_t k = 0; k < points; ++k) {
        Barycentric<R> x;
        for (std::size_t i = 0; i < 3; ++i)
          x.x[i] = r == 0 ? R(1) / R(3) : R(r * corner[i] + turn * lattice[k][i]) / R(r * n);
        basis.values(x, at_point);
        for (std::size_t j = 0; j < basis.size(); ++j) values[j * points + k] = at_point[j];
      }
      for (std::size_t j = 0; j < basis.size(); ++j)
        for (std::size_t k = 0; k < points; ++k) {
          R sum(0);
          for (std::size_t i = 0; i < points; ++i)
            sum += coefficients[k * points + i] * values[j * points + i];
          largest[j] = std::max(largest[j], static_cast<R>(abs(sum)));
        }
    }
  for (R& value : largest) value *= R(1 + 0x1p-20);
  return largest;
}

}  // namespace radcert
