// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/barycentric.h"

namespace radcert::laws {

/// A Lagrange basis on the reference triangle, as the laws below see one.
template <class Basis, class R>
concept BasisOver = Field<R> && requires(const Basis& basis, const Barycentric<R>& x, std::span<R> out) {
  { basis.degree() } -> std::convertible_to<int>;
  { basis.size() } -> std::convertible_to<std::size_t>;
  { basis.nodes() } -> std::convertible_to<std::vector<Barycentric<R>>>;
  basis.values(x, out);
};

/// Points of the plane for a law to be tried at: corners, centroid, points of the sides, inside and outside.
/// Random ones have the coordinates k/64 and come from a fixed stream: exact in Rational and in double.
template <Field R>
std::vector<Barycentric<R>> points_of_the_plane(std::uint64_t seed, int random_points = 12) {
  const auto at = [](int t, int s) {
    return Barycentric<R>{{R(64 - s - t) / R(64), R(t) / R(64), R(s) / R(64)}};
  };
  std::vector<Barycentric<R>> points{at(0, 0), at(64, 0), at(0, 64), at(32, 32), at(0, 1), at(1, 63)};
  points.push_back({{R(1) / R(3), R(1) / R(3), R(1) / R(3)}});
  std::mt19937_64 random(seed);
  for (int k = 0; k < random_points; ++k) {
    const int t = static_cast<int>(random() % 96) - 16;
    const int s = static_cast<int>(random() % 96) - 16;
    points.push_back(at(t, s));
  }
  return points;
}

namespace detail {

template <Field R>
R distance(const R& a, const R& b) {
  using std::abs;
  return abs(a - b);
}

template <Field R>
std::string text(const Barycentric<R>& x) {
  return "(" + description(x.x[0]) + ", " + description(x.x[1]) + ", " + description(x.x[2]) + ")";
}

template <Field R, class Basis>
std::vector<R> values(const Basis& basis, const Barycentric<R>& x) {
  std::vector<R> out(basis.size(), R(0));
  basis.values(x, std::span<R>(out));
  return out;
}

}  // namespace detail

/// l_i(q_j) = delta_ij, within `tolerance`: 0 in exact arithmetic.
template <Field R, BasisOver<R> Basis>
::testing::AssertionResult is_one_at_its_node_and_zero_at_the_others(const Basis& basis, const R& tolerance) {
  const std::vector<Barycentric<R>> nodes = basis.nodes();
  if (nodes.size() != basis.size())
    return ::testing::AssertionFailure() << nodes.size() << " nodes for " << basis.size() << " functions";
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    const std::vector<R> l = detail::values<R>(basis, nodes[j]);
    for (std::size_t i = 0; i < l.size(); ++i)
      if (!(detail::distance<R>(l[i], R(i == j ? 1 : 0)) <= tolerance))
        return ::testing::AssertionFailure() << "l_" << i << "(q_" << j << ") = " << description(l[i]);
  }
  return ::testing::AssertionSuccess();
}

/// sum_i l_i(x) = 1.
template <Field R, BasisOver<R> Basis>
::testing::AssertionResult is_a_partition_of_unity(const Basis& basis, std::span<const Barycentric<R>> points,
                                                   const R& tolerance) {
  for (const Barycentric<R>& x : points) {
    R sum(0);
    for (const R& l : detail::values<R>(basis, x)) sum = sum + l;
    if (!(detail::distance<R>(sum, R(1)) <= tolerance))
      return ::testing::AssertionFailure() << "the sum at " << detail::text(x) << " is " << description(sum);
  }
  return ::testing::AssertionSuccess();
}

/// sum_i p(q_i) l_i(x) = p(x) for the monomials p = t^a s^b with a + b <= degree.
template <Field R, BasisOver<R> Basis>
::testing::AssertionResult reproduces_polynomials(const Basis& basis, int degree,
                                                  std::span<const Barycentric<R>> points,
                                                  const R& tolerance) {
  const std::vector<Barycentric<R>> nodes = basis.nodes();
  for (const Barycentric<R>& x : points) {
    const std::vector<R> l = detail::values<R>(basis, x);
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; a + b <= degree; ++b) {
        const auto p = [a, b](const Barycentric<R>& at) { return power(at.x[1], a) * power(at.x[2], b); };
        R sum(0);
        for (std::size_t i = 0; i < l.size(); ++i) sum = sum + p(nodes[i]) * l[i];
        if (!(detail::distance<R>(sum, p(x)) <= tolerance))
          return ::testing::AssertionFailure()
                 << "t^" << a << " s^" << b << " at " << detail::text(x) << " becomes " << description(sum);
      }
  }
  return ::testing::AssertionSuccess();
}

/// The nodes lie in the closed triangle, no two coincide, and turning or reflecting the triangle permutes them.
template <Field R, BasisOver<R> Basis>
::testing::AssertionResult has_symmetric_nodes_in_the_triangle(const Basis& basis, const R& tolerance) {
  const std::vector<Barycentric<R>> nodes = basis.nodes();
  const auto equal = [&tolerance](const Barycentric<R>& a, const Barycentric<R>& b) {
    for (std::size_t i = 0; i < 3; ++i)
      if (!(detail::distance<R>(a.x[i], b.x[i]) <= tolerance)) return false;
    return true;
  };
  const auto occurrences = [&](const Barycentric<R>& q) {
    return std::count_if(nodes.begin(), nodes.end(), [&](const auto& other) { return equal(q, other); });
  };
  for (const Barycentric<R>& q : nodes) {
    if (!(detail::distance<R>(q.x[0] + q.x[1] + q.x[2], R(1)) <= tolerance))
      return ::testing::AssertionFailure() << detail::text(q) << " is not barycentric";
    for (const R& x : q.x)
      if (!(R(0) <= x + tolerance)) return ::testing::AssertionFailure() << detail::text(q) << " is outside";
    const Barycentric<R> turned{{q.x[1], q.x[2], q.x[0]}};
    const Barycentric<R> reflected{{q.x[1], q.x[0], q.x[2]}};
    for (const Barycentric<R>& image : {q, turned, reflected})
      if (occurrences(image) != 1)
        return ::testing::AssertionFailure()
               << detail::text(image) << " is a node " << occurrences(image) << " times";
  }
  return ::testing::AssertionSuccess();
}

}  // namespace radcert::laws
