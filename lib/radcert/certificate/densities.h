// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/certificate/scene.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/bounded_double.h"

namespace radcert::certificate {

/// Values of P_0, ..., P_degree at several places, with a bound of their errors.
struct LegendreTable {
  LegendreTable(int degree, std::span<const BoundedDouble> places);
  std::size_t powers;
  std::vector<double> values;  ///< by place, power
  double error = 0;
};

/// The functions of a certificate on its elements, and the constant 1 after them.
/// Maths     function k is 2^-exponent(k) times that of the certificate, so that none is much larger than 1.
///           E, and products with rho where it is a polynomial, are brought into Legendre polynomials by a
///           Gauss rule that is exact for them. |f| <= sum |c_ij| a^i b^j where |P_i(x)| <= a^i, |P_j(y)| <=
///           b^j; |P_i(z)| <= R^i in the ellipse with the foci -1, 1 and half axes summing to R (Laplace's
///           integral)
/// Requires  surface_fault, tiling_fault found nothing
class Densities {
public:
  explicit Densities(const PolyhedronCertificate& certificate);

  [[nodiscard]] int exponent(std::size_t k = 0) const { return exponents_[k]; }
  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] std::size_t powers() const { return static_cast<std::size_t>(degree_) + 1; }
  [[nodiscard]] std::size_t count() const { return count_; }  ///< without the constant
  [[nodiscard]] std::size_t constant() const { return count_; }
  /// w_k or q_k on an element, by i, j, functions side by side and filled up to `stride` with 0.
  [[nodiscard]] std::span<const double> w(std::size_t element) const { return of(w_, element); }
  [[nodiscard]] std::span<const double> q(std::size_t element) const { return of(q_, element); }
  [[nodiscard]] std::size_t stride() const { return stride_; }
  /// What values by `values` may be off, for all functions.
  [[nodiscard]] double error(std::size_t element, const LegendreTable& s, const LegendreTable& t) const;
  /// What the sum of the coefficients' sizes of any w_k on an element may be off.
  [[nodiscard]] double coefficient_error(std::size_t element) const { return error_[element]; }
  /// f_k at the place of both tables: out[k], k = 0, ..., stride - 1.
  static void values(std::span<const double> f, std::size_t stride, const double* s, const double* t,
                     std::size_t powers, std::span<double> out);

  /// sup |w_k| on an element over all k with the constant, where |P_i| <= along^i, |P_j| <= across^j.
  [[nodiscard]] double size(std::size_t element, double along = 1, double across = 1) const;
  /// sup |w_k| on an element over all k without the constant.
  [[nodiscard]] double size_of_w(std::size_t element) const;
  /// sup |w_k| and |q_k| on an element.
  [[nodiscard]] double size_of(std::size_t element, std::size_t k) const {
    return w_size_[element * count_ + k];
  }
  [[nodiscard]] double q_size_of(std::size_t element, std::size_t k) const {
    return q_size_[element * count_ + k];
  }
  /// sup |w_k| everywhere, and of all k with the constant.
  [[nodiscard]] double largest_of(std::size_t k) const { return largest_[k]; }
  [[nodiscard]] double largest() const { return all_; }
  /// Whether w_k, q_k and, of values, j_k are 0.
  [[nodiscard]] bool vanishes(std::size_t k) const { return vanishes_[k] != 0; }
  /// At least sup rho on an element.
  [[nodiscard]] double reflectivity(std::size_t element) const { return rho_[element]; }
  /// A Lipschitz constant of all w_k in x, and in y.
  struct Slopes {
    double in_x = 0;
    double in_y = 0;
  };
  [[nodiscard]] Slopes slopes(std::size_t element) const;
  /// Bounds of the coefficients of w(., -1) on the edge, by i, over all k.
  [[nodiscard]] std::vector<double> edge_sizes(std::size_t element) const;
  /// Int w_0 over each piece, of the certificate's functions and lengths.
  [[nodiscard]] static std::vector<Ball> integrals(const PolyhedronCertificate& certificate);

private:
  [[nodiscard]] std::span<const double> of(const std::vector<double>& all, std::size_t element) const {
    const std::size_t size = powers() * powers() * stride_;
    return {all.data() + element * size, size};
  }
  std::vector<int> exponents_;
  int degree_ = 0;
  std::size_t count_ = 0;
  std::size_t stride_ = 0;
  std::vector<double> w_, q_;
  std::vector<double> error_;      ///< of the coefficients of an element, summed, the largest over k
  std::vector<double> sum_sizes_;  ///< sum |c_ij|, the largest over k of w and q
  std::vector<double> largest_coefficients_;  ///< by element, i, j: over all k of w with the constant
  std::vector<double> w_size_, q_size_;
  std::vector<double> largest_;
  std::vector<char> vanishes_;
  std::vector<double> rho_;
  double all_ = 1;
};

/// The area of a face, and of a piece, of the certificate.
[[nodiscard]] Ball area_of(const Face& face);
[[nodiscard]] std::vector<Ball> piece_areas(const PolyhedronCertificate& certificate);

}  // namespace radcert::certificate
