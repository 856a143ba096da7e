// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "radcert/enclosure/demand.h"
#include "radcert/scalar/dual.h"

namespace radcert {

/// A function of several variables on the unit cube, in balls, with its gradient.
/// Maths     f : [0,1]^n -> R and (D_1 f, ..., D_n f)
/// Source    one formula in two arithmetics
/// Requires  n >= 1; both enclose their function over every box, or fail where they do not know
struct CubeFunction {
  std::size_t dimension;
  std::function<Ball(std::span<const Ball>)> value;
  std::function<std::vector<Ball>(std::span<const Ball>)> gradient;
};

/// From a formula: a class with  template <class T> T operator()(std::span<const T> x) const;  for T = Ball
/// and Dual<Ball>. Two derivatives are had from one evaluation.
template <class Formula>
CubeFunction cube_function(std::size_t dimension, Formula formula) {
  CubeFunction f{.dimension = dimension, .value = {}, .gradient = {}};
  f.value = [formula](std::span<const Ball> x) -> Ball { return formula(x); };
  f.gradient = [formula](std::span<const Ball> x) {
    std::vector<Ball> gradient(x.size());
    for (std::size_t k = 0; k < x.size(); k += 2) {
      std::vector<Dual<Ball>> dual;
      for (std::size_t i = 0; i < x.size(); ++i) {
        dual.emplace_back(x[i], Ball(i == k ? 1 : 0), Ball(i == k + 1 ? 1 : 0));
      }
      const Dual<Ball> value = formula(std::span<const Dual<Ball>>(dual));
      gradient[k] = value.by_s;
      if (k + 1 < x.size()) gradient[k + 1] = value.by_t;
    }
    return gradient;
  };
  return f;
}

/// The largest value of a function on the unit cube, enclosed.
/// Maths     max f over [0,1]^n
/// Source    branch and bound with the mean value form f(X) in f(m) + Df(X) (X - m), and the monotonicity
///           test: R. E. Moore, R. B. Kearfott, M. J. Cloud, "Introduction to Interval Analysis", 2009,
///           sections 6.3 and 11.2. A box where a derivative has one sign is replaced by its side of larger
///           values where that lies on the border of the cube, and left out elsewhere: a maximum is not there
/// Requires  demand.radius > 0, demand.work_limit >= 1, dimension >= 1, else ContractViolation; f continuous,
///           and differentiable where the gradient is finite
/// Result    a ball of radius <= demand.radius; else undecided, `reached` with both bounds of what is known.
///           An evaluation of the gradient counts as one. The same bits for every number of threads
/// Limits    work grows exponentially with n, and where f is constant along a curve of maxima with the
///           reciprocal of the radius. Domains other than a cube enter by a map onto them
[[nodiscard]] Enclosure maximum(const CubeFunction& f, const Demand& demand);

}  // namespace radcert
