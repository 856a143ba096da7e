// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "radcert/clusters/certified/cluster_region.h"
#include "radcert/clusters/coupling_degree.h"
#include "radcert/surface/chart.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// The clusters of one level as proofs see them: their regions, and their interpolation nodes.
/// Requires  as ClusterRegion; charts and clusters outlive it
/// Result    safe to ask from several threads at once: nodes are found when they are first asked for
class CertifiedOutlines {
public:
  /// The exact interpolation nodes of a degree in a cluster, their unit normals, and their weights: area
  /// elements times the cluster's area in the parameter plane.
  struct Nodes {
    std::vector<std::array<long double, 3>> at;
    std::vector<std::array<long double, 3>> normal;
    std::vector<long double> weight;
    double size = 0;   ///< of the coordinates
    double error = 0;  ///< of coordinates and normals, beside their rounding to long double
    double largest_weight = 0;
    double weight_error = 0;  ///< beside their rounding
  };

  CertifiedOutlines(const std::vector<Chart>& charts, const std::vector<ParameterTriangle>& clusters);
  CertifiedOutlines(const CertifiedOutlines&) = delete;
  CertifiedOutlines& operator=(const CertifiedOutlines&) = delete;
  ~CertifiedOutlines();

  [[nodiscard]] const ClusterRegion& region(std::size_t cluster) const;
  [[nodiscard]] const Nodes& nodes(std::size_t cluster, int degree) const;

private:
  struct Cluster;
  const std::vector<Chart>& charts_;
  const std::vector<ParameterTriangle>& triangles_;
  std::vector<std::unique_ptr<Cluster>> clusters_;
};

/// Decides at which degree two clusters of one level couple, with a proof of what that leaves out.
/// Maths     h(x, y) = G(P, Q) J(y), P in a and Q in b by barycentric coordinates, J the area element times
///           the area of b in the parameter plane; c(x, y) = sum_ab (W^T D)_a(x) h(x_a, y_b) (W^T D)_b(y) the
///           coupling of degree p with the stored W of ModeInterpolation. error_a >= the largest over x of
///           mean over y of |h - c| sum_j q_j / pi, where the root of the mean of (sum_j q_j)^2 is at most
///           demand.functions_size; error_b the same with a and b exchanged
/// Source    Theorem. With I the interpolation of degree p' >= p, exact and so without effect on c, in both
///           variables, |h - c| <= |h - I_x I_y h| + |I_x I_y (h - c)|. The first is at most (1 + L) E_x + L
///           (1 + L) E_y, L the Lebesgue constant, E_x and E_y the distances of h in x and in y from
///           polynomials of degree p': approximation_bound of kernel_bound, for E_x times the largest J, for
///           E_y times that of J on the same complex neighbourhood. The second is the polynomial of
///           the values e_ab of h - c at the nodes of degree p', which are computed: over y the mean of its
///           size is at most the root of the mean of its square, by Parseval that of the sum of squares of
///           its modes; as a function of x that norm is at most L times its largest value at a node, and at
///           most sum_m (m + 1)^(3/2) ||modes of degree m||, since the sum of D_n(x)^2 over the degree m is
///           at most (m + 1)^3: with x_i = |z_i|^2, z uniform on the unit sphere of C^3, these D_n are
///           orthonormal functions in the harmonics of bidegree (m, m), whose dimension that is. Values e_ab
///           that are off by d change the mean by at most d L sum_b ||l_b||
/// Requires  0 < share; what is passed outlives this
/// Result    proved, rounded up, with errors of at most the share: nodes and frames in balls, G in long
///           double, sums as if in twice the precision, with all roundings counted. Nothing where that was
///           not found: clusters too near
/// Limits    tries the degree of CouplingLook and at most three more. Octants of ellipsoids larger than about
///           1/64 of the octant, and clusters larger than about 1/128 of other curved charts, have
///           neighbourhoods too small for couplings. For one thread
class CertifiedLook {
public:
  CertifiedLook(const CertifiedOutlines& outlines, const ClusterOutlines& estimated,
                const CouplingDemand& demand, const ModeSizes& sizes)
      : outlines_(outlines), demand_(demand), estimate_(estimated, demand, sizes) {}

  std::optional<CouplingDegree> operator()(std::size_t a, std::size_t b);

private:
  /// What interpolation of a degree leaves out of h, rows in a and rows in b.
  struct Rest {
    int degree = 0;
    double a = 0;
    double b = 0;
  };
  [[nodiscard]] std::optional<Rest> rest(std::size_t a, std::size_t b, int least) const;

  const CertifiedOutlines& outlines_;
  const CouplingDemand& demand_;
  CouplingLook estimate_;
};

}  // namespace radcert
