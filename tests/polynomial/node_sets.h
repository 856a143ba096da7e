// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/nodes/lattice.h"

namespace radcert {

using Nodes = std::vector<Barycentric<Rational>>;

/// A point by its coordinates s = x_3 and t = x_2.
inline Barycentric<Rational> at(const Rational& s, const Rational& t) { return {{1 - s - t, t, s}}; }

/// Different points with coordinates k/101 of the triangle from a fixed stream, without any symmetry.
inline Nodes scattered_nodes(int degree, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Nodes nodes;
  while (nodes.size() < polynomial_dimension(degree)) {
    const long s = static_cast<long>(random() % 102);
    const long t = static_cast<long>(random() % 102);
    if (s + t > 101) continue;
    const Barycentric<Rational> node = at(Rational(s, 101), Rational(t, 101));
    bool is_new = true;
    for (const Barycentric<Rational>& other : nodes) is_new = is_new && !(other == node);
    if (is_new) nodes.push_back(node);
  }
  return nodes;
}

/// The Lagrange functions of a set that has them.
inline LagrangeFunctions functions_of(const Nodes& nodes) { return lagrange_functions(nodes).value(); }

/// Linear functions and the bubble x_1 x_2 x_3, by Bernstein coefficients of degree 3.
inline PolynomialSpace linear_with_bubble() {
  PolynomialSpace space{.degree = 3, .functions = {}};
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<Rational> x;
    for (const std::array<int, 3>& k : lattice_indices(3)) x.emplace_back(k[i], 3);
    space.functions.push_back(x);
  }
  std::vector<Rational> bubble(polynomial_dimension(3));
  bubble[lattice_place({1, 1, 1})] = Rational(1, 6);
  space.functions.push_back(bubble);
  return space;
}

/// (1 - 2a, a, a) and its like, and the centroid.
inline Nodes three_and_the_centroid(const Rational& a) {
  Nodes nodes = inset_nodes(1, a);
  nodes.push_back(at(Rational(1, 3), Rational(1, 3)));
  return nodes;
}

inline std::vector<Rational> some_insets() {
  return {
      0, Rational(1, 10), Rational(1, 8), Rational(1, 7), Rational(1, 6), Rational(1, 4), Rational(33, 100)};
}

}  // namespace radcert
