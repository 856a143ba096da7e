// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "radcert/certificate/ball_transport.h"
#include "radcert/certificate/densities.h"
#include "radcert/certificate/line_bounds.h"
#include "radcert/certificate/occlusion/shade.h"
#include "radcert/certificate/occlusion/sight.h"
#include "radcert/certificate/point_kernels.h"
#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/certificate/scene.h"
#include "radcert/core/work_limit.h"

namespace radcert::certificate {

extern const WorkLimit most_checked_cells;

/// What is proved of the residuals on one element, in the scaled units of Scene and Densities.
/// Maths     (Int_X rho t_k^2)^(1/2) <= norms[k];  |products[k] - Int_X w_(1+k) t_0| <= radii[k];
///           sup_X rho |t_0| <= largest
struct ResidualBounds {
  std::vector<double> norms;
  std::vector<double> products;
  std::vector<double> radii;
  std::vector<double> doubts;  ///< about how much norms may be too large
  double largest = 0;          ///< of a function alone
};

/// What is wanted of them: what rules leave may be about this much, of a norm, a product, a largest value.
struct Allowance {
  double norm = std::numeric_limits<double>::infinity();
  double product = std::numeric_limits<double>::infinity();
  double largest = std::numeric_limits<double>::infinity();
  double claim =
      std::numeric_limits<double>::infinity();  ///< of a largest value: where less is sure, is no work
  /// How many times that shade may leave, by function and by product; 1 where there are none.
  std::vector<double> norm_room = {};
  std::vector<double> product_room = {};
};

/// Proves claims about the residuals on elements.
/// Maths     an element is cut into cells, each with tensor Gauss nodes, n_s x n_t, more than the degree p of
///           the functions. f = T w, or F of EdgeClosing, is within e_s and e_t of polynomials of degree n_s
///           - 1 and n_t - 1 in its parameters (LineBounds), If interpolates it at the nodes:
///             ||If||^2 is the Gauss sum, of degree 2 n - 1 in either parameter with 1 - t; f - If = (f - I_s
///             f) + I_s (f - I_t f), and I_s f - f = I_s (f - p) - (f - p): ||f - If|| <= 2 |X|^(1/2) (e_s +
///             e_t). So with f - q, since q = Iq: ||f - q|| <= (sum)^(1/2) + 2 |X|^(1/2) (e_s + e_t) |Int w f
///             - Gauss| <= 2 |X| sup|w| (e_s + e_t) with e_s of degree 2 n_s - 1 - p, e_t of degree 2 n_t - 2
///             - p, since Gauss' rule is exact for the product with such polynomials; w q exactly
///           Next to an edge |T w - F| <= b adds |X|^(1/2) b and |X| sup|w| b. What is so small that it is
///           not looked into adds |X|^(1/2) sup|t| and |X| sup|w| sup|t|, |t| <= sup|w| + sup|q| by T 1 = 1.
///           Norms of cells are joined by Minkowski's inequality. Of values f = T w_k + j_k, with what
///           polynomials leave of j_k (PointKernels) in e_s and e_t, its values at nodes and sup|j_k|.
///           Largest values: |If - q| by cell_supremum, and with L_n = interpolation_norm(n) |f - If| <= |f -
///           I_s f| + |I_s (f - I_t f)| <= (1 + L_s) e_s + L_s (1 + L_t) e_t
///           Where parts hide each other f is the F of Shade, of what all of the cell sees (Sight); |T w_k -
///           f| <= d_k adds |X|^(1/2) d_k and |X| sup|w_k| d_0, to largest values d_0. Half of G/pi stands
///           for j_k where P_k sees a part of the cell, and half of sup G/pi is added to d_k alone
/// Source    ours; theorem I of the layer continuous says the same, of which no line is used here
class ElementCheck {
public:
  ElementCheck(const PolyhedronCertificate& certificate, const Scene& scene, const Densities& densities,
               const LineBounds& lines, const BallTransport& transport, const PointKernels& kernels,
               const Sight& sight, const Shades& shades);

  /// Requires  a face that reflects
  /// Result    proved, whatever the allowance; better where that is less
  [[nodiscard]] ResidualBounds bounds(std::size_t element, const Allowance& allowance) const;
  /// What `largest` of them cannot be less than: sup rho times |t_0| at some points inside.
  /// Requires  as bounds
  [[nodiscard]] double residual_inside(std::size_t element, double tolerance) const;

private:
  struct Cell;
  struct Plan;
  class Cutter;
  [[nodiscard]] Plan plan(std::size_t element, const Allowance& allowance) const;
  void add_cell(std::size_t element, const Cell& cell, const Allowance& allowance, std::size_t cells,
                ResidualBounds& sums, std::vector<double>& squares) const;

  const PolyhedronCertificate& certificate_;
  const Scene& scene_;
  const Densities& densities_;
  const LineBounds& lines_;
  const BallTransport& transport_;
  const PointKernels& kernels_;
  const Sight& sight_;
  const Shades& shades_;
};

}  // namespace radcert::certificate
