// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/continuous/elements/panel.h"
#include "radcert/continuous/occlusion/panel_sight.h"
#include "radcert/continuous/upward.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// The triangle between a side of a panel and its centre, with parameters that run along the side and away
/// from it.
/// Maths     P(s,t) = (1-t) ((1-s) a + s b) + t c on [0,1]^2, a and b the ends of the side, c the centre:
///           lines t = const are parallel to the side, lines s = const are straight; the area element is
///           jacobian (1-t) ds dt
/// Result    coordinates from the middle of the box about the surface, each vertex rounded once
struct Sector {
  std::size_t panel = 0;
  Vector<double> a;
  Vector<double> b;
  Vector<double> c;
  double jacobian = 0;

  [[nodiscard]] Vector<double> point(double s, double t) const {
    const double of_a = (1 - t) * (1 - s);
    const double of_b = (1 - t) * s;
    return of_a * a + of_b * b + t * c;
  }
};

/// A dyadic rectangle of a sector's parameters.
/// Maths     [s0,s1] x [t0,t1], bounds in [0,1] that double holds exactly
struct SectorBox {
  double s0 = 0;
  double s1 = 1;
  double t0 = 0;
  double t1 = 1;

  [[nodiscard]] double middle_s() const { return 0.5 * (s0 + s1); }
  [[nodiscard]] double middle_t() const { return 0.5 * (t0 + t1); }
  /// Int (1-t) ds dt
  [[nodiscard]] double weight() const { return (s1 - s0) * (t1 - t0) * (1 - middle_t()); }
  friend bool operator==(const SectorBox& a, const SectorBox& b) = default;
};

/// The halves of a box, cut across its longer sides on a sector; the lower parameters first.
[[nodiscard]] std::array<SectorBox, 2> halves(const Sector& sector, const SectorBox& box);

/// The corners of a part of a sector.
[[nodiscard]] inline std::array<Vector<double>, 4> corners_of(const Sector& sector, const SectorBox& box) {
  return {sector.point(box.s0, box.t0), sector.point(box.s1, box.t0), sector.point(box.s1, box.t1),
          sector.point(box.s0, box.t1)};
}

/// The boundary of a polyhedron, ready for integration.
/// Maths     sectors of a panel follow one another, in the order of its sides; extent bounds the coordinates
/// Requires  panels of a closed surface: in the boundary of a convex body, or as cut_panels gives them, with
///           convex polygons that are all of the surface as blockers; with_edges_matched or not
/// Result    geometry in double; what is decided is decided on the exact panels. parallel(i, j): the side of
///           sector i is parallel to the plane of panel j; touching(i, j): it lies in that plane, which is
///           not its own, and has a part of its length in the panel; before(i, j): a point of panel i has its
///           foot in the plane of j before itself, n_i.n_j < 0; opposite(i): the sector on the other side of
///           the same edge, with the same ends, where each lies before the other's plane, or none
class SectorScene {
public:
  explicit SectorScene(std::vector<Panel> panels, const std::vector<Panel>& blockers = {});

  [[nodiscard]] const std::vector<Panel>& panels() const { return panels_; }
  [[nodiscard]] const std::vector<Sector>& sectors() const { return sectors_; }
  /// Of unit length, each component rounded.
  [[nodiscard]] const Vector<double>& normal(std::size_t panel) const { return normals_[panel]; }
  [[nodiscard]] bool coplanar(std::size_t panel, std::size_t other) const {
    return coplanar_[panel * panels_.size() + other] != 0;
  }
  [[nodiscard]] bool parallel(std::size_t sector, std::size_t panel) const {
    return parallel_[sector * panels_.size() + panel] != 0;
  }
  /// Whether the sides of two sectors are parallel.
  [[nodiscard]] bool aligned(std::size_t sector, std::size_t other) const;
  [[nodiscard]] bool touching(std::size_t sector, std::size_t panel) const {
    return touching_[sector * panels_.size() + panel] != 0;
  }
  [[nodiscard]] bool before(std::size_t panel, std::size_t other) const {
    return before_[panel * panels_.size() + other] != 0;
  }
  [[nodiscard]] std::optional<std::size_t> opposite(std::size_t sector) const { return opposite_[sector]; }
  [[nodiscard]] std::size_t first_sector(std::size_t panel) const { return first_sector_[panel]; }
  /// How far a point is beyond the line of a sector's side, across it in the plane of the panel.
  /// Maths     the ends of the side are off by displacement each, which turns a short one: that is taken away
  /// Result    no more than it is, up to 4 displacement extent
  [[nodiscard]] double beyond_side(std::size_t sector, const Vector<double>& point) const;
  [[nodiscard]] double area(std::size_t panel) const { return areas_[panel]; }
  [[nodiscard]] double area() const { return area_; }
  [[nodiscard]] double extent() const { return extent_; }
  [[nodiscard]] const PanelSight& sight() const { return *sight_; }
  /// What the coordinates here are taken from, rounded.
  [[nodiscard]] Vector<double> origin() const;
  /// A point of the surface, within displacement of the exact one.
  [[nodiscard]] Vector<double> place(const Vector<Rational>& point) const;

private:
  std::vector<Panel> panels_;
  Vector<Rational> origin_;  ///< the middle of the box about all corners
  std::vector<Sector> sectors_;
  std::vector<std::size_t> first_sector_;  ///< of each panel, and the number of all
  std::vector<Vector<double>> normals_;
  std::vector<Vector<double>> outward_;  ///< by sector: across its side, in the plane, of unit length
  std::vector<double> areas_;
  std::vector<char> coplanar_;
  std::vector<char> before_;
  std::vector<char> parallel_;
  std::vector<char> touching_;
  std::vector<std::optional<std::size_t>> opposite_;
  double area_ = 0;
  double extent_ = 0;
  std::optional<PanelSight> sight_;
};

/// The distance of a point from a segment, rounded.
[[nodiscard]] double distance(const Vector<double>& point, const Vector<double>& from,
                              const Vector<double>& to);

/// How far the point that Sector::point computes may be from the exact one, over the extent X.
/// Maths     vertices, weights, products and sums: 7 u X a coordinate; s and t off by 3 u each, sides and
///           radii of at most 2 X a coordinate: 12 u X. sqrt(3) of their sum is less than 33 u X
inline constexpr double displacement = 33 * unit_roundoff<double>();

/// What rounding does to the kernel between two such points at the distance D, at most.
/// Maths     G = [n_P.(Q-P)] [n_Q.(P-a)] / |P-Q|^4, a the vertex of Q's sector: |computed - exact| <=
///           kernel_rounding X / D^3 for D >= 2^10 displacement X. Both points move: the scalar products and
///           D by 66 u X at most, which makes 6 * 66 u X / D^3 and 2% more; products, sums and normals that
///           are off by 6 u a coordinate: 15 u D in the first factor, 15 u |P-a| in the second, 13 u in the
///           quotient; D, |P-a| <= 2 sqrt(3) X. Together less than 560
inline constexpr double kernel_rounding = 1024 * unit_roundoff<double>();
inline constexpr double least_kernel_distance = 1024 * displacement;

}  // namespace radcert
