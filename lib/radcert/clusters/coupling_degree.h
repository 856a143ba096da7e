// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "radcert/clusters/cluster_points.h"
#include "radcert/surface/chart.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// What the clusters of one level are to a look at their couplings.
/// Maths     corners, middles of the sides, centroid and one more point of each cluster, eight in all; a ball
///           about them
/// Requires  charts and clusters outlive it
/// Result    rounded; balls hold the eight points
class ClusterOutlines {
public:
  /// Of all clusters, or of those that are wanted, ascending: only these may be asked for.
  ClusterOutlines(const std::vector<Chart>& charts, const std::vector<ParameterTriangle>& clusters);
  ClusterOutlines(const std::vector<Chart>& charts, const std::vector<ParameterTriangle>& clusters,
                  std::span<const std::uint32_t> wanted);

  static constexpr std::size_t samples = Pack::lanes;
  [[nodiscard]] const ClusterPoints& points() const { return points_; }
  /// The place of a cluster's eight points.
  [[nodiscard]] std::size_t first(std::size_t cluster) const { return place_[cluster] * samples; }
  [[nodiscard]] const Vector<double>& centre(std::size_t cluster) const { return centres_[place_[cluster]]; }
  [[nodiscard]] double radius(std::size_t cluster) const { return radii_[place_[cluster]]; }
  [[nodiscard]] const ParameterTriangle& triangle(std::size_t cluster) const { return clusters_[cluster]; }
  [[nodiscard]] const Chart& chart(std::size_t cluster) const { return charts_[clusters_[cluster].chart]; }

private:
  const std::vector<Chart>& charts_;
  const std::vector<ParameterTriangle>& clusters_;
  std::vector<std::uint32_t> place_;  ///< by cluster: among those that are wanted
  ClusterPoints points_;
  std::vector<Vector<double>> centres_;
  std::vector<double> radii_;
};

/// The degree at which G between two clusters is interpolated, and what that leaves out.
/// Maths     error_a is meant for the largest, over the points P of a, of Int_b |G - I_p G| |f| dS / pi for
///           densities f of the size that the demand states; error_b the same with a and b exchanged
/// Result    estimated: made for sums over all couplings of a row. A single one may be exceeded, at most by a
///           factor of 4 where that was looked at
struct CouplingDegree {
  int degree = 0;
  double error_a = 0;
  double error_b = 0;
};

/// How large the modes are where the values of a coupling are wanted.
/// Maths     of_mode[n] = max |D_n|,  of_degree[m] = max of the root of the sum of D_n^2 over the modes of
///           degree m, both over points of the triangle
/// Result    rounded; without points over the whole triangle: max |D_n| as a lattice of 40 intervals a side
///           shows it, and (m+1)^(3/2), which is reached at the vertices
struct ModeSizes {
  explicit ModeSizes(std::span<const Barycentric<double>> points = {});
  std::vector<double> of_mode;
  std::vector<double> of_degree;
};

/// What is demanded of a coupling.
struct CouplingDemand {
  double share;           ///< the largest error_a and error_b
  double functions_size;  ///< the root of the mean of (sum_j |l_j|)^2
  int largest_degree;     ///< at most largest_mode_degree - 2
  /// The nodes of an element, in its coordinates: only there values are wanted. Empty: everywhere.
  std::vector<Barycentric<double>> nodes = {};
};

/// Decides whether two clusters of one level couple by polynomials, and of which degree.
/// Maths     first from their distance: seen from every point P of b, the triangle a with the centre c and
///           the radius r has x = (|c - c_b| - r_b)/r, and the modes of degree m of G fall as rho^-m, rho =
///           x + sqrt(x^2 - 1): L(Q - c) <= g r on the complex neighbourhood with sum |lambda_i| <= g < x,
///           where L is the Lie norm, and |(P-Q).(P-Q)| >= (|P-c| - g r)^2. The least p with
///           8 rho^-p/(rho - 1) max|G| area/pi <= share; clusters are too near where it exceeds one and a
///           half times the largest degree. Then from G itself: its modes in a, seen from eight points of b,
///           and in b, seen from a, up to two degrees beyond p or more: the least degree at which the modes
///           left out, and those not looked at as a geometric series, stay within the share. Over the source
///           the root of the sum of their squares counts, the largest of the eight points; for P, as the
///           mean over the eight points of the source, degree by degree, the sum of |mode| max|D_n| or
///           the largest root of sum D_n^2 times the root of the sum of their squares, the least; see
///           ModeSizes. Three times that, for interpolation in both clusters instead of projection
/// Source    Lie norm: L(u+iv)^2 = |u|^2 + |v|^2 + 2 sqrt(|u|^2 |v|^2 - (u.v)^2), under which every zero of
///           (D-w).(D-w), D real, has L(w) >= |D|; Wang, Xiang (2012) for the rate. On curved charts the rate
///           is a guess that the look at the modes replaces
/// Requires  0 < share; outlines, demand and sizes outlive this
/// Result    estimated; nothing where the degree would exceed the largest, or the clusters are too near
/// Limits    for one thread: holds scratch
class CouplingLook {
public:
  CouplingLook(const ClusterOutlines& outlines, const CouplingDemand& demand, const ModeSizes& sizes)
      : outlines_(outlines), demand_(demand), sizes_(sizes) {}

  std::optional<CouplingDegree> operator()(std::size_t a, std::size_t b);

private:
  /// What the modes of one degree contribute.
  struct Contribution {
    double as_target = 0;
    double as_source = 0;
  };
  /// A cluster seen from eight points of another: G at its nodes, and from that its modes, as far as they
  /// are asked for.
  struct View {
    ClusterPoints nodes;
    std::vector<Pack> kernel;
    std::vector<Pack> weighted;  ///< G times the weights of the nodes
    Pack weight{0.0};
    int degree = 0;
    std::vector<std::optional<Contribution>> by_degree;
  };
  /// The rate rho at which G falls in cluster a seen from b; 1 where there is none.
  [[nodiscard]] double rate(std::size_t a, std::size_t b) const;
  /// The degree that the rate asks for.
  [[nodiscard]] std::optional<int> degree_by_distance(std::size_t a, std::size_t b) const;
  void look(std::size_t a, std::size_t b, int degree, View& view) const;
  const Contribution& contribution(View& view, std::size_t degree) const;
  /// What lies beyond the degrees that are looked at.
  Contribution beyond(View& view, double expected_ratio) const;

  const ClusterOutlines& outlines_;
  const CouplingDemand& demand_;
  const ModeSizes& sizes_;
  View in_a_;
  View in_b_;
};

}  // namespace radcert
