// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/core/outcome.h"

namespace radcert {

/// A vector and a bound of its distance from the solution, entry by entry.
struct VerifiedSolution {
  std::vector<double> values;
  std::vector<double> radius;  ///< >= |u_i - values_i|, proved
};

/// The systems whose matrix is known within radii, all of them proved regular, ready for right-hand sides.
/// Maths     A = I - K, |K - k| <= radius entry by entry. With an approximate inverse R let H >= |I - R A|
///           for all of them and H w <= theta w, w > 0, theta < 1: then R and every A are regular. For the
///           distance d = u - x of a solution, A u = e, from any x: |d| <= z + H |d| with z >= |R (e - A x)|,
///           so |d| <= w ||z||_w / (1 - theta), and then |d| <= z + H (that bound)
/// Source    Krawczyk (1969); Rump: Verification methods, Acta Numerica 19 (2010), section 10. w is found by
///           the power method from |R| (|A| 1), which makes theta independent of the scaling of columns
/// Requires  made by verified_system
/// Result    all bounds hold for the numbers as stored: the roundings of R A and of the residual, taken as if
///           in twice the working precision, are counted, underflow included. The same bits for any number of
///           threads
/// Limits    dense: four matrices, five with radii
class VerifiedSystem {
public:
  std::size_t size() const { return k_.rows(); }
  /// The theta of the proof.
  double theta() const { return theta_; }
  /// The weights w, the largest about 1.
  std::span<const double> weights() const { return weights_; }

  /// The solutions of all systems within the radii.
  /// Maths     all u with (I - K) u = e', |e' - e| <= e_radius entry by entry
  /// Source    x: iterative refinement with R. The steps d <- min(d, z + H d) tend to (I - H)^-1 z
  /// Requires  finite e; e_radius >= 0 and finite, or empty: e is exact; both of the system's size, else
  ///           ContractViolation
  /// Result    every such u is enclosed. Where the data are exact and theta << 1, the radius is about the
  ///           rounding of the values to double. Refused where numbers run over the largest
  /// Limits    matrix and right-hand side vary independently. The radius of wide data exceeds that of the
  ///           smallest box by terms of second order in the radii
  Outcome<VerifiedSolution> solve(std::span<const double> e, std::span<const double> e_radius = {}) const;

private:
  friend Outcome<VerifiedSystem> verified_system(Matrix<double> k, Matrix<double> k_radius);
  VerifiedSystem() = default;

  void invert();
  void bound_defect();
  void find_weights();
  std::vector<double> defect_times(std::span<const double> w) const;
  std::vector<double> data_radius(std::span<const double> x, std::span<const double> e_radius) const;
  std::vector<double> corrections(std::span<const double> x, std::span<const double> e,
                                  std::span<double> residual) const;

  Matrix<double> k_;
  Matrix<double> k_radius_;
  Matrix<double> inverse_;
  Matrix<double> defect_;
  std::vector<double> weights_;
  double theta_ = 0;
};

/// Proves that all systems within the radii are regular.
/// Maths     see VerifiedSystem: an approximate inverse by Gaussian elimination, then theta
/// Source    as VerifiedSystem
/// Requires  k square, not empty, at most 2^26 rows; k_radius of its shape and >= 0, or empty: k is exact;
///           else ContractViolation
/// Result    the systems, or why not: singular to working precision, or theta not below 1, as for every
///           family that contains a singular matrix. The same bits for any number of threads; Interrupted
///           when asked to stop
/// Limits    about 14/3 n^3 operations. Refuses where the condition number exceeds about 1/(n u), or the
///           radii a part of 1/|| |R| ||, though all matrices may be regular
Outcome<VerifiedSystem> verified_system(Matrix<double> k, Matrix<double> k_radius = {});

}  // namespace radcert
