// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <utility>
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
        return ::testing::AssertionFailure()
               << "l_" << i << "(q_" << j << ") = " << description(l[i]) << " in place of "
               << (i == j ? 1 : 0) << ", q_" << j << " = " << detail::text(nodes[j]);
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
      return ::testing::AssertionFailure() << "the sum of the functions at " << detail::text(x) << " is "
                                           << description(sum) << " in place of 1";
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
                 << "t^" << a << " s^" << b << " at " << detail::text(x) << " becomes " << description(sum)
                 << " in place of " << description(p(x));
      }
  }
  return ::testing::AssertionSuccess();
}

/// The nodes lie in the closed triangle, and no two coincide.
template <Field R, BasisOver<R> Basis>
::testing::AssertionResult has_different_nodes_in_the_triangle(const Basis& basis, const R& tolerance) {
  const std::vector<Barycentric<R>> nodes = basis.nodes();
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    const Barycentric<R>& q = nodes[j];
    const R sum = q.x[0] + q.x[1] + q.x[2];
    if (!(detail::distance<R>(sum, R(1)) <= tolerance))
      return ::testing::AssertionFailure() << "q_" << j << " = " << detail::text(q) << " has the sum "
                                           << description(sum) << " in place of 1";
    for (const R& x : q.x)
      if (!(R(0) <= x + tolerance))
        return ::testing::AssertionFailure() << "q_" << j << " = " << detail::text(q)
                                             << " is outside the triangle by " << description(R(0) - x);
    for (std::size_t i = 0; i < j; ++i)
      if (nodes[i].x == q.x)
        return ::testing::AssertionFailure()
               << "q_" << i << " and q_" << j << " are the same point " << detail::text(q);
  }
  return ::testing::AssertionSuccess();
}

/// All laws of a Lagrange basis that is to serve in the collocation method, in one call.
/// Maths     different nodes in the triangle; l_i(q_j) = delta_ij; sum_i l_i = 1; sum_i p(q_i) l_i = p for
///           all polynomials p of the degree that is said to be reproduced: all the order of convergence
///           everywhere depends on
/// Source    [m06, (14)-(15)]
/// Requires  `reproduced` >= 0; R = Rational with the tolerance 0 proves the first two laws
/// Result    a failure names the law, the function, node or point, what is found there, and what should be
/// Limits    the last two laws are tried at 19 points
template <Field R, BasisOver<R> Basis>
::testing::AssertionResult is_a_lagrange_basis(const Basis& basis, int reproduced, const R& tolerance) {
  constexpr std::uint64_t seed = 20260102;
  const std::vector<Barycentric<R>> points = points_of_the_plane<R>(seed);
  const std::span<const Barycentric<R>> span(points);
  using Result = ::testing::AssertionResult;
  // A later law may rest on the earlier ones: as many functions as nodes.
  const std::vector<std::pair<std::string, std::function<Result()>>> laws = {
      {"different nodes in the triangle",
       [&] { return has_different_nodes_in_the_triangle<R>(basis, tolerance); }},
      {"one at its node and zero at the others",
       [&] { return is_one_at_its_node_and_zero_at_the_others<R>(basis, tolerance); }},
      {"a partition of unity", [&] { return is_a_partition_of_unity<R>(basis, span, tolerance); }},
      {"reproduces the polynomials of degree " + std::to_string(reproduced),
       [&] { return reproduces_polynomials<R>(basis, reproduced, span, tolerance); }}};
  for (const auto& [name, law] : laws)
    if (const Result result = law(); !result)
      return ::testing::AssertionFailure() << "the law \"" << name << "\" is broken: " << result.message();
  return ::testing::AssertionSuccess();
}

/// The nodes lie in the closed triangle, no two coincide, and turning or reflecting the triangle permutes
/// them.
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
