// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "radcert/continuous/elements/panel.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// How much points of one convex set see of those of another: V = 0 almost everywhere, unknown, V = 1 almost
/// everywhere.
enum class PanelView { none, partly, whole };

/// What panels of a polyhedron see of each other.
/// Maths     a blocker B is a convex polygon with the normal n at a, and d(p) = n.(p-a); g_e(p) <= 0 on the
///           inner side of its side e, in its plane. Convex sets X and Y of points, d >= 0 on X, d <= 0 on Y:
///             B hides nothing   where the plane d alpha + g_e = 0 has both in front of it for some alpha and
///                               e: B lies behind it. That is alpha >= -g_e/d at the corners of X, and alpha
///                               <= g_e/|d| at those of Y
///             B hides all       where |d(q)| g_e(p) + d(p) g_e(q) <= 0 for all e and all corners p of X, q
///                               of Y: the form is linear in p and in q, so that it holds for all points; the
///                               line from p to q meets the plane of B where g_e is that over d(p) + |d(q)|
///           Borders are null sets
/// Requires  panels of which each is on one side of the plane of every blocker and every panel, or in it
/// Result    decided in double with bounds for rounding; on which side of which plane a panel lies is exact.
///           `partly` where nothing is decided
class PanelSight {
public:
  /// Coordinates of points are those less the origin, none larger than extent.
  PanelSight(const std::vector<Panel>& panels, const std::vector<Panel>& blockers,
             const Vector<Rational>& origin, double extent);

  /// Whether every panel sees all others that are not in its plane.
  [[nodiscard]] bool is_open() const { return blockers_.empty(); }
  /// Of a whole panel.
  [[nodiscard]] PanelView view(std::size_t panel, std::size_t other) const {
    return is_open() ? PanelView::whole : pairs_[panel * panels_ + other].view;
  }
  /// From the convex hull of points of a panel to those of another, all within rounding (displacement).
  class Lookout;

private:
  struct Blocker {
    Vector<double> at;
    Vector<double> normal;  ///< of unit length
    struct Side {
      Vector<double> at;
      Vector<double> outward;  ///< of unit length, in the plane
    };
    std::vector<Side> sides;
  };
  /// On which side of planes a panel lies: the least and the largest sign at its corners.
  struct Signs {
    signed char least = 0;
    signed char largest = 0;
  };
  struct Pair {
    PanelView view = PanelView::whole;
    std::vector<std::size_t> blockers;  ///< that may hide something
  };
  [[nodiscard]] Signs of_plane(std::size_t panel, std::size_t blocker) const {
    return planes_[panel * blockers_.size() + blocker];
  }

  std::size_t panels_;
  double slack_ = 0;
  std::vector<Blocker> blockers_;
  std::vector<Signs> planes_;                 ///< by panel, blocker
  std::vector<std::vector<Signs>> of_sides_;  ///< the same, by side
  std::vector<Pair> pairs_;                   ///< by panel, panel
};

/// What points of a panel see of points of another, asked for many times from the same points.
/// Requires  the sight outlives it
class PanelSight::Lookout {
public:
  Lookout(const PanelSight& sight, std::size_t panel, std::span<const Vector<double>> hull,
          std::size_t other);

  /// The blockers that may hide something of a set, a bit each; those beyond 64 always may.
  using MayHide = std::uint64_t;
  static constexpr MayHide all = ~MayHide{0};

  /// The convex hull of points of the other panel. Blockers that hide nothing of it are taken out of
  /// `may_hide`, so that they need not be asked about parts of it.
  [[nodiscard]] PanelView view(std::span<const Vector<double>> points, MayHide& may_hide);
  [[nodiscard]] PanelView view(std::span<const Vector<double>> points) {
    MayHide may_hide = all;
    return view(points, may_hide);
  }

private:
  struct Between {
    double least = 0;
    double largest = 0;
  };
  /// |d| and g_e at points of a panel.
  struct Distances {
    std::vector<Between> from_plane;
    std::vector<Between> beyond;  ///< by point, side
    void put(const PanelSight& sight, std::size_t panel, std::size_t blocker,
             std::span<const Vector<double>> points);
    [[nodiscard]] double largest_alpha(std::size_t side) const;
    [[nodiscard]] bool are_in_front(std::size_t side, double alpha) const;
  };
  struct Past {
    std::size_t blocker = 0;
    Distances hull;
    std::vector<double> alphas;  ///< by side: the plane d alpha + g_e = 0 has the hull in front of it
  };
  [[nodiscard]] PanelView view(const Past& past) const;

  const PanelSight& sight_;
  std::size_t other_;
  PanelView without_blockers_;
  std::vector<Past> past_;
  Distances points_;  ///< of the last view
};

}  // namespace radcert
