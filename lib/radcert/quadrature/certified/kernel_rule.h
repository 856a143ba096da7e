// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/scalar/pack.h"

namespace radcert {

/// A vector in doubles and a bound of the length that it is off by.
struct RoundedVector {
  Vector<double> value;
  double error = 0;
};
[[nodiscard]] RoundedVector rounded(const Vector<BoundedDouble>& v);

/// A product rule for the kernel times functions over a part of an element, and its sums for eight points at
/// a time.
/// Maths     sum_ab G(P, Q_ab) w_ab f_j(Q_ab), w_ab the weights times the area element
/// Requires  order^2 calls of add() after begin(), row by row; from 1 to 45 functions; points off the part
/// Result    sums as the machine rounds them, and by rounding() a bound of what they are off by
class KernelRule {
public:
  static constexpr std::size_t most_functions = 45;

  /// Eight points that see the part.
  struct Points {
    Vector<Pack> position;
    Vector<Pack> normal;
  };
  struct Sums {
    std::array<Pack, most_functions> sum;
    Pack nearest;   ///< least computed |Q - P|^2
    Pack cosine_p;  ///< largest computed ((Q - P).n_P)^2 / |Q - P|^2
    Pack cosine_q;
  };
  /// The error bound of the points.
  struct PointErrors {
    double position = 0;
    double normal = 0;
  };

  explicit KernelRule(std::size_t functions) : functions_(functions) {}

  void begin(int order);
  /// One node; weighted[j] = w f_j.
  void add(const Vector<BoundedDouble>& position, const Vector<BoundedDouble>& normal,
           std::span<const BoundedDouble> weighted);

  void take_sums(const Points& points, Sums& sums) const;
  /// A bound of what rounding does to each of the sums for the point in a lane.
  /// Maths     d = Q - P with r = |d| >= least; the computed d is off by delta r, (Q-P).n by theta r, r^2 by
  ///           2 delta + 4 u of itself. A product of kernel and weight then by at most weight / r^2 times
  ///             theta_P c_Q + theta_Q c_P + theta_P theta_Q + c_P c_Q (2 (relative error of r^2) + u (9 +
  ///             additions)),
  ///           c_P, c_Q at least the exact and computed cosines; and what the weights themselves are off by
  ///           times c_P c_Q / r^2
  /// Source    Higham, Accuracy and Stability of Numerical Algorithms, 2002, 3.1; 3 u for a scalar product in
  ///           space; a sum by rows passes each term through 2 order additions
  /// Requires  sums of this rule
  /// Result    one bound a function; infinite where the point is too near for the rounding of the coordinates
  void rounding(const Sums& sums, std::size_t lane, const PointErrors& points, std::span<double> error) const;

private:
  static constexpr std::size_t geometry = 6;

  template <std::size_t Fixed>
  void take_sums_of(const Points& points, Sums& sums) const;

  std::size_t functions_;
  int order_ = 0;
  std::vector<double> data_;  ///< a node: position, unit normal, weighted functions
  std::vector<double> mass_;  ///< sum of the sizes of the last, for each j
  std::vector<double> mass_error_;
  double position_error_ = 0;
  double normal_error_ = 0;
};

}  // namespace radcert
