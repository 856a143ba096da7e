// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/scalar/approximation.h"

namespace radcert::verification {

/// Errors of one method, level by level.
struct LevelErrors {
  std::vector<double> mesh_sizes;  ///< each less than the one before
  std::vector<Approximation> errors;
};

/// What an error is taken to be.
/// Maths     e = C h^p (1 + O(h^next)), or C h^p |log h| (1 + O(h^next))
/// Limits    beside |log h| a constant times h^p is not of this form; what it moves the exponents by shows in
///           their differences, and so in the interval
struct OrderModel {
  bool logarithm = false;
  double next = 1;
};

/// The exponent p of a model, as an interval.
struct ObservedOrder {
  Approximation exponent;
  /// The part of an order that |log h| costs between the last two levels; 0 in a model without it.
  double logarithm = 0;
};

/// The exponent that errors tell.
/// Maths     p_k = log(e_(k-1)/e_k)/log(h_(k-1)/h_k) + lambda_k, with its radius r_k from those of both
///           errors; lambda_k = log(|log h_k|/|log h_(k-1)|)/log(h_(k-1)/h_k) in a model with |log h|, else
///           0. By the model p_k - p = O(h_k^next), so that from some level on |p_k - p| <= |p_(k-1) -
///           p|/f_k, f_k = (h_(k-1)/h_k)^next, hence |p_k - p| <= |p_k - p_(k-1)|/(f_k - 1), and at the last
///           level |p_m - p| <= s_k = |p_k - p_(k-1)|/((f_k - 1) f_(k+1) ... f_m) for each k. The exponent is
///           p_m with the radius r_m + max_k s_k, radii r_k and r_(k-1) added to the difference: the largest
///           of bounds, each of which would do, for two orders may be near each other by chance
/// Source    ours
/// Requires  as many errors as mesh sizes, three at least; in a model with |log h| three with h < 1, and
///           those with h >= 1 are left out; next > 0; else ContractViolation
/// Result    never guaranteed: that the levels given are fine enough for the model is not proved. A radius
///           that is not finite where an error is not above its own
/// Limits    an error that is the largest of several oscillates as the largest changes: then the interval is
///           wide, but no number of levels makes it a proof
[[nodiscard]] ObservedOrder observed_order(const LevelErrors& errors, const OrderModel& model = {});

/// The exponent between two errors, without a model.
/// Maths     log(coarse/fine)/log(ratio)
/// Requires  ratio > 1
/// Result    the radius covers those of both errors; value 0 with an infinite radius where one of them may be
///           0; guaranteed if both errors are
[[nodiscard]] Approximation exponent_between(const Approximation& coarse, const Approximation& fine,
                                             double ratio = 2);

}  // namespace radcert::verification
